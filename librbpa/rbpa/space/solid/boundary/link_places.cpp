#include "rbpa/space/solid/boundary/link_places.h"

#include "rbpa/space/predicate/orientation.h"

namespace rbpa::space {

bool arcs_cross(std::span<const Point3> points, std::uint32_t center, const LinkTriangle& from, const LinkTriangle& to,
                std::uint32_t p, std::uint32_t q) {
  const auto sign = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    return orientation(points[center], points[i], points[j], points[k]);
  };
  // A direction within (a, b, c) is a + ε b + ε² c. The first term that is not 0 gives the side of the arc's plane. The
  // infinitesimals of `to` are smaller, so that their terms come last.
  const auto side_of_arc = [&](std::uint32_t k) {
    for (const std::uint32_t j : to)
      for (const std::uint32_t i : from)
        if (const int side = sign(i, j, k); side != 0) return side;
    return 0;
  };
  const auto side_of_edge = [&](const LinkTriangle& within) {
    for (const std::uint32_t i : within)
      if (const int side = sign(p, q, i); side != 0) return side;
    return 0;
  };
  const int begin = side_of_edge(from), end = side_of_edge(to);
  if (begin == end) return false;
  const int at_p = side_of_arc(p), at_q = side_of_arc(q);
  // The planes of the arcs meet in two opposite directions. The arcs cross if both pass through one of these
  // directions.
  return at_p != at_q && at_q == -end;
}

}  // namespace rbpa::space
