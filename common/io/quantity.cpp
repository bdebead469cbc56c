#include "io/quantity.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace hawser::io {
namespace {

struct UnitName {
    std::string_view name;
    double numerator, denominator;
    std::array<int, 4> exponents;  // mass, length, time, angle
};

constexpr double pi = std::numbers::pi;
constexpr double pound = 0.45359237, gravity = 9.80665, foot = 0.3048, inch = 0.0254;

constexpr std::array unit_names{
    UnitName{"m", 1, 1, {0, 1, 0, 0}},
    UnitName{"mm", 1, 1000, {0, 1, 0, 0}},
    UnitName{"cm", 1, 100, {0, 1, 0, 0}},
    UnitName{"km", 1000, 1, {0, 1, 0, 0}},
    UnitName{"ft", foot, 1, {0, 1, 0, 0}},
    UnitName{"in", inch, 1, {0, 1, 0, 0}},
    UnitName{"nmi", 1852, 1, {0, 1, 0, 0}},
    UnitName{"s", 1, 1, {0, 0, 1, 0}},
    UnitName{"ms", 1, 1000, {0, 0, 1, 0}},
    UnitName{"min", 60, 1, {0, 0, 1, 0}},
    UnitName{"h", 3600, 1, {0, 0, 1, 0}},
    UnitName{"kg", 1, 1, {1, 0, 0, 0}},
    UnitName{"t", 1000, 1, {1, 0, 0, 0}},
    UnitName{"te", 1000, 1, {1, 0, 0, 0}},
    UnitName{"lb", pound, 1, {1, 0, 0, 0}},
    UnitName{"kip_mass", 1000 * pound, 1, {1, 0, 0, 0}},
    UnitName{"N", 1, 1, {1, 1, -2, 0}},
    UnitName{"kN", 1e3, 1, {1, 1, -2, 0}},
    UnitName{"MN", 1e6, 1, {1, 1, -2, 0}},
    UnitName{"tf", 1000 * gravity, 1, {1, 1, -2, 0}},
    UnitName{"lbf", pound* gravity, 1, {1, 1, -2, 0}},
    UnitName{"kip", 1000 * pound* gravity, 1, {1, 1, -2, 0}},
    UnitName{"Pa", 1, 1, {1, -1, -2, 0}},
    UnitName{"kPa", 1e3, 1, {1, -1, -2, 0}},
    UnitName{"MPa", 1e6, 1, {1, -1, -2, 0}},
    UnitName{"GPa", 1e9, 1, {1, -1, -2, 0}},
    UnitName{"bar", 1e5, 1, {1, -1, -2, 0}},
    UnitName{"psi", pound* gravity, inch* inch, {1, -1, -2, 0}},
    UnitName{"ksi", 1000 * pound* gravity, inch* inch, {1, -1, -2, 0}},
    UnitName{"deg", pi, 180, {0, 0, 0, 1}},
    UnitName{"rad", 1, 1, {0, 0, 0, 1}},
    UnitName{"knot", 1852, 3600, {0, 1, -1, 0}},
    UnitName{"kn", 1852, 3600, {0, 1, -1, 0}},
    UnitName{"Hz", 2 * pi, 1, {0, 0, -1, 1}},
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Length of the number that `text` starts with, 0 if it starts with none.
std::size_t number_length(std::string_view text) {
    std::size_t i = 0;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
    const std::size_t whole = i;
    while (i < text.size() && is_digit(text[i])) ++i;
    std::size_t digits = i - whole;
    if (digits > 1 && text[whole] == '0') return 0;  // 0777: octal to some readers
    if (i < text.size() && text[i] == '.') {
        const std::size_t fraction = ++i;
        while (i < text.size() && is_digit(text[i])) ++i;
        digits += i - fraction;
    }
    if (digits == 0) return 0;
    if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
        std::size_t j = i + 1;
        if (j < text.size() && (text[j] == '+' || text[j] == '-')) ++j;
        const std::size_t exponent = j;
        while (j < text.size() && is_digit(text[j])) ++j;
        if (j > exponent) i = j;
    }
    return i;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

/// Factor of a number without a unit.
UnitFactor plain_factor(const std::array<int, 4>& exponents, Units units) {
    UnitFactor factor;
    if (exponents == dimension::angle.exponents) return {pi, 180.0, exponents};
    const auto multiply = [&factor](double by, int power) {
        for (; power > 0; --power) factor.numerator *= by;
        for (; power < 0; ++power) factor.denominator *= by;
    };
    if (units == Units::SI_kN) multiply(1000.0, exponents[0]);
    if (units == Units::US) {
        // A mass that comes with time is a force in disguise: kip, kip/ft, kip.s/ft.
        const bool force = exponents[0] != 0 && exponents[2] != 0;
        multiply(force ? 1000 * pound * gravity : 1000 * pound, exponents[0]);
        multiply(foot, force ? exponents[1] - exponents[0] : exponents[1]);
    }
    return factor;
}

double convert(double number, const UnitFactor& factor) {
    return number * factor.numerator / factor.denominator;
}

}  // namespace

std::string with_article(std::string_view noun) {
    const bool vowel = !noun.empty() && std::string_view("aeio").find(noun[0]) != noun.npos;
    return fmt::format("{} {}", vowel ? "an" : "a", noun);
}

std::optional<UnitFactor> parse_unit(std::string_view text) {
    UnitFactor total;
    bool quotient = false, first = true;
    while (!text.empty()) {
        if (!first) {
            if (text.front() != '.' && text.front() != '/') return std::nullopt;
            if (text.front() == '.' && quotient) return std::nullopt;  // kg/m.s: which is meant?
            quotient = text.front() == '/';
            text.remove_prefix(1);
        }
        first = false;
        std::size_t n = 0;
        while (n < text.size() &&
               (std::isalpha(static_cast<unsigned char>(text[n])) != 0 || text[n] == '_')) {
            ++n;
        }
        const std::string_view name = text.substr(0, n);
        text.remove_prefix(n);
        int power = 1;
        if (!text.empty() && text.front() == '^') text.remove_prefix(1);
        if (!text.empty() && (text.front() == '-' || is_digit(text.front()))) {
            const auto [end, status] =
                std::from_chars(text.data(), text.data() + text.size(), power);
            if (status != std::errc{} || power == 0 || power < -4 || power > 4) return std::nullopt;
            text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        }
        if (quotient) power = -power;
        bool known = false;
        for (const UnitName& unit : unit_names) {
            if (unit.name != name) continue;
            known = true;
            for (int i = 0; i < std::abs(power); ++i) {
                total.numerator *= power > 0 ? unit.numerator : unit.denominator;
                total.denominator *= power > 0 ? unit.denominator : unit.numerator;
            }
            for (std::size_t i = 0; i < 4; ++i) total.exponents[i] += power * unit.exponents[i];
        }
        if (!known) return std::nullopt;
    }
    if (first) return std::nullopt;
    return total;
}

std::optional<double> parse_number(std::string_view text) {
    text = trimmed(text);
    if (text.empty() || number_length(text) != text.size()) return std::nullopt;
    if (text.front() == '+') text.remove_prefix(1);
    double value = 0.0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

Quantity parse_quantity(std::string_view text, const Dimension& expected, Units plain) {
    const std::string wanted = expected.unit.empty()
                                   ? fmt::format("expected a number, e.g. {}", expected.example)
                                   : fmt::format("expected {}, e.g. \"{}\"",
                                                 with_article(expected.name), expected.example);
    const auto refuse = [&](const std::string& why) {
        return Quantity{std::nullopt, fmt::format("{}; got \"{}\"{}", wanted, text, why)};
    };
    const std::string_view all = trimmed(text);
    const std::size_t n = number_length(all);
    if (n == 0) {
        const std::size_t sign = !all.empty() && (all[0] == '-' || all[0] == '+') ? 1 : 0;
        const bool zeros = all.size() > sign + 1 && all[sign] == '0' && is_digit(all[sign + 1]);
        return refuse(zeros ? " (write numbers without leading zeros)" : "");
    }
    const std::optional<double> number = parse_number(all.substr(0, n));
    if (!number) return refuse(" (too large or too small a number)");
    const std::string_view unit = trimmed(all.substr(n));
    if (unit.size() > 1 && unit[0] == ',' && is_digit(unit[1])) {
        return refuse(" (decimals stand behind a point: 1.5, not 1,5)");
    }
    if (unit.empty()) {
        if (expected.unit_required && *number != 0.0) {
            return refuse(" without a unit: it must say degrees or radians");
        }
        return {convert(*number, plain_factor(expected.exponents, plain)), {}};
    }
    const std::optional<UnitFactor> factor = parse_unit(unit);
    if (!factor) return refuse(fmt::format(" (\"{}\" is not a unit)", unit));
    if (factor->exponents != expected.exponents) {
        const std::string_view found = dimension::name_of(factor->exponents);
        return refuse(found.empty() ? " (another dimension)" : fmt::format(" ({})", found));
    }
    return {convert(*number, *factor), {}};
}

std::string print_number(double value) {
    std::array<char, 64> text{};
    const double size = std::abs(value);
    const bool fixed = value == 0.0 || (size >= 1e-4 && size < 1e10);
    const auto result = fixed ? std::to_chars(text.data(), text.data() + text.size(), value,
                                              std::chars_format::fixed)
                              : std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), result.ptr};
}

std::string print_quantity(double value, const Dimension& dimension) {
    if (dimension.unit.empty()) return print_number(value);
    if (dimension.exponents != dimension::angle.exponents) {
        return fmt::format("{} {}", print_number(value), dimension.unit);
    }
    // Degrees, if some decimal close by gives back the same radians; else radians.
    const double degrees = value * 180.0 / pi;
    const auto exact = [value](double x) { return x * pi / 180.0 == value; };
    for (const int digits : {6, 12, 14, 15, 16}) {
        const auto rounded = parse_number(fmt::format("{:.{}g}", degrees, digits));
        if (rounded && exact(*rounded)) return print_number(*rounded) + " deg";
    }
    double below = degrees, above = degrees;
    for (int i = 0; i < 8; ++i) {
        if (exact(below)) return print_number(below) + " deg";
        if (exact(above)) return print_number(above) + " deg";
        below = std::nextafter(below, -1e300);
        above = std::nextafter(above, 1e300);
    }
    return print_number(value) + " rad";
}

}  // namespace hawser::io
