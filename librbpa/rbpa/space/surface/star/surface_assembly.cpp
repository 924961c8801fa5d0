#include "rbpa/space/surface/star/surface_assembly.h"

#include <string>

#include "rbpa/base/error.h"

namespace rbpa::space {
void SurfaceAssembly::finish(std::size_t input_points, Threads& threads, std::vector<Triple>& triangles,
                             std::vector<Triple>& neighbors) const {
  const std::span<const std::uint32_t> index = cells_.input_index();
  std::vector<std::uint32_t> start(input_points + 1, 0);
  for_each_index(threads, parts_.size(), [&](std::size_t number) {
    const Part& part = parts_[number];
    for (Site v = first_in(number); v < end_of(number); ++v) {
      const std::size_t i = v - first_in(number);
      start[index[v] + 1] = part.owned_first[i + 1] - part.owned_first[i];
    }
  });
  std::size_t count = 0;
  for (std::uint32_t& at : start) {
    count += at;
    at = static_cast<std::uint32_t>(count);
  }
  if (count >= none)
    throw InvalidInput(std::to_string(count) + " triangles, expected fewer than " + std::to_string(none));

  const auto owned_by = [&](Site v) {
    const Part& part = parts_[v / part_size];
    const std::size_t i = v % part_size;
    return std::span<const Owned>(part.owned.data() + part.owned_first[i], part.owned.data() + part.owned_first[i + 1]);
  };
  const auto number_of = [&](Site a, Site b, Site c) {
    while (!(index[a] < index[b] && index[a] < index[c])) {
      const Site first = a;
      a = b, b = c, c = first;
    }
    const std::span<const Owned> owned = owned_by(a);
    for (std::size_t i = 0; i < owned.size(); ++i)
      if (owned[i].x == b && owned[i].y == c) return start[index[a]] + static_cast<std::uint32_t>(i);
    return none;
  };
  // Returns the site z that follows x in the cycle: the ball at v rolls about x from (v, x, y) to (v, z, x).
  const auto after = [&](Site v, Site x, Site y) {
    const Part& part = parts_[v / part_size];
    const Site* at = part.points.data() + part.first[v % part_size];
    while (true) {
      const Site* const cycle = at;
      const Site* found = nullptr;
      for (Site before = Rings::end_of_cycle; *at != Rings::end_of_cycle; before = *at++)
        if (*at == x && before == y) found = at;
      if (*cycle == x && at[-1] == y) found = cycle;
      if (found != nullptr) return found + 1 == at ? *cycle : found[1];
      ++at;
    }
  };

  triangles.resize(count);
  neighbors.resize(count);
  for_each_index(threads, parts_.size(), [&](std::size_t number) {
    for (Site v = first_in(number); v < end_of(number); ++v) {
      std::uint32_t t = start[index[v]];
      for (const auto& [x, y, before_y, after_x] : owned_by(v)) {
        triangles[t] = {index[v], index[x], index[y]};
        neighbors[t] = {number_of(x, after(x, y, v), y), number_of(v, y, before_y), number_of(v, after_x, x)};
        ++t;
      }
    }
  });
}

}  // namespace rbpa::space
