#include "io/qtf_rows.hpp"

#include <algorithm>
#include <cmath>

#include "io/wave_rows.hpp"

namespace hawser::io {

namespace {
constexpr double turn = 2.0 * M_PI;
constexpr double same_heading = 1e-6;  // [rad]

// Into [-pi, pi).
double reduced(double heading) {
    const double b = heading - turn * std::floor(heading / turn + 0.5);
    return b > M_PI - same_heading ? -M_PI : b;
}

QtfPair& pair_at(Qtf& qtf, double b1, double b2) {
    for (QtfPair& p : qtf.pairs)
        if (std::abs(p.heading_1 - b1) < same_heading && std::abs(p.heading_2 - b2) < same_heading)
            return p;
    const std::size_t n = qtf.frequencies.size() * qtf.frequencies.size();
    qtf.pairs.push_back({b1, b2, std::vector<CVec6>(n, CVec6::Zero()), std::vector<char>(n, 0)});
    return qtf.pairs.back();
}

bool has_pair(const Qtf& qtf, double b1, double b2) {
    return std::any_of(qtf.pairs.begin(), qtf.pairs.end(), [&](const QtfPair& p) {
        return std::abs(p.heading_1 - b1) < same_heading &&
               std::abs(p.heading_2 - b2) < same_heading;
    });
}

void order(Qtf& qtf) {
    std::sort(qtf.pairs.begin(), qtf.pairs.end(), [](const QtfPair& a, const QtfPair& b) {
        if (std::abs(a.heading_1 - b.heading_1) > same_heading) return a.heading_1 < b.heading_1;
        return a.heading_2 < b.heading_2;
    });
}
}  // namespace

Qtf qtf_of(const std::vector<QtfRow>& rows, bool difference) {
    Qtf qtf;
    for (const QtfRow& row : rows) {
        qtf.frequencies.push_back(row.frequency_1);
        qtf.frequencies.push_back(row.frequency_2);
    }
    qtf.frequencies = distinct_frequencies(std::move(qtf.frequencies));
    const std::size_t N = qtf.frequencies.size();
    for (const QtfRow& row : rows) {
        const std::size_t m = place_of_frequency(qtf.frequencies, row.frequency_1);
        const std::size_t n = place_of_frequency(qtf.frequencies, row.frequency_2);
        QtfPair& pair =
            pair_at(qtf, reduced(row.heading_1 * M_PI / 180), reduced(row.heading_2 * M_PI / 180));
        pair.values[m * N + n][row.mode] = row.value;
        pair.given[m * N + n] = 1;
    }
    for (std::size_t p = 0; p < qtf.pairs.size(); ++p) {
        (void)pair_at(qtf, qtf.pairs[p].heading_2, qtf.pairs[p].heading_1);  // may add it
        const QtfPair from = qtf.pairs[p];
        QtfPair& to = pair_at(qtf, from.heading_2, from.heading_1);
        for (std::size_t m = 0; m < N; ++m)
            for (std::size_t n = 0; n < N; ++n) {
                if (from.given[m * N + n] == 0 || to.given[n * N + m] != 0) continue;
                const CVec6& Q = from.values[m * N + n];
                to.values[n * N + m] = difference ? CVec6(Q.conjugate()) : Q;
                to.given[n * N + m] = 1;
            }
    }
    order(qtf);
    return qtf;
}

void mirror(Qtf& qtf, bool about_xz) {
    const CVec6 sign = mirror_sign(about_xz).cast<Complex>();
    const auto image_of = [&](double b) { return reduced(about_xz ? -b : M_PI - b); };
    const std::size_t n = qtf.pairs.size();
    for (std::size_t i = 0; i < n; ++i) {
        QtfPair image = qtf.pairs[i];
        image.heading_1 = image_of(image.heading_1);
        image.heading_2 = image_of(image.heading_2);
        if (has_pair(qtf, image.heading_1, image.heading_2)) continue;
        for (CVec6& Q : image.values) Q = Q.cwiseProduct(sign).eval();
        qtf.pairs.push_back(std::move(image));
    }
    order(qtf);
}

}  // namespace hawser::io
