// Whole runs in this process, from a case in memory to the result file.
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/hdf5.hpp"
#include "io/link.hpp"
#include "roles.hpp"
#include "stop_signal.hpp"

namespace hawser {
namespace {

namespace fs = std::filesystem;

/// A buoy that heaves on a linear spring and damper: (m + A) z'' + B z' + C z = -m g.
struct HeavingBuoy {
    double m = 2e6, A = 1e6, B = 2e5, C = 1.5e6, offset = 1.2;
    [[nodiscard]] double rest() const { return -m * 9.80665 / C; }
    [[nodiscard]] double z(double t) const {  // released at rest, offset above its equilibrium
        const double decay = B / (2 * (m + A)), w = std::sqrt(C / (m + A) - decay * decay);
        return rest() +
               offset * std::exp(-decay * t) * (std::cos(w * t) + decay / w * std::sin(w * t));
    }
    [[nodiscard]] Case as_case(double duration, double D) const {
        Case c;
        c.name = "buoy";
        c.environment.seabed.depth = 100.0;
        Platform& p = c.platform.emplace();
        p.name = "buoy";
        p.mass = m;
        p.radii_of_gyration = {10, 10, 10};
        p.initial.position.z() = offset;
        HydroMatrix& matrix = p.hydrodynamics.matrix.emplace();
        matrix.added_mass(2, 2) = A;
        matrix.damping(2, 2) = B;
        matrix.stiffness(2, 2) = C;
        c.analysis.dynamics.duration = duration;
        c.analysis.dynamics.platform_step = D;
        c.analysis.dynamics.statistics_from = duration / 2;
        c.output.interval = D;
        c.output.platform_loads = true;
        return c;
    }
};

struct Folder {
    fs::path path;
    explicit Folder(const std::string& name)
        : path(fs::path(testing::TempDir()) / ("hawser_" + name)) {
        fs::remove_all(path);
    }
    ~Folder() { fs::remove_all(path); }
    [[nodiscard]] std::string text(const std::string& file) const {
        std::ifstream in(path / file);
        std::ostringstream out;
        out << in.rdbuf();
        return out.str();
    }
};

RunRequest quiet_request(const Folder& folder) {
    RunRequest request;
    request.folder = folder.path;
    request.progress = ProgressStyle::none;
    request.quiet = true;
    return request;
}

ExitCode run(const Case& input, const Folder& folder) {
    io::Link alone;
    return run_master(input, quiet_request(folder), alone);
}

TEST(Simulation, OfAHeaveDecayIsItsClosedForm) {  // P:3, K:4
    const HeavingBuoy buoy;
    const Folder folder("decay");
    ASSERT_EQ(run(buoy.as_case(60.0, 0.25), folder), ExitCode::done);
    const io::Hdf5File result = io::Hdf5File::open(folder.path / "result.h5");
    const std::vector<double> t = result.read("/time");
    const std::vector<double> z = result.dataset("/platform/buoy/position").read_column(2);
    ASSERT_EQ(t.size(), 241U);
    for (std::size_t i = 0; i < t.size(); ++i) {
        EXPECT_EQ(t[i], static_cast<double>(i) * 0.25);
        // Runge-Kutta: offset t w^5 D^4 / 120 = 4e-4 m with w = 0.7 rad/s
        EXPECT_NEAR(z[i], buoy.z(t[i]), 4e-4);
    }
    EXPECT_EQ(result.text_attribute("/", "title"), "");
    EXPECT_NE(folder.text("status.json").find("\"done\""), std::string::npos);
    EXPECT_NE(folder.text("summary.txt").find("heave"), std::string::npos);
}

TEST(Simulation, LedgerClosesOnTheChangeOfMomentum) {
    const HeavingBuoy buoy;
    const Folder folder("ledger");
    ASSERT_EQ(run(buoy.as_case(40.0, 0.1), folder), ExitCode::done);
    const io::Hdf5File result = io::Hdf5File::open(folder.path / "result.h5");
    const std::vector<double> residual = result.read("/ledger/buoy/residual");
    const std::vector<double> momentum = result.read("/ledger/buoy/momentum");
    // m (z'(40) - z'(20)) / 20 s from the closed form; the difference quotient errs by 1e-6.
    const auto rate = [&](double t) { return (buoy.z(t + 1e-4) - buoy.z(t - 1e-4)) / 2e-4; };
    EXPECT_NEAR(momentum[2], buoy.m * (rate(40.0) - rate(20.0)) / 20.0, 100.0);
    // Heave alone: momentum is linear in the state, what is left is rounding of loads of 1e8 N
    EXPECT_LT(std::abs(residual[2]), 1e-3);
    EXPECT_GT(std::abs(momentum[2]), 1000.0);
}

TEST(Simulation, RefusesAnOldResultUnlessForced) {
    const HeavingBuoy buoy;
    const Folder folder("refuse");
    ASSERT_EQ(run(buoy.as_case(2.0, 0.5), folder), ExitCode::done);
    testing::internal::CaptureStderr();
    EXPECT_EQ(run(buoy.as_case(2.0, 0.5), folder), ExitCode::io);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("error: "), std::string::npos);
    io::Link alone;
    RunRequest forced = quiet_request(folder);
    forced.force = true;
    EXPECT_EQ(run_master(buoy.as_case(2.0, 0.5), forced, alone), ExitCode::done);
}

TEST(Simulation, WithoutEquilibriumEndsWithFour) {
    Case c = HeavingBuoy{}.as_case(2.0, 0.5);
    c.platform->hydrodynamics.matrix->stiffness.setZero();  // it sinks
    const Folder folder("sinks");
    testing::internal::CaptureStderr();
    EXPECT_EQ(run(c, folder), ExitCode::no_equilibrium);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("nothing holds the platform in heave"), std::string::npos) << said;
    EXPECT_NE(folder.text("status.json").find("\"failed\""), std::string::npos);
}

TEST(Simulation, ThatDivergesEndsWithFiveAndKeepsWhatItHas) {
    HeavingBuoy buoy;
    buoy.C = 3e8;  // w = 10 rad/s: far outside Runge-Kutta's stability at D = 0.5 s
    buoy.B = 0.0;
    Case c = buoy.as_case(4000.0, 0.5);
    const Folder folder("diverges");
    testing::internal::CaptureStderr();
    EXPECT_EQ(run(c, folder), ExitCode::diverged);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("not a finite number"),
              std::string::npos);
    const io::Hdf5File result = io::Hdf5File::open(folder.path / "result.h5");
    EXPECT_GT(result.read("/time").size(), 10U);
    EXPECT_NE(folder.text("status.json").find("\"exit_code\": 5"), std::string::npos)
        << folder.text("status.json");
}

// The last test: a signal stays noted for the life of the process.
TEST(Simulation, StopsOnASignalWithSevenAndAWholeResult) {
    const HeavingBuoy buoy;
    const Folder folder("stop");
    watch_stop_signals();
    std::raise(SIGUSR1);
    EXPECT_EQ(stop_signal(), SIGUSR1);
    testing::internal::CaptureStderr();
    EXPECT_EQ(run(buoy.as_case(1000.0, 0.5), folder), ExitCode::stopped);
    testing::internal::GetCapturedStderr();
    const io::Hdf5File result = io::Hdf5File::open(folder.path / "result.h5");
    EXPECT_EQ(result.read("/time"), std::vector<double>{0.0});  // stopped before the first step
    EXPECT_NE(folder.text("status.json").find("\"stopped\""), std::string::npos);
}

}  // namespace
}  // namespace hawser
