// One element with its middle multiplier put back, as a dense system: what a test can differentiate
// or hand to an eigenvalue solver. Order: node a (r, r', lambda), node b, middle lambda.
#pragma once

#include <Eigen/Dense>

#include "rod/element.hpp"
#include "rod/rod_pack.hpp"

namespace hawser::worker::testing {

using Matrix15 = Eigen::Matrix<double, 15, 15>;
using Vector15 = Eigen::Matrix<double, 15, 1>;

struct FullElement {
    Matrix15 J;
    Vector15 R;
};

inline ElementProperties<Single> dry_element(double L, double EA, double EI, double mass,
                                             double gravity = 0.0) {
    ElementProperties<Single> e{};
    e.L = L, e.B = EI, e.m = mass, e.weight = mass * gravity;
    e.D = 0.1;
    e.K_damper = EA, e.K_creep = 1e30;
    return e;
}

inline Compliance<Single> elastic(double EA) {
    Compliance<Single> material{};
    for (Single& s : material.s) s = Single(1.0 / EA);
    return material;
}

inline TrialNode<Single> node_at(const Vec3& r, const Vec3& d) {
    TrialNode<Single> node{};
    node.r = {r.x(), r.y(), r.z()}, node.d = {d.x(), d.y(), d.z()};
    return node;
}

inline FullElement full_element(const ElementProperties<Single>& e, const TrialNode<Single>& a,
                                const TrialNode<Single>& b, const std::array<double, 3>& lambda,
                                const Compliance<Single>& material, double a0 = 0.0,
                                double a1 = 0.0, const Water<Single>& water = {}) {
    const std::array<Water<Single>, gauss_points> still = {water, water, water, water};
    const Single l[3] = {lambda[0], lambda[1], lambda[2]};
    const Bed bed{.z = -1e9, .stiffness = 0.0, .damping = 0.0};
    ElementSystem<Single> s;
    assemble_element(e, a, b, l, material, still.data(), bed, Single(a0), Single(a1), s);
    FullElement out;
    const double pivot = 1.0 / s.inverse_pivot[0], R = s.R_middle[0];
    for (int i = 0; i < 7; ++i) {
        for (int k = 0; k < 7; ++k) {
            out.J(i, k) = k <= i ? s.aa[i][k][0] : s.aa[k][i][0];
            out.J(7 + i, 7 + k) = k <= i ? s.bb[i][k][0] : s.bb[k][i][0];
            out.J(i, 7 + k) = out.J(7 + k, i) = s.ab[i][k][0];
        }
        out.R[i] = s.Ra[i][0], out.R[7 + i] = s.Rb[i][0];
    }
    Eigen::Matrix<double, 14, 1> c;
    for (int i = 0; i < 14; ++i) c[i] = s.column[i][0];
    out.J.topLeftCorner<14, 14>() += c * c.transpose() / pivot;  // R:20 undone
    out.R.head<14>() += c * (R / pivot);
    out.J.topRightCorner<14, 1>() = c;
    out.J.bottomLeftCorner<1, 14>() = c.transpose();
    out.J(14, 14) = pivot;
    out.R[14] = R;
    return out;
}

}  // namespace hawser::worker::testing
