// Rows of the validation table that scripts/validate prints: this program's number beside one from
// outside. A row that is not within its tolerance fails the test it stands in.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace hawser {

/// One comparison. `id` is the label of the outside number (tests/README.md says where it is from).
struct ValidationRow {
    const char* id;
    const char* what;  ///< quantity with its unit
    double expected;
    double got;
    double tolerance;      ///< of the error below
    bool relative = true;  ///< error is relative to `expected`, else absolute
};

/// Prints `id | what | expected | got | error | tolerance | ok` and expects the last to be yes.
inline void validate(const ValidationRow& row) {
    const double difference = row.got - row.expected;
    const double error = row.relative ? difference / std::abs(row.expected) : difference;
    const bool ok = std::abs(error) <= row.tolerance;  // false for NaN
    std::printf("%s | %s | %.7g | %.7g | %.2g | %.2g | %s\n", row.id, row.what, row.expected,
                row.got, error, row.tolerance, ok ? "yes" : "NO");
    EXPECT_TRUE(ok) << row.id << ": " << row.what;
}

}  // namespace hawser
