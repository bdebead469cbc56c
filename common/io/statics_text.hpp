// The static solution for people (kN, m, deg), for scripts (JSON, SI with angles in degrees), and
// as CSV.
#pragma once

#include <string>

#include "case/case.hpp"
#include "io/json.hpp"
#include "statics_report.hpp"

namespace hawser::io {

/// Everything: platform, lines, constraints, restoring curve.
std::string statics_text(const Case& input, const StaticsReport& report);

/// What a check wants to see of it: environment, platform, lines, each in a few columns.
std::string statics_summary(const Case& input, const StaticsReport& report);

Json statics_json(const Case& input, const StaticsReport& report);

/// The restoring curve if there is one, else one row per line; SI, angles in degrees, units in the
/// heads.
std::string statics_csv(const Case& input, const StaticsReport& report);

}  // namespace hawser::io
