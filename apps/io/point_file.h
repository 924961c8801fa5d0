// What: points of the plane as a file has them, and what the file says about them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/crs.h"
#include "rbpa/base/point.h"

namespace rbpa::app {

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
  /// A constant is none.
  bool differ() const { return differ_; }

 private:
  std::optional<double> first_ = std::nullopt;
  bool differ_ = false;
};

struct PointFile {
  std::vector<Point> points = {};         ///< in the order of the file, all finite
  std::vector<std::uint32_t> index = {};  ///< of each among all points of the file; none where it is its number here
  std::size_t all_points = 0;             ///< of the file: with those that are left out
  std::optional<Crs> crs = std::nullopt;  ///< where the file names one
  std::vector<std::vector<double>> fields = {};  ///< a column of each that the condition's columns() ask for
  /// Of each column of texts: these, which `fields` has the numbers of, from 0 on. As the name of a group an empty one is none.
  std::vector<std::optional<std::vector<std::string>>> texts = {};
  bool keys_are_texts = false;  ///< some are texts where others may be numbers, whatever they look like
  /// Third coordinates, of each point, where they were asked for and any point has one; NaN where one has none.
  std::vector<double> z = {};
  bool degrees = false;  ///< x is a longitude and y a latitude, as a CRS or the names of columns say
  /// That they have heights, which differ and are left out. Never of LAS, of which footprints are what is wanted.
  Heights heights = {};
  /// What was found by itself and might be meant otherwise, or was left out: a sentence each, for people.
  std::vector<std::string> remarks = {};
};

}  // namespace rbpa::app
