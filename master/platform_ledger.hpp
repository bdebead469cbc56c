// The platform's load ledger: which components it has and when it counts. Case-format "Load
// ledger".
#pragma once

#include <vector>

#include "case/case.hpp"
#include "hull.hpp"
#include "ledger.hpp"
#include "lines.hpp"

namespace hawser::master {

/// Hull loads by component and each family of the platform's lines by itself, from
/// `statistics_from` on.
class PlatformLedger {
 public:
    /// @param which  of several platforms in the case
    explicit PlatformLedger(const Case& input, int which = 0);

    /// One evaluation of P:3, in the order in which they are made. Before the first step from
    /// `statistics_from` on it does nothing.
    /// @param stage     1 to 3 within a step; 0 (the start) and 4 (the end) are also the first
    ///                  evaluation of the next step
    /// @param t         [s], of the evaluation
    /// @param momentum  of the rigid mass at it, angular about O [N.s, N.m.s]
    /// @param velocity  of O [m/s]
    void add(int stage, double t, const HullLoads& loads, const Reply& lines, const Vec6& momentum,
             const Vec3& velocity);
    /// Are there two states to take a mean between?
    [[nodiscard]] bool started() const { return states_ > 1; }
    [[nodiscard]] LedgerTable table() const { return ledger_.table(); }

 private:
    int which_;
    double from_, D_;
    int states_ = 0;                   ///< between steps
    std::vector<std::size_t> family_;  ///< of each line: index of its component
    Ledger ledger_;
    std::vector<Vec6> loads_;  ///< workspace
};

}  // namespace hawser::master
