// What the lines of this process give to the results: at a sampling time their columns of the
// fields that the case's output asks for; at every platform step ranges and extremes.
#pragma once

#include <utility>
#include <vector>

#include "case/case.hpp"
#include "io/line_fields.hpp"
#include "line_ranges.hpp"
#include "rod/rod_pack.hpp"

namespace hawser::worker {

class LineSamples {
 public:
    LineSamples() = default;
    /// @param results  null: nothing is recorded
    LineSamples(const Case& input, const std::vector<RodPack<Quad>>& packs,
                io::SeriesWriter* results);

    /// The kept state at a platform step: ranges and extremes take it in; the first is the start.
    void watch(const std::vector<RodPack<Quad>>& packs, double t);
    /// Results at ends and places, of touchdown and constraints, for the sample whose time has been
    /// added.
    void put_sample(const std::vector<RodPack<Quad>>& packs);
    /// Positions of all nodes, for the snapshot whose time has been added.
    void put_nodes(const std::vector<RodPack<Quad>>& packs);
    /// Ranges and extremes so far, before a segment is written.
    void put_latest(const std::vector<RodPack<Quad>>& packs);

 private:
    using Rod = std::pair<std::size_t, int>;  ///< pack, lane
    /// A field and the rods that fill it, in the order of the columns provided.
    struct EndChannel {
        int field = -1;
        bool end_a = true;
        io::EndResult result{};
        std::vector<Rod> rods;
    };
    /// A place, and what has been recovered there for the sample at hand.
    struct Place {
        std::size_t pack = 0;
        double arc_length = 0.0;
        RodPlace at;
        Recovered<Single> now;
    };
    /// A field and the places that fill it.
    struct PlaceChannel {
        int field = -1;
        LineQuantity quantity{};
        std::vector<std::size_t> places;  ///< indices into places_
    };
    struct TouchdownChannel {
        int field = -1;
        std::size_t result = 0;       ///< of io::touchdown_results
        std::vector<std::size_t> of;  ///< indices into grounded_
    };
    struct ConstraintChannel {
        int field = -1;
        ConstraintResult result{};
        std::vector<std::pair<Rod, int>> constraints;
    };
    /// A field over all nodes: one of the io::range_statistics of one of the ranges.
    struct RangeField {
        int field = -1;
        std::size_t range = 0, statistic = 0;
    };

    template <class Wanted, class Put>
    void each_rod(const std::vector<RodPack<Quad>>& packs, Wanted&& wanted, Put&& put) const;
    void provide_ends(const std::vector<RodPack<Quad>>& packs);
    void provide_places(const std::vector<RodPack<Quad>>& packs);
    void provide_touchdown(const std::vector<RodPack<Quad>>& packs);
    void provide_constraints(const std::vector<RodPack<Quad>>& packs);
    void provide_nodes(const std::vector<RodPack<Quad>>& packs);
    void provide_latest(const std::vector<RodPack<Quad>>& packs);
    std::size_t place(const std::vector<RodPack<Quad>>& packs, std::size_t p, int lane, double s);
    void put_start(const std::vector<RodPack<Quad>>& packs);

    const Case* input_ = nullptr;
    io::SeriesWriter* results_ = nullptr;
    double from_ = 0.0;  ///< ranges count from here [s]
    bool started_ = false, angles_ = false;
    std::vector<Recovery<Quad>> recoveries_;  ///< one per pack
    std::vector<LineWatch> watches_;
    std::vector<std::vector<QuantityRange>> ranges_;  ///< per pack, in the order of the quantities

    std::vector<EndChannel> ends_;
    std::vector<Place> places_;
    std::vector<PlaceChannel> place_channels_;
    std::vector<TouchdownChannel> touchdowns_;
    std::vector<std::pair<Rod, Grounding>> grounded_;
    std::vector<ConstraintChannel> constraints_;
    std::vector<RangeField> range_fields_;
    std::vector<int> maximum_fields_, extreme_fields_, start_fields_;
    std::vector<std::pair<Rod, int>> mismatch_;
    int slack_field_ = -1, mismatch_field_ = -1, node_field_ = -1;
    std::vector<double> values_;
};

}  // namespace hawser::worker
