#include "platform_ledger.hpp"

#include <algorithm>
#include <cstddef>

#include "packing.hpp"
#include "statistics.hpp"

namespace hawser::master {

namespace {

/// The hull's components without `lines`, then the families in the order they first appear; of
/// several platforms the families that touch this one.
std::vector<std::string> ledger_components(const Case& input, int which) {
    std::vector<std::string> names;
    for (const std::string_view name : load_names)
        if (name != "lines") names.emplace_back(name);
    const std::size_t hull_names = names.size();
    const bool several = input.platform_count() > 1;
    const std::vector<Touched> touched = touched_platforms(input);
    for (std::size_t i = 0; i < input.lines.size(); ++i) {
        const std::string& family = input.lines[i].family;
        if (several && touched[i].first != which && touched[i].second != which) continue;
        if (std::find(names.begin() + static_cast<long>(hull_names), names.end(), family) ==
            names.end())
            names.push_back(family);
    }
    return names;
}

}  // namespace

PlatformLedger::PlatformLedger(const Case& input, int which)
    : which_(which),
      from_(input.analysis.dynamics.statistics_from),
      D_(input.analysis.dynamics.platform_step),
      ledger_(ledger_components(input, which)) {
    const std::vector<std::string> names = ledger_components(input, which);
    for (const Line& line : input.lines) {  // from the end: a family may be called like a load
        const auto left = names.rend() - std::find(names.rbegin(), names.rend(), line.family);
        family_.push_back(static_cast<std::size_t>(std::max<std::ptrdiff_t>(left, 1) - 1));
    }
    loads_.resize(names.size());
}

void PlatformLedger::add(int stage, double t, const HullLoads& loads, const Reply& lines,
                         const Vec6& momentum, const Vec3& velocity) {
    const bool between_steps = stage == 0 || stage == 4;
    if (states_ == 0 && (!between_steps || !counts(t, from_))) return;
    if (between_steps) {
        ledger_.at_step(t, momentum);
        ++states_;
    }
    std::fill(loads_.begin(), loads_.end(), Vec6::Zero());
    std::size_t k = 0;
    for (int i = 0; i < load_count; ++i)
        if (static_cast<Load>(i) != Load::lines) loads_[k++] = loads[static_cast<Load>(i)];
    for (std::size_t i = 0; i < family_.size(); ++i)
        if (const Vec6* wrench = lines.lines[i].on(which_)) loads_[family_[i]] += *wrench;
    const double weight = stage == 1 || stage == 2 ? 1.0 / 3.0 : 1.0 / 6.0;  // of P:3
    ledger_.act(weight * D_, loads_, momentum, velocity);
}

}  // namespace hawser::master
