// Laws of joints at a rod's end: flex joint R:31, clamp. Every law gets the same tests.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "constraint/slope_laws.hpp"
#include "rod/rod_pack.hpp"
#include "vector.hpp"

namespace hawser::worker {
namespace {

Vector<Single> lanes_of(const Vec3& x) { return {x.x(), x.y(), x.z()}; }
Vec3 vec(const Vector<Single>& x) { return {x.x[0], x.y[0], x.z[0]}; }

template <class Law>
double energy(const Law& law, const Vec3& d, const Vec3& k) {
    return load(law, lanes_of(d), lanes_of(k)).energy[0];
}

/// Central differences of fourth order of the energy in the slope (or, with `of_axis`, in the
/// axis).
template <class Law>
Vec3 gradient(const Law& law, const Vec3& d, const Vec3& k, bool of_axis = false) {
    Vec3 out;
    const double h = 1e-3;
    for (int c = 0; c < 3; ++c) {
        const auto at = [&](double n) {
            const Vec3 e = n * h * Vec3::Unit(c);
            return of_axis ? energy(law, d, Vec3(k + e)) : energy(law, Vec3(d + e), k);
        };
        out[c] = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
    }
    return out;
}

constexpr double stiffness = 2e5;
const FlexJoint<Single> flex{.stiffness = stiffness};
const Clamp<Single> clamp{.stiffness = stiffness};

/// A slope at an angle to the axis, stretched a little.
Vec3 slope_at(double theta, const Vec3& k) {
    const Vec3 across = k.cross(Vec3(0.2, 0.9, -0.4)).normalized();
    return 1.03 * (std::cos(theta) * k + std::sin(theta) * across);
}
const Vec3 axis = Vec3(0.6, -0.3, 0.74).normalized();
const std::vector<double> angles = {1e-6, 1e-3, 0.05, 0.3, 1.0, 2.0};

template <class Law>
void force_is_minus_the_gradient(const Law& law) {
    for (const double theta : angles) {
        const Vec3 d = slope_at(theta, axis);
        const Vec3 force = vec(load(law, lanes_of(d), lanes_of(axis)).force);
        // fourth-order differences with h = 1e-3: 1e-11, and rounding 1e-13
        EXPECT_LT((force + gradient(law, d, axis)).norm(), 1e-8 * stiffness) << theta;
    }
}
TEST(FlexJoint, ForceIsMinusTheGradientOfEnergy) { force_is_minus_the_gradient(flex); }  // R:31
TEST(Clamp, ForceIsMinusTheGradientOfEnergy) { force_is_minus_the_gradient(clamp); }

template <class Law>
void action_equals_reaction(const Law& law) {
    for (const double theta : angles) {
        const Vec3 d = slope_at(theta, axis);
        const auto joint = load(law, lanes_of(d), lanes_of(axis));
        const Vec3 on_rod = d.cross(vec(joint.force));
        const Vec3 on_axis = -axis.cross(gradient(law, d, axis, true));  // what holds the axis
        EXPECT_LT((on_rod + on_axis).norm(), 1e-8 * stiffness) << theta;
        // energy is kept when slope and axis turn together
        const Eigen::Matrix3d Q =
            Eigen::AngleAxisd(0.8, Vec3(0.1, 0.7, -0.6).normalized()).matrix();
        EXPECT_NEAR(energy(law, Vec3(Q * d), Vec3(Q * axis)), joint.energy[0], 1e-10 * stiffness);
    }
}
TEST(FlexJoint, MomentsOnRodAndPlatformCancel) { action_equals_reaction(flex); }
TEST(Clamp, MomentsOnRodAndPlatformCancel) { action_equals_reaction(clamp); }

TEST(FlexJoint, MomentIsStiffnessTimesAngleAndDoesNotPullAlongTheRod) {  // R:31
    for (const double theta : angles) {
        const Vec3 d = slope_at(theta, axis);
        const Vec3 force = vec(load(flex, lanes_of(d), lanes_of(axis)).force);
        EXPECT_NEAR(d.cross(force).norm(), stiffness * theta, 1e-10 * stiffness) << theta;
        EXPECT_NEAR(force.dot(d), 0.0, 1e-10 * stiffness) << theta;
    }
}

TEST(Clamp, LeavesTheStretchFree) {
    const auto joint = load(clamp, lanes_of(1.2 * axis), lanes_of(axis));
    EXPECT_LT(vec(joint.force).norm(), 1e-12 * stiffness);
    EXPECT_NEAR((joint.stiffness * lanes_of(axis)).x[0], 0.0, 1e-12 * stiffness);
}

/// -d force/d slope by central differences.
template <class Law>
Mat3 tangent(const Law& law, const Vec3& d) {
    Mat3 out;
    const double h = 1e-5;
    for (int c = 0; c < 3; ++c)
        out.col(c) =
            -(vec(load(law, lanes_of(Vec3(d + h * Vec3::Unit(c))), lanes_of(axis)).force) -
              vec(load(law, lanes_of(Vec3(d - h * Vec3::Unit(c))), lanes_of(axis)).force)) /
            (2 * h);
    return out;
}
template <class Law>
Mat3 stated(const Law& law, const Vec3& d) {
    const auto S = load(law, lanes_of(d), lanes_of(axis)).stiffness;
    Mat3 out;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) out(i, k) = S(i, k)[0];
    return out;
}

TEST(Clamp, StiffnessIsTheDerivativeOfTheForce) {
    const Vec3 d = slope_at(0.3, axis);
    EXPECT_LT((stated(clamp, d) - tangent(clamp, d)).norm(), 1e-8 * stiffness);
}

TEST(FlexJoint, StiffnessIsTheDerivativeAcrossTheRodAndNeverNegative) {  // R:31
    for (const double theta : angles) {
        const Vec3 d = slope_at(theta, axis), t = d.normalized();
        // the parts along the tangent are left out on purpose
        const Mat3 across = Mat3::Identity() - t * t.transpose();
        const Mat3 S = stated(flex, d);
        EXPECT_LT((S - across * tangent(flex, d) * across).norm(), 1e-7 * stiffness) << theta;
        if (theta < M_PI / 2) {
            EXPECT_GT(Eigen::SelfAdjointEigenSolver<Mat3>(S).eigenvalues().minCoeff(),
                      -1e-9 * stiffness)
                << theta;
        }
    }
}

}  // namespace
}  // namespace hawser::worker
