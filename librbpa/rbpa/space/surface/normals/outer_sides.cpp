#include "rbpa/space/surface/normals/outer_sides.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/space/surface/normals/compare_normals.h"
#include "rbpa/space/surface/outer_shells.h"
#include "rbpa/space/surface/surface_components.h"

namespace rbpa::space {
namespace {

using Number = std::uint32_t;

// The numbers were chosen on some fifty sets of points with known normals, and tried on others
// (docs/explanation/surfaces.md, section 19).
// Least ratio of a point's projected sum to its area at which the side of the point is known
constexpr double one_sided = 0.35;
constexpr double least_one_sided = 0.5;     // least average of the ratio over a component
constexpr double most_contradicted = 0.05;  // greatest fraction of pairs of neighbors that contradict each other
constexpr double nearly_all = 0.7;          // fraction of the points that counts as nearly all
constexpr double most_opposed = 0.02;       // up to this fraction of opposed points, given normals are kept

/// Returns, for each point, the lowest index among the points that are connected with it through nearest others.
std::vector<Number> components_of(const Neighborhoods& near) {
  meshops::DisjointSets sets(near.points.size());
  for (Number i = 0; i < near.points.size(); ++i)
    for (const Number j : near.around(i)) sets.join(i, j);
  std::vector<Number> component(near.points.size());
  for (Number i = 0; i < component.size(); ++i) component[i] = sets.find(i);
  return component;
}

/// The areas of the triangles at each point that a ball of one radius sees from outside.
struct Seen {
  std::vector<double> along;  ///< twice the sum of the areas of the point's triangles, projected along its normal
  std::vector<double> area;   ///< that sum without projection; 0 if the point is not seen

  int side(std::size_t i) const { return !(std::abs(along[i]) > one_sided * area[i]) ? 0 : along[i] > 0 ? 1 : -1; }
};

Seen look(const Neighborhoods& near, std::span<const Point3> normals, double radius, const SurfaceOptions& options) {
  Seen seen{.along = std::vector<double>(near.points.size()), .area = std::vector<double>(near.points.size())};
  const Surface shells = exposed_triangles(near.points, radius, options);
  const SurfaceComponents components = surface_components(near.points, shells);
  const std::vector<bool> outer = outer_shells(near.points, radius, shells, components);
  for (std::size_t t = 0; t < shells.triangles.size(); ++t) {
    if (!outer[components.number[t]]) continue;
    const auto& corners = shells.triangles[t];
    const Point3 &a = near.points[corners[0]], &b = near.points[corners[1]], &c = near.points[corners[2]];
    const Point3 u = {b.x - a.x, b.y - a.y, b.z - a.z}, v = {c.x - a.x, c.y - a.y, c.z - a.z};
    const Point3 n = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    const double area = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    for (const Number i : corners) {
      seen.along[i] += n.x * normals[i].x + n.y * normals[i].y + n.z * normals[i].z;
      seen.area[i] += area;
    }
  }
  return seen;
}

/// The view of a ball on one component of the graph of nearest points.
struct Verdict {
  // Numbers of points: of all; of points that the ball touches; of touched points whose side is known; of points whose
  // known side is not that of their normal.
  std::size_t points = 0, seen = 0, known = 0, opposed = 0;
  double one_sided = 0;                     // sum of the ratios of the points that the ball touches
  std::size_t pairs = 0, contradicted = 0;  // pairs of neighbors with known sides and hardly tilted planes
  double apart = 0, apart_squared = 0;      // sums, over the contradicted pairs, of the distance between the sides

  /// Returns whether the sides are trusted. The two sides of a sheet as thin as the spacing of points contradict each
  /// other; but the ball sees nearly all points of the sheet, and the sides are equally far apart everywhere. On a
  /// rough sheet, where noise decides from which side a point is seen, the distance of the sides varies: by more than
  /// `most_variation`, its standard deviation divided by its mean.
  bool is_trusted(double most_variation) const {
    const auto share_of = [](double share, std::size_t of) { return share * static_cast<double>(of); };
    if (known == 0 || one_sided <= share_of(least_one_sided, seen)) return false;
    if (static_cast<double>(contradicted) <= share_of(most_contradicted, pairs)) return true;
    return static_cast<double>(seen) >= share_of(nearly_all, points) && apart > 0 &&
           apart_squared * static_cast<double>(contradicted) <= (1 + most_variation * most_variation) * (apart * apart);
  }
  bool contradicts_normals() const { return static_cast<double>(opposed) > most_opposed * static_cast<double>(known); }
};

std::vector<Verdict> judge(const Neighborhoods& near, std::span<const Point3> normals,
                           const std::vector<Number>& component, const Seen& seen) {
  std::vector<Verdict> verdicts(near.points.size());  // each at the lowest index of its component
  for (Number i = 0; i < near.points.size(); ++i) {
    Verdict& verdict = verdicts[component[i]];
    ++verdict.points;
    if (!(seen.area[i] > 0)) continue;
    ++verdict.seen;
    verdict.one_sided += std::abs(seen.along[i]) / seen.area[i];
    const int side = seen.side(i);
    if (side == 0) continue;
    ++verdict.known;
    verdict.opposed += side < 0;
    for (const Number j : near.around(i)) {
      const int other = seen.side(j);
      if (other == 0) continue;
      const Point3 &p = near.points[i], &q = near.points[j], &m = normals[i], &n = normals[j];
      const NormalComparison c = compare_normals<double>(p, m, q, n);
      constexpr double beyond_doubt = 0.7;
      if (std::abs(c.agreement) - c.tilt < beyond_doubt) continue;
      ++verdict.pairs;
      if ((c.agreement > 0) == (side == other)) continue;
      ++verdict.contradicted;
      // The height along both outward normals: a bend of the sheet adds to one and subtracts from the other.
      const Point3 outward = {side * m.x - other * n.x, side * m.y - other * n.y, side * m.z - other * n.z};
      const double apart = ((p.x - q.x) * outward.x + (p.y - q.y) * outward.y + (p.z - q.z) * outward.z) / 2;
      verdict.apart += apart;
      verdict.apart_squared += apart * apart;
    }
  }
  return verdicts;
}

constexpr double first_ball = 8;  // radius of the first ball, in spacings

constexpr double most_variation = 0.33;  // of the thickness: 0.17 to 0.30 on sheets, at least 0.38 on noise

/// Returns whether a ball with a radius of `factor` spacings, on the chosen points alone, contradicts their normals.
bool some_contradict(const Neighborhoods& near, std::span<const Point3> normals, std::vector<Number> chosen,
                     double factor, double variation, const SurfaceOptions& options) {
  std::sort(chosen.begin(), chosen.end(), [&](Number i, Number j) { return near.points[i] < near.points[j]; });
  std::vector<Point3> points;
  for (const Number i : chosen) points.push_back(near.points[i]);
  Threads threads(1);
  const Neighborhoods part = find_nearest<double>(std::move(points), near.count, threads, {});
  std::vector<Point3> of_part(chosen.size());
  for (std::size_t k = 0; k < chosen.size(); ++k) of_part[part.place[k]] = normals[chosen[k]];
  const Seen seen = look(part, of_part, factor * spacing_of(part), options);
  const std::vector<Verdict> verdicts = judge(part, of_part, components_of(part), seen);
  return std::any_of(verdicts.begin(), verdicts.end(),
                     [variation](const Verdict& v) { return v.is_trusted(variation) && v.contradicts_normals(); });
}

/// Returns whether it is worthwhile to compute the sides of all points. A sample over the whole surface finds a wrong
/// side of solids of any thickness. Open terrain, however, has crests and valleys: the sample sees each from one side,
/// a smaller ball sees both sides. The sides of a thin sheet contradict each other in any sample, but are equally far
/// apart only in pieces that contain all points.
bool is_worth_looking(const Neighborhoods& near, std::span<const Point3> normals, const SurfaceOptions& options) {
  constexpr std::size_t share = 8, least = 500, most = 4000, pieces = 3, piece = 1000;    // points
  constexpr double any = std::numeric_limits<double>::infinity(), none = 0, wide = 0.45;  // variation
  const std::size_t size = near.points.size(), count = std::clamp(size / share, least, most);
  if (size <= 2 * least) return true;
  std::vector<Number> sample;  // evenly along the leaves of the tree, and so over the surface
  for (std::size_t k = 0; k < count; ++k) sample.push_back(static_cast<Number>(k * size / count));
  if (!some_contradict(near, normals, sample, first_ball, any, options)) return false;
  if (some_contradict(near, normals, sample, first_ball / 2, none, options)) return true;
  if (size <= pieces * piece) return true;
  for (std::size_t k = 0; k < pieces; ++k) {
    std::vector<Number> leaves(piece);
    std::iota(leaves.begin(), leaves.end(), static_cast<Number>(k * (size - piece) / (pieces - 1)));
    if (some_contradict(near, normals, std::move(leaves), first_ball, wide, options)) return true;
  }
  return false;
}

}  // namespace

OuterSides outer_sides(const Neighborhoods& near, std::span<const Point3> normals, const SurfaceOptions& options) {
  if (near.count == 0 || !is_worth_looking(near, normals, options)) return {};
  const std::vector<Number> component = components_of(near);
  const double spacing = spacing_of(near);
  OuterSides sides = {.side = std::vector<std::int8_t>(near.points.size(), 0),
                      .vote = std::vector<double>(near.points.size(), 0)};
  std::vector<bool> is_seen(near.points.size(), false), is_asked(near.points.size(), true);
  for (const double factor : {first_ball, 5.0, 3.0, 2.0}) {
    const Seen seen = look(near, normals, factor * spacing, options);
    const std::vector<Verdict> verdicts = judge(near, normals, component, seen);
    bool any = false;
    for (std::size_t c = 0; c < verdicts.size(); ++c) {
      is_asked[c] = is_asked[c] && verdicts[c].is_trusted(most_variation) &&
                    (factor < first_ball || verdicts[c].contradicts_normals());
      any = any || is_asked[c];
    }
    if (!any) break;
    for (Number i = 0; i < near.points.size(); ++i) {
      if (!is_asked[component[i]] || is_seen[i] || !(seen.area[i] > 0)) continue;
      is_seen[i] = true;
      sides.side[i] = static_cast<std::int8_t>(seen.side(i));
      if (sides.side[i] != 0) sides.vote[i] = std::min(1.0, std::abs(seen.along[i]) / seen.area[i]);
    }
  }
  return sides;
}

}  // namespace rbpa::space
