#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "oracle/cgal_space.h"
#include "rbpa/space/surface/holes.h"
#include "rbpa/space/surface/surface.h"
#include "rbpa/space/surface/surface_levels.h"
#include "support/arguments.h"
#include "support/data_folder.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::Surface;

namespace {

static_assert(ExposedByCgal::none == Surface::none);

bool same(const Surface& actual, const ExposedByCgal& expected) {
  return actual.triangles == expected.triangles && actual.neighbors == expected.neighbors;
}

/// Checks the exposed triangles and the surface. Returns: the number of triangles of the surface.
std::size_t check(const Points3& points, const Points3& normals, double radius) {
  const Surface actual = rbpa::exposed_triangles(points, radius);
  const ExposedByCgal expected = exposed_by_delaunay(points, radius);
  CHECK(difference(expected.triangles, actual.triangles) == "");
  CHECK(expected.neighbors == actual.neighbors);
  const Surface surface = rbpa::surface(points, normals, radius);
  const ExposedByCgal agree = agreeing(expected, points, normals);
  CHECK(difference(agree.triangles, surface.triangles) == "");
  CHECK(agree.neighbors == surface.neighbors);
  return surface.triangles.size();
}
/// Checks with normals of any direction.
void check(const Points3& points, double radius) {
  Random random(points.size());
  check(points, random_normals(points.size(), random), radius);
}

/// Returns a text for people: the points and the radius as doubles that read back.
std::string text(const Points3& points, double radius) {
  std::ostringstream out;
  out << std::hexfloat << "radius " << radius << ", points";
  for (const Point3& p : points) out << " {" << p.x << ", " << p.y << ", " << p.z << "}";
  return out.str();
}

struct Scan {
  std::string name;
  Points3 points, normals;
};

/// Returns the .xyz files of the larger collection with `smallest` to `largest` points.
std::vector<Scan> further_scans(std::size_t smallest, std::size_t largest) {
  std::vector<Scan> found;
  if (!has_further_data()) return found;
  for (const auto& entry : std::filesystem::directory_iterator(further_data())) {
    if (entry.path().extension() != ".xyz") continue;
    Scan scan{entry.path().stem().string(), {}, {}};
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      std::istringstream numbers(line);
      Point3 p, n;
      if (!(numbers >> p.x >> p.y >> p.z)) throw std::runtime_error(entry.path().string() + ": " + line);
      scan.points.push_back(p);
      if (numbers >> n.x >> n.y >> n.z) scan.normals.push_back(n == Point3{} ? Point3{0, 0, 1} : n);
    }
    if (scan.points.size() >= smallest && scan.points.size() <= largest) found.push_back(std::move(scan));
  }
  std::sort(found.begin(), found.end(), [](const Scan& s, const Scan& t) { return s.name < t.name; });
  return found;
}

/// Returns about the distance of neighbors: the median, over some points, of the distance to the nearest other point.
double spacing(const Points3& points) {
  std::vector<double> nearest;
  for (std::size_t i = 0; i < points.size(); i += points.size() / 60 + 1) {
    double least = INFINITY;
    for (const Point3& q : points)
      if (q != points[i]) least = std::min(least, std::hypot(q.x - points[i].x, q.y - points[i].y, q.z - points[i].z));
    nearest.push_back(least);
  }
  std::nth_element(nearest.begin(), nearest.begin() + static_cast<long>(nearest.size() / 2), nearest.end());
  return nearest[nearest.size() / 2];
}

struct Samples {
  Points3 points, normals;
};

/// Returns points on a sphere, with `noise` along the normals.
Samples on_sphere(std::size_t count, double noise, std::uint64_t seed) {
  Random random(seed);
  Samples sphere;
  while (sphere.points.size() < count) {
    const Point3 p = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double size = std::hypot(p.x, p.y, p.z), out = (1 + noise * random.between(-1, 1)) / size;
    if (!(size > 0.1 && size < 1)) continue;
    sphere.points.push_back({out * p.x, out * p.y, out * p.z});
    sphere.normals.push_back(p);
  }
  return sphere;
}

/// Returns points near the zeros of f, moved there along its gradient, which is the normal.
template <typename Function>
Samples on_level(std::size_t count, double size, std::uint64_t seed, Function f) {
  constexpr double h = 1e-5;
  Random random(seed);
  Samples samples;
  while (samples.points.size() < count) {
    Point3 p = {random.between(-size, size), random.between(-size, size), random.between(-size, size)}, n;
    double value = 0;
    for (int step = 0; step < 10; ++step) {
      n = {(f(p.x + h, p.y, p.z) - f(p.x - h, p.y, p.z)) / (2 * h),
           (f(p.x, p.y + h, p.z) - f(p.x, p.y - h, p.z)) / (2 * h),
           (f(p.x, p.y, p.z + h) - f(p.x, p.y, p.z - h)) / (2 * h)};
      value = f(p.x, p.y, p.z);
      const double s = value / (n.x * n.x + n.y * n.y + n.z * n.z);
      p = {p.x - s * n.x, p.y - s * n.y, p.z - s * n.z};
    }
    if (!(std::abs(value) < 1e-6) || n == Point3{}) continue;
    samples.points.push_back(p);
    samples.normals.push_back(n);
  }
  return samples;
}

double torus_at(double center, double x, double y, double z) {
  return std::hypot(std::hypot(x - center, y) - 1, z) - 0.35;
}
Samples on_torus(std::size_t count) {
  return on_level(count, 1.4, 31, [](double x, double y, double z) { return torus_at(0, x, y, z); });
}
/// Returns points on two merged tori.
Samples on_double_torus(std::size_t count) {
  return on_level(count, 2.4, 32, [](double x, double y, double z) {
    return -std::log(std::exp(-12 * torus_at(-1, x, y, z)) + std::exp(-12 * torus_at(1, x, y, z))) / 12;
  });
}

/// Returns two sheets back to back, `thickness` apart.
Samples plate(std::size_t count, double thickness) {
  Random random(33);
  Samples samples;
  while (samples.points.size() < count) {
    const double up = random.chance(0.5) ? 1 : -1;
    samples.points.push_back({random.between(0, 2), random.between(0, 1), up * thickness / 2});
    samples.normals.push_back({random.between(-0.2, 0.2), random.between(-0.2, 0.2), up});
  }
  return samples;
}

/// Returns points in a box, with normals that mostly point up.
Samples in_box(std::size_t count, double height) {
  Random random(34);
  Samples samples;
  while (samples.points.size() < count) {
    samples.points.push_back({random.between(0, 1), random.between(0, 1), random.between(0, height)});
    samples.normals.push_back({random.between(-1, 1), random.between(-1, 1), random.between(-0.2, 1)});
  }
  return samples;
}

/// Returns integer points on the sides of a box, with outward normals, some of them twice.
Samples box_of_integers(int columns, int rows, int layers) {
  const auto side = [](int i, int last) { return i == 0 ? -1.0 : i == last ? 1.0 : 0.0; };
  Samples samples;
  for (int x = 0; x <= columns; ++x)
    for (int y = 0; y <= rows; ++y)
      for (int z = 0; z <= layers; ++z) {
        const Point3 n = {side(x, columns), side(y, rows), side(z, layers)};
        if (n == Point3{}) continue;
        for (int copies = (x + y + z) % 5 == 0 ? 2 : 1; copies > 0; --copies) {
          samples.points.push_back({double(x), double(y), double(z)});
          samples.normals.push_back(n);
        }
      }
  return samples;
}

/// Returns radii from below the spacing to many times it.
const std::vector<double>& radii() {
  static const std::vector<double> pitches = {0.4, 0.7, 1.0, 2.0, 5.0, 12.0};
  return pitches;
}

void check_radii(const Samples& samples) {
  const double pitch = spacing(samples.points);
  std::size_t triangles = 0;
  for (const double r : radii()) {
    CAPTURE(r);
    triangles += check(samples.points, samples.normals, r * pitch);
  }
  CHECK(2 * triangles > samples.points.size());
}

}  // namespace

TEST_CASE("small sets of every kind have the exposed triangles, pivots and surface of CGAL's alpha complex") {
  const std::uint64_t trials = argument("count", 2000) / space_kinds;
  std::size_t triangles = 0, agreed = 0, compared = 0;
  for (int k = 0; k < space_kinds; ++k) {
    Random random(100 + static_cast<std::uint64_t>(k));
    CAPTURE(name(static_cast<SpaceKind>(k)));
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
      const Points3 points = space_set(static_cast<SpaceKind>(k), 1 + random.below(24), random);
      const double radius = space_radius(points, random);
      const Surface actual = rbpa::exposed_triangles(points, radius);
      const ExposedByCgal expected = exposed_by_delaunay(points, radius);
      if (!same(actual, expected)) FAIL_CHECK(text(points, radius));
      triangles += expected.triangles.size();
      Points3 normals = random_normals(points.size(), random);
      if (random.chance(0.5))
        for (Point3& n : normals) n.z += 2.5;
      const ExposedByCgal agree = agreeing(expected, points, normals);
      if (!same(rbpa::surface(points, normals, radius), agree)) FAIL_CHECK(text(points, radius));
      agreed += agree.triangles.size();
      if (trial % 8 != 0) continue;
      const auto shape = exposed_by_alpha_shape(points, radius);
      if (shape.empty()) continue;  // it has none of points in a plane
      ++compared;
      if (actual.triangles != shape) FAIL_CHECK(text(points, radius));
    }
  }
  CHECK(triangles > 10 * trials);
  CHECK(agreed > 3 * trials);
  CHECK(compared > trials / 4);
}

TEST_CASE("integer grids at exactly critical radii have CGAL's exposed triangles") {
  for (const int columns : {3, 5}) {
    Points3 points;
    for (int x = 0; x < columns; ++x)
      for (int y = 0; y < columns; ++y)
        for (int z = 0; z < columns; ++z) points.push_back({2.0 * x, 4.0 * y, 4.0 * z});  // with diagonals of length 6
    for (const double radius : {1.0, 2.0, 2.5, 3.0, 4.0}) check(points, radius);
    Random random(5);
    random.shuffle(points);
    points.resize(points.size() * 2 / 3);
    for (const double radius : {1.0, 2.0, std::sqrt(5), 3.0, 4.5, 6.0, 20.0}) check(points, radius);
  }
}

TEST_CASE("smooth and noisy spheres have CGAL's surface, at radii from below the spacing to many times it") {
  const std::size_t count = argument("points", 400);
  const double pitch = std::sqrt(4 * 3.14159 / static_cast<double>(count));
  for (const double noise : {0.0, 0.1 * pitch, pitch, 2 * pitch}) {
    const Samples sphere = on_sphere(count, noise, 9);
    for (const double r : radii()) check(sphere.points, sphere.normals, r * pitch);
  }
}

TEST_CASE("cubes, slabs, tori and thin plates have CGAL's surface, at radii from below the spacing to many times it") {
  const std::size_t count = argument("points", 400);
  check_radii(in_box(count, 1));
  check_radii(in_box(count, 0.05));
  check_radii(on_torus(count));
  check_radii(on_double_torus(count));
  for (const double thickness : {0.0, 1e-6, 0.01, 0.1}) check_radii(plate(count, thickness));
}

TEST_CASE("boxes of integer points with duplicates have CGAL's surface, at critical radii and next to them") {
  const Samples box = box_of_integers(6, 4, 3);
  for (const double radius : {0.5, std::sqrt(0.5), 1.0, 1.5, 2.0, 2.5, 3.0, 4.5})
    for (const double r : {radius, std::nextafter(radius, 0), std::nextafter(radius, 9)})
      check(box.points, box.normals, r);
}

TEST_CASE("a set has CGAL's surface at 1e150 and at 1e-150") {
  const Samples sphere = on_sphere(argument("points", 400) / 4, 0.05, 10), box = box_of_integers(3, 3, 2);
  for (const double scale : {1e150, 1e-150})
    for (const Samples* samples : {&sphere, &box}) {
      Points3 points;
      for (const Point3& p : samples->points) points.push_back({scale * p.x, scale * p.y, scale * p.z});
      for (const double radius : {0.4, 1.0, 3.0}) check(points, samples->normals, scale * radius);
    }
}

TEST_CASE("further scans and models have the exposed triangles and surfaces of CGAL's triangulation") {
  for (const Scan& scan : further_scans(argument("smallest", 0), argument("largest", 1000))) {
    CAPTURE(scan.name);
    const double pitch = spacing(scan.points);
    for (const double r : {0.4, 0.8, 1.5, 3.0, 8.0}) {
      CAPTURE(r);
      if (scan.normals.size() == scan.points.size())
        check(scan.points, scan.normals, r * pitch);
      else
        check(scan.points, r * pitch);
    }
  }
}

TEST_CASE("further scans by two radii have at most the boundary of the first, except those that it does not cover") {
  const auto boundary = [](const Surface& surface) {
    std::size_t count = 0;
    for (const auto& n : surface.neighbors)
      count += static_cast<std::size_t>(std::count(n.begin(), n.end(), Surface::none));
    return count;
  };
  for (const Scan& scan : further_scans(argument("smallest", 0), argument("largest", 1000))) {
    CAPTURE(scan.name);
    if (scan.normals.size() != scan.points.size()) continue;
    const double pitch = spacing(scan.points);
    const std::vector<double> radii = {1.5 * pitch, 3 * pitch};
    const Surface first = rbpa::surface(scan.points, scan.normals, radii[0]),
                  both = rbpa::surface(scan.points, scan.normals, radii);
    CHECK(std::includes(both.triangles.begin(), both.triangles.end(), first.triangles.begin(), first.triangles.end()));
    // docs/explanation/surfaces.md, section 4.
    static const std::vector<std::string> not_covered = {"c3_cilantro_frame1", "c3_lpm_car400", "m3_plate_holes"};
    const bool is_covered = std::find(not_covered.begin(), not_covered.end(), scan.name) == not_covered.end();
    CHECK((boundary(both) <= boundary(first)) == is_covered);
    // Each side of the boundary is explained.
    std::size_t sides = 0;
    for (const rbpa::Hole& hole : rbpa::holes(scan.points, scan.normals, radii, both)) sides += hole.edges.size();
    CHECK(sides == boundary(both));
  }
}

TEST_CASE("the oracles detect wrong results") {
  const Samples sphere = on_sphere(50, 0, 3);
  const Points3& points = sphere.points;
  const Surface exposed = rbpa::exposed_triangles(points, 0.5);
  REQUIRE(exposed.triangles.size() > 50);
  auto wrong = exposed.triangles;
  std::swap(wrong.back()[1], wrong.back()[2]);
  CHECK(difference(exposed_by_delaunay(points, 0.5).triangles, canonical(wrong)) != "");
  CHECK(exposed_by_alpha_shape(points, 0.5) == exposed.triangles);
  CHECK(exposed_by_alpha_shape(points, 0.5) != canonical(wrong));
  CHECK(exposed_by_delaunay(points, 0.4).triangles != exposed.triangles);
  const ExposedByCgal expected = exposed_by_delaunay(points, 0.5), outside = agreeing(expected, points, sphere.normals);
  CHECK(outside.triangles.size() * 2 == expected.triangles.size());
  Points3 turned = sphere.normals;
  turned[outside.triangles[0][0]] = {-turned[outside.triangles[0][0]].x, 0, 0};
  CHECK(agreeing(expected, points, turned).triangles.size() < outside.triangles.size());
}
