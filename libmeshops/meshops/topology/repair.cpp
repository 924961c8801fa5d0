#include "meshops/topology/repair.h"

#include <algorithm>
#include <array>
#include <map>

#include "meshops/topology/soup_sides.h"

namespace meshops {
namespace {

using detail::FaceFault;
using detail::SoupSide;
using detail::SoupSides;
using Edge = std::span<const SoupSide>;

/// Faces that fit together at an edge: one, or two that run along it in opposite directions.
bool fits(Edge edge) { return edge.size() == 1 || (edge.size() == 2 && edge[0].ascending != edge[1].ascending); }

class Repairer {
 public:
  explicit Repairer(const PolygonSoup& given) : given_(given) {}

  Repair operator()() {
    take_faces();
    orient();
    for (bool changed = true; changed;) changed = part_fans() || detach_faces();
    for (std::uint32_t p = 0; p < given_.points; ++p)
      if (is_split(p)) step(RepairKind::point_split, {p}, {});
    std::stable_sort(result_.steps.begin(), result_.steps.end(),
                     [](const RepairStep& a, const RepairStep& b) { return a.kind < b.kind; });
    return std::move(result_);
  }

 private:
  void step(RepairKind kind, std::vector<std::uint32_t> points, std::vector<std::size_t> faces) {
    result_.steps.push_back({kind, std::move(points), std::move(faces)});
  }

  /// The faces worth keeping: without points named twice in a row, not degenerate, each once.
  void take_faces() {
    PolygonSoup cleaned;
    cleaned.points = given_.points;
    std::vector<std::uint32_t> cycle;
    for (std::size_t f = 0; f < given_.faces(); ++f) {
      const auto face = given_.face(f);
      cycle.clear();
      for (const std::uint32_t corner : face)
        if (cycle.empty() || cycle.back() != corner) cycle.push_back(corner);
      while (cycle.size() > 1 && cycle.front() == cycle.back()) cycle.pop_back();
      cleaned.add_face(cycle);
    }
    const detail::FaceFaults faults = detail::find_face_faults(cleaned);
    result_.soup.points = given_.points;
    for (std::uint32_t p = 0; p < given_.points; ++p) result_.stands_on.push_back(p);
    for (std::size_t f = 0; f < given_.faces(); ++f) {
      const auto face = given_.face(f);
      if (faults.of[f] != FaceFault::none) {
        step(RepairKind::face_dropped, {face.begin(), face.end()}, {f});
        continue;
      }
      for (std::size_t i = 0; i < face.size(); ++i)
        if (face[i] == face[i + 1 < face.size() ? i + 1 : 0]) step(RepairKind::corner_dropped, {face[i]}, {f});
      result_.soup.add_face(cleaned.face(f));
      result_.face_was.push_back(f);
    }
  }

  /// Sides of the soup as it is now: its faces are all without fault.
  SoupSides sides() const {
    detail::FaceFaults none;
    none.of.resize(result_.soup.faces(), FaceFault::none);
    return {result_.soup, none};
  }

  /// Reverses the fewer faces of each piece, and says which edges are cut.
  void orient() {
    const SoupSides all = sides();
    PolygonSoup& soup = result_.soup;
    auto pieces = detail::pieces_of(soup, all, [](Edge) {});
    std::vector<std::array<std::size_t, 2>> count(soup.faces(), {0, 0});
    for (std::uint32_t f = 0; f < soup.faces(); ++f) {
      const std::uint32_t root = pieces.find(f);
      ++count[root][pieces.is_odd(f) ? 1 : 0];
    }
    std::vector<bool> reversed(soup.faces(), false);
    for (std::uint32_t f = 0; f < soup.faces(); ++f) {
      const auto& [even, odd] = count[pieces.find(f)];
      if (pieces.is_odd(f) != (odd > even)) {
        reversed[f] = true;
        step(RepairKind::face_reversed, given_corners(f), {result_.face_was[f]});
      }
    }
    for (std::size_t e = 0; e < all.edges(); ++e) {
      const Edge edge = all.edge(e);
      if (edge.size() == 1) continue;
      if (edge.size() == 2 &&
          (edge[0].ascending != reversed[edge[0].face]) != (edge[1].ascending != reversed[edge[1].face]))
        continue;
      std::vector<std::size_t> faces;
      for (const SoupSide& side : edge) faces.push_back(result_.face_was[side.face]);
      step(RepairKind::edge_cut, {edge[0].low, edge[0].high}, std::move(faces));
    }
    for (std::size_t f = 0; f < soup.faces(); ++f)
      if (reversed[f])
        std::reverse(soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.begin[f]),
                     soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.begin[f + 1]));
  }

  std::vector<std::uint32_t> given_corners(std::size_t f) const {
    const auto face = result_.soup.face(f);
    return {face.begin(), face.end()};
  }

  std::uint32_t copy_of(std::uint32_t p) {
    result_.stands_on.push_back(result_.stands_on[p]);
    return static_cast<std::uint32_t>(result_.soup.points++);
  }

  /// Gives every fan but the first a point of its own. Faces are joined where exactly two fit together.
  bool part_fans() {
    PolygonSoup& soup = result_.soup;
    auto fans = detail::fans_of(soup, sides(), fits);
    std::vector<bool> taken(soup.points, false);
    std::vector<std::uint32_t> point_of(soup.corners.size());
    bool changed = false;
    for (std::uint32_t c = 0; c < soup.corners.size(); ++c) {
      const std::uint32_t p = soup.corners[c], root = fans.find(c);
      if (root != c) {
        point_of[c] = point_of[root];
      } else if (!taken[p]) {
        taken[p] = true;
        point_of[c] = p;
      } else {
        point_of[c] = copy_of(p);
        changed = true;
      }
    }
    soup.corners = std::move(point_of);
    return changed;
  }

  /// Where faces that do not fit still name one edge, because they hang together around both of its ends some other
  /// way, all but the first get points of their own for the ends.
  bool detach_faces() {
    const SoupSides all = sides();
    std::vector<std::uint32_t> corners;
    for (std::size_t e = 0; e < all.edges(); ++e)
      if (const Edge edge = all.edge(e); !fits(edge))
        for (const SoupSide& side : edge.subspan(1)) {
          corners.push_back(all.corner_at_low(side));
          corners.push_back(all.corner_at_high(side));
        }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    for (const std::uint32_t c : corners) result_.soup.corners[c] = copy_of(result_.soup.corners[c]);
    return !corners.empty();
  }

  bool is_split(std::uint32_t p) {
    if (copies_.empty()) {
      copies_.resize(given_.points, 0);
      for (const std::uint32_t q : result_.stands_on) ++copies_[q];
    }
    return copies_[p] > 1;
  }

  const PolygonSoup& given_;
  Repair result_;
  std::vector<std::uint32_t> copies_;
};

}  // namespace

std::string_view name(RepairKind kind) {
  static constexpr std::array<std::string_view, 5> names = {"corner dropped", "face dropped", "face reversed",
                                                            "edge cut", "point split"};
  return names[static_cast<std::size_t>(kind)];
}

std::string describe(const RepairStep& step) {
  std::string text(name(step.kind));
  const auto append = [&](const char* word, const auto& numbers, bool first) {
    if (numbers.empty()) return;
    text += first ? ": " : ", ";
    text += word;
    if (numbers.size() > 1) text += 's';
    for (const auto number : numbers) text += ' ' + std::to_string(number);
  };
  append("point", step.points, true);
  append("face", step.faces, step.points.empty());
  return text;
}

Repair repair(const PolygonSoup& soup) { return Repairer(soup)(); }

}  // namespace meshops
