#include "message.hpp"

#include <algorithm>

namespace hawser {

namespace {

double* put(double* to, const Vec3& v) { return std::copy(v.data(), v.data() + 3, to); }

double* put(double* to, const PlatformMotion& m) {
    return put(put(put(put(to, m.position), m.angles), m.velocity), m.angle_rates);
}

PlatformMotion motion_at(const double* from) {
    return {.position = Vec3(from),
            .angles = Vec3(from + 3),
            .velocity = Vec3(from + 6),
            .angle_rates = Vec3(from + 9)};
}

}  // namespace

OrderMessage pack(const Order& o) {
    OrderMessage m{};
    m[0] = static_cast<double>(static_cast<int>(o.ask));
    m[1] = o.keep_previous;
    m[2] = o.sample;
    m[3] = o.snapshot;
    m[4] = o.write_segment;
    m[5] = o.current;
    m[6] = o.t0;
    m[7] = o.t1;
    m[8] = o.frequency;
    double* to = &m[9];
    for (std::size_t k = 0; k < o.from.size(); ++k) to = put(put(to, o.from[k]), o.to[k]);
    return m;
}

Order unpack(const OrderMessage& m) {
    Order o{.ask = static_cast<Ask>(static_cast<int>(m[0])),
            .keep_previous = m[1] != 0.0,
            .sample = m[2] != 0.0,
            .snapshot = m[3] != 0.0,
            .write_segment = m[4] != 0.0,
            .current = m[5] != 0.0,
            .t0 = m[6],
            .t1 = m[7],
            .frequency = m[8]};
    for (std::size_t k = 0; k < o.from.size(); ++k) {
        o.from[k] = motion_at(&m[9 + 24 * k]);
        o.to[k] = motion_at(&m[21 + 24 * k]);
    }
    return o;
}

void pack_reply_to(const Reply& reply, Ask ask, std::span<double> out, bool between) {
    double* to = out.data();
    *to++ = static_cast<double>(static_cast<int>(reply.status.code));
    *to++ = reply.status.line;
    *to++ = reply.status.arc_length;
    *to++ = reply.status.t;
    *to++ = reply.status.residual;
    *to++ = reply.status.iterations;
    for (const LineLoad& line : reply.lines) {
        to = std::copy(line.wrench.data(), line.wrench.data() + 6, to);
        *to++ = line.end_tension;
        *to++ = line.impulse_mismatch;
        *to++ = line.mismatch_at;
        if (replies_stiffness(ask))
            to = std::copy(line.stiffness.data(), line.stiffness.data() + 36, to);
        if (!between) continue;
        const SecondLoad& second = line.second;
        to = std::copy(second.wrench.data(), second.wrench.data() + 6, to);
        if (!replies_stiffness(ask)) continue;
        for (const Mat6* S : {&second.stiffness, &second.on_first, &second.of_first})
            to = std::copy(S->data(), S->data() + 36, to);
    }
}

Status unpack_status(std::span<const double> m) {
    return {.code = static_cast<Status::Code>(static_cast<int>(m[0])),
            .line = static_cast<int>(m[1]),
            .arc_length = m[2],
            .t = m[3],
            .residual = m[4],
            .iterations = static_cast<int>(m[5])};
}

LineLoad unpack_line(std::span<const double> message, Ask ask, int line, bool between) {
    const double* from = message.data() + status_numbers + line * numbers_per_line(ask, between);
    LineLoad load;
    load.wrench = Vec6(from);
    load.end_tension = from[6];
    load.impulse_mismatch = from[7];
    load.mismatch_at = static_cast<int>(from[8]);
    if (replies_stiffness(ask)) load.stiffness = Mat6(from + 9);
    if (!between) return load;
    from += replies_stiffness(ask) ? 45 : 9;
    SecondLoad& second = load.second;
    second.wrench = Vec6(from);
    if (!replies_stiffness(ask)) return load;
    second.stiffness = Mat6(from + 6);
    second.on_first = Mat6(from + 42);
    second.of_first = Mat6(from + 78);
    return load;
}

}  // namespace hawser
