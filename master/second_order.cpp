#include "second_order.hpp"

#include <algorithm>
#include <cmath>

#include "cubic_weights.hpp"
#include "yaw_axes.hpp"

namespace hawser::master {

namespace {
constexpr double same_heading = 1e-6;  // [rad]

bool same(double a, double b) { return std::abs(std::remainder(a - b, 2.0 * M_PI)) < same_heading; }

const QtfPair* find_pair(const Qtf& qtf, double b1, double b2) {
    for (const QtfPair& p : qtf.pairs)
        if (same(p.heading_1, b1) && same(p.heading_2, b2)) return &p;
    return nullptr;
}

struct Product {
    double re, im;
};
/// a b, written out: the library's asks for infinities.
Product times(const Complex& a, const Complex& b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
}  // namespace

QuadraticLoad::QuadraticLoad(const Qtf& qtf, Of of, const std::vector<WaveComponent>& components)
    : of_(of) {
    if (qtf.empty() || components.empty()) return;
    const WaveTable<CVec6> own = hawser::diagonal(qtf);
    (void)ComponentTable<CVec6>(own, components);  // refuses what is outside
    full_circle_ = own.full_circle;
    for (const auto& h : own.headings) headings_.push_back(h.heading);
    for (const WaveComponent& c : components) {
        omega_.push_back(c.omega);
        const auto at = std::find(directions_.begin(), directions_.end(), c.heading);
        direction_.push_back(static_cast<std::size_t>(at - directions_.begin()));
        if (at == directions_.end()) directions_.push_back(c.heading);
    }
    std::size_t first = 0;
    find_frequencies(qtf.frequencies, first);
    const std::size_t H = headings_.size();
    for (std::size_t h = 0; h < H; ++h) add_block(qtf, first, h, h);
    crosses_ = directions_.size() > 1 && H > 1;
    for (std::size_t i = 0; i < H; ++i)
        for (std::size_t j = 0; j < i; ++j)
            crosses_ = crosses_ && find_pair(qtf, headings_[j], headings_[i]) != nullptr;
    if (crosses_)
        for (std::size_t i = 0; i < H; ++i)
            for (std::size_t j = i + 1; j < H; ++j) add_block(qtf, first, i, j);

    by_direction_.assign(directions_.size(), Spectrum(n_));
    by_heading_.assign(H, Spectrum(n_));
    total_.resize(n_);
    used_.resize(H);
}

/// Weights of the file's frequencies for every component; keeps only those that have any.
void QuadraticLoad::find_frequencies(const std::vector<double>& file, std::size_t& first) {
    const std::size_t N = file.size();
    std::size_t low = N, high = 0;
    for (const double omega : omega_) {
        FrequencyWeights& w = weights_.emplace_back();
        if (N == 1) {
            w.weight[0] = 1.0;
        } else {
            const double at = std::clamp(omega, file.front(), file.back());
            const auto above = std::upper_bound(file.begin(), file.end(), at) - file.begin();
            const auto i = std::min(static_cast<std::size_t>(above) - 1, N - 2);
            const bool before = i > 0, after = i + 2 < N;
            w.index = {before ? i - 1 : i, i, i + 1, after ? i + 2 : i + 1};
            w.weight = cubic_weights({before ? file[i - 1] : 2 * file[i] - file[i + 1], file[i],
                                      file[i + 1], after ? file[i + 2] : 2 * file[i + 1] - file[i]},
                                     before, after, at);
        }
        for (std::size_t k = 0; k < 4; ++k)
            if (w.weight[k] != 0.0) {
                low = std::min(low, w.index[k]);
                high = std::max(high, w.index[k]);
            }
    }
    first = low;
    n_ = high - low + 1;
    for (FrequencyWeights& w : weights_)
        for (std::size_t k = 0; k < 4; ++k) w.index[k] = w.weight[k] == 0.0 ? 0 : w.index[k] - low;
}

/// With Q(n, m) taken for the conjugate of Q(m, n), or for the same of sums: their mean.
void QuadraticLoad::add_block(const Qtf& qtf, std::size_t first_frequency, std::size_t i,
                              std::size_t j) {
    Block& block = blocks_.emplace_back();
    block.first = i;
    block.second = j;
    const QtfPair& Q = *find_pair(qtf, headings_[i], headings_[j]);
    const QtfPair* mirrored = find_pair(qtf, headings_[j], headings_[i]);
    const std::size_t N = qtf.frequencies.size();
    for (std::size_t g = 0; g < n_; ++g)
        for (std::size_t h = 0; h < (i == j ? g + 1 : n_); ++h) {
            const std::size_t m = first_frequency + g, n = first_frequency + h;
            CVec6 value = Q.values[m * N + n];
            if (mirrored != nullptr) {
                const CVec6& other = mirrored->values[n * N + m];
                value = 0.5 * (value + (of_ == Of::differences ? CVec6(other.conjugate()) : other));
            }
            Coefficient& c = block.Q.emplace_back();
            c.re.head<6>() = value.real().array();
            c.im.head<6>() = value.imag().array();
        }
}

/// Re sum_gh a_g conj(b_h) Q_gh over all g, h, from those with h <= g: Q_hg = conj(Q_gh). Of sums
/// without the conjugates.
Vec6 QuadraticLoad::equal_headings(const Block& block, const Spectrum& a, const Spectrum& b) const {
    const bool differences = of_ == Of::differences;
    Modes re = Modes::Zero(), im = Modes::Zero();
    const Coefficient* Q = block.Q.data();
    for (std::size_t g = 0; g < n_; ++g) {
        const Complex ag = a[g], bg = b[g];
        for (std::size_t h = 0; h < g; ++h, ++Q) {
            const Complex ah = differences ? std::conj(a[h]) : a[h];
            const Complex bh = differences ? std::conj(b[h]) : b[h];
            const Product x = times(ag, bh), y = times(bg, ah);
            re += (x.re + y.re) * Q->re;
            im += (x.im + y.im) * Q->im;
        }
        const Product x = times(ag, differences ? std::conj(bg) : bg);
        re += x.re * Q->re;
        im += x.im * Q->im;
        ++Q;
    }
    return (re - im).head<6>().matrix();
}

/// Twice Re sum_gh a_g conj(b_h) Q_gh: the block of the headings exchanged gives the same.
Vec6 QuadraticLoad::unequal_headings(const Block& block, const Spectrum& a,
                                     const Spectrum& b) const {
    Modes re = Modes::Zero(), im = Modes::Zero();
    const Coefficient* Q = block.Q.data();
    for (std::size_t g = 0; g < n_; ++g)
        for (std::size_t h = 0; h < n_; ++h, ++Q) {
            const Product x = times(a[g], of_ == Of::differences ? std::conj(b[h]) : b[h]);
            re += x.re * Q->re;
            im += x.im * Q->im;
        }
    return 2.0 * (re - im).head<6>().matrix();
}

Vec6 QuadraticLoad::load(const std::vector<Complex>& phases, double yaw) const {
    if (empty()) return Vec6::Zero();
    for (Spectrum& Z : by_direction_) std::fill(Z.begin(), Z.end(), 0.0);
    for (Spectrum& Z : by_heading_) std::fill(Z.begin(), Z.end(), 0.0);
    std::fill(used_.begin(), used_.end(), 0);
    std::fill(total_.begin(), total_.end(), 0.0);
    for (std::size_t m = 0; m < weights_.size(); ++m) {
        Spectrum& Z = by_direction_[direction_[m]];
        for (std::size_t k = 0; k < 4; ++k)
            Z[weights_[m].index[k]] += weights_[m].weight[k] * phases[m];
    }
    for (std::size_t d = 0; d < directions_.size(); ++d) {
        const Spectrum& Z = by_direction_[d];
        const HeadingWeights w = heading_weights(headings_, full_circle_, directions_[d] - yaw);
        for (std::size_t k = 0; k < 4; ++k) {
            if (w.weight[k] == 0.0) continue;
            const auto h = static_cast<std::size_t>(w.index[k]);
            used_[h] = 1;
            for (std::size_t g = 0; g < n_; ++g) by_heading_[h][g] += w.weight[k] * Z[g];
        }
        for (std::size_t g = 0; g < n_; ++g) total_[g] += Z[g];
    }
    Vec6 force = Vec6::Zero();
    for (const Block& block : blocks_) {
        if (used_[block.first] == 0 || used_[block.second] == 0) continue;
        const Spectrum& a = by_heading_[block.first];
        if (block.first != block.second)
            force += unequal_headings(block, a, by_heading_[block.second]);
        else
            force += equal_headings(block, a, crosses_ ? a : total_);
    }
    return turned_by_yaw(force, yaw);
}

WaveTable<Vec6> QuadraticLoad::diagonal() const {
    WaveTable<Vec6> table;
    table.full_circle = full_circle_;
    std::vector<std::size_t> order(omega_.size());
    for (std::size_t m = 0; m < order.size(); ++m) order[m] = m;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return omega_[a] < omega_[b]; });
    order.erase(std::unique(order.begin(), order.end(),
                            [&](std::size_t a, std::size_t b) { return omega_[a] == omega_[b]; }),
                order.end());
    for (const std::size_t m : order) table.frequencies.push_back(omega_[m]);
    for (std::size_t h = 0; h < headings_.size(); ++h) {
        HeadingData<Vec6>& to = table.headings.emplace_back();
        to.heading = headings_[h];
        for (const std::size_t m : order) {
            Spectrum one(n_, 0.0);
            for (std::size_t k = 0; k < 4; ++k) one[weights_[m].index[k]] += weights_[m].weight[k];
            to.values.push_back(equal_headings(blocks_[h], one, one));
        }
    }
    return table;
}

}  // namespace hawser::master
