// Ball pivoting on the advancing-front engine. Points on a torus become a closed surface of genus 1, points on a double
// torus a closed surface of genus 2. Other inputs are noise, a grid with many ties, and files of points with normals. A
// second radius closes the sparse half of a sphere. Each mesh is compared with rbpa::surface(), which has no front.
//   example_ball_pivoting [FILE.xyz RADIUS[,RADIUS...]]...
#include "examples/ball_pivoting.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <numbers>
#include <random>
#include <sstream>
#include <string>

#include "examples/surface_arrays.h"
#include "meshops/topology/report.h"
#include "rbpa/space/surface/surface_levels.h"

using meshops::Front;
using meshops::Site;
using rbpa::Point3;

namespace {

struct Samples {
  std::string name;
  std::vector<Point3> points, normals;
  std::vector<double> radii;  // ascending
};

double square(double x) { return x * x; }
double distance2(const Point3& p, const Point3& q) { return square(p.x - q.x) + square(p.y - q.y) + square(p.z - q.z); }

class Random {
 public:
  /// Returns a number from −1 to 1.
  double operator()() { return 2 * static_cast<double>(engine_()) / 0x1p32 - 1; }

 private:
  std::mt19937 engine_{1999};
};

/// Returns points at which f is 0, each at least `spacing` from every other, with the gradient of f as normal. The
/// points are random points, moved along the gradient.
template <typename Function>
Samples on_surface(const std::string& name, double size, double spacing, int trials, Function f) {
  Random random;
  Samples samples{name, {}, {}, {1.5 * spacing}};
  const auto slope = [&](const Point3& p) {
    constexpr double h = 1e-5;
    return Point3{(f(p.x + h, p.y, p.z) - f(p.x - h, p.y, p.z)) / (2 * h),
                  (f(p.x, p.y + h, p.z) - f(p.x, p.y - h, p.z)) / (2 * h),
                  (f(p.x, p.y, p.z + h) - f(p.x, p.y, p.z - h)) / (2 * h)};
  };
  for (int i = 0; i < trials; ++i) {
    Point3 p = {size * random(), size * random(), size * random()};
    for (int step = 0; step < 12; ++step) {
      const Point3 g = slope(p);
      const double s = f(p.x, p.y, p.z) / (g.x * g.x + g.y * g.y + g.z * g.z);
      p = {p.x - s * g.x, p.y - s * g.y, p.z - s * g.z};
    }
    if (!(std::abs(f(p.x, p.y, p.z)) < 1e-9)) continue;
    const auto is_near = [&](const Point3& q) { return distance2(p, q) < square(spacing); };
    if (std::ranges::any_of(samples.points, is_near)) continue;
    samples.points.push_back(p);
    samples.normals.push_back(slope(p));
  }
  return samples;
}

Samples torus() {
  return on_surface("torus", 1.5, 0.07, 100'000, [](double x, double y, double z) {
    const double out = std::hypot(x, y) - 1;
    return out * out + z * z - 0.16;
  });
}
/// Returns points on two merged tori.
Samples double_torus() {
  return on_surface("double torus", 2.5, 0.12, 100'000, [](double x, double y, double z) {
    const auto torus_at = [&](double center) { return std::hypot(std::hypot(x - center, y) - 1, z) - 0.35; };
    return -std::log(std::exp(-12 * torus_at(-1)) + std::exp(-12 * torus_at(1))) / 12;
  });
}

/// Returns a spiral of points on the unit sphere, each moved in or out by up to half of the spacing.
Samples noisy_sphere() {
  Random random;
  constexpr int count = 2000;
  const double spacing = std::sqrt(4 * std::numbers::pi / count);
  Samples samples{"noisy sphere", {}, {}, {1.5 * spacing}};
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, ring = std::sqrt(1 - z * z),
                 turn = i * std::numbers::pi * (3 - std::sqrt(5));
    const Point3 n = {ring * std::cos(turn), ring * std::sin(turn), z};
    const double out = 1 + spacing / 2 * random();
    samples.points.push_back({out * n.x, out * n.y, out * n.z});
    samples.normals.push_back(n);
  }
  return samples;
}

/// Returns integer points on the surface of a box, some of them twice, and a radius at which balls touch four points or
/// more.
Samples grid() {
  Samples samples{"grid", {}, {}, {1}};
  const auto side = [](int i, int last) { return i == 0 ? -1.0 : i == last ? 1.0 : 0.0; };
  for (int x = 0; x <= 12; ++x)
    for (int y = 0; y <= 9; ++y)
      for (int z = 0; z <= 6; ++z) {
        const Point3 n = {side(x, 12), side(y, 9), side(z, 6)};
        if (n == Point3{}) continue;
        for (int copies = (x + y + z) % 5 == 0 ? 2 : 1; copies > 0; --copies) {
          samples.points.push_back({double(x), double(y), double(z)});
          samples.normals.push_back(n);
        }
      }
  return samples;
}

/// Returns points on a sphere, five times as dense above the equator as below the equator, and a radius for each half.
Samples uneven_sphere() {
  Samples samples{"uneven sphere", {}, {}, {0.1, 0.25}};
  for (const double side : {-1, 1})
    for (int i = 0, count = side < 0 ? 300 : 1500; i < count; ++i) {
      const double z = side * (i + 0.5) / count, ring = std::sqrt(1 - z * z),
                   turn = i * std::numbers::pi * (3 - std::sqrt(5));
      samples.points.push_back({ring * std::cos(turn), ring * std::sin(turn), z});
    }
  samples.normals = samples.points;
  return samples;
}

/// Reads points and normals from a file: in each line x, y, z, and the three coordinates of the normal.
Samples of_file(const std::string& path, const std::string& radii) {
  Samples samples{path, {}, {}, {}};
  std::istringstream list(radii);
  for (std::string radius; std::getline(list, radius, ',');) samples.radii.push_back(std::stod(radius));
  std::ifstream file(path);
  for (Point3 p, n; file >> p.x >> p.y >> p.z >> n.x >> n.y >> n.z;) {
    samples.points.push_back(p);
    samples.normals.push_back(n);
  }
  return samples;
}

/// Runs ball pivoting, and returns whether the mesh equals that of rbpa::surface().
bool run(const Samples& samples) {
  OpenMesh::TriMesh_ArrayKernelT<> mesh;
  Front front(mesh, samples.points.size(), 4096);
  struct Refusals : meshops::FrontVisitor {
    std::size_t count = 0;
    void refused(const Front&, meshops::Halfedge, const meshops::Refusal&) { ++count; }
  } refusals;
  for (const double radius : samples.radii) {
    const rbpa::RollingBall ball(samples.points, samples.normals, radius);
    BallPivoting policy(ball, front, front.next_level().carried);
    meshops::advance(front, policy, refusals);
  }
  const std::vector<Site> site = front.finish();
  const meshops::TopologyReport topology = meshops::report(mesh, site);
  std::cout << samples.name << ": " << samples.points.size() << " points, " << topology.faces << " triangles, "
            << topology.components << " components, " << topology.boundary_curves << " boundary curves, "
            << refusals.count << " refusals";
  if (topology.genus) std::cout << ", genus " << *topology.genus;
  const rbpa::Surface found = arrays(front, site);
  const rbpa::Surface expected = rbpa::surface(samples.points, samples.normals, samples.radii);
  const bool same =
      found.triangles == expected.triangles && found.neighbors == expected.neighbors && found.levels == expected.levels;
  std::cout << (same ? "; the mesh of rbpa::surface()\n" : "; another mesh than rbpa::surface()\n");
  return same;
}

}  // namespace

int main(int argc, char** argv) {
  const bool asks_for_help = argc == 2 && std::string(argv[1]) == "--help";
  if (argc % 2 == 0 || argv[argc - 1][0] == '-') {
    (asks_for_help ? std::cout : std::cerr) << "usage: example_ball_pivoting [FILE.xyz RADIUS[,RADIUS...]]...\n";
    return asks_for_help ? 0 : 2;
  }
  std::vector<Samples> all = {torus(), double_torus(), noisy_sphere(), grid(), uneven_sphere()};
  for (int i = 1; i + 1 < argc; i += 2) all.push_back(of_file(argv[i], argv[i + 1]));
  bool same = true;
  for (const Samples& samples : all) same = run(samples) && same;
  return same ? 0 : 1;
}
