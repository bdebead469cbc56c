// The lines of this process: packs of rods behind the Lines seam (order in, reply out).
#pragma once

#include <vector>

#include "case/case.hpp"
#include "environment/sea.hpp"
#include "line_samples.hpp"
#include "resting_lines.hpp"
#include "rod/rod_group.hpp"

namespace hawser::worker {

class LocalLines final : public RestingLines {
 public:
    /// @param packs  indices into packs_of(input)
    LocalLines(const Case& input, const std::vector<int>& packs, io::SeriesWriter* results);

    void send(const Order& order) override;
    const Reply& receive() override;
    [[nodiscard]] std::vector<LineAtRest> at_rest() const override;
    std::vector<RodMode> modes(int line, int count) override;

    [[nodiscard]] const std::vector<RodPack<Quad>>& packs() const { return packs_; }
    std::vector<RodPack<Quad>>& packs() { return packs_; }

 private:
    void take_status(const Status& status);
    [[nodiscard]] LineLoad load_of(const RodPack<Quad>& pack, int lane) const;

    const Case* input_;
    int platforms_;  ///< that orders tell of
    Sea sea_;
    std::vector<RodPack<Quad>> packs_;
    std::vector<RodGroup<Quad>> groups_;  ///< of packs_, side by side
    LineSamples samples_;
    Order order_;
    /// Where lane i of pack p stands in the reply: ascending line order of this process.
    std::vector<std::vector<std::size_t>> place_;
    Reply reply_;
};

}  // namespace hawser::worker
