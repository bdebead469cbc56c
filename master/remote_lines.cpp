#include "remote_lines.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "message.hpp"

namespace hawser::master {

RemoteLines::RemoteLines(const io::Link& link, std::vector<std::vector<int>> lines_of_rank,
                         int platforms, const std::vector<Touched>& touched)
    : link_(link),
      lines_of_rank_(std::move(lines_of_rank)),
      order_numbers_(static_cast<size_t>(order_numbers(platforms))),
      touched_(touched),
      between_(std::any_of(touched.begin(), touched.end(),
                           [](const Touched& line) { return line.two(); })),
      counts_(lines_of_rank_.size(), 0) {
    size_t lines = 0;
    for (const auto& mine : lines_of_rank_) lines += mine.size();
    reply_.lines.resize(lines);
    touched_.resize(lines);
    message_.reserve(lines_of_rank_.size() * static_cast<size_t>(status_numbers) +
                     lines * static_cast<size_t>(numbers_per_line(Ask::equilibrium, between_)));
}

void RemoteLines::send(const Order& order) {
    ask_ = order.ask;
    OrderMessage message = pack(order);
    link_.broadcast(std::span(message).first(order_numbers_));
}

const Reply& RemoteLines::receive() {
    size_t total = 0;
    for (size_t rank = 1; rank < counts_.size(); ++rank) {
        counts_[rank] =
            reply_numbers(ask_, static_cast<int>(lines_of_rank_[rank].size()), between_);
        total += static_cast<size_t>(counts_[rank]);
    }
    message_.resize(total);
    const auto from = std::chrono::steady_clock::now();
    link_.gather({}, counts_, message_);
    waited_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();

    reply_.status = Status{};
    const double* at = message_.data();
    for (size_t rank = 1; rank < counts_.size(); ++rank) {
        const std::span<const double> part(at, static_cast<size_t>(counts_[rank]));
        const Status status = unpack_status(part);
        if (!status.ok() && (reply_.status.ok() || status.line < reply_.status.line))
            reply_.status = status;  // the first in line order, whatever the number of ranks
        for (size_t i = 0; i < lines_of_rank_[rank].size(); ++i) {
            const auto line = static_cast<size_t>(lines_of_rank_[rank][i]);
            LineLoad& load = reply_.lines[line];
            load = unpack_line(part, ask_, static_cast<int>(i), between_);
            load.platform = touched_[line].first;
            load.second.platform = touched_[line].second;
        }
        at += counts_[rank];
    }
    return reply_;
}

}  // namespace hawser::master
