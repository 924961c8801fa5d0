// What: the points of a file in the plane, and the facts that a file states about its points.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/crs.h"
#include "io/point_columns.h"
#include "rbpa/base/point.h"

namespace rbpa::app {

/// A record of third coordinates that shows whether any two of them differ.
class Heights {
 public:
  void take(double z) {
    if (!first_) first_ = z;
    differ_ = differ_ || z != *first_;
  }
  void take(const Heights& others) {
    if (others.first_) take(*others.first_);
    differ_ = differ_ || others.differ_;
  }
  /// Returns whether there are at least two different heights.
  bool differ() const { return differ_; }

 private:
  std::optional<double> first_ = std::nullopt;
  bool differ_ = false;
};

/// Facts that the header of a laser scan states.
struct ScanFacts {
  unsigned minor = 0;       ///< the version of LAS is 1.minor
  unsigned format = 0;      ///< format of point records
  unsigned compressor = 0;  ///< version of LASzip's compressor; 0: the points are not compressed
  bool is_copc = false;
  std::array<double, 3> scale = {}, offset = {};
  /// Numbers of points by class and by return, if they were requested; else 0.
  std::array<std::size_t, 256> classes = {};
  std::array<std::size_t, 16> returns = {};
};

/// Facts about the points that were read from a file, in the plane or in space.
struct PointFacts {
  std::vector<std::uint32_t> index =
      {};                      ///< number of each point among all of the file, from 0; empty if points[i] has index i
  std::size_t all_points = 0;  ///< number of points of the file, including those that are left out
  std::optional<Crs> crs = std::nullopt;         ///< the coordinate system; absent if the file names none
  std::vector<PointColumn> kept = {};            ///< kept fields, in the order of the file, with a value for each point
  std::optional<ScanFacts> scan = std::nullopt;  ///< absent unless the format is LAS or LAZ
  std::vector<std::vector<double>> fields =
      {};  ///< a column for each of Condition::columns(), with a value for each point
  /// For each column of `fields` that holds texts: the distinct texts, which the numbers in `fields` index from 0. An
  /// empty text is not the name of a group.
  std::vector<std::optional<std::vector<std::string>>> texts = {};
  /// Warnings, each one sentence: about guesses that may be wrong, and about data that are left out.
  std::vector<std::string> warnings = {};
};

/// A line, or the ring of a polygon, as a range of points.
struct PointLine {
  std::size_t begin, end;
  bool is_closed;
};

/// The points of a file in the plane, in memory.
struct PointFile : PointFacts {
  std::vector<Point> points = {};  ///< in the order of the file, all finite
  /// For each key of groups whether some of its values are texts in the file, so that all count as texts; may be
  /// shorter.
  std::vector<bool> keys_are_texts = {};
  /// Third coordinates, one for each point, NaN if it has none; empty unless they were requested and any point has one.
  std::vector<double> z = {};
  std::string height_name = "z";  ///< name of the column of third coordinates
  bool degrees = false;           ///< x is a longitude and y a latitude, as a CRS or the names of columns say
  /// Third coordinates that are ignored, for a warning if they differ. Not set for LAS, whose users expect footprints.
  Heights heights = {};
  /// The lines and rings whose vertices are points, in the order of the file. Unspecified if --where leaves points out.
  std::vector<PointLine> lines = {};
};

}  // namespace rbpa::app
