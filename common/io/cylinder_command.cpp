#include "io/cylinder_command.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "io/wamit_output.hpp"
#include "status.hpp"

namespace hawser::io {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A line every few seconds, none for what takes less. The choice of the sums comes before the
/// first frequency and is not counted.
class Progress {
 public:
    void operator()(double done) {
        if (first_ == 0.0) {
            start_ = last_ = Clock::now();
            first_ = done;
        }
        if (seconds_since(last_) < 3.0) return;
        last_ = Clock::now();
        const double to_go = seconds_since(start_) * (1.0 - done) / (done - first_);
        fmt::print(stderr, "frequencies {:3.0f} %, about {:.0f} s to go\n", 100.0 * done, to_go);
    }

 private:
    Clock::time_point start_, last_;
    double first_ = 0.0;
};

std::string summary(const hydro::CylinderRequest& request, const hydro::CylinderData& d) {
    std::string text;
    const auto say = [&](const std::string& line) { text.append(line).append("\n"); };
    const hydro::Water& water = request.water;
    const double rho_g = water.density * water.gravity;
    say(fmt::format("displaced volume      {:.3f} m3, {:.1f} t", d.buoyancy.volume,
                    1e-3 * water.density * d.buoyancy.volume));
    say(fmt::format("centre of buoyancy    z = {:.3f} m", d.buoyancy.centre));
    say(fmt::format("waterplane            {:.3f} m2, second moment {:.1f} m4, C33 {:.6g} N/m",
                    d.buoyancy.waterplane, d.buoyancy.waterplane_moment,
                    rho_g * d.buoyancy.waterplane));
    if (request.free) {
        const auto& f = *request.free;
        say(fmt::format(
            "mean drift            of the free hull: {:.1f} t, centre of gravity {:g} m, "
            "gyration {:g} m",
            1e-3 * f.mass, f.cog, f.gyration));
        if (f.heave_added_mass > 0.0 || d.heave_damping > 0.0)
            say(fmt::format(
                "  its heave           {:g} t of added mass, damping {:.4g} N.s/m ({:g} "
                "of critical)",
                1e-3 * f.heave_added_mass, d.heave_damping, request.heave_damping_fraction));
        const double lacking = f.mass / (water.density * d.buoyancy.volume) - 1.0;
        if (std::abs(lacking) > 0.05)
            say(fmt::format("  note: the mass is {:+.1f} % of what the hull displaces",
                            100 * lacking));
    } else {
        say("mean drift            of the fixed hull");
    }
    say(fmt::format("zero frequency        A(0) is computed at {:g} rad/s", d.zero_frequency));
    say(fmt::format(
        "truncation error      {:.1e} relative, the last change on doubling; {} functions "
        "in the openings, {} modes outside",
        d.truncation_error, d.functions, d.outer_modes));
    say(fmt::format("Haskind, energy       kept to {:.0e} and {:.0e}", d.haskind_gap,
                    d.energy_gap));
    return text;
}

}  // namespace

int cylinder_command(const hydro::CylinderRequest& request, const std::string& stem, bool quiet) {
    // Before the work, not after it.
    const std::filesystem::path folder = std::filesystem::path(stem).parent_path();
    std::error_code ignored;
    if (!folder.empty() && !std::filesystem::is_directory(folder, ignored))
        throw RunError(ExitCode::io, fmt::format("{}: there is no such folder", folder.string()));
    const Clock::time_point start = Clock::now();
    Progress progress;
    const hydro::CylinderData result = hydro::cylinder_data(
        request, quiet ? std::function<void(double)>{} : [&](double done) { progress(done); });
    const auto files = write_wamit(result.data, request.water.gravity, stem);
    if (!result.within_tolerance)
        fmt::print(stderr,
                   "warning: truncation error {:.1e} is above the tolerance {:g}; the finest sums "
                   "were used\n",
                   result.truncation_error, request.tolerance);
    if (quiet) return static_cast<int>(ExitCode::done);
    std::fputs(summary(request, result).c_str(), stdout);
    std::string names;
    for (const auto& file : files) names.append(names.empty() ? "" : " ").append(file.string());
    fmt::print("{} frequencies, {} headings in {:.1f} s: {}\n", request.frequencies.size(),
               request.headings.size(), seconds_since(start), names);
    return static_cast<int>(ExitCode::done);
}

}  // namespace hawser::io
