#include "rod/rod_pack.hpp"
namespace hawser::worker {
template <class V>
Status RodPack<V>::hang(double, double, const MotionSpline&) {
    return {};
}
template Status RodPack<Single>::hang(double, double, const MotionSpline&);
template Status RodPack<Quad>::hang(double, double, const MotionSpline&);
}  // namespace hawser::worker
