// From the declared line to what holds it, targets of statics and failures.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "case/declared.hpp"

namespace hawser {

/// Unit vector at an angle from vertical down in the plane of an azimuth [rad].
Vec3 direction_down(double angle, std::optional<double> azimuth);

/// The one number of a stiffness: the first slope of the curve where there is one.
double first_slope(const Curve& curve, std::optional<double> number);

/// Name of the n-th constraint, from 1, that a declared one makes.
std::string constraint_name(const ConstraintKeys& keys, std::size_t n);

/// Constraints and winch of `line`, whose ends and sections are known.
void line_constraints(const LineKeys& keys, const DeclaredCase& declared, Line& line,
                      Problems& problems);

/// What statics is to meet, and by what.
void line_target(const LineKeys& keys, Line& line, Problems& problems);

/// A line that parts.
void line_failure(const LineKeys& keys, const DeclaredCase& declared, Line& line,
                  Problems& problems);

/// Index of the line that another is tied to, at an arc length of it; -1: not found, or itself.
/// {n} in the name is the number of the tied line in its family.
int tied_line(const std::string& name, double arc, const LineKeys& line,
              const DeclaredCase& declared, const std::string& name_path,
              const std::string& arc_path, Problems& problems);

/// An end of a line on another line: the constraint that ties it.
void tied_end(const EndKeys& keys, bool is_b, const LineKeys& line_keys,
              const DeclaredCase& declared, Line& line, Problems& problems);

}  // namespace hawser
