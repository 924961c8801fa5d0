#include "rbpa/fill/front/size_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "rbpa/base/run/steps.h"
#include "rbpa/fill/front/triangulate_outline.h"
#include "rbpa/fill/rings/plane_distance.h"

namespace rbpa {
namespace {

constexpr std::size_t pieces_of_all = std::size_t{1} << 17U, pieces_of_each = 64;  // maximum numbers of pieces
constexpr int most_rounds = 400;  // maximum number of rounds of halving: doubles have no finer pieces
constexpr double tolerance = 0.1;

Point between(const Point& a, const Point& b) { return {a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2}; }

/// A triangular part of a polygon.
struct Area {
  static constexpr double per_measure = 2.3094010767585034;  // 4 / √3: a triangle of sides 1 has the area √3 / 4
  static double density(double size) { return 1 / size / size; }

  std::array<Point, 3> corner;

  double measure() const {
    const auto& [a, b, c] = corner;
    return std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
  }
  Point middle() const {
    return {corner[0].x + (corner[1].x - corner[0].x) / 3 + (corner[2].x - corner[0].x) / 3,
            corner[0].y + (corner[1].y - corner[0].y) / 3 + (corner[2].y - corner[0].y) / 3};
  }
  double radius() const {
    const Point at = middle();
    return std::max({distance(at, corner[0]), distance(at, corner[1]), distance(at, corner[2])});
  }
  /// Returns the halves of the triangle, which a cut through the middle of the longest side makes.
  std::array<Area, 2> halves() const {
    std::size_t k = 0;
    for (const std::size_t other : {1U, 2U})
      if (distance(corner[other], corner[(other + 1) % 3]) > distance(corner[k], corner[(k + 1) % 3])) k = other;
    const Point &a = corner[k], &b = corner[(k + 1) % 3], &c = corner[(k + 2) % 3], m = between(a, b);
    return {Area{{a, m, c}}, Area{{m, b, c}}};
  }
};

/// A part of an edge.
struct Stretch {
  static constexpr double per_measure = 1;
  static double density(double size) { return 1 / size; }

  Point a, b;

  double measure() const { return distance(a, b); }
  Point middle() const { return between(a, b); }
  double radius() const { return measure() / 2; }
  std::array<Stretch, 2> halves() const { return {Stretch{a, middle()}, Stretch{middle(), b}}; }
};

/// The integral over one piece: an estimate `value`, a lower bound `least`, and an upper bound `least` + `doubt`.
template <typename Part>
struct Piece {
  Piece(const Part& of, std::size_t piece_of, const SizeField& field) : part(of), whole(piece_of) {
    const double size = field.at(part.middle()), change = field.grade() * part.radius(), measure = part.measure();
    const double low = std::max(size - change, field.least()), high = std::min(size + change, field.most());
    value = Part::per_measure * measure * Part::density(size);
    least = Part::per_measure * measure * Part::density(high);
    doubt = Part::per_measure * measure * Part::density(low) - least;
  }

  Part part;
  std::size_t whole;  // number of the part that contains the piece
  double value, least, doubt;
};

/// Returns the integral over each part; a lower bound if the tolerance would need too many pieces.
template <typename Part>
std::vector<double> integrate(const std::vector<Part>& parts, const SizeField& field, Steps& step) {
  std::vector<Piece<Part>> pieces;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    step();
    pieces.emplace_back(parts[i], i, field);
  }
  const std::size_t most = pieces_of_all + pieces_of_each * parts.size();
  bool is_known = false;
  for (int round = 0; round < most_rounds && pieces.size() < most; ++round) {
    double value = 0, doubt = 0;
    for (const auto& piece : pieces) {
      value += piece.value;
      doubt += piece.doubt;
    }
    is_known = !(doubt > tolerance * value);
    if (is_known) break;
    // The doubts of the pieces that stay whole sum up to at most half of the tolerance.
    const double tolerated = tolerance / 2 * value / static_cast<double>(pieces.size());
    for (std::size_t i = pieces.size(); i-- > 0 && pieces.size() < most;) {
      step();
      if (!(pieces[i].doubt > tolerated)) continue;
      const auto [first, second] = pieces[i].part.halves();
      const std::size_t whole = pieces[i].whole;
      pieces[i] = {first, whole, field};
      pieces.emplace_back(second, whole, field);
    }
  }
  std::vector<double> integrals(parts.size(), 0.0);
  for (const auto& piece : pieces) integrals[piece.whole] += is_known ? piece.value : piece.least;
  return integrals;
}

}  // namespace

double estimate_triangles(std::span<const OutlinePart> groups, const SizeField& field, bool keep_boundary,
                          const GoOn& go_on) {
  Steps step(go_on);
  // All groups are integrated together, so that the limit on pieces applies to their total.
  std::vector<Stretch> stretches;
  std::vector<Area> areas;
  std::vector<std::size_t> group_of_stretch, group_of_area;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Outline& outline = groups[g].outline;
    for (const OutlineRing& ring : outline.rings)
      for (std::size_t i = 0; i < ring.sites.size(); ++i)
        stretches.push_back({outline.places[ring.sites[i]], outline.places[ring.sites[(i + 1) % ring.sites.size()]]});
    for (const auto& [a, b, c] : triangulate(outline, go_on))
      areas.push_back({{outline.places[a], outline.places[b], outline.places[c]}});
    group_of_stretch.resize(stretches.size(), g);
    group_of_area.resize(areas.size(), g);
  }
  std::vector<double> boundary(groups.size(), 0.0), inside(groups.size(), 0.0);
  const std::vector<double> pieces =
      keep_boundary ? std::vector<double>(stretches.size(), 1.0) : integrate(stretches, field, step);
  for (std::size_t i = 0; i < pieces.size(); ++i) boundary[group_of_stretch[i]] += std::max(pieces[i], 1.0);
  const std::vector<double> parts = integrate(areas, field, step);
  for (std::size_t i = 0; i < parts.size(); ++i) inside[group_of_area[i]] += parts[i];
  double triangles = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) triangles += std::max(boundary[g], inside[g]);
  return triangles;
}

}  // namespace rbpa
