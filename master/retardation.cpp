#include "retardation.hpp"

#include <cmath>

namespace hawser::master {

namespace {
constexpr double sampling = 0.02;  ///< of integrals over tau [s]; a wave of 5 rad/s turns by 0.1
}  // namespace

Retardation::Retardation(const HydroData& data) {
    if (data.frequencies.empty() || data.frequencies.front() > 0.0) {
        frequencies_.push_back(0.0);
        damping_.push_back(Mat6::Zero());
    }
    for (std::size_t i = 0; i < data.frequencies.size(); ++i) {
        frequencies_.push_back(data.frequencies[i]);
        damping_.push_back(0.5 * (data.damping[i] + data.damping[i].transpose()));
    }
}

Mat6 Retardation::at(double tau) const {
    Mat6 K = Mat6::Zero();
    for (std::size_t i = 0; i + 1 < frequencies_.size(); ++i) {
        const double a = frequencies_[i], b = frequencies_[i + 1], width = b - a;
        // int (B_a + (B_b - B_a)(w - a)/width) cos(w tau) dw = weight_a B_a + weight_b B_b
        double weight_a, weight_b;
        if (width * tau < 1e-3) {  // cos hardly changes over the piece
            weight_a = width * std::cos((2 * a + b) / 3 * tau) / 2;
            weight_b = width * std::cos((a + 2 * b) / 3 * tau) / 2;
        } else {
            const double bend = (std::cos(b * tau) - std::cos(a * tau)) / (width * tau * tau);
            weight_a = -std::sin(a * tau) / tau - bend;
            weight_b = std::sin(b * tau) / tau + bend;
        }
        K += weight_a * damping_[i] + weight_b * damping_[i + 1];
    }
    return 2 / M_PI * K;
}

Mat6 Retardation::added_mass(const Mat6& infinite, double w, double duration) const {
    // Simpson
    const int n = 2 * static_cast<int>(std::ceil(duration / sampling / 2));
    const double h = duration / n;
    Mat6 sum = Mat6::Zero();
    for (int i = 0; i <= n; ++i) {
        const double weight = i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2;
        sum += weight * std::sin(w * i * h) * at(i * h);
    }
    return infinite - h / 3 / w * sum;
}

Mat6 estimated_infinite_added_mass(const HydroData& data, double duration) {
    const Retardation K(data);
    const int n = 2 * static_cast<int>(std::ceil(duration / sampling / 2));
    const double h = duration / n;
    std::vector<Mat6> integral(data.frequencies.size(), Mat6::Zero());
    for (int i = 0; i <= n; ++i) {
        const double weight = (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2) * h / 3;
        const Mat6 at = K.at(i * h);
        for (std::size_t f = 0; f < integral.size(); ++f)
            integral[f] += weight * std::sin(data.frequencies[f] * i * h) * at;
    }
    Mat6 sum = Mat6::Zero();
    double weights = 0.0;
    for (std::size_t f = 0; f < integral.size(); ++f) {
        const double w = data.frequencies[f];
        sum += w * w * (data.added_mass[f] + integral[f] / w);
        weights += w * w;
    }
    return sum / weights;
}

}  // namespace hawser::master
