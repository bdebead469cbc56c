// The platform's load ledger: which components it has and when it counts. Case-format "Load
// ledger".
#pragma once

#include <vector>

#include "case/case.hpp"
#include "hull.hpp"
#include "ledger.hpp"
#include "lines.hpp"

namespace hawser::master {

/// Hull loads by component and each family of lines by itself, from `statistics_from` on.
class PlatformLedger {
 public:
    explicit PlatformLedger(const Case& input);

    /// The state at the end of a step with the loads that act in it. Before `statistics_from` it
    /// does nothing.
    void add(double t, const HullLoads& loads, const Reply& lines, const Vec6& momentum,
             const Vec3& velocity);
    /// Are there two states to take a mean between?
    [[nodiscard]] bool started() const { return states_ > 1; }
    [[nodiscard]] LedgerTable table() const { return ledger_.table(); }

 private:
    double from_;
    int states_ = 0;
    std::vector<std::size_t> family_;  ///< of each line: index of its component
    Ledger ledger_;
    std::vector<Vec6> loads_;  ///< workspace
};

}  // namespace hawser::master
