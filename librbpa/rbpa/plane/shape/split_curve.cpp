#include "rbpa/plane/shape/split_curve.h"

namespace rbpa {

Ring CurveSplitter::take(std::size_t first) {
  const auto begin = walked_.begin() + static_cast<std::ptrdiff_t>(first);
  Ring ring{{begin, walked_.end()}};
  walked_.erase(begin, walked_.end());
  for (const std::uint32_t p : ring.points) place_[p] = nowhere;
  return ring;
}

void CurveSplitter::split(std::span<const std::uint32_t> curve, std::vector<Ring>& rings) {
  for (const std::uint32_t p : curve) {
    if (place_[p] != nowhere) rings.push_back(take(place_[p]));
    place_[p] = static_cast<std::uint32_t>(walked_.size());
    walked_.push_back(p);
  }
  rings.push_back(take(0));
}

}  // namespace rbpa
