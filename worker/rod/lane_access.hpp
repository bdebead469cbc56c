// One lane of the pack's vectors as plain vectors, for work that is done rod by rod.
#pragma once

#include "rod/vector3.hpp"
#include "vector.hpp"

namespace hawser::worker {

template <class V>
[[nodiscard]] Vec3 lane_vector(const Vector<V>& x, int lane) {
    using T = LaneTraits<V>;
    return {T::get(x.x, lane), T::get(x.y, lane), T::get(x.z, lane)};
}

template <class V>
[[nodiscard]] Mat3 lane_matrix(const Symmetric<V>& S, int lane) {
    Mat3 out;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) out(i, k) = LaneTraits<V>::get(S(i, k), lane);
    return out;
}

template <class V>
void set_lane_vector(Vector<V>& to, int lane, const Vec3& x) {
    using T = LaneTraits<V>;
    T::set(to.x, lane, x.x()), T::set(to.y, lane, x.y()), T::set(to.z, lane, x.z());
}

/// Force and moment of a lane as one load, and back.
template <class V>
[[nodiscard]] Vec6 lane_wrench(const Vector<V>& force, const Vector<V>& moment, int lane) {
    Vec6 out;
    out << lane_vector(force, lane), lane_vector(moment, lane);
    return out;
}
template <class V>
void set_lane_wrench(Vector<V>& force, Vector<V>& moment, int lane, const Vec6& x) {
    set_lane_vector(force, lane, x.head<3>());
    set_lane_vector(moment, lane, x.tail<3>());
}

/// Three rows of a border (R:22): a matrix for the displacements and one for the rotations of one
/// of the platforms; n = 6 columns for one platform, 12 for two.
template <int n>
[[nodiscard]] Eigen::Matrix<double, 3, n> columns_of_hull(const Mat3& moved, const Mat3& turned,
                                                          int hull) {
    Eigen::Matrix<double, 3, n> out;
    if constexpr (n > 6) out.setZero();
    out.template middleCols<3>(6 * hull) = moved;
    out.template middleCols<3>(6 * hull + 3) = turned;
    return out;
}

}  // namespace hawser::worker
