#include "rbpa/space/balls/full/outside_of_balls.h"

#include <algorithm>
#include <numbers>
#include <tuple>

#include "rbpa/base/arrays/grouped.h"
#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/balls/full/ball_wedges.h"
#include "rbpa/space/predicate/spread.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {
namespace {

using std::numbers::pi;

/// Sums over the simplices of a region at a ball: docs/explanation/space.md, section 25.
struct Term {
  std::uint32_t region, ball;
  bool is_end = false;     // whether the ball is an end of an edge of the complex at the region
  std::int64_t turns = 0;  // half turns
  double angles = 0;       // in radians, to be subtracted from the half turns
  double arcs = 0;
  double contacts = 0;  // three times the volume of cones over contacts; each is counted at one end

  void add(const Term& other) {
    is_end |= other.is_end;
    turns += other.turns;
    angles += other.angles;
    arcs += other.arcs;
    contacts += other.contacts;
  }
};

class Terms {
 public:
  explicit Terms(const BallRegions& regions) : of_(regions), stars_(of_.cells) {}

  const PointStars& stars() const { return stars_; }

  /// Returns the terms of all regions, ascending by region and ball. A region and ball may have several terms.
  std::vector<Term> all(Threads& threads, const GoOn& go_on) const {
    constexpr std::size_t at_a_time = 1u << 9;
    struct Workspace {
      EdgesUp up;
      std::vector<Term> terms;
    };
    std::vector<Term> terms;
    CheckpointOfThreads checkpoint(go_on);
    in_order<Workspace>(
        threads, (stars_.bound() + at_a_time - 1) / at_a_time,
        [&](std::size_t part, Workspace& w) {
          checkpoint();
          w.terms.clear();
          for (std::size_t i = part * at_a_time; i < std::min((part + 1) * at_a_time, stars_.bound()); ++i)
            add_star(static_cast<std::uint32_t>(i), w.up, w.terms);
        },
        [&](std::size_t, Workspace& w) { terms.insert(terms.end(), w.terms.begin(), w.terms.end()); },
        [](std::size_t, Workspace&) {});
    std::stable_sort(terms.begin(), terms.end(), [](const Term& a, const Term& b) {
      return std::tie(a.region, a.ball) < std::tie(b.region, b.ball);
    });
    return terms;
  }

 private:
  Ball ball(std::uint32_t t, std::size_t k) const {
    const std::uint32_t vertex = of_.cells.simplices[t][k];
    return {of_.positions[vertex], of_.radii[vertex]};
  }
  bool is_whole(std::span<const EdgeAt> ring, std::uint32_t region) const {
    return std::all_of(ring.begin(), ring.end(), [&](const EdgeAt& at) {
      const auto [k, l] = others(at);
      const auto& beyond = of_.cells.neighbors[at.tetrahedron];
      return of_.region[at.tetrahedron] == region && beyond[k] != Solid::none && beyond[l] != Solid::none;
    });
  }

  void add_star(std::uint32_t i, EdgesUp& up, std::vector<Term>& terms) const {
    const std::size_t before = terms.size();
    for (const std::uint32_t t : stars_[i]) {
      if (of_.region[t] == BallRegions::none) continue;
      Term term = {of_.region[t], i};
      std::uint8_t own = 0;
      while (of_.cells.point(of_.cells.simplices[t][own]) != i) ++own;
      term.turns = -1;
      for (std::uint8_t k = 0; k < 4; ++k) {
        if (k == own || !of_.is_wall(t, k)) continue;
        const auto [a, b] = others({t, own, k});
        ++term.turns;
        term.angles += corner_angle(ball(t, own), ball(t, a), ball(t, b));
      }
      terms.push_back(term);
    }
    if (terms.size() == before) return;
    for_each_edge_up(i, stars_[i], of_.cells, up, [&](std::uint32_t j, std::span<const EdgeAt> ring) {
      for (std::size_t at = 0; at < ring.size(); ++at) {
        const auto region_of = [&](const EdgeAt& edge) { return of_.region[edge.tetrahedron]; };
        const std::uint32_t region = region_of(ring[at]);
        const auto earlier = ring.first(at);
        const auto is_same = [&](const EdgeAt& edge) { return region_of(edge) == region; };
        if (region != BallRegions::none && std::none_of(earlier.begin(), earlier.end(), is_same))
          add_edge({region, i}, {region, j}, ring, terms);
      }
    });
  }

  /// Adds the terms of one region at the edge between balls i and j.
  void add_edge(Term i, Term j, std::span<const EdgeAt> ring, std::vector<Term>& terms) const {
    const bool is_whole = this->is_whole(ring, i.region);
    double angle = is_whole ? 2 * pi : 0, area = 0;
    for (const EdgeAt& at : ring) {
      if (of_.region[at.tetrahedron] != i.region) continue;
      const auto [k, l] = others(at);
      const Ball a = ball(at.tetrahedron, at.from), b = ball(at.tetrahedron, at.to), c = ball(at.tetrahedron, k),
                 d = ball(at.tetrahedron, l);
      const BallCircle circle(a, b);
      if (!is_whole) angle += circle.in_tetrahedron(c, d, true).angle;
      for (const auto& [across, beside] : {std::pair(k, &d), std::pair(l, &c)})
        if (of_.is_wall(at.tetrahedron, across)) {
          const WedgePart part = circle.beside_triangle(*beside);
          angle -= part.angle;
          area += part.area;
        }
    }
    i.is_end = j.is_end = of_.has_edge(ring);
    if (i.is_end) {
      const Ball a = ball(ring[0].tetrahedron, ring[0].from), b = ball(ring[0].tetrahedron, ring[0].to);
      const BallCircle circle(a, b);
      i.arcs = circle.height_i * angle;
      j.arcs = circle.height_j * angle;
      i.contacts = circle.distance * (area + angle * circle.square / 2);
    } else {
      i.angles = j.angles = -angle;
    }
    terms.push_back(i);
    terms.push_back(j);
  }

  const BallRegions& of_;
  PointStars stars_;
};

}  // namespace

RegionMeasures outside_of_balls(const BallRegions& regions, Threads& threads, const GoOn& go_on) {
  const Terms of(regions);
  const std::vector<Term> terms = of.all(threads, go_on);
  RegionMeasures result;
  result.all.resize(regions.count);
  Steps step(go_on);
  const Grouped tetrahedra(regions.region.size(), regions.count, [&](std::uint32_t t) { return regions.region[t]; });
  for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
    ExactSum whole;
    for (const std::uint32_t t : tetrahedra.items(i)) {
      step();
      whole.add(volume<double>(regions.positions, regions.cells.simplices[t]));
    }
    result.all[regions.region[tetrahedra.items(i).front()]].tetrahedra = whole.rounded();
  }
  for (auto at = terms.begin(); at != terms.end();) {
    const std::uint32_t region = at->region;
    ExactSum covered, area;
    while (at != terms.end() && at->region == region) {
      step();
      Term sum = *at;
      for (++at; at != terms.end() && at->region == region && at->ball == sum.ball; ++at) sum.add(*at);
      if (!sum.is_end && regions.has_vertex && !regions.has_vertex(sum.ball)) continue;
      const auto& row = regions.cells.simplices[of.stars()[sum.ball].front()];
      const auto vertex = std::find_if(row.begin(), row.end(),
                                       [&](std::uint32_t corner) { return regions.cells.point(corner) == sum.ball; });
      const double r = regions.radii[*vertex];
      const double part = r * (r * (pi * static_cast<double>(sum.turns) - sum.angles) + sum.arcs);
      result.shares.push_back({region, sum.ball, part, (r * part + sum.contacts) / 3});
      area.add(part);
      covered.add(result.shares.back().volume);
    }
    RegionMeasure& measure = result.all[region];
    measure.area = area.rounded();
    covered.add(-measure.tetrahedra);
    measure.volume = -covered.rounded();
  }
  return result;
}

std::vector<double> outside_of_balls(const Triangulated& space, std::span<const std::uint32_t> void_of,
                                     std::size_t voids, double alpha, Threads& threads, const GoOn& go_on) {
  const Spread scale = spread(space.positions, std::span(&alpha, 1));
  std::vector<Point3> copy;
  const std::vector<double> radii(space.positions.size(), std::ldexp(alpha, scale.exponent));
  const auto is_wall = [&](std::uint32_t t, std::size_t k) { return space.neighbors[t][k] == Solid::none; };
  const auto has_edge = [&](std::span<const EdgeAt> ring) {
    const auto is_at_wall = [&](const EdgeAt& at) {
      const auto [k, l] = others(at);
      return is_wall(at.tetrahedron, k) || is_wall(at.tetrahedron, l);
    };
    return std::any_of(ring.begin(), ring.end(), is_at_wall) || is_edge_alone(space, ring, alpha);
  };
  const RegionMeasures measures = outside_of_balls(
      {space, scaled(space.positions, scale, copy), radii, void_of, voids, is_wall, has_edge}, threads, go_on);
  std::vector<double> volumes;
  for (const RegionMeasure& of : measures.all)
    volumes.push_back(std::ldexp(std::max(of.volume, 0.0), -3 * scale.exponent));
  return volumes;
}

}  // namespace rbpa::space
