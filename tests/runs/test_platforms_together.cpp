// Several platforms in one case: whole runs, static start, offset curve, natural modes.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "../master/spar_hull.hpp"
#include "coupled_modes.hpp"
#include "io/hdf5.hpp"
#include "io/link.hpp"
#include "modes_report.hpp"
#include "resting_lines.hpp"
#include "roles.hpp"
#include "static_start.hpp"
#include "statics_report.hpp"

namespace hawser::master {
namespace {

namespace fs = std::filesystem;
constexpr double g = 9.80665;

/// A buoy with 2000 t of added mass; a force bears its weight, matrices hold it.
Platform buoy(const std::string& name, double x, double surge_stiffness, double mass = 2e6) {
    Platform p;
    p.name = name;
    p.key_path = "platforms." + name;
    p.position = {x, 0.0, 0.0};
    p.mass = mass;
    p.forces = {{.name = "float", .force = Vec3(0, 0, mass * g)}};
    p.radii_of_gyration = {10, 10, 10};
    HydroMatrix& matrix = p.hydrodynamics.matrix.emplace();
    matrix.added_mass.diagonal() << 2e6, 2e6, 2e6, 2e8, 2e8, 2e8;
    matrix.stiffness.diagonal() << 0, 0, 4e6, 2e9, 2e9, 0;
    p.stiffness.diagonal() << surge_stiffness, 4e5, 0, 0, 0, 1e7;
    return p;
}

/// Two of them 200 m apart, in still water, without lines.
Case two_buoys(double stiffness_1 = 3e5, double stiffness_2 = 3e5, double second_mass = 2e6) {
    Case c;
    c.name = "two";
    c.environment.seabed.depth = 1000.0;
    c.platform = buoy("near", 100.0, stiffness_1);
    c.further_platforms = {buoy("far", 300.0, stiffness_2, second_mass)};
    Dynamics& d = c.analysis.dynamics;
    d.duration = 40.0;
    d.platform_step = 0.25;
    d.ramp = 0.0;
    d.statistics_from = 0.0;
    c.output.interval = 0.5;
    c.output.platform_loads = true;
    return c;
}

/// A line between the two, from O to O, without drag or buoyancy.
void join(Case& c, double mass, double EA, double length, int elements) {
    LineType type;
    type.name = "hawser";
    type.category = "general";
    type.mass = mass;
    type.EA = EA;
    type.outer_diameter = type.drag_diameter = 0.1;
    type.added_mass_normal = 0.0;
    c.line_types = {type};
    Line line;
    line.name = "hawser";
    line.family = "hawser";
    line.sections = {{.type = 0, .length = length, .elements = elements}};
    line.end_a = {.kind = EndKind::platform};
    line.end_b = {.kind = EndKind::platform, .platform = 1};
    c.lines = {line};
    c.analysis.dynamics.line_step = 0.05;
}

struct Folder {
    fs::path path;
    explicit Folder(const std::string& name)
        : path(fs::path(testing::TempDir()) / ("hawser_together_" + name)) {
        fs::remove_all(path);
    }
    ~Folder() { fs::remove_all(path); }
};

ExitCode run(const Case& input, const Folder& folder) {
    RunRequest request;
    request.folder = folder.path;
    request.progress = ProgressStyle::none;
    request.quiet = true;
    io::Link alone;
    return run_master(input, request, alone);
}

std::vector<double> column(const Folder& folder, const std::string& path, int i) {
    return io::Hdf5File::open(folder.path / "result.h5").dataset(path).read_column(i);
}

/// The motions of one platform with and without the other in the case.
void expect_alike(const Folder& both, const Folder& alone, const std::string& name, double least) {
    for (int i = 0; i < 6; ++i) {
        const std::string path = "/platform/" + name + "/position";
        const std::vector<double> x = column(both, path, i), y = column(alone, path, i);
        ASSERT_EQ(x.size(), y.size());
        double most = 0.0;
        for (std::size_t n = 0; n < x.size(); ++n) {
            // Both static starts are within the tolerance of 1e-6 m, as a rule far within it
            EXPECT_NEAR(x[n], y[n], 1e-7) << name << " " << i << " at sample " << n;
            most = std::max(most, std::abs(x[n]));
        }
        if (i == 0 || i == 2) {
            EXPECT_GT(most, least) << name << " " << i;
        }
    }
}

TEST(PlatformsTogether, WithoutCommonLinesMoveAsEachAlone) {
    Case c = two_buoys();
    c.environment.waves = {
        {.type = WaveType::jonswap, .Hs = 3.0, .Tp = 9.0, .seed = 5, .components = 15}};
    c.environment.current = Current{.heading = 0.0, .profile = {{.depth = 0.0, .speed = 0.5}}};
    for (Platform* p : {&*c.platform, &c.further_platforms[0]}) {
        p->members = {{.name = "column",
                       .from = {0, 0, -20},
                       .to = {0, 0, 8},
                       .diameter = 8.0,
                       .Cd = 1.0,
                       .displaced_area = 16 * M_PI}};
        p->mass.reset();
        p->forces.clear();
        p->centre_of_gravity.z() = -12.0;
        p->initial.position = {1.0, 0.5, -0.5};
    }
    c.further_platforms[0].mass = 1.02 * 1025 * 16 * M_PI * 20;  // floats a little deeper
    Line mooring;
    mooring.name = mooring.family = "ml";
    join(c, 50.0, 1e8, 400.0, 10);
    c.lines[0].end_b = {.kind = EndKind::anchor, .position = {-200, 50, -200}};
    c.lines[0].name = c.lines[0].family = "near_ml";
    c.lines.push_back(c.lines[0]);
    c.lines[1].name = c.lines[1].family = "far_ml";
    c.lines[1].end_a.platform = 1;
    c.lines[1].end_b.position = {600, 50, -200};
    c.analysis.dynamics.duration = 10.0;
    Case near = c, far = c;
    near.further_platforms.clear();
    near.lines.pop_back();
    far.platform = c.further_platforms[0];
    far.further_platforms.clear();
    far.lines = {c.lines[1]};
    far.lines[0].end_a.platform = 0;
    const Folder both("both"), one("one"), other("other");
    ASSERT_EQ(run(c, both), ExitCode::done);
    ASSERT_EQ(run(near, one), ExitCode::done);
    ASSERT_EQ(run(far, other), ExitCode::done);
    expect_alike(both, one, "near", 0.3);
    expect_alike(both, other, "far", 0.3);
    // each has its ledger, with its own lines alone
    const io::Hdf5File result = io::Hdf5File::open(both.path / "result.h5");
    for (const char* name : {"near", "far"}) {
        const std::vector<double> residual =
            result.read("/ledger/" + std::string(name) + "/residual");
        const std::vector<double> mean = result.read("/ledger/" + std::string(name) + "/mean");
        ASSERT_EQ(mean.size() % 6, 0U);
        EXPECT_EQ(mean.size() / 6, static_cast<std::size_t>(load_count));  // one family of lines
        EXPECT_LT(std::abs(residual[2]), 1e-4 * 2e6 * g) << name;
    }
}

TEST(PlatformsTogether, EachTellsTheSeaAtItsOwnPlace) {
    // deep water: A cos(w t - k x cos(heading)) with k = w^2/g
    Case c = two_buoys();
    const double A = 1.5, T = 9.0, heading = 0.6;
    c.environment.waves = {{.type = WaveType::airy, .H = 2 * A, .T = T, .heading = heading}};
    c.analysis.dynamics.duration = 10.0;
    c.output.environment = true;
    const Folder folder("elevation");
    ASSERT_EQ(run(c, folder), ExitCode::done);
    const io::Hdf5File result = io::Hdf5File::open(folder.path / "result.h5");
    const std::vector<double> t = result.read("/time");
    const double w = 2 * M_PI / T, k = w * w / g;
    for (const auto& [name, x] : {std::pair{"near", 100.0}, std::pair{"far", 300.0}}) {
        const std::vector<double> eta =
            result.read("/platform/" + std::string(name) + "/elevation");
        ASSERT_EQ(eta.size(), t.size());
        for (std::size_t n = 0; n < t.size(); ++n)
            EXPECT_NEAR(eta[n], A * std::cos(w * t[n] - k * x * std::cos(heading)), 1e-6);
    }
}

TEST(PlatformsTogether, SwingApartWithTheReducedMassAndKeepMomentumAndEnergy) {  // P:3
    // Nothing but a taut line of 5 kg between two free masses: k = EA/L, w^2 = k (1/M1 + 1/M2).
    // The pull at rest is taken by constant forces.
    Case c = two_buoys(0.0, 0.0, 1e6);
    const double EA = 1e8, L = 199.0, k = EA / L, T = EA * (200.0 / L - 1.0);
    join(c, 5.0 / L, EA, L, 10);
    c.environment.water.gravity = g;
    Platform &one = *c.platform, &two = c.further_platforms[0];
    one.forces.push_back({.name = "hold", .force = Vec3(-T, 0, 0)});
    two.forces.push_back({.name = "hold", .force = Vec3(T, 0, 0)});
    two.hydrodynamics.matrix->added_mass(0, 0) = 0.5e6;
    const double M1 = 4e6, M2 = 1.5e6;
    one.initial.position.x() = -0.3;
    one.initial.velocity.x() = 0.1;
    two.initial.position.x() = 0.2;
    const Folder folder("pair");
    ASSERT_EQ(run(c, folder), ExitCode::done);
    const std::vector<double> x1 = column(folder, "/platform/near/position", 0),
                              x2 = column(folder, "/platform/far/position", 0),
                              v1 = column(folder, "/platform/near/velocity", 0),
                              v2 = column(folder, "/platform/far/velocity", 0);
    const std::vector<double> t = io::Hdf5File::open(folder.path / "result.h5").read("/time");
    const double w = std::sqrt(k * (1 / M1 + 1 / M2));
    const double x0 = x2.front() - x1.front(), momentum = M1 * v1.front() + M2 * v2.front();
    EXPECT_NEAR(x1.front(), -0.3, 1e-3);  // from the design positions
    EXPECT_NEAR(x2.front(), 0.2, 1e-3);
    ASSERT_NEAR(x0, 0.5, 1e-3);  // the line's weight draws the two together a little
    const auto energy = [&](std::size_t n) {
        return 0.5 *
               (M1 * v1[n] * v1[n] + M2 * v2[n] * v2[n] + k * (x2[n] - x1[n]) * (x2[n] - x1[n]));
    };
    EXPECT_GT(t.back() * w, 2 * M_PI);  // more than a period
    for (std::size_t n = 0; n < t.size(); ++n) {
        // RK4 with w D = 0.17: (w D)^5/120 a step of the amplitude, (w D)^6/72 of the energy; the
        // line's mass weighs 1e-6
        const double apart = x0 * std::cos(w * t[n]) - 0.1 / w * std::sin(w * t[n]);
        EXPECT_NEAR(x2[n] - x1[n], apart, 2e-3) << t[n];
        EXPECT_NEAR(M1 * v1[n] + M2 * v2[n], momentum, 1e-3 * momentum) << t[n];
        EXPECT_NEAR(energy(n), energy(0), 5e-3 * energy(0)) << t[n];
    }
    const std::vector<double> on_one = column(folder, "/platform/near/loads/lines", 0),
                              on_two = column(folder, "/platform/far/loads/lines", 0);
    for (std::size_t n = 0; n < t.size(); ++n)  // but for what moves the 5 kg
        EXPECT_NEAR(on_one[n] + on_two[n], 0.0, 1e-4 * T) << t[n];
}

/// Horizontal tension of an inextensible catenary of weight w per length L over a span.
double catenary_tension(double w, double L, double span) {
    double low = 1e2, high = 1e8;
    for (int i = 0; i < 200; ++i) {
        const double H = std::sqrt(low * high);
        (2 * H / w * std::sinh(w * span / (2 * H)) > L ? low : high) = H;
    }
    return low;
}

TEST(PlatformsTogether, RestWhereACatenaryPullsAgainstTheirSprings) {  // K:25
    const double k1 = 3e5, k2 = 2e5, m = 120.0, L = 210.0;
    Case c = two_buoys(k1, k2);
    join(c, m, 1e11, L, 40);
    std::vector<Hull> hulls;
    for (int k = 0; k < 2; ++k) hulls.emplace_back(c, nullptr, k);
    const std::unique_ptr<RestingLines> lines = make_resting_lines(c);
    const StaticStart start = static_start(c, hulls, *lines);
    // k1 x1 = H = -k2 x2, span = 200 - x1 + x2
    double low = 1e2, high = 2e6;
    for (int i = 0; i < 100; ++i) {
        const double H = 0.5 * (low + high);
        (catenary_tension(m * g, L, 200 - H / k1 - H / k2) > H ? low : high) = H;
    }
    const double x1 = start.equilibrium[0].position.x() - 100,
                 x2 = start.equilibrium[1].position.x() - 300;
    // the two hang at different depths by some centimetres, the elements are 5 m long
    EXPECT_NEAR(k1 * x1, low, 1e-3 * low);
    EXPECT_NEAR(-k2 * x2, low, 1e-3 * low);
    EXPECT_NEAR(k1 * x1, -k2 * x2, 1e-6 * low);
    const double weight = m * g * L;
    EXPECT_NEAR(start.vertical_line_load[0] + start.vertical_line_load[1], weight, 1e-4 * weight);
    EXPECT_TRUE(start.stability[0].stable() && start.stability[1].stable());
    EXPECT_EQ(start.modes.size(), 12U);
}

TEST(PlatformsTogether, HaveTheNaturalPeriodsOfTwoMassesAndThreeSprings) {  // K:26
    const double k1 = 3e5, k2 = 5e5, EA = 8e7, L = 199.0, k = EA / L, T = EA * (200.0 / L - 1.0);
    Case c = two_buoys(k1, k2, 1e6);
    join(c, 1e-3, EA, L, 10);
    c.platform->forces.push_back({.name = "hold", .force = Vec3(-T, 0, 0)});
    c.further_platforms[0].forces.push_back({.name = "hold", .force = Vec3(T, 0, 0)});
    const ModesReport report = find_modes(c, {});
    const double M1 = 4e6, M2 = 3e6;
    const auto surge = [&](double of_1, double of_2, double between) {
        Eigen::Matrix2d K, M;
        K << of_1 + between, -between, -between, of_2 + between;
        M << M1, 0, 0, M2;
        return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d>(K, M).eigenvalues().eval();
    };
    ASSERT_EQ(report.platforms, (std::vector<std::string>{"near", "far"}));
    ASSERT_EQ(report.coupled.size(), 12U);
    std::vector<double> found, swayed;
    for (int p = 0; p < 2; ++p)
        for (int i = 0; i < 6; ++i) {
            const CoupledMode& mode = report.coupled[std::size_t(6 * p + i)];
            EXPECT_EQ(mode.platform, p);
            EXPECT_EQ(mode.motion, i);
            ASSERT_EQ(mode.all.size(), 2U);
            EXPECT_EQ(mode.all[std::size_t(p)], mode.shape);
            if (i == 0) found.push_back(mode.omega_squared);
            if (i == 1) swayed.push_back(mode.omega_squared);
        }
    std::sort(found.begin(), found.end());
    std::sort(swayed.begin(), swayed.end());
    const Eigen::Vector2d exact = surge(k1, k2, k), across = surge(4e5, 4e5, T / 200.0);
    for (int i = 0; i < 2; ++i) {
        EXPECT_NEAR(found[std::size_t(i)] / exact[i], 1.0, 1e-4) << i;
        EXPECT_NEAR(swayed[std::size_t(i)] / across[i], 1.0, 1e-3) << i;
    }
    EXPECT_NEAR(report.coupled[2].period().value(), 2 * M_PI * std::sqrt(4e6 / 4e6), 0.01);
}

TEST(CoupledModesOfTwo, SwingTogetherAndApart) {  // K:26
    // Equal masses on equal springs: w^2 = k/m with both alike, (k + 2 k')/m against each other
    const double m = 5.0, k = 2.0, between = 0.7;
    Eigen::MatrixXd K = Eigen::MatrixXd::Identity(12, 12) * 50.0;
    K(0, 0) = K(6, 6) = k;
    Eigen::MatrixXd S = Eigen::MatrixXd::Zero(12, 12);
    S(0, 0) = S(6, 6) = between;
    S(0, 6) = S(6, 0) = -between;
    Eigen::MatrixXd M = Eigen::MatrixXd::Identity(12, 12) * m;
    for (int i = 1; i < 6; ++i) M(i, i) = M(6 + i, 6 + i) = m * (1 + 0.1 * i);
    const auto modes = coupled_modes(
        K, [&](double) { return M; }, [&](double) { return S; });
    std::vector<double> squares{modes[0].omega_squared, modes[6].omega_squared};
    std::sort(squares.begin(), squares.end());
    EXPECT_NEAR(squares[0], k / m, 1e-12);
    EXPECT_NEAR(squares[1], (k + 2 * between) / m, 1e-12);
    for (const std::size_t i : {0U, 6U}) {
        const double sign = modes[i].omega_squared < 0.5 ? 1.0 : -1.0;
        EXPECT_NEAR(modes[i].all[0][0] / modes[i].all[1][0], sign, 1e-9);
        EXPECT_NEAR(modes[i].share, 0.5, 1e-9);
        // of the elastic energy in the one against each other 2 k'/(k + 2 k') is the line's
        EXPECT_NEAR(modes[i].line_stiffness, sign > 0 ? 0.0 : 2 * between / (k + 2 * between),
                    1e-12);
    }
}

TEST(PlatformsTogether, AreFollowedByTheOtherAlongTheRestoringCurve) {
    // near - line 1 - far - line 2 - anchor, taut and weightless: two springs one behind the other
    const double EA1 = 4e7, EA2 = 6e7, L1 = 198.0, L2 = 297.0;
    Case c = two_buoys(0.0, 0.0);
    c.further_platforms[0].stiffness.setZero();
    join(c, 1e-3, EA1, L1, 10);
    c.line_types.push_back(c.line_types[0]);
    c.line_types[1].name = "second", c.line_types[1].EA = EA2;
    c.lines.push_back(c.lines[0]);
    Line& second = c.lines[1];
    second.name = second.family = "tail";
    second.sections[0].type = 1;
    second.sections[0].length = L2;
    second.end_a = {.kind = EndKind::platform, .platform = 1};
    second.end_b = {.kind = EndKind::fixed, .position = {600, 0, 0}};
    Platform& near = *c.platform;
    near.fixed = {true, true, true, true, true, true};
    StaticsRequest request;
    request.offsets = {-4.0, -2.0, 0.0, 1.0};
    request.free = FreeMotions{.heave = false};
    const StaticsReport report = find_statics(c, request);
    ASSERT_TRUE(report.curve);
    ASSERT_EQ(report.curve->points.size(), 4U);
    const double k1 = EA1 / L1, k2 = EA2 / L2, k = k1 * k2 / (k1 + k2);
    for (const OffsetPoint& p : report.curve->points) {
        // elongations k1 (d - L1) = k2 (D - d - L2), D = 500 - offset
        const double pull = k * (500.0 - p.offset - L1 - L2);
        EXPECT_NEAR(-p.restoring, pull, 1e-5 * pull) << p.offset;
        EXPECT_NEAR(p.slope, k, 1e-4 * k) << p.offset;
        EXPECT_EQ(p.pose.position.x(), p.offset);
    }
    ASSERT_EQ(report.stiffness.rows(), 12);
    // the fixed one has no stiffness of its own to tell; the other has both lines'
    EXPECT_NEAR(report.stiffness(6, 6), k1 + k2, 1e-4 * (k1 + k2));
    EXPECT_EQ(report.platforms[1].stiffness(0, 0), report.stiffness(6, 6));
    request.platform = "nobody";
    try {
        find_statics(c, request);
        FAIL();
    } catch (const RunError& error) {
        EXPECT_NE(std::string(error.what()).find("near, far"), std::string::npos) << error.what();
    }
}

TEST(PlatformsTogether, TheRestoringCurveLooksAtTheLinesOfItsPlatform) {
    // near - hawser - far - tail - anchor, far held: the tail is the tauter one and not near's
    Case c = two_buoys();
    c.further_platforms[0].fixed = {true, true, true, true, true, true};
    join(c, 1e-3, 4e7, 198.0, 10);
    c.lines.push_back(c.lines[0]);
    Line& tail = c.lines[1];
    tail.name = tail.family = "tail";
    tail.sections[0].length = 295.0;
    tail.end_a = {.kind = EndKind::platform, .platform = 1};
    tail.end_b = {.kind = EndKind::fixed, .position = {600, 0, 0}};
    StaticsRequest request;
    request.offsets = {0.0};
    const StaticsReport report = find_statics(c, request);
    ASSERT_TRUE(report.curve);
    const OffsetPoint& point = report.curve->points.at(0);
    EXPECT_EQ(point.greatest_line, 0);
    EXPECT_NEAR(point.greatest, 4e7 * (200.0 / 198.0 - 1.0), 1.0);
    ASSERT_GT(report.lines[1].tension_a, 1.5 * point.greatest);
    request.lines = "tail";
    try {
        find_statics(c, request);
        FAIL();
    } catch (const RunError& error) {
        EXPECT_EQ(error.code(), ExitCode::input);
        EXPECT_NE(std::string(error.what()).find("touches near"), std::string::npos)
            << error.what();
    }
}

TEST(PlatformsTogether, AFailureNamesThePlatform) {
    Case c = two_buoys();
    Platform& bad = c.further_platforms[0];
    bad.hydrodynamics.matrix->stiffness(2, 2) = 3e9;  // far outside Runge-Kutta's stability
    bad.initial.position.z() = 0.1;
    c.analysis.dynamics.duration = 4000.0;
    const Folder folder("diverges");
    testing::internal::CaptureStderr();
    EXPECT_EQ(run(c, folder), ExitCode::diverged);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("far, t = "), std::string::npos) << said;
    EXPECT_EQ(said.find("near"), std::string::npos) << said;
    EXPECT_GT(io::Hdf5File::open(folder.path / "result.h5").read("/time").size(), 10U);
}

TEST(PlatformsTogether, OneThatSinksIsNamedWithItsKeys) {
    Case c = two_buoys();
    c.further_platforms[0].members = {{.name = "column",
                                       .from = {0, 0, -20},
                                       .to = {0, 0, 8},
                                       .diameter = 8.0,
                                       .displaced_area = 16 * M_PI}};
    c.further_platforms[0].mass = 1e8;
    const Folder folder("sinks");
    testing::internal::CaptureStderr();
    EXPECT_EQ(run(c, folder), ExitCode::no_equilibrium);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("far: weight"), std::string::npos) << said;
    EXPECT_NE(said.find("platforms.far.mass"), std::string::npos) << said;
}

TEST(HullAtItsPlace, MeetsTheWavesWhereItIs) {  // K:8
    Case c = spar_case();
    c.environment.waves = {regular_wave(0.6, 1.5)};
    c.analysis.dynamics.ramp = 0.0;
    c.platform->initial.position = {2.0, 0, 0};
    c.further_platforms = {*c.platform};
    c.further_platforms[0].name = "there";
    const Hull here(c, &spar_data());
    const double length = 2 * M_PI / here.sea().components().front().k;
    for (const double part : {1.0, 0.25}) {
        c.further_platforms[0].position = {part * length, 40.0, 0.0};
        const Hull there(c, &spar_data(), 1);
        EXPECT_EQ(there.design().position, c.further_platforms[0].position);
        const State s = there.start(there.design(), there.design());
        const State o = here.start({}, {});
        const double period = 2 * M_PI / 0.6;
        const Vec6 load = there.loads(3.0, s)[Load::wave1];
        const Vec6 earlier = here.loads(3.0 - part * period, o)[Load::wave1];
        EXPECT_LT((load - earlier).norm(), 1e-9 * load.norm()) << part;
        EXPECT_GT(load.norm(), 1e6);
    }
}

TEST(HullAtItsPlace, CountsStiffnessAndHeldMotionsFromThere) {  // K:20, K:22
    Case c = two_buoys(3e5, 7e5);
    Platform& p = c.further_platforms[0];
    p.fixed[1] = true;
    p.initial.position.y() = 4.0;
    const Hull hull(c, nullptr, 1);
    PlatformMotion pose = hull.design();
    EXPECT_EQ(hull.held_at(5.0).motion.position, Vec3(300, 4, 0));
    State s = hull.start(pose, pose);
    EXPECT_EQ(s[1], 4.0);
    s[0] += 2.0;
    s[1] = 0.0;
    const Vec6 load = hull.loads(0.0, s)[Load::stiffness];
    EXPECT_NEAR(load[0], -7e5 * 2.0, 1e-6);
    EXPECT_LT(load.tail<5>().norm(), 1e-6);
    p.fixed = {};
    p.prescribed.emplace().harmonic[0] = HarmonicMotion{.mean = 1.0};
    EXPECT_EQ(Hull(c, nullptr, 1).held_at(0.0).motion.position, Vec3(301, 0, 0));
}

}  // namespace
}  // namespace hawser::master
