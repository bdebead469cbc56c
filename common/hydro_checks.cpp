#include "hydro_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "environment/dispersion.hpp"
#include "motion_names.hpp"

namespace hawser {

namespace {
using Verdict = HydroCheck::Verdict;
using About = HydroCheck::About;
constexpr double degree = M_PI / 180.0;

double depth_of(const HydroData& d) { return d.depth > 0.0 && d.depth < 1e6 ? d.depth : 1e6; }
double wave_number_of(const HydroData& d, double w) {
    return wave_number(w, depth_of(d), d.gravity);
}
/// c_g = w / (2k) (1 + 2kh / sinh 2kh)
double group_speed(const HydroData& d, double w) {
    const double k = wave_number_of(d, w), kh2 = 2 * k * depth_of(d);
    return w / (2 * k) * (1 + (kh2 < 50 ? kh2 / std::sinh(kh2) : 0.0));
}

/// Place of a frequency of the excitation among those of the radiation, or none.
std::optional<std::size_t> place(const std::vector<double>& frequencies, double w) {
    for (std::size_t i = 0; i < frequencies.size(); ++i)
        if (std::abs(frequencies[i] - w) < 1e-5 * w) return i;
    return std::nullopt;
}

/// int_0^2pi |X_i|^2 db, by the trapezoidal rule over a full turn. Of a round hull one heading
/// tells all: |X_1(0)|^2 pi for the modes that have a direction, |X_3|^2 2 pi for heave, none for
/// yaw, which does not radiate.
double around(const WaveTable<CVec6>& table, std::size_t f, int mode, bool round) {
    const auto& all = table.headings;
    if (table.full_circle) {
        double sum = 0.0;
        for (std::size_t h = 0; h < all.size(); ++h) {
            const double before = h > 0 ? all[h - 1].heading : all.back().heading - 2 * M_PI;
            const double after =
                h + 1 < all.size() ? all[h + 1].heading : all.front().heading + 2 * M_PI;
            sum += std::norm(all[h].values[f][mode]) * (after - before) / 2;
        }
        return sum;
    }
    if (!round || mode == 5) return std::nan("");
    const CVec6& X = all.front().values[f];
    if (mode == 2) return 2 * M_PI * std::norm(X[2]);
    const int x = mode == 0 || mode == 1 ? 0 : 4, y = mode == 0 || mode == 1 ? 1 : 3;
    return M_PI * (std::norm(X[x]) + std::norm(X[y]));
}

bool is_round(const HydroData& d) {
    double off = 0.0, all = 0.0;
    for (const Mat6& A : d.added_mass) {
        off += std::abs(A(0, 0) - A(1, 1)) + std::abs(A(0, 1));
        all += std::abs(A(0, 0));
    }
    return off < 0.01 * all;
}

/// Misfit of one mode; `inverted`: as if periods and frequencies had been mistaken.
std::optional<double> haskind_of(const HydroData& d, int mode, bool inverted) {
    const auto& X = d.excitation;
    if (X.empty()) return std::nullopt;
    const bool round = is_round(d);
    double off = 0.0, all = 0.0;
    for (std::size_t f = 0; f < X.frequencies.size(); ++f) {
        const auto at = place(d.frequencies, X.frequencies[f]);
        if (!at) continue;
        double w = X.frequencies[f], B = d.damping[*at](mode, mode);
        if (inverted) {
            B *= 2 * M_PI / (w * w);  // files hold B over w
            w = 2 * M_PI / w;
        }
        const double turn = around(X, f, mode, round);
        if (!std::isfinite(turn)) return std::nullopt;
        const double by_haskind =
            wave_number_of(d, w) / (8 * M_PI * d.density * d.gravity * group_speed(d, w)) * turn;
        off += std::abs(B - by_haskind);
        all += std::abs(B);
    }
    if (all == 0.0) return std::nullopt;
    return off / all;
}

class Checks {
 public:
    explicit Checks(const HydroData& data) : d_(data) {}

    std::vector<HydroCheck> run() {
        if (!d_.frequencies.empty()) {
            symmetry();
            damping();
            size_of_added_mass();
        }
        stiffness();
        if (!d_.excitation.empty()) {
            parts();
            long_waves();
            haskind();
        }
        motion();
        second_order();
        return std::move(list_);
    }

 private:
    void add(Verdict verdict, About about, std::string what, std::string sentence) {
        list_.push_back({verdict, about, std::move(what), std::move(sentence)});
    }

    /// Largest |M_ij - M_ji| as a part of sqrt(M_ii M_jj).
    static double asymmetry(const std::vector<Mat6>& all) {
        double worst = 0.0;
        for (const Mat6& M : all)
            for (int i = 0; i < 6; ++i)
                for (int j = 0; j < i; ++j) {
                    const double scale = std::sqrt(std::abs(M(i, i) * M(j, j)));
                    if (scale > 0.0) worst = std::max(worst, std::abs(M(i, j) - M(j, i)) / scale);
                }
        return worst;
    }

    void symmetry() {
        const double A = asymmetry(d_.added_mass);
        add(A > 0.02 ? Verdict::doubtful : Verdict::fine, About::radiation, "symmetry",
            A > 0.02 ? fmt::format("added mass is not symmetric, by {:.1f} %", 100 * A)
                     : fmt::format("added mass is symmetric within {:.2g} %", 100 * A));
    }

    void damping() {
        std::array<double, 6> most{};
        for (const Mat6& B : d_.damping)
            for (int i = 0; i < 6; ++i)
                most[static_cast<std::size_t>(i)] =
                    std::max(most[static_cast<std::size_t>(i)], std::abs(B(i, i)));
        bool fine = true;
        for (int i = 0; i < 6; ++i) {
            double worst = 0.0, where = 0.0;
            bool large = false;
            for (std::size_t f = 0; f < d_.damping.size(); ++f) {
                const double B = d_.damping[f](i, i), w = d_.frequencies[f];
                const double wA = w * std::abs(d_.added_mass[f](i, i));
                if (B >= -1e-3 * wA || B >= worst) continue;
                worst = B;
                where = w;
                large = B < -0.2 * most[static_cast<std::size_t>(i)] && B < -0.02 * wA;
            }
            if (worst == 0.0) continue;
            fine = false;
            add(large ? Verdict::wrong : Verdict::doubtful, About::radiation, "damping",
                fmt::format(
                    "damping of mode {} is negative at {:.4g} rad/s ({:.3g}, with {:.3g} at "
                    "most){}",
                    i + 1, where, worst, most[static_cast<std::size_t>(i)],
                    large ? ": the hull would feed itself from the sea" : ""));
        }
        if (fine) add(Verdict::fine, About::radiation, "damping", "damping is nowhere negative");
    }

    void size_of_added_mass() {
        const Mat6& A = d_.added_mass_inf ? *d_.added_mass_inf : d_.added_mass.back();
        for (int i = 0; i < 6; ++i)
            if (d_.added_mass_inf && A(i, i) < 0.0)
                add(Verdict::wrong, About::radiation, "added mass",
                    fmt::format("added mass of mode {} at infinite frequency is negative ({:.4g})",
                                i + 1, A(i, i)));
        if (d_.displaced_volume == 0.0 || A(0, 0) == 0.0) return;
        const double ratio = A(0, 0) / (d_.density * d_.displaced_volume);
        const bool wrong = ratio < 2e-4 || ratio > 50, odd = ratio < 0.01 || ratio > 6;
        add(wrong ? Verdict::wrong
            : odd ? Verdict::doubtful
                  : Verdict::fine,
            About::radiation, "added mass",
            fmt::format("surge added mass {} is {:.3g} of the displaced mass{}",
                        d_.added_mass_inf ? "at infinite frequency" : "at the highest frequency",
                        ratio, odd ? "; check rho, ulen and displaced_volume" : ""));
    }

    void stiffness() {
        if (!d_.buoyancy_stiffness || d_.displaced_volume == 0.0) return;
        const double area = (*d_.buoyancy_stiffness)(2, 2) / (d_.density * d_.gravity);
        if (area <= 0.0) return;
        const double slender = d_.displaced_volume / std::pow(area, 1.5);
        const bool odd = slender < 0.01 || slender > 100;
        add(odd ? Verdict::doubtful : Verdict::fine, About::stiffness, "waterplane",
            fmt::format("C33 means a waterplane of {:.5g} m2; the volume is {:.3g} m deep below "
                        "it{}",
                        area, d_.displaced_volume / area,
                        odd ? ", which no hull is; check rho, ulen and displaced_volume" : ""));
    }

    /// sum |X - Y| / sum |X| of a mode.
    static double difference(const WaveTable<CVec6>& X, const WaveTable<CVec6>& Y, int mode) {
        double off = 0.0, all = 0.0;
        for (const auto& h : X.headings)
            for (const auto& other : Y.headings) {
                if (std::abs(std::remainder(h.heading - other.heading, 2 * M_PI)) > 1e-6) continue;
                for (std::size_t f = 0; f < X.frequencies.size(); ++f)
                    if (const auto at = place(Y.frequencies, X.frequencies[f])) {
                        off += std::abs(h.values[f][mode] - other.values[*at][mode]);
                        all += std::abs(h.values[f][mode]);
                    }
            }
        return all > 0.0 ? off / all : 0.0;
    }

    void parts() {
        const auto compare = [&](const WaveTable<CVec6>& with, const char* what, const char* name,
                                 double limit) {
            double worst = 0.0;
            int mode = 0;
            for (const int i : {0, 2, 4})
                if (const double e = difference(d_.excitation, with, i); e > worst) {
                    worst = e;
                    mode = i;
                }
            add(worst > limit ? Verdict::doubtful : Verdict::fine, About::excitation, what,
                fmt::format("excitation and {} differ by {:.2g} % in {}", name, 100 * worst,
                            motion_names[static_cast<std::size_t>(mode)]));
        };
        if (!d_.haskind.empty()) compare(d_.haskind, ".2 and .3", "that of the .2", 0.1);
        if (d_.froude_krylov.empty() || d_.scattering.empty()) return;
        WaveTable<CVec6> sum = d_.froude_krylov;
        for (std::size_t h = 0; h < sum.headings.size() && h < d_.scattering.headings.size(); ++h)
            for (std::size_t f = 0; f < sum.frequencies.size(); ++f)
                sum.headings[h].values[f] += d_.scattering.headings[h].values[f];
        compare(sum, "parts", "the sum of its Froude-Krylov and scattering parts", 0.02);
    }

    /// In waves much longer than the hull it feels hydrostatics and the water's acceleration:
    ///     X_3 = C_33 - w^2 (rho V + A_33)       X_1 = i w^2 coth(kh) (rho V + A_11) cos b
    void long_waves() {
        const auto& X = d_.excitation;
        const double w = X.frequencies.front();
        const auto at = place(d_.frequencies, w);
        if (!at) return;
        const Mat6& A = d_.added_mass[*at];
        const double mass = d_.density * d_.displaced_volume;
        const double C33 = d_.buoyancy_stiffness ? (*d_.buoyancy_stiffness)(2, 2) : 0.0;
        if (const double inertia = w * w * (mass + A(2, 2)); C33 > 0.0 && inertia < 0.15 * C33) {
            const double ratio = X.headings.front().values.front()[2].real() / (C33 - inertia);
            const bool wrong = ratio < 0.2 || ratio > 5, odd = ratio < 0.8 || ratio > 1.25;
            add(wrong ? Verdict::wrong
                : odd ? Verdict::doubtful
                      : Verdict::fine,
                About::excitation, "long waves, heave",
                fmt::format("heave excitation at {:.4g} rad/s is {:.3g} of C33 less inertia{}", w,
                            ratio,
                            odd ? ", expected 1: excitation and hydrostatics are not of one hull, "
                                  "or ulen is wrong"
                                : ""));
        }
        // The direction of the surge force: a quarter of a period before the crest.
        std::size_t best = 0;
        for (std::size_t h = 0; h < X.headings.size(); ++h)
            if (std::abs(std::cos(X.headings[h].heading)) >
                std::abs(std::cos(X.headings[best].heading)) + 1e-9)
                best = h;
        const double c = std::cos(X.headings[best].heading), k = wave_number_of(d_, w);
        const double size =
            std::cbrt(d_.displaced_volume > 0.0 ? d_.displaced_volume : A(0, 0) / d_.density);
        const Complex X1 = X.headings[best].values.front()[0];
        if (std::abs(c) < 0.5 || !(k * size < 0.5) || std::abs(X1) == 0.0) return;
        const double phase = std::arg(X1 / c) / degree;
        const double expected =
            w * w / std::tanh(k * depth_of(d_)) * (mass + A(0, 0)) * std::abs(c);
        const std::string found = fmt::format(
            "surge excitation at {:.4g} rad/s, heading {:.4g} deg, leads the crest by {:.0f} deg",
            w, X.headings[best].heading / degree, std::arg(X1) / degree);
        if (std::abs(phase + 90) < 45)
            add(Verdict::wrong, About::excitation, "long waves, surge",
                found + fmt::format(", expected {:.0f}: the phases follow e^(-i w t), or headings "
                                    "say where waves come from",
                                    c > 0 ? 90.0 : -90.0));
        else
            add(std::abs(phase - 90) < 45 ? Verdict::fine : Verdict::doubtful, About::excitation,
                "long waves, surge",
                found + (std::abs(phase - 90) < 45
                             ? ", as it must"
                             : fmt::format(", expected {:.0f}; check phase_origin and "
                                           "reference_point",
                                           c > 0 ? 90.0 : -90.0)));
        if (d_.depth == 0.0 || d_.displaced_volume == 0.0) return;
        const double ratio = std::abs(X1) / expected;
        const bool odd = ratio < 0.5 || ratio > 2;
        add(odd ? Verdict::doubtful : Verdict::fine, About::excitation, "long waves, surge",
            fmt::format("surge excitation at {:.4g} rad/s is {:.3g} of the water's acceleration on "
                        "displaced and added mass{}",
                        w, ratio,
                        odd ? ", expected about 1; check ulen, rho and displaced_volume" : ""));
    }

    void haskind() {
        for (int i = 0; i < 6; ++i) {
            const std::optional<double> e = haskind_of(d_, i, false);
            if (!e || (i == 5 && is_round(d_))) continue;
            const std::string name(motion_names[static_cast<std::size_t>(i)]);
            std::string sentence =
                fmt::format("{} damping and excitation differ by {:.2g} % of Haskind's relation{}",
                            name, 100 * *e, d_.depth == 0.0 ? " for deep water" : "");
            Verdict verdict = *e > 0.1 ? Verdict::doubtful : Verdict::fine;
            if (*e > 0.5 && (i == 0 || i == 2)) {
                // In water of unknown depth only a gross misfit is proof.
                if (d_.depth > 0.0 || *e > 2) verdict = Verdict::wrong;
                const std::optional<double> inverted = haskind_of(d_, i, true);
                sentence += inverted && *inverted < 0.1
                                ? ": periods were read as frequencies, or frequencies as periods; "
                                  "check period_column"
                                : ": they are not of one run, or ulen is wrong, or periods were "
                                  "taken for frequencies";
            }
            add(verdict, About::excitation, "Haskind, " + name, sentence);
        }
    }

    void motion() {
        if (d_.motion.empty()) return;
        const double heave = std::abs(d_.motion.headings.front().values.front()[2]);
        const bool odd = std::abs(heave - 1) > 0.2;
        add(odd ? Verdict::doubtful : Verdict::fine, About::excitation, "motion",
            fmt::format("heave in the longest waves ({:.4g} rad/s) is {:.3g} of their height{}",
                        d_.motion.frequencies.front(), heave,
                        odd ? ", expected 1 for a hull that floats freely" : ""));
    }

    void second_order() {
        for (const auto& [qtf, name, conjugate] :
             {std::tuple{&d_.difference, "difference", true}, {&d_.sum, "sum", false}}) {
            if (qtf->empty()) continue;
            const std::size_t N = qtf->frequencies.size();
            double off = 0.0, most = 0.0;
            for (const QtfPair& p : qtf->pairs)
                for (const QtfPair& q : qtf->pairs) {
                    if (p.heading_1 != q.heading_2 || p.heading_2 != q.heading_1) continue;
                    for (std::size_t m = 0; m < N; ++m)
                        for (std::size_t n = 0; n < N; ++n) {
                            const Complex b = q.values[n * N + m][0];
                            off = std::max(off, std::abs(p.values[m * N + n][0] -
                                                         (conjugate ? std::conj(b) : b)));
                            most = std::max(most, std::abs(b));
                        }
                }
            const double e = most > 0.0 ? off / most : 0.0;
            add(e > 0.01 ? Verdict::doubtful : Verdict::fine, About::excitation,
                fmt::format("{}-frequency QTF", name),
                fmt::format("surge QTF of {} frequencies is {} symmetric within {:.2g} %", name,
                            conjugate ? "conjugate" : "", 100 * e));
        }
        diagonal();
    }

    /// Q(w, w, b, b) of differences is the mean drift.
    void diagonal() {
        if (d_.difference.empty() || d_.mean_drift.empty()) return;
        const Qtf& q = d_.difference;
        const std::size_t N = q.frequencies.size();
        for (const int mode : {0, 1}) {
            double off = 0.0, most = 0.0;
            for (const QtfPair& p : q.pairs)
                for (const auto& h : d_.mean_drift.headings) {
                    if (std::abs(std::remainder(p.heading_1 - h.heading, 2 * M_PI)) > 1e-6 ||
                        std::abs(std::remainder(p.heading_2 - h.heading, 2 * M_PI)) > 1e-6)
                        continue;
                    for (std::size_t m = 0; m < N; ++m)
                        if (const auto at = place(d_.mean_drift.frequencies, q.frequencies[m])) {
                            const double D = h.values[*at][mode];
                            off = std::max(off, std::abs(p.values[m * N + m][mode].real() - D));
                            most = std::max(most, std::abs(D));
                        }
                }
            if (most == 0.0) continue;
            add(off > 0.1 * most ? Verdict::doubtful : Verdict::fine, About::excitation,
                "QTF diagonal",
                fmt::format("{} mean drift and the diagonal of the difference QTF differ by {:.2g} "
                            "% of the largest",
                            motion_names[static_cast<std::size_t>(mode)], 100 * off / most));
        }
    }

    const HydroData& d_;
    std::vector<HydroCheck> list_;
};
}  // namespace

std::vector<HydroCheck> check_hydro(const HydroData& data) { return Checks(data).run(); }

std::optional<double> haskind_misfit(const HydroData& data) {
    std::optional<double> worst;
    for (const int mode : {0, 2})
        if (const auto e = haskind_of(data, mode, false)) worst = std::max(worst.value_or(0.0), *e);
    return worst;
}

}  // namespace hawser
