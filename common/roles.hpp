// Who does what in a run, as the program's start sees it: rank 0 is the master (platform), the
// others are workers (lines); alone, one process is both. master/ and worker/ define these.
#pragma once

#include <memory>
#include <vector>

#include "case/case.hpp"
#include "lines.hpp"

namespace hawser {

namespace io {
class Link;
class SeriesWriter;
}  // namespace io

/// The lines of these packs (indices into packs_of(input)), computed in this process. Replies carry
/// this process's lines only, in ascending line order; of several failing lines the first in line
/// order is the one reported. Flags of an order are carried out in send(). On `sample` and
/// `snapshot` the lines put() their columns for the time that the caller has added; add_time() and
/// write_segment() are the caller's, because the platform records into the same file.
/// @param results null: nothing is recorded
std::unique_ptr<Lines> make_local_lines(const Case& input, std::vector<int> packs,
                                        io::SeriesWriter* results);

}  // namespace hawser
