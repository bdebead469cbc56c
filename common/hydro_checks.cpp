#include "hydro_checks.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "hydro_relations.hpp"
#include "motion_names.hpp"

namespace hawser {

namespace {
using Verdict = HydroCheck::Verdict;
using About = HydroCheck::About;
constexpr double degree = M_PI / 180.0;

std::string name_of(int mode) { return std::string(motion_names[static_cast<std::size_t>(mode)]); }

Verdict judged(double x, double doubtful, double wrong) {
    return x > wrong ? Verdict::wrong : x > doubtful ? Verdict::doubtful : Verdict::fine;
}
constexpr double never = std::numeric_limits<double>::infinity();

/// Waves longer than half the hull: shorter ones move it little, panels are coarse for them, and
/// irregular frequencies lie there.
bool is_long(const HydroData& d, double w) {
    const double size = hull_size(d);
    return size == 0.0 || wavelength(d, w, d.depth) > size / 2;
}
/// Which of these frequencies are of long waves; all of them if hardly any is.
std::vector<char> long_ones(const HydroData& d, const std::vector<double>& frequencies) {
    std::vector<char> list;
    list.reserve(frequencies.size());
    for (const double w : frequencies) list.push_back(is_long(d, w) ? 1 : 0);
    if (std::count(list.begin(), list.end(), 1) < 3) list.assign(list.size(), 1);
    return list;
}

/// sum |B_ij - H_ij| over sum sqrt(B_ii B_jj), of long or of short waves, and where it is largest.
struct Misfit {
    double size = 0.0, frequency = 0.0, by_haskind = 0.0, in_file = 0.0;
    bool known = false;
};
Misfit misfit(const HydroData& d, const HaskindDamping& haskind, double depth, int i, int j,
              bool in_long) {
    const std::vector<char> is = long_ones(d, d.frequencies);
    double off = 0.0, all = 0.0, worst = 0.0;
    Misfit m;
    for (std::size_t n = 0; n < haskind.at.size(); ++n) {
        const std::size_t f = haskind.at[n];
        if ((is[f] != 0) != in_long) continue;
        const Mat6& B = d.damping[f];
        const CMat6 H = haskind.damping(d, n, depth);
        // The real part is the damping; of an imaginary part there must be none.
        const double e = std::abs(H(i, j) - B(i, j));
        off += e;
        all += i == j ? std::abs(B(i, i)) : std::sqrt(std::abs(B(i, i) * B(j, j)));
        if (e <= worst) continue;
        worst = e;
        m.frequency = d.frequencies[f];
        m.by_haskind = H(i, j).real();
        m.in_file = B(i, j);
    }
    m.known = all > 0.0;
    if (m.known) m.size = off / all;
    return m;
}

/// The set as it would be had periods and frequencies been exchanged on reading.
HydroData exchanged(const HydroData& d) {
    HydroData other;
    other.density = d.density;
    other.gravity = d.gravity;
    other.depth = d.depth;
    other.displaced_volume = d.displaced_volume;
    other.waterplane_stiffness = d.waterplane_stiffness;
    for (std::size_t f = d.frequencies.size(); f-- > 0;) {
        const double w = d.frequencies[f], to = 2 * M_PI / w;
        other.frequencies.push_back(to);
        other.added_mass.push_back(d.added_mass[f]);
        other.damping.push_back(d.damping[f] * (to / w));  // files hold B over w
    }
    other.excitation = d.excitation;
    for (double& w : other.excitation.frequencies) w = 2 * M_PI / w;
    std::reverse(other.excitation.frequencies.begin(), other.excitation.frequencies.end());
    for (auto& h : other.excitation.headings) std::reverse(h.values.begin(), h.values.end());
    return other;
}

class Checks {
 public:
    explicit Checks(const HydroData& data)
        : d_(data), long_(long_ones(data, data.frequencies)), haskind_(haskind_damping(data)) {}

    std::vector<HydroCheck> run() {
        if (!d_.frequencies.empty()) {
            symmetry();
            damping();
            definite();
            size_of_added_mass();
            limits();
        }
        stiffness();
        if (!d_.excitation.empty()) {
            parts();
            deep_ = belongs_to_another_depth();
            long_waves();
            haskind();
        }
        motion();
        drift();
        second_order();
        return std::move(list_);
    }

 private:
    HydroCheck& add(Verdict verdict, About about, std::string what, std::string sentence,
                    std::optional<double> size = std::nullopt) {
        list_.push_back({verdict, about, std::move(what), std::move(sentence), 0.0, -1, size});
        return list_.back();
    }

    /// Largest diagonal terms. A rotation that hardly moves water (of a sphere, or yaw of a spar)
    /// is measured by what its moments could be, for it has none but rounding.
    [[nodiscard]] Vec6 largest(const std::vector<Mat6>& matrices) const {
        Vec6 most = Vec6::Zero();
        for (const Mat6& M : matrices) most = most.cwiseMax(M.diagonal().cwiseAbs());
        const double floor = 1e-4 * most.head<3>().maxCoeff() * std::pow(hull_size(d_), 2);
        for (int i = 3; i < 6; ++i) most[i] = std::max(most[i], floor);
        return most;
    }

    void symmetry() {
        for (const auto& [matrices, name] :
             {std::pair{&d_.added_mass, "added mass"}, {&d_.damping, "damping"}})
            for (const bool in_long : {true, false}) {
                // |M_ij - M_ji| as a part of sqrt(M_ii M_jj), each at its largest.
                const Vec6 most = largest(*matrices);
                double worst = 0.0, where = 0.0;
                int row = 0, column = 0;
                for (std::size_t f = 0; f < matrices->size(); ++f) {
                    if ((long_[f] != 0) != in_long) continue;
                    for (int i = 0; i < 6; ++i)
                        for (int j = 0; j < i; ++j) {
                            const double scale = std::sqrt(most[i] * most[j]);
                            const double e =
                                std::abs((*matrices)[f](i, j) - (*matrices)[f](j, i)) / scale;
                            if (!(scale > 0.0) || e <= worst) continue;
                            worst = e;
                            where = d_.frequencies[f];
                            row = j + 1;
                            column = i + 1;
                        }
                }
                if (!in_long && worst < 0.05) continue;
                const Verdict verdict = in_long ? judged(worst, 0.05, 0.5) : Verdict::remark;
                const bool good = verdict == Verdict::fine;
                HydroCheck& check = add(
                    verdict, About::radiation, "symmetry",
                    good ? fmt::format("{} is symmetric within {:.2g} %", name, 100 * worst)
                         : fmt::format("{} is not symmetric, by {:.2g} % (terms {}{} and {}{} at "
                                       "{:.4g} rad/s{})",
                                       name, 100 * worst, row, column, column, row, where,
                                       in_long ? "" : ", in waves shorter than half the hull"),
                    worst);
                if (!good) check.frequency = where;
            }
    }

    void damping() {
        bool fine = true;
        const Vec6 scale = largest(d_.damping);
        for (int i = 0; i < 6; ++i) {
            const double most = scale[i];
            for (const bool in_long : {true, false}) {
                double worst = 0.0, where = 0.0, wA = 0.0;
                for (std::size_t f = 0; f < d_.damping.size(); ++f) {
                    const double B = d_.damping[f](i, i), w = d_.frequencies[f];
                    const double of_mass = w * std::abs(d_.added_mass[f](i, i));
                    if ((long_[f] != 0) != in_long || B >= -1e-3 * of_mass || B >= -1e-3 * most ||
                        B >= worst)
                        continue;
                    worst = B;
                    where = w;
                    wA = of_mass;
                }
                if (worst == 0.0) continue;
                fine = false;
                const bool wrong = worst < -(in_long ? 0.05 : 0.2) * most && worst < -0.02 * wA;
                HydroCheck& check =
                    add(wrong     ? Verdict::wrong
                        : in_long ? Verdict::doubtful
                                  : Verdict::remark,
                        About::radiation, "damping",
                        fmt::format("damping of mode {} is negative at {:.4g} rad/s ({:.3g}, with "
                                    "{:.3g} at most){}",
                                    i + 1, where, worst, most,
                                    wrong     ? ": the hull would feed itself from the sea"
                                    : in_long ? ""
                                              : ", in waves shorter than half the hull"),
                        -worst / most);
                check.frequency = where;
                check.mode = i;
            }
        }
        if (fine)
            add(Verdict::fine, About::radiation, "damping",
                "damping is nowhere negative beyond 0.1 % of its largest");
    }

    /// No motion may take work from the water: B has no negative direction.
    void definite() {
        const Vec6 scale = largest(d_.damping);
        double worst = 0.0, most = 0.0, where = 0.0;
        for (std::size_t f = 0; f < d_.damping.size(); ++f) {
            if (long_[f] == 0) continue;
            Mat6 M = Mat6::Zero();
            for (int i = 0; i < 6; ++i)
                for (int j = 0; j < 6; ++j)
                    if (scale[i] > 0.0 && scale[j] > 0.0)
                        M(i, j) = (d_.damping[f](i, j) + d_.damping[f](j, i)) / 2 /
                                  std::sqrt(scale[i] * scale[j]);
            const Eigen::SelfAdjointEigenSolver<Mat6> solver(M, Eigen::EigenvaluesOnly);
            most = std::max(most, solver.eigenvalues()[5]);
            if (solver.eigenvalues()[0] >= worst) continue;
            worst = solver.eigenvalues()[0];
            where = d_.frequencies[f];
        }
        if (most == 0.0) return;
        const double e = -worst / most;
        HydroCheck& check =
            add(judged(e, 0.02, 0.2), About::radiation, "work",
                e > 0.02 ? fmt::format("some motion would take work from the sea: the damping "
                                       "matrix at {:.4g} rad/s has a negative direction, {:.2g} % "
                                       "of its largest",
                                       where, 100 * e)
                         : fmt::format("damping takes work from every motion (lowest eigenvalue "
                                       "{:.2g} % of the largest)",
                                       100 * worst / most),
                e);
        if (e > 0.02) check.frequency = where;
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

    /// Damping and added mass are transforms of one another (Ogilvie); the limits with them.
    void limits() {
        for (int i = 0; i < 6; ++i) {
            double most = 0.0, low = never, high = -never;
            for (std::size_t f = 0; f < d_.frequencies.size(); ++f) {
                most = std::max(most, d_.damping[f](i, i));
                low = std::min(low, d_.added_mass[f](i, i));
                high = std::max(high, d_.added_mass[f](i, i));
            }
            const double range = high - low;
            // A dozen frequencies at least, up to where the damping has come down.
            if (d_.frequencies.size() < 12 || most <= 0.0 || range < 0.02 * std::abs(high) ||
                std::abs(d_.damping.back()(i, i)) > 0.5 * most)
                continue;
            const std::vector<double> told = infinite_by_ogilvie(d_, i);
            std::vector<double> inside;
            for (std::size_t f = 0; f < told.size(); ++f)
                if (d_.frequencies[f] < 0.7 * d_.frequencies.back()) inside.push_back(told[f]);
            if (inside.size() < 4) continue;
            std::vector<double> sorted = inside;
            std::nth_element(sorted.begin(), sorted.begin() + std::ssize(sorted) / 2, sorted.end());
            const double median = sorted[sorted.size() / 2];
            double off = 0.0;
            for (const double a : inside) off += std::abs(a - median);
            off /= static_cast<double>(inside.size()) * range;
            const std::string name = name_of(i);
            add(judged(off, 0.1, never), About::radiation, "Ogilvie, " + name,
                fmt::format("{} damping and added mass are transforms of one another within {:.2g} "
                            "% of the range of added mass{}",
                            name, 100 * off,
                            off > 0.1 ? ": frequencies lie too far apart or end too early, or "
                                        "they are not of one run"
                                      : ""),
                off)
                .mode = i;
            if (!d_.added_mass_inf) continue;
            const double stated = (*d_.added_mass_inf)(i, i), e = std::abs(stated - median) / range;
            const bool swapped = d_.added_mass_0 && e > 0.3 &&
                                 std::abs((*d_.added_mass_0)(i, i) - median) < 0.3 * e * range;
            add(swapped ? Verdict::wrong : judged(e, 0.2, never), About::radiation,
                "A(inf), " + name,
                fmt::format("{} added mass at infinite frequency is {:.5g}, by Ogilvie's relation "
                            "{:.5g}{}",
                            name, stated, median,
                            swapped ? ": the limits of zero and infinite frequency are exchanged; "
                                      "check limits"
                                    : ""),
                e)
                .mode = i;
        }
    }

    void stiffness() {
        if (!d_.buoyancy_stiffness || d_.displaced_volume == 0.0) return;
        const double rho_g = d_.density * d_.gravity;
        const double area = (*d_.buoyancy_stiffness)(2, 2) / rho_g;
        // Of all waterplanes of one area the disc has the least polar moment, A^2/(2 pi).
        const double polar =
            (d_.waterplane_stiffness(1, 1) + d_.waterplane_stiffness(2, 2)) / rho_g;
        if (area < 0.0 || polar < 0.9 * area * area / (2 * M_PI)) {
            add(Verdict::wrong, About::stiffness, "waterplane",
                fmt::format("C33 means a waterplane of {:.5g} m2, whose second moments sum to at "
                            "least {:.5g} m4; C44 + C55 without buoyancy leave {:.5g} m4. Check "
                            "ulen, displaced_volume, centre_of_buoyancy and includes_weight",
                            area, area * area / (2 * M_PI), polar));
            return;
        }
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
                    if (const auto at = place_of(Y.frequencies, X.frequencies[f])) {
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
            add(judged(worst, limit, 1.0), About::excitation, what,
                fmt::format("excitation and {} differ by {:.2g} % in {}", name, 100 * worst,
                            name_of(mode)),
                worst);
        };
        if (!d_.haskind.empty()) compare(d_.haskind, ".2 and .3", "that of the .2", 0.1);
        if (d_.froude_krylov.empty() || d_.scattering.empty()) return;
        WaveTable<CVec6> sum = d_.froude_krylov;
        for (std::size_t h = 0; h < sum.headings.size() && h < d_.scattering.headings.size(); ++h)
            for (std::size_t f = 0; f < sum.frequencies.size(); ++f)
                sum.headings[h].values[f] += d_.scattering.headings[h].values[f];
        compare(sum, "parts", "the sum of its Froude-Krylov and scattering parts", 0.02);
    }

    /// Mean of |ln B_ii / H_ii| over the long waves, surge and heave: at low frequencies, where
    /// there is little damping, it counts as much as anywhere.
    [[nodiscard]] double misfit_by_ratio(double depth) const {
        double sum = 0.0;
        int n = 0;
        for (std::size_t i = 0; i < haskind_->at.size(); ++i) {
            if (long_[haskind_->at[i]] == 0) continue;
            const CMat6 H = haskind_->damping(d_, i, depth);
            for (const int mode : {0, 2}) {
                const double B = d_.damping[haskind_->at[i]](mode, mode), X = H(mode, mode).real();
                if (!(B > 0.0) || !(X > 0.0)) continue;
                sum += std::min(3.0, std::abs(std::log(B / X)));
                ++n;
            }
        }
        return n > 0 ? sum / n : 0.0;
    }

    /// Haskind's relation holds at the depth of the computation and at no other.
    /// @return true if that is infinite depth and not the stated one
    bool belongs_to_another_depth() {
        if (!haskind_ || haskind_->at.size() < 4) return false;
        const double here = misfit_by_ratio(d_.depth);
        if (here < 0.02) return false;
        double best = misfit_by_ratio(0.0), depth = 0.0;
        const double size = std::max(1.0, hull_size(d_));
        for (int n = 0; n < 80; ++n) {
            const double h = 0.1 * size * std::pow(10.0, 0.05 * n);
            if (const double e = misfit_by_ratio(h); e < 0.9 * best) {
                best = e;
                depth = h;
            }
        }
        if (best > 0.25 * here) return false;
        another_depth_ = true;
        const std::string is = depth == 0.0 ? "infinite" : fmt::format("about {:.2g} m", depth);
        add(d_.depth > 0.0 ? Verdict::doubtful : Verdict::remark, About::excitation, "depth",
            fmt::format(
                "damping and excitation belong together in water of {} depth (within {:.2g} "
                "%), not of {} (within {:.2g} %)",
                is, 100 * best,
                d_.depth == 0.0 || std::isinf(d_.depth) ? std::string("infinite depth")
                                                        : fmt::format("{:g} m", d_.depth),
                100 * here),
            here);
        return depth == 0.0;
    }

    /// In waves much longer than the hull it feels hydrostatics and the water's acceleration:
    ///     X_3 = C_33 - w^2 (rho V + A_33)       X_1 = i w^2 coth(kh) (rho V + A_11) cos b
    void long_waves() {
        const auto& X = d_.excitation;
        const double w = X.frequencies.front();
        const auto at = place_of(d_.frequencies, w);
        if (!at) return;
        const Mat6& A = d_.added_mass[*at];
        const double mass = d_.density * d_.displaced_volume;
        const double C33 = d_.buoyancy_stiffness ? (*d_.buoyancy_stiffness)(2, 2) : 0.0;
        if (const double inertia = w * w * (mass + A(2, 2)); C33 > 0.0 && inertia < 0.15 * C33) {
            const double ratio = X.headings.front().values.front()[2].real() / (C33 - inertia);
            const bool wrong = ratio < 0.2 || ratio > 5, odd = ratio < 0.8 || ratio > 1.25;
            place(add(wrong ? Verdict::wrong
                      : odd ? Verdict::doubtful
                            : Verdict::fine,
                      About::excitation, "long waves, heave",
                      fmt::format("heave excitation at {:.4g} rad/s is {:.3g} of C33 less "
                                  "inertia{}",
                                  w, ratio,
                                  odd ? ", expected 1: excitation and hydrostatics are not of one "
                                        "hull, or ulen is wrong"
                                      : ""),
                      std::abs(ratio - 1)),
                  w, 2);
        }
        // The direction of the surge force: a quarter of a period before the crest.
        std::size_t best = 0;
        for (std::size_t h = 0; h < X.headings.size(); ++h)
            if (std::abs(std::cos(X.headings[h].heading)) >
                std::abs(std::cos(X.headings[best].heading)) + 1e-9)
                best = h;
        const double c = std::cos(X.headings[best].heading);
        const double k = 2 * M_PI / wavelength(d_, w, d_.depth);
        const double size =
            std::cbrt(d_.displaced_volume > 0.0 ? d_.displaced_volume : A(0, 0) / d_.density);
        const Complex X1 = X.headings[best].values.front()[0];
        if (std::abs(c) < 0.5 || !(k * size < 0.5) || std::abs(X1) == 0.0) return;
        const double phase = std::arg(X1 / c) / degree;
        const std::string found = fmt::format(
            "surge excitation at {:.4g} rad/s, heading {:.4g} deg, leads the crest by {:.0f} deg",
            w, X.headings[best].heading / degree, std::arg(X1) / degree);
        const std::string expected = fmt::format(", expected {:.0f}", c > 0 ? 90.0 : -90.0);
        if (std::abs(phase + 90) < 45)
            place(add(Verdict::wrong, About::excitation, "long waves, phase",
                      found + expected +
                          ": the phases follow e^(-i w t), or headings say where waves come from",
                      std::abs(phase - 90) / 180),
                  w, 0);
        else
            place(add(std::abs(phase - 90) < 45 ? Verdict::fine : Verdict::doubtful,
                      About::excitation, "long waves, phase",
                      found + (std::abs(phase - 90) < 45
                                   ? ", as it must"
                                   : expected + "; check phase_origin and reference_point"),
                      std::abs(phase - 90) / 180),
                  w, 0);
        if (d_.depth == 0.0 || d_.displaced_volume == 0.0) return;
        const double kh = deep_ || std::isinf(d_.depth) ? 1e3 : k * d_.depth;
        const double ratio =
            std::abs(X1) / (w * w / std::tanh(kh) * (mass + A(0, 0)) * std::abs(c));
        const bool odd = ratio < 0.5 || ratio > 2;
        place(
            add(odd ? Verdict::doubtful : Verdict::fine, About::excitation, "long waves, surge",
                fmt::format("surge excitation at {:.4g} rad/s is {:.3g} of the water's "
                            "acceleration on displaced and added mass{}",
                            w, ratio,
                            odd ? ", expected about 1; check ulen, rho and displaced_volume" : ""),
                std::abs(ratio - 1)),
            w, 0);
    }

    static void place(HydroCheck& check, double frequency, int mode) {
        check.frequency = frequency;
        check.mode = mode;
    }

    void haskind() {
        if (!haskind_) {
            add(Verdict::remark, About::excitation, "Haskind",
                "headings do not make a full turn, so damping and excitation cannot be compared; "
                "state the symmetry of the hull if it has one");
            return;
        }
        const double depth = deep_ ? 0.0 : d_.depth;
        const Vec6 scale = largest(d_.damping);
        Vec6 most = Vec6::Zero();
        for (const Mat6& B : d_.damping) most = most.cwiseMax(B.diagonal().cwiseAbs());
        for (int i = 0; i < 6; ++i) {
            const Misfit m = misfit(d_, *haskind_, depth, i, i, true);
            if (!m.known || most[i] < 0.1 * scale[i]) continue;
            std::string sentence =
                fmt::format("{} damping and excitation differ by {:.2g} % of Haskind's relation{}",
                            name_of(i), 100 * m.size,
                            d_.depth == 0.0            ? " for deep water"
                            : another_depth_           ? " (see depth)"
                            : haskind_->by_one_heading ? ", taken for a round hull"
                                                       : "");
            Verdict verdict = m.size > 0.1 ? Verdict::doubtful : Verdict::fine;
            if (another_depth_ && verdict == Verdict::doubtful) verdict = Verdict::remark;
            if (m.size > 0.5 && (i == 0 || i == 2)) {
                // In water of unknown depth, or with one heading, only a gross misfit is proof.
                const bool sure = d_.depth > 0.0 && !haskind_->by_one_heading;
                if (!another_depth_ && (sure || m.size > 2)) verdict = Verdict::wrong;
                sentence += would_fit_exchanged()
                                ? ": periods were read as frequencies, or frequencies as periods; "
                                  "check period_column"
                                : ": they are not of one run, or ulen is wrong, or periods were "
                                  "taken for frequencies";
            }
            place(add(verdict, About::excitation, "Haskind, " + name_of(i), sentence, m.size),
                  verdict == Verdict::fine ? 0.0 : m.frequency, i);
            short_waves(i);
        }
        for (const auto& [i, j] : {std::pair{0, 4}, {1, 3}, {0, 2}, {2, 4}, {1, 5}, {3, 5}}) {
            const Misfit m = misfit(d_, *haskind_, depth, i, j, true);
            if (!m.known || haskind_->by_one_heading || !couples(i, j)) continue;
            if (most[i] < 0.1 * scale[i] || most[j] < 0.1 * scale[j]) continue;
            const Verdict verdict = another_depth_ ? Verdict::remark : judged(m.size, 0.1, 0.5);
            place(
                add(verdict, About::excitation,
                    fmt::format("Haskind, {} and {}", name_of(i), name_of(j)),
                    fmt::format("B{}{} and the phases of {} and {} excitation agree within {:.2g} "
                                "%{}",
                                i + 1, j + 1, name_of(i), name_of(j), 100 * m.size,
                                m.size > 0.1
                                    ? fmt::format(": at {:.4g} rad/s it is {:.4g}, by the "
                                                  "excitation {:.4g}; these phases do not belong "
                                                  "to this damping",
                                                  m.frequency, m.in_file, m.by_haskind)
                                    : std::string()),
                    m.size),
                verdict == Verdict::fine ? 0.0 : m.frequency, i);
        }
    }

    /// Does one of two motions push the hull in the other, by damping or by the excitation?
    [[nodiscard]] bool couples(int i, int j) const {
        for (std::size_t n = 0; n < haskind_->at.size(); ++n) {
            const Mat6& B = d_.damping[haskind_->at[n]];
            const CMat6& X = haskind_->integral[n];
            if (std::abs(B(i, j)) > 1e-4 * std::sqrt(std::abs(B(i, i) * B(j, j))) ||
                std::abs(X(i, j)) > 1e-4 * std::sqrt(std::abs(X(i, i) * X(j, j))))
                return true;
        }
        return false;
    }

    void short_waves(int mode) {
        const Misfit m = misfit(d_, *haskind_, d_.depth, mode, mode, false);
        if (!m.known || m.size < 0.1) return;
        add(Verdict::remark, About::excitation, "Haskind, short waves",
            fmt::format("in waves shorter than half the hull {} damping and excitation differ by "
                        "{:.2g} %: coarse panels or headings, or irregular frequencies",
                        name_of(mode), 100 * m.size),
            m.size);
    }

    [[nodiscard]] bool would_fit_exchanged() const {
        const std::optional<double> other = haskind_misfit(exchanged(d_));
        return other && *other < 0.1;
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

    /// A hull that takes no work from the waves is pushed the way they go.
    void drift() {
        if (d_.mean_drift.empty()) return;
        double most = 0.0, against = 0.0, where = 0.0;
        for (const auto& h : d_.mean_drift.headings)
            for (std::size_t f = 0; f < d_.mean_drift.frequencies.size(); ++f) {
                const double w = d_.mean_drift.frequencies[f];
                const double push =
                    h.values[f][0] * std::cos(h.heading) + h.values[f][1] * std::sin(h.heading);
                most = std::max(most, std::abs(push));
                if (!is_long(d_, w) || push >= against) continue;
                against = push;
                where = w;
            }
        if (most == 0.0) return;
        const double e = -against / most;
        place(add(judged(e, 0.1, 0.9), About::drift, "drift",
                  e > 0.1 ? fmt::format("mean drift at {:.4g} rad/s pushes against the waves, by "
                                        "{:.2g} % of the largest; check the headings",
                                        where, 100 * e)
                          : "mean drift pushes the way the waves go",
                  std::max(0.0, e)),
              e > 0.1 ? where : 0.0, 0);
        for (const MeanDrift& other : d_.other_drift) {
            double off = 0.0, all = 0.0;
            for (const auto& h : d_.mean_drift.headings)
                for (const auto& b : other.table.headings) {
                    if (std::abs(std::remainder(h.heading - b.heading, 2 * M_PI)) > 1e-6) continue;
                    for (std::size_t f = 0; f < d_.mean_drift.frequencies.size(); ++f) {
                        const double w = d_.mean_drift.frequencies[f];
                        const auto at = place_of(other.table.frequencies, w);
                        if (!at || !is_long(d_, w)) continue;
                        off += (h.values[f] - b.values[*at]).head<2>().norm();
                        all += h.values[f].head<2>().norm();
                    }
                }
            if (all == 0.0) continue;
            const bool acts = d_.drift_method != DriftMethod::momentum;
            add(off < 0.25 * all ? Verdict::fine
                : acts           ? Verdict::doubtful
                                 : Verdict::remark,
                About::drift, "drift by two methods",
                fmt::format("horizontal mean drift by {} and by {} differ by {:.2g} %{}",
                            name_of_method(d_.drift_method), name_of_method(other.method),
                            100 * off / all,
                            off > 0.25 * all ? "; pressures need the finer panels" : ""),
                off / all);
        }
    }
    static const char* name_of_method(DriftMethod method) {
        return method == DriftMethod::momentum   ? "momentum"
               : method == DriftMethod::pressure ? "pressure"
                                                 : "control surface";
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
            add(judged(e, 0.01, never), About::second_order, fmt::format("{}-frequency QTF", name),
                fmt::format("surge QTF of {} frequencies is {}symmetric within {:.2g} %", name,
                            conjugate ? "conjugate " : "", 100 * e),
                e);
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
                        if (const auto at = place_of(d_.mean_drift.frequencies, q.frequencies[m])) {
                            const double D = h.values[*at][mode];
                            off = std::max(off, std::abs(p.values[m * N + m][mode].real() - D));
                            most = std::max(most, std::abs(D));
                        }
                }
            if (most == 0.0) continue;
            add(judged(off / most, 0.1, never), About::second_order, "QTF diagonal",
                fmt::format("{} mean drift and the diagonal of the difference QTF differ by {:.2g} "
                            "% of the largest",
                            name_of(mode), 100 * off / most),
                off / most);
        }
    }

    const HydroData& d_;
    std::vector<char> long_;  ///< by frequency of the radiation
    std::optional<HaskindDamping> haskind_;
    bool another_depth_ = false, deep_ = false;
    std::vector<HydroCheck> list_;
};
}  // namespace

std::vector<HydroCheck> check_hydro(const HydroData& data) { return Checks(data).run(); }

std::optional<double> haskind_misfit(const HydroData& data) {
    const std::optional<HaskindDamping> haskind = haskind_damping(data);
    if (!haskind) return std::nullopt;
    std::optional<double> worst;
    for (const int mode : {0, 2})
        if (const Misfit m = misfit(data, *haskind, data.depth, mode, mode, true); m.known)
            worst = std::max(worst.value_or(0.0), m.size);
    return worst;
}

}  // namespace hawser
