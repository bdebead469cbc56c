#include "component_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cubic_weights.hpp"
#include "status.hpp"

namespace hawser::master {

namespace {
constexpr double turn = 2.0 * M_PI;
constexpr double at_the_end = 1e-6;  // [rad] rounding allowed at the ends of an open range
}  // namespace

HeadingWeights heading_weights(const std::vector<double>& headings, bool full_circle, double b) {
    const int n = static_cast<int>(headings.size());
    const auto at = [&](int i) {  // the range repeated round the circle
        const int lap = i < 0 ? -1 : i >= n ? 1 : 0;
        return headings[static_cast<std::size_t>(i - lap * n)] + lap * turn;
    };
    if (n == 1) {
        if (std::abs(std::remainder(b - headings.front(), turn)) > one_heading_reach + at_the_end)
            throw RunError(
                ExitCode::diverged,
                fmt::format("a wave meets the platform from a heading of {:.2f} deg; the database "
                            "has only {:.2f} deg, which serves within {:g} deg to either side: "
                            "compute more headings",
                            std::remainder(b, turn) * 180 / M_PI, headings.front() * 180 / M_PI,
                            one_heading_reach * 180 / M_PI));
        return {.index = {}, .weight = {1.0, 0.0, 0.0, 0.0}};
    }
    b -= turn * std::floor((b - headings.front()) / turn);  // into [first, first + 2 pi)
    if (!full_circle) {
        if (b > headings.back() && b - turn > headings.front() - at_the_end) b = headings.front();
        if (b > headings.back() + at_the_end)
            throw RunError(
                ExitCode::diverged,
                fmt::format("a wave meets the platform from a heading of {:.2f} deg, "
                            "outside the database's {:.2f} to {:.2f} deg; headings are "
                            "never extrapolated: compute more of them, or state the "
                            "symmetry of the hull",
                            std::remainder(b, turn) * 180 / M_PI, headings.front() * 180 / M_PI,
                            headings.back() * 180 / M_PI));
        b = std::min(b, headings.back());
    }
    int i =
        static_cast<int>(std::upper_bound(headings.begin(), headings.end(), b) - headings.begin()) -
        1;
    if (!full_circle) i = std::min(i, n - 2);
    const bool before = full_circle || i > 0, after = full_circle || i + 2 < n;
    HeadingWeights w;
    w.weight = cubic_weights({at(i - 1), at(i), at(i + 1), at(i + 2)}, before, after, b);
    for (int k = 0; k < 4; ++k)
        w.index[static_cast<std::size_t>(k)] =
            full_circle ? (i - 1 + k + n) % n : std::clamp(i - 1 + k, 0, n - 1);
    return w;
}

template <class Value>
ComponentTable<Value>::ComponentTable(const WaveTable<Value>& table,
                                      const std::vector<WaveComponent>& components)
    : full_circle_(table.full_circle) {
    if (table.empty()) return;
    for (const auto& h : table.headings) headings_.push_back(h.heading);
    const std::vector<double>& at = table.frequencies;
    double energy = 0.0, outside = 0.0;
    for (const WaveComponent& c : components) {
        const double a2 = c.amplitude * c.amplitude;
        energy += a2;
        if (c.omega < at.front() || c.omega > at.back()) outside += a2;
        const auto above =
            std::clamp<std::ptrdiff_t>(std::upper_bound(at.begin(), at.end(), c.omega) - at.begin(),
                                       1, std::max<std::ptrdiff_t>(std::ssize(at) - 1, 1));
        const auto j = std::min(static_cast<std::size_t>(above), at.size() - 1);
        const std::size_t i = static_cast<std::size_t>(above) - 1;
        const double f = i == j ? 0.0 : std::clamp((c.omega - at[i]) / (at[j] - at[i]), 0.0, 1.0);
        for (const auto& h : table.headings)
            values_.push_back((1 - f) * h.values[i] + f * h.values[j]);
    }
    if (outside > 0.01 * energy)
        throw RunError(ExitCode::input,
                       fmt::format("{:.1f} % of the waves' energy lies outside the frequencies of "
                                   "the hydrodynamic database, {:.3g} to {:.3g} rad/s; expected at "
                                   "most 1 %",
                                   100 * outside / energy, at.front(), at.back()));
    for (const WaveComponent& c : components) {
        try {
            (void)weights(c.heading);
        } catch (const RunError& error) {  // found before the run, so it is the input that is wrong
            throw RunError(ExitCode::input, error.what());
        }
    }
}

template class ComponentTable<CVec6>;
template class ComponentTable<Vec6>;

}  // namespace hawser::master
