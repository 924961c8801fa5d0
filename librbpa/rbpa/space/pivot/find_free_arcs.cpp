#include "rbpa/space/pivot/find_free_arcs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "rbpa/space/pivot/roll_about_edge.h"
#include "rbpa/space/search/cells.h"
#include "rbpa/space/search/scale.h"

namespace rbpa::space {
namespace {

template <typename Real>
class Finder {
 public:
  Finder(std::span<const Point3> points, double radius) : points_(points), radius_(radius), cells_(points, radius) {}

  std::vector<FreeArc> run() {
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
      around_.clear();
      cells_.for_each_around(cell, [&](std::size_t i) {
        const auto sites = cells_.points_in(i);
        around_.insert(around_.end(), sites.begin(), sites.end());
      });
      for (const Site a : cells_.points_in(cell)) find_at(a);
    }
    return std::move(arcs_);
  }

 private:
  struct Near {
    Real distance;  // squared, rounded
    Site site;
  };

  /// The arcs of the edges from a to greater sites.
  void find_at(Site a) {
    // Rounded outward, and by more than the roundings of a distance.
    const Real farthest = 4 * Real(radius_) * Real(radius_) * (1 + Real(0x1p-40));
    near_.clear();
    for (const Site p : around_) {
      if (p == a) continue;
      const Vector3<Real> d = from<Real>(points_[a], points_[p]);
      const Real distance = dot(d, d);
      if (!(distance > farthest)) near_.push_back({distance, p});
    }
    std::sort(near_.begin(), near_.end(), [](const Near& p, const Near& q) {
      return p.distance != q.distance ? p.distance < q.distance : p.site < q.site;
    });
    places_.clear();
    for (const Near& p : near_) places_.push_back(points_[p.site]);
    for (std::size_t b = 0; b < near_.size(); ++b)
      if (near_[b].site > a)
        EdgeRoll<Real>(points_[a], b, radius_, places_).for_each_free_arc([&](std::size_t left, std::size_t touched) {
          arcs_.push_back({a, near_[b].site, near_[left].site, near_[touched].site});
        });
  }

  std::span<const Point3> points_;
  double radius_;
  Cells cells_;
  std::vector<FreeArc> arcs_;
  std::vector<Site> around_;    // of the cells around one
  std::vector<Near> near_;      // what a ball at one site can touch or hold, nearest first
  std::vector<Point3> places_;  // theirs
};

}  // namespace

std::vector<FreeArc> find_free_arcs(std::span<const Point3> points, double radius) {
  const std::optional<int> exponent = scale_to_double(points, radius);
  if (!exponent) return Finder<long double>(points, radius).run();
  if (*exponent == 0) return Finder<double>(points, radius).run();
  std::vector<Point3> scaled;
  scaled.reserve(points.size());
  for (const Point3& p : points)
    scaled.push_back({std::ldexp(p.x, *exponent), std::ldexp(p.y, *exponent), std::ldexp(p.z, *exponent)});
  return Finder<double>(scaled, std::ldexp(radius, *exponent)).run();
}

}  // namespace rbpa::space
