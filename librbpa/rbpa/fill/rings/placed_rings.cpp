#include "rbpa/fill/rings/placed_rings.h"
#include "rbpa/base/run/point_text.h"

#include <utility>

#include "rbpa/base/error.h"

namespace rbpa {

std::string text_of(const RingsMeet& meet, std::span<const Point> points, std::span<const Ring> rings,
                    const NodedRings& noded, const RingName& name) {
  const auto at = [&](const RingsMeet::Side& side) { return noded.rings[side.ring].points[side.edge]; };
  const auto vertex = [&](std::size_t ring, std::size_t number) {
    return "vertex " + std::to_string(number) + " " + place_of(points[rings[ring].points[number]]);
  };
  const auto edge = [&](const RingsMeet::Side& side) {
    const std::size_t number = noded.edge_of[side.ring][side.edge];
    return "the edge from " + vertex(side.ring, number) + " to " +
           vertex(side.ring, (number + 1) % rings[side.ring].points.size()) + " of " + name(side.ring);
  };
  switch (meet.how) {
    case RingsMeet::How::edges_cross:
      return edge(meet.first) + " crosses " + edge(meet.second);
    case RingsMeet::How::edges_overlap:
      return edge(meet.first) + " runs along " + edge(meet.second);
    case RingsMeet::How::vertex_on_edge:
      return place_of(points[at(meet.first)]) + " of " + name(meet.first.ring) + " lies on " + edge(meet.second);
    case RingsMeet::How::one_place:
      return name(meet.first.ring) + " passes " + place_of(points[at(meet.first)]) + " twice, on " + edge(meet.first) +
             " and on " + edge(meet.second);
    case RingsMeet::How::cross_at_a_point:
      break;
  }
  return name(meet.first.ring) + " crosses " + name(meet.second.ring) + " at " + place_of(points[at(meet.first)]);
}

std::vector<RingPlace> place_rings(std::span<const Point> points, std::span<const Ring> rings, const NodedRings& noded,
                                   const RingName& name, const GoOn& go_on) {
  NestedRings nested = nest_rings(points, noded.rings, go_on);
  if (nested.meet)
    throw InvalidInput(text_of(*nested.meet, points, rings, noded, name) +
                       "; expected rings that meet in single points at most");
  return std::move(nested.place);
}

}  // namespace rbpa
