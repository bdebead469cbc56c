#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "clocks.hpp"

namespace hawser::master {

std::string progress_line(const ProgressState& s) {
    const double speed = s.wall > 0.0 ? s.t / s.wall : 0.0;
    std::string text =
        fmt::format("t {:.1f}/{:.1f} s  {:.1f} %  {:.3g}x real time", s.t, s.duration,
                    s.duration > 0.0 ? 100.0 * s.t / s.duration : 100.0, speed);
    if (speed > 0.0) {
        const long left = std::lround((s.duration - s.t) / speed);
        text += fmt::format("  ETA {:02}:{:02}:{:02}", left / 3600, left / 60 % 60, left % 60);
    }
    if (s.surge) text += fmt::format("  surge {:.1f} m", *s.surge);
    if (s.surge && !s.platform.empty()) text += fmt::format(" ({})", s.platform);
    if (!s.line.empty()) text += fmt::format("  max T {:.0f} kN ({})", s.tension / 1e3, s.line);
    return text;
}

Progress::Progress(ProgressStyle style, bool alone)
    : style_(style), start_(wall_seconds()), last_wall_(start_) {
    if (style_ == ProgressStyle::automatic)
        style_ = alone && isatty(STDERR_FILENO) != 0 ? ProgressStyle::bar : ProgressStyle::lines;
}

void Progress::show(double t, double duration, std::span<const PlatformMotion> platforms,
                    const Reply& lines, const Case& input) {
    if (style_ == ProgressStyle::none) return;
    const double now = wall_seconds(), fraction = duration > 0.0 ? t / duration : 1.0;
    const bool due = style_ == ProgressStyle::bar
                         ? now - last_wall_ >= 0.2 || t >= duration
                         : now - last_wall_ >= 30.0 || fraction >= last_fraction_ + 0.05 - 1e-9;
    if (!due || t == 0.0) return;
    last_wall_ = now;
    last_fraction_ = fraction;
    ProgressState s{.t = t,
                    .duration = duration,
                    .wall = now - start_,
                    .surge = std::nullopt,
                    .tension = 0.0,
                    .line = "",
                    .platform = ""};
    for (std::size_t k = 0; k < platforms.size(); ++k) {
        const Platform& its = input.platform_at(static_cast<int>(k));
        const double surge = platforms[k].position.x() - its.position.x();
        if (s.surge && std::abs(surge) <= std::abs(*s.surge)) continue;
        s.surge = surge;
        if (platforms.size() > 1) s.platform = its.name;
    }
    for (std::size_t i = 0; i < lines.lines.size(); ++i)
        if (s.line.empty() || lines.lines[i].end_tension > s.tension) {
            s.tension = lines.lines[i].end_tension;
            s.line = input.lines[i].name;
        }
    if (style_ == ProgressStyle::bar) {
        constexpr int width = 24;
        const int full = static_cast<int>(width * std::min(1.0, fraction));
        std::fprintf(stderr, "\r\033[K[%s%s] %s", std::string(std::size_t(full), '#').c_str(),
                     std::string(std::size_t(width - full), '.').c_str(), progress_line(s).c_str());
        bar_shown_ = true;
    } else {
        std::fprintf(stderr, "%s\n", progress_line(s).c_str());
    }
    std::fflush(stderr);
}

void Progress::finish() {
    if (bar_shown_) std::fputc('\n', stderr);
    bar_shown_ = false;
}

}  // namespace hawser::master
