// Numbers with units: "1.4 m/s", "3e6 Pa", "10 deg". The only place where units are converted.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "case/dimension.hpp"

namespace hawser::io {

/// What a number without a unit means: kg, m, s, N, Pa; tonne, m, s, kN, kPa; kip, ft, s. A plain
/// angle is in degrees in all three.
enum class Units { SI, SI_kN, US };

/// A value in SI and radians, or why there is none (a complete phrase: "expected a ...; got ...").
struct Quantity {
    std::optional<double> value;
    std::string error;
};

/// Reads `number [space] [unit]`. Units are products and quotients of names with integer powers
/// (kN.m/deg, kg/m, kN/m2), the quotient last. Leading zeros, hexadecimal, inf and nan are refused,
/// and so is a unit of another dimension than the one expected. A plain 0 needs no unit.
Quantity parse_quantity(std::string_view text, const Dimension& expected, Units plain = Units::SI);

/// Reads a number alone: decimal, with an optional sign and exponent, no leading zeros.
std::optional<double> parse_number(std::string_view text);

/// Writes a value in its SI unit (angles in degrees where that is exact) so that parse_quantity
/// gives back the same bits.
std::string print_quantity(double value, const Dimension& dimension);

/// The shortest decimal that reads back to the same bits.
std::string print_number(double value);

/// Value from a unit, e.g. factor("kN") = 1000: nothing if it is no unit.
struct UnitFactor {
    double numerator = 1.0, denominator = 1.0;
    std::array<int, 4> exponents{0, 0, 0, 0};
};
std::optional<UnitFactor> parse_unit(std::string_view text);

/// "a mass", "an angle".
std::string with_article(std::string_view noun);

}  // namespace hawser::io
