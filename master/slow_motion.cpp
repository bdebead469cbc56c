#include "slow_motion.hpp"

namespace hawser::master {

namespace {
// Rows of surge, sway, yaw among the motions of the state.
constexpr int motion_row[3] = {0, 1, 5};
constexpr double damping_a = 0.7654, damping_s = 1.8478;  // 2 zeta of the two sections
}  // namespace

WavePosition slow_position(const State& s) {
    return {s[filter_index(0) + 2], s[filter_index(1) + 2], s[filter_index(2) + 2]};
}

WavePosition instantaneous_position(const State& s) { return {s[0], s[1], s[5]}; }

void add_slow_motion_to(State& rate, const State& s, double wc) {
    if (wc <= 0.0) return;
    for (int j = 0; j < 3; ++j) {
        const int i = filter_index(j);
        const double x = s[motion_row[j]], xa = s[i], va = s[i + 1], xs = s[i + 2], vs = s[i + 3];
        rate[i] += va;
        rate[i + 1] += -damping_a * wc * va - wc * wc * (xa - x);
        rate[i + 2] += vs;
        rate[i + 3] += -damping_s * wc * vs - wc * wc * (xs - xa);
    }
}

void rest_slow_motion_at(State& s, const PlatformMotion& m) {
    const double at[3] = {m.position.x(), m.position.y(), m.angles.z()};
    for (int j = 0; j < 3; ++j) s.segment<4>(filter_index(j)) << at[j], 0.0, at[j], 0.0;
}

}  // namespace hawser::master
