// Lines as elastic catenaries: between their ends on a flat bed, without current, waves, bending,
// friction or memory, with the static stiffness of a rope. Their nodes are put into the rods'
// state, so that everything that reads a rod reads them.
#include <cmath>

#include "rod/lane_access.hpp"
#include "rod/rod_pack.hpp"

namespace hawser::worker {

template <class V>
std::vector<CatenaryElement> RodPack<V>::catenary_elements(int lane) const {
    using T = LaneTraits<V>;
    std::vector<CatenaryElement> elements;
    auto mass = masses_.begin();
    for (std::size_t e = 0; e < properties_.size(); ++e) {
        const ElementProperties<V>& p = properties_[e];
        const double EA_static =
            1.0 / (1.0 / T::get(p.K_damper, lane) + 1.0 / T::get(p.K_creep, lane));
        CatenaryElement element{.length = T::get(p.L, lane),
                                .EA = EA_static,
                                .weight_wet = T::get(p.weight, lane) - T::get(p.buoyancy, lane),
                                .weight_dry = T::get(p.weight, lane)};
        for (; mass != masses_.end() && mass->node <= static_cast<int>(e) + 1; ++mass) {
            if (mass->node != static_cast<int>(e) + 1) continue;
            const double buoyancy = T::get(mass->displaced, lane) * gravity_;
            element.point_weight += T::get(mass->mass, lane) * gravity_ - buoyancy;
            // of several at one node as if all were as high as the last that floats
            element.point_buoyancy += buoyancy;
            if (buoyancy > 0.0) element.point_height = T::get(mass->height, lane);
        }
        elements.push_back(element);
    }
    return elements;
}

template <class V>
bool RodPack<V>::hang_lane(int lane, double t, const MotionSpline& platform) {
    using T = LaneTraits<V>;
    const Vec3 a =
        lane_vector(end_values(place_a_, kept_.head().axis_a, V(t), platform).position, lane);
    const Vec3 b =
        lane_vector(end_values(place_b_, kept_.head().axis_b, V(t), platform).position, lane);
    const bool on_bed = place_b_.end[static_cast<std::size_t>(lane)].kind == EndKind::anchor;
    const std::vector<CatenaryElement>& elements = hanging_[static_cast<std::size_t>(lane)];
    const double at_a = elements.back().hanging_at(a.z());
    const Vec3 before = lane_vector(kept_.head().force_a, lane);
    Catenary& found = hung_;
    if (started_)
        follow_catenary(elements, b, a, on_bed, std::hypot(before.x(), before.y()),
                        before.z() - at_a, found);
    else
        solve_catenary(elements, b, a, on_bed, 0.0, found);
    constexpr double most_strain = 0.2;  // of a static solution that is believed, as of the rods'
    if (!found.found) return false;
    for (std::size_t n = 0; n < elements.size(); ++n)
        if (found.nodes[n + 1].tension > most_strain * elements[n].EA) return false;

    NodeState<V>* node = working_.nodes();
    Multiplier<V>* lambda = working_.lambda();
    const std::size_t N = elements.size();
    const auto set_lambda = [&](std::size_t i, double tension, double EA) {
        T::set(lambda[i].before, lane, T::get(lambda[i].now, lane));
        T::set(lambda[i].now, lane, tension / (1.0 + tension / EA));  // R:2
    };
    for (std::size_t n = 0; n <= N; ++n) {
        const CatenaryNode& c = found.nodes[n];
        const double EA = elements[n == 0 ? 0 : n - 1].EA;
        set_lane_vector(node[n].r, lane, c.position);
        set_lane_vector(node[n].d, lane, (1.0 + c.tension / EA) * c.tangent);
        set_lambda(2 * n, c.tension, EA);
        if (n == N) break;
        const CatenaryElement& above = elements[n];
        const double vertical = found.nodes[n + 1].tension * found.nodes[n + 1].tangent.z() -
                                0.5 * above.weight_wet * above.length;
        set_lambda(2 * n + 1,
                   std::hypot(found.horizontal, on_bed ? std::max(vertical, 0.0) : vertical),
                   above.EA);
    }
    Vec3 out(a.x() - b.x(), a.y() - b.y(), 0.0);
    out = out.norm() > 0.0 ? Vec3(found.horizontal * out.normalized()) : Vec3::Zero();
    set_lane_vector(working_.head().force_a, lane, out + (found.vertical_a + at_a) * Vec3::UnitZ());
    set_lane_vector(working_.head().force_b, lane, -out - found.vertical_b * Vec3::UnitZ());
    T::set(working_.head().h, lane,
           t > T::get(kept_.head().t, lane) ? t - T::get(kept_.head().t, lane)
                                            : T::get(line_step_, lane));
    T::set(working_.head().t, lane, t);
    hanging_stiffness_[static_cast<std::size_t>(lane)] = found.stiffness;
    return true;
}

template <class V>
Status RodPack<V>::hang(double t1, const MotionSpline& platform) {
    working_ = kept_;
    if (hanging_.empty())
        for (int i = 0; i < lanes; ++i) hanging_.push_back(catenary_elements(i));
    Status failed;
    for (int i = 0; i < static_cast<int>(lines_.size()); ++i) {
        if (hang_lane(i, t1, platform)) continue;
        const int line = lines_[static_cast<std::size_t>(i)];
        if (failed.ok() || line < failed.line)
            failed = {.code = Status::Code::no_equilibrium, .line = line, .t = t1};
    }
    for (int i = 0; i < static_cast<int>(lines_.size()); ++i) take_wrench(i, platform, t1);
    return failed;
}

template <class V>
Status RodPack<V>::hang_at(const PlatformMotion& pose) {
    PlatformMotion at = pose;
    at.velocity.setZero();
    at.angle_rates.setZero();
    const Status status = hang(0.0, MotionSpline(0.0, at, 0.0, at));
    if (!status.ok()) {
        working_ = kept_;
        return status;
    }
    kept_ = working_;
    kept_.head().t = V(0.0);
    kept_.head().h = line_step_;
    for (std::size_t i = 0; i < lambda_.size(); ++i)
        kept_.lambda()[i].before = kept_.lambda()[i].now;
    working_ = kept_;
    started_ = true;
    return status;
}

template <class V>
Mat6 RodPack<V>::hanging_stiffness(int lane, const Vec3& reference) const {
    if (place_a_.kind != EndKind::platform) return Mat6::Zero();
    const Vec3 lever = lane_vector(working_.nodes()[properties_.size()].r, lane) - reference;
    Eigen::Matrix<double, 3, 6> B;  // R:21
    B << Mat3::Identity(), -skew(lever);
    Mat6 S = B.transpose() * hanging_stiffness_[static_cast<std::size_t>(lane)] * B;
    S.bottomRightCorner<3, 3>() -= skew(force_on_support_a(lane)) * skew(lever);
    return S;
}

template Status RodPack<Single>::hang(double, const MotionSpline&);
template Status RodPack<Single>::hang_at(const PlatformMotion&);
template Mat6 RodPack<Single>::hanging_stiffness(int, const Vec3&) const;
template std::vector<CatenaryElement> RodPack<Single>::catenary_elements(int) const;
template Status RodPack<Quad>::hang(double, const MotionSpline&);
template Status RodPack<Quad>::hang_at(const PlatformMotion&);
template Mat6 RodPack<Quad>::hanging_stiffness(int, const Vec3&) const;
template std::vector<CatenaryElement> RodPack<Quad>::catenary_elements(int) const;

}  // namespace hawser::worker
