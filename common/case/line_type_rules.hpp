// From a declared line type to its mechanical properties per length.
#pragma once

#include "case/declared.hpp"

namespace hawser {

/// Fills in what the category's rules give: mass, density, volume diameter, EA, EI (README.md,
/// "line types"). `material` is null for a pipe whose material is not known.
/// A curve starts at [0, 0] and ascends in both columns.
void check_curve(const Curve& curve, const std::string& path, Problems& problems);

void complete_line_type(LineTypeKeys& type, const Material* material, Problems& problems);

/// Properties of a completed line type: contents and marine growth added.
LineType line_type(const LineTypeKeys& type);

}  // namespace hawser
