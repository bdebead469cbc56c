// Stand-ins for hull and lines with closed-form answers.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "force_fit.hpp"
#include "lines.hpp"
#include "spline.hpp"
#include "state.hpp"

namespace hawser::test {

/// A body with six uncoupled coordinates of the given masses; its own load is a function of t.
struct Body {
    Vec6 masses = Vec6::Ones();
    std::function<Vec6(double)> force = [](double) { return Vec6(Vec6::Zero()); };
    std::vector<std::string>* log = nullptr;

    struct Loads {
        Vec6 outer = Vec6::Zero();
    };
    [[nodiscard]] Loads loads(double t, const master::State&) const {
        if (log != nullptr) log->push_back("loads");
        return {force(t)};
    }
    master::State rate(double, const master::State& y, const Loads& loads, const Vec6& lines,
                       Vec6* acceleration) const {
        *acceleration = (loads.outer + lines).cwiseQuotient(masses);
        master::State dy = master::State::Zero();
        dy.head<6>() = y.segment<6>(6);
        dy.segment<6>(6) = *acceleration;
        return dy;
    }
};

inline Vec6 coordinates(const PlatformMotion& m) {
    Vec6 x;
    x << m.position, m.angles;
    return x;
}

/// Massless springs from the platform's coordinates to the ground; remembers its orders.
class SpringLines final : public Lines {
 public:
    SpringLines(std::vector<Vec6> stiffnesses) : stiffnesses_(std::move(stiffnesses)) {
        reply_.lines.resize(stiffnesses_.size());
    }
    void send(const Order& order) override {
        orders.push_back(order);
        if (log != nullptr) log->push_back("send");
    }
    const Reply& receive() override {
        if (log != nullptr) log->push_back("receive");
        for (size_t i = 0; i < stiffnesses_.size(); ++i) {
            reply_.lines[i].wrench =
                -stiffnesses_[i].cwiseProduct(coordinates(orders.back().to[0]));
            reply_.lines[i].stiffness = stiffnesses_[i].asDiagonal();
        }
        return reply_;
    }
    std::vector<Order> orders;
    std::vector<std::string>* log = nullptr;

 private:
    std::vector<Vec6> stiffnesses_;
    Reply reply_;
};

/// A mass m on a spring k from the platform's surge, with a spring and a damper to the ground,
/// integrated with steps of its own (Runge-Kutta of order 4) along the platform's spline:
///
///     m z'' = k (x(t) - z) - k_g z - c z'        force on the platform: k (z - x)
class SprungMass final : public Lines {
 public:
    double m = 1.0, k = 1.0, k_g = 0.0, c = 0.0;
    double z = 0.0, v = 0.0;  ///< kept state
    double step = 0.01;       ///< upper bound of its own step
    ForceFit fit = ForceFit::instantaneous;
    double time_run = 0.0;  ///< sum of the lengths of all passes
    int passes = 0;

    SprungMass() { reply_.lines.resize(1); }
    void send(const Order& order) override {
        if (order.keep_previous) z = z1_, v = v1_;
        order_ = order;
    }
    const Reply& receive() override {
        const MotionSpline motion(order_.t0, order_.from[0], order_.t1, order_.to[0]);
        const double H = order_.t1 - order_.t0;
        const int n = static_cast<int>(std::ceil(H / step - 1e-9));
        const double h = H / n;
        const auto x = [&](double t) { return motion.at(t).motion.position.x(); };
        const auto a = [&](double t, double zt, double vt) {
            return (k * (x(t) - zt) - k_g * zt - c * vt) / m;
        };
        z1_ = z, v1_ = v;
        double force = fit_weight(fit, 0, n) * k * (z1_ - x(order_.t0));
        for (int i = 0; i < n; ++i) {
            const double t = order_.t0 + i * h;
            const double a1 = a(t, z1_, v1_);
            const double a2 = a(t + h / 2, z1_ + h / 2 * v1_, v1_ + h / 2 * a1);
            const double a3 = a(t + h / 2, z1_ + h / 2 * (v1_ + h / 2 * a1), v1_ + h / 2 * a2);
            const double a4 = a(t + h, z1_ + h * (v1_ + h / 2 * a2), v1_ + h * a3);
            z1_ += h * v1_ + h * h / 6 * (a1 + a2 + a3);
            v1_ += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
            force += fit_weight(fit, i + 1, n) * k * (z1_ - x(order_.t0 + (i + 1) * h));
        }
        reply_.lines[0].wrench = force * Vec6::Unit(0);
        time_run += H;
        ++passes;
        return reply_;
    }

 private:
    double z1_ = 0.0, v1_ = 0.0;
    Order order_;
    Reply reply_;
};

}  // namespace hawser::test
