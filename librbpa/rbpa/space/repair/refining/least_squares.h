// What: solves a sparse system of linear equations between places by least squares.
// Cost: about n^1.5 for n places on a surface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

class LeastSquares {
 public:
  explicit LeastSquares(std::size_t places) : places_(places) {}

  /// Begins another equation: the terms added next sum up to `known`.
  void add_equation(const Vector3<double>& known) { known_.push_back(known); }
  /// Adds the term factor · place to the last equation.
  void add(std::uint32_t place, double factor) {
    entries_.push_back({static_cast<std::uint32_t>(known_.size()) - 1, place, factor});
  }

  /// Returns the places; nothing if the equations do not determine them.
  std::optional<std::vector<Vector3<double>>> solution() const;

 private:
  struct Entry {
    std::uint32_t row, column;
    double factor;
  };

  std::size_t places_;
  std::vector<Entry> entries_;
  std::vector<Vector3<double>> known_;
};

}  // namespace rbpa::space
