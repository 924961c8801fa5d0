// What: points of space as a file has them, and what the file says about them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa::app {

struct SpacePoints {
  std::vector<Point3> points = {};                       ///< in the order of the file, all finite
  std::vector<Point3> normals = {};                      ///< none, or one each: finite, of any length but 0
  std::vector<std::array<std::uint8_t, 3>> colors = {};  ///< red, green, blue: none, or one each
  std::vector<std::string> remarks = {};                 ///< what was left out or taken so: a sentence each, for people
};

}  // namespace rbpa::app
