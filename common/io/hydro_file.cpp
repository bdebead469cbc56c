#include "io/hydro_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "environment/dispersion.hpp"
#include "hydro_checks.hpp"
#include "io/hydro_reading.hpp"
#include "io/qtf_rows.hpp"
#include "wave_table.hpp"

namespace hawser::io {

namespace {

HydroSet read_set(Reading& reading) {
    switch (reading.database.format) {
        case HydroFormat::capytaine:
            return read_capytaine_set(reading);
        case HydroFormat::bemio:
            return read_bemio_set(reading);
        case HydroFormat::nemoh:
            return read_nemoh_set(reading);
        default:
            return read_wamit_set(reading);
    }
}

/// What the case states goes before what the files tell; where both do, they must agree.
void stated_values(Reading& r, HydroData& data) {
    const HydroDatabase& d = r.database;
    const auto differs = [](double a, double b) { return std::abs(a - b) > 5e-3 * std::abs(b); };
    if (d.rho) {
        if (data.density > 0.0 && differs(*d.rho, data.density))
            r.problems.add(d.path, 0,
                           fmt::format("says a density of {:g} kg/m3; the key rho says {:g}",
                                       data.density, *d.rho));
        data.density = *d.rho;
    }
    if (d.displaced_volume) {
        if (data.displaced_volume > 0.0 && differs(*d.displaced_volume, data.displaced_volume))
            r.problems.add(
                d.path, 0,
                fmt::format("says a displaced volume of {:.6g} m3; the key displaced_volume says "
                            "{:.6g}",
                            data.displaced_volume, *d.displaced_volume));
        data.displaced_volume = *d.displaced_volume;
    }
    if (d.centre_of_buoyancy) data.centre_of_buoyancy = *d.centre_of_buoyancy;
    if (data.density < 900.0 || data.density > 1100.0)
        r.problems.add(
            d.path, 0,
            fmt::format("rho: expected the density of water, 900 to 1100 kg/m3; got {:g}",
                        data.density));
    if (data.gravity == 0.0) data.gravity = r.gravity;
    if (data.depth == 0.0) data.depth = r.depth;
}

/// Where nothing else tells volume and centre of buoyancy, the panels of the .gdf do.
void volume_of_panels(Reading& r, const HydroSet& set, HydroData& data) {
    if (data.displaced_volume > 0.0 || !set.geometry || !set.geometry->hull) return;
    const PanelHydrostatics& hull = *set.geometry->hull;
    if (!(hull.volume() > 0.0) || hull.gap() > 0.02) return;
    data.displaced_volume = hull.volume();
    data.centre_of_buoyancy = hull.centre_of_buoyancy + r.database.reference_point;
    data.centre_of_buoyancy.z() += hull.waterline;
    r.notes.push_back(
        fmt::format("{}: displaced volume {:.6g} m3 and centre of buoyancy are those "
                    "inside its panels",
                    set.geometry->file.string(), data.displaced_volume));
}

/// Mirrors and orders the headings of all tables. Symmetry about xz: stated in the case, or plain
/// from excitation over half a turn.
void finish_headings(Reading& r, const Path& file, HydroData& data) {
    const auto& planes = r.database.symmetry;
    const bool yz = std::find(planes.begin(), planes.end(), "yz") != planes.end();
    bool xz = std::find(planes.begin(), planes.end(), "xz") != planes.end();
    if (!xz && looks_symmetric_about_xz(data.excitation)) {
        xz = true;
        r.notes.push_back(
            fmt::format("{}: headings 0 to 180 deg are mirrored to a full turn: sway, roll and yaw "
                        "vanish at both ends, so the hull is taken as symmetric about xz",
                        file.string()));
    }
    const auto finish = [&](auto& table) {
        if (yz) mirror(table, false);
        if (xz) mirror(table, true);
        order_headings(table);
    };
    for (WaveTable<CVec6>* table :
         {&data.excitation, &data.haskind, &data.froude_krylov, &data.scattering, &data.motion})
        finish(*table);
    finish(data.mean_drift);
    for (MeanDrift& other : data.other_drift) finish(other.table);
    for (Qtf* qtf : {&data.difference, &data.sum}) {
        if (yz) mirror(*qtf, false);
        if (xz) mirror(*qtf, true);
    }
}

/// A crest at the files' origin at phase zero becomes a crest at O, which stands at (x0, y0) of
/// their axes: X e^{+i k (x0 cos b + y0 sin b)}.
void move_phase_origin(const std::vector<double>& at, HydroData& data) {
    if (at.size() != 2 || (at[0] == 0.0 && at[1] == 0.0)) return;
    const double depth = data.depth > 0.0 ? data.depth : 1e9;
    const auto phase = [&](double w, double b) {
        return wave_number(w, depth, data.gravity) * (at[0] * std::cos(b) + at[1] * std::sin(b));
    };
    for (WaveTable<CVec6>* table :
         {&data.excitation, &data.haskind, &data.froude_krylov, &data.scattering, &data.motion})
        for (auto& h : table->headings)
            for (std::size_t f = 0; f < table->frequencies.size(); ++f)
                h.values[f] *= std::polar(1.0, phase(table->frequencies[f], h.heading));
    for (Qtf* qtf : {&data.difference, &data.sum})
        for (QtfPair& p : qtf->pairs)
            for (std::size_t m = 0, N = qtf->frequencies.size(); m < N; ++m)
                for (std::size_t n = 0; n < N; ++n) {
                    const double second = phase(qtf->frequencies[n], p.heading_2);
                    p.values[m * N + n] *=
                        std::polar(1.0, phase(qtf->frequencies[m], p.heading_1) +
                                            (qtf == &data.sum ? second : -second));
                }
}

/// K:7: what is left of C for heave, roll and pitch without buoyancy and weight, and C with its
/// two parts apart; still about the files' origin P.
void take_apart(Reading& r, const HydroSet& set, HydroData& data) {
    if (!set.stiffness) return;
    const HydroDatabase& d = r.database;
    const Path& file = set.stiffness_file;
    const Mat6& C = *set.stiffness;
    if (d.includes_weight) {
        if (C(3, 3) < 0.0 || C(4, 4) < 0.0)
            r.problems.add(file, 0,
                           "C44 or C55 is negative, which proves that the file does not contain "
                           "the weight; expected includes_weight: false");
        // z_G about P, like the files' moments.
        data.weight_stiffness(3, 3) = data.weight_stiffness(4, 4) =
            -d.included_mass * data.gravity * d.included_z;
    }
    data.buoyancy_stiffness = C - data.weight_stiffness;
    if (data.displaced_volume == 0.0) return;
    const double z_B = data.centre_of_buoyancy.z() - d.reference_point.z();
    const double rho_g = data.density * data.gravity;
    Mat3 waterplane = data.buoyancy_stiffness->block<3, 3>(2, 2);
    waterplane(1, 1) -= rho_g * data.displaced_volume * z_B;
    waterplane(2, 2) -= rho_g * data.displaced_volume * z_B;

    data.waterplane_stiffness = waterplane;
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
    CMat6 back = CMat6::Identity();  // T^-1
    back.block<3, 3>(0, 3) = skew(r).cast<Complex>();
    const CMat6 Tt = T.transpose().cast<Complex>();
    for (WaveTable<CVec6>* table :
         {&data.excitation, &data.haskind, &data.froude_krylov, &data.scattering})
        for (auto& h : table->headings)
            for (CVec6& X : h.values) X = (Tt * X).eval();
    for (auto& h : data.motion.headings)
        for (CVec6& X : h.values) X = (back * X).eval();
    const auto shift_drift = [&](WaveTable<Vec6>& table) {
        for (auto& h : table.headings)
            for (Vec6& D : h.values) D = (T.transpose() * D).eval();
    };
    shift_drift(data.mean_drift);
    for (MeanDrift& other : data.other_drift) shift_drift(other.table);
    for (Qtf* qtf : {&data.difference, &data.sum})
        for (QtfPair& p : qtf->pairs)
            for (CVec6& Q : p.values) Q = (Tt * Q).eval();

    // z_P = z_O + roll y_P - pitch x_P. The buoyancy part of C moves as its waterplane does, and
    // its rho g V z_B and the weight's -m g z_G take the height above O.
    Mat3 S = Mat3::Identity();
    S(0, 1) = r.y();
    S(0, 2) = -r.x();
    data.waterplane_stiffness = (S.transpose() * data.waterplane_stiffness * S).eval();
    if (!data.buoyancy_stiffness) return;
    Mat3 C = data.buoyancy_stiffness->block<3, 3>(2, 2);
    C = (S.transpose() * C * S).eval();
    const double lift = data.density * data.gravity * data.displaced_volume * r.z();
    C(1, 1) += lift;
    C(2, 2) += lift;
    data.buoyancy_stiffness->block<3, 3>(2, 2) = C;
}

/// The line that tells most of what a check found: of its frequency and mode, else of its
/// frequency; 0 if there is none.
int line_of(const HydroCheck& check, const std::vector<RowPlace>& rows) {
    int line = 0;
    for (const RowPlace& row : rows) {
        if (check.frequency == 0.0 || !same_frequency(row.frequency, check.frequency)) continue;
        if (row.mode == check.mode) return row.line;
        if (line == 0 && check.mode < 0) line = row.line;
    }
    return line;
}

/// The file that a check is about, and its rows if there are any.
std::pair<Path, const std::vector<RowPlace>*> place_of(HydroCheck::About about,
                                                       const HydroSet& set) {
    using About = HydroCheck::About;
    if (about == About::radiation) return {set.radiation_file, &set.radiation_rows};
    if (about == About::stiffness) return {set.stiffness_file, nullptr};
    if (about == About::drift && !set.drift_file.empty()) return {set.drift_file, nullptr};
    if (about == About::second_order && !set.second_order_file.empty())
        return {set.second_order_file, nullptr};
    return {set.excitation_file, &set.excitation_rows};
}

CheckedHydro read_once(const HydroDatabase& database, const Water& water, double depth) {
    Reading r{database, water.gravity, depth, {}, {}};
    HydroSet set = read_set(r);
    CheckedHydro out;
    HydroData& data = out.data = std::move(set.data);
    stated_values(r, data);
    volume_of_panels(r, set, data);
    finish_headings(r, set.excitation_file, data);
    take_apart(r, set, data);
    if (!r.problems.empty()) throw HydroFileError(r.problems);
    std::vector<PlacedCheck> of_inputs = check_wamit_inputs(database, set, data);
    move_phase_origin(database.phase_origin, data);
    shift_to_reference_point(database.reference_point, data);
    // Of a stated rho the checks of the case tell.
    if (!database.rho && std::abs(data.density / water.density - 1.0) > 0.005)
        data.doubts.push_back(
            {database.path, 0,
             fmt::format("made dimensional with {:g} kg/m3, but the water of the case has {:g} "
                         "kg/m3",
                         data.density, water.density)});
    for (HydroCheck& check : check_hydro(data)) {
        const auto [file, rows] = place_of(check.about, set);
        const int line = rows != nullptr ? line_of(check, *rows) : 0;
        out.checks.push_back({std::move(check), file.string(), line});
    }
    std::move(of_inputs.begin(), of_inputs.end(), std::back_inserter(out.checks));
    out.files = std::move(set.files);
    data.notes = std::move(r.notes);
    return out;
}

/// What is wrong is thrown, what is doubtful kept.
HydroData accepted(CheckedHydro checked) {
    FileProblems problems;
    for (const auto& [check, file, line] : checked.checks) {
        if (check.verdict == HydroCheck::Verdict::wrong) problems.add(file, line, check.sentence);
        if (check.verdict == HydroCheck::Verdict::doubtful)
            checked.data.doubts.push_back({file, line, check.sentence});
    }
    if (!problems.empty()) throw HydroFileError(problems);
    HydroData& data = checked.data;
    if (data.mean_drift.empty() && !data.difference.empty()) {
        data.mean_drift = real_part(diagonal(data.difference));
        data.drift_is_of_qtf = true;
    }
    return std::move(data);
}

/// period_column: auto. The reading whose damping and excitation belong together by Haskind's
/// relation is the right one.
CheckedHydro read_either(HydroDatabase database, const Water& water, double depth) {
    std::optional<HydroData> best;
    double least = 0.0;
    std::string problems;
    const char* is = "";
    for (const auto& [column, word] :
         {std::pair{PeriodColumn::period, "periods"}, {PeriodColumn::frequency, "frequencies"}}) {
        database.period_column = column;
        Reading r{database, water.gravity, depth, {}, {}};
        HydroSet set = read_set(r);
        stated_values(r, set.data);
        if (!r.problems.empty()) {
            if (problems.empty()) problems = r.problems.text();
            continue;
        }
        finish_headings(r, set.excitation_file, set.data);
        const std::optional<double> misfit = haskind_misfit(set.data);
        if (!misfit || (best && *misfit >= least)) continue;
        best.emplace();
        least = *misfit;
        is = word;
    }
    if (!best) {
        FileProblems none;
        none.add(database.path, 0,
                 "cannot tell whether the first column holds periods or frequencies: excitation "
                 "over a full turn of headings would; expected period_column: period or frequency");
        throw HydroFileError(none);
    }
    database.period_column =
        is == std::string("periods") ? PeriodColumn::period : PeriodColumn::frequency;
    CheckedHydro checked = read_once(database, water, depth);
    checked.data.notes.insert(
        checked.data.notes.begin(),
        fmt::format("{}: the first column is taken for {}: damping and excitation "
                    "then agree within {:.2g} % (Haskind)",
                    database.path, is, 100 * least));
    return checked;
}
}  // namespace

CheckedHydro read_checked_hydro(const HydroDatabase& database, const Water& water, double depth) {
    return database.period_column == PeriodColumn::automatic ? read_either(database, water, depth)
                                                             : read_once(database, water, depth);
}

HydroData read_hydro(const HydroDatabase& database, const Water& water, double depth) {
    return accepted(read_checked_hydro(database, water, depth));
}

HydroData read_hydro(const HydroDatabase& database, const Environment& environment) {
    return read_hydro(database, environment.water, environment.seabed.depth);
}

}  // namespace hawser::io
