// Running rods in tests: passes without a platform, states set by hand, spectra of small systems.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "rod_cases.hpp"

namespace hawser::worker::testing {

inline Vec3 vec(const Vector<Single>& x) { return {x.x[0], x.y[0], x.z[0]}; }
inline Vector<Single> lanes_of(const Vec3& x) { return {x.x(), x.y(), x.z()}; }

/// Passes of `interval` from time 0 on with the platform at rest, each kept; `look` after each.
/// @return the status of the pass that failed, or ok
template <class V>
Status run(RodPack<V>& rod, double duration, double interval,
           const std::function<void(double)>& look = nullptr) {
    const PlatformMotion still;
    const auto n = static_cast<int>(std::lround(duration / interval));
    for (int k = 0; k < n; ++k) {
        const double t0 = k * interval, t1 = (k + 1) * interval;
        const Status status = rod.pass(t0, t1, MotionSpline(t0, still, t1, still));
        if (!status.ok()) return status;
        rod.keep();
        if (look) look(t1);
    }
    return {};
}

/// Values with their times; mean, standard deviation, differences.
struct Record {
    std::vector<double> t, y;
    void add(double time, double value) { t.push_back(time), y.push_back(value); }
    [[nodiscard]] double mean() const {
        double sum = 0.0;
        for (const double v : y) sum += v;
        return sum / static_cast<double>(y.size());
    }
    [[nodiscard]] double deviation() const {
        double sum = 0.0;
        const double m = mean();
        for (const double v : y) sum += (v - m) * (v - m);
        return std::sqrt(sum / static_cast<double>(y.size()));
    }
    [[nodiscard]] double largest() const { return *std::max_element(y.begin(), y.end()); }
    /// Mean time between zero crossings of like sign, interpolated [s].
    [[nodiscard]] double period() const {
        std::vector<double> up;
        for (std::size_t i = 1; i < y.size(); ++i)
            if (y[i - 1] < 0.0 && y[i] >= 0.0)
                up.push_back(t[i - 1] + (t[i] - t[i - 1]) * y[i - 1] / (y[i - 1] - y[i]));
        return (up.back() - up.front()) / static_cast<double>(up.size() - 1);
    }
};

/// Root mean square of the difference of two records of the same times.
inline double rms_difference(const Record& a, const Record& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.y.size(); ++i) sum += (a.y[i] - b.y[i]) * (a.y[i] - b.y[i]);
    return std::sqrt(sum / static_cast<double>(a.y.size()));
}

/// Adds a small motion to the kept state of a single rod: displacement u(s) and its slope, with
/// acceleration factor * u; `s` counts from end B.
inline void displace(RodPack<Single>& rod, double length, double factor,
                     const std::function<Vec3(double)>& u, const std::function<Vec3(double)>& du) {
    NodeState<Single>* node = rod.kept().nodes();
    const int N = rod.elements();
    for (int n = 0; n <= N; ++n) {
        const double s = length * n / N;
        node[n].r += lanes_of(u(s)), node[n].d += lanes_of(du(s));
        node[n].a = node[n].A = lanes_of(factor * u(s));
        node[n].ad = node[n].Ad = lanes_of(factor * du(s));
    }
}

/// Motion of a fixed end.
inline LineEnd moving(LineEnd end, const Vec3& amplitude, double period) {
    end.motion =
        EndMotion{.amplitude = amplitude, .period = Vec3::Constant(period), .phase = Vec3::Zero()};
    return end;
}

/// The standing mooring line of the rod tests: chain 91 m, polyester 2286 m, chain 122 m with 2 t
/// at the connectors, between a fairlead at -100 m and an anchor point at -1500 m, clear of the
/// bed.
/// @param offset  of the fairlead from a mean tension near 2 MN, away from the anchor [m]
inline Case standing_line(const LineEnd& top, double span, int refine = 1) {
    LineType chain = plain_type(588.7, 3.07119e9), rope = plain_type(66.0, 7.0632e8);
    chain.displaced_area = M_PI / 4 * 0.3096 * 0.3096;
    chain.drag_diameter = 0.172, chain.drag_normal = 2.4, chain.drag_axial = 1.15;
    rope.displaced_area = M_PI / 4 * 0.2474 * 0.2474;
    rope.drag_diameter = 0.2474, rope.drag_normal = 1.2, rope.drag_axial = 0.1;
    for (LineType* type : {&chain, &rope}) type->added_mass_normal = 1.0;
    Case input = one_line(chain, 91, 4, top, fixed_at({span, 0, -1500}), 3000);
    input.line_types.push_back(rope);
    input.lines[0].sections = {{.type = 0, .length = 91, .elements = 4 * refine},
                               {.type = 1, .length = 2286, .elements = 32 * refine},
                               {.type = 0, .length = 122, .elements = 4 * refine}};
    input.lines[0].attachments = {{.arc_length = 91, .mass = 2000},
                                  {.arc_length = 2377, .mass = 2000}};
    return input;
}

}  // namespace hawser::worker::testing
