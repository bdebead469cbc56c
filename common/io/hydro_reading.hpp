// What the readers of hydrodynamic layouts share: one reading with its problems, what a layout
// hands over, and the 6x6 matrices and mode numbers of all of them. Private to hydro_*.cpp and
// *_set.cpp.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "case/platform.hpp"
#include "hydro_data.hpp"
#include "io/wamit_inputs.hpp"
#include "io/wamit_records.hpp"
#include "io/wave_rows.hpp"

namespace hawser::io {

using Path = std::filesystem::path;

/// What one reading shares: where the files are, what makes them dimensional, what went wrong.
struct Reading {
    const HydroDatabase& database;
    double gravity;
    double depth;  ///< of the case [m]; 0: not known
    FileProblems problems;
    std::vector<std::string> notes;

    [[nodiscard]] Path file(const std::string& extension) const {
        return database.path + extension;
    }
    [[nodiscard]] double power_of_length(int n) const { return std::pow(database.ulen, n); }
};

/// Which line of a file tells of a frequency and a mode.
struct RowPlace {
    double frequency = 0.0;
    int mode = 0, line = 0;
};

/// A set as its files tell it: dimensional, e^{+i w t}, moments about the files' own origin,
/// headings as listed.
struct HydroSet {
    HydroData data;
    std::optional<Mat6> stiffness;  ///< C with whatever weight it holds
    Path radiation_file, excitation_file, stiffness_file;
    Path drift_file, second_order_file;                     ///< empty: the file of the excitation
    std::vector<RowPlace> radiation_rows, excitation_rows;  ///< of files of text
    std::vector<std::string> files;                         ///< that were read
    std::optional<WamitGeometry> geometry;                  ///< what went into a run of WAMIT
    std::optional<WamitControl> control;
};

/// 1 for roll, pitch and yaw, 0 for the translations.
inline int rotation_of(int mode) { return mode >= 3 ? 1 : 0; }

/// A 6x6 matrix whose terms come one by one. Terms without a row are zero; where only one of (i, j)
/// and (j, i) has a row, it stands for both.
struct GatheredMatrix {
    Mat6 value = Mat6::Zero();
    Eigen::Matrix<bool, 6, 6> given = Eigen::Matrix<bool, 6, 6>::Constant(false);

    void set(int i, int j, double x) {
        value(i, j) = x;
        given(i, j) = true;
    }
    [[nodiscard]] Mat6 filled() const {
        Mat6 m = value;
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j)
                if (!given(i, j) && given(j, i)) m(i, j) = value(j, i);
        return m;
    }
};

// The layouts. Each adds to `problems` what it cannot read and returns what it could.

/// WAMIT numeric files, and HAMS's, which have their layout with e^{-i w t} and reversed limits.
HydroSet read_wamit_set(Reading& reading);
/// Capytaine's NetCDF-4.
HydroSet read_capytaine_set(Reading& reading);
/// BEMIO's .h5.
HydroSet read_bemio_set(Reading& reading);
/// A folder of NEMOH.
HydroSet read_nemoh_set(Reading& reading);

}  // namespace hawser::io
