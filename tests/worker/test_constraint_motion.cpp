// Constraints along a rod in motion: energy balance of a rod in all of them, impact in a guide, the
// walk of a contact through the elements, and the impulse that rod and platform take (R:40).
#include <gtest/gtest.h>

#include <cmath>

#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

/// Rods in a void: no water, no gravity, the trapezoidal rule, Newton to the end.
Case in_a_void(Case input, double step) {
    input.environment.water.density = 0.0;
    input.environment.water.gravity = 0.0;
    input.analysis.dynamics.line_step = step;
    input.analysis.dynamics.rod_scheme.type = RodSchemeType::adams_moulton;
    return input;
}
void solve_fully(RodPack<Single>& rod) {
    rod.newton.tolerance = 1e-9;
    rod.newton.max_iterations = 30;
    rod.newton.constraint_force = 1.0;
    rod.newton.constraint_part = 1e-6;
    rod.newton.constraint_iterations = 30;
}

/// A short stiff rod along z, both ends free, in one guide at its middle.
Case flying_rod(double damping, double step) {
    Case input = one_line(plain_type(300, 1e10, 1e10), 2.0, 2, LineEnd{}, LineEnd{});
    input.lines[0].constraints = {{.type = ConstraintType::guide,
                                   .name = "guide",
                                   .on_platform = false,
                                   .position = {0, 0, 1},
                                   .arc_length = {},
                                   .stiffness = 2e7,
                                   .damping = damping,
                                   .gap = 0.025}};
    return in_a_void(input, step);
}
struct Impact {
    double peak, rebound;
};
/// The rod starts on the axis with 2 m/s across.
Impact strike(double damping, double step) {
    const Case input = flying_rod(damping, step);
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    solve_fully(rod);
    std::vector<CatenaryNode> nodes;
    for (int n = 0; n <= 2; ++n)
        nodes.push_back({.position = Vec3(0, 0, n), .tangent = Vec3::UnitZ(), .tension = 0.0});
    rod.set_guess(0, nodes);
    for (int n = 0; n <= 2; ++n) rod.kept().nodes()[n].v = lanes_of({2, 0, 0});
    Impact out{0.0, 0.0};
    const Status status = run(rod, 0.045, step, [&](double) {
        out.peak = std::max(out.peak, rod.constraint_force(0, 0).norm());
    });
    EXPECT_TRUE(status.ok());
    out.rebound = -rod.state().nodes()[1].v.x[0];
    return out;
}

TEST(GuideImpact, PeakAndReboundAreThoseOfALumpedMass) {  // R:32, 600 kg at 2 m/s
    // 1/2 m v^2 = k [d0^2/6 + (p - d0) d0/2 + (p - d0)^2/2],  N = k (p - d0/2)
    const double k = 2e7, d0 = contact_smoothing, energy = 0.5 * 600 * 4;
    const double q = -0.5 * d0 + std::sqrt(0.25 * d0 * d0 + 2 * (energy / k - d0 * d0 / 6));
    const double peak = k * (q + 0.5 * d0);
    const Impact elastic = strike(0.0, 1e-4);
    EXPECT_NEAR(elastic.peak, peak, 5e-3 * peak);
    EXPECT_NEAR(elastic.rebound, 2.0, 5e-3 * 2.0);
    // with a damper: the same mass integrated by itself
    const double c = 5e4;
    double x = 0.025, v = 2.0, lumped = 0.0;
    for (const double h = 1e-7; x >= 0.025;) {
        const double p = x - 0.025, on = std::min(1.0, p / d0);
        const double N =
            std::max(0.0, (p < d0 ? 0.5 * k * p * p / d0 : k * (p - 0.5 * d0)) + c * on * v);
        lumped = std::max(lumped, N);
        v -= h * N / 600;
        x += h * v;
    }
    const Impact damped = strike(c, 1e-4);
    EXPECT_NEAR(damped.peak, lumped, 5e-3 * lumped);
    EXPECT_NEAR(damped.rebound, -v, 5e-3 * 2.0);
    EXPECT_LT(damped.rebound, 1.7);
}

TEST(GuideImpact, ConvergesWithTheStep) {
    // the contact lasts pi sqrt(m/k) = 17 ms
    const double fine = strike(5e4, 5e-5).peak;
    const double coarse = std::abs(strike(5e4, 8e-4).peak / fine - 1);
    EXPECT_LT(coarse, 0.02);
    EXPECT_LT(std::abs(strike(5e4, 2e-4).peak / fine - 1), 0.25 * coarse + 1e-3);
}

TEST(GuideImpact, TheForceThatTheRodFeelsIsTheLawsWithTheUsualTolerances) {  // README, "Contacts"
    // A hard guide, 15 cm/s: no correction is as large as the 5 mm that ask for another iteration,
    // yet the law's force at the solution is to be the one that moved the rod, to 1 % and 1 kN.
    const double k = 1e9, step = 5e-3;
    Case input = flying_rod(0.0, step);
    input.lines[0].constraints[0].stiffness = k;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    std::vector<CatenaryNode> nodes;
    for (int n = 0; n <= 2; ++n)
        nodes.push_back({.position = Vec3(0.024, 0, n), .tangent = Vec3::UnitZ(), .tension = 0.0});
    rod.set_guess(0, nodes);
    for (int n = 0; n <= 2; ++n) rod.kept().nodes()[n].v = lanes_of({0.15, 0, 0});
    double peak = 0.0;
    const Status status = run(rod, 0.06, step, [&](double t) {
        const double p = std::max(0.0, rod.state().nodes()[1].r.x[0] - 0.025);
        const double law = k * (p < contact_smoothing ? 0.5 * p * p / contact_smoothing
                                                      : p - 0.5 * contact_smoothing);
        EXPECT_NEAR(rod.constraint_force(0, 0).norm(), law, 1e3 + 0.01 * law) << t;
        peak = std::max(peak, law);
    });
    EXPECT_TRUE(status.ok());
    EXPECT_GT(peak, 1e4);
}

/// Energy of a rod [J]: kinetic, of stretch and of bending.
double energy_of(const RodPack<Single>& rod, double L, double m, double EA, double EI) {
    double sum = 0.0;
    const NodeState<Single>* node = rod.state().nodes();
    const Multiplier<Single>* lambda = rod.state().lambda();
    for (int e = 0; e < rod.elements(); ++e) {
        const NodeState<Single>&a = node[e], &b = node[e + 1];
        for (std::size_t g = 0; g < gauss_points; ++g) {
            const auto A = hermite(gauss_xi[g]);
            const auto P = quadratic(gauss_xi[g]);
            const auto c = reduced_curvature(gauss_xi[g]);
            const Vec3 v =
                A[0] * vec(a.v) + A[1] * L * vec(a.vd) + A[2] * vec(b.v) + A[3] * L * vec(b.vd);
            const Vec3 bend =
                (c[0] * (vec(b.r) - vec(a.r)) + c[1] * L * vec(a.d) + c[2] * L * vec(b.d)) /
                (L * L);
            const double l = P[0] * lambda[2 * e].now[0] + P[1] * lambda[2 * e + 1].now[0] +
                             P[2] * lambda[2 * e + 2].now[0];
            const double T = l / (1 - l / EA);
            sum += L * gauss_weight[g] *
                   (0.5 * m * v.squaredNorm() + 0.5 * T * T / EA + 0.5 * EI * bend.squaredNorm());
        }
    }
    return sum;
}

TEST(EveryConstraint, AccountsForTheEnergyOfAMovingRod) {
    // One rod in a guide with friction and damping, a slider, a joint, a pull tube and a tensioner
    // with three rubbing cylinders, its end A shaken: energy of rod and constraints, and what they
    // dissipated, against the work of end A.
    const double m = 200, EA = 5e8, EI = 5e7, L = 2.0, step = 5e-4;
    LineEnd top = moving(fixed_at({0, 0, 0}), {0.25, 0.1, 0.0}, 1.6);
    Case input = one_line(plain_type(m, EA, EI), 60, 30, top, LineEnd{});
    LineConstraint base;
    base.on_platform = false;
    LineConstraint guide = base, slider = base, joint = base, tube = base, tensioner = base;
    guide.type = ConstraintType::guide, guide.name = "guide", guide.position = {0, 0, -21};
    guide.stiffness = 2e6, guide.damping = 2e4, guide.gap = 0.02, guide.friction = 0.3;
    slider.type = ConstraintType::slider, slider.name = "slider", slider.position = {0, 0, -43};
    slider.stiffness = 1e5, slider.damping = 2e3;
    joint.type = ConstraintType::flex_joint, joint.name = "joint", joint.position = {0, 0, -35};
    joint.arc_length = 35.0, joint.stiffness = 2e6, joint.damping = 1e4;
    joint.rotational_curve = {{0, 0}, {0.002, 2e4}, {1, 5e6}};
    joint.direction = Vec3(0, 0, -1);
    tube.type = ConstraintType::pull_tube, tube.name = "tube";
    tube.path = {{0, 0, -5}, {0.01, 0, -9}, {0, 0, -13}};
    tube.stiffness = 1e6, tube.gap = 0.05, tube.friction = 0.2;
    tensioner.type = ConstraintType::tensioner, tensioner.name = "tensioner";
    tensioner.position = {0, 0, -59}, tensioner.arc_length = 59.0, tensioner.axis = {0, 0, -1};
    tensioner.nominal_tension = 1e5, tensioner.stiffness = 1e5, tensioner.friction_force = 2e4;
    tensioner.damping = 1e3;
    tensioner.cylinders = {{1, 0, -65}, {-0.5, 0.8, -65}, {-0.5, -0.8, -65}};
    input.lines[0].constraints = {guide, slider, joint, tube, tensioner};
    input.analysis.dynamics.ramp = 0.0;
    input = in_a_void(input, step);
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    solve_fully(rod);
    std::vector<CatenaryNode> nodes;
    for (int n = 30; n >= 0; --n)
        nodes.push_back(
            {.position = Vec3(0, 0, -2.0 * n), .tangent = Vec3::UnitZ(), .tension = 0.0});
    rod.set_guess(0, nodes);
    // set off with the speed of its end
    for (int n = 0; n <= 30; ++n)
        rod.kept().nodes()[n].v =
            lanes_of({0.25 * 2 * M_PI / 1.6 * n / 30, 0.1 * 2 * M_PI / 1.6 * n / 30, 0.3});
    for (int n = 0; n <= 30; ++n)
        rod.kept().nodes()[n].vd =
            lanes_of({0.25 * 2 * M_PI / 1.6 / 60, 0.1 * 2 * M_PI / 1.6 / 60, 0});
    ASSERT_TRUE(run(rod, step, step).ok());  // all constraints have their first reading
    const auto held = [&] {
        double sum = 0.0;
        for (int c = 0; c < 5; ++c)
            sum += rod.constraint_energy(0, c) + rod.constraint_dissipated(0, c);
        return sum + energy_of(rod, L, m, EA, EI);
    };
    const double before = held();
    double work = 0.0, flow = 0.0, last = 0.0;
    const PlatformMotion still;
    for (int k = 1; k < 6000; ++k) {
        const double t0 = k * step, t1 = (k + 1) * step;
        const Vec3 f0 = -rod.force_on_support_a(0), v0 = vec(rod.state().nodes()[30].v);
        ASSERT_TRUE(rod.pass(t0, t1, MotionSpline(t0, still, t1, still)).ok()) << t1;
        rod.keep();
        const Vec3 f1 = -rod.force_on_support_a(0), v1 = vec(rod.state().nodes()[30].v);
        const double dW = 0.5 * step * (f0.dot(v0) + f1.dot(v1));
        work += dW, flow += std::abs(dW), last = t1;
    }
    EXPECT_GT(last, 2.9);
    double dissipated = 0.0;
    for (int c = 0; c < 5; ++c) {
        EXPECT_GT(rod.constraint_dissipated(0, c), 1.0) << c;  // all take part
        dissipated += rod.constraint_dissipated(0, c);
    }
    // second order in the step; contacts of 2 mm at 1 m/s last four steps
    EXPECT_NEAR(held() - before, work, 0.01 * (flow + dissipated));
}

TEST(Contact, WalksFromElementToElementWithoutAJumpInForce) {
    // A bent rod is drawn through a guide at 5 m/s: the force is continuous, so its change per step
    // falls with the step, as much at nodes as between them.
    const auto largest_change = [](double step, int& crossings) {
        Case input =
            one_line(plain_type(100, 1e9, 2e6), 60, 30, moving(fixed_at({0, 0, 0}), {0, 0, 8}, 10),
                     moving(fixed_at({0, 0, -60.06}), {0, 0, 8}, 10));
        input.lines[0].constraints = {{.type = ConstraintType::guide,
                                       .name = "guide",
                                       .on_platform = false,
                                       .position = {1.5, 0, -30},
                                       .arc_length = {},
                                       .stiffness = 1e6,
                                       .damping = 1e4,
                                       .gap = 0.01}};
        input.analysis.dynamics.ramp = 5.0;
        input.environment.water.density = 0.0;
        input.environment.water.gravity = 0.0;
        input.analysis.dynamics.line_step = step;
        const Sea sea = still_sea(input);
        RodPack<Single> rod(input, sea, {0});
        std::vector<CatenaryNode> nodes;
        for (int n = 30; n >= 0; --n)
            nodes.push_back(
                {.position = Vec3(0, 0, -2.002 * n), .tangent = Vec3::UnitZ(), .tension = 1e6});
        rod.set_guess(0, nodes);
        EXPECT_TRUE(rod.equilibrium({}, false).ok());
        double change = 0.0, element = -1.0;
        double last = rod.constraint_magnitude(0, 0);
        EXPECT_GT(last, 5e4);
        crossings = 0;
        const Status status = run(rod, 8.0, step, [&](double) {
            const double N = rod.constraint_magnitude(0, 0);
            const double e = rod.state().constraints()[0].element[0];
            if (element >= 0.0 && e != element) {
                ++crossings;
                change = std::max(change, std::abs(N - last) / N);
            }
            element = e, last = N;
        });
        EXPECT_TRUE(status.ok());
        return change;
    };
    int crossings = 0;
    const double coarse = largest_change(0.02, crossings);
    EXPECT_GT(crossings, 8);
    const double fine = largest_change(0.005, crossings);
    EXPECT_LT(coarse, 0.05);
    EXPECT_LT(fine, 0.5 * coarse);
}

TEST(Impulse, OfTheHullIsWhatItsFourRatesTook) {  // R:40
    Case input = flying_rod(5e4, 0.005);
    input.analysis.dynamics.force = ForceFit::instantaneous;
    input.lines[0].constraints[0].on_platform = true;
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    std::vector<CatenaryNode> nodes;
    for (int n = 0; n <= 2; ++n)
        nodes.push_back({.position = Vec3(0, 0, n), .tangent = Vec3::UnitZ(), .tension = 0.0});
    rod.set_guess(0, nodes);
    for (int n = 0; n <= 2; ++n) rod.kept().nodes()[n].v = lanes_of({2, 0, 0});
    const PlatformMotion still;
    const double D = 0.04;
    Vec3 hull = Vec3::Zero(), start = Vec3::Zero();
    for (int k = 0; k < 4; ++k) {
        const double t = k * D;
        Vec3 F[4];
        const double ends[4] = {t + D / 2, t + D / 2, t + D, t + D};
        for (int s = 0; s < 4; ++s) {
            ASSERT_TRUE(rod.pass(t, ends[s], MotionSpline(t, still, ends[s], still)).ok());
            F[s] = rod.constraint_force(0, 0);
        }
        rod.keep();
        hull += D / 6 * (start + 2 * F[0] + 2 * F[1] + F[2]);
        start = F[3];
    }
    const ConstraintState<Single>& c = rod.state().constraints()[0];
    const Vec3 taken = vec(c.hull_impulse), given = vec(c.impulse);
    EXPECT_NEAR((taken - hull).norm(), 0, 1e-9 * hull.norm());
    // the rod's own momentum: 600 kg from 2 m/s to what it has now
    double momentum = 600 * (rod.state().nodes()[1].v.x[0] - 2.0);
    EXPECT_NEAR(given.x(), momentum, 0.02 * std::abs(momentum));
    const double mismatch = rod.impulse_mismatch(0, 0);
    EXPECT_NEAR(mismatch, (taken - given).norm() / c.impulse_size[0], 1e-12);
    EXPECT_GT(mismatch, 0.01);  // an impact of 17 ms under stages of 20 ms
}

TEST(Impulse, OfASteadyLoadIsTheSameForRodAndHull) {  // R:40, from the static start on
    LineEnd top = fixed_at({0, 0, 0});
    top.kind = EndKind::platform;
    Case input = one_line(plain_type(100, 1e9), 100, 50, top, {});
    input.environment.water.density = 0.0;
    input.lines[0].constraints = {{.type = ConstraintType::ball_joint,
                                   .name = "tie_off",
                                   .position = {30, 0, -50},
                                   .arc_length = 60.0}};
    const Sea sea = still_sea(input);
    RodPack<Single> rod(input, sea, {0});
    ASSERT_TRUE(rod.equilibrium({}, false).ok());
    const PlatformMotion still;
    for (int k = 0; k < 3; ++k) {
        const double t = 0.5 * k;
        for (const double end : {t + 0.25, t + 0.25, t + 0.5, t + 0.5}) {
            ASSERT_TRUE(rod.pass(t, end, MotionSpline(t, still, end, still)).ok());
            EXPECT_LT(rod.impulse_mismatch(0, 0), 1e-6) << t;  // passes not kept do not count
        }
        rod.keep();
        const double size = rod.state().constraints()[0].impulse_size[0];
        EXPECT_NEAR(size, 0.5 * (k + 1) * rod.constraint_force(0, 0).norm(), 1e-4 * size);
        EXPECT_LT(rod.impulse_mismatch(0, 0), 1e-6) << t;
    }
}

}  // namespace
}  // namespace hawser::worker
