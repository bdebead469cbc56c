// The same hemisphere in the layouts and conventions of five programs gives the same coefficients
// (validation of the readers), and what the checks of hydro_checks.hpp say of wrong sets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <sstream>

#include "hydro_checks.hpp"
#include "io/hdf5.hpp"
#include "io/hydro_file.hpp"

namespace hawser::io {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
constexpr double rho = 1025.0, g = 9.80665, radius = 2.0, ulen = 2.0, infinite = 1e300;
const double volume = 2.0 / 3 * M_PI * radius * radius * radius;
const std::vector<double> frequencies{1.0, 1.5}, headings{0, 90, 180, 270};

// The numbers, dimensional and e^{+i w t}; tests/tools/capytaine_sample.py has the same.
Mat6 added_mass(double w) {
    const double scale = w == infinite ? 0.7 : w == 0.0 ? 0.8 : w == 1.0 ? 1.1 : 1.0;
    Mat6 A = Mat6::Zero();
    A(0, 0) = A(1, 1) = 9e3;
    A(2, 2) = 1.1e4;
    A(0, 4) = A(4, 0) = -300;
    A(1, 3) = A(3, 1) = 300;
    return scale * A;
}
/// By Haskind's relation in deep water from the excitation below.
Mat6 damping(double w) {
    const double to_B = w * w * w / (4 * M_PI * rho * g * g * g);
    Mat6 B = Mat6::Zero();
    B(0, 0) = B(1, 1) = to_B * M_PI * 1e8 * w * w;
    B(2, 2) = to_B * 2 * M_PI * (6.4e9 + 1e6 * w * w);
    return B;
}
CVec6 excitation(double w, double degrees) {
    const double c = std::cos(degrees * M_PI / 180), s = std::sin(degrees * M_PI / 180);
    CVec6 X;
    X << Complex(0, 1e4 * w * c), Complex(0, 1e4 * w * s), Complex(8e4, 1e3 * w), -500 * w * s,
        500 * w * c, 0;
    return X;
}
double C33() { return rho * g * M_PI * radius * radius; }

fs::path folder() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    const fs::path path = fs::path(testing::TempDir()) / "hawser_formats" / info->name();
    fs::remove_all(path);
    fs::create_directories(path);
    return path;
}

std::string row(const std::vector<double>& a) {
    std::string line;
    char word[40];
    for (const double x : a) std::snprintf(word, sizeof word, " %.14g", x), line += word;
    return line + "\n";
}

HydroDatabase stated(HydroFormat format, const fs::path& path) {
    HydroDatabase d;
    d.format = format;
    d.path = path.string();
    if (format == HydroFormat::wamit || format == HydroFormat::hams) {
        d.rho = rho;
        d.displaced_volume = volume;
        d.centre_of_buoyancy = Vec3(0, 0, -3.0 / 8 * radius);
        d.ulen = ulen;
    }
    return d;
}

/// A set in WAMIT's layout. `first` makes the first column of w, `sign` is that of the imaginary
/// parts, and the limits stand as given.
HydroDatabase write_wamit(HydroFormat format, const std::function<double(double)>& first,
                          double sign, double zero, double infinity) {
    const fs::path stem = folder() / "ball";
    const auto L = [](int n) { return std::pow(ulen, n); };
    const auto k = [](int i) { return i >= 3 ? 1 : 0; };
    std::ofstream one(stem.string() + ".1"), three(stem.string() + ".3"),
        hst(stem.string() + ".hst");
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
            if (added_mass(1)(i, j) == 0.0) continue;
            const double scale = rho * L(3 + k(i) + k(j));
            one << row({zero, i + 1.0, j + 1.0, added_mass(0)(i, j) / scale})
                << row({infinity, i + 1.0, j + 1.0, added_mass(infinite)(i, j) / scale});
            for (const double w : frequencies)
                one << row({first(w), i + 1.0, j + 1.0, added_mass(w)(i, j) / scale,
                            damping(w)(i, j) / (scale * w)});
        }
    for (const double w : frequencies)
        for (const double b : headings)
            for (int i = 0; i < 6; ++i) {
                const Complex X = excitation(w, b)[i] / (rho * g * L(2 + k(i)));
                three << row({first(w), b, i + 1.0, std::abs(X), sign * std::arg(X) * 180 / M_PI,
                              X.real(), sign * X.imag()});
            }
    hst << row({3, 3, C33() / (rho * g * L(2))});
    return stated(format, stem);
}

void expect_the_ball(const HydroData& d) {
    ASSERT_EQ(d.frequencies.size(), 2u);
    for (std::size_t f = 0; f < 2; ++f) {
        const double w = frequencies[f];
        EXPECT_NEAR(d.frequencies[f], w, 1e-12);
        // The texts carry 14 digits.
        EXPECT_LT((d.added_mass[f] - added_mass(w)).norm(), 1e-8);
        EXPECT_LT((d.damping[f] - damping(w)).norm(), 1e-8);
        ASSERT_EQ(d.excitation.headings.size(), 4u);
        for (const auto& h : d.excitation.headings)
            EXPECT_LT((h.values[f] - excitation(w, h.heading * 180 / M_PI)).norm(), 1e-6)
                << h.heading;
    }
    EXPECT_TRUE(d.excitation.full_circle);
    EXPECT_NEAR(d.displaced_volume, volume, 1e-9);
    EXPECT_NEAR(d.centre_of_buoyancy.z(), -0.75, 1e-12);
    EXPECT_NEAR(d.density, rho, 1e-12);
    EXPECT_NEAR(d.waterplane_stiffness(0, 0), C33(), 1e-6);
    // K:7: C55 = 0 less rho g V z_B is the waterplane's pi/4 r^4.
    EXPECT_NEAR(d.waterplane_stiffness(2, 2), rho * g * M_PI / 4 * std::pow(radius, 4), 1e-6);
}
void expect_limits(const HydroData& d) {
    ASSERT_TRUE(d.added_mass_0 && d.added_mass_inf);
    EXPECT_LT((*d.added_mass_0 - added_mass(0)).norm(), 1e-8);
    EXPECT_LT((*d.added_mass_inf - added_mass(infinite)).norm(), 1e-8);
}

HydroData read(const HydroDatabase& d) { return read_hydro(d, Water{rho, g}); }
std::string complaint(const HydroDatabase& d) {
    try {
        (void)read(d);
    } catch (const HydroFileError& e) {
        return e.what();
    }
    return "no complaint";
}
double period(double w) { return 2 * M_PI / w; }
double same(double w) { return w; }

TEST(HydroFormats, WamitByPeriod) {
    const HydroData d = read(write_wamit(HydroFormat::wamit, period, 1, -1, 0));
    expect_the_ball(d);
    expect_limits(d);
}

TEST(HydroFormats, WamitByFrequencyAsksForTheLimits) {
    HydroDatabase d = write_wamit(HydroFormat::wamit, same, 1, 0, -1);
    d.period_column = PeriodColumn::frequency;
    const std::string said = complaint(d);
    EXPECT_THAT(said, HasSubstr("expected the key `limits`"));
    EXPECT_EQ(said.find("is a limit"), said.rfind("is a limit")) << "once, not of every row";
    d.limits = HydroLimits::reversed;
    expect_the_ball(read(d));
    expect_limits(read(d));
}

TEST(HydroFormats, WamitByWavenumberOfDeepWater) {
    HydroDatabase d = write_wamit(
        HydroFormat::wamit, [](double w) { return w * w / g * ulen; }, 1, -1, 0);
    d.period_column = PeriodColumn::deep_wavenumber;
    d.limits = HydroLimits::wamit;
    expect_the_ball(read(d));
}

TEST(HydroFormats, HamsIsConjugateWithReversedLimits) {
    HydroDatabase d = write_wamit(HydroFormat::hams, same, -1, 0, -1);
    d.period_column = PeriodColumn::frequency;
    const HydroData data = read(d);
    expect_the_ball(data);
    expect_limits(data);
}

TEST(HydroFormats, Capytaine) {
    const fs::path sample = fs::path(HAWSER_SOURCE_DIR) / "tests/common/hydro/ball.nc";
    const HydroData d = read(stated(HydroFormat::capytaine, sample));
    expect_the_ball(d);
    expect_limits(d);
    EXPECT_TRUE(std::isinf(d.depth));
}

TEST(HydroFormats,
     Bemio) {  // WEC-Sim's writeBEMIOH5: (dof, heading, frequency), over rho, rho w ...
    const fs::path path = folder() / "ball.h5";
    Hdf5File f = Hdf5File::create(path);
    const auto scalar = [&](const char* name, double x) {
        f.write(name, std::vector<double>{x}, {1, 1});
    };
    scalar("simulation_parameters/rho", rho);
    scalar("simulation_parameters/g", g);
    scalar("simulation_parameters/scaled", 0);
    f.write_text("simulation_parameters/water_depth", "infinite");
    f.write("simulation_parameters/w", frequencies, {2, 1});
    f.write("simulation_parameters/wave_dir", headings, {4, 1});
    scalar("body1/properties/disp_vol", volume);
    f.write("body1/properties/cb", std::vector<double>{0, 0, -0.75}, {3, 1});
    std::vector<double> A, B, inf, C(36, 0.0), re, im;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
            inf.push_back(added_mass(infinite)(i, j) / rho);
            for (const double w : frequencies) {
                A.push_back(added_mass(w)(i, j) / rho);
                B.push_back(damping(w)(i, j) / (rho * w));
            }
        }
    for (int i = 0; i < 6; ++i)
        for (const double b : headings)
            for (const double w : frequencies) {
                re.push_back(excitation(w, b)[i].real() / (rho * g));
                im.push_back(excitation(w, b)[i].imag() / (rho * g));
            }
    C[14] = C33() / (rho * g);
    const std::string at = "body1/hydro_coeffs/";
    f.write(at + "added_mass/all", A, {6, 6, 2});
    f.write(at + "added_mass/inf_freq", inf, {6, 6});
    f.write(at + "radiation_damping/all", B, {6, 6, 2});
    f.write(at + "excitation/re", re, {6, 4, 2});
    f.write(at + "excitation/im", im, {6, 4, 2});
    f.write(at + "linear_restoring_stiffness", C, {6, 6});
    f.close();
    const HydroData d = read(stated(HydroFormat::bemio, path));
    expect_the_ball(d);
    ASSERT_TRUE(d.added_mass_inf);
    EXPECT_LT((*d.added_mass_inf - added_mass(infinite)).norm(), 1e-8);
    EXPECT_TRUE(std::isinf(d.depth));
}

TEST(HydroFormats, Nemoh) {  // magnitude and phase in radians of e^{-i w t}; a zone per motion
    const fs::path path = folder();
    fs::create_directories(path / "Mesh");
    fs::create_directories(path / "Results");
    std::ofstream(path / "Nemoh.cal")
        << "--- Environment ---\n1025.0 ! RHO ! KG/M**3 ! Fluid specific volume\n"
        << "9.80665 ! G ! M/S**2 ! Gravity\n0. ! DEPTH ! M ! Water depth\n"
        << "0. 0. ! XEFF YEFF ! M ! Wave measurement point\n--- Description of floating bodies "
           "---\n"
        << "1 ! Number of bodies\n";
    std::ofstream rad(path / "Results/RadiationCoefficients.tec"),
        ex(path / "Results/ExcitationForce.tec");
    rad << "VARIABLES=\"w (rad/s)\"\n\"A   1   1\" \"B   1   1\"\n";
    for (int j = 0; j < 6; ++j) {
        rad << "Zone t=\"Motion of body   1 in DoF   " << j + 1 << "\",I=   2,F=POINT\n";
        for (const double w : frequencies) {
            std::vector<double> x{w};
            for (int i = 0; i < 6; ++i) {
                x.push_back(added_mass(w)(i, j));
                x.push_back(damping(w)(i, j));
            }
            rad << row(x);
        }
    }
    ex << "VARIABLES=\"w (rad/s)\"\n\"abs(F   1   1)\" \"angle(F   1   1)\"\n";
    for (const double b : headings) {
        ex << "Zone t=\"Diffraction force - beta = " << b << " deg\",I=   2,F=POINT\n";
        for (const double w : frequencies) {
            std::vector<double> x{w};
            for (int i = 0; i < 6; ++i) {
                x.push_back(std::abs(excitation(w, b)[i]));
                x.push_back(-std::arg(excitation(w, b)[i]));
            }
            ex << row(x);
        }
    }
    std::ofstream kh(path / "Mesh/KH.dat");
    for (int i = 0; i < 6; ++i) {
        std::vector<double> x(6, 0.0);
        if (i == 2) x[2] = C33();
        kh << row(x);
    }
    char text[40];
    std::snprintf(text, sizeof text, "%.14g", volume);
    std::ofstream(path / "Mesh/Hydrostatics.dat")
        << " XF =   0.000 - XG =   0.000\n YF =   0.000 - YG =   0.000\n"
        << " ZF =  -0.750 - ZG =  -0.750\n Displacement =  " << text
        << "\n Waterplane area =  12.566\n";
    for (std::ofstream* f : {&rad, &ex, &kh}) f->close();
    const HydroData d = read(stated(HydroFormat::nemoh, path));
    expect_the_ball(d);
    EXPECT_TRUE(std::isinf(d.depth));
}

TEST(HydroFormats, ForgottenConjugationIsAnError) {
    HydroDatabase d = write_wamit(HydroFormat::wamit, period, -1, -1, 0);
    EXPECT_THAT(complaint(d), HasSubstr("the phases follow e^(-i w t), or headings say where waves "
                                        "come from"));
}

TEST(HydroFormats, DensityOfTheCaseMustBeThatOfTheFile) {
    HydroDatabase d =
        stated(HydroFormat::capytaine, fs::path(HAWSER_SOURCE_DIR) / "tests/common/hydro/ball.nc");
    d.rho = 1000.0;
    EXPECT_THAT(complaint(d), HasSubstr("says a density of 1025 kg/m3; the key rho says 1000"));
}

TEST(HydroFormats, DifferenceQtfOfOneTriangleIsFilledByItsConjugate) {
    HydroDatabase d = write_wamit(HydroFormat::wamit, period, 1, -1, 0);
    std::ofstream(d.path + ".12d") << row({period(1), period(1), 0, 0, 1, 3, 0, 3, 0})
                                   << row({period(1.5), period(1), 0, 0, 1, 5, 0, 3, 4})
                                   << row({period(1.5), period(1.5), 0, 0, 1, 6, 0, 6, 0});
    std::ofstream(d.path + ".12s") << row({period(1.5), period(1), 0, 0, 5, 5, 0, 3, 4});
    const HydroData data = read(d);
    ASSERT_EQ(data.difference.frequencies.size(), 2u);
    ASSERT_EQ(data.difference.pairs.size(), 1u);
    const auto& Q = data.difference.pairs[0].values;  // rho g L per amplitude squared
    EXPECT_NEAR(std::abs(Q[2][0] - rho * g * ulen * Complex(3, 4)), 0.0, 1e-6);
    EXPECT_NEAR(std::abs(Q[1][0] - rho * g * ulen * Complex(3, -4)), 0.0, 1e-6);
    EXPECT_NEAR(std::abs(Q[3][0] - rho * g * ulen * 6.0), 0.0, 1e-6);
    const auto& S = data.sum.pairs[0].values;
    EXPECT_NEAR(std::abs(S[1][4] - rho * g * ulen * ulen * Complex(3, 4)), 0.0, 1e-6);
    EXPECT_EQ(data.sum.pairs[0].given[0], 0);  // none was given
    // Its diagonal stands in for a file of mean drift.
    EXPECT_EQ(data.mean_drift.frequencies, data.difference.frequencies);
    EXPECT_NEAR(data.mean_drift.headings[0].values[1][0], rho * g * ulen * 6.0, 1e-6);
    EXPECT_TRUE(data.drift_is_of_qtf);
    // The drift of a .9 that is 20 % off the diagonal is told.
    std::ofstream nine(d.path + ".9");
    for (const double w : frequencies)
        for (const double b : headings)
            nine << row(
                {period(w), b, b, 1, 0, 0, (w == 1.0 ? 3 : 7.2) * std::cos(b * M_PI / 180), 0});
    nine.close();
    const HydroData both = read(d);
    EXPECT_FALSE(both.drift_is_of_qtf);
    EXPECT_THAT(both.doubts.back().sentence,
                HasSubstr("surge mean drift and the diagonal of the "
                          "difference QTF differ by 17 % of the largest"));
}

TEST(HydroFormats, PhaseOriginMovesTheCrest) {
    HydroDatabase d = write_wamit(HydroFormat::wamit, period, 1, -1, 0);
    d.phase_origin = {3.0, -2.0};
    const HydroData moved = read(d);
    for (const auto& h : moved.excitation.headings) {
        const double k = 1.5 * 1.5 / g;
        const Complex turn =
            std::polar(1.0, k * (3 * std::cos(h.heading) - 2 * std::sin(h.heading)));
        EXPECT_LT((h.values[1] - turn * excitation(1.5, h.heading * 180 / M_PI)).norm(), 1e-6);
    }
}

TEST(HydroFormats, OneBodyOfTwoMustBeNamed) {
    HydroDatabase d = write_wamit(HydroFormat::wamit, period, 1, -1, 0);
    std::ofstream(d.path + ".1", std::ios::app)
        << row({period(1), 7, 7, 1, 0.1}) << row({period(1), 1, 7, 1, 0.1});
    EXPECT_THAT(complaint(d), HasSubstr("mode 7 belongs to a second body"));
    d.body = 1;
    const HydroData data = read(d);
    expect_the_ball(data);
    EXPECT_THAT(data.notes, testing::Contains(HasSubstr("body 1 of several is read")));
}

/// Coefficients that satisfy Haskind's relation in deep water exactly, by B = k/(8 pi rho g c_g) *
/// int |X|^2: heave radiates evenly, surge with cos b.
HydroDatabase haskind_ball() {
    const fs::path stem = folder() / "ball";
    std::ofstream one(stem.string() + ".1"), three(stem.string() + ".3"),
        hst(stem.string() + ".hst");
    for (int n = 1; n <= 12; ++n) {
        const double w = 0.25 * n, k = w * w / g, c_g = g / (2 * w);
        const double X3 = C33() * std::exp(-0.75 * k) - w * w * 9e3,
                     X1 = w * w * (rho * volume + 9e3) * std::exp(-k);
        const double to_B = k / (8 * M_PI * rho * g * c_g);
        const double B3 = to_B * 2 * M_PI * X3 * X3, B1 = to_B * M_PI * X1 * X1;
        for (const int i : {1, 2, 3})
            one << row(
                {period(w), double(i), double(i), 9e3 / rho, (i == 3 ? B3 : B1) / (rho * w)});
        for (const double b : headings) {
            const double c = std::cos(b * M_PI / 180), s = std::sin(b * M_PI / 180);
            three << row({period(w), b, 1, 0, 0, 0, X1 * c / (rho * g)})
                  << row({period(w), b, 2, 0, 0, 0, X1 * s / (rho * g)})
                  << row({period(w), b, 3, 0, 0, X3 / (rho * g), 0});
        }
    }
    hst << row({3, 3, C33() / (rho * g)});
    HydroDatabase d = stated(HydroFormat::wamit, stem);
    d.ulen = 1.0;
    return d;
}

TEST(HydroChecks, HaskindHoldsToRounding) {
    const HydroData d = read_hydro(haskind_ball(), Water{rho, g}, infinite);
    ASSERT_TRUE(haskind_misfit(d));
    EXPECT_LT(*haskind_misfit(d), 1e-10);
}

TEST(HydroChecks, FrequenciesReadAsPeriodsAreFound) {
    HydroDatabase d = haskind_ball();
    d.period_column = PeriodColumn::frequency;
    try {
        (void)read_hydro(d, Water{rho, g}, infinite);
        ADD_FAILURE() << "no complaint";
    } catch (const HydroFileError& e) {
        EXPECT_THAT(e.what(), HasSubstr("check period_column"));
    }
    d.period_column = PeriodColumn::automatic;
    const HydroData data = read_hydro(d, Water{rho, g}, infinite);
    EXPECT_NEAR(data.frequencies.front(), 0.25, 1e-9);
    EXPECT_THAT(data.notes.front(), HasSubstr("taken for periods"));
}

TEST(HydroChecks, ExcitationOfAnotherRunIsFound) {
    const HydroDatabase d = haskind_ball();
    std::string text;
    {
        std::ifstream in(d.path + ".1");
        std::ofstream out(d.path + ".new");
        for (std::string line; std::getline(in, line);) {
            std::istringstream words(line);
            std::vector<double> x;
            for (double v = 0; words >> v;) x.push_back(v);
            x[4] *= 4;
            out << row(x);
        }
    }
    fs::rename(d.path + ".new", d.path + ".1");
    try {
        (void)read_hydro(d, Water{rho, g}, infinite);
        ADD_FAILURE() << "no complaint";
    } catch (const HydroFileError& e) {
        EXPECT_THAT(e.what(), HasSubstr("they are not of one run"));
    }
}

TEST(HydroChecks, NegativeDampingIsAnError) {
    const HydroDatabase d = haskind_ball();
    std::ofstream(d.path + ".1", std::ios::app) << row({period(3.5), 3, 3, 8, -4});
    EXPECT_THAT(complaint(d), HasSubstr("damping of mode 3 is negative at 3.5 rad/s"));
}

}  // namespace
}  // namespace hawser::io
