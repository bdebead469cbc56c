// Three-vectors and symmetric 3 x 3 matrices over a lane value type V (Lanes<N>).
#pragma once

#include "lanes.hpp"

namespace hawser::worker {

using hawser::select;

template <class V>
struct Vector {
    V x{}, y{}, z{};
    [[gnu::always_inline]] friend Vector operator+(const Vector& a, const Vector& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    [[gnu::always_inline]] friend Vector operator-(const Vector& a, const Vector& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    [[gnu::always_inline]] friend Vector operator*(V s, const Vector& a) {
        return {s * a.x, s * a.y, s * a.z};
    }
    [[gnu::always_inline]] Vector& operator+=(const Vector& a) {
        x += a.x, y += a.y, z += a.z;
        return *this;
    }
    [[gnu::always_inline]] Vector& operator-=(const Vector& a) {
        x -= a.x, y -= a.y, z -= a.z;
        return *this;
    }
};

template <class V>
[[gnu::always_inline]] inline V dot(const Vector<V>& a, const Vector<V>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class V>
[[gnu::always_inline]] inline Vector<V> cross(const Vector<V>& a, const Vector<V>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class V, class M>
[[gnu::always_inline]] inline Vector<V> select(M m, const Vector<V>& a, const Vector<V>& b) {
    return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}

template <class V>
struct Symmetric {
    V xx{}, yy{}, zz{}, xy{}, xz{}, yz{};

    /// c I
    [[gnu::always_inline]] static Symmetric scaled_identity(V c) {
        return {c, c, c, V(0), V(0), V(0)};
    }
    /// += c a a^T
    [[gnu::always_inline]] void add_outer(V c, const Vector<V>& a) {
        const V cx = c * a.x, cy = c * a.y, cz = c * a.z;
        xx += cx * a.x, yy += cy * a.y, zz += cz * a.z;
        xy += cx * a.y, xz += cx * a.z, yz += cy * a.z;
    }
    /// += c S
    [[gnu::always_inline]] void add(V c, const Symmetric& S) {
        xx += c * S.xx, yy += c * S.yy, zz += c * S.zz;
        xy += c * S.xy, xz += c * S.xz, yz += c * S.yz;
    }
    [[gnu::always_inline]] friend Vector<V> operator*(const Symmetric& S, const Vector<V>& a) {
        return {S.xx * a.x + S.xy * a.y + S.xz * a.z, S.xy * a.x + S.yy * a.y + S.yz * a.z,
                S.xz * a.x + S.yz * a.y + S.zz * a.z};
    }
    /// Entry (i, j); i and j are constants once loops are unrolled.
    V operator()(int i, int j) const {
        if (i > j) return (*this)(j, i);
        if (i == 0) return j == 0 ? xx : j == 1 ? xy : xz;
        if (i == 1) return j == 1 ? yy : yz;
        return zz;
    }
};

template <class M, class V>
[[gnu::always_inline]] inline Symmetric<V> select(M m, const Symmetric<V>& a,
                                                  const Symmetric<V>& b) {
    return {select(m, a.xx, b.xx), select(m, a.yy, b.yy), select(m, a.zz, b.zz),
            select(m, a.xy, b.xy), select(m, a.xz, b.xz), select(m, a.yz, b.yz)};
}

}  // namespace hawser::worker
