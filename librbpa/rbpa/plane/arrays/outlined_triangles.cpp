#include "rbpa/plane/arrays/outlined_triangles.h"

#include <algorithm>
#include <iterator>

namespace rbpa {

using meshops::Patch;
using meshops::Site;

void OutlinedTriangles::prepare(const Patch& patch, Place& place) const {
  place.open.clear();
  place.outer.clear();
  for (std::size_t t = 0; t < patch.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      if (patch.across[t][i] >= 0) [[likely]]
        continue;
      const Site from = patch.triangles[t][i], to = patch.triangles[t][(i + 1) % 3];
      if (patch.across[t][i] == Patch::open)
        place.open.push_back({from, to});
      else
        place.outer.push_back({names_[from], names_[to]});
    }
}

void OutlinedTriangles::place(const Patch& patch, Place& place) {
  list_.place(patch, place.of_list);
  outer_.insert(outer_.end(), place.outer.begin(), place.outer.end());
  for (const auto& [from, to] : place.open) {
    const Site begin = from;
    if (const auto beyond = seams_.take(to, [&](const Open& other) { return other.to == begin; })) {
      rim_[beyond->number] = closed;
    } else {
      seams_.add(from, {to, rim_.size()});
      rim_.push_back({names_[from], names_[to]});
    }
  }
}

std::vector<OutlinedTriangles::Side> OutlinedTriangles::boundary() const {
  std::vector<Side> sides = outer_;
  std::copy_if(rim_.begin(), rim_.end(), std::back_inserter(sides), [](const Side& side) { return side != closed; });
  std::sort(sides.begin(), sides.end());
  return sides;
}

}  // namespace rbpa
