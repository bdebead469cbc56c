#include "io/hydro_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hydro_relations.hpp"
#include "io/text_table.hpp"
#include "io/wave_rows.hpp"
#include "motion_names.hpp"

namespace hawser::io {

namespace {
using Verdict = HydroCheck::Verdict;
constexpr double degree = M_PI / 180.0;

const char* word_of(Verdict v) {
    return v == Verdict::fine       ? "fine"
           : v == Verdict::remark   ? "remark"
           : v == Verdict::doubtful ? "doubtful"
                                    : "wrong";
}
const char* word_of(DriftMethod m) {
    return m == DriftMethod::momentum   ? "momentum (.8)"
           : m == DriftMethod::pressure ? "pressure (.9)"
                                        : "control surface (.7)";
}

std::string depth_text(double depth) {
    return depth == 0.0        ? "not known"
           : std::isinf(depth) ? "infinite"
                               : fmt::format("{:g} m", depth);
}

std::string span(const std::vector<double>& w) {
    return w.empty() ? "none"
                     : fmt::format("{} frequencies, {:.4g} to {:.4g} rad/s", w.size(), w.front(),
                                   w.back());
}

template <class Value>
std::string span(const WaveTable<Value>& table) {
    if (table.empty()) return "none";
    const auto& h = table.headings;
    return fmt::format("{}; {} heading{} {:.4g}{}{}", span(table.frequencies), h.size(),
                       h.size() == 1 ? "" : "s", h.front().heading / degree,
                       h.size() == 1 ? std::string(" deg")
                                     : fmt::format(" to {:.4g} deg", h.back().heading / degree),
                       table.full_circle ? ", a full turn" : "");
}

std::string span(const Qtf& q) {
    if (q.empty()) return "none";
    std::size_t given = 0;
    for (const QtfPair& p : q.pairs)
        given += static_cast<std::size_t>(std::count(p.given.begin(), p.given.end(), 1));
    return fmt::format(
        "{}; {} pair{} of headings, {:.0f} % of the values", span(q.frequencies), q.pairs.size(),
        q.pairs.size() == 1 ? "" : "s",
        100.0 * static_cast<double>(given) /
            static_cast<double>(q.pairs.size() * q.frequencies.size() * q.frequencies.size()));
}

void say(std::string& text, const char* what, const std::string& is) {
    text += fmt::format("  {:<22}{}\n", what, is);
}

void contents(const CheckedHydro& found, std::string& text) {
    const HydroData& d = found.data;
    std::string limits;
    if (d.added_mass_0) limits = "; zero";
    if (d.added_mass_inf) limits += limits.empty() ? "; infinite" : " and infinite";
    say(text, "added mass, damping",
        span(d.frequencies) + (limits.empty() ? "; no limits" : limits + " frequency"));
    say(text, "excitation", span(d.excitation));
    if (!d.haskind.empty()) say(text, "  by Haskind (.2)", span(d.haskind));
    if (!d.froude_krylov.empty()) say(text, "  Froude-Krylov part", span(d.froude_krylov));
    if (!d.scattering.empty()) say(text, "  scattering part", span(d.scattering));
    if (!d.motion.empty()) say(text, "free motion", span(d.motion));
    if (d.mean_drift.empty())
        say(text, "mean drift", "none");
    else
        say(text, "mean drift",
            fmt::format("by {}: {}", word_of(d.drift_method), span(d.mean_drift)));
    for (const MeanDrift& other : d.other_drift)
        say(text, "  also", fmt::format("by {}: {}", word_of(other.method), span(other.table)));
    say(text, "difference QTF", span(d.difference));
    say(text, "sum QTF", span(d.sum));
    say(text, "symmetry shown", symmetry_shown(d));
}

void hydrostatics(const HydroRequest& request, const HydroData& d, std::string& text) {
    text += title("Hydrostatics about the reference point, weight taken out");
    const double rho_g = d.density * d.gravity;
    if (d.displaced_volume > 0.0) {
        say(text, "displaced volume",
            fmt::format("{:.6g} m3, {:.6g} t", d.displaced_volume,
                        1e-3 * d.density * d.displaced_volume));
        say(text, "centre of buoyancy",
            fmt::format("[{:.4g}, {:.4g}, {:.6g}] m", d.centre_of_buoyancy.x(),
                        d.centre_of_buoyancy.y(), d.centre_of_buoyancy.z()));
    } else {
        say(text, "displaced volume", "not in the files; --volume and --centre-of-buoyancy say it");
    }
    if (!d.buoyancy_stiffness) {
        say(text, "stiffness", "none");
        return;
    }
    const Mat6& C = *d.buoyancy_stiffness;
    say(text, "waterplane", fmt::format("{:.6g} m2", C(2, 2) / rho_g));
    say(text, "C33", fmt::format("{:.6g} N/m", C(2, 2)));
    say(text, "C44, C55, C45",
        fmt::format("{:.6g}, {:.6g}, {:.6g} N.m/rad", C(3, 3), C(4, 4), C(3, 4)));
    say(text, "C34, C35", fmt::format("{:.6g}, {:.6g} N/rad", C(2, 3), C(2, 4)));
    if (d.displaced_volume == 0.0) return;
    const double z_B = d.centre_of_buoyancy.z();
    const double BM_T = d.waterplane_stiffness(1, 1) / (rho_g * d.displaced_volume);
    const double BM_L = d.waterplane_stiffness(2, 2) / (rho_g * d.displaced_volume);
    say(text, "metacentre",
        fmt::format("z_B + I/V: {:.5g} + {:.4g} = {:.5g} m in roll, {:.5g} + "
                    "{:.4g} = {:.5g} m in pitch",
                    z_B, BM_T, z_B + BM_T, z_B, BM_L, z_B + BM_L));
    if (!request.mass) return;
    say(text, "metacentric height",
        fmt::format("GM {:.5g} m in roll, {:.5g} m in pitch (centre of gravity at {:g} m)",
                    z_B + BM_T - request.cog, z_B + BM_L - request.cog, request.cog));
    say(text, "mass",
        fmt::format("{:.6g} t, {:+.2f} % of the displaced", 1e-3 * *request.mass,
                    100 * (*request.mass / (d.density * d.displaced_volume) - 1)));
}

void radiation(const HydroData& d, std::string& text) {
    text += title("Added mass and damping");
    TextTable table;
    table.column("", "kg, kg.m2");
    table.column("A(0)");
    table.column("A, lowest");
    table.column("A at peak of B");
    table.column("A, highest");
    table.column("A(inf)");
    table.column("B, largest", "kg/s, ...");
    table.column("at", "rad/s");
    const double none = std::nan("");
    for (const auto& [i, j] :
         {std::pair{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {0, 4}, {1, 3}}) {
        std::size_t peak = 0;
        for (std::size_t f = 0; f < d.frequencies.size(); ++f)
            if (std::abs(d.damping[f](i, j)) > std::abs(d.damping[peak](i, j))) peak = f;
        const std::string name(motion_names[static_cast<std::size_t>(i)]);
        table.row(
            {i == j ? name : name + "-" + std::string(motion_names[static_cast<std::size_t>(j)]),
             digits(d.added_mass_0 ? (*d.added_mass_0)(i, j) : none),
             digits(d.added_mass.front()(i, j)), digits(d.added_mass[peak](i, j)),
             digits(d.added_mass.back()(i, j)),
             digits(d.added_mass_inf ? (*d.added_mass_inf)(i, j) : none),
             digits(d.damping[peak](i, j)), digits(d.frequencies[peak], 4)});
    }
    text += table.text();
}

Json numbers(const std::vector<double>& x) {
    Json list = Json::array();
    for (const double v : x) list.add(v);
    return list;
}
Json matrix(const Mat6& M) {
    Json rows = Json::array();
    for (int i = 0; i < 6; ++i) {
        Json row = Json::array();
        for (int j = 0; j < 6; ++j) row.add(M(i, j));
        rows.add(std::move(row));
    }
    return rows;
}
Json matrices(const std::vector<Mat6>& all) {
    Json list = Json::array();
    for (const Mat6& M : all) list.add(matrix(M));
    return list;
}
Json vector(const Vec6& v) { return numbers(std::vector<double>(v.data(), v.data() + 6)); }

/// {frequencies, headings [deg], full_turn, re[heading][frequency][mode], im ...}
template <class Value>
Json table(const WaveTable<Value>& t) {
    constexpr bool is_complex = std::is_same_v<Value, CVec6>;
    Json headings = Json::array(), re = Json::array(), im = Json::array();
    for (const auto& h : t.headings) {
        headings.add(h.heading / degree);
        Json x = Json::array(), y = Json::array();
        for (const Value& v : h.values) {
            x.add(vector(v.real()));
            if constexpr (is_complex) y.add(vector(v.imag()));
        }
        re.add(std::move(x));
        im.add(std::move(y));
    }
    Json out = Json::object();
    out.put("frequencies", numbers(t.frequencies))
        .put("headings", std::move(headings))
        .put("full_turn", t.full_circle)
        .put("re", std::move(re));
    if (is_complex) out.put("im", std::move(im));
    return out;
}

/// {frequencies, pairs: [{headings, re[m][n][mode], im}]}, null where the files have no value.
Json qtf(const Qtf& q) {
    Json pairs = Json::array();
    const std::size_t N = q.frequencies.size();
    for (const QtfPair& p : q.pairs) {
        Json re = Json::array(), im = Json::array();
        for (std::size_t m = 0; m < N; ++m) {
            Json x = Json::array(), y = Json::array();
            for (std::size_t n = 0; n < N; ++n) {
                const CVec6& Q = p.values[m * N + n];
                const bool given = p.given[m * N + n] != 0;
                x.add(given ? vector(Q.real()) : Json(std::nan("")));
                y.add(given ? vector(Q.imag()) : Json(std::nan("")));
            }
            re.add(std::move(x));
            im.add(std::move(y));
        }
        Json one = Json::object();
        one.put("headings", numbers({p.heading_1 / degree, p.heading_2 / degree}))
            .put("re", std::move(re))
            .put("im", std::move(im));
        pairs.add(std::move(one));
    }
    Json out = Json::object();
    out.put("frequencies", numbers(q.frequencies)).put("pairs", std::move(pairs));
    return out;
}
}  // namespace

namespace {
/// Excitation is the mirror image of itself, as far as there are headings to compare.
bool mirrors(const WaveTable<CVec6>& table, bool about_xz) {
    const CVec6 sign = mirror_sign(about_xz).cast<Complex>();
    for (const auto& h : table.headings)
        for (const auto& image : table.headings) {
            const double b = about_xz ? -h.heading : M_PI - h.heading;
            if (std::abs(std::remainder(b - image.heading, 2 * M_PI)) > 1e-6) continue;
            double off = 0.0, all = 0.0;
            for (std::size_t f = 0; f < table.frequencies.size(); ++f) {
                const CVec6 X = h.values[f].cwiseProduct(sign);
                off += (X - image.values[f]).head<3>().norm();
                all += X.head<3>().norm();
            }
            if (off > 0.01 * all) return false;
        }
    return true;
}
}  // namespace

std::string symmetry_shown(const HydroData& d) {
    // Terms that couple what a plane keeps apart, against the size of what they couple.
    Vec6 most = Vec6::Zero();
    for (const Mat6& A : d.added_mass) most = most.cwiseMax(A.diagonal().cwiseAbs());
    const auto couples = [&](const std::vector<int>& one, const std::vector<int>& other) {
        for (const Mat6& A : d.added_mass)
            for (const int i : one)
                for (const int j : other)
                    if (std::abs(A(i, j)) > 0.01 * std::sqrt(most[i] * most[j])) return true;
        return false;
    };
    const bool xz = !couples({0, 2, 4}, {1, 3, 5}) && mirrors(d.excitation, true);
    const bool yz = !couples({0, 4, 5}, {1, 2, 3}) && mirrors(d.excitation, false);
    bool round = xz && yz;
    for (const Mat6& A : d.added_mass)
        round = round && std::abs(A(0, 0) - A(1, 1)) < 0.01 * most[0] &&
                std::abs(A(3, 3) - A(4, 4)) < 0.01 * most[4] &&
                std::abs(A(5, 5)) < 0.01 * std::max(most[3], most[4]);
    return round ? "round" : xz && yz ? "xz and yz" : xz ? "xz" : yz ? "yz" : "none";
}

std::string hydro_text(const HydroRequest& request, const CheckedHydro& found) {
    const HydroData& d = found.data;
    std::string text = d.source + "\n";
    say(text, "made dimensional with",
        fmt::format("rho {:g} kg/m3, g {:g} m/s2, ulen {:g} m", d.density, d.gravity,
                    request.database.ulen));
    for (const std::string& assumed : request.assumed) say(text, "  assumed", assumed);
    say(text, "depth of the water", depth_text(d.depth));
    contents(found, text);
    hydrostatics(request, d, text);
    if (!d.frequencies.empty()) radiation(d, text);
    if (!d.notes.empty()) {
        text += title("Notes of the reader");
        for (const std::string& note : d.notes) text += "  " + note + "\n";
    }
    text += title("Checks");
    for (const auto& [check, file, line] : found.checks) {
        std::string where;
        if (check.verdict == Verdict::doubtful || check.verdict == Verdict::wrong)
            where = line > 0 ? fmt::format(" [{}:{}]", file, line) : fmt::format(" [{}]", file);
        text += fmt::format("  {:<9}{}{}\n", word_of(check.verdict), check.sentence, where);
    }
    return text;
}

Json hydro_json(const HydroRequest& request, const CheckedHydro& found) {
    const HydroData& d = found.data;
    Json files = Json::array(), notes = Json::array(), checks = Json::array();
    for (const std::string& file : found.files) files.add(file);
    for (const std::string& note : d.notes) notes.add(note);
    for (const auto& [check, file, line] : found.checks) {
        Json one = Json::object();
        one.put("what", check.what).put("verdict", word_of(check.verdict));
        if (check.size) one.put("size", *check.size);
        one.put("file", file);
        if (line > 0) one.put("line", line);
        one.put("message", check.sentence);
        checks.add(std::move(one));
    }
    Json out = Json::object();
    out.put("source", d.source)
        .put("files", std::move(files))
        .put("density", d.density)
        .put("gravity", d.gravity)
        .put("ulen", request.database.ulen)
        .put("depth", std::isinf(d.depth) ? Json("infinite") : Json(d.depth))
        .put("displaced_volume", d.displaced_volume)
        .put("centre_of_buoyancy", numbers({d.centre_of_buoyancy.x(), d.centre_of_buoyancy.y(),
                                            d.centre_of_buoyancy.z()}))
        .put("symmetry", symmetry_shown(d))
        .put("notes", std::move(notes))
        .put("checks", std::move(checks))
        .put("frequencies", numbers(d.frequencies))
        .put("added_mass", matrices(d.added_mass))
        .put("damping", matrices(d.damping));
    if (d.added_mass_0) out.put("added_mass_0", matrix(*d.added_mass_0));
    if (d.added_mass_inf) out.put("added_mass_inf", matrix(*d.added_mass_inf));
    if (const auto haskind = haskind_damping(d)) {
        Json w = Json::array(), B = Json::array();
        for (std::size_t i = 0; i < haskind->at.size(); ++i) {
            w.add(d.frequencies[haskind->at[i]]);
            B.add(matrix(haskind->damping(d, i, d.depth).real()));
        }
        Json by = Json::object();
        by.put("frequencies", std::move(w)).put("damping", std::move(B));
        out.put("damping_by_haskind", std::move(by));
    }
    if (d.buoyancy_stiffness) out.put("buoyancy_stiffness", matrix(*d.buoyancy_stiffness));
    out.put("excitation", table(d.excitation));
    if (!d.motion.empty()) out.put("motion", table(d.motion));
    Json drift = Json::array();
    const auto add_drift = [&](DriftMethod method, const WaveTable<Vec6>& of) {
        if (of.empty()) return;
        Json one = table(of);
        one.put("method", word_of(method));
        drift.add(std::move(one));
    };
    add_drift(d.drift_method, d.mean_drift);
    for (const MeanDrift& other : d.other_drift) add_drift(other.method, other.table);
    out.put("mean_drift", std::move(drift))
        .put("difference", qtf(d.difference))
        .put("sum", qtf(d.sum));
    return out;
}

}  // namespace hawser::io
