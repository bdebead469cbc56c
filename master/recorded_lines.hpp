// Lines beside a result file: the platform's part of what an order asks to be written.
#pragma once

#include "io/series_file.hpp"
#include "lines.hpp"

namespace hawser::master {

/// Passes orders on. Writing is collective: when an order makes the workers write, rank 0 writes
/// too, after the lines have carried out the order's flags and before any pass is waited for.
class RecordedLines final : public Lines {
 public:
    RecordedLines(Lines& lines, io::SeriesWriter& results) : lines_(lines), results_(results) {}
    void send(const Order& order) override {
        ++orders_;
        lines_.send(order);
        if (order.write_segment) results_.write_segment();
    }
    const Reply& receive() override { return lines_.receive(); }
    [[nodiscard]] int orders() const { return orders_; }

 private:
    Lines& lines_;
    io::SeriesWriter& results_;
    int orders_ = 0;
};

/// A platform without lines.
class NoLines final : public Lines {
 public:
    void send(const Order&) override {}
    const Reply& receive() override { return reply_; }

 private:
    Reply reply_;
};

}  // namespace hawser::master
