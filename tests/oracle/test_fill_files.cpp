// Checks `rbpa fill` on whole files: on all output of `rbpa shape`, and on polygons from elsewhere. No polygon that
// GEOS calls valid is refused; areas are those of GEOS, and every edge of the file is a row of edges of triangles.
//   --largest=N   only files with at most that many points
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "apps/support/program.h"
#include "io/failure.h"
#include "io/formats.h"
#include "io/polygon/read_polygons.h"
#include "oracle/geos_geometry.h"
#include "oracle/rational.h"
#include "support/arguments.h"
#include "support/data_folder.h"
#include "support/read_points.h"
#include "support/spacing.h"

namespace rbpa_test {
namespace {

using apps_test::Folder;
using apps_test::Outcome;
using rbpa::Point;
using rbpa::Polygon;
using rbpa::Ring;
using rbpa::app::PolygonFile;

std::string shortest(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

double distance(const Point& a, const Point& b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// Decides exactly.
bool are_on_a_line(const Point& a, const Point& b, const Point& c) {
  return (rational(b.x) - rational(a.x)) * (rational(c.y) - rational(a.y)) ==
         (rational(b.y) - rational(a.y)) * (rational(c.x) - rational(a.x));
}

/// Output of a run.
struct Triangles {
  Points points;
  std::vector<std::array<std::uint32_t, 3>> corners = {};

  explicit Triangles(const std::string& off) {
    std::istringstream words(off);
    std::string magic;
    std::size_t n = 0, faces = 0, rest = 0;
    words >> magic >> n >> faces >> rest;
    points.resize(n);
    for (Point& p : points) words >> p.x >> p.y >> rest;
    corners.resize(faces);
    for (auto& [a, b, c] : corners) words >> rest >> a >> b >> c;
    REQUIRE(words);
  }

  double area() const {
    double twice = 0;
    for (const auto& [a, b, c] : corners) {
      const Point &p = points[a], &q = points[b], &r = points[c];
      twice += (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    }
    return twice / 2;
  }
};

/// The edges of triangles, and paths along them.
class Edges {
 public:
  explicit Edges(const Triangles& triangles) {
    std::vector<std::uint32_t> number;
    for (const Point& p : triangles.points) {  // several points may be at one place
      const auto [at, is_new] = number_.emplace(p, static_cast<std::uint32_t>(places_.size()));
      if (is_new) places_.push_back(p);
      number.push_back(at->second);
    }
    beside_.resize(places_.size());
    for (const auto& corner : triangles.corners)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = number[corner[k]], b = number[corner[(k + 1) % 3]];
        beside_[a].push_back(b);
        beside_[b].push_back(a);
      }
  }

  /// Returns whether edges lead straight from one place to the other. The points between lie exactly on the line, or,
  /// where edges were cut, as near to it as doubles allow.
  bool lead(const Point& a, const Point& b, bool exactly) const {
    const auto from = number_.find(a), to = number_.find(b);
    if (from == number_.end() || to == number_.end()) return false;
    const double far = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)}), length = distance(a, b);
    const auto along = [&](const Point& p) { return ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length; };
    const auto is_on = [&](const Point& p) {
      const double off = std::abs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length;
      return off <= 4 * 0x1p-53 * far && (!exactly || are_on_a_line(a, b, p));
    };
    std::vector<std::uint32_t> open = {from->second};
    while (!open.empty()) {
      const std::uint32_t at = open.back();
      open.pop_back();
      if (at == to->second) return true;
      for (const std::uint32_t next : beside_[at])
        if (next == to->second ||
            (along(places_[next]) > along(places_[at]) && along(places_[next]) < length && is_on(places_[next])))
          open.push_back(next);
    }
    return false;
  }

 private:
  std::map<Point, std::uint32_t> number_ = {};
  Points places_ = {};
  std::vector<std::vector<std::uint32_t>> beside_ = {};
};

/// The features of a file that GEOS calls valid, and their area.
struct Valid {
  std::vector<Polygon> polygons = {};
  std::size_t left_out = 0;  // number of features
  double area = 0, perimeter = 0;

  explicit Valid(const PolygonFile& file) {
    for (std::size_t g = 0; g < file.geometries.size();) {
      const std::size_t feature = file.geometries[g].feature;
      std::vector<Polygon> whole;
      std::string invalid;
      double its_area = 0, its_perimeter = 0;
      for (; g < file.geometries.size() && file.geometries[g].feature == feature; ++g) {
        const std::size_t end =
            g + 1 < file.geometries.size() ? file.geometries[g + 1].first_polygon : file.polygons.size();
        const std::vector<Polygon> part(
            file.polygons.begin() + static_cast<std::ptrdiff_t>(file.geometries[g].first_polygon),
            file.polygons.begin() + static_cast<std::ptrdiff_t>(end));
        const GeosGeometry geometry = GeosGeometry::of(part, file.vertices.points);
        if (invalid.empty()) invalid = geometry.invalid();
        its_area += geometry.area();
        its_perimeter += geometry.perimeter();
        whole.insert(whole.end(), part.begin(), part.end());
      }
      left_out += !invalid.empty();
      if (!invalid.empty()) continue;
      polygons.insert(polygons.end(), whole.begin(), whole.end());
      area += its_area;
      perimeter += its_perimeter;
    }
  }
};

std::size_t count_of(const std::string& report, const std::string& what) {
  const std::size_t at = report.find("\"" + what + "\":");
  REQUIRE(at != std::string::npos);
  return std::stoul(report.substr(at + what.size() + 3));
}

/// Checks a run with a size, which GEOS does not have; infinity is "inf".
void check_fill(const Folder& folder, const std::string& path, const PolygonFile& file, const Valid& valid,
                const std::string& size) {
  INFO("size ", size);
  const Outcome outcome =
      folder.rbpa("fill '" + path + "' --size " + size + " --skip-invalid -o m.off --stats s.json -q");
  REQUIRE_MESSAGE(outcome.code == 0, outcome.err);
  CHECK(count_of(folder.content("s.json"), "invalid_features") == valid.left_out);
  const Triangles triangles(folder.content("m.off"));
  double far = 0;
  for (const Point& p : file.vertices.points) far = std::max({far, std::abs(p.x), std::abs(p.y)});
  // If an area is small compared with the coordinates, GEOS is not more precise than this.
  CHECK(std::abs(triangles.area() - valid.area) <= std::max(1e-9 * valid.area, 0x1p-50 * far * valid.perimeter));
  const Edges edges(triangles);
  const auto check_ring = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      const Point& a = file.vertices.points[ring.points[i]];
      const Point& b = file.vertices.points[ring.points[(i + 1) % ring.points.size()]];
      if (a == b || edges.lead(a, b, size == "inf")) continue;
      FAIL_CHECK("no edges of triangles lead from ", shortest(a.x), " ", shortest(a.y), " to ", shortest(b.x), " ",
                 shortest(b.y));
    }
  };
  for (const Polygon& polygon : valid.polygons) {
    check_ring(polygon.shell);
    for (const Ring& hole : polygon.holes) check_ring(hole);
  }
}

PolygonFile read(const std::string& path) {
  return rbpa::app::read_polygons(path,
                                  *rbpa::app::find_format(rbpa::app::Use::polygons, rbpa::app::input_ending(path)));
}

/// Checks runs without new points, and with few points inside.
void check_file(const Folder& folder, const std::string& path) {
  const PolygonFile file = read(path);
  const Valid valid(file);
  check_fill(folder, path, file, valid, "inf");
  Point low{0, 0}, high{0, 0};
  for (std::size_t i = 0; i < file.vertices.points.size(); ++i) {
    const Point& p = file.vertices.points[i];
    low = i == 0 ? p : Point{std::min(low.x, p.x), std::min(low.y, p.y)};
    high = i == 0 ? p : Point{std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  if (low != high) check_fill(folder, path, file, valid, shortest(distance(low, high) / 40));
}

std::size_t check_shapes(const std::filesystem::path& folder_of_points) {
  const auto largest = static_cast<std::size_t>(argument("largest", 1500));
  std::size_t shapes = 0;
  for (const PointFile& file : point_files(folder_of_points)) {
    const Points points = read_points(file);
    if (points.size() > largest) continue;
    std::string text;
    for (const Point& p : points) text += shortest(p.x) + " " + shortest(p.y) + "\n";
    const Folder folder;
    folder.file("p.xy", text);
    const double spacing = mean_spacing(points);
    for (const std::string& alpha : {std::string("plateau"), shortest(0.7 * spacing), shortest(1.4 * spacing)}) {
      INFO(file.name, ", alpha ", alpha);
      const Outcome outcome = folder.rbpa("shape p.xy --alpha " + alpha + " -o s.wkt -q");
      REQUIRE_MESSAGE(outcome.code == 0, outcome.err);
      check_file(folder, folder.path("s.wkt"));
      ++shapes;
    }
  }
  return shapes;
}

TEST_CASE("rbpa fill fills the shapes that rbpa shape writes of bundled point files") {
  CHECK(check_shapes(bundled_data()) > 40);
}

TEST_CASE("further point files have shapes that rbpa fill fills") {
  CHECK((check_shapes(further_data()) > 0) == has_further_data());
}

/// Returns whether a .poly file has lines in a polygon that bound no hole. fill leaves them out; for GEOS they are no
/// polygons either.
bool has_lines_inside(const std::string& path) {
  try {
    read(path);
  } catch (const rbpa::app::BadInput& e) {
    CHECK(std::string(e.what()).find("lines inside") != std::string::npos);
    return true;
  }
  return false;
}

TEST_CASE("further polygons are filled, except those that GEOS calls invalid") {
  const auto largest = argument("largest", 1500);
  if (!has_further_data()) return;
  for (const auto& entry : std::filesystem::directory_iterator(further_data())) {
    const std::string path = entry.path().string(), name = entry.path().filename().string();
    if (!name.starts_with("poly_")) continue;
    INFO(name);
    if (has_lines_inside(path) || read(path).vertices.points.size() > largest) continue;
    check_file(Folder(), path);
  }
}

}  // namespace
}  // namespace rbpa_test
