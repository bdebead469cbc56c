// What the rods of a group do together in every scheme: places and loads of their constraints, one
// linear system, status.
#include "rod/rod_group.hpp"

namespace hawser::worker {

template <class V>
RodGroup<V>::RodGroup(std::span<RodPack<V>> packs) : packs_(packs) {
    find_ties();
}

template <class V>
void RodGroup<V>::place(State before, V t_before, V t, const MotionSpline& platform, bool search) {
    for (RodPack<V>& p : packs_)
        if (!p.constraints_.empty()) p.place_constraints(p.*before, t_before, t, platform, search);
    if (!ties_.empty()) place_ties(before, search);
}

template <class V>
void RodGroup<V>::evaluate(V a1) {
    for (RodPack<V>& p : packs_) p.find_points();
    if (!ties_.empty()) follow_ties();
    for (RodPack<V>& p : packs_) p.apply_laws(a1);
    if (!ties_.empty()) answer_ties();
}

template <class V>
void RodGroup<V>::solve(V a0, V a1) {
    for (RodPack<V>& p : packs_) p.reduce(a0, a1);
    if (!ties_.empty()) couple();
    for (RodPack<V>& p : packs_) p.back_substitute();
    if (!ties_.empty()) carry_ties();
}

template <class V>
Status RodGroup<V>::pass(double t0, double t1, const MotionSpline& platform) {
    switch (packs_.front().model_) {
        case LineModel::quasi_static:
            return still_pass(t0, t1, platform);
        case LineModel::catenary:
            return packs_.front().hang(t1, platform);
        case LineModel::dynamic:
            break;
    }
    return dynamic_pass(t0, t1, platform);
}

template <class V>
Status RodGroup<V>::status_of(Mask bad, Status::Code code, double t) const {
    Status worst = packs_.front().status_of(bad, code, t);
    for (const RodPack<V>& p : packs_.subspan(1)) {
        const Status other = p.status_of(bad, code, t);
        const bool worse = other.code == Status::Code::not_finite
                               ? worst.code != Status::Code::not_finite
                               : other.residual > worst.residual;
        if (worse) worst = other;
    }
    return worst;
}

template <class V>
void RodGroup<V>::swing(double omega) {
    for (RodPack<V>& p : packs_) p.prepare_tangent(omega);
    const PlatformMotion pose = packs_.front().last_pose();
    place(&RodPack<V>::kept_, V(0.0), V(0.0), MotionSpline(0.0, pose, 0.0, pose), true);
    for (RodPack<V>& p : packs_) p.guides_closed_ = true;
    evaluate(V(0.0));
    for (RodPack<V>& p : packs_) p.guides_closed_ = false;
    const bool moves =  // the others have no inertia in a run either
        packs_.front().model_ == LineModel::dynamic;
    solve(V(moves ? -omega * omega : 0.0), V(0.0));
}

template RodGroup<Single>::RodGroup(std::span<RodPack<Single>>);
template void RodGroup<Single>::place(State, Single, Single, const MotionSpline&, bool);
template void RodGroup<Single>::evaluate(Single);
template void RodGroup<Single>::solve(Single, Single);
template Status RodGroup<Single>::pass(double, double, const MotionSpline&);
template Status RodGroup<Single>::status_of(Mask, Status::Code, double) const;
template void RodGroup<Single>::swing(double);
template RodGroup<Quad>::RodGroup(std::span<RodPack<Quad>>);
template void RodGroup<Quad>::place(State, Quad, Quad, const MotionSpline&, bool);
template void RodGroup<Quad>::evaluate(Quad);
template void RodGroup<Quad>::solve(Quad, Quad);
template Status RodGroup<Quad>::pass(double, double, const MotionSpline&);
template Status RodGroup<Quad>::status_of(Mask, Status::Code, double) const;
template void RodGroup<Quad>::swing(double);

}  // namespace hawser::worker
