#include "rbpa/space/balls/periodic_topology.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/space/balls/dangling_faces.h"
#include "rbpa/space/solid/solid_radii.h"
#include "support/infinity.h"
#include "support/periodic_sets.h"

using namespace rbpa_test;
using rbpa::ComplexKind;
using rbpa::PeriodicPart;
using rbpa::PeriodicSolid;
using rbpa::PeriodicTopology;
using rbpa::PeriodicVertex;
using rbpa::Point3;

TEST_SUITE_BEGIN("space");

namespace {

using Simplex = std::vector<std::array<int, 4>>;  // points and offsets, of the first 0

/// Returns the image whose first point is in the box. Requires: ascending vertices.
Simplex normalized(const std::vector<PeriodicVertex>& vertices) {
  Simplex result;
  for (const PeriodicVertex& v : vertices)
    result.push_back({static_cast<int>(v.point), v.offset[0] - vertices[0].offset[0],
                      v.offset[1] - vertices[0].offset[1], v.offset[2] - vertices[0].offset[2]});
  return result;
}

struct Chains {
  std::array<std::map<Simplex, std::size_t>, 4> number;
  std::array<std::vector<std::map<std::size_t, std::int64_t>>, 4> boundary;  // columns
};

std::size_t add(Chains& chains, const std::vector<PeriodicVertex>& ascending) {
  const std::size_t dimension = ascending.size() - 1;
  const auto [at, is_new] = chains.number[dimension].emplace(normalized(ascending), chains.number[dimension].size());
  const std::size_t number = at->second;
  if (!is_new) return number;
  chains.boundary[dimension].emplace_back();
  if (dimension == 0) return number;
  std::map<std::size_t, std::int64_t> column;
  for (std::size_t k = 0; k <= dimension; ++k) {
    std::vector<PeriodicVertex> face = ascending;
    face.erase(face.begin() + static_cast<std::ptrdiff_t>(k));
    column[add(chains, face)] += k % 2 == 0 ? 1 : -1;
  }
  chains.boundary[dimension][number] = column;
  return number;
}

/// Returns the rank over the integers modulo a large prime: the same as over the rationals, unless a torsion has that
/// prime.
std::size_t rank(std::vector<std::map<std::size_t, std::int64_t>> columns) {
  constexpr std::int64_t prime = 1'000'003;
  const auto inverse = [](std::int64_t x) {
    std::int64_t result = 1;
    for (std::int64_t power = prime - 2; power > 0; power /= 2, x = x * x % prime)
      if (power % 2 == 1) result = result * x % prime;
    return result;
  };
  std::map<std::size_t, std::map<std::size_t, std::int64_t>> reduced;  // by the greatest row
  for (auto& column : columns) {
    for (auto& entry : column) entry.second = (entry.second % prime + prime) % prime;
    std::erase_if(column, [](const auto& entry) { return entry.second == 0; });
    while (!column.empty()) {
      const auto [at, is_new] = reduced.emplace(column.rbegin()->first, column);
      if (is_new) break;
      const std::int64_t factor = column.rbegin()->second * inverse(at->second.rbegin()->second) % prime;
      for (const auto& [row, value] : at->second) {
        std::int64_t& entry = column[row];
        entry = ((entry - factor * value) % prime + prime) % prime;
        if (entry == 0) column.erase(row);
      }
    }
  }
  return reduced.size();
}

struct Model {
  std::array<std::size_t, 4> counts, betti;
};

/// Returns the model of the tetrahedra of `solid` and of the simplices `more`.
Model model_of(const PeriodicSolid& solid, const std::vector<std::vector<PeriodicVertex>>& more = {}) {
  Chains chains;
  for (const auto& row : rows_of(solid)) {
    std::vector<PeriodicVertex> ascending(row.begin(), row.end());
    std::sort(ascending.begin(), ascending.end());
    add(chains, ascending);
  }
  for (const auto& ascending : more) add(chains, ascending);
  std::array<std::size_t, 5> ranks = {0, 0, 0, 0, 0};
  Model model{};
  for (std::size_t d = 1; d < 4; ++d) ranks[d] = rank(chains.boundary[d]);
  for (std::size_t d = 0; d < 4; ++d) {
    model.counts[d] = chains.number[d].size();
    model.betti[d] = model.counts[d] - ranks[d] - ranks[d + 1];
  }
  return model;
}

/// Returns the dangling simplices of the full complex of 27 images of all points that have their first corner in the
/// box. Simplices near the outer sides of the images, some of which are wrong, have no corner in the box.
std::vector<std::vector<PeriodicVertex>> dangling_by_images(const Points3& in_box, const Point3& box, double alpha) {
  const AllImages all = all_images(in_box, box);
  const rbpa::Solid delaunay = rbpa::solid(all.positions, infinity);
  const rbpa::DanglingFaces found =
      rbpa::dangling_faces(all.positions, delaunay, rbpa::circumradii(all.positions, delaunay.simplices), alpha);
  std::vector<std::vector<PeriodicVertex>> simplices;
  const auto add = [&](const auto& corners) {
    std::vector<PeriodicVertex> ascending;
    for (const std::uint32_t corner : corners) ascending.push_back(all.vertices[corner]);
    std::sort(ascending.begin(), ascending.end());
    if (ascending[0].offset == std::array<std::int8_t, 3>{0, 0, 0}) simplices.push_back(ascending);
  };
  for (const auto& triangle : found.triangles) add(triangle);
  for (const auto& edge : found.edges) add(edge);
  for (const std::uint32_t point : found.points) add(std::array{point});
  return simplices;
}

double sum(const std::vector<PeriodicPart>& parts, double PeriodicPart::*what) {
  return std::accumulate(parts.begin(), parts.end(), 0.0,
                         [&](double total, const PeriodicPart& part) { return total + part.*what; });
}

struct Case {
  PeriodicSolid delaunay;
  std::vector<double> radii;
};

Case triangulated(const Points3& points, const Point3& box) {
  Case made;
  made.delaunay = rbpa::periodic_solid(points, box, infinity);
  made.radii = rbpa::circumradii(made.delaunay.positions, made.delaunay.simplices);
  return made;
}

/// Returns uniform points of a box of side 10, without those within a shape.
Points3 without(const std::function<double(const Point3&)>& depth) {
  Random random(81);
  Points3 points;
  while (points.size() < 6000) {
    const Point3 p = {10 * random.unit(), 10 * random.unit(), 10 * random.unit()};
    if (depth(p) <= 0) points.push_back(p);
  }
  return points;
}

}  // namespace

TEST_CASE("counts and Betti numbers of periodic complexes are those of their boundary matrices; parts fill the box") {
  std::array<std::size_t, 4> dimensions = {0, 0, 0, 0};
  std::size_t checked = 0, whole = 0, with_tunnels = 0, only_full = 0;
  for (std::uint64_t trial = 0; trial < 60; ++trial) {
    Random random(4800 + trial);
    const PeriodicSet set = periodic_set(trial, 40 + random.below(60), random);
    CAPTURE(set.name);
    Case made;
    try {
      made = triangulated(set.points, set.box);
    } catch (const rbpa::InvalidInput&) {
      continue;
    }
    std::vector<double> sorted = made.radii;
    std::sort(sorted.begin(), sorted.end());
    for (const double share : {0.0, 0.1, 0.2, 0.35, 0.5, 0.7, 0.9, 0.98, 1.0}) {
      const double alpha = sorted[static_cast<std::size_t>(share * double(sorted.size() - 1))] * (share == 0 ? 0.9 : 1);
      CAPTURE(alpha);
      const PeriodicTopology topology = rbpa::periodic_topology(made.delaunay, made.radii, alpha, ComplexKind::solid);
      const PeriodicSolid within = rbpa::within(made.delaunay, made.radii, alpha);
      const Model model = model_of(within);
      CHECK(std::array{topology.points, topology.edges, topology.triangles, topology.tetrahedra} == model.counts);
      CHECK(topology.betti == model.betti);
      const double box = made.delaunay.box.x * made.delaunay.box.y * made.delaunay.box.z;
      CHECK(sum(topology.solid_components, &PeriodicPart::volume) == doctest::Approx(topology.volume));
      CHECK(sum(topology.solid_components, &PeriodicPart::area) == doctest::Approx(topology.area));
      CHECK(sum(topology.voids, &PeriodicPart::area) == doctest::Approx(topology.area));
      CHECK(topology.volume + sum(topology.voids, &PeriodicPart::volume) == doctest::Approx(box));
      for (const auto* parts : {&topology.solid_components, &topology.voids})
        for (std::size_t i = 0; i < parts->size(); ++i) {
          CHECK((*parts)[i].volume > 0);
          CHECK((*parts)[i].points.empty() == (parts->size() == 1 && topology.boundary_triangles == 0));
          if (i > 0) CHECK((*parts)[i].volume <= (*parts)[i - 1].volume);
          ++dimensions[(*parts)[i].dimension];
        }
      const PeriodicTopology full = rbpa::periodic_topology(made.delaunay, made.radii, alpha, ComplexKind::full, 2);
      const Model full_model =
          model_of(within, dangling_by_images(wrapped(set, made.delaunay.box), made.delaunay.box, alpha));
      CHECK(std::array{full.points, full.edges, full.triangles, full.tetrahedra} == full_model.counts);
      CHECK(full.betti == full_model.betti);
      CHECK(full.volume == topology.volume);
      CHECK(full.area == topology.area);
      CHECK(full.volume + sum(full.voids, &PeriodicPart::volume) == doctest::Approx(box));
      CHECK(sum(full.voids, &PeriodicPart::area) >= topology.area * (1 - 1e-12));
      for (const PeriodicPart& hollow : full.voids) {
        REQUIRE(hollow.outside_balls.has_value());
        CHECK(*hollow.outside_balls >= 0);
        CHECK(*hollow.outside_balls < hollow.volume);
        ++dimensions[hollow.dimension];
      }
      only_full += full.voids.size() > topology.voids.size() ? 1u : 0u;
      ++checked;
      whole += topology.betti == std::array<std::size_t, 4>{1, 3, 3, 1} ? 1u : 0u;
      with_tunnels += topology.betti[1] > 0 ? 1u : 0u;
    }
  }
  CHECK(checked > 200);
  CHECK(whole > 20);
  CHECK(with_tunnels > 100);
  CHECK(only_full > 40);
  for (const std::size_t count : dimensions) CHECK(count > 0);
}

TEST_CASE("a ball, a channel, a layer and a network that are left out percolate in 0, 1, 2 and 3 directions") {
  const auto bent = [](double x) { return x - 10 * std::floor(x / 10) - 5; };  // from −5 to 5
  const auto topology_without = [&](const std::function<double(const Point3&)>& depth) {
    const Case made = triangulated(without(depth), {10, 10, 10});
    const PeriodicTopology full = rbpa::periodic_topology(made.delaunay, made.radii, 1.2);
    const PeriodicTopology solid = rbpa::periodic_topology(made.delaunay, made.radii, 1.2, ComplexKind::solid);
    REQUIRE(full.voids.size() >= solid.voids.size());  // points are so dense that triangles separate hardly anything
    CHECK(full.voids[0].dimension == solid.voids[0].dimension);
    CHECK(full.voids[0].volume == doctest::Approx(solid.voids[0].volume).epsilon(0.01));
    return solid;
  };
  const auto about = [](double value) { return doctest::Approx(value).epsilon(0.15); };
  // The ball is across the corner of the box, so that it is in pieces there.
  const PeriodicTopology ball =
      topology_without([&](const Point3& p) { return 3 - std::hypot(bent(p.x + 5), bent(p.y + 5), bent(p.z + 5)); });
  REQUIRE(ball.voids.size() == 1);
  CHECK(ball.voids[0].dimension == 0);
  CHECK(ball.voids[0].volume == about(4.0 / 3 * 3.14159 * 27));
  CHECK(ball.voids[0].area == about(4 * 3.14159 * 9));
  CHECK(ball.voids[0].points.size() > 100);
  CHECK(ball.betti == std::array<std::size_t, 4>{1, 3, 3, 0});
  CHECK(ball.solid_components[0].dimension == 3);

  const PeriodicTopology channel =
      topology_without([&](const Point3& p) { return 2.5 - std::hypot(bent(p.y + 5 + p.x), bent(p.z + 5)); });
  REQUIRE(channel.voids.size() == 1);
  CHECK(channel.voids[0].dimension == 1);
  CHECK(channel.betti == std::array<std::size_t, 4>{1, 3, 2, 0});

  const PeriodicTopology layer = topology_without([&](const Point3& p) { return 2 - std::abs(bent(p.z + 5)); });
  REQUIRE(layer.voids.size() == 1);
  CHECK(layer.voids[0].dimension == 2);
  CHECK(layer.betti == std::array<std::size_t, 4>{1, 2, 1, 0});
  CHECK(layer.solid_components[0].dimension == 2);
  CHECK(layer.voids[0].area == about(200));

  const PeriodicTopology network = topology_without([&](const Point3& p) {
    const double x = bent(p.x), y = bent(p.y), z = bent(p.z);
    return 2.5 - std::min({std::hypot(x, y), std::hypot(y, z), std::hypot(z, x)});
  });
  REQUIRE(network.voids.size() == 1);
  CHECK(network.voids[0].dimension == 3);
  CHECK(network.betti[0] == 1);
  CHECK(network.solid_components[0].dimension == 3);
}

TEST_CASE("measures of a periodic solid have the same bytes in any order of the points, and wherever the box begins") {
  for (std::uint64_t trial = 0; trial < 16; ++trial) {
    Random random(4900 + trial);
    PeriodicSet set = periodic_set(trial % 8, 60, random);
    set.points = wrapped(set, set.box);
    std::vector<PeriodicTopology> all, all_full;
    for (int time = 0; time < 3; ++time) {
      try {
        const Case made = triangulated(set.points, set.box);
        for (const ComplexKind walls : {ComplexKind::solid, ComplexKind::full})
          (walls == ComplexKind::solid ? all : all_full)
              .push_back(rbpa::periodic_topology(made.delaunay, made.radii, 1.5, walls));
      } catch (const rbpa::InvalidInput&) {
      }
      random.shuffle(set.points);
      if (time == 1)
        for (Point3& p : set.points) p = {p.x + 3.25, p.y - 1.125, p.z + 7.5};
    }
    CAPTURE(set.name);
    for (const auto* same : {&all, &all_full})
      for (const PeriodicTopology& other : *same) {
        const PeriodicTopology& first = same->front();
        CHECK(other.volume == first.volume);
        CHECK(other.area == first.area);
        CHECK(other.betti == first.betti);
        REQUIRE(other.voids.size() == first.voids.size());
        for (std::size_t i = 0; i < other.voids.size(); ++i) {
          CHECK(other.voids[i].volume == first.voids[i].volume);
          CHECK(other.voids[i].area == first.voids[i].area);
          CHECK(other.voids[i].dimension == first.voids[i].dimension);
          CHECK(other.voids[i].points.size() == first.voids[i].points.size());
          if (first.voids[i].outside_balls)
            CHECK(*other.voids[i].outside_balls == doctest::Approx(*first.voids[i].outside_balls).epsilon(1e-9));
        }
      }
  }
}

TEST_CASE("bricks of points open their windows of three sizes at exact radii, each in its direction") {
  // Euler's brick: all diagonals of faces are integers, so that half of each is a double. The diagonal of the brick is
  // 270.6.
  const Point3 brick = {44, 117, 240};
  const int along_x = 7, along_y = 4, along_z = 3;
  const Point3 box = {along_x * brick.x, along_y * brick.y, along_z * brick.z};
  const Points3 points = corners_of_bricks(along_x, along_y, along_z, brick);
  const Case made = triangulated(points, box);
  const auto at = [&](double alpha, ComplexKind walls = ComplexKind::full) {
    return rbpa::periodic_topology(made.delaunay, made.radii, alpha, walls);
  };
  const auto below = [](double x) { return std::nextafter(x, 0.0); };
  struct Step {
    double alpha;
    unsigned dimension;
    std::size_t voids;
  };
  const std::size_t bricks = 7 * 4 * 3;
  for (const Step& step : {Step{below(62.5), 3, 1}, Step{62.5, 2, 3}, Step{below(122), 2, 3}, Step{122, 1, 12},
                           Step{below(133.5), 1, 12}, Step{133.5, 0, bricks}, Step{135, 0, bricks}}) {
    CAPTURE(step.alpha);
    const PeriodicTopology topology = at(step.alpha);
    REQUIRE(topology.voids.size() == step.voids);
    for (const PeriodicPart& hollow : topology.voids) {
      CHECK(hollow.dimension == step.dimension);
      CHECK(hollow.volume == box.x * box.y * box.z / double(step.voids));
    }
    CHECK(topology.betti[0] == (step.alpha < 120 ? 3 : 1));  // edges along z
    CHECK(topology.betti[2] == step.voids + 2 - step.dimension);
    CHECK(topology.betti[3] == 0);
    // The solid leaks through every window.
    CHECK(at(step.alpha, ComplexKind::solid).voids.size() == 1);
  }
  CHECK(at(135.5).voids.empty());
  CHECK(at(135.5).betti == std::array<std::size_t, 4>{1, 3, 3, 1});
}

TEST_CASE("balls leave of a cubic lattice the volume of the formula, and of random points that of samples") {
  Points3 cubic;
  for (int i = 0; i < 64; ++i) cubic.push_back({double(i % 4), double(i / 4 % 4), double(i / 16)});
  const Case lattice = triangulated(cubic, {4, 4, 4});
  const double pi = std::acos(-1.0);
  for (const double r : {0.3, 0.5, 0.6, 0.7, std::nextafter(std::sqrt(0.5), 1.0)}) {
    CAPTURE(r);
    const double lens = r > 0.5 ? pi / 12 * (4 * r + 1) * (2 * r - 1) * (2 * r - 1) : 0;
    const double left = 1 - (4 * pi / 3 * r * r * r - 3 * lens);
    const PeriodicTopology topology = rbpa::periodic_topology(lattice.delaunay, lattice.radii, r);
    CHECK(topology.voids.size() == (r > 0.705 ? 64 : 1));
    for (const PeriodicPart& hollow : topology.voids)
      CHECK(*hollow.outside_balls / hollow.volume == doctest::Approx(left).epsilon(1e-12));
  }
  for (const std::size_t count : {40u, 150u}) {
    Random random(4970 + count);
    const PeriodicSet set = {"uniform",
                             [&] {
                               Points3 points;
                               for (std::size_t i = 0; i < count; ++i)
                                 points.push_back({8 * random.unit(), 9 * random.unit(), 10 * random.unit()});
                               return points;
                             }(),
                             {8, 9, 10}};
    const Case made = triangulated(set.points, set.box);
    for (const double alpha : {0.8, 1.2, 1.7}) {
      CAPTURE(alpha);
      const PeriodicTopology topology = rbpa::periodic_topology(made.delaunay, made.radii, alpha);
      double outside = 0;
      for (const PeriodicPart& hollow : topology.voids) outside += *hollow.outside_balls;
      constexpr int samples = 40'000;
      int far = 0;
      for (int i = 0; i < samples; ++i) {
        const Point3 q = {8 * random.unit(), 9 * random.unit(), 10 * random.unit()};
        const auto apart = [](double a, double b, double side) {
          const double d = std::abs(a - b);
          return std::min(d, side - d);
        };
        far += std::none_of(set.points.begin(), set.points.end(),
                            [&](const Point3& p) {
                              return std::hypot(apart(p.x, q.x, 8), apart(p.y, q.y, 9), apart(p.z, q.z, 10)) < alpha;
                            })
                   ? 1
                   : 0;
      }
      const double share = double(far) / samples;
      CHECK(std::abs(outside / 720 - share) < 4 * std::sqrt(share * (1 - share) / samples) + 1e-4);
    }
  }
}

TEST_CASE("what is not a triangulation of a box is refused") {
  Random random(4950);
  const PeriodicSet set = periodic_set(0, 100, random);
  const Case made = triangulated(set.points, set.box);
  const auto refuses = [](const PeriodicSolid& solid, const std::vector<double>& radii, double alpha = 1) {
    CHECK_THROWS_AS(rbpa::periodic_topology(solid, radii, alpha), meshops::ContractViolation);
  };
  refuses(made.delaunay, {1, 2, 3});
  PeriodicSolid bare = made.delaunay;
  bare.neighbors.clear();
  refuses(bare, made.radii);
  const PeriodicSolid part = rbpa::within(made.delaunay, made.radii, made.radii[0]);
  refuses(part, rbpa::circumradii(part.positions, part.simplices));
  CHECK_THROWS_AS(rbpa::periodic_topology(made.delaunay, made.radii, 0), rbpa::InvalidInput);
}
