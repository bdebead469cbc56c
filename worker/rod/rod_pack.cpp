// Set-up of a pack from the case, motion of its ends, and what can be read from it.
#include "rod/rod_pack.hpp"

#include <algorithm>
#include <cmath>

#include "environment/ramp.hpp"
#include "line_mesh.hpp"
#include "rod/lane_access.hpp"
#include "rod/tie_system.hpp"

namespace hawser::worker {

namespace {

/// Harmonic motion of an end, times the ramp, with its exact derivatives.
PointMotion harmonic(const EndMotion& motion, double t, double ramp) {
    const Ramp r = ramp_with_rates(t, ramp);
    PointMotion out;
    for (int i = 0; i < 3; ++i) {
        const double w = 2.0 * M_PI / motion.period[i], a = motion.amplitude[i];
        const double s = a * std::sin(w * t + motion.phase[i]);
        const double c = a * w * std::cos(w * t + motion.phase[i]);
        out.position[i] = r.value * s;
        out.velocity[i] = r.value * c + r.rate * s;
        out.acceleration[i] = -r.value * w * w * s + 2.0 * r.rate * c + r.second * s;
    }
    return out;
}

}  // namespace

template <class V>
RodPack<V>::RodPack(const Case& input, const Sea& sea, std::vector<int> lines)
    : lines_(std::move(lines)),
      sea_(&sea),
      scheme_(input.analysis.dynamics.rod_scheme),
      bed_(bed_of(input.environment.seabed)),
      gravity_(input.environment.water.gravity),
      water_density_(input.environment.water.density),
      force_(input.analysis.dynamics.force),
      model_(input.lines[static_cast<std::size_t>(lines_.front())].model.value_or(
          input.analysis.dynamics.line_model)),
      ramp_(input.analysis.dynamics.ramp),
      platform_step_(input.analysis.dynamics.platform_step),
      wave_step_(input.analysis.dynamics.wave_step),
      used_(LaneTraits<V>::none()),
      law_on_(!LaneTraits<V>::none()),
      guessed_(LaneTraits<V>::none()),
      axis_is_static_a_(LaneTraits<V>::none()),
      axis_is_static_b_(LaneTraits<V>::none()) {
    if (scheme_.undamped()) newton.tolerance = NewtonControl::undamped_tolerance;
    for (auto& hull : fitted_)
        for (Vec6& f : hull) f.setZero();
    touched_ = touched_platforms(input)[static_cast<std::size_t>(lines_.front())];
    design_ = input.design_of(touched_.first);
    if (touched_.two()) {
        const PlatformMotion second = input.design_of(touched_.second);
        second_ = MotionSpline(0.0, second, 0.0, second);
    }
    set_properties(input);
    const std::size_t N = properties_.size();
    const int slabs = static_cast<int>(std::ceil(platform_step_ / wave_step_)) + 3;
    kept_ =
        RodState<V>(static_cast<int>(N), static_cast<int>(constraints_.size()), slabs, bed_.rubs());
    const auto axis = [&](const EndPlace& place, Vector<V>& to, Mask& is_static) {
        for (int i = 0; i < lanes; ++i) {
            const LineEnd& end = place.end[static_cast<std::size_t>(i)];
            set_lane_vector(to, i, end.direction ? Vec3(-*end.direction) : Vec3(Vec3::UnitZ()));
            const bool turns_freely = end.joint == Joint::ball || end.joint == Joint::spring;
            LaneTraits<V>::set(is_static, i, !turns_freely && !end.direction);
        }
    };
    axis(place_a_, kept_.head().axis_a, axis_is_static_a_);
    axis(place_b_, kept_.head().axis_b, axis_is_static_b_);
    kept_.head().h = line_step_;
    working_ = kept_;

    trial_.resize(N + 1);
    lambda_.resize(2 * N + 1);
    material_.resize(N);
    water_.resize(N * gauss_points);
    factors_.resize(N);
    middles_.resize(N);
    correction_.resize(N + 1);
    lambda_correction_.resize(N);
    if (model_ == LineModel::quasi_static) {
        reached_.resize(N + 1);
        reached_lambda_.resize(2 * N + 1);
    }
    hanging_stiffness_.assign(static_cast<std::size_t>(lanes), Mat3::Zero());
    const std::size_t samples = lines_.size() * N * gauss_points;
    for (auto* v : {&xs_, &ys_, &zs_, &ux_, &uy_, &uz_, &ax_, &ay_, &az_, &eta_})
        v->resize(samples);
    slot_.resize(samples);
}

template <class V>
void RodPack<V>::set_properties(const Case& input) {
    using T = LaneTraits<V>;
    for (int i = 0; i < lanes; ++i) {
        const bool used = static_cast<std::size_t>(i) < lines_.size();
        T::set(used_, i, used);
        const int index = lines_[used ? static_cast<std::size_t>(i) : 0];
        const Line& line = input.lines[static_cast<std::size_t>(index)];
        const LineMesh mesh = mesh_of(line);
        const double travel_time = axial_travel_time(input, line);
        const int N = mesh.elements();
        properties_.resize(static_cast<std::size_t>(N));
        for (int n = 0; n < N; ++n) {  // counted from end B
            ElementProperties<double> p =
                element_properties(input, line, mesh, N - 1 - n, travel_time);
            if (model_ != LineModel::dynamic) p.c_damper = p.Db = 0.0;  // no rates at rest
            ElementProperties<V>& to = properties_[static_cast<std::size_t>(n)];
            const auto set = [&](V& v, double x) { T::set(v, i, x); };
            set(to.L, p.L), set(to.B, p.B), set(to.Db, p.Db), set(to.m, p.m);
            set(to.weight, p.weight), set(to.rhoA, p.rhoA), set(to.buoyancy, p.buoyancy);
            set(to.ma, p.ma), set(to.ma_less_mt, p.ma_less_mt), set(to.cn, p.cn), set(to.ct, p.ct);
            set(to.D, p.D), set(to.K_damper, p.K_damper), set(to.c_damper, p.c_damper);
            set(to.K_creep, p.K_creep), set(to.c_creep, p.c_creep);
            has_strain_ = has_strain_ || p.c_damper > 0.0 || p.c_creep > 0.0;
        }
        masses_.resize(line.attachments.size());
        for (std::size_t k = 0; k < line.attachments.size(); ++k) {
            const Attachment& attachment = line.attachments[k];
            PointMass<V>& to = masses_[k];
            to.node = N - mesh.attachment_node[k];
            const double displaced = water_density_ * attachment.volume;
            T::set(to.mass, i, attachment.mass);
            T::set(to.displaced, i, displaced);
            T::set(to.added, i, attachment.Ca * displaced);
            T::set(to.drag, i, 0.5 * water_density_ * attachment.drag_area);
            T::set(to.height, i, std::max(0.1, std::cbrt(6.0 * attachment.volume / M_PI)));
        }
        std::vector<double> arc(mesh.arc_length.rbegin(), mesh.arc_length.rend());
        for (double& s : arc) s = mesh.arc_length.back() - s;
        arc_length_.push_back(std::move(arc));
        place_a_.end.push_back(line.end_a);
        place_b_.end.push_back(line.end_b);
        place_a_.kind = line.end_a.kind;
        place_b_.kind = line.end_b.kind;
        place_a_.hull = touched_.place_of(line.end_a.platform);
        place_b_.hull = touched_.place_of(line.end_b.platform);
        T::set(line_step_, i,
               std::min(line.time_step.value_or(input.analysis.dynamics.line_step),
                        input.analysis.dynamics.line_step));
    }
    // not stable_sort: its buffer ignores the alignment of vector lanes
    std::sort(masses_.begin(), masses_.end(),
              [](const auto& a, const auto& b) { return a.node < b.node; });
    set_slope_law(place_a_, law_a_, properties_.back());
    set_slope_law(place_b_, law_b_, properties_.front());
    set_spring();
    set_constraints(input);
    set_curves(input);
    set_changes(input);
    sheltered_above_ = V(1e30);
    for (int i = 0; i < lanes; ++i) {
        const auto lane = static_cast<std::size_t>(i);
        const Line& line = input.lines[static_cast<std::size_t>(
            lines_[lane < lines_.size() ? lane : std::size_t{0}])];
        if (!line.sheltered_above) continue;
        shelters_ = true;
        T::set(sheltered_above_, i, *line.sheltered_above);
    }
}

template <class V>
void RodPack<V>::set_slope_law(const EndPlace& place, SlopeLaw<V>& law,
                               const ElementProperties<V>& element) {
    const Joint joint = place.end.front().joint;
    if (!place.prescribed() || joint == Joint::ball) return;  // free and sprung ends turn freely
    if (joint == Joint::clamped) {  // much stiffer than the element that it holds
        law = Clamp<V>{.stiffness = V(4e3) * element.B / element.L};
        return;
    }
    FlexJoint<V> flex;
    for (int i = 0; i < lanes; ++i)
        LaneTraits<V>::set(flex.stiffness, i,
                           place.end[static_cast<std::size_t>(i)].rotational_stiffness);
    for (std::size_t i = 0; i < flex.table.size(); ++i)
        if (!place.end[i].rotational_curve.empty())
            flex.table[i] = PiecewiseLinear(place.end[i].rotational_curve);
    law = flex;
}

template <class V>
void RodPack<V>::set_spring() {
    if (!place_a_.sprung()) return;
    using T = LaneTraits<V>;
    Spring<V> spring;
    for (int i = 0; i < lanes; ++i) {
        const LineEnd& end = place_a_.end[static_cast<std::size_t>(i)];
        T::set(spring.stiffness, i, end.spring_stiffness);
        T::set(spring.damping, i, end.spring_damping);
        T::set(spring.length, i, end.spring_length);
    }
    spring_a_ = spring;
}

template <class V>
EndValues<V> RodPack<V>::end_values(const EndPlace& place, const Vector<V>& axis, V t,
                                    const MotionSpline& platform) const {
    using T = LaneTraits<V>;
    EndValues<V> out;
    if (!place.held()) return out;
    MotionSpline::Sample sample;
    Mat3 R = Mat3::Identity();
    double sampled_at = NAN;
    for (int i = 0; i < lanes; ++i) {
        const LineEnd& end = place.end[static_cast<std::size_t>(i)];
        const double time = T::get(t, i);
        PointMotion point{.position = end.position};
        Vec3 k = lane_vector(axis, i);
        if (end.kind == EndKind::platform) {
            if (time != sampled_at) {
                sample = motion_of(place.hull, platform).at(time);
                R = rotation(sample.motion.angles);
                sampled_at = time;
            }
            point = point_motion(sample.motion, sample.acceleration, end.position);
            k = R * k;
        } else if (end.motion) {
            const PointMotion moved = harmonic(*end.motion, time, ramp_);
            point.position += moved.position;
            point.velocity = moved.velocity;
            point.acceleration = moved.acceleration;
        }
        set_lane_vector(out.position, i, point.position);
        set_lane_vector(out.velocity, i, point.velocity);
        set_lane_vector(out.acceleration, i, point.acceleration);
        set_lane_vector(out.axis, i, k);
    }
    return out;
}

template <class V>
Vec6 RodPack<V>::wrench(int lane, const Vec3& reference, int hull) const {
    Vec6 out = Vec6::Zero();
    if (place_a_.kind == EndKind::platform && place_a_.hull == hull) {
        const Vec3 force = force_on_support_a(lane);
        const Vec3 lever = lane_vector(working_.nodes()[properties_.size()].r, lane) - reference;
        out << force, lever.cross(force) + moment_on_support_a(lane);
    }
    if (place_b_.kind == EndKind::platform && place_b_.hull == hull) {
        const Vec3 force = force_on_support_b(lane);
        const Vec3 lever = lane_vector(working_.nodes()[0].r, lane) - reference;
        out.head<3>() += force;
        out.tail<3>() += lever.cross(force) + moment_on_support_b(lane);
    }
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
        if (!constraints_[c].at[static_cast<std::size_t>(lane)].on_platform) continue;
        if (constraints_[c].hull != hull) continue;
        const ConstraintState<V>& state = working_.constraints()[c];
        const Vec3 force = -lane_vector(state.force, lane);
        const Vec3 lever = lane_vector(state.point, lane) - reference;
        out.head<3>() += force;
        out.tail<3>() += lever.cross(force) - lane_vector(state.moment, lane);
    }
    return out;
}

template <class V>
Vec3 RodPack<V>::force_on_support_a(int lane) const {
    return -lane_vector(working_.head().force_a, lane);
}
template <class V>
Vec3 RodPack<V>::force_on_support_b(int lane) const {
    return -lane_vector(working_.head().force_b, lane);
}
template <class V>
Vec3 RodPack<V>::moment_on_support_a(int lane) const {
    return -lane_vector(working_.head().moment_a, lane);
}
template <class V>
Vec3 RodPack<V>::moment_on_support_b(int lane) const {
    return -lane_vector(working_.head().moment_b, lane);
}
template <class V>
Vec3 RodPack<V>::direction_a(int lane) const {
    return -lane_vector(working_.nodes()[properties_.size()].d, lane).normalized();
}
template <class V>
Vec3 RodPack<V>::direction_b(int lane) const {
    return -lane_vector(working_.nodes()[0].d, lane).normalized();
}
template <class V>
double RodPack<V>::tension_a(int lane) const {
    if (!place_a_.held()) return end_tension(properties_.size(), lane);
    return force_on_support_a(lane).dot(direction_a(lane));
}
template <class V>
double RodPack<V>::tension_b(int lane) const {
    if (!place_b_.held()) return end_tension(0, lane);
    return -force_on_support_b(lane).dot(direction_b(lane));
}
template <class V>
double RodPack<V>::end_tension(std::size_t node, int lane) const {  // R:2
    const double lambda = LaneTraits<V>::get(working_.lambda()[2 * node].now, lane);
    return lambda * lane_vector(working_.nodes()[node].d, lane).norm();
}
template <class V>
Vec3 RodPack<V>::node_position(int lane, int n) const {
    return lane_vector(working_.nodes()[properties_.size() - static_cast<std::size_t>(n)].r, lane);
}

template <class V>
template <int n>
Eigen::Matrix<double, n, n> RodPack<V>::stiffness_about(int lane, const References& references,
                                                        TieBorder<V>* ties) {
    using Square = Eigen::Matrix<double, n, n>;
    const Vec3& reference = references[static_cast<std::size_t>(place_a_.hull)];
    if constexpr (n == 6)
        if (model_ == LineModel::catenary) return hanging_stiffness(lane, reference);
    using T = LaneTraits<V>;
    Eigen::Matrix<double, 7, 7> D;
    for (int i = 0; i < 7; ++i)
        for (int k = 0; k < 7; ++k) D(i, k) = T::get(last_D_[i][k], lane);
    Square along_rod = Square::Zero();
    if (ties != nullptr) begin_border(lane, *ties, n);
    Border<n> K_along = border_of_constraints<n>(lane, references, along_rod, ties);
    if (place_a_.kind != EndKind::platform) {
        if (!place_a_.prescribed())
            return along_rod - border_at_end_a<7, n>(lane, D, K_along, ties);
        return along_rod - border_at_end_a<4, n>(lane, D.bottomRightCorner<4, 4>(),
                                                 K_along.template bottomRows<4>(), ties);
    }
    Mat3 Ks;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) Ks(i, k) = T::get(slope_load_a_.stiffness(i, k), lane);
    // The joint's force f on the slope d turns with the platform, and the flex joint's tangent has
    // parts along the rod, (d f^T + f d^T)/d^2, which R:31 leaves out of the iteration.
    const Vec3 d = lane_vector(working_.nodes()[properties_.size()].d, lane);
    const Vec3 f = lane_vector(slope_load_a_.force, lane);
    if (std::holds_alternative<FlexJoint<V>>(law_a_)) {
        const Mat3 along = (d * f.transpose() + f * d.transpose()) / d.squaredNorm();
        Ks += along;
        D.block<3, 3>(3, 3) += along;
    }
    const NodeState<V>& node = working_.nodes()[properties_.size()];
    // R:21: a point turns with l x, a slope with r' x
    const int hull = place_a_.hull, turned = 6 * hull + 3;
    const Vec3 lever = lane_vector(node.r, lane) - reference;
    const auto B = columns_of_hull<n>(Mat3::Identity(), -skew(lever), hull);
    const auto Bs = columns_of_hull<n>(Mat3::Zero(), -skew(d), hull);
    // Departs from R:23, which leaves this out: the lever turns under the force, d(l x F) = (dtheta
    // x l) x F. It is most of the yaw stiffness of a mooring.
    Square turning = Square::Zero();
    turning.template block<3, 3>(turned, turned) = -skew(force_on_support_a(lane)) * skew(lever);
    if (place_a_.sprung()) {  // R:22: the spring joins the free node to the border
        Mat3 Kt;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) Kt(i, k) = T::get(spring_load_a_.stiffness(i, k), lane);
        Border<n> K = K_along;
        K.template topRows<3>() -= Kt * B;
        return along_rod + B.transpose() * Kt * B - border_at_end_a<7, n>(lane, D, K, ties) +
               turning;
    }
    // R:22, R:23: border columns and block, then the elimination of (r', lambda)
    const Eigen::Matrix<double, 3, n> K_r = K_along.template topRows<3>();
    Eigen::Matrix<double, 4, n> K =
        D.bottomLeftCorner<4, 3>() * B + K_along.template bottomRows<4>();
    K.template topRows<3>() -= Ks * Bs;
    K.template block<3, 3>(0, turned) += skew(f);
    turning.template block<3, 3>(turned, turned) -= skew(d) * skew(f);
    const Square M = along_rod + B.transpose() * D.topLeftCorner<3, 3>() * B + B.transpose() * K_r +
                     K_r.transpose() * B + Bs.transpose() * Ks * Bs;
    return M - border_at_end_a<4, n>(lane, D.bottomRightCorner<4, 4>(), K, ties, &B) + turning;
}

template Mat6 RodPack<Single>::stiffness_about<6>(int, const References&, TieBorder<Single>*);
template Mat12 RodPack<Single>::stiffness_about<12>(int, const References&, TieBorder<Single>*);
template Mat6 RodPack<Quad>::stiffness_about<6>(int, const References&, TieBorder<Quad>*);
template Mat12 RodPack<Quad>::stiffness_about<12>(int, const References&, TieBorder<Quad>*);
template class RodPack<Single>;
template class RodPack<Quad>;

}  // namespace hawser::worker
