#include "io/hydro_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/wave_rows.hpp"

namespace hawser::io {

namespace {
using Path = std::filesystem::path;

/// What one reading shares: where the files are, what makes them dimensional, what went wrong.
struct Reading {
    const HydroDatabase& database;
    double gravity;
    FileProblems problems;
    std::vector<std::string> notes;
    bool symmetric_about_xz = false;  ///< told, or shown by the excitation

    [[nodiscard]] Path file(const std::string& extension) const {
        return database.path + extension;
    }
    [[nodiscard]] double power_of_length(int n) const { return std::pow(database.ulen, n); }
};

int rotation_of(int mode) { return mode >= 3 ? 1 : 0; }

// A mode number of the file as 0 .. 5, or -1 with a problem.
int mode_of(double number, const Path& file, int line, FileProblems& problems) {
    const int mode = static_cast<int>(number);
    if (mode == number && mode >= 1 && mode <= 6) return mode - 1;
    problems.add(file, line,
                 mode == number && mode > 6
                     ? fmt::format("mode {} belongs to a second body; expected one body, modes "
                                   "1 to 6",
                                   mode)
                     : fmt::format("expected a mode 1 to 6; got {:g}", number));
    return -1;
}

double frequency_of(double period, const Path& file, int line, FileProblems& problems) {
    if (period > 0.0) return 2.0 * M_PI / period;
    problems.add(file, line, fmt::format("expected a period above zero; got {:g}", period));
    return 0.0;
}

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

// Largest |M_ij - M_ji| as a part of sqrt(M_ii M_jj).
double asymmetry(const Mat6& M) {
    double worst = 0.0;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < i; ++j) {
            const double scale = std::sqrt(std::abs(M(i, i) * M(j, j)));
            if (scale > 0.0) worst = std::max(worst, std::abs(M(i, j) - M(j, i)) / scale);
        }
    return worst;
}

/// .1: PER I J A B; PER < 0 is zero, PER = 0 infinite frequency, both without B.
void read_radiation(Reading& r, HydroData& data) {
    const Path file = r.file(".1");
    const std::vector<Record> records = read_records(file, 4, r.problems);
    for (const Record& record : records)
        if (record.numbers[0] > 0.0) data.frequencies.push_back(2.0 * M_PI / record.numbers[0]);
    data.frequencies = distinct_frequencies(std::move(data.frequencies));

    std::vector<GatheredMatrix> A(data.frequencies.size()), B(data.frequencies.size());
    std::optional<GatheredMatrix> zero, infinite;
    for (const Record& record : records) {
        const int i = mode_of(record.numbers[1], file, record.line, r.problems);
        const int j = mode_of(record.numbers[2], file, record.line, r.problems);
        if (i < 0 || j < 0) continue;
        const double scale =
            r.database.rho * r.power_of_length(3 + rotation_of(i) + rotation_of(j));
        const double period = record.numbers[0], added = scale * record.numbers[3];
        if (period < 0.0) {
            if (!zero) zero.emplace();
            zero->set(i, j, added);
        } else if (period == 0.0) {
            if (!infinite) infinite.emplace();
            infinite->set(i, j, added);
        } else if (record.numbers.size() < 5) {
            r.problems.add(file, record.line, "expected 5 numbers, PER I J A B; got 4");
        } else {
            const double w = 2.0 * M_PI / period;
            const auto at = static_cast<std::size_t>(
                std::lower_bound(data.frequencies.begin(), data.frequencies.end(), w * (1 - 4e-6)) -
                data.frequencies.begin());
            A[at].set(i, j, added);
            B[at].set(i, j, scale * w * record.numbers[4]);
        }
    }
    if (!records.empty() && data.frequencies.empty())
        r.problems.add(file, 0, "holds no finite period");
    double worst = 0.0;
    for (std::size_t f = 0; f < A.size(); ++f) {
        data.added_mass.push_back(A[f].filled());
        data.damping.push_back(B[f].filled());
        worst = std::max(worst, asymmetry(data.added_mass.back()));
        for (int i = 0; i < 6; ++i)
            if (data.damping.back()(i, i) < -1e-3 * data.frequencies[f] * data.added_mass[f](i, i))
                r.notes.push_back(fmt::format("{}: damping of mode {} is negative at {:.4g} rad/s",
                                              file.string(), i + 1, data.frequencies[f]));
    }
    if (worst > 0.02)
        r.notes.push_back(fmt::format("{}: added mass is not symmetric, by {:.1f} %", file.string(),
                                      100 * worst));
    if (zero) data.added_mass_0 = zero->filled();
    if (infinite) data.added_mass_inf = infinite->filled();
}

/// Mirrors and orders the headings of a table.
void finish_headings(const Reading& r, WaveTable<CVec6>& table) {
    const auto& planes = r.database.symmetry;
    if (std::find(planes.begin(), planes.end(), "yz") != planes.end()) mirror(table, false);
    if (r.symmetric_about_xz) mirror(table, true);
    order_headings(table);
}

// Symmetry about xz: stated in the case, or plain from excitation over half a turn.
void decide_symmetry(Reading& r, const WaveTable<CVec6>& excitation, const Path& file) {
    const auto& planes = r.database.symmetry;
    r.symmetric_about_xz = std::find(planes.begin(), planes.end(), "xz") != planes.end();
    if (r.symmetric_about_xz || !looks_symmetric_about_xz(excitation)) return;
    r.symmetric_about_xz = true;
    r.notes.push_back(
        fmt::format("{}: headings 0 to 180 deg are mirrored to a full turn: sway, roll and yaw "
                    "vanish at both ends, so the hull is taken as symmetric about xz",
                    file.string()));
}

/// .3 (or .2, Haskind): PER BETA I mod phase Re Im.
void read_excitation(Reading& r, HydroData& data) {
    Path file = r.file(".3");
    if (!std::filesystem::exists(file) && !std::filesystem::exists(r.file(".2")))
        return;  // still water needs none; with waves the check of the case has asked for it
    if (!std::filesystem::exists(file) && std::filesystem::exists(r.file(".2"))) {
        file = r.file(".2");
        r.notes.push_back(
            fmt::format("{}: excitation is taken from it, there is no .3", file.string()));
    }
    std::vector<WaveRow> rows;
    for (const Record& record : read_records(file, 7, r.problems)) {
        const auto& x = record.numbers;
        const int i = mode_of(x[2], file, record.line, r.problems);
        const double w = frequency_of(x[0], file, record.line, r.problems);
        if (i < 0 || w <= 0.0) continue;
        const double scale = r.database.rho * r.gravity * r.power_of_length(2 + rotation_of(i));
        rows.push_back({record.line, w, x[1], i, scale * Complex(x[5], x[6])});
    }
    data.excitation = table_of(rows, file, r.problems);
    std::vector<double> strange;  // periods without added mass
    for (const WaveRow& row : rows) {
        const auto same = [&](double w) { return same_frequency(w, row.frequency); };
        if (std::any_of(data.frequencies.begin(), data.frequencies.end(), same) ||
            std::any_of(strange.begin(), strange.end(), same))
            continue;
        strange.push_back(row.frequency);
        r.problems.add(
            file, row.line,
            fmt::format("period {:.6g} s has excitation but no added mass and damping in "
                        "{}",
                        2 * M_PI / row.frequency, r.file(".1").filename().string()));
    }
    decide_symmetry(r, data.excitation, file);
    finish_headings(r, data.excitation);
}

/// .8, else .9, else .7: PER BETA1 BETA2 I mod phase Re Im, rows with BETA1 = BETA2.
void read_drift(Reading& r, HydroData& data) {
    Path file;
    for (const char* extension : {".8", ".9", ".7"})
        if (file.empty() && std::filesystem::exists(r.file(extension))) file = r.file(extension);
    if (file.empty()) return;
    std::vector<WaveRow> rows;
    for (const Record& record : read_records(file, 8, r.problems)) {
        const auto& x = record.numbers;
        if (x[3] < 0.0 || std::remainder(x[1] - x[2], 360.0) != 0.0) continue;
        const int i = mode_of(x[3], file, record.line, r.problems);
        const double w = frequency_of(x[0], file, record.line, r.problems);
        if (i < 0 || w <= 0.0) continue;
        const double scale = r.database.rho * r.gravity * r.power_of_length(1 + rotation_of(i));
        rows.push_back({record.line, w, x[1], i, scale * x[6]});
    }
    WaveTable<CVec6> table = table_of(rows, file, r.problems);
    finish_headings(r, table);
    data.mean_drift.frequencies = table.frequencies;
    data.mean_drift.full_circle = table.full_circle;
    for (const auto& h : table.headings) {
        HeadingData<Vec6>& real = data.mean_drift.headings.emplace_back();
        real.heading = h.heading;
        for (const CVec6& v : h.values) real.values.emplace_back(v.real());
    }
    data.drift_is_horizontal = file.extension() == ".8";
    if (data.drift_is_horizontal)
        r.notes.push_back(
            fmt::format("{}: from momentum, so the mean drift of heave, roll and "
                        "pitch is zero",
                        file.string()));
}

/// .hst: I J C. K:7: what is left of C for heave, roll and pitch without buoyancy and weight.
void read_hydrostatics(Reading& r, HydroData& data) {
    const Path file = r.file(".hst");
    const HydroDatabase& d = r.database;
    GatheredMatrix gathered;
    const std::vector<Record> records = read_records(file, 3, r.problems);
    for (const Record& record : records) {
        const int i = mode_of(record.numbers[0], file, record.line, r.problems);
        const int j = mode_of(record.numbers[1], file, record.line, r.problems);
        if (i < 0 || j < 0) continue;
        gathered.set(i, j,
                     d.rho * r.gravity * r.power_of_length(2 + rotation_of(i) + rotation_of(j)) *
                         record.numbers[2]);
    }
    if (records.empty()) return;
    const Mat6 C = gathered.filled();
    const double z_B = d.centre_of_buoyancy.z() - d.reference_point.z();
    double upright = d.rho * r.gravity * d.displaced_volume * z_B;
    if (d.includes_weight) {
        if (C(3, 3) < 0.0 || C(4, 4) < 0.0)
            r.problems.add(file, 0,
                           "C44 or C55 is negative, which proves that the file does not contain "
                           "the weight; expected includes_weight: false");
        upright -= d.included_mass * r.gravity * d.included_z;
    }
    Mat3 waterplane = C.block<3, 3>(2, 2);
    waterplane(1, 1) -= upright;
    waterplane(2, 2) -= upright;

    // Of all waterplanes of one area the disc has the least polar moment, A^2/(2 pi).
    const double area = waterplane(0, 0) / (d.rho * r.gravity);
    const double polar = (waterplane(1, 1) + waterplane(2, 2)) / (d.rho * r.gravity);
    if (area < 0.0 || polar < 0.9 * area * area / (2 * M_PI))
        r.problems.add(
            file, 0,
            fmt::format("C33 means a waterplane of {:.5g} m2, whose second moments sum to at least "
                        "{:.5g} m4; C44 + C55 without buoyancy leave {:.5g} m4. Check ulen, "
                        "displaced_volume, centre_of_buoyancy and includes_weight",
                        area, area * area / (2 * M_PI), polar));

    // From the files' origin P to O: z_P = z_O + roll y_P - pitch x_P.
    Mat3 T = Mat3::Identity();
    T(0, 1) = d.reference_point.y();
    T(0, 2) = -d.reference_point.x();
    data.waterplane_stiffness = T.transpose() * waterplane * T;
}

/// Moves everything from the files' origin to O: with (v_P, w) = T (v_O, w), A_O = T^t A T,
/// X_O = T^t X. The phase stays that of the crest at O.
void shift_to_reference_point(const Vec3& r, HydroData& data) {
    if (r.isZero()) return;
    Mat6 T = Mat6::Identity();
    T.block<3, 3>(0, 3) = -skew(r);
    const auto shift = [&](Mat6& A) { A = (T.transpose() * A * T).eval(); };
    for (Mat6& A : data.added_mass) shift(A);
    for (Mat6& B : data.damping) shift(B);
    if (data.added_mass_0) shift(*data.added_mass_0);
    if (data.added_mass_inf) shift(*data.added_mass_inf);
    for (auto& h : data.excitation.headings)
        for (CVec6& X : h.values) X = (T.transpose().cast<Complex>() * X).eval();
    for (auto& h : data.mean_drift.headings)
        for (Vec6& D : h.values) D = (T.transpose() * D).eval();
}
}  // namespace

HydroData read_hydro(const HydroDatabase& database, const Water& water) {
    Reading r{database, water.gravity, {}, {}, false};
    HydroData data;
    data.density = database.rho;
    data.displaced_volume = database.displaced_volume;
    data.centre_of_buoyancy = database.centre_of_buoyancy;
    if (database.rho < 900.0 || database.rho > 1100.0)
        r.problems.add(
            database.path, 0,
            fmt::format("rho: expected the density of water, 900 to 1100 kg/m3; got {:g}",
                        database.rho));
    read_radiation(r, data);
    read_excitation(r, data);
    read_drift(r, data);
    read_hydrostatics(r, data);
    if (!r.problems.empty()) throw HydroFileError(r.problems);
    shift_to_reference_point(database.reference_point, data);
    if (std::abs(database.rho / water.density - 1.0) > 0.01)
        r.notes.push_back(
            fmt::format("{}: made dimensional with {:g} kg/m3, but the water of the "
                        "case has {:g} kg/m3",
                        database.path, database.rho, water.density));
    data.notes = std::move(r.notes);
    return data;
}

}  // namespace hawser::io
