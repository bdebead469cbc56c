// Reads the hydrodynamic coefficients of one hull, whatever program made them, into SI about the
// platform's reference point: WAMIT and HAMS numeric files, Capytaine NetCDF-4, BEMIO .h5, NEMOH.
#pragma once

#include <vector>

#include "case/environment.hpp"
#include "case/platform.hpp"
#include "hydro_checks.hpp"
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

/// A check with the file that it is about, and the line, if one tells more than others.
struct PlacedCheck {
    HydroCheck check;
    std::string file;
    int line = 0;
};

/// A set that could be read, whatever its checks say.
struct CheckedHydro {
    HydroData data;
    std::vector<PlacedCheck> checks;
    std::vector<std::string> files;  ///< that were read, as far as they are apart
};

/// Reads the set that `database` names. WAMIT's numbers become dimensional with rho, L = ulen and
/// g,
///
///     A: rho L^k, B: rho w L^k   k = 3 + (i rotation) + (j rotation)
///     X: rho g L^(2 + (i rotation))      D, QTF: rho g L^(1 + (i rotation))
///     C: rho g L^(2 + (i rotation) + (j rotation))      motion: L^-(i rotation)
///
/// Missing terms are zero, an upper triangle is filled, headings are reduced to one turn, mirrored
/// in the stated planes of symmetry, and never extrapolated. A set of 0 to 180 deg whose
/// coefficients show symmetry about xz is mirrored without being told, with a note. What is wrong
/// by hydro_checks.hpp is thrown, what is doubtful kept beside the data.
///
/// @param depth  of the water [m]; 0: not known, unless the files tell it; infinity: deep
/// Throws HydroFileError.
HydroData read_hydro(const HydroDatabase& database, const Water& water, double depth = 0.0);
/// The same, with all checks instead of a throw where one says wrong.
CheckedHydro read_checked_hydro(const HydroDatabase& database, const Water& water,
                                double depth = 0.0);
/// With the water and depth of a case.
HydroData read_hydro(const HydroDatabase& database, const Environment& environment);

}  // namespace hawser::io
