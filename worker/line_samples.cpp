#include "line_samples.hpp"

#include <algorithm>
#include <cmath>

#include "io/series_file.hpp"
#include "line_mesh.hpp"
#include "statistics.hpp"

namespace hawser::worker {

namespace {

constexpr double degrees = 180.0 / M_PI;

using Quads = RodPack<Quad>;

double declination(const Vec3& u) { return degrees * std::atan2(std::hypot(u.x(), u.y()), -u.z()); }

/// Result of one rod at one end [N, deg, N.m]; directions are those of increasing arc length.
Vec3 end_result(const Quads& rod, int lane, bool end_a, io::EndResult result) {
    const Vec3 u = end_a ? rod.direction_a(lane) : rod.direction_b(lane);
    switch (result) {
        case io::EndResult::effective_tension:
            return {end_a ? rod.tension_a(lane) : rod.tension_b(lane), 0, 0};
        case io::EndResult::declination:
            return {declination(u), 0, 0};
        case io::EndResult::azimuth:
            return {degrees * std::atan2(u.y(), u.x()), 0, 0};
        case io::EndResult::force:
            return end_a ? rod.force_on_support_a(lane) : rod.force_on_support_b(lane);
        case io::EndResult::moment:
            return end_a ? rod.moment_on_support_a(lane) : rod.moment_on_support_b(lane);
    }
    return Vec3::Zero();
}

bool is_vector(io::EndResult result) {
    return result == io::EndResult::force || result == io::EndResult::moment;
}

double constraint_result(const Quads& rod, int lane, int c, ConstraintResult result) {
    switch (result) {
        case ConstraintResult::force:
        case ConstraintResult::tension:
            return rod.constraint_magnitude(lane, c);
        case ConstraintResult::moment:
            return rod.constraint_moment(lane, c).norm();
        case ConstraintResult::gap:
        case ConstraintResult::stroke:
            return rod.constraint_opening(lane, c);
        case ConstraintResult::slip:
            return rod.constraint_slip(lane, c);
    }
    return 0.0;
}

int line_of(const Quads& pack, int lane) { return pack.lines()[static_cast<std::size_t>(lane)]; }
int lanes_of(const Quads& pack) { return static_cast<int>(pack.lines().size()); }

}  // namespace

template <class Wanted, class Put>
void LineSamples::each_rod(const std::vector<Quads>& packs, Wanted&& wanted, Put&& put) const {
    for (std::size_t p = 0; p < packs.size(); ++p)
        for (int lane = 0; lane < lanes_of(packs[p]); ++lane) {
            const int line = line_of(packs[p], lane);
            if (wanted(input_->lines[static_cast<std::size_t>(line)])) put(p, lane, line);
        }
}

LineSamples::LineSamples(const Case& input, const std::vector<Quads>& packs,
                         io::SeriesWriter* results)
    : input_(&input),
      results_(input.lines.empty() ? nullptr : results),
      from_(input.analysis.dynamics.statistics_from) {
    if (!results_) return;
    for (const Quads& pack : packs) {
        recoveries_.emplace_back(input, pack);
        watches_.emplace_back(pack.elements() + 1);
    }
    provide_ends(packs);
    provide_places(packs);
    provide_touchdown(packs);
    provide_constraints(packs);
    provide_nodes(packs);
    provide_latest(packs);
    std::size_t nodes = 0, constraints = 0;
    for (const Quads& pack : packs) nodes += static_cast<std::size_t>((pack.elements() + 1) * 4);
    for (const Line& line : input.lines) constraints += line.constraints.size();
    values_.reserve(3 * nodes + 3 * input.lines.size() + constraints + places_.size());
}

void LineSamples::provide_ends(const std::vector<Quads>& packs) {
    for (const bool end_a : {true, false}) {
        for (const io::EndResult result : io::end_results) {
            EndChannel channel{.field = results_->find(io::end_path(end_a, result)),
                               .end_a = end_a,
                               .result = result,
                               .rods = {}};
            if (channel.field < 0) continue;
            std::vector<int> columns;
            each_rod(
                packs,
                [&](const Line& line) {
                    return io::is_recorded(input_->output, line.name, end_a, result);
                },
                [&](std::size_t p, int lane, int line) {
                    channel.rods.emplace_back(p, lane);
                    const int width = is_vector(result) ? 3 : 1;
                    for (int k = 0; k < width; ++k) columns.push_back(width * line + k);
                });
            results_->provide(channel.field, columns);
            ends_.push_back(channel);
        }
    }
}

std::size_t LineSamples::place(const std::vector<Quads>& packs, std::size_t p, int lane, double s) {
    for (std::size_t k = 0; k < places_.size(); ++k)
        if (places_[k].pack == p && places_[k].at.lane == lane && places_[k].arc_length == s)
            return k;
    places_.push_back({p, s, recoveries_[p].place(*input_, packs[p], lane, s), {}});
    return places_.size() - 1;
}

void LineSamples::provide_places(const std::vector<Quads>& packs) {
    const std::vector<io::LinePlace> all = io::recorded_places(*input_);
    for (std::size_t n = 0; n < n_line_quantities; ++n) {
        const auto quantity = static_cast<LineQuantity>(n);
        const int field = results_->find(io::place_path(quantity));
        if (field < 0) continue;
        PlaceChannel channel{.field = field, .quantity = quantity, .places = {}};
        std::vector<int> columns;
        each_rod(
            packs, [](const Line&) { return true; },
            [&](std::size_t p, int lane, int line) {
                for (std::size_t k = 0; k < all.size(); ++k) {
                    if (all[k].line != line || !io::is_recorded(*input_, all[k], quantity))
                        continue;
                    channel.places.push_back(place(packs, p, lane, all[k].arc_length));
                    columns.push_back(static_cast<int>(k));
                }
            });
        results_->provide(field, columns);
        place_channels_.push_back(channel);
    }
    for (const bool end_a : {true, false}) {
        for (const LineQuantity quantity : io::further_end_quantities()) {
            const int field = results_->find(io::end_path(end_a, quantity));
            if (field < 0) continue;
            PlaceChannel channel{.field = field, .quantity = quantity, .places = {}};
            std::vector<int> columns;
            each_rod(
                packs,
                [&](const Line& line) {
                    return io::is_recorded(input_->output, line.name, end_a, quantity);
                },
                [&](std::size_t p, int lane, int line) {
                    const double L = input_->lines[static_cast<std::size_t>(line)].length();
                    channel.places.push_back(place(packs, p, lane, end_a ? 0.0 : L));
                    columns.push_back(line);
                });
            results_->provide(field, columns);
            place_channels_.push_back(channel);
        }
    }
}

void LineSamples::provide_touchdown(const std::vector<Quads>& packs) {
    for (std::size_t k = 0; k < io::touchdown_results.size(); ++k) {
        TouchdownChannel channel{
            .field = results_->find(io::touchdown_path(io::touchdown_results[k])),
            .result = k,
            .of = {}};
        if (channel.field < 0) continue;
        std::vector<int> columns;
        each_rod(
            packs,
            [&](const Line& line) {
                return io::is_touchdown_recorded(input_->output, line.name,
                                                 io::touchdown_results[k]);
            },
            [&](std::size_t p, int lane, int line) {
                std::size_t i = 0;
                while (i < grounded_.size() && grounded_[i].first != Rod(p, lane)) ++i;
                if (i == grounded_.size()) grounded_.push_back({{p, lane}, {}});
                channel.of.push_back(i);
                columns.push_back(line);
            });
        results_->provide(channel.field, columns);
        touchdowns_.push_back(channel);
    }
}

void LineSamples::provide_constraints(const std::vector<Quads>& packs) {
    const std::vector<io::ConstraintOfLine> all = io::constraints_of(*input_);
    std::vector<int> columns;
    const auto provide = [&](int field, auto&& wanted, std::vector<std::pair<Rod, int>>& to) {
        columns.clear();
        each_rod(
            packs, [](const Line&) { return true; },
            [&](std::size_t p, int lane, int line) {
                for (std::size_t k = 0; k < all.size(); ++k) {
                    if (all[k].line != line || !wanted(all[k])) continue;
                    to.push_back({{p, lane}, all[k].index});
                    columns.push_back(static_cast<int>(k));
                }
            });
        results_->provide(field, columns);
    };
    for (const ConstraintResult result : io::constraint_results) {
        ConstraintChannel channel{.field = results_->find(io::constraint_path(result)),
                                  .result = result,
                                  .constraints = {}};
        if (channel.field < 0) continue;
        provide(
            channel.field,
            [&](const io::ConstraintOfLine& c) { return io::is_recorded(*input_, c, result); },
            channel.constraints);
        constraints_.push_back(channel);
    }
    mismatch_field_ = results_->find(std::string(io::mismatch_path));
    if (mismatch_field_ >= 0)
        provide(
            mismatch_field_, [](const io::ConstraintOfLine&) { return true; }, mismatch_);
}

void LineSamples::provide_nodes(const std::vector<Quads>& packs) {
    std::vector<int> first(1, 0);
    for (const Line& line : input_->lines)
        first.push_back(first.back() + mesh_of(line).elements() + 1);
    const auto provide = [&](int field, int width) {
        std::vector<int> columns;
        for (const Quads& pack : packs)
            for (const int line : pack.lines())
                for (int c = width * first[static_cast<std::size_t>(line)];
                     c < width * first[static_cast<std::size_t>(line) + 1]; ++c)
                    columns.push_back(c);
        results_->provide(field, columns);
    };
    node_field_ = results_->find("/lines/nodes/position");
    if (node_field_ >= 0) provide(node_field_, 3);

    const std::vector<LineQuantity> quantities = io::range_quantities(*input_);
    for (std::size_t p = 0; p < packs.size(); ++p) {
        ranges_.emplace_back();
        for (const LineQuantity q : quantities) ranges_[p].emplace_back(q, packs[p].elements() + 1);
    }
    for (std::size_t k = 0; k < quantities.size(); ++k) {
        angles_ = angles_ || quantities[k] == LineQuantity::declination ||
                  quantities[k] == LineQuantity::azimuth;
        for (std::size_t s = 0; s < io::range_statistics.size(); ++s) {
            const int field =
                results_->find(io::range_path(quantities[k], io::range_statistics[s]));
            provide(field, 1);
            range_fields_.push_back({.field = field, .range = k, .statistic = s});
        }
    }
}

void LineSamples::provide_latest(const std::vector<Quads>& packs) {
    const auto provide = [&](int field, int width) {
        std::vector<int> columns;
        for (const Quads& pack : packs)
            for (const int line : pack.lines())
                for (int k = 0; k < width; ++k) columns.push_back(width * line + k);
        results_->provide(field, columns);
        return field;
    };
    const auto find = [&](const std::string& path) { return results_->find(path); };
    for (const LineQuantity q : io::range_quantities(*input_))
        maximum_fields_.push_back(provide(find(io::range_path(q, "time_of_maximum")), 1));
    for (const std::string_view name : io::line_extremes)
        extreme_fields_.push_back(provide(find(io::extreme_path(name)), 3));
    slack_field_ = provide(find(io::extreme_path("slack")), 3);
    for (const std::string_view name : io::start_results)
        start_fields_.push_back(provide(find(io::start_path(name)), 1));
}

void LineSamples::watch(const std::vector<Quads>& packs, double t) {
    if (!results_) return;
    for (std::size_t p = 0; p < packs.size(); ++p) {
        recoveries_[p].recover(packs[p], angles_);
        watches_[p].add(recoveries_[p], t);
        if (!counts(t, from_)) continue;
        for (QuantityRange& range : ranges_[p]) range.add(recoveries_[p], t);
    }
    if (!started_) put_start(packs);
    started_ = true;
}

void LineSamples::put_start(const std::vector<Quads>& packs) {
    for (std::size_t k = 0; k < start_fields_.size(); ++k) {
        values_.clear();
        each_rod(
            packs, [](const Line&) { return true; },
            [&](std::size_t p, int lane, int) {
                const Quads& rod = packs[p];
                switch (k) {  // in the order of io::start_results
                    case 0:
                        return values_.push_back(rod.tension_b(lane));
                    case 1:
                        return values_.push_back(declination(rod.direction_a(lane)));
                    case 2:
                        return values_.push_back(declination(rod.direction_b(lane)));
                    case 3:
                        return values_.push_back(recoveries_[p].grounding(rod, lane).grounded);
                    default:
                        return values_.push_back(recoveries_[p].grounding(rod, lane).touchdown);
                }
            });
        results_->put(start_fields_[k], values_);
    }
}

void LineSamples::put_sample(const std::vector<Quads>& packs) {
    for (const EndChannel& channel : ends_) {
        values_.clear();
        for (const auto& [p, lane] : channel.rods) {
            const Vec3 value = end_result(packs[p], lane, channel.end_a, channel.result);
            values_.push_back(value.x());
            if (is_vector(channel.result))
                values_.push_back(value.y()), values_.push_back(value.z());
        }
        results_->put(channel.field, values_);
    }
    for (Place& place : places_)
        place.now = recoveries_[place.pack].at(packs[place.pack], place.at);
    for (const PlaceChannel& channel : place_channels_) {
        values_.clear();
        for (const std::size_t k : channel.places)
            values_.push_back(places_[k].now[index_of(channel.quantity)][0]);
        results_->put(channel.field, values_);
    }
    for (auto& [rod, bed] : grounded_)
        bed = recoveries_[rod.first].grounding(packs[rod.first], rod.second);
    for (const TouchdownChannel& channel : touchdowns_) {
        values_.clear();
        for (const std::size_t k : channel.of) {
            const Grounding& bed = grounded_[k].second;
            values_.push_back(channel.result == 0
                                  ? bed.touchdown
                                  : bed.position[static_cast<Eigen::Index>(channel.result) - 1]);
        }
        results_->put(channel.field, values_);
    }
    for (const ConstraintChannel& channel : constraints_) {
        values_.clear();
        for (const auto& [rod, c] : channel.constraints)
            values_.push_back(constraint_result(packs[rod.first], rod.second, c, channel.result));
        results_->put(channel.field, values_);
    }
}

void LineSamples::put_nodes(const std::vector<Quads>& packs) {
    if (node_field_ < 0) return;
    values_.clear();
    for (const Quads& pack : packs) {
        for (int lane = 0; lane < lanes_of(pack); ++lane) {
            for (int n = 0; n <= pack.elements(); ++n) {
                const Vec3 x = pack.node_position(lane, n);
                values_.push_back(x.x()), values_.push_back(x.y()), values_.push_back(x.z());
            }
        }
    }
    results_->put(node_field_, values_);
}

void LineSamples::put_latest(const std::vector<Quads>& packs) {
    if (!results_) return;
    const auto wanted = [&](const Quads& pack, int lane, LineQuantity q) {
        const auto line = static_cast<std::size_t>(line_of(pack, lane));
        return io::is_in_range(input_->output, input_->lines[line].name, q);
    };
    for (const RangeField& field : range_fields_) {
        values_.clear();
        for (std::size_t p = 0; p < packs.size(); ++p) {
            const QuantityRange& range = ranges_[p][field.range];
            for (int lane = 0; lane < lanes_of(packs[p]); ++lane) {
                const bool asked = wanted(packs[p], lane, range.quantity());
                for (int n = 0; n <= packs[p].elements(); ++n)
                    values_.push_back(asked ? range.value(field.statistic, lane, n) : NAN);
            }
        }
        results_->put(field.field, values_);
    }
    const auto per_line = [&](int field, auto&& value) {
        values_.clear();
        for (std::size_t p = 0; p < packs.size(); ++p)
            for (int lane = 0; lane < lanes_of(packs[p]); ++lane) value(p, lane);
        results_->put(field, values_);
    };
    for (std::size_t k = 0; k < maximum_fields_.size(); ++k)
        per_line(maximum_fields_[k], [&](std::size_t p, int lane) {
            const QuantityRange& range = ranges_[p][k];
            values_.push_back(wanted(packs[p], lane, range.quantity()) ? range.time_of_maximum(lane)
                                                                       : NAN);
        });
    for (std::size_t k = 0; k < extreme_fields_.size(); ++k)
        per_line(extreme_fields_[k], [&](std::size_t p, int lane) {
            const auto [value, node, time] = watches_[p].extreme(k, lane);
            const std::vector<double>& arc = packs[p].arc_length(lane);  // from end B
            const double s =
                std::isnan(node)
                    ? NAN
                    : arc.back() - arc[arc.size() - 1 - static_cast<std::size_t>(node)];
            values_.insert(values_.end(), {value, s, time});
        });
    per_line(slack_field_, [&](std::size_t p, int lane) {
        const std::array<double, 3> slack = watches_[p].slack(lane);
        values_.insert(values_.end(), slack.begin(), slack.end());
    });
    if (mismatch_field_ < 0) return;
    values_.clear();
    for (const auto& [rod, c] : mismatch_)
        values_.push_back(packs[rod.first].impulse_mismatch(rod.second, c));
    results_->put(mismatch_field_, values_);
}

}  // namespace hawser::worker
