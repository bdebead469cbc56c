// Where the platform's energy goes: an undamped one keeps it but for the error of the Runge-Kutta
// scheme, and what radiation takes is the work of its damping, with constant matrices and with
// memory.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "spar_hull.hpp"

namespace hawser::master {
namespace {

/// A deep buoy: weight and buoyancy through the exact rotation, a waterplane that only heaves,
/// added mass that is the same in all directions, no damping. All of it has a potential.
struct Buoy {
    Case input = spar_case();
    HydroData data;

    Buoy() {
        input.platform->radii_of_gyration = {83, 60, 15};
        data.density = 1025.0;
        data.displaced_volume = 1.030442e8 / 1025.0;
        data.centre_of_buoyancy = {0, 0, -51.875};
        Vec6 added;
        added << 6e7, 6e7, 6e7, 2e11, 2e11, 2e11;
        for (const double w : {0.1, 1.0}) {
            data.frequencies.push_back(w);
            data.added_mass.emplace_back(added.asDiagonal());
            data.damping.push_back(Mat6::Zero());
        }
        data.waterplane_stiffness(0, 0) = 1.26e7;
    }
};

/// A taut spring from a point of the body to one that stays: stiff enough to be felt.
struct Spring {
    Vec3 fairlead, anchor;
    double stiffness = 5e5, length = 600.0;

    [[nodiscard]] Vec3 span(const State& s) const {
        return motion_of(s).position + rotation(motion_of(s).angles) * fairlead - anchor;
    }
    [[nodiscard]] Vec6 load(const State& s) const {
        const Vec3 d = span(s);
        const Vec3 force = -stiffness * (1.0 - length / d.norm()) * d;
        const Vec3 arm = rotation(motion_of(s).angles) * fairlead;
        Vec6 out;
        out << force, arm.cross(force);
        return out;
    }
    [[nodiscard]] double energy(const State& s) const {
        return 0.5 * stiffness * std::pow(span(s).norm() - length, 2);
    }
};

const std::array<Spring, 3> springs = {{{{20, 0, -50}, {620, 0, -150}},
                                        {{-10, 17, -50}, {-310, 530, -150}},
                                        {{-10, -17, -50}, {-310, -530, -150}}}};

double energy_of(const Hull& hull, const HydroData& data, const State& s) {
    const PlatformMotion m = motion_of(s);
    const Mat3 R = rotation(m.angles);
    Vec6 v;
    v << m.velocity, angular_velocity(m);
    const Mat6 mass = mass_matrix(turned(hull.body(), R)) + turned(data.added_mass.front(), R);
    const double g = 9.80665, heave = m.position.z();
    const double z_G = heave + (R * hull.body().centre_of_gravity).z(),
                 z_B = heave + (R * data.centre_of_buoyancy).z();
    double energy = 0.5 * v.dot(mass * v) + hull.body().mass * g * z_G -
                    data.density * g * data.displaced_volume * z_B +
                    0.5 * data.waterplane_stiffness(0, 0) * heave * heave;
    for (const Spring& spring : springs) energy += spring.energy(s);
    return energy;
}

TEST(UndampedPlatform, KeepsItsEnergyToTheOrderOfRungeAndKutta) {  // P:3, K:4, K:6
    const Buoy buoy;
    const Hull hull(buoy.input, &buoy.data);
    State start = State::Zero();
    set_motion(start, {.position = {10, -5, 4},
                       .angles = {0.4, 0.5, 0.3},
                       .velocity = {2, 1, 0},
                       .angle_rates = {0.02, 0.0, 0.15}});
    const double all =
        energy_of(hull, buoy.data, start) - energy_of(hull, buoy.data, State::Zero());
    double steepest = 0, exchanged = 0;
    std::array<double, 3> errors{};
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const double h = 1.0 / static_cast<double>(1 << i);
        double& error = errors[i];
        (void)run(
            hull, start, h, static_cast<int>(300 / h),
            [&](double, const State& y, const HullLoads&) {
                error = std::max(error, std::abs(energy_of(hull, buoy.data, y) -
                                                 energy_of(hull, buoy.data, start)) /
                                            all);
                steepest = std::max(steepest, y.segment<2>(3).norm());
                Vec6 v;
                v << motion_of(y).velocity, angular_velocity(motion_of(y));
                exchanged = std::max(exchanged, 0.5 * v.dot(hull.momentum(y)) / all);
            },
            [](double, const State& y) {
                Vec6 load = Vec6::Zero();
                for (const Spring& spring : springs) load += spring.load(y);
                return load;
            });
    }
    EXPECT_GT(steepest, 0.5);   // far from linear
    EXPECT_GT(exchanged, 0.2);  // and the energy goes to and fro
    // A free oscillation loses (w h)^6/72 of its amplitude a step, h^5 in all; the swing within a
    // period is of order h^4.
    EXPECT_LT(errors[2], 2e-5);
    for (int i : {0, 1}) {
        const double ratio = errors[std::size_t(i)] / errors[std::size_t(i) + 1];
        EXPECT_GT(ratio, 15.0);
        EXPECT_LT(ratio, 40.0);
    }
}

TEST(UndampedPlatform, LosesInHeaveWhatTheSchemeTakesAndNothingElse) {  // P:3
    Buoy buoy;
    const Hull hull(buoy.input, &buoy.data);
    State s = State::Zero();
    s[2] = 2.0;
    const double h = 2.0, w = std::sqrt(1.26e7 / (1.030442e8 + 6e7));
    const int steps = 500;
    const State end = run(hull, s, h, steps);
    const double k = 1.26e7, m = 1.030442e8 + 6e7;
    const double left =
        (0.5 * k * end[2] * end[2] + 0.5 * m * end[8] * end[8]) / (0.5 * k * s[2] * s[2]);
    const Complex z(0, w * h);
    const double scheme = std::norm(1.0 + z + z * z / 2.0 + z * z * z / 6.0 + z * z * z * z / 24.0);
    EXPECT_LT(left, 0.9);
    EXPECT_NEAR(left, std::pow(scheme, steps), 1e-8);
}

/// Mean power [W] of the force that drives the hull through Re(x e^{i w t}), once steady. Its
/// inertia and weight give back what they take: what is left is radiated.
double mean_power(Hull& hull, const CVec6& x, double w) {
    const int per_period = 32, periods = 30;
    const double h = 2 * M_PI / w / per_period;
    const Mat6 mass =
        mass_matrix(turned(hull.body(), Mat3::Identity())) + hull.radiation().added_mass;
    const auto held = [&](double t, State s) {
        const Complex turn = std::polar(1.0, w * t);
        s.head<6>() = (x * turn).real();
        s.segment<6>(6) = (x * turn * Complex(0, w)).real();
        return s;
    };
    Vec6 driver, acceleration;
    const auto rate = [&](double t, const State& s) {
        acceleration = (-w * w * x * std::polar(1.0, w * t)).real();
        Vec6 free;
        HullLoads loads = hull.loads(t, s);
        State out = hull.rate(t, s, loads, Vec6::Zero(), &free);
        driver = mass * (acceleration - free);
        return out;
    };
    State s = held(0, State::Zero());
    double work = 0;
    for (int n = 0; n < periods * per_period; ++n) {
        const double t = n * h;
        const State k1 = rate(t, s);
        hull.remember(t, s, acceleration);
        const bool last = n >= (periods - 1) * per_period;
        // The trapezoidal rule is exact over a period. The discrete memory tells the load at a
        // step's end, before that step is remembered.
        const State k2 = rate(t + h / 2, held(t + h / 2, s + h / 2 * k1));
        const State k3 = rate(t + h / 2, held(t + h / 2, s + h / 2 * k2));
        const State end = held(t + h, s + h * k3);
        const State k4 = rate(t + h, end);
        if (last) work += driver.dot(end.segment<6>(6)) * h;
        s = held(t + h, s + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4));
    }
    return work * w / (2 * M_PI);
}

TEST(Radiation, TakesTheWorkOfItsDamping) {  // mean power 1/2 w^2 x^H B(w) x; K:9, K:10
    using Form = RadiationMemoryKeys::Form;
    const HydroData& data = spar_data();
    std::vector<CVec6> motions(4, CVec6::Zero());
    motions[0][0] = 1e-3;                                            // surge
    motions[1][2] = 1e-3;                                            // heave
    motions[2][0] = 1e-3, motions[2][4] = Complex(0.3e-5, -1.2e-5);  // surge leads pitch
    motions[3][1] = Complex(0, 1e-3), motions[3][3] = 1e-5, motions[3][2] = 5e-4;  // all across
    for (const double w : {0.3, 0.6, 1.0}) {
        Case constant = spar_case();
        constant.platform->hydrodynamics.added_mass_frequency = w;
        std::array<Case, 3> cases = {constant, spar_with_memory(Form::fitted),
                                     spar_with_memory(Form::discrete)};
        for (std::size_t form = 0; form < cases.size(); ++form) {
            Case& c = cases[form];
            c.analysis.dynamics.platform_step = 2 * M_PI / w / 32;
            Hull hull(c, &data);
            for (std::size_t i = 0; i < motions.size(); ++i) {
                const CVec6& x = motions[i];
                const auto power = [&](const Mat6& B) {
                    return 0.5 * w * w * (x.adjoint() * B * x).value().real();
                };
                const double expected = power(radiation_at(data, w).damping);
                double largest = 0;  // as if it were at another frequency
                for (const Mat6& B : data.damping) largest = std::max(largest, power(B));
                // Constant: the rotations of 1e-5. Fitted: 0.4 % in all, heave 1.7 %. Discrete: the
                // damping that the file leaves out beyond 2 rad/s, and what is not yet forgotten
                // after 100 s.
                const double tolerance = std::array{
                    1e-4 * expected, (i == 1 ? 0.02 : 0.005) * largest, 0.004 * largest}[form];
                EXPECT_NEAR(mean_power(hull, x, w), expected, tolerance)
                    << "form " << form << ", motion " << i << ", w " << w;
            }
        }
    }
}

TEST(Radiation, OfFittedMemoryNeverGivesBackMoreThanItTook) {  // K:10
    const FittedMemory memory(
        Hull(spar_with_memory(RadiationMemoryKeys::Form::fitted), &spar_data()).memory());
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    const Vec6 scale = spar_data().added_mass_inf->diagonal().cwiseSqrt().cwiseMax(1e3);
    const auto n = static_cast<std::size_t>(memory.states());
    std::vector<double> x(n, 0.0), middle(n), k1(n), k2(n);
    const double h = 0.02;
    double work = 0, least = 0, most = 0;
    Vec6 push = Vec6::Zero(), v = Vec6::Zero();
    for (int i = 0; i < 30000; ++i) {
        if (i % 50 == 0)  // another push every second
            for (double& p : push) p = normal(random);
        const Vec6 rate = scale.cwiseInverse().cwiseProduct(push) - 0.3 * v;
        const Vec6 at_middle = v + h / 2 * rate;
        std::fill(k1.begin(), k1.end(), 0.0), std::fill(k2.begin(), k2.end(), 0.0);
        memory.add_rates_to(k1.data(), x.data(), v);
        for (std::size_t j = 0; j < n; ++j) middle[j] = x[j] + h / 2 * k1[j];
        memory.add_rates_to(k2.data(), middle.data(), at_middle);
        work -= h * memory.load(middle.data()).dot(at_middle);
        least = std::min(least, work), most = std::max(most, work);
        for (std::size_t j = 0; j < n; ++j) x[j] += h * k2[j];
        v += h * (scale.cwiseInverse().cwiseProduct(push) - 0.3 * at_middle);
    }
    EXPECT_GT(work, 0.5 * most);
    EXPECT_GE(least, -1e-5 * most);
}

}  // namespace
}  // namespace hawser::master
