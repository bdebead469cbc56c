#include "remote_lines.hpp"

#include <chrono>
#include <utility>

#include "message.hpp"

namespace hawser::master {

RemoteLines::RemoteLines(const io::Link& link, std::vector<std::vector<int>> lines_of_rank)
    : link_(link), lines_of_rank_(std::move(lines_of_rank)), counts_(lines_of_rank_.size(), 0) {
    size_t lines = 0;
    for (const auto& mine : lines_of_rank_) lines += mine.size();
    reply_.lines.resize(lines);
    message_.reserve(lines_of_rank_.size() * static_cast<size_t>(status_numbers) +
                     lines * static_cast<size_t>(numbers_per_line(Ask::equilibrium)));
}

void RemoteLines::send(const Order& order) {
    ask_ = order.ask;
    OrderMessage message = pack(order);
    link_.broadcast(message);
}

const Reply& RemoteLines::receive() {
    size_t total = 0;
    for (size_t rank = 1; rank < counts_.size(); ++rank) {
        counts_[rank] = reply_numbers(ask_, static_cast<int>(lines_of_rank_[rank].size()));
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
        for (size_t i = 0; i < lines_of_rank_[rank].size(); ++i)
            reply_.lines[static_cast<size_t>(lines_of_rank_[rank][i])] =
                unpack_line(part, ask_, static_cast<int>(i));
        at += counts_[rank];
    }
    return reply_;
}

}  // namespace hawser::master
