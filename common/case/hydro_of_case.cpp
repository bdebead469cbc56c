#include "case/hydro_of_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "environment/wave_components.hpp"
#include "status.hpp"
#include "wave_table.hpp"

namespace hawser {

namespace {
constexpr double turn = 2.0 * M_PI, degree = M_PI / 180.0;
constexpr double rounding = 1e-6;  // [rad]

/// Mass of water displaced at the design draft [kg].
double displaced_mass(const Case& input, const Platform& p, double volume) {
    for (const Member& m : p.members) {
        const double top = std::max(m.from.z(), m.to.z()), low = std::min(m.from.z(), m.to.z());
        const double length = (m.to - m.from).norm();
        const double wet = top <= 0.0 ? 1.0 : low >= 0.0 ? 0.0 : -low / (top - low);
        if (m.flooded) continue;
        // A truncated cone from its lower end up to the surface.
        const double from = std::sqrt(m.displaced_area);
        const double to = std::sqrt(m.displaced_area_to.value_or(m.displaced_area));
        const bool turned = m.to.z() < m.from.z();
        const double bottom = turned ? to : from;
        const double cut = bottom + wet * ((turned ? from : to) - bottom);
        volume += (bottom * bottom + bottom * cut + cut * cut) / 3.0 * length * wet;
    }
    return input.environment.water.density * volume;
}

template <class Value>
bool covers(const WaveTable<Value>& table, double heading) {
    if (table.full_circle) return true;
    if (table.headings.size() == 1)
        return std::abs(std::remainder(heading - table.headings.front().heading, turn)) <=
               one_heading_reach + rounding;
    const double first = table.headings.front().heading, last = table.headings.back().heading;
    const double b = heading - turn * std::floor((heading - first + rounding) / turn);
    return b <= last + rounding;
}

/// In a sentence: one alone has no need of its name.
std::string called(const Case& input, const Platform& p) {
    return input.platform_count() > 1 ? p.name : "the platform";
}

/// "the 0 to 180 deg of the database's excitation"
template <class Value>
std::string headings_of(const WaveTable<Value>& table, const std::string& what) {
    const double first = table.headings.front().heading / degree,
                 last = table.headings.back().heading / degree;
    if (table.headings.size() == 1)
        return fmt::format("the one heading, {:.4g} deg, of the database's {}", first, what);
    return fmt::format("the {:.4g} to {:.4g} deg of the database's {}", first, last, what);
}

template <class Value>
void check_waves(const Case& input, const WaveTable<Value>& table, double yaw,
                 const std::string& what, const std::string& of, Problems& problems) {
    const Environment& e = input.environment;
    double energy = 0.0, outside = 0.0;
    for (std::size_t i = 0; i < e.waves.size(); ++i) {
        const std::string path = fmt::format("environment.waves[{}]", i);
        bool told = false;
        for (const WaveComponent& c :
             wave_components(e.waves[i], e.seabed.depth, e.water.gravity)) {
            const double a2 = c.amplitude * c.amplitude;
            energy += a2;
            if (c.omega < table.frequencies.front() * (1 - 1e-5) ||
                c.omega > table.frequencies.back() * (1 + 1e-5))
                outside += a2;
            if (told || covers(table, c.heading - yaw)) continue;
            told = true;
            const double train = e.waves[i].heading;
            const bool spread = std::abs(std::remainder(c.heading - train, turn)) > rounding;
            problems.push_back(
                {Severity::error,
                 path + ".heading",
                 fmt::format("waves{} meet {} at a heading of {:.4g} deg, outside {}; headings are "
                             "never extrapolated: compute more of them, or state the symmetry of "
                             "the hull",
                             spread ? fmt::format(" spread about {:.4g} deg",
                                                  std::remainder(train - yaw, turn) / degree)
                                    : std::string(),
                             of, std::remainder(c.heading - yaw, turn) / degree,
                             headings_of(table, what)),
                 {}});
        }
    }
    if (outside > 0.01 * energy)
        problems.push_back(
            {Severity::error,
             "environment.waves",
             fmt::format("{:.1f} % of the waves' energy lies outside the frequencies of the "
                         "database's {}, {:.3g} to {:.3g} rad/s; expected at most 1 %",
                         100 * outside / energy, what, table.frequencies.front(),
                         table.frequencies.back()),
             {}});
}

/// The pairs of the waves' components that the QTF does not have are zero: how much they would
/// carry, by the product of their energies.
void check_pairs(const Case& input, const Platform& p, const Qtf& qtf, const std::string& what,
                 Problems& problems) {
    const Environment& e = input.environment;
    const std::vector<double>& at = qtf.frequencies;
    const std::size_t N = at.size();
    std::vector<double> energy(N, 0.0);  // of the waves nearest to each frequency of the file
    for (const WaveTrain& train : e.waves)
        for (const WaveComponent& c : wave_components(train, e.seabed.depth, e.water.gravity)) {
            std::size_t nearest = 0;
            for (std::size_t g = 1; g < N; ++g)
                if (std::abs(at[g] - c.omega) < std::abs(at[nearest] - c.omega)) nearest = g;
            energy[nearest] += c.amplitude * c.amplitude;
        }
    double all = 0.0, missing = 0.0;
    for (const QtfPair& pair : qtf.pairs) {
        if (std::abs(std::remainder(pair.heading_1 - pair.heading_2, turn)) > rounding) continue;
        for (std::size_t m = 0; m < N; ++m)
            for (std::size_t n = 0; n < N; ++n) {
                all += energy[m] * energy[n];
                if (pair.given[m * N + n] == 0) missing += energy[m] * energy[n];
            }
        for (std::size_t m = 0; m < N; ++m)
            if (pair.given[m * N + m] == 0 && energy[m] > 0.0) {
                problems.push_back(
                    {Severity::error,
                     p.key_path + ".hydrodynamics.drift",
                     fmt::format("the database's {} has no value on its diagonal at {:.4g} rad/s, "
                                 "heading {:.4g} deg",
                                 what, at[m], pair.heading_1 / degree),
                     {}});
                return;
            }
    }
    if (missing > 0.01 * all)
        problems.push_back(
            {Severity::warning,
             p.key_path + ".hydrodynamics.drift",
             fmt::format("the database's {} lacks pairs of frequencies that carry {:.1f} % of the "
                         "pairs of the waves by energy; they are taken for zero",
                         what, 100 * missing / all),
             {}});
}

/// Full QTFs: there, over the frequencies and headings of the waves, with all pairs.
void check_qtf(const Case& input, const Platform& p, const HydroData& data, Problems& problems) {
    const auto add = [&](Severity severity, std::string message) {
        problems.push_back({severity, p.key_path + ".hydrodynamics.drift", std::move(message), {}});
    };
    if (data.difference.empty()) {
        add(Severity::error,
            "full_qtf: the database holds no difference-frequency QTF (.10d, .11d or .12d); "
            "newman does with mean drift alone");
        return;
    }
    if (data.sum.empty())
        add(Severity::note, "no sum-frequency QTF in the database: difference frequencies alone");
    std::vector<double> headings;  // that the waves have
    for (const WaveTrain& train : input.environment.waves) {
        headings.push_back(train.heading);
        if (train.spreading) headings.push_back(train.heading + turn / 2);
    }
    const bool several = std::adjacent_find(headings.begin(), headings.end(),
                                            std::not_equal_to<>()) != headings.end();
    for (const auto& [qtf, what] :
         {std::pair{&data.difference, "difference QTF"}, {&data.sum, "sum QTF"}}) {
        if (qtf->empty()) continue;
        const WaveTable<CVec6> own = diagonal(*qtf);
        if (own.empty()) {
            add(Severity::error, fmt::format("the database's {} has no equal headings", what));
            continue;
        }
        check_waves(input, own, p.initial.angles.z(), what, called(input, p), problems);
        check_pairs(input, p, *qtf, what, problems);
        const std::size_t H = own.headings.size();
        if (several && H > 1 && qtf->pairs.size() < H * H)
            add(Severity::note, fmt::format("the {} lacks pairs of unequal headings: waves of two "
                                            "headings take the mean of their own",
                                            what));
    }
}
}  // namespace

void check_displacement(const Case& input, const Platform& p, double volume, Problems& problems) {
    const double water = displaced_mass(input, p, volume);
    const auto add = [&](Severity severity, const char* key, std::string message) {
        problems.push_back({severity, p.key_path + key, std::move(message), {}});
    };
    if (p.displacement && std::abs(*p.displacement / water - 1.0) > 0.005)
        add(Severity::error, ".displacement",
            fmt::format("{:.0f} t given, but database and members displace {:.0f} t ({:+.2f} %; "
                        "0.5 % is allowed)",
                        *p.displacement / 1e3, water / 1e3,
                        100.0 * (*p.displacement / water - 1.0)));
    if (p.mass && input.lines.empty() && std::abs(*p.mass / water - 1.0) > 0.005)
        add(Severity::warning, ".mass",
            fmt::format("{:.0f} t, but {:.0f} t of water are displaced at the design draft: the "
                        "platform will rise or sink; `auto` keeps the draft",
                        *p.mass / 1e3, water / 1e3));
    if (!p.mass && water == 0.0)
        add(Severity::error, ".mass",
            "auto needs buoyancy: a database or members that displace water");
}

void check_size(const Case& input, const Platform& p, const HydroData* data, Problems& problems) {
    const double rho = input.environment.water.density;
    const double volume =
        displaced_mass(input, p, data != nullptr ? data->displaced_volume : 0.0) / rho;
    if (volume <= 0.0) return;
    double draft = p.draft.value_or(0.0), length = std::cbrt(volume);
    for (const Member& m : p.members) {
        draft = std::max({draft, -m.from.z(), -m.to.z()});
        length = std::max({length, m.from.norm(), m.to.norm(), (m.to - m.from).norm()});
    }
    const auto say = [&](Severity severity, const char* key, std::string message) {
        problems.push_back({severity, p.key_path + key, std::move(message), {}});
    };
    if (data != nullptr && data->displaced_volume > 0.0) {
        const double z_B = data->centre_of_buoyancy.z(),
                     area = data->waterplane_stiffness(0, 0) / (data->density * data->gravity);
        length = std::max(length, -2.0 * z_B);
        if (area > 0.0)
            length =
                std::max({length, data->displaced_volume / area, 2.0 * std::sqrt(area / M_PI)});
        const char* of = p.draft ? ".draft" : ".members";
        // The centre of buoyancy of the database must lie inside the hull; no hull is all keel.
        if (draft > 0.0 && p.members.empty() && (z_B <= -draft || z_B > 0.0))
            say(Severity::error, of,
                fmt::format("the keel is at -{:.4g} m, but the centre of buoyancy of the database "
                            "is at {:.4g} m: expected it between keel and waterline",
                            draft, z_B));
        else if (draft > 0.0 && p.members.empty() && (z_B < -0.85 * draft || z_B > -0.15 * draft))
            say(Severity::warning, of,
                fmt::format("{:.4g} m, with the centre of buoyancy of the database at {:.4g} m: "
                            "hardly any hull has it so near to {}",
                            draft, z_B, z_B < -0.5 * draft ? "the keel" : "the waterline"));
    }
    length = std::max(length, draft);
    Vec3 radii = p.radii_of_gyration;
    if (p.inertia && p.mass) radii = (p.inertia->diagonal() / *p.mass).cwiseMax(0.0).cwiseSqrt();
    const char* names[3] = {"roll", "pitch", "yaw"};
    for (int i = 0; i < 3; ++i) {
        if (radii[i] <= 0.0 || (radii[i] >= 0.05 * std::cbrt(volume) && radii[i] <= 2.5 * length))
            continue;
        say(Severity::warning, p.inertia ? ".inertia" : ".radii_of_gyration",
            fmt::format("a radius of gyration in {} of {:.4g} m is hardly that of a hull of {:.4g} "
                        "m3 whose largest dimension is about {:.3g} m; look at its unit",
                        names[i], radii[i], volume, length));
    }
}

void check_steps_of_waves(const Case& input, Problems& problems) {
    const Environment& e = input.environment;
    const double step = input.analysis.dynamics.platform_step, shortest = 6.0 * step;
    double energy = 0.0, of_short = 0.0, least = std::numeric_limits<double>::infinity();
    try {
        for (const WaveTrain& train : e.waves)
            for (const WaveComponent& c : wave_components(train, e.seabed.depth, e.water.gravity)) {
                const double a2 = c.amplitude * c.amplitude, period = turn / c.omega;
                energy += a2;
                if (period >= shortest * (1 - 1e-9)) continue;
                of_short += a2;
                least = std::min(least, period);
            }
    } catch (const RunError&) {
        return;  // told by whoever makes the waves
    }
    if (of_short <= 0.05 * energy) return;
    problems.push_back(
        {Severity::warning,
         "analysis.dynamics.steps.platform",
         fmt::format("{:.4g} s, but {:.3g} % of the waves' energy has periods below six steps "
                     "(down to {:.4g} s): the platform's motion in them is not resolved",
                     step, 100 * of_short / energy, least),
         {}});
}

void check_coverage(const Case& input, const Platform& p, const HydroData& data,
                    Problems& problems) {
    const Environment& e = input.environment;
    const std::string database = p.key_path + ".hydrodynamics.database";
    const auto warning = [&](const std::string& path, std::string message) {
        problems.push_back({Severity::warning, path, std::move(message), {}});
    };
    if (data.depth > 0.0) {
        // The waves see the bed where k h < pi, roughly.
        const double seen = M_PI * e.water.gravity / std::pow(data.frequencies.front(), 2);
        const double file = std::min(data.depth, seen), here = std::min(e.seabed.depth, seen);
        if (std::abs(file / here - 1.0) > 0.05)
            warning(database,
                    fmt::format("computed for {} of water; the case has {:.6g} m",
                                std::isinf(data.depth) ? std::string("infinite depth")
                                                       : fmt::format("{:.6g} m", data.depth),
                                e.seabed.depth));
    }
    if (e.waves.empty()) return;
    if (data.excitation.empty()) {
        problems.push_back(
            {Severity::error, database, "holds no excitation, and the case has waves", {}});
        return;
    }
    try {
        check_waves(input, data.excitation, p.initial.angles.z(), "excitation", called(input, p),
                    problems);
        if (p.hydrodynamics.drift == Drift::none) return;
        if (p.hydrodynamics.drift == Drift::full_qtf) {
            check_qtf(input, p, data, problems);
            return;
        }
        if (data.drift_is_of_qtf)
            problems.push_back({Severity::note,
                                p.key_path + ".hydrodynamics.drift",
                                "the database holds no mean drift; the diagonal of its difference "
                                "QTF is taken for it",
                                {}});
        if (data.mean_drift.empty())
            problems.push_back({Severity::error,
                                p.key_path + ".hydrodynamics.drift",
                                "the database holds no mean drift",
                                {}});
        else
            check_waves(input, data.mean_drift, p.initial.angles.z(), "mean drift",
                        called(input, p), problems);
    } catch (const RunError&) {
        // waves that cannot be made are told by whoever makes them
    }
}

}  // namespace hawser
