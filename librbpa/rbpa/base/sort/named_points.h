// What: points, each with a number that the caller chose as its name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "rbpa/base/point.h"

namespace rbpa {

struct NamedPoints {
  std::span<const Point> points;
  const std::uint32_t* names = nullptr;  ///< the name of each point; if null, a point's name is its position
  std::uint32_t name(std::size_t i) const { return names ? names[i] : static_cast<std::uint32_t>(i); }
};

}  // namespace rbpa
