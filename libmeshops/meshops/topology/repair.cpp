#include "meshops/topology/repair.h"

#include <algorithm>
#include <array>

#include "meshops/topology/soup_sides.h"

namespace meshops {
namespace {

using detail::FaceFault;
using detail::fits;
using detail::SoupSide;
using detail::SoupSides;
using Edge = std::span<const SoupSide>;

class Repairer {
 public:
  explicit Repairer(const PolygonSoup& given) : given_(given) {}

  Repair operator()() {
    take_faces();
    orient();
    // Points are still those that were given.
    const SoupSides oriented = sides();
    part_fans(oriented);
    find_cuts(oriented);
    find_splits();
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

  /// Reverses the fewer faces of each piece.
  void orient() {
    PolygonSoup& soup = result_.soup;
    auto pieces = detail::pieces_of(soup, sides(), [](Edge) {});
    std::vector<std::array<std::size_t, 2>> count(soup.faces(), {0, 0});
    for (std::uint32_t f = 0; f < soup.faces(); ++f) {
      const std::uint32_t root = pieces.find(f);
      ++count[root][pieces.is_odd(f) ? 1 : 0];
    }
    for (std::uint32_t f = 0; f < soup.faces(); ++f) {
      const auto& [even, odd] = count[pieces.find(f)];
      if (pieces.is_odd(f) == (odd > even)) continue;
      const auto face = soup.face(f);
      step(RepairKind::face_reversed, {face.begin(), face.end()}, {result_.face_was[f]});
      // The first corner stays the first.
      std::reverse(soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.begin[f]) + 1,
                   soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.begin[f + 1]));
    }
  }

  std::uint32_t copy_of(std::uint32_t p) {
    result_.stands_on.push_back(result_.stands_on[p]);
    return static_cast<std::uint32_t>(result_.soup.points++);
  }

  /// Gives every fan but the first a point of its own. Faces are joined where exactly two fit together. All edges fit
  /// then: sides that are not joined and still name the same two points are the ends of one fan at either, so that they
  /// are two, and run in opposite directions as the faces of the fan agree.
  void part_fans(const SoupSides& all) {
    PolygonSoup& soup = result_.soup;
    auto fans = detail::fans_of(soup, all, fits);
    std::vector<bool> taken(soup.points, false);
    std::vector<std::uint32_t> point_of(soup.corners.size());
    for (std::uint32_t c = 0; c < soup.corners.size(); ++c) {
      const std::uint32_t p = soup.corners[c], root = fans.find(c);
      if (root != c) {
        point_of[c] = point_of[root];
      } else {
        point_of[c] = taken[p] ? copy_of(p) : p;
        taken[p] = true;
      }
    }
    soup.corners = std::move(point_of);
  }

  /// The edges at which faces had the same two points, and have them no more.
  void find_cuts(const SoupSides& oriented) {
    const auto ends = [&](const SoupSide& side) {
      return std::pair(result_.soup.corners[oriented.corner_at_low(side)],
                       result_.soup.corners[oriented.corner_at_high(side)]);
    };
    for (std::size_t e = 0; e < oriented.edges(); ++e) {
      const Edge edge = oriented.edge(e);
      if (std::all_of(edge.begin(), edge.end(), [&](const SoupSide& s) { return ends(s) == ends(edge[0]); })) continue;
      std::vector<std::size_t> faces;
      for (const SoupSide& side : edge) faces.push_back(result_.face_was[side.face]);
      step(RepairKind::edge_cut, {edge[0].low, edge[0].high}, std::move(faces));
    }
  }

  void find_splits() {
    std::vector<bool> split(given_.points, false);
    for (std::size_t p = given_.points; p < result_.soup.points; ++p) split[result_.stands_on[p]] = true;
    for (std::uint32_t p = 0; p < given_.points; ++p)
      if (split[p]) step(RepairKind::point_split, {p}, {});
  }

  const PolygonSoup& given_;
  Repair result_;
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
