// What: computes the rounded-up circumradii of many tetrahedra, which threads share.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/run/checkpoint_of_threads.h"
#include "rbpa/space/predicate/circumradius.h"

namespace rbpa::space {

/// Returns the radius of each simplex. Requires: as circumradii_rounded_up(). Throws: Cancelled.
inline std::vector<double> circumradii_of(std::span<const Point3> points,
                                          std::span<const std::array<std::uint32_t, 4>> simplices, Threads& threads,
                                          const GoOn& go_on) {
  constexpr std::size_t at_a_time = 1u << 12;
  std::vector<double> radii(simplices.size());
  CheckpointOfThreads checkpoint(go_on);
  for_each_part(threads, radii.size(), at_a_time, [&](std::size_t begin, std::size_t end) {
    checkpoint();
    circumradii_rounded_up(points, simplices.subspan(begin, end - begin), std::span(radii).subspan(begin, end - begin));
  });
  return radii;
}

}  // namespace rbpa::space
