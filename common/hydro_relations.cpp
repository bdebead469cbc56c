#include "hydro_relations.hpp"

#include <algorithm>
#include <cmath>

#include "environment/dispersion.hpp"

namespace hawser {

namespace {
constexpr double turn = 2.0 * M_PI;
constexpr double deep = 1e6;  // [m], deeper than any wave sees

double finite(double depth) { return depth > 0.0 && depth < deep ? depth : deep; }

/// One heading and its share of the turn.
struct Heading {
    const std::vector<CVec6>* values;
    double share = 0.0;     ///< [rad]
    double rotation = 0.0;  ///< the values are those of a wave turned by this [rad]
};

/// Forces of a round hull in a wave turned by `angle`.
CVec6 rotated(const CVec6& X, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    CVec6 Y = X;
    for (const int i : {0, 3}) {
        Y[i] = c * X[i] - s * X[i + 1];
        Y[i + 1] = s * X[i] + c * X[i + 1];
    }
    return Y;
}

bool round_by_added_mass(const HydroData& d) {
    double off = 0.0, all = 0.0;
    for (const Mat6& A : d.added_mass) {
        off += std::abs(A(0, 0) - A(1, 1)) + std::abs(A(0, 1));
        all += std::abs(A(0, 0));
    }
    return off < 0.01 * all;
}

/// Every heading is the first one, turned.
bool round_by_excitation(const WaveTable<CVec6>& table) {
    const auto& first = table.headings.front();
    for (const auto& h : table.headings)
        for (std::size_t f = 0; f < table.frequencies.size(); ++f) {
            const CVec6 X = rotated(first.values[f], h.heading - first.heading);
            if ((X - h.values[f]).head<3>().norm() > 0.01 * X.head<3>().norm()) return false;
        }
    return true;
}

/// The headings that stand for a full turn; empty if they do not.
std::vector<Heading> full_turn(const HydroData& d, HaskindDamping& out) {
    const auto& all = d.excitation.headings;
    std::vector<Heading> list;
    if (d.excitation.full_circle) {
        for (std::size_t h = 0; h < all.size(); ++h) {
            const double before = h > 0 ? all[h - 1].heading : all.back().heading - turn;
            const double after = h + 1 < all.size() ? all[h + 1].heading : all[0].heading + turn;
            list.push_back({&all[h].values, (after - before) / 2});
        }
        return list;
    }
    if (!round_by_added_mass(d) || !round_by_excitation(d.excitation)) return list;
    out.by_roundness = true;
    out.by_one_heading = all.size() == 1;
    for (int n = 0; n < 4; ++n) list.push_back({&all.front().values, turn / 4, n * turn / 4});
    return list;
}
}  // namespace

double hull_size(const HydroData& d) {
    double size = std::cbrt(std::max(0.0, d.displaced_volume));
    const Mat3& C = d.waterplane_stiffness;
    // A disc of radius r: second moments sum to area r^2 / 2.
    if (C(0, 0) > 0.0 && d.displaced_volume > 0.0)
        size = std::max(size, 2 * std::sqrt(2 * std::max(0.0, C(1, 1) + C(2, 2)) / C(0, 0)));
    // Without a volume C44 and C55 cannot be taken apart; C33 is the area alone: of a disc.
    if (d.displaced_volume == 0.0 && d.buoyancy_stiffness)
        size = 2 * std::sqrt(std::max(0.0, (*d.buoyancy_stiffness)(2, 2)) /
                             (M_PI * d.density * d.gravity));
    return size;
}

double wavelength(const HydroData& d, double omega, double depth) {
    return turn / wave_number(omega, finite(depth), d.gravity);
}

std::optional<std::size_t> place_of(const std::vector<double>& frequencies, double omega) {
    const auto at = std::lower_bound(frequencies.begin(), frequencies.end(), omega * (1 - 1e-5));
    if (at == frequencies.end() || std::abs(*at - omega) > 1e-5 * omega) return std::nullopt;
    return static_cast<std::size_t>(at - frequencies.begin());
}

CMat6 HaskindDamping::damping(const HydroData& d, std::size_t i, double depth) const {
    const double w = d.frequencies[at[i]], h = finite(depth);
    const double k = wave_number(w, h, d.gravity), kh2 = 2 * k * h;
    const double c_g = w / (2 * k) * (1 + (kh2 < 50 ? kh2 / std::sinh(kh2) : 0.0));
    return k / (8 * M_PI * d.density * d.gravity * c_g) * integral[i];
}

std::optional<HaskindDamping> haskind_damping(const HydroData& d) {
    if (d.excitation.empty() || d.frequencies.empty()) return std::nullopt;
    HaskindDamping out;
    const std::vector<Heading> headings = full_turn(d, out);
    if (headings.empty()) return std::nullopt;
    for (std::size_t f = 0; f < d.excitation.frequencies.size(); ++f) {
        const auto at = place_of(d.frequencies, d.excitation.frequencies[f]);
        if (!at) continue;
        CMat6 sum = CMat6::Zero();
        for (const Heading& h : headings) {
            const CVec6 X = rotated((*h.values)[f], h.rotation);
            sum += h.share * X * X.adjoint();
        }
        out.at.push_back(*at);
        out.integral.push_back(sum);
    }
    if (out.at.empty()) return std::nullopt;
    return out;
}

std::vector<double> infinite_by_ogilvie(const HydroData& d, int mode) {
    const std::vector<double>& u = d.frequencies;
    const std::size_t N = u.size();
    const auto B = [&](std::size_t i) { return d.damping[i](mode, mode); };
    std::vector<double> all;
    for (std::size_t f = 0; f < N; ++f) {
        const double w = u[f];
        // ln |(u - w)/(u + w)| and ln |u^2 - w^2|; their poles at u = w cancel between neighbours.
        const auto L1 = [&](double x) {
            return x == w ? -std::log(2 * w) : std::log(std::abs(x - w) / (x + w));
        };
        const auto L2 = [&](double x) {
            return x == w ? std::log(2 * w) : std::log(std::abs(x * x - w * w));
        };
        double integral = 0.0;
        for (std::size_t i = 0; i <= N - 1; ++i) {  // from 0, where B is zero
            const double a = i == 0 ? 0.0 : u[i - 1], b = u[i];
            const double Ba = i == 0 ? 0.0 : B(i - 1), slope = (B(i) - Ba) / (b - a);
            integral += (Ba - slope * a) / (2 * w) * (L1(b) - L1(a)) + slope / 2 * (L2(b) - L2(a));
        }
        const double q = w * w / (u.back() * u.back());
        integral += f + 1 < N ? B(N - 1) * std::pow(u.back(), 3) / (2 * std::pow(w, 4)) *
                                    (-std::log1p(-q) - q)
                              : B(N - 1) / (2 * w) * (std::log(w / 2) - 1);
        all.push_back(d.added_mass[f](mode, mode) - 2 / M_PI * integral);
    }
    return all;
}

}  // namespace hawser
