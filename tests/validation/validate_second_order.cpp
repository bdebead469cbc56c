// Validation row B11: quadratic transfer functions of a semi-submersible from WAMIT files of others
// (--reference), read and made to act; mean of Newman's force in a sea with own data.
#include <filesystem>
#include <fstream>
#include <functional>

#include "../master/spar_hull.hpp"
#include "validation/reference.hpp"
#include "validation/row.hpp"

namespace hawser::master {
namespace {

namespace fs = std::filesystem;
constexpr double rho = 1025, g = 9.80665;

HydroDatabase database(const fs::path& stem, double volume, double depth_of_buoyancy) {
    HydroDatabase d;
    d.path = stem.string();
    d.rho = rho;
    d.displaced_volume = volume;
    d.centre_of_buoyancy = Vec3(0, 0, -depth_of_buoyancy);
    return d;
}

/// One mode of a QTF file as it stands there, over periods: other code than the program's reader.
struct RawQtf {
    std::vector<double> periods;  ///< falling
    std::vector<Complex> values;
    [[nodiscard]] std::size_t place(double T) const {
        for (std::size_t i = 0; i < periods.size(); ++i)
            if (std::abs(periods[i] - T) < 1e-4 * T) return i;
        return periods.size();
    }
    [[nodiscard]] Complex at(std::size_t i, std::size_t j) const {
        return values[i * periods.size() + j];
    }
    [[nodiscard]] double omega(std::size_t i) const { return 2 * M_PI / periods[i]; }
    /// Straight in triangles along the diagonal.
    [[nodiscard]] Complex between(double w1, double w2) const {
        const auto cell = [&](double w) {
            std::size_t i = 0;
            while (i + 2 < periods.size() && omega(i + 1) < w) ++i;
            return std::pair{i, (w - omega(i)) / (omega(i + 1) - omega(i))};
        };
        const auto [i, s] = cell(w1);
        const auto [j, u] = cell(w2);
        return s >= u ? (1 - s) * at(i, j) + (s - u) * at(i + 1, j) + u * at(i + 1, j + 1)
                      : (1 - u) * at(i, j) + (u - s) * at(i, j + 1) + s * at(i + 1, j + 1);
    }
};

RawQtf raw(const std::string& file, int mode, bool conjugate) {
    std::ifstream in(file);
    std::vector<std::array<double, 9>> rows;
    for (std::array<double, 9> r{}; in;) {
        for (double& x : r) in >> x;
        if (in && static_cast<int>(r[4]) == mode) rows.push_back(r);
    }
    RawQtf qtf;
    for (const auto& r : rows)
        if (qtf.place(r[0]) == qtf.periods.size()) qtf.periods.push_back(r[0]);
    std::sort(qtf.periods.rbegin(), qtf.periods.rend());
    const std::size_t N = qtf.periods.size();
    qtf.values.resize(N * N);
    for (const auto& r : rows) {
        const std::size_t i = qtf.place(r[0]), j = qtf.place(r[1]);
        qtf.values[i * N + j] = Complex(r[7], r[8]);
        qtf.values[j * N + i] = Complex(r[7], conjugate ? -r[8] : r[8]);
    }
    return qtf;
}

Case volturnus(const std::string& folder, const std::vector<WaveTrain>& waves) {
    Case c;
    c.environment.seabed.depth = 200;
    c.environment.waves = waves;
    Platform& p = c.platform.emplace();
    p.mass = 20092e3;
    p.centre_of_gravity = {0, 0, -1.859};
    p.radii_of_gyration = {47, 47, 34.5};
    p.hydrodynamics.database = database(fs::path(folder) / "volturnus_s/volturnus_s", 20206.35, 0);
    p.hydrodynamics.drift = Drift::full_qtf;
    c.analysis.dynamics.ramp = 0;
    return c;
}

Complex harmonic(const std::function<double(double)>& f, double w, double T, int n) {
    Complex sum = 0;
    for (int i = 0; i < n; ++i) sum += f(T * i / n) * std::polar(1.0, -w * T * i / n);
    return 2.0 * sum / static_cast<double>(n);
}

const char* const semi_rows =
    "VolturnUS-S: QTF diagonal; pairs of waves; mean and variance of the slow force in a sea";

TEST(ValidationB11, QtfOfTheSemiSubmersible) {
    const std::string folder = reference_folder();
    if (folder.empty()) return skip_row("B11", semi_rows);
    const std::string stem = (fs::path(folder) / "volturnus_s/volturnus_s").string();
    Case c = volturnus(folder, {});
    const HydroData data = io::read_hydro(*c.platform->hydrodynamics.database, Water{}, 200);
    const WaveTable<CVec6> own = diagonal(data.difference);
    const auto D = [&](double T) {
        std::size_t i = 0;
        while (std::abs(own.frequencies[i] - 2 * M_PI / T) > 1e-3) ++i;
        return own.headings[0].values[i][0].real() / (rho * g);
    };
    validate({"B11", "QTF diagonal, surge, 10.47 s [rho g m]", 0.7176, D(10.472), 5e-5, false});
    validate({"B11", "QTF diagonal, surge, 12.57 s [rho g m]", 0.3394, D(12.566), 5e-5, false});

    // Two waves at frequencies of the file: amplitudes at their difference and their sum.
    const double T1 = 8.976, T2 = 12.566;  // 0.7 and 0.5 rad/s
    c.environment.waves = {{.type = WaveType::airy, .H = 2, .T = T1},
                           {.type = WaveType::airy, .H = 4, .T = T2, .phase = 0.4}};
    c.platform->hydrodynamics.added_mass_frequency = 0.5;
    const Hull pair(c, &data);
    const State s = pair.start({}, {});
    const double w1 = 2 * M_PI / T1, w2 = 2 * M_PI / T2;
    const double T = 200 * M_PI / (w1 - w2);  // w1 + w2 fits within 1e-4 of a period
    for (const int mode : {0, 2, 4}) {
        const RawQtf slow = raw(stem + ".12d", mode + 1, true),
                     fast = raw(stem + ".12s", mode + 1, false);
        const Complex turn = std::polar(rho * g * 2 * 1.0 * 2.0, -0.4);
        const Complex Qd = slow.at(slow.place(T1), slow.place(T2)) * turn;
        const Complex Qs = fast.at(fast.place(T1), fast.place(T2)) * std::conj(turn);
        const auto part = [&](Load load) {
            return [&, load](double t) { return pair.loads(t, s)[load][mode]; };
        };
        const char* const motion[] = {"surge", "", "heave", "", "pitch"};
        const std::string what = motion[mode];
        validate({"B11", ("two waves: " + what + ", difference, off in the plane [-]").c_str(), 0,
                  std::abs(harmonic(part(Load::drift), w1 - w2, T, 8000) / Qd - 1.0), 1e-3, false});
        validate({"B11", ("two waves: " + what + ", sum, off in the plane [-]").c_str(), 0,
                  std::abs(harmonic(part(Load::wave2), w1 + w2, T, 8000) / Qs - 1.0), 1e-3, false});
    }

    // A sea: mean 2 int S D dw; power below 0.15 rad/s, where moorings answer: 8 int int S(w)
    // S(w + mu) |Q|^2 dw dmu (Pinkster). At large mu the phase of Q turns too far between the
    // frequencies of the file to tell one interpolation from another.
    const double slow_below = 0.15;
    const RawQtf surge = raw(stem + ".12d", 1, true);
    const double Hs = 6, wp = 2 * M_PI / 12;
    const auto S = [&](double w) {
        const double sigma = w <= wp ? 0.07 : 0.09;
        return 5.0 / 16 * Hs * Hs * std::pow(wp, 4) * std::pow(w, -5) *
               std::exp(-1.25 * std::pow(wp / w, 4)) *
               std::pow(3.3, std::exp(-0.5 * std::pow((w - wp) / (sigma * wp), 2)));
    };
    double m0 = 0, mean = 0, variance = 0, at_zero = 0;
    const double dw = 0.005;
    for (double w = 0.5 * wp + dw / 2; w < 2.49; w += dw) {
        const double D0 = w < 0.25 ? surge.at(0, 0).real() : surge.between(w, w).real();
        m0 += S(w) * dw;
        mean += 2 * S(w) * D0 * dw;
        at_zero += 8 * S(w) * S(w) * D0 * D0 * dw;
        for (double mu = dw / 2; w + mu < 2.49 && mu < slow_below; mu += dw)
            variance += 8 * S(w) * S(w + mu) * std::norm(surge.between(w + mu, w)) * dw * dw;
    }
    const double energy = Hs * Hs / 16 / m0;  // the program's seas carry exactly Hs^2/16
    mean *= rho * g * energy;
    variance *= std::pow(rho * g * energy, 2);
    at_zero *= std::pow(rho * g * energy, 2);

    double constant = 0, found_mean = 0, found_variance = 0;
    const int seas = 40, n = 3000;
    const double step = 1.2;  // 2 pi / step is above twice the largest difference frequency
    std::vector<Complex> lines(static_cast<std::size_t>(slow_below * step * n / (2 * M_PI)) + 1);
    for (int seed = 1; seed <= seas; ++seed) {
        c.environment.waves = {{.type = WaveType::jonswap,
                                .Hs = Hs,
                                .Tp = 12,
                                .gamma = 3.3,
                                .seed = static_cast<std::uint64_t>(seed),
                                .components = 400}};
        const Hull hull(c, &data);
        const State rest = hull.start({}, {});
        const double still = hull.static_load({}, {.current = false, .wind_mean = false})[0];
        constant += still / seas;
        std::fill(lines.begin(), lines.end(), 0.0);
        for (int i = 0; i < n; ++i) {
            const double f = hull.loads(step * i, rest)[Load::drift][0];
            found_mean += f / (n * seas);
            for (std::size_t k = 1; k < lines.size(); ++k)
                lines[k] += std::polar((f - still) / n, -2 * M_PI * static_cast<double>(k) * i / n);
        }
        for (const Complex& line : lines) found_variance += 2 * std::norm(line) / seas;
    }
    validate({"B11", "mean drift of a sea, 6 m, 12 s: statics [N]", mean, constant, 5e-3});
    validate({"B11", "its mean over 40 h less that, in standard errors [-]", 0,
              (found_mean - constant) / std::sqrt(M_PI * at_zero / (seas * n * step)), 3, false});
    // 85 lines of 40 seas: 1/sqrt(3400) of the power, half of that of its root, three times over.
    validate({"B11", "rms of the force below 0.15 rad/s [N]", std::sqrt(variance),
              std::sqrt(found_variance), 3e-2});
}

TEST(ValidationB11, NewmansMeanInASpectrum) {  // own data: the truss spar's hull
    Case c = spar_case();
    c.environment.waves = {paper_sea()};
    c.environment.waves[0].components = 400;
    c.platform->hydrodynamics.drift = Drift::newman;
    c.platform->hydrodynamics.added_mass_frequency = 0.4;
    c.analysis.dynamics.ramp = 0;
    const Hull hull(c, &spar_data());
    const auto& table = spar_data().mean_drift;
    const auto ahead = std::find_if(table.headings.begin(), table.headings.end(),
                                    [](const auto& h) { return std::abs(h.heading) < 1e-6; });
    ASSERT_NE(ahead, table.headings.end());
    const auto& values = ahead->values;
    const double wp = 2 * M_PI / 15.6;
    double m0 = 0, mean = 0;
    const double dw = 1e-4;
    for (double w = 0.5 * wp; w < 5 * wp; w += dw) {
        const double sigma = w <= wp ? 0.07 : 0.09;
        const double S = std::pow(w, -5) * std::exp(-1.25 * std::pow(wp / w, 4)) *
                         std::pow(2.4, std::exp(-0.5 * std::pow((w - wp) / (sigma * wp), 2)));
        std::size_t i = 0;
        while (i + 2 < table.frequencies.size() && table.frequencies[i + 1] < w) ++i;
        const double s = std::clamp(
            (w - table.frequencies[i]) / (table.frequencies[i + 1] - table.frequencies[i]), 0.0,
            1.0);
        m0 += S * dw;
        mean += 2 * S * ((1 - s) * values[i][0] + s * values[i + 1][0]) * dw;
    }
    mean *= 15.2 * 15.2 / 16 / m0;
    const State rest = hull.start({}, {});
    double found = 0;
    const int n = 20000;
    for (int i = 0; i < n; ++i) found += hull.loads(7.1 * i, rest)[Load::drift][0] / n;
    validate({"B11", "own data, Newman: mean over 39 h of the truss spar's hull [N]", mean, found,
              2e-2});
}

}  // namespace
}  // namespace hawser::master
