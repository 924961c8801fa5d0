#include "rbpa/space/pivot/find_free_arcs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "rbpa/parallel/in_order.h"
#include "rbpa/space/pivot/roll_about_edge.h"
#include "rbpa/space/search/cells.h"
#include "rbpa/space/search/scale.h"

namespace rbpa::space {
namespace {

/// Sites of a cell, few enough that a run can be ended soon.
struct Part {
  std::size_t cell, first, count;
};

std::vector<Part> parts_of(const Cells& cells) {
  constexpr std::size_t most = 32;
  std::vector<Part> parts;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const std::size_t size = cells.points_in(cell).size();
    for (std::size_t first = 0; first < size; first += most)
      parts.push_back({cell, first, std::min(most, size - first)});
  }
  return parts;
}

/// The arcs of edges from sites of one cell to greater ones; used again for other cells.
template <typename Real>
class Star {
 public:
  /// Replaces arcs().
  void find(std::span<const Point3> points, double radius, const Cells& cells, const Part& part) {
    around_.clear();
    arcs_.clear();
    cells.for_each_around(part.cell, [&](std::size_t i) {
      const auto sites = cells.points_in(i);
      around_.insert(around_.end(), sites.begin(), sites.end());
    });
    for (const Site a : cells.points_in(part.cell).subspan(part.first, part.count)) find_at(a, points, radius);
  }
  const std::vector<FreeArc>& arcs() const { return arcs_; }

 private:
  struct Near {
    Real distance;  // squared, rounded
    Site site;
  };

  void find_at(Site a, std::span<const Point3> points, double radius) {
    // Rounded outward, by more than the roundings of a distance.
    const Real farthest = 4 * Real(radius) * Real(radius) * (1 + Real(0x1p-40));
    near_.clear();
    for (const Site p : around_) {
      if (p == a) continue;
      const Vector3<Real> d = from<Real>(points[a], points[p]);
      const Real distance = dot(d, d);
      if (!(distance > farthest)) near_.push_back({distance, p});
    }
    std::sort(near_.begin(), near_.end(), [](const Near& p, const Near& q) {
      return p.distance != q.distance ? p.distance < q.distance : p.site < q.site;
    });
    places_.clear();
    for (const Near& p : near_) places_.push_back(points[p.site]);
    for (std::size_t b = 0; b < near_.size(); ++b)
      if (near_[b].site > a)
        EdgeRoll<Real>(points[a], b, radius, places_).for_each_free_arc([&](std::size_t left, std::size_t touched) {
          arcs_.push_back({a, near_[b].site, near_[left].site, near_[touched].site});
        });
  }

  std::vector<FreeArc> arcs_;
  std::vector<Site> around_;    // of the cells around one
  std::vector<Near> near_;      // what a ball at one site can touch or hold, nearest first
  std::vector<Point3> places_;  // theirs
};

template <typename Real>
std::vector<FreeArc> find(std::span<const Point3> points, double radius, Threads& threads,
                          const std::function<void(std::size_t)>& found) {
  const Cells cells(points, radius);
  const std::vector<Part> parts = parts_of(cells);
  std::vector<FreeArc> arcs;
  in_order<Star<Real>>(
      threads, parts.size(), [&](std::size_t i, Star<Real>& star) { star.find(points, radius, cells, parts[i]); },
      [&](std::size_t, Star<Real>& star) {
        arcs.insert(arcs.end(), star.arcs().begin(), star.arcs().end());
        if (found) found(arcs.size());
      },
      [](std::size_t, Star<Real>&) {});
  return arcs;
}

}  // namespace

std::vector<FreeArc> find_free_arcs(std::span<const Point3> points, double radius, Threads& threads,
                                    const std::function<void(std::size_t)>& found) {
  const std::optional<int> exponent = scale_to_double(points, radius);
  if (!exponent) return find<long double>(points, radius, threads, found);
  if (*exponent == 0) return find<double>(points, radius, threads, found);
  std::vector<Point3> scaled;
  scaled.reserve(points.size());
  for (const Point3& p : points)
    scaled.push_back({std::ldexp(p.x, *exponent), std::ldexp(p.y, *exponent), std::ldexp(p.z, *exponent)});
  return find<double>(scaled, std::ldexp(radius, *exponent), threads, found);
}

}  // namespace rbpa::space
