// What: the text of a point, for messages.
#pragma once

#include <string>

#include "rbpa/base/point.h"
#include "rbpa/base/run/input.h"

namespace rbpa {

/// Returns "(1.5, 2)", with the shortest numbers that read back to the coordinates.
inline std::string place_of(const Point& p) {
  std::string place = "(";
  return place.append(text(p.x)).append(", ").append(text(p.y)).append(")");
}

}  // namespace rbpa
