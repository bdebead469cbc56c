// Order and reply as rows of numbers: what MPI_Bcast takes down and MPI_Gatherv brings up. Every
// bit of a double arrives as it was sent.
#pragma once

#include <array>
#include <span>

#include "lines.hpp"

namespace hawser {

/// ask, five flags, t0, t1, frequency, then per platform the 12 states of P:1 at t0 and at t1. Only
/// the first order_numbers(platforms of the case) are sent.
[[nodiscard]] inline constexpr int order_numbers(int platforms) {
    return 9 + 24 * (platforms > 1 ? platforms : 1);
}
using OrderMessage = std::array<double, static_cast<std::size_t>(order_numbers(most_platforms))>;

[[nodiscard]] OrderMessage pack(const Order& order);
[[nodiscard]] Order unpack(const OrderMessage& message);

/// One status, then per line wrench, end tension and impulse mismatch, and the 36 numbers of the
/// stiffness where the order asks for it. Where a line of the case lies between two platforms,
/// every line's numbers are followed by those of the second: its wrench, and three matrices.
inline constexpr int status_numbers = 6;
[[nodiscard]] inline bool replies_stiffness(Ask ask) {
    return ask == Ask::equilibrium || ask == Ask::impedance;
}
[[nodiscard]] inline int numbers_per_line(Ask ask, bool between = false) {
    return replies_stiffness(ask) ? (between ? 159 : 45) : (between ? 15 : 9);
}
[[nodiscard]] inline int reply_numbers(Ask ask, int lines, bool between = false) {
    return status_numbers + lines * numbers_per_line(ask, between);
}

/// @param out      reply_numbers(ask, number of lines, between) numbers
/// @param between  does a line of the case lie between two platforms?
void pack_reply_to(const Reply& reply, Ask ask, std::span<double> out, bool between = false);
[[nodiscard]] Status unpack_status(std::span<const double> message);
/// Which platforms the line touches is not in the message: both sides know the case.
/// @param line which of the lines in this message
[[nodiscard]] LineLoad unpack_line(std::span<const double> message, Ask ask, int line,
                                   bool between = false);

}  // namespace hawser
