#include "local_lines.hpp"

#include <algorithm>
#include <numeric>

#include "packing.hpp"
#include "rod/at_rest.hpp"
#include "rod/modes.hpp"
#include "roles.hpp"

namespace hawser {

namespace worker {

LocalLines::LocalLines(const Case& input, const std::vector<int>& packs, io::SeriesWriter* results)
    : input_(&input),
      sea_(input.environment, input.analysis.dynamics.ramp, input.analysis.dynamics.depth_filter,
           !input.analysis.statics.current) {
    const std::vector<Pack> all = packs_of(input);
    std::vector<int> lines;
    for (const int p : packs) {
        const Pack& pack = all[static_cast<std::size_t>(p)];
        packs_.emplace_back(input, sea_, pack.lines);
        lines.insert(lines.end(), pack.lines.begin(), pack.lines.end());
    }
    std::sort(lines.begin(), lines.end());
    for (const RodPack<Quad>& pack : packs_) {
        place_.emplace_back();
        for (const int line : pack.lines())
            place_.back().push_back(static_cast<std::size_t>(
                std::lower_bound(lines.begin(), lines.end(), line) - lines.begin()));
    }
    reply_.lines.resize(lines.size());
    samples_ = LineSamples(input, packs_, results);
}

void LocalLines::send(const Order& order) {
    order_ = order;
    if (order.keep_previous)
        for (RodPack<Quad>& pack : packs_) pack.keep();
    if (order.keep_previous || order.sample) samples_.watch(packs_, order.t0);
    if (order.sample) samples_.put_sample(packs_);
    if (order.snapshot) samples_.put_nodes(packs_);
    if (order.write_segment) samples_.put_latest(packs_);
}

const Reply& LocalLines::receive() {
    reply_.status = {};
    const MotionSpline platform(order_.t0, order_.from, order_.t1, order_.to);
    for (std::size_t p = 0; p < packs_.size(); ++p) {
        RodPack<Quad>& pack = packs_[p];
        if (order_.ask == Ask::run_to) take_status(pack.pass(order_.t0, order_.t1, platform));
        if (order_.ask == Ask::equilibrium)
            take_status(pack.equilibrium(order_.to, order_.current));
        if (order_.ask == Ask::impedance) pack.swing(order_.frequency);
        for (int i = 0; i < static_cast<int>(pack.lines().size()); ++i) {
            LineLoad& load = reply_.lines[place_[p][static_cast<std::size_t>(i)]];
            load.wrench = pack.pass_wrench(i);
            load.end_tension = pack.tension_a(i);
            load.mismatch_at = -1;
            load.impulse_mismatch = 0.0;
            for (int c = 0; c < pack.constraint_count(); ++c) {
                const double mismatch = pack.impulse_mismatch(i, c);
                if (load.mismatch_at < 0 || mismatch > load.impulse_mismatch)
                    load.impulse_mismatch = mismatch, load.mismatch_at = c;
            }
            if (order_.ask == Ask::equilibrium || order_.ask == Ask::impedance)
                load.stiffness = pack.stiffness(i, order_.to.position);
        }
    }
    return reply_;
}

std::vector<LineAtRest> LocalLines::at_rest() const {
    std::vector<LineAtRest> out(reply_.lines.size());
    for (std::size_t p = 0; p < packs_.size(); ++p)
        for (std::size_t i = 0; i < place_[p].size(); ++i)
            out[place_[p][i]] = worker::at_rest(packs_[p], static_cast<int>(i), *input_);
    return out;
}

std::vector<RodMode> LocalLines::modes(int line, int count) {
    for (RodPack<Quad>& pack : packs_)
        for (int i = 0; i < static_cast<int>(pack.lines().size()); ++i)
            if (pack.lines()[static_cast<std::size_t>(i)] == line)
                return rod_modes(pack, i, *input_, count);
    return {};
}

void LocalLines::take_status(const Status& status) {
    if (status.ok()) return;
    if (reply_.status.ok() || status.line < reply_.status.line) reply_.status = status;
}

}  // namespace worker

std::unique_ptr<Lines> make_local_lines(const Case& input, const std::vector<int>& packs,
                                        io::SeriesWriter* results) {
    return std::make_unique<worker::LocalLines>(input, packs, results);
}

std::unique_ptr<RestingLines> make_resting_lines(const Case& input) {
    std::vector<int> all(packs_of(input).size());
    std::iota(all.begin(), all.end(), 0);
    return std::make_unique<worker::LocalLines>(input, all, nullptr);
}

}  // namespace hawser
