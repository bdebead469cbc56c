// Every law along a rod gets the same two tests: force is minus the gradient of energy, and work is
// stored or dissipated, nothing else. Then what each law claims for itself.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <string>
#include <vector>

#include "constraint/along_rod.hpp"
#include "rod/lane_access.hpp"

namespace hawser::worker {
namespace {

using V = Lanes<1>;

Vector<V> vector(const Vec3& x) { return {V(x.x()), V(x.y()), V(x.z())}; }
Vec3 plain(const Vector<V>& x) { return lane_vector(x, 0); }

const Vec3 axis = Vec3(0.1, -0.2, 1).normalized();

/// A law, places of its point to look at, and a way to move through.
struct LawCase {
    std::string name;
    Law<V> law;
    std::vector<Vec3> places;  ///< g [m]
    Vec3 centre, reach;        ///< g = centre + reach sin(t) (and cos across) [m]
    std::vector<Vec3> cylinders = {};
};

std::vector<LawCase> all_laws() {
    const Vec3 side = axis.unitOrthogonal(), other = axis.cross(side);
    const std::vector<Vec3> across = {0.03 * side + 0.3 * axis, 0.0262 * other,
                                      0.05 * side - 0.02 * other - 0.1 * axis, 0.01 * side};
    const std::vector<Vec3> strokes = {-1.3 * axis + 0.2 * side, 2.0 * axis - 0.1 * other,
                                       4.5008 * axis, -4.6 * axis + 0.1 * side};
    const std::vector<Vec3> rig = {6 * axis + 1.5 * side, 6 * axis - 0.75 * side + 1.3 * other,
                                   6 * axis - 0.75 * side - 1.3 * other};
    const Tensioner<V> limits{
        .stroke_min = V(-4.5), .stroke_max = V(4.5), .stop_stiffness = V(1e8)};
    Tensioner<V> linear = limits, gas = limits, table = limits;
    linear.nominal = V(5e6), linear.stiffness = V(1.5e5);
    gas.nominal = V(5e6), gas.exponent = V(1.1), gas.column = V(40.0);
    table.table[0] = PiecewiseLinear({{-4, 4e6}, {0, 5e6}, {1, 5.3e6}, {4, 7e6}});
    for (Tensioner<V>* t : {&linear, &gas, &table}) t->damping = V(3e4), t->friction_force = V(1e5);
    return {
        {"guide", Guide<V>{V(0.025), V(2e7), V(3e5), V(0.2), V(0.001), V(0.002)}, across,
         Vec3::Zero(), 0.04 * side + 0.3 * axis},
        {"slider with a gap", Guide<V>{V(0.025), V(2e7), V(0.0), V(0.0), V(1.0), V(0.002)}, across,
         0.02 * other, 0.03 * side + 0.3 * axis},
        {"slider", Slider<V>{V(1e6), V(2e4)}, across, Vec3::Zero(), 0.2 * side + 2 * axis},
        {"held point", HeldPoint<V>{V(1e6), V(2e4)}, across, Vec3::Zero(), 0.2 * side + 2 * axis},
        {"linear tensioner", linear, strokes, 0.5 * axis, 3 * axis + 0.1 * side},
        {"gas tensioner", gas, strokes, 0.5 * axis, 4.02 * axis + 0.1 * side},  // onto its stop
        {"table tensioner", table, strokes, Vec3::Zero(), 4.6 * axis + 0.1 * side},
        {"gas tensioner beyond its gas", gas, {-39 * axis}, Vec3::Zero(), 1.0 * axis},
        {"three cylinders", gas, strokes, 0.5 * axis, 4.02 * axis + 0.4 * side, rig},
        {"three cylinders by table", table, strokes, 0.5 * axis, 3 * axis + 0.4 * other, rig}};
}

ConstraintReading<V> at(const LawCase& c, const ConstraintMotion<V>& m) {
    return std::visit([&](const auto& law) { return load(law, m, V(0.0)); }, c.law);
}

/// At rest and without friction.
ConstraintReading<V> resting_at(const LawCase& c, const Vec3& g) {
    std::vector<Vector<V>> points;
    for (const Vec3& p : c.cylinders) points.push_back(vector(p));
    ConstraintMotion<V> m;
    m.g = vector(g);
    m.k = vector(axis);
    m.rubs = V(0.0);
    m.cylinders = points;
    return at(c, m);
}

TEST(EveryLaw, ForceIsMinusTheGradientOfEnergy) {
    for (const LawCase& c : all_laws()) {
        for (const Vec3& g : c.places) {
            const double h = 1e-6;
            const Vec3 force = plain(resting_at(c, g).load.force);
            for (int i = 0; i < 3; ++i) {
                const Vec3 step = h * Vec3::Unit(i);
                const double slope = (resting_at(c, g + step).load.energy[0] -
                                      resting_at(c, g - step).load.energy[0]) /
                                     (2 * h);
                // rounding of an energy of up to 2e7 J over 2e-6 m, and the foot of a contact
                EXPECT_NEAR(force[i], -slope, 1e-5 * std::max(force.norm(), 1e4))
                    << c.name << " " << i;
            }
        }
    }
}

TEST(EveryLaw, StiffnessIsTheDerivativeOfTheForce) {
    for (const LawCase& c : all_laws()) {
        for (const Vec3& g : c.places) {
            const Mat3 S = lane_matrix(resting_at(c, g).load.stiffness, 0);
            Mat3 difference;
            const double h = 1e-6;
            for (int i = 0; i < 3; ++i) {
                const Vec3 step = h * Vec3::Unit(i);
                difference.col(i) = -(plain(resting_at(c, g + step).load.force) -
                                      plain(resting_at(c, g - step).load.force)) /
                                    (2 * h);
            }
            // a cylinder that pushes would soften across itself: that is left out
            if (!c.cylinders.empty() && resting_at(c, g).magnitude[0] < 0.0) {
                EXPECT_GT(Eigen::SelfAdjointEigenSolver<Mat3>(S).eigenvalues().minCoeff(),
                          -1e-9 * S.norm());
                continue;
            }
            EXPECT_NEAR((S - difference).norm(), 0, 1e-5 * std::max(S.norm(), 1e3)) << c.name;
        }
    }
}

TEST(EveryLaw, StiffnessHoldsDampingAndFriction) {
    // As the time scheme moves a point from rest: its speed follows with a1, its slide in full.
    const double a1 = 100.0, h = 1e-7;
    for (const LawCase& c : all_laws()) {
        std::vector<Vector<V>> points;
        for (const Vec3& p : c.cylinders) points.push_back(vector(p));
        const auto reading = [&](const Vec3& g, const Vec3& step) {
            ConstraintMotion<V> m;
            m.g = vector(g + step);
            m.g_rate = vector(a1 * step);
            m.k = vector(axis);
            m.cylinders = points;
            m.slide = V(step.dot(axis));
            m.stroke_before = resting_at(c, g).opening;
            return std::visit([&](const auto& law) { return load(law, m, V(a1)); }, c.law).load;
        };
        for (const Vec3& g : c.places) {
            if (!c.cylinders.empty() && resting_at(c, g).magnitude[0] < 0.0) continue;
            const Mat3 S = lane_matrix(reading(g, Vec3::Zero()).stiffness, 0);
            Mat3 difference;
            for (int i = 0; i < 3; ++i)
                difference.col(i) = -(plain(reading(g, h * Vec3::Unit(i)).force) -
                                      plain(reading(g, -h * Vec3::Unit(i)).force)) /
                                    (2 * h);
            // the damper's own step is of second order: a1 h / smoothing
            EXPECT_NEAR((S - difference).norm(), 0, 1e-4 * std::max(S.norm(), 1e3)) << c.name;
        }
    }
}

TEST(EveryLaw, WorkIsStoredOrDissipated) {
    // Along g(t) from rest to rest: -int f.g' dt = change of energy + int power dt.
    for (const LawCase& c : all_laws()) {
        std::vector<Vector<V>> points;
        for (const Vec3& p : c.cylinders) points.push_back(vector(p));
        const Vec3 swing = 0.3 * axis.cross(c.reach);
        const auto g = [&](double t) {
            return Vec3(c.centre + c.reach * std::sin(t) + swing * (1 - std::cos(t)));
        };
        const auto rate = [&](double t) {
            return Vec3(c.reach * std::cos(t) + swing * std::sin(t));
        };
        const int n = 40000;
        const double h = 7.0 / n;
        ConstraintMotion<V> m;
        m.k = vector(axis);
        m.cylinders = points;
        m.g = vector(g(0)), m.g_rate = vector(rate(0));
        m.stroke_before = resting_at(c, g(0)).opening;
        ConstraintReading<V> last = at(c, m);
        const double start = last.load.energy[0];
        double work = 0.0, dissipated = 0.0, largest = 0.0;
        for (int i = 1; i <= n; ++i) {
            const Vec3 v0 = rate((i - 1) * h), v1 = rate(i * h);
            m.friction = last.friction;
            m.slide = V((g(i * h) - g((i - 1) * h)).dot(axis));
            m.stroke_before = std::holds_alternative<Tensioner<V>>(c.law) ? last.opening : V(0.0);
            m.g = vector(g(i * h)), m.g_rate = vector(v1);
            const ConstraintReading<V> next = at(c, m);
            work -= 0.5 * h * (plain(last.load.force).dot(v0) + plain(next.load.force).dot(v1));
            dissipated += 0.5 * h * (last.power[0] + next.power[0]);
            largest = std::max(largest, std::abs(next.load.energy[0] - start));
            last = next;
        }
        const double stored = last.load.energy[0] - start;
        // trapezoidal rule over 40000 steps through contacts of 2 mm: 1e-4 of what flows
        EXPECT_NEAR(work, stored + dissipated, 2e-4 * (largest + dissipated)) << c.name;
        EXPECT_GT(dissipated, -1e-6 * largest) << c.name;
    }
}

TEST(Guide, RubsUpToItsFrictionLimit) {
    const Guide<V> guide{V(0.0), V(1e6), V(0.0), V(0.3), V(0.01), V(0.002)};
    ConstraintMotion<V> m;
    m.g = vector({0.1, 0, 0});
    m.k = vector(Vec3::UnitZ());
    m.slide = V(0.005);  // half of what mobilises it
    const double N = load(guide, m, V(0.0)).magnitude[0];
    EXPECT_NEAR(plain(load(guide, m, V(0.0)).load.force).z(), -0.5 * 0.3 * N, 1e-9 * N);
    m.slide = V(1.0);
    EXPECT_NEAR(plain(load(guide, m, V(0.0)).load.force).z(), -0.3 * N, 1e-9 * N);
    EXPECT_NEAR(load(guide, m, V(0.0)).friction[0], 0.01, 1e-12);
}

TEST(Guide, NeverPulls) {
    const Guide<V> guide{V(0.02), V(2e7), V(1e7), V(0.3), V(0.01), V(0.002)};
    ConstraintMotion<V> m;
    m.g = vector({0.03, 0, 0});
    m.g_rate = vector({-5, 0, 0});  // leaves faster than its damper would let it
    m.k = vector(Vec3::UnitZ());
    EXPECT_EQ(load(guide, m, V(0.0)).magnitude[0], 0.0);
    EXPECT_GT(load(guide, m, V(0.0)).power[0], 0.0);
}

TEST(Tensioner, FollowsItsLawAndStopsAtItsStroke) {
    Tensioner<V> t{.stroke_min = V(-3.0), .stroke_max = V(3.0), .stop_stiffness = V(1e8)};
    t.table[0] = PiecewiseLinear({{-2, 4e6}, {0, 5e6}, {2, 7e6}});
    const auto pull = [&](double x) { return pull_at(t, V(x)).force[0]; };
    EXPECT_NEAR(pull(0), 5e6, 1e-3);
    EXPECT_NEAR(pull(-1), 4.5e6, 1e-3);
    EXPECT_NEAR(pull(1), 6e6, 1e-3);
    EXPECT_NEAR(pull(2.9), 7e6 + 0.9 * 1e6, 1e-3);  // goes on with its end slope
    // beyond the limit by 5 mm: k (pen - d0/2) on top
    EXPECT_NEAR(pull(3.005) - (7e6 + 1.005e6), 1e8 * (0.005 - 0.001), 1.0);
    EXPECT_NEAR(pull(-3.005) - (4e6 - 0.5025e6), -1e8 * (0.005 - 0.001), 1.0);
}

TEST(Tensioner, CylindersSumToTheLawOnTheAxisAndCentreTheRod) {
    const std::vector<Vector<V>> rig = {vector({1.5, 0, 6}), vector({-0.75, 1.3, 6}),
                                        vector({-0.75, -1.3, 6})};
    Tensioner<V> t{.nominal = V(5e6),
                   .stiffness = V(2e5),
                   .stroke_min = V(-4.5),
                   .stroke_max = V(4.5),
                   .stop_stiffness = V(1e8)};
    ConstraintMotion<V> m;
    m.k = vector(Vec3::UnitZ());
    m.cylinders = rig;
    for (const double x : {-3.0, 0.0, 2.5}) {
        m.g = vector({0, 0, -x});
        const ConstraintReading<V> r = load(t, m, V(0.0));
        EXPECT_NEAR(plain(r.load.force).z(), 5e6 + 2e5 * x, 1e-6 * 5e6) << x;
        EXPECT_NEAR(r.opening[0], x, 1e-12);
        EXPECT_NEAR(r.magnitude[0], 5e6 + 2e5 * x, 1e-6 * 5e6);
    }
    m.g = vector({0.3, 0, 0});
    EXPECT_LT(plain(load(t, m, V(0.0)).load.force).x(), -1e4);
}

TEST(Tensioner, RamsRubAgainstTheirStroke) {
    const Tensioner<V> t{.nominal = V(5e6),
                         .stroke_min = V(-4.5),
                         .stroke_max = V(4.5),
                         .stop_stiffness = V(1e8),
                         .friction_force = V(2e5),
                         .mobilisation = V(0.01)};
    ConstraintMotion<V> m;
    m.k = vector(Vec3::UnitZ());
    for (const double way : {1.0, -1.0}) {  // the rod's top goes down, then up
        m.g = vector({0, 0, -way});
        EXPECT_NEAR(load(t, m, V(0.0)).magnitude[0], 5e6 + way * 2e5, 1e-3);
    }
}

}  // namespace
}  // namespace hawser::worker
