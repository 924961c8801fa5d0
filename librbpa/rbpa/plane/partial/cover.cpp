#include "rbpa/plane/partial/cover.h"
#include "rbpa/base/arrays/sort_unique.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>

namespace rbpa {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Weights at places of a vertical line, in a segment tree that knows the least and the greatest partial sum of the
/// weights, summed from below. The partial sum at a place is the number of regions that cover it.
class Heights {
 public:
  explicit Heights(std::span<const Quadrant> quadrants) {
    for (const Quadrant& quadrant : quadrants) y_.push_back(quadrant.at.y);
    y_.push_back(-unbounded);  // the part below every corner is not covered
    sort_unique(y_);
    leaves_ = std::bit_ceil(y_.size());
    nodes_.resize(2 * leaves_);
    // Leaves after the last place weigh 0, so their partial sums repeat the last one.
  }

  void add(double y, int weight) {
    std::size_t at = leaves_ + place(y);
    const int sum = nodes_[at].sum + weight;
    nodes_[at] = {sum, sum, sum};
    for (at /= 2; at > 0; at /= 2) {
      const Node &low = nodes_[2 * at], &high = nodes_[2 * at + 1];
      nodes_[at] = {low.sum + high.sum, std::min(low.least, low.sum + high.least),
                    std::max(low.most, low.sum + high.most)};
    }
  }
  int least() const { return nodes_[1].least; }
  int most() const { return nodes_[1].most; }

  /// Returns the y of the lowest place for whose partial sum is_meant(sum) is true. Requires: there is such a place.
  template <typename IsMeant>
  double find(IsMeant is_meant) const {
    int sum = 0;
    for (std::size_t i = 0; i < y_.size(); ++i)
      if (is_meant(sum += nodes_[leaves_ + i].sum)) return y_[i];
    return y_.back();
  }

 private:
  struct Node {
    int sum = 0, least = 0, most = 0;  // of the leaves below the node; partial sums begin with the first leaf
  };
  std::size_t place(double y) const {
    return static_cast<std::size_t>(std::lower_bound(y_.begin(), y_.end(), y) - y_.begin());
  }

  std::vector<double> y_;
  std::size_t leaves_;
  std::vector<Node> nodes_;
};

/// Moves a vertical line over the corners from left to right, and stops where is_wrong(least, most) of the partial sums
/// is true. Returns the lowest place on that line for which is_meant(sum) is true; nothing if the line never stops.
template <typename IsWrong, typename IsMeant>
std::optional<Point> sweep(std::span<const Quadrant> quadrants, IsWrong is_wrong, IsMeant is_meant) {
  Heights heights(quadrants);
  for (std::size_t i = 0; i < quadrants.size();) {
    const double x = quadrants[i].at.x;
    for (; i < quadrants.size() && quadrants[i].at.x == x; ++i) heights.add(quadrants[i].at.y, quadrants[i].weight);
    if (is_wrong(heights.least(), heights.most())) return Point{x, heights.find(is_meant)};
  }
  return std::nullopt;
}

}  // namespace

Cover::Cover(const Region& region) {
  if (!(region.x0 < region.x1) || !(region.y0 < region.y1)) return;
  // −0 is written as 0, so that equal covers have equal bytes.
  const auto add = [&](double x, double y, int weight) {
    if (x < unbounded && y < unbounded) quadrants_.push_back({{x + 0.0, y + 0.0}, weight});
  };
  add(region.x0, region.y0, 1);
  add(region.x0, region.y1, -1);
  add(region.x1, region.y0, -1);
  add(region.x1, region.y1, 1);
}

Cover operator+(const Cover& a, const Cover& b) {
  std::vector<Quadrant> sum;
  sum.reserve(a.quadrants_.size() + b.quadrants_.size());
  auto i = a.quadrants_.begin();
  auto j = b.quadrants_.begin();
  while (i != a.quadrants_.end() || j != b.quadrants_.end()) {
    if (j == b.quadrants_.end() || (i != a.quadrants_.end() && i->at < j->at)) {
      sum.push_back(*i++);
    } else if (i == a.quadrants_.end() || j->at < i->at) {
      sum.push_back(*j++);
    } else {
      const int weight = i->weight + j->weight;
      if (weight != 0) sum.push_back({i->at, weight});
      ++i, ++j;
    }
  }
  return Cover(std::move(sum));
}

bool Cover::is_whole() const {
  return quadrants_.size() == 1 && quadrants_[0] == Quadrant{{-unbounded, -unbounded}, 1};
}

std::optional<Point> Cover::wrong() const {
  return sweep(
      quadrants_, [](int least, int most) { return least < 0 || most > 1; },
      [](int sum) { return sum < 0 || sum > 1; });
}

std::optional<Point> Cover::missing() const {
  if (quadrants_.empty() || quadrants_[0].at.x > -unbounded) return Point{-unbounded, -unbounded};
  return sweep(
      quadrants_, [](int least, int) { return least < 1; }, [](int sum) { return sum < 1; });
}

}  // namespace rbpa
