// The six motions by name, in their order.
#pragma once

#include <array>

namespace hawser {

inline constexpr std::array<const char*, 6> motion_names = {"surge", "sway",  "heave",
                                                            "roll",  "pitch", "yaw"};

}  // namespace hawser
