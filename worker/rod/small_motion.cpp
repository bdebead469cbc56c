// Tangent of a pack at its static solution: the dynamic stiffness of all lanes (R:44) and the
// matrices of one lane (R:43).
#include "rod/small_motion.hpp"

#include <vector>

#include "rod/rod_group.hpp"

namespace hawser::worker {

template <class V>
void RodPack<V>::prepare_tangent(double omega) {
    static_ = true;
    friction_on_ = false;
    const MotionSpline still(0.0, last_pose(), 0.0, last_pose());
    const NodeState<V>* node = kept_.nodes();
    for (std::size_t n = 0; n < trial_.size(); ++n)
        trial_[n] = {.r = node[n].r, .d = node[n].d, .v = {}, .vd = {}, .a = {}, .ad = {}};
    for (std::size_t i = 0; i < lambda_.size(); ++i) lambda_[i] = kept_.lambda()[i].now;
    for (std::size_t e = 0; e < properties_.size(); ++e) {
        const ElementProperties<V>& p = properties_[e];
        // Storage modulus 1/s = Re(1/(1/K + 1/(K_c + i w c))): R:35 in harmonic motion.
        const V w_c = V(omega) * p.c_creep;
        const V size = p.K_creep * p.K_creep + w_c * w_c;
        const V real = V(1.0) / p.K_damper + p.K_creep / size, imaginary = w_c / size;
        const V s = (real * real + imaginary * imaginary) / real;
        const V s_static = V(1.0) / p.K_damper + V(1.0) / p.K_creep;
        for (V& point : material_[e].s) point = s;
        for (std::size_t g = 0; g < gauss_points; ++g) {  // R:3 keeps its stretch at rest
            const Multiplier<V>* l = kept_.lambda() + 2 * e;
            const V lambda = V(shape.P[g][0]) * l[0].now + V(shape.P[g][1]) * l[1].now +
                             V(shape.P[g][2]) * l[2].now;
            const V T = lambda / (V(1.0) - s_static * lambda);
            material_[e].b[g] = (s_static - s) * T;
        }
    }
    end_a_ = end_values(place_a_, kept_.head().axis_a, V(0.0), still);
    end_b_ = end_values(place_b_, kept_.head().axis_b, V(0.0), still);
    if (!curves_.empty()) (void)follow_curves(used_, nullptr, V(1.0));
    current_only(false, V(0.0), still);  // drag without motion has no part in the tangent
}

template <class V>
void RodPack<V>::swing(double omega) {
    RodGroup<V>(std::span(this, 1)).swing(omega);
}

namespace {

/// Adds factor x a block to the triplets; `lower`: of a symmetric block whose lower triangle is
/// given. Of a difference of two Jacobians (`mass`) the rows of lambda are left out: nothing but
/// rounding stands there.
template <class V>
void add_block(std::vector<Eigen::Triplet<double>>& to, std::size_t row, std::size_t column,
               const V (&block)[7][7], int lane, double factor, bool lower, bool mass) {
    const int rows = mass ? 6 : 7;
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k < rows; ++k) {
            const double x =
                factor * LaneTraits<V>::get(lower && k > i ? block[k][i] : block[i][k], lane);
            if (x == 0.0) continue;
            const int p = static_cast<int>(7 * row) + i, q = static_cast<int>(7 * column) + k;
            to.emplace_back(p, q, x);
            if (row != column) to.emplace_back(q, p, x);
        }
}

}  // namespace

template <class V>
SmallMotion RodPack<V>::small_motion(int lane) {
    // Fast motion, so a rope has its dynamic stiffness: the relaxation is slower than its modes.
    constexpr double fast = 1e6;
    prepare_tangent(fast);
    const MotionSpline still(0.0, last_pose(), 0.0, last_pose());
    if (!constraints_.empty()) place_constraints(kept_, V(0.0), V(0.0), still, true);
    find_points();
    guides_closed_ = true;
    apply_laws(V(0.0));
    guides_closed_ = false;
    const std::size_t N = properties_.size();
    using Triplets = std::vector<Eigen::Triplet<double>>;
    const auto assemble = [&](Triplets& to, V a0, double factor, bool mass) {
        V D[7][7], R[7];
        const auto add_node = [&](std::size_t n, auto&& what) {
            for (auto& row : D)
                for (V& x : row) x = V(0.0);
            what();
            add_block(to, n, n, D, lane, factor, true, mass);
        };
        for (std::size_t e = 0; e < N; ++e) {
            const V lambda[3] = {lambda_[2 * e], lambda_[2 * e + 1], lambda_[2 * e + 2]};
            assemble_element(properties_[e], trial_[e], trial_[e + 1], lambda, material_[e],
                             &water_[e * gauss_points], bed_, a0, V(0.0), element_);
            if (!constraints_.empty()) add_constraints(e, element_);
            add_block(to, e, e, element_.aa, lane, factor, true, mass);
            add_block(to, e, e + 1, element_.ab, lane, factor, false, mass);
            add_block(to, e + 1, e + 1, element_.bb, lane, factor, true, mass);
        }
        for (const PointMass<V>& point : masses_)
            add_node(static_cast<std::size_t>(point.node),
                     [&] { add_point_mass(point, a0, V(0.0), D, R); });
        add_node(0, [&] {
            add_slope_law(law_b_, trial_[0], end_b_.axis, D, R, slope_load_b_,
                          !LaneTraits<V>::none());
        });
        add_node(N, [&] {
            add_slope_law(law_a_, trial_[N], end_a_.axis, D, R, slope_load_a_,
                          !LaneTraits<V>::none());
        });
        if (place_a_.sprung())
            add_node(N, [&] {
                const Vector<V> g = trial_[N].r - end_a_.position;
                const auto spring = std::visit(
                    [&](const auto& l) { return load(l, g, Vector<V>{}, V(0.0)); }, spring_a_);
                for (int i = 0; i < 3; ++i)
                    for (int k = 0; k <= i; ++k) D[i][k] += spring.stiffness(i, k);
            });
    };
    Triplets stiffness, mass;  // J(a0) = K + a0 M
    assemble(stiffness, V(0.0), 1.0, false);
    assemble(mass, V(1.0), 1.0, true);
    assemble(mass, V(0.0), -1.0, true);

    const auto held = [&](int row) {
        const int n = row / 7, i = row % 7;
        return i < 3 && ((n == 0 && place_b_.prescribed()) ||
                         (n == static_cast<int>(N) && place_a_.prescribed()));
    };
    const auto filtered = [&](const Triplets& all, bool identity) {
        Triplets out;
        for (const auto& t : all)
            if (!held(t.row()) && !held(t.col())) out.push_back(t);
        for (int row = 0; identity && row < 7 * static_cast<int>(N + 1); ++row)
            if (held(row)) out.emplace_back(row, row, 1.0);
        return out;
    };
    const auto n = static_cast<Eigen::Index>(7 * (N + 1));
    SmallMotion out{Eigen::SparseMatrix<double>(n, n), Eigen::SparseMatrix<double>(n, n)};
    const Triplets K = filtered(stiffness, true), M = filtered(mass, false);
    out.stiffness.setFromTriplets(K.begin(), K.end());
    out.mass.setFromTriplets(M.begin(), M.end());
    return out;
}

template void RodPack<Single>::prepare_tangent(double);
template void RodPack<Single>::swing(double);
template SmallMotion RodPack<Single>::small_motion(int);
template void RodPack<Quad>::prepare_tangent(double);
template void RodPack<Quad>::swing(double);
template SmallMotion RodPack<Quad>::small_motion(int);

}  // namespace hawser::worker
