// A run without physics: harmonic motions and plausible line shapes, recorded through the project's
// own writer, for tests of everything that comes after a simulation.
#pragma once

#include <filesystem>
#include <functional>

#include "case/case.hpp"
#include "io/link.hpp"
#include "io/result_file.hpp"

namespace hawser::test {

/// A spar with twelve mooring lines and four risers in irregular waves, wind and current.
Case synthetic_spar(double duration);
/// The same with a second platform beside it, "tender", designed to be at x 120 m, y 60 m.
Case synthetic_pair(double duration);
/// The same hull without lines in still water, let go 5 m above its rest.
Case synthetic_decay(double duration);
/// One line with a moved end and no platform.
Case synthetic_chain(double duration);

/// Records the case from t = 0 to its duration in segments of `samples_per_segment`; lines belong
/// to ranks as cards are dealt. Collective. `after_segment(n)`, if given, is called after segment
/// n.
void record_synthetic(const std::filesystem::path& folder, const Case& input, io::Link& link,
                      int samples_per_segment,
                      const std::function<void(int)>& after_segment = nullptr);

/// What rank 0 would know about such a run.
io::RunRecord synthetic_record(const Case& input, int ranks);

}  // namespace hawser::test
