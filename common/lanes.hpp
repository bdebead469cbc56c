// N doubles side by side, one per vector lane: the value type of the rod packs and of the wave
// sums. Every operation acts on each lane alone, so no lane's bits depend on its neighbours.
#pragma once

#include <cmath>
#include <cstdint>

namespace hawser {

// The compiler's vector types, spelled out: the attribute does not survive a dependent width.
template <int N>
struct LaneRegisters;
template <>
struct LaneRegisters<1> {
    using Doubles = double __attribute__((vector_size(8)));
    using Integers = int64_t __attribute__((vector_size(8)));
};
template <>
struct LaneRegisters<2> {
    using Doubles = double __attribute__((vector_size(16)));
    using Integers = int64_t __attribute__((vector_size(16)));
};
template <>
struct LaneRegisters<4> {
    using Doubles = double __attribute__((vector_size(32)));
    using Integers = int64_t __attribute__((vector_size(32)));
};
template <>
struct LaneRegisters<8> {
    using Doubles = double __attribute__((vector_size(64)));
    using Integers = int64_t __attribute__((vector_size(64)));
};

template <int N>
struct LaneMask {
    using Raw = typename LaneRegisters<N>::Integers;
    Raw v;
    [[gnu::always_inline]] friend LaneMask operator&(LaneMask a, LaneMask b) { return {a.v & b.v}; }
    [[gnu::always_inline]] friend LaneMask operator|(LaneMask a, LaneMask b) { return {a.v | b.v}; }
    [[gnu::always_inline]] LaneMask operator!() const { return {~v}; }
    [[nodiscard]] bool operator[](int i) const {
        return reinterpret_cast<const int64_t*>(&v)[i] != 0;
    }
    void set(int i, bool on) { reinterpret_cast<int64_t*>(&v)[i] = on ? -1 : 0; }
    static LaneMask none() { return {Raw{}}; }
    static LaneMask all() { return {~Raw{}}; }
};

template <int N>
struct Lanes {
    using Raw = typename LaneRegisters<N>::Doubles;
    using Mask = LaneMask<N>;
    static constexpr int size = N;
    Raw v;

    Lanes() : v{} {}
    [[gnu::always_inline]] Lanes(Raw raw) : v(raw) {}
    [[gnu::always_inline]] Lanes(double x) : v(Raw{} + x) {}
    [[nodiscard]] double operator[](int i) const { return reinterpret_cast<const double*>(&v)[i]; }
    void set(int i, double x) { reinterpret_cast<double*>(&v)[i] = x; }

    [[gnu::always_inline]] friend Lanes operator+(Lanes a, Lanes b) { return a.v + b.v; }
    [[gnu::always_inline]] friend Lanes operator-(Lanes a, Lanes b) { return a.v - b.v; }
    [[gnu::always_inline]] friend Lanes operator*(Lanes a, Lanes b) { return a.v * b.v; }
    [[gnu::always_inline]] friend Lanes operator/(Lanes a, Lanes b) { return a.v / b.v; }
    [[gnu::always_inline]] Lanes operator-() const { return -v; }
    [[gnu::always_inline]] Lanes& operator+=(Lanes a) { return v += a.v, *this; }
    [[gnu::always_inline]] Lanes& operator-=(Lanes a) { return v -= a.v, *this; }
    [[gnu::always_inline]] Lanes& operator*=(Lanes a) { return v *= a.v, *this; }
    [[gnu::always_inline]] friend Mask operator<(Lanes a, Lanes b) { return {a.v < b.v}; }
    [[gnu::always_inline]] friend Mask operator<=(Lanes a, Lanes b) { return {a.v <= b.v}; }
    [[gnu::always_inline]] friend Mask operator>(Lanes a, Lanes b) { return {a.v > b.v}; }
    [[gnu::always_inline]] friend Mask operator>=(Lanes a, Lanes b) { return {a.v >= b.v}; }
};

template <int N>
[[gnu::always_inline]] inline Lanes<N> select(LaneMask<N> m, Lanes<N> a, Lanes<N> b) {
    return m.v ? a.v : b.v;
}
template <int N>
[[gnu::always_inline]] inline Lanes<N> sqrt(Lanes<N> a) {
    typename Lanes<N>::Raw r;
    for (int i = 0; i < N; ++i) r[i] = std::sqrt(a.v[i]);
    return r;
}
template <int N>
[[gnu::always_inline]] inline Lanes<N> abs(Lanes<N> a) {
    return a.v < 0.0 ? -a.v : a.v;
}
template <int N>
[[gnu::always_inline]] inline Lanes<N> max(Lanes<N> a, Lanes<N> b) {
    return a.v > b.v ? a.v : b.v;
}
template <int N>
[[gnu::always_inline]] inline Lanes<N> min(Lanes<N> a, Lanes<N> b) {
    return a.v < b.v ? a.v : b.v;
}
template <int N>
inline bool any(LaneMask<N> m) {
    int64_t on = 0;
    for (int i = 0; i < N; ++i) on |= m[i];
    return on != 0;
}

/// A value type's lanes, seen from code that is written for any V.
template <class V>
struct LaneTraits;
template <int N>
struct LaneTraits<Lanes<N>> {
    using Mask = LaneMask<N>;
    static constexpr int count = N;
    static double get(const Lanes<N>& v, int i) { return v[i]; }
    static void set(Lanes<N>& v, int i, double x) { v.set(i, x); }
    static bool get(const Mask& m, int i) { return m[i]; }
    static void set(Mask& m, int i, bool on) { m.set(i, on); }
    static Mask none() { return Mask::none(); }
};

}  // namespace hawser
