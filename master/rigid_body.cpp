#include "rigid_body.hpp"

namespace hawser::master {

TurnedBody turned(const RigidBody& body, const Mat3& R) {
    const Vec3& r = body.centre_of_gravity;
    const Mat3 about_O =
        body.inertia + body.mass * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
    return {body.mass, R * r, R * about_O * R.transpose()};
}

Mat6 mass_matrix(const TurnedBody& b) {
    const Mat3 mc = b.mass * skew(b.c);
    Mat6 M;
    M << b.mass * Mat3::Identity(), -mc, mc, b.inertia;
    return M;
}

Vec6 gyroscopic_load(const TurnedBody& b, const Vec3& w) {
    Vec6 load;
    load << b.mass * w.cross(w.cross(b.c)), w.cross(b.inertia * w);
    return load;
}

Vec6 momentum(const TurnedBody& b, const Vec3& v, const Vec3& w) {
    Vec6 p;
    p << b.mass * (v + w.cross(b.c)), b.mass * b.c.cross(v) + b.inertia * w;
    return p;
}

Vec6 momentum_transport(const TurnedBody& b, const Vec3& v, const Vec3& w) {
    Vec6 p = Vec6::Zero();
    p.tail<3>() = v.cross(b.mass * w.cross(b.c));
    return p;
}

}  // namespace hawser::master
