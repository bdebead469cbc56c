// Loads at a point of a rod and their Jacobian: Morison R:16, R:17; free surface R:18; seabed R:33.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "rod/point_load.hpp"
#include "rod/rod_pack.hpp"
#include "vector.hpp"

namespace hawser::worker {
namespace {

Vector<Single> lanes_of(const Vec3& x) { return {x.x(), x.y(), x.z()}; }
Vec3 vec(const Vector<Single>& x) { return {x.x[0], x.y[0], x.z[0]}; }

struct Point {
    Vec3 r{0, 0, -20}, v = Vec3::Zero(), a = Vec3::Zero(), p{0.8, -0.4, 1.1};
    Vec3 u = Vec3::Zero(), ud = Vec3::Zero();
    double eta = 0.0, length = 2.0;
};

/// Steel pipe of 0.3 m in sea water.
ElementProperties<Single> pipe() {
    ElementProperties<Single> e{};
    e.m = 150.0, e.weight = 150.0 * 9.80665;
    e.rhoA = 72.0, e.buoyancy = 72.0 * 9.80665;
    e.ma = 80.0, e.ma_less_mt = 80.0 - 10.0;
    e.cn = 180.0, e.ct = 6.0;
    e.D = 0.3;
    return e;
}
const Bed no_bed{.z = -1e6, .stiffness = 0, .damping = 0};

PointLoad<Single> at(const Point& q, double a0 = 0, double a1 = 0, const Bed& bed = no_bed,
                     const ElementProperties<Single>& e = pipe()) {
    const PointMotion3<Single> x{lanes_of(q.r), lanes_of(q.v), lanes_of(q.a), lanes_of(q.p)};
    const Water<Single> water{.u = lanes_of(q.u), .ud = lanes_of(q.ud), .eta = q.eta};
    return point_load(e, x, water, bed, Single(q.length), Single(a0), Single(a1));
}

TEST(PointLoad, IsMorisonsForceAcrossAndAlongTheRod) {  // R:16, written out for one point
    Point q;
    q.v = {0.3, -0.2, 0.5}, q.a = {0.1, 0.4, -0.3}, q.u = {1.1, 0.6, -0.2}, q.ud = {0.5, -0.1, 0.2};
    const Vec3 t = q.p.normalized(), vr = q.u - q.v;
    const auto along = [&](const Vec3& y) -> Vec3 { return t * t.dot(y); };
    const auto across = [&](const Vec3& y) -> Vec3 { return y - t * t.dot(y); };
    const Vec3 water = 72.0 * q.ud + 80.0 * across(q.ud - q.a) + 10.0 * along(q.ud - q.a) +
                       180.0 * across(vr).norm() * across(vr) + 6.0 * along(vr).norm() * along(vr);
    const Vec3 expected = 150.0 * q.a - water + Vec3(0, 0, (150.0 - 72.0) * 9.80665);
    EXPECT_LT((vec(at(q).f) - expected).norm(), 1e-8 * expected.norm());
}

TEST(PointLoad, DragDependsOnTheRelativeVelocityAlone) {
    Point still, moving;
    still.u = {1.1, 0.6, -0.2};
    moving.u = {3.1, -0.4, 0.8}, moving.v = {2.0, -1.0, 1.0};
    EXPECT_LT((vec(at(still).f) - vec(at(moving).f)).norm(), 1e-9);
}

TEST(PointLoad, JacobianIsTheDerivativeAtFixedTangent) {  // R:17
    Point q;
    q.v = {0.3, -0.2, 0.5}, q.a = {0.1, 0.4, -0.3}, q.u = {1.1, 0.6, -0.2}, q.ud = {0.5, -0.1, 0.2};
    const double a0 = 40.0, a1 = 7.0, h = 1e-5;
    const Bed bed{.z = q.r.z() - 0.1, .stiffness = 5e4, .damping = 5e3};  // pen 0.05 > d0
    const PointLoad<Single> here = at(q, a0, a1, bed);
    for (int c = 0; c < 3; ++c) {
        const auto moved = [&](double s) {
            Point y = q;
            y.r[c] += s, y.v[c] += a1 * s, y.a[c] += a0 * s;
            return vec(at(y, a0, a1, bed).f);
        };
        const Vec3 column = (moved(h) - moved(-h)) / (2 * h);
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(here.S(i, c)[0], column[i], 1e-6 * here.S(c, c)[0]) << i << c;
    }
}

TEST(FreeSurface, TheWaterEndsGraduallyOverTheHeightOfTheRodPiece) {  // R:18
    Point q;
    q.p = {0, 0, 1.5};  // vertical, 2 m stand for the point, D = 0.3
    const double dry = 150.0 * 9.80665, buoyancy = 72.0 * 9.80665;
    const auto wet = [&](double z, double eta) {
        Point y = q;
        y.r.z() = z, y.eta = eta;
        return (dry - vec(at(y).f).z()) / buoyancy;
    };
    EXPECT_NEAR(wet(0, 0), 0.5, 1e-12);
    EXPECT_NEAR(wet(-1.0, 0), 0.5 + 1.0 / 2.3, 1e-12);
    EXPECT_NEAR(wet(-1.16, 0), 1.0, 1e-12);
    EXPECT_NEAR(wet(1.16, 0), 0.0, 1e-12);
    EXPECT_NEAR(wet(3.0, 3.5), wet(-0.5, 0), 1e-12);  // counts from the elevation of the instant
}

TEST(FreeSurface, NothingOfTheWaterActsAboveIt) {
    Point q;
    q.r.z() = 5.0;
    q.v = {0.3, -0.2, 0.5}, q.a = {0.1, 0.4, -0.3}, q.u = {9, 9, 9}, q.ud = {9, 9, 9};
    q.eta = 3.0;
    const Vec3 expected = 150.0 * q.a + Vec3(0, 0, 150.0 * 9.80665);
    EXPECT_LT((vec(at(q).f) - expected).norm(), 1e-9);
}

const Bed bed{.z = -100.0, .stiffness = 5e4, .damping = 5e3};
double bed_force(double pen, double v_z) {
    return bed_contact(bed, Single(-100.0 + 0.15 - pen), Single(v_z), Single(0.3), Single(0.0))
        .force[0];
}

TEST(Seabed, PushesWithASpringThatSetsInSmoothly) {  // R:33
    const double d0 = bed_smoothing;
    EXPECT_EQ(bed_force(-1e-9, -1.0), 0.0);
    EXPECT_NEAR(bed_force(0.5 * d0, 0), 5e4 * 0.25 * d0 / 2, 1e-8);
    EXPECT_NEAR(bed_force(d0, 0), 5e4 * d0 / 2, 1e-8);
    EXPECT_NEAR(bed_force(0.2, 0), 5e4 * (0.2 - d0 / 2), 1e-8);
    // stiffness is continuous where the two laws meet
    for (const double pen : {0.3 * d0, d0, 2 * d0}) {
        const double h = 1e-7;
        const double slope = (bed_force(pen + h, 0) - bed_force(pen - h, 0)) / (2 * h);
        const auto contact =
            bed_contact(bed, Single(-99.85 - pen), Single(0.0), Single(0.3), Single(0.0));
        EXPECT_NEAR(contact.stiffness[0], slope, 1e-4 * slope) << pen;
    }
}

TEST(Seabed, DampsButNeverPulls) {  // R:33
    EXPECT_NEAR(bed_force(0.2, -0.1) - bed_force(0.2, 0), 5e3 * 0.1, 1e-8);
    for (const double pen : {0.0, 0.01, 0.02, 0.1, 0.3}) {
        for (const double v : {-5.0, 0.0, 0.1, 1.0, 5.0, 50.0}) EXPECT_GE(bed_force(pen, v), 0.0);
    }
    EXPECT_EQ(bed_force(0.1, 50.0), 0.0);
}

}  // namespace
}  // namespace hawser::worker
