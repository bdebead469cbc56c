#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "io/quantity.hpp"

namespace hawser::io {
namespace {

namespace dim = dimension;

double value(const char* text, const Dimension& d, Units units = Units::SI) {
    const Quantity q = parse_quantity(text, d, units);
    EXPECT_TRUE(q.value) << text << ": " << q.error;
    return q.value.value_or(NAN);
}

std::string error(const char* text, const Dimension& d) {
    const Quantity q = parse_quantity(text, d);
    EXPECT_FALSE(q.value) << text;
    return q.error;
}

TEST(Quantity, UnitsConvertToSi) {
    EXPECT_EQ(value("1.4 m/s", dim::speed), 1.4);
    EXPECT_EQ(value("5338 kN", dim::force), 5338e3);
    EXPECT_EQ(value("406 mm", dim::length), 0.406);
    EXPECT_EQ(value("36 km/h", dim::speed), 10.0);
    EXPECT_EQ(value("87.5 knot", dim::speed), 87.5 * 1852.0 / 3600.0);
    EXPECT_EQ(value("1 h", dim::time), 3600.0);
    EXPECT_EQ(value("103800 t", dim::mass), 103.8e6);
    EXPECT_EQ(value("207 GPa", dim::stress), 207e9);
    EXPECT_EQ(value("100kN/m2", dim::stiffness_per_length), 1e5);
    EXPECT_EQ(value("10 kN.s/m^2", dim::damping_per_length), 1e4);
    EXPECT_DOUBLE_EQ(value("0.1 Hz", dim::frequency), 0.2 * std::numbers::pi);
    EXPECT_EQ(value("10 deg", dim::angle), 10.0 * std::numbers::pi / 180.0);
    EXPECT_DOUBLE_EQ(value("15 kN.m/deg", dim::rotational_stiffness),
                     15e3 * 180.0 / std::numbers::pi);
    // 1 ft = 0.3048 m and 1 lb = 0.45359237 kg by definition; 1 lbf = 1 lb x 9.80665 m/s2.
    EXPECT_EQ(value("10 ft", dim::length), 3.048);
    EXPECT_DOUBLE_EQ(value("1 kip", dim::force), 4448.2216152605);
    EXPECT_NEAR(value("1 ksi", dim::stress), 6.894757293168e6, 1e-3);
    EXPECT_EQ(value("1 tf", dim::force), 9806.65);
}

TEST(Quantity, PlainNumbersFollowTheUnitsOfTheFile) {
    EXPECT_EQ(value("3e6", dim::stress), 3e6);
    EXPECT_EQ(value("90", dim::angle), std::numbers::pi / 2);  // degrees in every system
    EXPECT_EQ(value("90", dim::angle, Units::US), std::numbers::pi / 2);
    EXPECT_EQ(value("5", dim::force, Units::SI_kN), 5e3);
    EXPECT_EQ(value("0.589", dim::mass_per_length, Units::SI_kN), 589.0);
    EXPECT_EQ(value("100", dim::stiffness_per_length, Units::SI_kN), 1e5);
    EXPECT_DOUBLE_EQ(value("1", dim::force, Units::US), 4448.2216152605);
    EXPECT_DOUBLE_EQ(value("1", dim::mass, Units::US), 453.59237);
    EXPECT_DOUBLE_EQ(value("1", dim::stiffness, Units::US), 4448.2216152605 / 0.3048);
    EXPECT_EQ(value("1.5", dim::number, Units::US), 1.5);
}

TEST(Quantity, CompoundsWithAnAngleMustSayWhich) {
    EXPECT_NE(error("2.0e8", dim::rotational_damping).find("degrees or radians"),
              std::string::npos);
    EXPECT_EQ(value("2.0e8 N.m.s/rad", dim::rotational_damping), 2e8);
    EXPECT_EQ(value("0", dim::rotational_damping), 0.0);
    EXPECT_FALSE(parse_quantity("2.0e8 N.m.s", dim::rotational_damping).value);
}

TEST(Quantity, WrongDimensionNamesBoth) {
    EXPECT_EQ(error("103800 kN", dim::mass),
              "expected a mass, e.g. \"103800 t\"; got \"103800 kN\" (force)");
    EXPECT_EQ(error("5 m", dim::force), "expected a force, e.g. \"5338 kN\"; got \"5 m\" (length)");
}

TEST(Quantity, OnlyDecimalNumbersAreNumbers) {
    for (const char* bad : {"0777", "-01", "0x1F", "inf", "nan", "1,5", "1_000", "", "m", "1e", ".",
                            "- 1", "1 2", "1e999"}) {
        EXPECT_FALSE(parse_quantity(bad, dim::number).value) << bad;
    }
    for (const char* good : {"0", "-0.5", "+1.5", ".5", "5.", "1e-3", "0.1e+5", "10"}) {
        EXPECT_TRUE(parse_quantity(good, dim::number).value) << good;
    }
}

TEST(Quantity, AmbiguousUnitsAreRefused) {
    EXPECT_FALSE(parse_unit("kg/m.s"));  // kg/(m s) or (kg/m) s?
    EXPECT_TRUE(parse_unit("kg/m/s"));
    EXPECT_FALSE(parse_unit("kN."));
    EXPECT_FALSE(parse_unit("Kn"));  // neither knot nor kN
    EXPECT_FALSE(parse_unit("m0"));
}

TEST(Quantity, PrintedValuesReadBackToTheSameBits) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> mantissa(-10.0, 10.0);
    std::uniform_int_distribution<int> exponent(-30, 30);
    for (int i = 0; i < 20000; ++i) {
        const double x = mantissa(random) * std::pow(10.0, exponent(random));
        for (const Dimension* d : {&dim::length, &dim::number, &dim::rotational_damping}) {
            EXPECT_EQ(value(print_quantity(x, *d).c_str(), *d), x);
        }
        const double angle = mantissa(random);
        EXPECT_EQ(value(print_quantity(angle, dim::angle).c_str(), dim::angle), angle);
    }
}

TEST(Quantity, DegreesStayReadable) {
    EXPECT_EQ(print_quantity(112.5 * std::numbers::pi / 180.0, dim::angle), "112.5 deg");
    EXPECT_EQ(print_quantity(1500.0, dim::length), "1500 m");
    EXPECT_EQ(print_quantity(0.1, dim::number), "0.1");
}

}  // namespace
}  // namespace hawser::io
