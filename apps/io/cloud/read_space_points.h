// What: reads points in space, with normals and colors if the file has them, from a file of any supported format.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/cloud/cloud.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

struct SpacePoints : PointFacts {
  std::vector<Point3> points = {};   ///< in the order of the file, all finite
  std::vector<Point3> normals = {};  ///< none, or one for each point: finite, of any length but 0, if needed
  std::vector<std::array<std::uint8_t, 3>> colors = {};  ///< red, green, blue: none, or one for each point
  UnitCell cell = {};                                    ///< the cell of the atoms of a molecule
};

/// Reads the points in the order of the file. `path` "-" is standard input; a gzip file is decompressed. Allocates no
/// memory for points that a header claims and the file does not have. Throws BadInput that names the file, the line or
/// the point (counted from 0), what was found and what was expected; Failure; Cancelled; WrongUsage if two of the
/// columns are the same.
SpacePoints read_space_points(const std::string& path, Format format, const CloudRequest& request = {});

/// Reads points from `bytes`, the content of a file; messages call the file `name`. Throws as read_space_points().
SpacePoints space_points_in(std::string_view bytes, const std::string& name, Format format,
                            const CloudRequest& request = {});

}  // namespace rbpa::app
