// Prints how many estimated normals are on the right side, and how many of the others are marked as doubtful: bodies,
// sheets and nested bodies with normals by formulas, then scans and models of the further data, as a table. Its cases
// are in docs/explanation/surfaces.md, section 3. A set is the same in each run, but for the last bits of sines.
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <utility>

#include "bench/options.h"
#include "bench/tables.h"
#include "rbpa/space/normals/estimate_normals.h"
#include "support/data_folder.h"
#include "support/random.h"
#include "support/vectors.h"

namespace rbpa_bench {
namespace {

using namespace rbpa_test;
using rbpa::Point3;

/// Points in space; normals point outward, on sheets upward.
struct KnownNormals {
  std::string name;
  std::vector<Point3> points = {}, normals = {};
};

constexpr double pi = std::numbers::pi;

/// Adds points p + d n, where d is noise.
struct Adder {
  KnownNormals& known;
  double noise;
  Random random;

  void add(const Point3& p, const Point3& n) {
    const double size = length(n), d = noise > 0 ? noise * random.between(-1, 1) / size : 0;
    known.points.push_back(p + d * n);
    known.normals.push_back(n / size);
  }
  /// Returns a random direction.
  Point3 direction() {
    for (;;) {
      const Point3 p = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
      const double square = dot(p, p);
      if (square <= 1 && square >= 0.01) return p / std::sqrt(square);
    }
  }
};

/// Returns points on x²/a² + y²/b² + z²/c² = 1, evenly by area.
KnownNormals ellipsoid(const std::string& name, std::size_t count, const Point3& axes, double noise = 0) {
  KnownNormals known{.name = name};
  const double area =
      4 * pi *
      std::pow((std::pow(axes.x * axes.y, 1.6) + std::pow(axes.x * axes.z, 1.6) + std::pow(axes.y * axes.z, 1.6)) / 3,
               1 / 1.6);
  Adder to{known, noise * std::sqrt(area / static_cast<double>(count)), Random(1)};
  const double most = 1 / std::min({axes.x, axes.y, axes.z});
  while (known.points.size() < count) {
    const Point3 u = to.direction(), n = {u.x / axes.x, u.y / axes.y, u.z / axes.z};
    if (to.random.unit() * most < length(n)) to.add({axes.x * u.x, axes.y * u.y, axes.z * u.z}, n);
  }
  return known;
}

/// Returns points on a box with these sides, evenly by area, with sharp edges.
KnownNormals box(const std::string& name, std::size_t count, const Point3& sides) {
  KnownNormals known{.name = name};
  const double xy = sides.x * sides.y, xz = sides.x * sides.z, yz = sides.y * sides.z;
  Adder to{known, 0, Random(4)};
  while (known.points.size() < count) {
    const double which = to.random.between(0, xy + xz + yz), side = to.random.chance(0.5) ? 1 : -1;
    Point3 p = {sides.x * to.random.between(-0.5, 0.5), sides.y * to.random.between(-0.5, 0.5),
                sides.z * to.random.between(-0.5, 0.5)},
           n = {};
    if (which < xy) {
      p.z = side * sides.z / 2;
      n.z = side;
    } else if (which < xy + xz) {
      p.y = side * sides.y / 2;
      n.y = side;
    } else {
      p.x = side * sides.x / 2;
      n.x = side;
    }
    to.add(p, n);
  }
  return known;
}

/// Returns points on the intersection of two balls of radius 1: a ridge with the given angle, in degrees.
KnownNormals lens(const std::string& name, std::size_t count, double angle) {
  KnownNormals known{.name = name};
  Adder to{known, 0, Random(5)};
  const double off = std::cos(angle / 2 * pi / 180);  // distance of the centers from the plane between them
  while (known.points.size() < count) {
    const Point3 u = to.direction();
    if (std::abs(u.z) < off) continue;
    to.add({u.x, u.y, u.z - std::copysign(off, u.z)}, u);
  }
  return known;
}

/// Returns points on a shell: a ball and the surface of a cavity in it, whose normals point into the cavity.
KnownNormals shell() {
  KnownNormals known = ellipsoid("ball with a cavity", 15'000, {1, 1, 1});
  const KnownNormals inner = ellipsoid("", 5'000, {0.5, 0.5, 0.5});
  for (std::size_t i = 0; i < inner.points.size(); ++i) {
    const Point3& n = inner.normals[i];
    known.points.push_back(inner.points[i]);
    known.normals.push_back({-n.x, -n.y, -n.z});
  }
  return known;
}

/// Returns the sets by formulas. Noise is in spacings, along the normal.
std::vector<KnownNormals> bodies_with_normals() {
  return {ellipsoid("sphere, noise 1", 20'000, {1, 1, 1}, 1),
          ellipsoid("sphere, noise 2", 20'000, {1, 1, 1}, 2),
          box("plate of a hundredth", 20'000, {1, 1, 0.01}),
          ellipsoid("ellipsoid 1, 0.25, 0.005", 15'000, {1, 0.25, 0.005}),
          lens("lens, ridge of 60 degrees", 10'000, 60),
          shell()};
}

/// Returns the sets of the further data that have normals, if there are any.
std::vector<KnownNormals> scans_with_normals() {
  std::vector<KnownNormals> all;
  for (const char* name :
       {"c3_cilantro_frame1", "c3_hammer", "c3_lpm_car400", "c3_nefertiti", "c3_pcl_tum_rabbit", "m3_bob",
        "m3_human_woman", "m3_plane_holes", "m3_plate_holes", "m3_quadknot", "m3_spot", "m3_torus", "m3_wingnut"}) {
    KnownNormals known{.name = name};
    std::ifstream file(rbpa_test::further_data() / (std::string(name) + ".xyz"));
    for (std::string line; std::getline(file, line);) {
      std::istringstream numbers(line);
      Point3 p, n;
      if (!(numbers >> p.x >> p.y >> p.z >> n.x >> n.y >> n.z) || n == Point3{}) continue;
      known.points.push_back(p);
      known.normals.push_back(n);
    }
    if (!known.points.empty()) all.push_back(std::move(known));
  }
  return all;
}

void row(const KnownNormals& known) {
  const rbpa::EstimatedNormals found = rbpa::estimate_normals_and_confidence(known.points);
  std::size_t count = 0, wrong = 0, sure = 0, wrong_sure = 0;
  double angle = 0;
  for (std::size_t i = 0; i < known.points.size(); ++i) {
    const Point3 &n = found.normals[i], &m = known.normals[i];
    if (m == Point3{}) continue;
    const double along = dot(n, m) / length(m);
    const bool is_wrong = along <= 0, is_sure = found.confidence[i] >= rbpa::least_confidence;
    ++count;
    wrong += is_wrong;
    sure += is_sure;
    wrong_sure += is_wrong && is_sure;
    angle += std::acos(std::min(1.0, std::abs(along))) * 180 / pi;
  }
  const auto percent = [&](std::size_t part) { return 100.0 * static_cast<double>(part) / static_cast<double>(count); };
  print_row({known.name, text("%zu", count), text("%.2f", percent(count - wrong)),
             text("%.1f", angle / static_cast<double>(count)), text("%.2f", percent(count - sure)), text("%zu", wrong),
             text("%zu", wrong_sure)});
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  read_options(argc, argv, {});
  print_head({"points"}, {"", "right side, %", "off, degrees", "in doubt, %", "wrong side", "of these sure"});
  for (const KnownNormals& known : bodies_with_normals()) row(known);
  for (const KnownNormals& known : scans_with_normals()) row(known);
}
