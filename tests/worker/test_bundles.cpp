// Rods tied to each other: balance at rest, stiffness about the platform, one beam of two, the same
// line in one piece and in two, momentum and energy in motion (R:46).
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "rod/rod_group.hpp"
#include "rod_runs.hpp"

namespace hawser::worker {
namespace {

using namespace testing;

/// All lines of a case as one bundle.
template <class V>
struct Bundle {
    Case input;
    Sea sea;
    std::vector<RodPack<V>> rods;
    RodGroup<V> group;

    explicit Bundle(const Case& whole)
        : input(whole), sea(still_sea(input)), rods(packs(input, sea)), group(std::span(rods)) {}

    static std::vector<RodPack<V>> packs(const Case& input, const Sea& sea) {
        std::vector<RodPack<V>> out;
        for (int i = 0; i < static_cast<int>(input.lines.size()); ++i)
            out.emplace_back(input, sea, std::vector<int>{i});
        return out;
    }
    Status run(double duration, double interval,
               const std::function<void(double)>& look = nullptr) {
        const PlatformMotion still;
        const auto n = static_cast<int>(std::lround(duration / interval));
        for (int k = 0; k < n; ++k) {
            const double t0 = k * interval, t1 = (k + 1) * interval;
            const Status status = group.pass(t0, t1, MotionSpline(t0, still, t1, still));
            if (!status.ok()) return status;
            group.keep();
            if (look) look(t1);
        }
        return {};
    }
    void solve_fully() {
        for (RodPack<V>& rod : rods) {
            rod.newton.tolerance = 1e-10;
            rod.newton.max_iterations = 30;
            rod.newton.constraint_force = 0.1;
            rod.newton.constraint_part = 1e-7;
            rod.newton.constraint_iterations = 30;
        }
    }
};

LineEnd free_end() { return {}; }

/// Adds a line of one section.
Line& add_line(Case& input, int type, double length, int elements, const LineEnd& a,
               const LineEnd& b) {
    Line line;
    line.name = "line_" + std::to_string(input.lines.size());
    line.end_a = a, line.end_b = b;
    line.sections = {{.type = type, .length = length, .elements = elements}};
    input.lines.push_back(line);
    return input.lines.back();
}

/// Ties end B of a line to a point of another.
void tie_end_b(Case& input, std::size_t line, int other, double arc, double stiffness = 0.0) {
    Line& its = input.lines[line];
    its.end_b.kind = EndKind::line;
    its.constraints.push_back({.type = ConstraintType::ball_joint,
                               .name = "end_b",
                               .on_platform = false,
                               .other_line = other,
                               .other_arc = arc,
                               .is_end = true,
                               .arc_length = its.length(),
                               .stiffness = stiffness});
}

void slide(Case& input, std::size_t line, int other, double arc, double stiffness,
           double gap = 0.0) {
    input.lines[line].constraints.push_back({.type = ConstraintType::slider,
                                             .name = "slider" + std::to_string(arc),
                                             .on_platform = false,
                                             .other_line = other,
                                             .arc_length = arc,
                                             .stiffness = stiffness,
                                             .gap = gap});
}

/// Three light ropes from three points to a knot, the free end of the first.
struct Knot {
    static constexpr double EA = 1e8;
    static constexpr int elements = 6;
    std::array<Vec3, 3> support{Vec3(0, 0, 0), Vec3(80, 10, -60), Vec3(20, 90, -50)};
    std::array<double, 3> length{58, 59, 58};

    [[nodiscard]] Case input() const {
        Case c;
        c.environment.seabed.depth = 1e4;
        c.line_types = {plain_type(0.02, EA)};
        add_line(c, 0, length[0], elements, fixed_at(support[0]), free_end());
        for (std::size_t i = 1; i < 3; ++i) {
            add_line(c, 0, length[i], elements, fixed_at(support[i]), free_end());
            tie_end_b(c, i, 0, length[0]);
        }
        return c;
    }
    /// Of a tie, ten times that of an element.
    [[nodiscard]] double tie(std::size_t rope) const { return 10 * EA * elements / length[rope]; }
    /// The knot and the tensions that balance in it, ropes as springs; the two tied ropes in series
    /// with their ties.
    [[nodiscard]] std::pair<Vec3, Vec3> closed_form() const {
        Vec3 x = (support[0] + support[1] + support[2]) / 3, T;
        for (int i = 0; i < 200; ++i) {
            Vec3 f = Vec3::Zero();
            Mat3 K = Mat3::Zero();
            for (int k = 0; k < 3; ++k) {
                const auto u = static_cast<std::size_t>(k);
                const double stiffness = 1.0 / (length[u] / EA + (k > 0 ? 1.0 / tie(u) : 0.0));
                const Vec3 r = x - support[u];
                const Vec3 e = r.normalized();
                T[k] = stiffness * (r.norm() - length[u]);
                f -= T[k] * e;
                K += stiffness * e * e.transpose() +
                     std::max(T[k], 0.0) / r.norm() * (Mat3::Identity() - e * e.transpose());
            }
            x += K.inverse() * f;
        }
        return {x, T};
    }
};

TEST(Bundle, ThreeRopesBalanceInTheirKnot) {
    const Knot knot;
    Bundle<Single> three(knot.input());
    ASSERT_TRUE(three.group.equilibrium({}, false).ok());
    const auto [x, T] = knot.closed_form();
    ASSERT_GT(T.minCoeff(), 1e5);  // a case worth solving
    // ropes of 0.2 N/m sag by wL^2/8T = 1 mm: (wL/T)^2/24 of their length
    for (int i = 0; i < 3; ++i) {
        RodPack<Single>& rod = three.rods[static_cast<std::size_t>(i)];
        EXPECT_NEAR(rod.tension_a(0), T[i], 1e-4 * T[i]) << i;
        const double to_knot = i > 0 ? T[i] / knot.tie(static_cast<std::size_t>(i)) : 0.0;
        EXPECT_NEAR((rod.node_position(0, rod.elements()) - x).norm(), to_knot, 1e-3) << i;
    }
    // the tied ends pull the knot as hard as the first rope holds it
    const Vec3 sum = three.rods[1].constraint_force(0, 0) + three.rods[2].constraint_force(0, 0);
    const RodPack<Single>& first = three.rods[0];
    EXPECT_NEAR(sum.norm(), T[0], 1e-4 * T[0]);
    EXPECT_NEAR(sum.normalized().dot(first.direction_a(0)), -1.0, 1e-6);
    EXPECT_NEAR(three.rods[1].tension_b(0), T[1], 1e-4 * T[1]);
}

TEST(Bundle, ItsStiffnessIsMinusTheDerivativeOfItsLoads) {  // R:25, R:46
    Knot knot;
    Case input = knot.input();
    input.line_types[0] = plain_type(40.0, 1e8, 2e5);  // heavy: it sags
    for (const std::size_t i : {0, 1}) input.lines[i].end_a.kind = EndKind::platform;
    Bundle<Quad> three(input);
    const auto moved = [](int motion, double by) {
        PlatformMotion m;
        (motion < 3 ? m.position[motion] : m.angles[motion - 3]) = by;
        return m;
    };
    ASSERT_TRUE(three.group.equilibrium({}, false).ok());
    std::array<Mat6, 3> K;
    for (std::size_t p = 0; p < 3; ++p) K[p] = three.group.stiffness(p, 0, Vec3::Zero());
    EXPECT_EQ(K[2].norm(), 0.0);  // it is not on the platform
    const Mat6 alone = three.rods[1].stiffness(0, Vec3::Zero());
    EXPECT_GT((K[1] - alone).norm(), 0.05 * K[1].norm());  // the other ropes matter
    for (int j = 0; j < 6; ++j) {
        const double h = j < 3 ? 0.01 : 0.0005;
        std::array<Vec6, 2> up, down;
        ASSERT_TRUE(three.group.equilibrium(moved(j, h), false).ok());
        for (std::size_t p = 0; p < 2; ++p) up[p] = three.rods[p].wrench(0, moved(j, h).position);
        ASSERT_TRUE(three.group.equilibrium(moved(j, -h), false).ok());
        for (std::size_t p = 0; p < 2; ++p)
            down[p] = three.rods[p].wrench(0, moved(j, -h).position);
        for (std::size_t p = 0; p < 2; ++p) {
            const Vec6 column = (down[p] - up[p]) / (2 * h);
            EXPECT_LT((K[p].col(j) - column).head<3>().norm(), 5e-4 * column.head<3>().norm() + 2.0)
                << p << " " << j << "\n"
                << K[p].col(j).transpose() << "\n"
                << column.transpose();
            EXPECT_LT((K[p].col(j) - column).tail<3>().norm(),
                      5e-4 * column.tail<3>().norm() + 200.0)
                << p << " " << j << "\n"
                << K[p].col(j).transpose() << "\n"
                << column.transpose();
        }
    }
}

/// Two pinned horizontal beams in one place, tied across at every node between.
Case pipe_in_pipe(double EI_outer, double EI_inner, double m_outer, double m_inner, int elements,
                  double gap = 0.0) {
    const double L = 20.0;
    Case input;
    input.environment.seabed.depth = 1e4;
    input.line_types = {plain_type(m_outer, 1e9, EI_outer), plain_type(m_inner, 1e9, EI_inner)};
    for (const int type : {0, 1})
        add_line(input, type, L, elements, fixed_at({0, 0, 0}), fixed_at({L, 0, 0}));
    for (int n = 1; n < elements; ++n) slide(input, 1, 0, L * n / elements, 1e9, gap);
    return input;
}

TEST(Bundle, APipeInAPipeBendsAsOneBeamOfBoth) {
    // 5 q L^4/(384 (EI_o + EI_i)); the loads go from one to the other at the nodes, h^2/L^2
    Bundle<Single> pair(pipe_in_pipe(1e7, 2e7, 3.0, 0.5, 20));
    ASSERT_TRUE(pair.group.equilibrium({}, false).ok());
    const double sag = 5 * 3.5 * 9.80665 * std::pow(20.0, 4) / (384 * 3e7);
    for (const RodPack<Single>& rod : pair.rods)
        EXPECT_NEAR(-rod.node_position(0, 10).z(), sag, 5e-3 * sag);
    // what the outer pipe weighs beyond its share of the stiffness goes through the sliders
    double through = 0.0;
    for (int c = 0; c < pair.rods[1].constraint_count(); ++c)
        through += pair.rods[1].constraint_force(0, c).z();
    const double handed_on = (3.0 - 3.5 / 3) * 9.80665 * 20;
    EXPECT_NEAR(-through, handed_on,
                0.06 * handed_on);  // the half elements at the ends keep theirs
}

TEST(Bundle, APipeWithPlayTouchesWhereItWouldLeaveTheOther) {
    // with 0.5 mm of play the inner pipe, alone stiff enough, takes what is beyond the play
    const double g = 9.80665, L4 = std::pow(20.0, 4);
    Bundle<Single> pair(pipe_in_pipe(1e7, 2e7, 3.0, 0.5, 20, 5e-4));
    ASSERT_TRUE(pair.group.equilibrium({}, false).ok());
    const double outer = -pair.rods[0].node_position(0, 10).z(),
                 inner = -pair.rods[1].node_position(0, 10).z();
    EXPECT_NEAR(outer - inner, 5e-4, 2e-5);  // the contact gives way by micrometres
    EXPECT_LT(outer, 5 * 3.0 * g * L4 / (384 * 1e7));
    EXPECT_GT(inner, 5 * 0.5 * g * L4 / (384 * 2e7));
    for (int c = 0; c < pair.rods[1].constraint_count(); ++c) {
        const double opening = pair.rods[1].constraint_opening(0, c);
        EXPECT_EQ(pair.rods[1].constraint_force(0, c).norm() > 0.0, opening < 0.0) << c;
    }
}

TEST(Bundle, TwinsMoveAsOneAndTheirTiesRest) {
    LineType pipe = plain_type(100.0, 5e8, 1e7);
    pipe.displaced_area = 0.05, pipe.drag_normal = 1.0, pipe.added_mass_normal = 1.0;
    const LineEnd top = moving(fixed_at({0, 0, 0}), {1.0, 0, 0.2}, 6.0),
                  foot = fixed_at({3, 0, -149});
    Case input = one_line(pipe, 148.5, 15, top, foot);
    input.environment.seabed.depth = 200;
    Case alone = input;
    input.lines.push_back(input.lines[0]);
    for (const double arc : {33.0, 75.0, 120.0}) slide(input, 1, 0, arc, 1e8);
    Bundle<Single> twins(input), one(alone);
    ASSERT_TRUE(twins.group.equilibrium({}, false).ok());
    ASSERT_TRUE(one.group.equilibrium({}, false).ok());
    ASSERT_TRUE(twins.run(5, 0.5).ok());
    ASSERT_TRUE(one.run(5, 0.5).ok());
    for (int n = 0; n <= 15; ++n)
        EXPECT_LT((twins.rods[1].node_position(0, n) - one.rods[0].node_position(0, n)).norm(),
                  1e-7)
            << n;
    for (int c = 0; c < 3; ++c) EXPECT_LT(twins.rods[1].constraint_force(0, c).norm(), 1.0) << c;
}

/// A sagging line between two points, its top shaken, in one piece or tied together at 60 m.
Case sagging(bool in_two, double amplitude) {
    LineType rope = plain_type(50.0, 5e7);
    rope.displaced_area = 0.01, rope.drag_normal = 1.2, rope.added_mass_normal = 1.0;
    rope.damping_ratio = 0.01;
    const LineEnd top = moving(fixed_at({0, 0, -10}), {amplitude, 0.3 * amplitude, 0}, 8.0),
                  foot = fixed_at({90, 0, -110});
    Case input = one_line(rope, 140, 28, top, foot);
    input.analysis.dynamics.ramp = 4.0;
    if (!in_two) return input;
    input.line_types.push_back(rope);
    input.lines.clear();
    add_line(input, 0, 80, 16, foot, free_end());
    add_line(input, 1, 60, 12, top, free_end());
    tie_end_b(input, 1, 0, 80.0, 1e10);
    return input;
}

TEST(Bundle, ALineInTwoPiecesIsTheLineInOne) {
    for (const double amplitude : {0.0, 2.0}) {
        Case one_piece = sagging(false, amplitude), two_pieces = sagging(true, amplitude);
        for (Case* input : {&one_piece, &two_pieces}) input->line_types[0].damping_ratio = {};
        two_pieces.line_types[1].damping_ratio = {};
        Bundle<Single> whole(one_piece), tied(two_pieces);
        ASSERT_TRUE(whole.group.equilibrium({}, false).ok());
        ASSERT_TRUE(tied.group.equilibrium({}, false).ok());
        const double T = whole.rods[0].tension_a(0);
        if (amplitude == 0.0) {
            // the tie of 10 GN/m opens by T/K: 1e-6 m; slopes are free to differ in the joint
            EXPECT_NEAR(tied.rods[1].tension_a(0), T, 1e-5 * T);
            for (int n = 0; n <= 12; ++n)
                EXPECT_LT(
                    (tied.rods[1].node_position(0, n) - whole.rods[0].node_position(0, n)).norm(),
                    1e-3)
                    << n;
            continue;
        }
        Record a, b;
        ASSERT_TRUE(
            whole.run(20, 0.1, [&](double t) { a.add(t, whole.rods[0].tension_a(0)); }).ok());
        ASSERT_TRUE(tied.run(20, 0.1, [&](double t) { b.add(t, tied.rods[1].tension_a(0)); }).ok());
        EXPECT_GT(a.deviation(), 0.05 * T);
        EXPECT_LT(rms_difference(a, b), 0.01 * a.deviation());  // the meshes' own error
    }
}

TEST(Bundle, QuasiStaticLinesAreAtRestTogether) {
    // A pass of a pair whose top has moved ends where the static solution of that place is.
    Case input = sagging(true, 2.0);
    input.analysis.dynamics.line_model = LineModel::quasi_static;
    input.analysis.dynamics.ramp = 0.0;
    for (LineType& type : input.line_types) type.damping_ratio = {};
    Bundle<Single> moved(input);
    ASSERT_TRUE(moved.group.equilibrium({}, false).ok());
    ASSERT_TRUE(moved.run(2.0, 0.25).ok());
    Case there = input;
    LineEnd& top = there.lines[1].end_a;
    top.motion.reset();
    top.position += Vec3(2.0, 0.6, 0.0);  // a quarter of the period of 8 s
    Bundle<Single> still(there);
    ASSERT_TRUE(still.group.equilibrium({}, false).ok());
    for (const std::size_t i : {0, 1}) {
        const double T = still.rods[i].tension_a(0);
        EXPECT_NEAR(moved.rods[i].tension_a(0), T, 1e-5 * T) << i;
    }
    EXPECT_LT((moved.rods[1].constraint_force(0, 0) - still.rods[1].constraint_force(0, 0)).norm(),
              1e-5 * still.rods[1].tension_a(0) + 10.0);
}

TEST(Packing, BundlesOfOnePatternStandLaneByLane) {
    // three knots of three ropes, and two ropes by themselves
    Case input;
    for (int i = 0; i < 3; ++i) {
        const Case one = Knot{}.input();
        if (i == 0) input = one, input.lines.clear();
        for (Line line : one.lines) {
            for (LineConstraint& c : line.constraints) c.other_line += 3 * i;
            input.lines.push_back(line);
        }
    }
    input.lines[8].sections[0].elements = 9;  // the last knot is of another pattern
    for (int i = 0; i < 2; ++i)
        add_line(input, 0, 50, 6, fixed_at({0, 0, 0}), fixed_at({30, 0, -30}));
    const std::vector<std::vector<int>> bundles{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9}, {10}};
    EXPECT_EQ(bundles_of(input), bundles);
    const std::vector<Pack> packs = packs_of(input);
    const std::vector<std::vector<int>> lines{{0, 3}, {1, 4}, {2, 5}, {6}, {7}, {8}, {9, 10}};
    const std::vector<int> groups{0, 0, 0, 1, 1, 1, 2};
    ASSERT_EQ(packs.size(), lines.size());
    for (std::size_t p = 0; p < packs.size(); ++p) {
        EXPECT_EQ(packs[p].lines, lines[p]) << p;
        EXPECT_EQ(packs[p].group, groups[p]) << p;
    }
    for (const int workers : {1, 2, 3, 5}) {
        const std::vector<int> worker = assign(packs, workers);
        for (std::size_t p = 1; p < packs.size(); ++p)  // a group is never torn apart
            if (groups[p] == groups[p - 1]) {
                EXPECT_EQ(worker[p], worker[p - 1]) << workers;
            }
    }
    EXPECT_NE(assign(packs, 2).front(), assign(packs, 2)[3]);
}

/// Momentum, angular momentum about 0, energy of a rod.
struct Motion {
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
    double energy = 0.0;
    void add(const RodPack<Single>& rod, double L, double m, double EA, double EI) {
        const NodeState<Single>* node = rod.state().nodes();
        const Multiplier<Single>* lambda = rod.state().lambda();
        for (int e = 0; e < rod.elements(); ++e) {
            const NodeState<Single>&a = node[e], &b = node[e + 1];
            for (std::size_t g = 0; g < gauss_points; ++g) {
                const auto A = hermite(gauss_xi[g]);
                const auto P = quadratic(gauss_xi[g]);
                const auto c = reduced_curvature(gauss_xi[g]);
                const auto at = [&](const Vec3& ra, const Vec3& da, const Vec3& rb,
                                    const Vec3& db) {
                    return Vec3(A[0] * ra + A[1] * L * da + A[2] * rb + A[3] * L * db);
                };
                const Vec3 r = at(vec(a.r), vec(a.d), vec(b.r), vec(b.d)),
                           v = at(vec(a.v), vec(a.vd), vec(b.v), vec(b.vd));
                const Vec3 bend =
                    (c[0] * (vec(b.r) - vec(a.r)) + c[1] * L * vec(a.d) + c[2] * L * vec(b.d)) /
                    (L * L);
                const double l = P[0] * lambda[2 * e].now[0] + P[1] * lambda[2 * e + 1].now[0] +
                                 P[2] * lambda[2 * e + 2].now[0];
                const double T = l / (1 - l / EA), w = L * gauss_weight[g];
                linear += w * m * v;
                angular += w * m * r.cross(v);
                energy += w * (0.5 * m * v.squaredNorm() + 0.5 * T * T / EA +
                               0.5 * EI * bend.squaredNorm());
            }
        }
    }
};

/// Two rods crossed in the air, the second tied to the first, in a void.
struct Crossed {
    Bundle<Single> pair;
    double L = 1.0, m = 20, EA = 1e6, EI = 2e4;

    static Case input(double step, bool slider) {
        Case c;
        c.environment.seabed.depth = 1e5;
        c.environment.water.density = c.environment.water.gravity = 0.0;
        c.analysis.dynamics.line_step = step;
        c.analysis.dynamics.rod_scheme.type = RodSchemeType::adams_moulton;
        c.line_types = {plain_type(20, 1e6, 2e4)};
        add_line(c, 0, 10, 10, free_end(), free_end());
        add_line(c, 0, 8, 8, free_end(), free_end());
        LineConstraint tie{.type = slider ? ConstraintType::slider : ConstraintType::ball_joint,
                           .name = "tie",
                           .on_platform = false,
                           .other_line = 0,
                           .other_arc = 5.5,
                           .arc_length = 2.4,
                           .stiffness = 1e5,
                           .damping = 50.0};
        c.lines[1].constraints = {tie};
        return c;
    }
    Crossed(double step, bool slider) : pair(input(step, slider)) {
        pair.solve_fully();
        // rod 0 along x, arc 5.5 at 0; rod 1 along y, arc 2.4 at 0; both turn about z and drift
        set(0, 10, Vec3(-4.5, 0, 0), Vec3::UnitX());
        set(1, 8, Vec3(0, -5.6, 0), Vec3::UnitY());
    }
    void set(std::size_t i, int N, const Vec3& from, const Vec3& along) {
        RodPack<Single>& rod = pair.rods[i];
        std::vector<CatenaryNode> nodes;
        for (int n = 0; n <= N; ++n)
            nodes.push_back({.position = from + n * along, .tangent = along, .tension = 0.0});
        rod.set_guess(0, nodes);
        const Vec3 spin(0.3, 0, 0.9);
        for (int n = 0; n <= N; ++n) {
            const Vec3 r = from + n * along;
            NodeState<Single>& x = rod.kept().nodes()[n];
            // the second rod slides and bends away
            const Vec3 own = i == 0 ? Vec3::Zero() : Vec3(0, 0.2, 0);
            x.v = lanes_of(Vec3(0.5, 0.1, 0.2) + own + spin.cross(r));
            x.vd = lanes_of(spin.cross(along));
            x.a = x.A = lanes_of(spin.cross(spin.cross(r)));
            x.ad = x.Ad = lanes_of(spin.cross(spin.cross(along)));
        }
    }
    [[nodiscard]] Motion motion() const {
        Motion out;
        for (const RodPack<Single>& rod : pair.rods) out.add(rod, L, m, EA, EI);
        out.energy +=
            pair.rods[1].constraint_energy(0, 0) + pair.rods[1].constraint_dissipated(0, 0);
        return out;
    }
};

class CrossedRods : public ::testing::TestWithParam<bool> {};

TEST_P(CrossedRods, KeepTheirMomentumAndEnergy) {
    double last = 0.0;
    for (const double step : {0.004, 0.002}) {
        Crossed rods(step, GetParam());
        ASSERT_TRUE(rods.pair.run(step, step).ok());
        const Motion before = rods.motion();
        double pulled = 0.0;
        ASSERT_TRUE(rods.pair
                        .run(2.0, step,
                             [&](double) {
                                 pulled = std::max(pulled,
                                                   rods.pair.rods[1].constraint_force(0, 0).norm());
                             })
                        .ok());
        const Motion after = rods.motion();
        EXPECT_GT(pulled, 100.0);  // the tie has worked
        // action and reaction: to Newton's tolerance
        EXPECT_LT((after.linear - before.linear).norm(), 1e-6 * before.linear.norm());
        const double turned = (after.angular - before.angular).norm() / before.angular.norm();
        EXPECT_LT(turned, 2e-3) << step;
        const double lost = std::abs(after.energy / before.energy - 1);
        EXPECT_LT(lost, 2e-2) << step;
        if (last > 0.0) {
            EXPECT_LT(lost, 0.5 * last + 1e-4);
        }
        last = lost;
    }
}

INSTANTIATE_TEST_SUITE_P(JointAndSlider, CrossedRods, ::testing::Bool());

TEST(Bundle, ItsBitsDoNotDependOnTheBundlesBeside) {
    // Four knots of different stiffness and sea room in one group, and each by itself.
    Case input;
    for (int i = 0; i < 4; ++i) {
        Knot knot;
        knot.support[2].y() += 3.0 * i;
        knot.length[1] += 2.0 * i;
        Case one = knot.input();
        one.line_types[0] = plain_type(40.0, 1e7, 100.0);
        // a strap between two of the ropes, in every knot at other elements
        one.lines[2].constraints.push_back({.type = ConstraintType::ball_joint,
                                            .name = "strap",
                                            .on_platform = false,
                                            .other_line = 1,
                                            .other_arc = 12.0 + 12.0 * i,
                                            .arc_length = 50.0 - 11.0 * i,
                                            .stiffness = 500.0});
        if (i == 0) input = one, input.lines.clear();
        for (Line& line : one.lines) {
            if (i > 0 && line.end_a.position == knot.support[1])
                line.end_a = moving(line.end_a, {0.5, 0.2, 0.1 * i}, 5.0 + i);
            for (LineConstraint& c : line.constraints) c.other_line += 3 * i;
            if (i == 2) line.time_step = 0.03;
            input.lines.push_back(line);
        }
    }
    input.analysis.dynamics.ramp = 1.0;
    const Sea sea = still_sea(input);
    const auto run_with = [&](const std::vector<int>& bundles) {
        std::vector<RodPack<Quad>> rods;
        for (int k = 0; k < 3; ++k) {
            std::vector<int> lines;
            for (const int b : bundles) lines.push_back(3 * b + k);
            rods.emplace_back(input, sea, lines);
        }
        RodGroup<Quad> group{std::span(rods)};
        EXPECT_TRUE(group.equilibrium({}, false).ok());
        const PlatformMotion still;
        for (int k = 0; k < 8; ++k) {
            EXPECT_TRUE(group
                            .pass(0.5 * k, 0.5 * k + 0.5,
                                  MotionSpline(0.5 * k, still, 0.5 * k + 0.5, still))
                            .ok());
            group.keep();
        }
        std::vector<std::vector<double>> bits(bundles.size());
        for (std::size_t i = 0; i < bundles.size(); ++i)
            for (const RodPack<Quad>& rod : rods)
                for (const Quad& v : rod.kept().block()) bits[i].push_back(v[static_cast<int>(i)]);
        return bits;
    };
    const auto together = run_with({0, 1, 2, 3});
    for (const std::vector<int>& bundles :
         std::vector<std::vector<int>>{{0}, {1}, {2}, {3}, {3, 1}}) {
        const auto apart = run_with(bundles);
        for (std::size_t i = 0; i < bundles.size(); ++i) {
            const auto& a = apart[i];
            const auto& b = together[static_cast<std::size_t>(bundles[i])];
            EXPECT_EQ(std::memcmp(a.data(), b.data(), 8 * a.size()), 0) << bundles[i];
        }
    }
}

}  // namespace
}  // namespace hawser::worker
