#include "rbpa/space/repair/closing/mesh_around.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/space/predicate/orientation.h"

namespace rbpa::space {
namespace {

Corners corners_of(const Rim& rim, const RimTriangle& t) {
  return {rim.points[t[0]], rim.points[t[1]], rim.points[t[2]]};
}

std::vector<Box> boxes_of(std::span<const Point3> points, std::span<const SimpleLoop> loops) {
  std::vector<Box> boxes(loops.size());
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (const LoopCorner& corner : loops[l].corners) boxes[l].include(points[corner.in]);
  return boxes;
}

/// Returns the triangles that have an area and whose boxes meet the box of a loop.
std::vector<Corners> near(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
                          const BoxTree& loops, meshops::Steps& step) {
  std::vector<Corners> result;
  for (const auto& [a, b, c] : triangles) {
    step();
    const Corners t = {points[a], points[b], points[c]};
    bool is_near = false;
    loops.for_each_meeting(box_of(t), [&](std::uint32_t) {
      is_near = true;
      step();
    });
    if (is_near && !are_collinear(t[0], t[1], t[2])) result.push_back(t);
  }
  return result;
}

std::vector<Box> boxes_of(std::span<const Corners> triangles) {
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const Corners& t : triangles) boxes.push_back(box_of(t));
  return boxes;
}

std::vector<Point3> places_of(std::span<const Point3> points, std::span<const SimpleLoop> loops) {
  std::vector<Point3> places;
  for (const SimpleLoop& loop : loops)
    for (const LoopCorner& corner : loop.corners) places.push_back(points[corner.in]);
  sort_unique(places);
  return places;
}

bool is_side(const Chord& chord, std::size_t size) {
  return chord.second == chord.first + 1 || (chord.first == 0 && chord.second + 1 == size);
}

/// Returns the one of two crossing triangles that is to be forbidden: the one of larger area.
const RimTriangle& worse(const Rim& rim, const RimTriangle& s, const RimTriangle& t) {
  const auto square = [&](const RimTriangle& of) {
    const Vector n = cross(rim.places[of[1]] - rim.places[of[0]], rim.places[of[2]] - rim.places[of[0]]);
    return dot(n, n);
  };
  const double of_s = square(s), of_t = square(t);
  return of_s != of_t ? (of_s > of_t ? s : t) : std::max(s, t);
}

}  // namespace

MeshAround::MeshAround(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
                       std::span<const SimpleLoop> loops, meshops::Steps& step)
    : loops_(loops),
      places_(places_of(points, loops)),
      joined_(places_.size()),
      corners_at_(loops.size()),
      loop_tree_(boxes_of(points, loops), step),
      added_(loops.size()) {
  triangles_ = near(points, triangles, loop_tree_, step);
  triangle_tree_ = BoxTree(boxes_of(triangles_), step);
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (const LoopCorner& corner : loops[l].corners) corners_at_[l].push_back(*place_of(points[corner.in]));

  std::vector<std::uint32_t> place(points.size(), 0);  // for each vertex, its place, counted from 1, or 0
  for (std::size_t v = 0; v < points.size(); ++v) {
    step(2);
    if (const auto found = place_of(points[v])) place[v] = *found + 1;
  }
  for (const auto& t : triangles) {
    step();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = place[t[k]], to = place[t[(k + 1) % 3]];
      if (from == 0 || to == 0) continue;
      joined_[from - 1].push_back(to - 1);
      joined_[to - 1].push_back(from - 1);
    }
  }
  for (auto& others : joined_) sort_unique(others);
}

std::optional<std::uint32_t> MeshAround::place_of(const Point3& p) const {
  const auto found = std::lower_bound(places_.begin(), places_.end(), p);
  if (found == places_.end() || *found != p) return std::nullopt;
  return static_cast<std::uint32_t>(found - places_.begin());
}

std::vector<Chord> MeshAround::taken_chords(const SimpleLoop& loop) const {
  const std::vector<std::uint32_t>& corners = corners_at_[static_cast<std::size_t>(&loop - loops_.data())];
  std::vector<std::pair<std::uint32_t, std::uint32_t>> at;  // pairs of a place and the loop's corner at it
  for (std::uint32_t i = 0; i < corners.size(); ++i) at.emplace_back(corners[i], i);
  std::sort(at.begin(), at.end());
  std::vector<Chord> taken;
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    const std::vector<std::uint32_t>& joined = joined_[corners[i]];
    const auto take = [&](std::uint32_t other) {
      if (other >= i && !is_side({i, other}, corners.size())) taken.emplace_back(i, other);
    };
    if (joined.size() > at.size()) {  // there are many triangles at this point
      for (const auto& [place, other] : at)
        if (std::binary_search(joined.begin(), joined.end(), place)) take(other);
      continue;
    }
    for (const std::uint32_t place : joined) {
      const auto found = std::lower_bound(at.begin(), at.end(), std::pair{place, std::uint32_t{0}});
      if (found != at.end() && found->first == place) take(found->second);
    }
  }
  sort_unique(taken);
  return taken;
}

Faults MeshAround::faults(std::uint32_t number, const Rim& rim, std::span<const RimTriangle> filling,
                          Work& work) const {
  Faults faults;
  const std::vector<std::uint32_t>& corners = corners_at_[number];
  const auto check = [&](const RimTriangle& t, const Corners& own, const Corners& other) {
    if (!triangles_cross(own, other)) return;
    bool found = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Chord chord = std::minmax(t[k], t[(k + 1) % 3]);
      if (is_side(chord, rim.size()) || !segment_crosses(own[k], own[(k + 1) % 3], other)) continue;
      faults.crossing.push_back(chord);
      found = true;
    }
    if (!found) faults.triangles.push_back(t);
  };
  std::vector<Corners> own;
  for (const RimTriangle& t : filling) {
    own.push_back(corners_of(rim, t));
    for (std::size_t k = 0; k < 3; ++k) {
      const Chord chord = std::minmax(t[k], t[(k + 1) % 3]);
      const auto& joined = joined_[corners[chord.first]];
      if (!is_side(chord, rim.size()) && std::binary_search(joined.begin(), joined.end(), corners[chord.second]))
        faults.taken.push_back(chord);
    }
    const Box box = box_of(own.back());
    triangle_tree_.for_each_meeting(box, [&](std::uint32_t i) {
      work();
      check(t, own.back(), triangles_[i]);
    });
    loop_tree_.for_each_meeting(box, [&](std::uint32_t l) {
      work(added_[l].size() / 8 + 1);
      for (const Corners& other : added_[l]) {
        if (!box_of(other).meets(box)) continue;
        work();
        check(t, own.back(), other);
      }
    });
  }
  const std::vector<Box> boxes = boxes_of(own);
  const BoxTree tree(boxes, work.steps());
  for (std::uint32_t i = 0; i < filling.size(); ++i)
    tree.for_each_meeting(boxes[i], [&](std::uint32_t j) {
      work();
      if (j > i && triangles_cross(own[i], own[j])) faults.triangles.push_back(worse(rim, filling[i], filling[j]));
    });
  sort_unique(faults.taken);
  sort_unique(faults.crossing);
  sort_unique(faults.triangles);
  return faults;
}

void MeshAround::add(std::uint32_t number, const Rim& rim, std::span<const RimTriangle> filling) {
  const std::vector<std::uint32_t>& corners = corners_at_[number];
  const auto join = [&](std::uint32_t place, std::uint32_t other) {
    auto& joined = joined_[place];
    joined.insert(std::lower_bound(joined.begin(), joined.end(), other), other);
  };
  for (const RimTriangle& t : filling) {
    added_[number].push_back(corners_of(rim, t));
    for (std::size_t k = 0; k < 3; ++k) {
      const Chord chord = std::minmax(t[k], t[(k + 1) % 3]);
      if (is_side(chord, rim.size())) continue;  // the mesh joins them already
      join(corners[chord.first], corners[chord.second]);
      join(corners[chord.second], corners[chord.first]);
    }
  }
}

}  // namespace rbpa::space
