// What: the target length of edges at each point of the plane.
// Law:  the field is the greatest function of slope at most `grade` that is at most `most` everywhere and at most
//       sources[i].size at sources[i].at.
// Cost: n log n to build; a query takes about log n, plus the sources whose value at the point is close to the least.
#pragma once

#include <cstddef>
#include <vector>

#include "rbpa/fill/filling.h"

namespace rbpa {

class SizeField {
 public:
  SizeField(double most, double grade, std::vector<SizeAt> sources);

  double at(const Point& p) const;

  /// Returns a lower bound of all values: the least of `most` and the sizes of the sources.
  double least() const { return least_; }
  /// Returns an upper bound of all values; grade() returns an upper bound of the slope.
  double most() const { return most_; }
  double grade() const { return grade_; }

 private:
  /// The box and the least size of a range of sources, in a tree whose node k has the children 2 k + 1 and 2 k + 2.
  struct Node {
    double left, right, bottom, top;
    double least;
  };
  void build(std::size_t node, std::size_t first, std::size_t last);
  void search(std::size_t node, std::size_t first, std::size_t last, const Point& p, double& best) const;

  static constexpr std::size_t leaf = 8;
  double most_, grade_, least_;
  std::vector<SizeAt> sources_;
  std::vector<Node> nodes_;
};

}  // namespace rbpa
