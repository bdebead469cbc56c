#include "local_lines.hpp"

#include <algorithm>
#include <numeric>

#include "message.hpp"
#include "packing.hpp"
#include "rod/at_rest.hpp"
#include "rod/modes.hpp"
#include "roles.hpp"

namespace hawser {

namespace worker {

LocalLines::LocalLines(const Case& input, const std::vector<int>& packs, io::SeriesWriter* results)
    : input_(&input),
      platforms_(std::max(1, input.platform_count())),
      sea_(input.environment, input.analysis.dynamics.ramp, input.analysis.dynamics.depth_filter,
           !input.analysis.statics.current) {
    const std::vector<Pack> all = packs_of(input);
    std::vector<int> lines;
    std::vector<std::size_t> size;  // of each group
    packs_.reserve(packs.size());   // the groups refer to them
    for (std::size_t k = 0; k < packs.size(); ++k) {
        const Pack& pack = all[static_cast<std::size_t>(packs[k])];
        packs_.emplace_back(input, sea_, pack.lines);
        lines.insert(lines.end(), pack.lines.begin(), pack.lines.end());
        if (k == 0 || pack.group != all[static_cast<std::size_t>(packs[k - 1])].group)
            size.push_back(0);
        ++size.back();
    }
    std::size_t first = 0;
    for (const std::size_t n : size) {
        groups_.emplace_back(std::span(packs_).subspan(first, n));
        first += n;
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
    PerPlatform<MotionSpline> platforms;
    for (std::size_t k = 0; k < static_cast<std::size_t>(platforms_); ++k)
        platforms[k] = MotionSpline(order_.t0, order_.from[k], order_.t1, order_.to[k]);
    std::size_t p = 0;
    for (RodGroup<Quad>& group : groups_) {
        const Touched& touched = group.packs().front().touched();
        const auto first = static_cast<std::size_t>(touched.first),
                   second = static_cast<std::size_t>(touched.two() ? touched.second : 0);
        if (touched.two() && order_.ask == Ask::run_to) group.follow_second(platforms[second]);
        if (order_.ask == Ask::run_to)
            take_status(group.pass(order_.t0, order_.t1, platforms[first]));
        if (order_.ask == Ask::equilibrium) {
            if (touched.two()) group.hold_second(order_.to[second]);
            take_status(group.equilibrium(order_.to[first], order_.current));
        }
        if (order_.ask == Ask::impedance) group.swing(order_.frequency);
        for (std::size_t k = 0; k < group.packs().size(); ++k, ++p) {
            for (int i = 0; i < static_cast<int>(place_[p].size()); ++i) {
                LineLoad& load = reply_.lines[place_[p][static_cast<std::size_t>(i)]];
                load = load_of(packs_[p], i);
                if (!replies_stiffness(order_.ask)) continue;
                if (!touched.two()) {
                    load.stiffness = group.stiffness(k, i, order_.to[first].position);
                    continue;
                }
                const Mat12 S = group.stiffness_between(k, i, order_.to[first].position,
                                                        order_.to[second].position);
                load.stiffness = S.topLeftCorner<6, 6>();
                load.second.on_first = S.topRightCorner<6, 6>();
                load.second.of_first = S.bottomLeftCorner<6, 6>();
                load.second.stiffness = S.bottomRightCorner<6, 6>();
            }
        }
    }
    return reply_;
}

LineLoad LocalLines::load_of(const RodPack<Quad>& pack, int lane) const {
    LineLoad load{.platform = pack.touched().first,
                  .wrench = pack.pass_wrench(lane),
                  .end_tension = pack.tension_a(lane)};
    if (pack.touched().two()) {
        load.second.platform = pack.touched().second;
        load.second.wrench = pack.pass_wrench(lane, 1);
    }
    const Line& line =
        input_->lines[static_cast<std::size_t>(pack.lines()[static_cast<std::size_t>(lane)])];
    for (int c = 0; c < pack.constraint_count(); ++c) {
        if (line.constraints[static_cast<std::size_t>(c)].other_line >= 0) continue;
        const double mismatch = pack.impulse_mismatch(lane, c);
        if (load.mismatch_at < 0 || mismatch > load.impulse_mismatch)
            load.impulse_mismatch = mismatch, load.mismatch_at = c;
    }
    return load;
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
