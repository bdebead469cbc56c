// Order and reply as rows of numbers: what MPI_Bcast takes down and MPI_Gatherv brings up. Every
// bit of a double arrives as it was sent.
#pragma once

#include <array>
#include <span>

#include "lines.hpp"

namespace hawser {

/// ask, five flags, t0, t1, the 12 states of P:1 at t0 and at t1, frequency.
inline constexpr int order_numbers = 33;
using OrderMessage = std::array<double, order_numbers>;

[[nodiscard]] OrderMessage pack(const Order& order);
[[nodiscard]] Order unpack(const OrderMessage& message);

/// One status, then per line wrench, end tension and impulse mismatch, and the 36 numbers of the
/// stiffness where the order asks for it.
inline constexpr int status_numbers = 6;
[[nodiscard]] inline bool replies_stiffness(Ask ask) {
    return ask == Ask::equilibrium || ask == Ask::impedance;
}
[[nodiscard]] inline int numbers_per_line(Ask ask) { return replies_stiffness(ask) ? 45 : 9; }
[[nodiscard]] inline int reply_numbers(Ask ask, int lines) {
    return status_numbers + lines * numbers_per_line(ask);
}

/// @param out reply_numbers(ask, number of lines) numbers
void pack_reply_to(const Reply& reply, Ask ask, std::span<double> out);
[[nodiscard]] Status unpack_status(std::span<const double> message);
/// @param line which of the lines in this message
[[nodiscard]] LineLoad unpack_line(std::span<const double> message, Ask ask, int line);

}  // namespace hawser
