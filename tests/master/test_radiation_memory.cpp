// Radiation with memory: the fit K:10, the discrete convolution K:9, and the hull with either of
// them.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "coupled_modes.hpp"
#include "nonnegative.hpp"
#include "radiation_memory.hpp"
#include "spar_hull.hpp"

namespace hawser::master {
namespace {

/// Data of a body whose memory is two oscillators exactly, heave and surge-pitch apart.
MemoryFit two_oscillators() {
    MemoryFit fit;
    fit.oscillators.resize(2);
    fit.oscillators[0].a = 0.15, fit.oscillators[0].b = 0.4;
    fit.oscillators[1].a = 0.25, fit.oscillators[1].b = 0.9;
    for (Oscillator& o : fit.oscillators) {
        // 2 s a' / (...) alone: B vanishes at w = 0 where 2 a first = 2 b second
        o.first(2, 2) = 2e6 * o.a, o.second(2, 2) = o.first(2, 2) * o.a / o.b;
        o.first(0, 0) = 8e6 * o.b, o.second(0, 0) = o.first(0, 0) * o.a / o.b;
        o.first(0, 4) = o.first(4, 0) = -3e7 * o.b;
        o.second(0, 4) = o.second(4, 0) = o.first(0, 4) * o.a / o.b;
        o.first(4, 4) = 6e8 * o.b, o.second(4, 4) = o.first(4, 4) * o.a / o.b;
    }
    return fit;
}

Mat6 some_mass() {
    Vec6 m;
    m << 6e7, 6e7, 4e7, 2e11, 2e11, 1e9;
    return m.asDiagonal();
}

HydroData data_of(const MemoryFit& fit, const Mat6& infinite, double step, double top) {
    HydroData data;
    for (double w = step; w < top; w += step) {
        const CMat6 H = fit.at(w);
        data.frequencies.push_back(w);
        data.damping.push_back(H.real());
        data.added_mass.push_back(infinite + H.imag() / w);
    }
    data.added_mass_inf = infinite;
    return data;
}

TEST(MemoryFit, FindsTheOscillatorsThatMadeTheData) {
    const MemoryFit made = two_oscillators();
    const MemoryFit fit = fit_memory(data_of(made, some_mass(), 0.05, 3), some_mass(), 0.25, 2);
    ASSERT_EQ(fit.oscillators.size(), 2u);
    EXPECT_LT(fit.rms_error, 1e-8);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(fit.oscillators[i].a, made.oscillators[i].a, 1e-6);
        EXPECT_NEAR(fit.oscillators[i].b, made.oscillators[i].b, 1e-6);
        EXPECT_LT((fit.oscillators[i].first - made.oscillators[i].first).norm(),
                  1e-6 * made.oscillators[i].first.norm());
    }
}

TEST(MemoryFit, HoldsTheSparsDataAndNeverGivesEnergyToAMotion) {
    const HydroData& data = spar_data();
    const MemoryFit fit = fit_memory(data, *data.added_mass_inf, 0.5, {});
    EXPECT_LT(fit.rms_error, 0.005);  // what "auto" asks for
    EXPECT_LE(fit.oscillators.size(), 6u);
    EXPECT_GE(fit.least_damping, -2e-6);
    // Within the waves each number is that of the file, to a percent of its largest.
    Mat6 most_A = Mat6::Zero(), most_B = Mat6::Zero();
    for (std::size_t i = 0; i < data.frequencies.size(); ++i) {
        most_A = most_A.cwiseMax((data.added_mass[i] - *data.added_mass_inf).cwiseAbs());
        most_B = most_B.cwiseMax(data.damping[i].cwiseAbs());
    }
    for (std::size_t i = 0; i < data.frequencies.size(); ++i) {
        const double w = data.frequencies[i];
        if (w > 1.5) continue;
        const CMat6 H = fit.at(w);
        // Heave hardly makes waves: 1.4 % of its inertia.
        EXPECT_NEAR(H(2, 2).real(), data.damping[i](2, 2), 0.02 * most_B(2, 2)) << w;
        for (const auto& [r, c] : {std::pair{0, 0}, {0, 4}, {4, 4}}) {
            EXPECT_NEAR(H(r, c).real(), data.damping[i](r, c), 0.01 * most_B(r, c)) << w;
            EXPECT_NEAR(H(r, c).imag(), w * (data.added_mass[i] - *data.added_mass_inf)(r, c),
                        0.01 * w * most_A(r, c) + 1e-3 * most_B(r, c))
                << w;
        }
    }
}

TEST(MemoryFit, NeverLosesByMoreOscillatorsAndAutoTakesTheFewestThatDo) {
    const HydroData& data = spar_data();
    std::vector<MemoryFit> fits;
    for (int order = 1; order <= 8; ++order) {
        fits.push_back(fit_memory(data, *data.added_mass_inf, 0.5, order));
        const MemoryFit& fit = fits.back();
        ASSERT_LE(std::ssize(fit.oscillators), order);
        if (order > 1) {
            EXPECT_LE(fit.rms_error, fits[fits.size() - 2].rms_error);
        }
        // No steady velocity meets a radiation load, and no motion gains energy at any frequency,
        // looked at between the frequencies that the fit looks at and far beyond.
        EXPECT_LT(fit.at(0.0).norm(), 1e-9 * fit.at(0.6).norm());
        for (double w = 0.0037; w < 30; w *= 1.01) {
            const Vec6 scale = data.added_mass_inf->diagonal().cwiseSqrt().cwiseMax(1e3);
            const Mat6 B = scale.cwiseInverse().asDiagonal() * fit.at(w).real() *
                           scale.cwiseInverse().asDiagonal();
            EXPECT_GT(Eigen::SelfAdjointEigenSolver<Mat6>(B).eigenvalues()[0], -1e-5) << w;
        }
    }
    const auto fewest =
        std::find_if(fits.begin(), fits.end(), [](const auto& f) { return f.rms_error < 0.005; });
    const MemoryFit taken = fit_memory(data, *data.added_mass_inf, 0.5, {});
    EXPECT_EQ(std::ssize(taken.oscillators), 1 + (fewest - fits.begin()));
    EXPECT_EQ(taken.rms_error, fewest->rms_error);
}

TEST(MemoryFit, MendsNegativeDampingByALittle) {
    HydroData data = data_of(two_oscillators(), some_mass(), 0.05, 3);
    for (std::size_t i = 0; i < data.frequencies.size(); ++i)  // as badly meshed panels give it
        if (data.frequencies[i] > 1.5) data.damping[i](2, 2) -= 3e4;
    const MemoryFit fit = fit_memory(data, some_mass(), 0.25, 4);
    EXPECT_GE(fit.least_damping, -2e-6);
    EXPECT_LT(fit.rms_error, 0.05);
}

TEST(NonnegativeQuadratic, MeetsTheConditionsOfItsMinimum) {
    const int n = 12;  // more unknowns than the rank of K: cuts that repeat each other
    Eigen::MatrixXd G(7, n);
    Eigen::VectorXd d(n);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < 7; ++j) G(j, i) = std::sin(1.7 * i * (j + 1) + j);
        d[i] = std::cos(2.3 * i);
    }
    G.col(11) = G.col(3);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
    solve_nonnegative(G.transpose() * G, d.cwiseMin(G.transpose() * Eigen::VectorXd::Ones(7)), x);
    const Eigen::VectorXd slope =
        G.transpose() * G * x - d.cwiseMin(G.transpose() * Eigen::VectorXd::Ones(7));
    EXPECT_GE(x.minCoeff(), 0.0);
    EXPECT_GT(x.maxCoeff(), 0.0);
    EXPECT_GE(slope.minCoeff(), -1e-9);    // no constraint is broken
    EXPECT_NEAR(x.dot(slope), 0.0, 1e-9);  // none pulls that does not bind
}

TEST(Retardation, OfALorentzianIsItsDampedOscillation) {
    // K = e^{-a t} cos(b t)  <=>  B = a/2 [1/(a^2 + (w-b)^2) + 1/(a^2 + (w+b)^2)]
    const double a = 0.3, b = 0.7;
    HydroData data;
    for (double w = 0.0; w < 120.0; w += w < 3 ? 0.01 : 0.05) {
        data.frequencies.push_back(w);
        data.damping.push_back(Mat6::Identity() * a / 2 *
                               (1 / (a * a + (w - b) * (w - b)) + 1 / (a * a + (w + b) * (w + b))));
    }
    const Retardation K(data);
    // The tail a/w^2 beyond 120 rad/s is worth 2/pi a/120 at most.
    for (const double t : {0.0, 0.5, 1.0, 3.0, 8.0})
        EXPECT_NEAR(K.at(t)(2, 2), std::exp(-a * t) * std::cos(b * t), 2e-3) << t;
}

TEST(Retardation, OfTheSparBelongsToItsAddedMass) {  // Kramers and Kronig
    const HydroData& data = spar_data();
    const Retardation K(data);
    const Mat6 estimated = estimated_infinite_added_mass(data, 100.0);
    for (const int i : {0, 4})
        EXPECT_NEAR(estimated(i, i), (*data.added_mass_inf)(i, i), 0.02 * estimated(i, i));
    for (std::size_t f = 4; f < data.frequencies.size(); f += 8) {
        const Mat6 A = K.added_mass(*data.added_mass_inf, data.frequencies[f], 100.0);
        // The file ends at 2 rad/s, where the damping in surge is 1 % of its largest.
        EXPECT_NEAR(A(0, 0), data.added_mass[f](0, 0), 0.02 * data.added_mass[f](0, 0));
    }
}

/// Load on a body that is driven with velocity cos(w t) in surge, at late times, as B + i w (A -
/// A(inf)).
template <class Load>
Complex impedance(double w, double D, const Load& load) {
    const int steps = static_cast<int>(200 / D);
    Complex sum = 0;
    double weights = 0;
    for (int n = 0; n <= steps; ++n) {
        const Vec6 f = load(n, n * D);
        const double x = (n * D - 150) / 50;  // a smooth window over the last 100 s
        if (x < -1) continue;
        const double weight = std::pow(std::cos(M_PI * x / 2), 4);
        sum += weight * -f[0] * std::polar(1.0, -w * n * D);
        weights += weight;
    }
    return 2.0 * sum / weights;
}

TEST(DiscreteMemory, ErrorFallsWithTheThirdPowerOfTheStep) {
    const MemoryFit made = two_oscillators();
    HydroData data = data_of(made, some_mass(), 0.005, 30);
    const Retardation K(data);
    const double w = 0.8;
    const auto velocity = [&](double t) { return Vec6(Vec6::Unit(0) * std::cos(w * t)); };
    std::vector<double> errors;
    const Complex whole = made.at(w)(0, 0);
    for (const double D : {1.0, 0.5}) {
        DiscreteMemory memory(K, D, 60);
        const Complex got = impedance(w, D, [&](int n, double t) {
            const Vec6 load = memory.load(t, velocity(t));
            memory.remember(n * D, velocity(t), -w * Vec6::Unit(0) * std::sin(w * t));
            return load;
        });
        errors.push_back(std::abs(got - whole) / std::abs(whole));
    }
    EXPECT_LT(errors[1], 3e-3);
    EXPECT_GT(errors[0] / errors[1], 5.0);
}

TEST(HullWithMemory, RespondsAtEveryFrequencyWithTheMatricesOfThatFrequency) {  // row B2
    using Form = RadiationMemoryKeys::Form;
    const HydroData& data = spar_data();
    for (const Form form : {Form::fitted, Form::discrete})
        for (const double w : {0.275, 0.325, 0.35, 0.475, 0.6, 0.9}) {
            // One degree of freedom is enough to say: a free hull in surge alone would need all
            // six, so the full linear equation is solved here in the frequency domain.
            Case c = spar_with_memory(form);
            c.environment.waves = {regular_wave(w, 0.01)};
            c.analysis.dynamics.ramp = 400;
            c.analysis.dynamics.platform_step = 0.25;
            Hull hull(c, &data);
            const CVec6 expected = linear_response(hull, data, w);
            const int n = 2000;
            Eigen::MatrixXd basis(n, 8), motion(n, 3);
            int row = 0;
            run_remembering(hull, State::Zero(), 0.25, 1600 + n,
                            [&](double t, const State& y, const HullLoads&) {
                                if (t < 400) return;
                                const double heave = 2 * M_PI / 21.3, pitch = 2 * M_PI / 45.87;
                                basis.row(row) << std::cos(w * t), std::sin(w * t), 1,
                                    (t - 650) / 250, std::cos(heave * t), std::sin(heave * t),
                                    std::cos(pitch * t), std::sin(pitch * t);
                                motion.row(row++) << y[0], y[2], y[4];
                            });
            ASSERT_EQ(row, n);
            const Eigen::MatrixXd fit = basis.colPivHouseholderQr().solve(motion) / 0.01;
            for (const auto& [i, k] : {std::pair{0, 0}, {1, 2}, {2, 4}}) {
                const Complex got(fit(0, i), -fit(1, i));
                // Error of the fit (0.5 % of the memory, itself a small part of the balance), and
                // of the file's end at 2 rad/s for the discrete form. Heave at 0.9 rad/s is 1e-4 m
                // per metre of wave: there what is left of the start shows.
                EXPECT_LT(std::abs(got - expected[k]), 0.01 * std::abs(expected[k]) + 5e-6)
                    << "motion " << k << " at " << w << ", form " << static_cast<int>(form);
            }
        }
}

TEST(HullWithMemory, MovesInARandomSeaAsTheFrequencyDomainSays) {
    // On springs and a little damping, so that every motion forgets its start; waves so small that
    // all is linear. Sum over the components of the response of each, at every instant.
    using Form = RadiationMemoryKeys::Form;
    const HydroData& data = spar_data();
    Vec6 stiffness = Vec6::Zero(), damping;
    stiffness.head<2>().setConstant(1e6);
    damping << 2e6, 2e6, 4e6, 6e9, 6e9, 1e9;
    for (const Form form : {Form::fitted, Form::discrete}) {
        Case c = spar_with_memory(form);
        c.platform->mass.reset();  // floats at its design draft
        c.environment.waves = {
            {.type = WaveType::jonswap, .Hs = 0.02, .Tp = 12, .gamma = 2, .seed = 7}};
        c.analysis.dynamics.ramp = 200;
        Hull hull(c, &data);
        const Mat6 M = mass_matrix(turned(hull.body(), Mat3::Identity()));
        Mat6 C =
            hull.static_stiffness({}, {.current = false, .wind_mean = false, .drift_mean = false});
        C.diagonal() += stiffness;
        std::vector<CVec6> response;
        for (const WaveComponent& wave : hull.sea().components()) {
            const double w = wave.omega;
            const Radiation r = radiation_at(data, w);
            const auto& table = data.excitation;
            const auto after = static_cast<std::size_t>(
                std::upper_bound(table.frequencies.begin(), table.frequencies.end(), w) -
                table.frequencies.begin());
            const double low = table.frequencies[after - 1], high = table.frequencies[after];
            const auto heading =
                std::find_if(table.headings.begin(), table.headings.end(),
                             [](const auto& h) { return std::abs(h.heading) < 1e-9; });
            const CVec6 X =
                ((high - w) * heading->values[after - 1] + (w - low) * heading->values[after]) /
                (high - low);
            Mat6 B = r.damping;
            B.diagonal() += damping;
            const CMat6 Z = (C - w * w * (M + r.added_mass)).cast<Complex>() +
                            Complex(0, w) * B.cast<Complex>();
            response.push_back(wave.amplitude * Z.fullPivLu().solve(X));
        }
        Vec6 square = Vec6::Zero(), difference = Vec6::Zero();
        run_remembering(
            hull, State::Zero(), 0.5, 3600,
            [&](double t, const State& y, const HullLoads&) {
                if (t < 1200) return;
                Vec6 expected = Vec6::Zero();
                for (std::size_t i = 0; i < response.size(); ++i) {
                    const WaveComponent& wave = hull.sea().components()[i];
                    expected += (response[i] * std::polar(1.0, wave.omega * t + wave.phase)).real();
                }
                square += expected.cwiseAbs2();
                difference += (y.head<6>() - expected).cwiseAbs2();
            },
            [&](double, const State& y) {
                return Vec6(-stiffness.cwiseProduct(y.head<6>()) -
                            damping.cwiseProduct(y.segment<6>(6)));
            });
        // 0.4 % of the memory, which is up to a fifth of the balance; the discrete form forgets
        // after 100 s.
        for (const int i : {0, 2, 4})
            EXPECT_LT(std::sqrt(difference[i] / square[i]), 0.005)
                << "motion " << i << ", form " << static_cast<int>(form);
    }
}

TEST(HullWithMemory, KeepsTheOrderOfRungeAndKutta) {
    State start = State::Zero();
    start[2] = 1.0, start[4] = 0.02;
    const auto end = [&](double h) {
        // one fit for all steps: that of the longest
        Case c = spar_with_memory(RadiationMemoryKeys::Form::fitted);
        c.analysis.dynamics.platform_step = 1.0;
        Hull hull(c, &spar_data());
        return State(run_remembering(hull, start, h, static_cast<int>(std::lround(64 / h))));
    };
    const State exact = end(0.125), coarse = end(1.0), fine = end(0.5);
    EXPECT_GT((coarse - exact).head<6>().norm() / (fine - exact).head<6>().norm(), 11.0);  // 16
}

TEST(HullWithMemory, HeavesWithThePeriodThatItsModesTell) {  // row B2: 21.30 s
    const Hull hull(spar_with_memory(RadiationMemoryKeys::Form::fitted), &spar_data());
    const Mat6 K =
        hull.static_stiffness({}, {.current = false, .wind_mean = false, .drift_mean = false});
    const auto modes = coupled_modes(
        K, [&](double w) { return hull.static_mass({}, w); }, [](double) { return Mat6::Zero(); });
    EXPECT_NEAR(modes[2].period().value(), 21.30, 0.02);
    EXPECT_NEAR(modes[4].period().value(), 45.87, 0.05);
}

TEST(HullWithMemory, AsksForTheInfiniteFrequencyOrLeaveToEstimateIt) {
    HydroData data = spar_data();
    data.added_mass_inf.reset();
    Case c = spar_with_memory(RadiationMemoryKeys::Form::fitted);
    try {
        const Hull hull(c, &data);
        FAIL() << "no added mass at infinite frequency, and no complaint";
    } catch (const RunError& error) {
        EXPECT_EQ(error.code(), ExitCode::input);
        EXPECT_NE(std::string(error.what()).find("estimate_infinite"), std::string::npos);
    }
    c.platform->hydrodynamics.database->estimate_infinite = true;
    EXPECT_NO_THROW(Hull(c, &data));
}

}  // namespace
}  // namespace hawser::master
