#include "rod/catenary.hpp"

#include <algorithm>
#include <cmath>

namespace hawser::worker {

namespace {

/// A number with its derivatives by the two unknowns of a catenary, H and u.
struct Dual {
    double v, H = 0.0, u = 0.0;
    Dual(double value = 0.0, double dH = 0.0, double du = 0.0) : v(value), H(dH), u(du) {}

    Dual& operator+=(const Dual& b) { return *this = *this + b; }
    friend Dual operator+(const Dual& a, const Dual& b) {
        return {a.v + b.v, a.H + b.H, a.u + b.u};
    }
    friend Dual operator-(const Dual& a, const Dual& b) {
        return {a.v - b.v, a.H - b.H, a.u - b.u};
    }
    friend Dual operator*(const Dual& a, const Dual& b) {
        return {a.v * b.v, a.H * b.v + a.v * b.H, a.u * b.v + a.v * b.u};
    }
    friend Dual operator/(const Dual& a, const Dual& b) {
        const double q = a.v / b.v;
        return {q, (a.H - q * b.H) / b.v, (a.u - q * b.u) / b.v};
    }
    /// f(a) where f has the value and slope given.
    static Dual chain(const Dual& a, double value, double slope) {
        return {value, slope * a.H, slope * a.u};
    }
};
double plain(double x) { return x; }
double plain(const Dual& x) { return x.v; }
double length_of(double a, double b) { return std::hypot(a, b); }
Dual length_of(const Dual& a, const Dual& b) {
    const double h = std::hypot(a.v, b.v);
    return {h, (a.v * a.H + b.v * b.H) / h, (a.v * a.u + b.v * b.u) / h};
}
double area_sinh(double x) { return std::asinh(x); }
Dual area_sinh(const Dual& x) {
    return Dual::chain(x, std::asinh(x.v), 1.0 / std::sqrt(1.0 + x.v * x.v));
}

/// Plane march from B to A: x horizontal towards A, z up, V vertical tension.
struct March {
    const std::vector<CatenaryElement>& elements;
    double z_b;
    bool on_bed;
    double friction = 0.0;

    template <class T>
    struct Point {
        T x, z, V, H;  ///< H, the horizontal tension, is less along the bed than above it
    };
    using End = Point<double>;

    /// Ends of all elements for horizontal tension H and parameter u: u >= 0 (or no bed) is the
    /// vertical tension at B; u < 0 with a bed means that a length -u lies on it (beside what
    /// clumps that lie there are worth).
    template <class T, class Visit>
    Point<T> run(T H, T u, Visit visit) const {
        const bool lies = on_bed && plain(u) < 0.0;
        T grounded = lies ? T(0.0) - u : T(0.0);
        T ahead = friction_of(grounded);  // between here and touchdown
        Point<T> p{T(0.0), T(z_b), lies ? T(0.0) : u, left_of(H, ahead)};
        visit(p);
        for (const CatenaryElement& e : elements) {
            const T lying = plain(grounded) < e.length ? grounded : T(e.length);
            grounded = grounded - lying;
            lie(e, H, lying, ahead, p);
            const T L = T(e.length) - lying;
            if (plain(L) > 0.0) advance(e, H, L, p), p.H = H;
            const T carried = carried_by_bed(e, grounded);
            grounded = grounded - carried;
            p.V += hanging(e, p.z) - carried * T(e.weight_wet);
            visit(p);
        }
        return p;
    }

    /// Length on the bed of all elements for this u.
    [[nodiscard]] double lying(double u) const {
        double left = on_bed && u < 0.0 ? -u : 0.0, sum = 0.0;
        for (const CatenaryElement& e : elements) {
            const double here = std::min(left, e.length);
            sum += here;
            left -= here;
            left -= carried_by_bed(e, left);
        }
        return sum;
    }

 private:
    static double hanging(const CatenaryElement& e, double z) { return e.hanging_at(z); }
    static Dual hanging(const CatenaryElement& e, const Dual& z) {
        const double dry = e.dry_part(z.v);
        const bool pierces = dry > 0.0 && dry < 1.0;
        return Dual::chain(z, e.hanging_at(z.v), pierces ? e.point_buoyancy / e.point_height : 0.0);
    }

    /// What the bed carries of a clump that lies on it, as length of line of the same weight: -u
    /// goes through it while the clump is lifted, so that the end follows u without a jump.
    template <class T>
    static T carried_by_bed(const CatenaryElement& e, const T& grounded) {
        if (!(plain(grounded) > 0.0 && e.point_weight > 0.0 && e.weight_wet > 0.0)) return T(0.0);
        const double all = e.point_weight / e.weight_wet;
        return plain(grounded) < all ? grounded : T(all);
    }

    /// Friction of the bed on the first `grounded` metres from B [N]; clumps rub no more than the
    /// line does.
    template <class T>
    T friction_of(T grounded) const {
        T sum(0.0);
        if (friction == 0.0) return sum;
        for (const CatenaryElement& e : elements) {
            const T lying = plain(grounded) < e.length ? grounded : T(e.length);
            grounded = grounded - lying;
            sum += T(friction * e.weight_wet) * lying;
            grounded = grounded - carried_by_bed(e, grounded);
        }
        return sum;
    }
    template <class T>
    static T left_of(const T& H, const T& rubbed) {
        return plain(rubbed) < plain(H) ? H - rubbed : T(0.0);
    }

    /// A piece that lies on the bed, towards touchdown: its tension grows by the friction on it,
    /// from max(H - ahead, 0), and stretches what is under tension.
    template <class T>
    void lie(const CatenaryElement& e, const T& H, const T& L, T& ahead, Point<T>& p) const {
        const double f = friction * e.weight_wet;
        if (!(f > 0.0)) {
            p.x += L * (T(1.0) + H / T(e.EA));
            return;
        }
        const T T1 = p.H;
        ahead = ahead - T(f) * L;
        p.H = left_of(H, ahead);
        p.x += L + (p.H - T1) * (p.H + T1) / T(2.0 * f * e.EA);
    }

    /// One elastic catenary piece (Irvine): dx = (H/w)(asinh(V2/H) - asinh(V1/H)) + H L/EA, and so
    /// on.
    template <class T>
    static void advance(const CatenaryElement& e, const T& H, const T& L, Point<T>& p) {
        const double w = plain(p.z) < 0.0 ? e.weight_wet : e.weight_dry;
        const T V2 = p.V + T(w) * L;
        const T T1 = length_of(H, p.V), T2 = length_of(H, V2);
        if (std::abs(w) * plain(L) > 1e-9 * (plain(T1) + plain(T2))) {
            p.x += H / T(w) * (area_sinh(V2 / H) - area_sinh(p.V / H));
            p.z += (T2 - T1) / T(w);
        } else {
            p.x += H / T1 * L;
            p.z += p.V / T1 * L;
        }
        p.x += H * L / T(e.EA);
        p.z += (p.V + V2) / T(2.0) * L / T(e.EA);
        p.V = V2;
    }
};

/// Horizontal direction from B to A; of a vertical line any will do.
struct Plane {
    double length = 0.0, span = 0.0, tiny_span = 0.0;
    Vec3 towards = Vec3::UnitX();

    Plane(const std::vector<CatenaryElement>& elements, const Vec3& b, const Vec3& a) {
        for (const CatenaryElement& e : elements) length += e.length;
        span = std::hypot(a.x() - b.x(), a.y() - b.y());
        tiny_span = 1e-6 * length;
        if (span > tiny_span) towards = Vec3((a.x() - b.x()) / span, (a.y() - b.y()) / span, 0.0);
    }
};

/// The line with these unknowns.
void shape_of(const March& march, const Plane& plane, const Vec3& b, double H, double u,
              Catenary& result) {
    result.nodes.clear();
    result.horizontal = H;
    result.grounded = march.lying(u);
    result.vertical_b = march.on_bed ? std::max(u, 0.0) : u;
    std::size_t n = 0;
    const March::End end = march.run(H, u, [&](const March::End& p) {
        // a node's tangent and tension are those just below what hangs on it
        const double V = n == 0 ? result.vertical_b : p.V - march.elements[n - 1].hanging_at(p.z);
        const double T = std::hypot(H, V);  // but for friction
        result.nodes.push_back({.position = b + p.x * plane.towards + Vec3(0, 0, p.z - b.z()),
                                .tangent = H / T * plane.towards + V / T * Vec3::UnitZ(),
                                .tension = std::hypot(p.H, V)});
        ++n;
    });
    result.vertical_a = end.V - march.elements.back().hanging_at(end.z);
}

/// Stiffness at end A: in the plane d(H, V)/d(x, z), across it H/span.
Mat3 stiffness_of(const Plane& plane, double H, const March::Point<Dual>& end) {
    Eigen::Matrix2d flex, force;
    flex << end.x.H, end.x.u, end.z.H, end.z.u;
    force << 1.0, 0.0, end.V.H, end.V.u;
    const Eigen::Matrix2d K = force * flex.inverse();
    const Vec3 e = plane.towards, k = Vec3::UnitZ(), across = k.cross(e);
    return K(0, 0) * e * e.transpose() + K(0, 1) * e * k.transpose() + K(1, 0) * k * e.transpose() +
           K(1, 1) * k * k.transpose() +
           H / std::max(plane.span, plane.tiny_span) * across * across.transpose();
}

/// Root of a growing function between lo and hi; a fixed number of halvings, so the same bits
/// always.
template <class F>
double bisect(double lo, double hi, F f) {
    for (int i = 0; i < 200 && lo < hi; ++i) {
        const double mid = 0.5 * (lo + hi);
        if (mid <= lo || mid >= hi) break;
        (f(mid) < 0.0 ? lo : hi) = mid;
    }
    return 0.5 * (lo + hi);
}

}  // namespace

Catenary solve_catenary(const std::vector<CatenaryElement>& elements, const Vec3& b, const Vec3& a,
                        bool on_bed, double friction) {
    Catenary line;
    solve_catenary(elements, b, a, on_bed, friction, line);
    return line;
}

void solve_catenary(const std::vector<CatenaryElement>& elements, const Vec3& b, const Vec3& a,
                    bool on_bed, double friction, Catenary& line) {
    const Plane plane(elements, b, a);
    double weight = 0.0;
    for (const CatenaryElement& e : elements)
        weight += std::abs(e.weight_wet) * e.length + std::abs(e.point_weight);
    const double scale = weight + 1.0, length = plane.length;
    const double span = std::max(plane.span, plane.tiny_span);
    const March march{elements, b.z(), on_bed, friction};
    const auto nothing = [](const March::End&) {};

    // Height of end A grows with u: bracket, then bisect.
    const auto u_for = [&](double H) {
        const auto miss = [&](double u) { return march.run(H, u, nothing).z - a.z(); };
        double lo = on_bed ? -length : -scale, hi = scale;
        for (const CatenaryElement& e : elements)
            if (on_bed && e.weight_wet > 0.0) lo -= std::max(0.0, e.point_weight / e.weight_wet);
        for (int i = 0; i < 60 && miss(hi) < 0.0; ++i) hi *= 2.0;
        for (int i = 0; i < 60 && !on_bed && miss(lo) > 0.0; ++i) lo *= 2.0;
        return bisect(lo, hi, miss);
    };
    const auto span_miss = [&](double log_H) {
        const double H = std::exp(log_H);
        return march.run(H, u_for(H), nothing).x - span;
    };
    double lo = std::log(1e-7 * scale), hi = std::log(scale);
    for (int i = 0; i < 60 && span_miss(hi) < 0.0; ++i) hi += 1.0;

    const double H = std::exp(bisect(lo, hi, span_miss));
    const double u = u_for(H);
    shape_of(march, plane, b, H, u, line);
    const March::End end = march.run(H, u, nothing);
    line.found = std::abs(end.x - span) < 1e-3 * length && std::abs(end.z - a.z()) < 1e-3 * length;
    if (line.found)
        line.stiffness = stiffness_of(
            plane, H, march.run(Dual(H, 1, 0), Dual(u, 0, 1), [](const March::Point<Dual>&) {}));
}

void follow_catenary(const std::vector<CatenaryElement>& elements, const Vec3& b, const Vec3& a,
                     bool on_bed, double horizontal, double vertical_a, Catenary& line) {
    constexpr int most_iterations = 20;
    constexpr double close = 1e-10;  // of the length
    const Plane plane(elements, b, a);
    const March march{elements, b.z(), on_bed};
    double H = horizontal, u = vertical_a;
    for (auto e = elements.rbegin(); e != elements.rend(); ++e) {  // down from end A
        if (e != elements.rbegin()) u -= e->point_weight;
        const double w = e->weight_wet;
        if (on_bed && u < w * e->length) {  // it touches down in this element
            u = -(e->length - u / w);
            for (++e; e != elements.rend(); ++e) u -= e->length;
            break;
        }
        u -= w * e->length;
    }
    bool close_now = false;
    for (int i = 0; i < most_iterations && H > 0.0 && std::isfinite(H + u); ++i) {
        const auto end = march.run(Dual(H, 1, 0), Dual(u, 0, 1), [](const March::Point<Dual>&) {});
        if (close_now) {  // with the last correction carried out
            shape_of(march, plane, b, H, u, line);
            line.stiffness = stiffness_of(plane, H, end);
            line.found = true;
            return;
        }
        const double dx = end.x.v - plane.span, dz = end.z.v - a.z();
        const double det = end.x.H * end.z.u - end.x.u * end.z.H;
        if (plane.span <= plane.tiny_span || det == 0.0) break;
        const double dH = -(dx * end.z.u - dz * end.x.u) / det;
        const double du = -(dz * end.x.H - dx * end.z.H) / det;
        H = std::max(H + dH, 0.2 * H);
        u += du;
        close_now = std::max(std::abs(dx), std::abs(dz)) < close * plane.length;
    }
    solve_catenary(elements, b, a, on_bed, 0.0, line);
}

Catenary hang_freely(const std::vector<CatenaryElement>& elements, const Vec3& a) {
    Catenary result;
    result.found = true;
    double length = 0.0;
    for (const CatenaryElement& e : elements) length += e.length;
    double T = 0.0, z = a.z() - length;
    result.nodes.push_back(
        {.position = {a.x(), a.y(), z}, .tangent = Vec3::UnitZ(), .tension = 0.0});
    for (const CatenaryElement& e : elements) {
        const double w = z < 0.0 ? e.weight_wet : e.weight_dry;
        z += e.length;
        T += w * e.length;
        result.nodes.push_back(
            {.position = {a.x(), a.y(), z}, .tangent = Vec3::UnitZ(), .tension = T});
        T += e.point_weight;
    }
    result.vertical_a = T - elements.back().point_weight;
    return result;
}

}  // namespace hawser::worker
