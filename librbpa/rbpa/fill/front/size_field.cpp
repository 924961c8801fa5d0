#include "rbpa/fill/front/size_field.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace rbpa {

SizeField::SizeField(double most, double grade, std::vector<SizeAt> sources)
    : most_(most), grade_(grade), least_(most), sources_(std::move(sources)) {
  std::erase_if(sources_, [&](const SizeAt& source) { return source.size >= most; });
  if (!sources_.empty()) build(0, 0, sources_.size());
  for (const SizeAt& source : sources_) least_ = std::min(least_, source.size);
}

void SizeField::build(std::size_t node, std::size_t first, std::size_t last) {
  if (nodes_.size() <= node) nodes_.resize(node + 1);
  Node box{sources_[first].at.x, sources_[first].at.x, sources_[first].at.y, sources_[first].at.y, most_};
  for (std::size_t i = first; i < last; ++i) {
    const auto& [at, size] = sources_[i];
    box = {std::min(box.left, at.x), std::max(box.right, at.x), std::min(box.bottom, at.y), std::max(box.top, at.y),
           std::min(box.least, size)};
  }
  nodes_[node] = box;
  if (last - first <= leaf) return;
  const bool by_x = box.right - box.left > box.top - box.bottom;
  const std::size_t middle = first + (last - first) / 2;
  const auto begin = sources_.begin();
  // The order is total, so that the position of a source in the tree does not depend on the order of the input.
  std::nth_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(middle),
                   begin + static_cast<std::ptrdiff_t>(last), [&](const SizeAt& a, const SizeAt& b) {
                     return by_x ? std::tie(a.at.x, a.at.y, a.size) < std::tie(b.at.x, b.at.y, b.size)
                                 : std::tie(a.at.y, a.at.x, a.size) < std::tie(b.at.y, b.at.x, b.size);
                   });
  build(2 * node + 1, first, middle);
  build(2 * node + 2, middle, last);
}

double SizeField::at(const Point& p) const {
  double best = most_;
  if (!sources_.empty()) search(0, 0, sources_.size(), p, best);
  return best;
}

void SizeField::search(std::size_t node, std::size_t first, std::size_t last, const Point& p, double& best) const {
  const Node& box = nodes_[node];
  const double dx = std::max({box.left - p.x, p.x - box.right, 0.0});
  const double dy = std::max({box.bottom - p.y, p.y - box.top, 0.0});
  if (box.least + grade_ * std::sqrt(dx * dx + dy * dy) >= best) return;
  if (last - first <= leaf) {
    for (std::size_t i = first; i < last; ++i) {
      const double x = sources_[i].at.x - p.x, y = sources_[i].at.y - p.y;
      best = std::min(best, sources_[i].size + grade_ * std::sqrt(x * x + y * y));
    }
    return;
  }
  const std::size_t middle = first + (last - first) / 2;
  // The half on the side of p is searched first, as its result often excludes the other half.
  const Node& low = nodes_[2 * node + 1];
  const bool by_x = box.right - box.left > box.top - box.bottom;
  if (by_x ? p.x <= low.right : p.y <= low.top) {
    search(2 * node + 1, first, middle, p, best);
    search(2 * node + 2, middle, last, p, best);
  } else {
    search(2 * node + 2, middle, last, p, best);
    search(2 * node + 1, first, middle, p, best);
  }
}

}  // namespace rbpa
