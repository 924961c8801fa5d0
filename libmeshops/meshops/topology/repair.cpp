#include "meshops/topology/repair.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "meshops/topology/soup_defects.h"
#include "meshops/topology/soup_sides.h"

namespace meshops {
namespace {

using detail::FaceFault;
using detail::fits;
using detail::SoupSide;
using detail::SoupSides;
using SoupEdge = std::span<const SoupSide>;

class Repairer {
 public:
  Repairer(const PolygonSoup& given, bool keeps_walls, const GoOn& go_on)
      : given_(given), keeps_walls_(keeps_walls), go_on_(go_on), step_(go_on) {}

  Repair operator()() {
    take_faces();
    SoupSides oriented(result_.soup, go_on_);
    if (orient(oriented)) oriented = SoupSides(result_.soup, go_on_);
    // `oriented` still names the given points after split_fans(), which gives new points to further fans.
    split_fans(oriented);
    find_cuts(oriented);
    find_splits();
    std::stable_sort(result_.steps.begin(), result_.steps.end(), [this](const RepairStep& a, const RepairStep& b) {
      step_();
      return a.kind < b.kind;
    });
    return std::move(result_);
  }

  /// Returns whether the two sides of each wall are apart in the result. They may not be if a face of a wall was
  /// reversed, or if the surfaces on both sides are joined elsewhere.
  bool separates_walls(const Repair& result) const {
    return twin_.empty() || (!reverses_wall_ && find_defects(result.soup, go_on_).empty());
  }

 private:
  void did(RepairKind kind, std::vector<std::uint32_t> points, std::vector<std::size_t> faces) {
    result_.steps.push_back({kind, std::move(points), std::move(faces)});
  }

  /// Copies the faces that are neither degenerate, duplicate nor out of range, without corners that equal the corner
  /// before. Reports the other faces and the dropped corners.
  void take_faces() {
    require_parted(given_);
    PolygonSoup cleaned;
    cleaned.points = given_.points;
    for (PolygonSoup* soup : {&cleaned, &result_.soup}) {
      soup->corners.reserve(given_.corners.size());
      soup->begin.reserve(given_.begin.size());
    }
    std::vector<std::uint32_t> cycle;
    for (std::size_t f = 0; f < given_.faces(); ++f) {
      const auto face = given_.face(f);
      step_(1 + face.size());
      cycle.clear();
      for (const std::uint32_t corner : face)
        if (cycle.empty() || cycle.back() != corner) cycle.push_back(corner);
      while (cycle.size() > 1 && cycle.front() == cycle.back()) cycle.pop_back();
      cleaned.add_face(cycle);
    }
    detail::FaceFaults faults = detail::find_face_faults(cleaned, go_on_);
    if (keeps_walls_) detail::keep_walls(cleaned, faults, go_on_);
    result_.soup.points = given_.points;
    result_.steps.reserve(faults.of.size() -
                          static_cast<std::size_t>(std::count(faults.of.begin(), faults.of.end(), FaceFault::none)));
    result_.stands_on.resize(given_.points);
    std::iota(result_.stands_on.begin(), result_.stands_on.end(), 0U);
    for (std::size_t f = 0; f < given_.faces(); ++f) {
      const auto face = given_.face(f);
      step_(1 + face.size());
      if (faults.of[f] != FaceFault::none) {
        did(RepairKind::face_dropped, {face.begin(), face.end()}, {f});
        continue;
      }
      for (std::size_t i = 0; i < face.size(); ++i)
        if (face[i] == face[i + 1 < face.size() ? i + 1 : 0]) did(RepairKind::corner_dropped, {face[i]}, {f});
      result_.soup.add_face(cleaned.face(f));
      result_.face_was.push_back(f);
    }
    if (faults.twin.empty()) return;
    std::vector<std::uint32_t> number(given_.faces(), detail::FaceFaults::none);
    for (std::uint32_t f = 0; f < result_.face_was.size(); ++f) number[result_.face_was[f]] = f;
    for (const std::size_t was : result_.face_was)
      twin_.push_back(faults.twin[was] == detail::FaceFaults::none ? faults.twin[was] : number[faults.twin[was]]);
  }

  /// Reverses in each piece the smaller of its two sets of faces that agree. Returns: whether any face was reversed.
  bool orient(const SoupSides& sides) {
    PolygonSoup& soup = result_.soup;
    auto pieces = detail::pieces_of(
        soup, sides, [](SoupEdge) {}, go_on_);
    for_each_pair_at_walls(sides,
                           [&](const SoupSide& a, const SoupSide& b) { pieces.unite(a.face(), b.face(), false); });
    std::vector<std::array<std::size_t, 2>> count(soup.faces(), {0, 0});
    for (std::uint32_t f = 0; f < soup.faces(); ++f) {
      step_();
      const std::uint32_t root = pieces.find(f);
      ++count[root][pieces.is_odd(f) ? 1 : 0];
    }
    bool any = false;
    for (std::uint32_t f = 0; f < soup.faces(); ++f) {
      step_();
      const auto& [even, odd] = count[pieces.find(f)];
      if (pieces.is_odd(f) == (odd > even)) continue;
      any = true;
      reverses_wall_ = reverses_wall_ || (!twin_.empty() && twin_[f] != detail::FaceFaults::none);
      const auto face = soup.face(f);
      did(RepairKind::face_reversed, {face.begin(), face.end()}, {result_.face_was[f]});
      // The first corner of the face stays the first.
      std::reverse(soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.begin[f]) + 1,
                   soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.begin[f + 1]));
    }
    return any;
  }

  /// Calls pair(side, side) for the sides that belong to one surface at edges of walls.
  template <typename Pair>
  void for_each_pair_at_walls(const SoupSides& sides, Pair pair) {
    for (std::size_t e = 0; !twin_.empty() && e < sides.edges(); ++e) {
      step_();
      if (const auto pairs = detail::sides_of_wall(sides.edge(e), twin_))
        for (const auto& [a, b] : *pairs) pair(a, b);
    }
  }

  std::uint32_t copy_of(std::uint32_t p) {
    result_.stands_on.push_back(result_.stands_on[p]);
    return static_cast<std::uint32_t>(result_.soup.points++);
  }

  /// Gives every fan but the first on a point its own point. Faces are joined only at edges where exactly two faces fit
  /// together. Afterwards, the faces at every edge fit together: if unjoined sides still have the same two points, they
  /// are the ends of one fan at each of the points, and run in opposite directions, because the faces of a fan agree.
  void split_fans(const SoupSides& all) {
    PolygonSoup& soup = result_.soup;
    auto fans = detail::fans_of(soup, all, fits, go_on_);
    for_each_pair_at_walls(all, [&](const SoupSide& a, const SoupSide& b) {
      fans.unite(a.corner_at_low(), b.corner_at_low());
      fans.unite(a.corner_at_high(), b.corner_at_high());
    });
    std::vector<bool> taken(soup.points, false);
    std::vector<std::uint32_t> point_of(soup.corners.size());
    for (std::uint32_t c = 0; c < soup.corners.size(); ++c) {
      step_();
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

  /// Reports the edges at which faces shared two points in the given soup, but no longer do.
  void find_cuts(const SoupSides& oriented) {
    const auto ends = [&](const SoupSide& side) {
      return std::pair(result_.soup.corners[side.corner_at_low()], result_.soup.corners[side.corner_at_high()]);
    };
    for (std::size_t e = 0; e < oriented.edges(); ++e) {
      const SoupEdge edge = oriented.edge(e);
      step_(edge.size());
      if (std::all_of(edge.begin(), edge.end(), [&](const SoupSide& s) { return ends(s) == ends(edge[0]); })) continue;
      std::vector<std::size_t> faces;
      for (const SoupSide& side : edge) faces.push_back(result_.face_was[side.face()]);
      did(RepairKind::edge_cut, {edge[0].low, edge[0].high}, std::move(faces));
    }
  }

  void find_splits() {
    std::vector<bool> split(given_.points, false);
    for (std::size_t p = given_.points; p < result_.soup.points; ++p) split[result_.stands_on[p]] = true;
    for (std::uint32_t p = 0; p < given_.points; ++p)
      if (split[p]) did(RepairKind::point_split, {p}, {});
  }

  const PolygonSoup& given_;
  const bool keeps_walls_;
  const GoOn& go_on_;
  Steps step_;
  std::vector<std::uint32_t> twin_;  // FaceFaults::twin, for the faces of result_.soup
  bool reverses_wall_ = false;
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

Repair repair(const PolygonSoup& soup, const GoOn& go_on) {
  Repairer repairer(soup, true, go_on);
  Repair result = repairer();
  return repairer.separates_walls(result) ? std::move(result) : Repairer(soup, false, go_on)();
}

}  // namespace meshops
