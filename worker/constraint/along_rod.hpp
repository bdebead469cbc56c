// The laws that may hold a rod between its ends.
#pragma once

#include <variant>

#include "constraint/guide.hpp"
#include "constraint/slider.hpp"
#include "constraint/tensioner.hpp"

namespace hawser::worker {

template <class V>
using Law = std::variant<Guide<V>, Slider<V>, HeldPoint<V>, Tensioner<V>>;

}  // namespace hawser::worker
