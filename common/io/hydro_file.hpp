// Reads the hydrodynamic coefficients of one hull from WAMIT numeric files (.1 .3 .hst and drift
// .8, .9 or .7) into SI about the platform's reference point. One body; period in the first column.
#pragma once

#include <vector>

#include "case/environment.hpp"
#include "case/platform.hpp"
#include "hydro_data.hpp"
#include "io/wamit_records.hpp"
#include "status.hpp"

namespace hawser::io {

/// All that is wrong with a set of files. what() holds one line per problem, `file:line: error:
/// ...`.
class HydroFileError : public RunError {
 public:
    explicit HydroFileError(const FileProblems& problems)
        : RunError(ExitCode::input, problems.text()), problems_(problems.list()) {}
    [[nodiscard]] const std::vector<FileProblem>& problems() const { return problems_; }

 private:
    std::vector<FileProblem> problems_;
};

/// Reads `path`.1 and so on. With rho, L = ulen and g the numbers become dimensional,
///
///     A: rho L^k, B: rho w L^k   k = 3 + (i rotation) + (j rotation)
///     X: rho g L^(2 + (i rotation))      D: rho g L^(1 + (i rotation))
///     C: rho g L^(2 + (i rotation) + (j rotation))
///
/// Missing terms are zero, an upper triangle is filled, headings are reduced to one turn, mirrored
/// in the stated planes of symmetry, and never extrapolated. A set of 0 to 180 deg whose
/// coefficients show symmetry about xz is mirrored without being told, with a note. Throws
/// HydroFileError.
HydroData read_hydro(const HydroDatabase& database, const Water& water);

}  // namespace hawser::io
