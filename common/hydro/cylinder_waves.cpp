#include "hydro/cylinder_waves.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "hydro/bessel.hpp"

namespace hawser::hydro {
namespace {

constexpr Complex I{0.0, 1.0};

/// Bessel's functions at kR and their derivatives by the argument.
struct Cylinder {
    std::vector<double> J, Y;
    double x;
    Cylinder(double kR, int orders) : J(static_cast<std::size_t>(orders) + 2), Y(J.size()), x(kR) {
        bessel_jy(kR, J, Y);
    }
    [[nodiscard]] double dJ(int m) const { return slope(J, m); }
    [[nodiscard]] Complex dH(int m) const { return {slope(J, m), -slope(Y, m)}; }

 private:
    [[nodiscard]] double slope(const std::vector<double>& f, int m) const {
        const auto i = static_cast<std::size_t>(m);
        return m / x * f[i] - f[i + 1];
    }
};

/// Incident wave in azimuth m, H:9: c_m J_m(kr) Z_0(z) / Z_0(0), c_m = i g / w eps_m (-i)^m.
Complex incident(int m, double w, double g) {
    return I * g / w * (m == 0 ? 1.0 : 2.0) * std::pow(-I, m);
}

double stiffness_in_heave(const Buoyancy& b, const Water& water) {
    return water.density * water.gravity * b.waterplane;
}

/// H:10: the free hull's heave, and surge with pitch.
void move(WaveResponse& r, double w, const Hull& hull, const Water& water, const FreeHull& f) {
    const Buoyancy b = buoyancy_of(hull);
    const double rho_g = water.density * water.gravity, w2 = w * w;
    const Complex heave = -w2 * (f.mass + f.heave_added_mass + r.heave_added_mass) +
                          I * w * (r.heave_damping + f.heave_damping) +
                          stiffness_in_heave(b, water);
    r.heave = r.heave_force / heave;
    const double C55 =
        rho_g * (b.volume * b.centre + b.waterplane_moment) - f.mass * water.gravity * f.cog;
    const double inertia = f.mass * (f.gyration * f.gyration + f.cog * f.cog);
    Eigen::Matrix2cd Z;
    Z(0, 0) = -w2 * (f.mass + r.surge_added_mass) + I * w * r.surge_damping;
    Z(0, 1) = -w2 * (f.mass * f.cog + r.surge_pitch_added_mass) + I * w * r.surge_pitch_damping;
    Z(1, 0) = Z(0, 1);
    Z(1, 1) = -w2 * (inertia + r.pitch_added_mass) + I * w * r.pitch_damping + C55;
    const Eigen::Vector2cd x = Z.inverse() * Eigen::Vector2cd(r.surge_force, r.pitch_moment);
    r.surge = x[0];
    r.pitch = x[1];
}

double gap(Complex a, Complex b, double scale) {
    const double size = std::max({std::abs(a), std::abs(b), scale});
    return size > 0.0 ? std::abs(a - b) / size : 0.0;
}

}  // namespace

WaveResponse wave_response(CylinderFlow& flow, const Hull& hull, double w, const Water& water,
                           const FreeHull* free) {
    const double g = water.gravity, rho = water.density, K = w * w / g;
    const FarWaves far = flow.far_waves(K);
    const double k = far.k, R = far.radius, kR = k * R, zeta = far.at_surface;
    const int most = static_cast<int>(std::ceil(kR + 6.0 * std::cbrt(kR))) + 6;
    const Cylinder cylinder(kR, most);

    const AzimuthFlow f0 = flow.solve(0, K), f1 = flow.solve(1, K);
    WaveResponse r;
    r.heave_added_mass = -rho * f0.force(0, 0).real();
    r.heave_damping = rho * w * f0.force(0, 0).imag();
    r.surge_added_mass = -rho * f1.force(0, 0).real();
    r.surge_damping = rho * w * f1.force(0, 0).imag();
    r.surge_pitch_added_mass = -rho * f1.force(0, 1).real();
    r.surge_pitch_damping = rho * w * f1.force(0, 1).imag();
    r.pitch_added_mass = -rho * f1.force(1, 1).real();
    r.pitch_damping = rho * w * f1.force(1, 1).imag();

    // What the incident wave amounts to on a hull that lets no flux through: J - J' H / H'.
    const auto meets = [&](int m) {
        return incident(m, w, g) / zeta * Complex(0.0, -2.0 / (M_PI * kR)) / cylinder.dH(m);
    };
    const Complex pressure = I * w * rho;
    r.heave_force = pressure * f0.exciting[0] * meets(0);
    r.surge_force = pressure * f1.exciting[0] * meets(1);
    r.pitch_moment = pressure * f1.exciting[1] * meets(1);

    // Haskind, H:9, and radiated power, H:12, against the forces
    const auto haskind = [&](int m, Complex Q) {
        return pressure * (m == 0 ? 2.0 * M_PI : M_PI) * R * meets(m) * Q;
    };
    const double buoyant = rho * g * M_PI * R * R * 1e-12;
    r.haskind_gap = std::max({gap(r.heave_force, haskind(0, f0.radiated[0]), buoyant),
                              gap(r.surge_force, haskind(1, f1.radiated[0]), buoyant),
                              gap(r.pitch_moment, haskind(1, f1.radiated[1]), buoyant * R)});
    const auto radiated = [&](int m, Complex Q) {
        const double T = outgoing_ratio(m, kR).imag() / k;
        return w * rho * (m == 0 ? 2.0 * M_PI : M_PI) * R * T * std::norm(Q);
    };
    const double tiny = 1e-12 * rho * w * R * R * R;
    r.energy_gap = std::max({gap(r.heave_damping, radiated(0, f0.radiated[0]), tiny),
                             gap(r.surge_damping, radiated(1, f1.radiated[0]), tiny),
                             gap(r.pitch_damping, radiated(1, f1.radiated[1]), tiny * R * R)});
    if (free != nullptr) move(r, w, hull, water, *free);

    // Scattered and radiated waves: c_m B_m H_m(kr), from the flux into the propagating mode.
    std::vector<Complex> B;
    for (int m = 0; m <= most; ++m) {
        const Complex c = incident(m, w, g) / zeta, meet = meets(m);
        Complex flux = 0.0;
        if (m == 0) flux = f0.scattered * meet + I * w * r.heave * f0.radiated[0];
        if (m == 1)
            flux =
                f1.scattered * meet + I * w * (r.surge * f1.radiated[0] + r.pitch * f1.radiated[1]);
        if (m > 1 && std::abs(B.back()) > 1e-14) flux = flow.solve(m, K).scattered * meet;
        B.push_back((flux / (c * k) - cylinder.dJ(m)) / cylinder.dH(m));
        if (m > 1 && std::abs(B.back()) < 1e-16) break;
    }
    B.push_back(0.0);
    // H:11 with 1 - S_m S*_(m+1) = -2 (B_m + B*_(m+1)) - 4 B_m B*_(m+1)
    double sum = 0.0;
    for (std::size_t m = 0; m + 1 < B.size(); ++m)
        sum += (-2.0 * (B[m] + std::conj(B[m + 1])) - 4.0 * B[m] * std::conj(B[m + 1])).real();
    r.drift = rho * g * far.group_ratio / k * sum;
    return r;
}

double heave_damping_of(double fraction, CylinderFlow& flow, const Hull& hull, const Water& water,
                        const FreeHull& free) {
    const double C = stiffness_in_heave(buoyancy_of(hull), water);
    if (C == 0.0 || fraction == 0.0) return 0.0;
    double total = free.mass + free.heave_added_mass, w = std::sqrt(C / total);
    for (int i = 0; i < 20; ++i) {
        const double added =
            -water.density * flow.solve(0, w * w / water.gravity).force(0, 0).real();
        total = free.mass + free.heave_added_mass + added;
        const double next = std::sqrt(C / total);
        if (std::abs(next / w - 1.0) < 1e-10) break;
        w = next;
    }
    return 2.0 * fraction * std::sqrt(C * total);
}

}  // namespace hawser::hydro
