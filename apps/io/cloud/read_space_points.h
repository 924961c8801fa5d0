// What: points of space, with normals and colors where the file has them, from a file of any format we read.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/crs.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

struct SpacePoints {
  std::vector<Point3> points = {};                       ///< in the order of the file, all finite
  std::vector<Point3> normals = {};                      ///< none, or one each: finite, of any length but 0
  std::vector<std::array<std::uint8_t, 3>> colors = {};  ///< red, green, blue: none, or one each
  std::vector<std::vector<double>> fields = {};          ///< a column of each that the condition's columns() ask for
  std::vector<std::optional<std::vector<std::string>>> texts = {};  ///< as PointFile::texts
  std::vector<std::uint32_t> index = {};                            ///< as PointFile::index
  std::size_t all_points = 0;                                       ///< as PointFile::all_points
  std::optional<Crs> crs = std::nullopt;                            ///< where the file names one
  UnitCell cell = {};                                               ///< of the atoms of a molecule
  std::vector<std::string> remarks = {};  ///< what was left out or taken so: a sentence each, for people
};

/// The points in the order of the file. `path` "-" is standard input; a gzip file is read as what was compressed. Throws
/// BadInput naming the file, the line or the point (counted from 0), what was found and what was expected, and nothing
/// is allocated for what a header only claims; Failure; Cancelled; WrongUsage when two of the columns are one.
SpacePoints read_space_points(const std::string& path, Format format, const CloudRequest& request = {});

/// The same of the content of a file, which messages call `name`.
SpacePoints space_points_in(std::string_view bytes, const std::string& name, Format format,
                            const CloudRequest& request = {});

}  // namespace rbpa::app
