// `rbpa mesh --complex full`: its files against the definition and against persistence, and wrong usage.
#include <doctest/doctest.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "io/mesh/read_mesh.h"
#include "support/program.h"
#include "support/random.h"

using namespace apps_test;

namespace {

using Edge = std::array<std::uint32_t, 2>;
using Triangle = std::array<std::uint32_t, 3>;

/// A complex as read from its files.
struct Full {
  std::set<Triangle> triangles;
  std::set<Edge> edges;
  std::set<std::uint32_t> points;
  friend bool operator==(const Full&, const Full&) = default;
};

struct Grid {
  std::int64_t x, y;
};
using Wide = std::int64_t;  // enough for coordinates below 1000 and radii up to 1500

Wide square(const Grid& a, const Grid& b) { return Wide(a.x - b.x) * (a.x - b.x) + Wide(a.y - b.y) * (a.y - b.y); }
Wide cross(const Grid& a, const Grid& b, const Grid& c) {
  return Wide(b.x - a.x) * (c.y - a.y) - Wide(b.y - a.y) * (c.x - a.x);
}
/// Returns a number > 0 if p is inside the circle through a, b, c. Requires: these are counter-clockwise.
Wide in_circle(const Grid& a, const Grid& b, const Grid& c, const Grid& p) {
  const Wide ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y, cx = c.x - p.x, cy = c.y - p.y;
  return (ax * ax + ay * ay) * (bx * cy - cx * by) - (bx * bx + by * by) * (ax * cy - cx * ay) +
         (cx * cx + cy * cy) * (ax * by - bx * ay);
}

/// Returns random integer points below 1000.
std::vector<Grid> scattered(std::size_t count, std::uint64_t seed) {
  rbpa_test::Random random(seed);
  std::vector<Grid> points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<std::int64_t>(random.below(1000));
    points.push_back({x, static_cast<std::int64_t>(random.below(1000))});
  }
  return points;
}

std::string text_of(const std::vector<Grid>& points) {
  std::string text;
  for (const Grid& p : points) text += std::to_string(p.x) + " " + std::to_string(p.y) + "\n";
  return text;
}

/// Returns all edges, in triangles or not.
std::set<Edge> all_edges(const Full& full) {
  std::set<Edge> edges = full.edges;
  for (const Triangle& t : full.triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.insert({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
  return edges;
}

/// Returns whether no other point has a positive power. Requires: none has power 0, that is, is on the circle.
template <typename Power>
bool is_empty(const std::vector<Grid>& points, std::size_t own, const Power& power) {
  std::size_t on_circle = 0;
  for (const Grid& p : points) {
    if (power(p) > 0) return false;
    on_circle += power(p) == 0;
  }
  REQUIRE(on_circle == own);
  return true;
}

/// Returns the alpha complex by its definition: triangles and edges with an empty circle of radius at most alpha.
Full by_definition(const std::vector<Grid>& points, std::int64_t alpha) {
  Full full;
  const auto n = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    full.points.insert(i);
    for (std::uint32_t j = i + 1; j < n; ++j)
      for (std::uint32_t k = i + 1; k < n; ++k) {
        const Grid &a = points[i], &b = points[j], &c = points[k];
        const Wide area = cross(a, b, c);
        if (area <= 0 || square(a, b) * square(b, c) * square(c, a) > 4 * area * area * alpha * alpha) continue;
        if (is_empty(points, 3, [&](const Grid& p) { return in_circle(a, b, c, p); })) full.triangles.insert({i, j, k});
      }
  }
  const std::set<Edge> in_triangles = all_edges(full);
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = i + 1; j < n; ++j) {
      const Grid &a = points[i], &b = points[j];
      const auto power = [&](const Grid& p) { return (a.x - p.x) * (p.x - b.x) + (a.y - p.y) * (p.y - b.y); };
      if (!in_triangles.contains({i, j}) && square(a, b) <= 4 * alpha * alpha && is_empty(points, 2, power))
        full.edges.insert({i, j});
    }
  for (const Edge& edge : all_edges(full))
    for (const std::uint32_t i : edge) full.points.erase(i);
  return full;
}

/// Reads the lines f, l and p of an OBJ file.
Full in_obj(const std::string& text) {
  Full full;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind;
    std::uint32_t a = 0, b = 0, c = 0;
    words >> kind;
    if (kind == "f" && words >> a >> b >> c) CHECK(full.triangles.insert({a - 1, b - 1, c - 1}).second);
    if (kind == "l" && words >> a >> b) CHECK(full.edges.insert({a - 1, b - 1}).second);
    if (kind == "p" && words >> a) CHECK(full.points.insert(a - 1).second);
    if (kind == "v") continue;
    CHECK((kind == "f" || kind == "l" || kind == "p"));
    CHECK((words >> kind).fail());  // nothing is left of the line
  }
  return full;
}

/// Returns the values of an .npy file of uint32. Checks its shape.
std::vector<std::uint32_t> in_npy(const std::string& bytes, const std::string& shape) {
  CHECK(bytes.find("{'descr': '<u4', 'fortran_order': False, 'shape': " + shape + ", }") == 10);
  const std::size_t begin = bytes.find('\n') + 1;
  CHECK(begin % 64 == 0);
  std::vector<std::uint32_t> values((bytes.size() - begin) / 4);
  if (!values.empty()) std::memcpy(values.data(), bytes.data() + begin, 4 * values.size());
  return values;
}

Full in_arrays(const Folder& folder, const std::string& name, const Full& sizes) {
  Full full;
  const auto shape = [](std::size_t rows, const char* behind) {
    std::string text = "(";
    text += std::to_string(rows);
    return text += behind;
  };
  const auto t = in_npy(folder.content(name + ".npy"), shape(sizes.triangles.size(), ", 3)"));
  for (std::size_t i = 0; i + 3 <= t.size(); i += 3) full.triangles.insert({t[i], t[i + 1], t[i + 2]});
  const auto e = in_npy(folder.content(name + ".edges.npy"), shape(sizes.edges.size(), ", 2)"));
  for (std::size_t i = 0; i + 2 <= e.size(); i += 2) full.edges.insert({e[i], e[i + 1]});
  const auto p = in_npy(folder.content(name + ".points.npy"), shape(sizes.points.size(), ",)"));
  full.points.insert(p.begin(), p.end());
  return full;
}

std::size_t count_of(const std::string& text, const std::string& piece) {
  std::size_t count = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++count;
  return count;
}

/// Returns the number of pixels of this color.
std::size_t count_of_color(const std::string& png, const std::array<std::uint8_t, 3>& color) {
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&image, png.data(), png.size()) != 0);
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
  REQUIRE(png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr) != 0);
  std::size_t count = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 3)
    count += std::equal(color.begin(), color.end(), bytes.begin() + static_cast<std::ptrdiff_t>(i)) ? 1U : 0U;
  return count;
}

/// Returns the path of this name in a picture.
std::string path_of(const std::string& svg, const std::string& id) {
  const std::size_t at = svg.find("<path id=\"" + id + "\"");
  if (at == std::string::npos) return "none";
  const std::size_t begin = svg.find(" d=\"", at) + 4;
  return svg.substr(begin, svg.find('"', begin) - begin);
}

const std::string data = "'" RBPA_TEST_DATA "/shape_hdbscan_clusterable.xy' ";

/// A triangle with a tail, an edge, a point, and its duplicate.
constexpr const char* small = "0 0\n2 0\n0 2\n4 0\n9 9\n9 11\n20 0\n20 0\n";

}  // namespace

TEST_SUITE("full complex") {
  TEST_CASE("the files have the alpha complex, by its definition") {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      const std::vector<Grid> points = scattered(40, seed);
      const Folder folder("p.xy", text_of(points));
      for (const int alpha : {1, 20, 40, 60, 80, 100, 150, 300, 1500}) {
        CAPTURE(seed);
        CAPTURE(alpha);
        const Full expected = by_definition(points, alpha);
        REQUIRE(
            folder.rbpa("mesh p.xy --alpha " + std::to_string(alpha) + " --complex full -o m.obj -o m.npy -q").code ==
            0);
        CHECK(in_obj(folder.content("m.obj")) == expected);
        CHECK(in_arrays(folder, "m", expected) == expected);
      }
    }
  }

  TEST_CASE("it grows with alpha, and its triangles are the solid complex") {
    const Folder folder;
    Full before;
    for (const std::string alpha : {"1e-9", "0.003", "0.01", "0.02", "0.05", "0.2", "inf"}) {
      CAPTURE(alpha);
      REQUIRE(folder.rbpa("mesh " + data + "--alpha " + alpha + " --complex full -o f.obj -o f.npy -q").code == 0);
      REQUIRE(folder.rbpa("mesh " + data + "--alpha " + alpha + " --complex solid -o s.npy -o s.obj -q").code == 0);
      CHECK(folder.content("f.npy") == folder.content("s.npy"));
      CHECK(folder.content("f.obj").starts_with(folder.content("s.obj")));
      const Full now = in_obj(folder.content("f.obj"));
      const std::set<Edge> edges = all_edges(now), edges_before = all_edges(before);
      CHECK(
          std::includes(now.triangles.begin(), now.triangles.end(), before.triangles.begin(), before.triangles.end()));
      CHECK(std::includes(edges.begin(), edges.end(), edges_before.begin(), edges_before.end()));
      if (alpha != "1e-9")
        CHECK(std::includes(before.points.begin(), before.points.end(), now.points.begin(), now.points.end()));
      before = now;
    }
    CHECK(before.edges.empty());
    CHECK(before.points.empty());
  }

  TEST_CASE("solid is the default") {
    const Folder folder;
    REQUIRE(folder.rbpa("mesh " + data + "--alpha 0.02 -o a.obj -o a.svg -q").code == 0);
    REQUIRE(folder.rbpa("mesh " + data + "--alpha 0.02 --complex solid -o b.obj -o b.svg -q").code == 0);
    CHECK(folder.content("a.obj") == folder.content("b.obj"));
    CHECK(folder.content("a.svg") == folder.content("b.svg"));
  }

  TEST_CASE("its statistics are those of persistence") {
    const Folder folder;
    const auto diagram =
        nlohmann::json::parse(folder.rbpa("alpha " + data + "--json --persistence --complex full -q").out)["pairs"];
    for (const double alpha : {0.001, 0.005, 0.01, 0.02, 0.04, 0.1}) {
      CAPTURE(alpha);
      REQUIRE(folder.rbpa("mesh " + data + "--complex full --stats s.json -q --alpha " + std::to_string(alpha)).code ==
              0);
      const auto s = nlohmann::json::parse(folder.content("s.json"));
      std::array<std::size_t, 2> alive{};
      for (const auto& pair : diagram)
        if (pair["birth"] <= alpha && (pair["death"].is_null() || pair["death"] == "inf" || pair["death"] > alpha))
          ++alive[pair["dimension"].get<std::size_t>()];
      CHECK(s["components"] == alive[0]);
      CHECK(s["holes"] == alive[1]);
      CHECK(s["vertices"].get<long>() + s["isolated"].get<long>() == s["distinct"].get<long>());
      CHECK(s["components"].get<long>() - s["holes"].get<long>() ==
            s["distinct"].get<long>() - s["edges"].get<long>() + s["triangles"].get<long>());
      CHECK(s["dangling_edges"] <= s["edges"]);
    }
  }

  TEST_CASE("every line of a small file is written, and the summary is right") {
    const Folder folder("p.xy", small);
    const std::string vertices = "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 4 0 0\nv 9 9 0\nv 9 11 0\nv 20 0 0\n";
    const std::string rest = "f 1 2 3\nl 2 4\nl 5 6\np 7\n";
    Outcome outcome = folder.rbpa("mesh p.xy --alpha 1.5 --complex full -o - --output-format obj", 0);
    CHECK(outcome.out == vertices + "v 20 0 0\n" + rest);
    CHECK(outcome.err ==
          "rbpa: 8 points (1 duplicate), 1 triangle, 2 edges in no triangle, 1 point in neither -> standard output\n");
    outcome = folder.rbpa("mesh p.xy --alpha 1.5 --complex full --compact -o - --output-format obj -q");
    CHECK(outcome.out == vertices + rest);
    outcome = folder.rbpa("mesh p.xy --alpha 0.5 --complex full -o m.npy", 0);
    CHECK(outcome.err ==
          "rbpa: there is no triangle: no triangle has circumradius <= 0.5\n"
          "rbpa: 8 points (1 duplicate), 0 triangles, 0 edges in no triangle, 7 points in neither -> m.npy, "
          "m.edges.npy, m.points.npy\n");
    folder.file("line.xy", "0 0\n5 5\n1 1\n");
    outcome = folder.rbpa("mesh line.xy --alpha 1 --complex full --compact -o - --output-format obj -q");
    CHECK(outcome.out == "v 0 0 0\nv 5 5 0\nv 1 1 0\nl 1 3\np 2\n");
    CHECK(outcome.err == "rbpa: there is no triangle: all points are collinear\n");
  }

  TEST_CASE("a reader of faces finds the same faces") {
    const Folder folder;
    REQUIRE(folder.rbpa("mesh " + data + "--alpha 0.02 --complex full -o f.obj -q").code == 0);
    REQUIRE(folder.rbpa("mesh " + data + "--alpha 0.02 -o s.off -q").code == 0);
    const auto full = rbpa::app::read_mesh({folder.path("f.obj"), rbpa::app::Format::obj});
    const auto solid = rbpa::app::read_mesh({folder.path("s.off"), rbpa::app::Format::off});
    CHECK(full.positions == solid.positions);
    CHECK(full.soup.corners == solid.soup.corners);
  }

  TEST_CASE("pictures show edges as lines and points as dots") {
    const Folder folder("p.xy", small);
    REQUIRE(folder.rbpa("mesh p.xy --alpha 1.5 --complex full -o f.svg -o f.png -q").code == 0);
    REQUIRE(folder.rbpa("mesh p.xy --alpha 1.5 -o s.svg -o s.png -q").code == 0);
    const std::string full = folder.content("f.svg"), solid = folder.content("s.svg");
    CHECK(path_of(solid, "dangling") == "none");
    CHECK(count_of(path_of(full, "dangling"), "l") == 2);
    CHECK(count_of(path_of(solid, "isolated"), "h0") == 4);
    CHECK(count_of(path_of(full, "isolated"), "h0") == 1);
    for (const char* layer : {"solid", "edges", "boundary"}) CHECK(path_of(full, layer) == path_of(solid, layer));
    // The line is as dark as the boundary, and longer.
    CHECK(count_of_color(folder.content("f.png"), {0x10, 0x33, 0x5C}) >
          count_of_color(folder.content("s.png"), {0x10, 0x33, 0x5C}) + 100);
    // Without a triangle the width of lines follows these edges.
    folder.file("line.xy", "0 0\n1 0\n2 0\n");
    REQUIRE(folder.rbpa("mesh line.xy --alpha 1 --complex full -o l.svg -q").code == 0);
    CHECK(contains(folder.content("l.svg"),
                   "<path id=\"dangling\" fill=\"none\" stroke=\"#10335c\" stroke-width=\"2.2\""));
    // An edge too short to be visible is a dot, like a curve.
    folder.file("q.xy", "0 0\n1e-9 0\n1 1\n");
    REQUIRE(folder.rbpa("mesh q.xy --alpha 1e-9 --complex full -o q.svg -q").code == 0);
    CHECK(count_of(path_of(folder.content("q.svg"), "dangling"), "h0") == 1);
  }

  TEST_CASE("threads change nothing") {
    const Folder folder;
    REQUIRE(folder.rbpa("mesh " + data + "--alpha 0.02 --complex full --threads 1 -o a.obj -o a.png -q").code == 0);
    REQUIRE(folder.rbpa("mesh " + data + "--alpha 0.02 --complex full -o b.obj -o b.png -q").code == 0);
    CHECK(folder.content("a.obj") == folder.content("b.obj"));
    CHECK(folder.content("a.png") == folder.content("b.png"));
  }

  TEST_CASE("wrong usage is refused") {
    const Folder folder("p.xy", corner);
    refuses(folder, "mesh p.xy --alpha 1 --complex thick -o m.obj", 2,
            "--complex: found 'thick', expected solid or full");
    for (const std::string file : {"m.off", "m.ply"})
      refuses(folder, "mesh p.xy --alpha 1 --complex full -o m.obj -o " + file, 2,
              file +
                  ": found a format of triangles alone, expected one of obj, npy, vtu, svg, png for the edges and "
                  "points of --complex full (or --complex solid)");
    refuses(folder, "mesh p.xy --alpha 1 --complex full -o - --output-format npy", 2,
            "-o -: found standard output for the three .npy files of --complex full, expected a file name");
    refuses(folder, "mesh p.xy --alpha 1 --complex full --method hrbpa -o m.obj", 2,
            "--complex full requires --method rbpa");
    refuses(folder, "mesh p.xy --alpha 1 --complex full --search paper -o m.obj", 2,
            "--complex full requires --search near");
    refuses(folder, "mesh p.xy --alpha 1 --complex full --levels l.csv -o m.obj", 2,
            "--levels requires --method hrbpa");
    refuses(folder, "mesh p.xy --alpha 1 --complex full -o m.npy -o m.edges.npy", 2,
            "m.edges.npy: found twice among the files to write, expected once");
    folder.file("m.points.npy", "p");
    refuses(folder, "mesh m.points.npy --alpha 1 --complex full -o m.npy", 2,
            "m.points.npy: found the file of points, expected another file to write to");
  }

  TEST_CASE("files that accompany an array take its name without its ending") {
    const Folder folder("p.xy", small);
    CHECK(folder.rbpa("mesh p.xy --alpha 1.5 --complex full -o a.v1 -o b.NPY --output-format npy -q").code == 0);
    CHECK(folder.names() == std::vector<std::string>{"a.v1", "a.v1.edges.npy", "a.v1.points.npy", "b.NPY",
                                                     "b.edges.npy", "b.points.npy", "p.xy"});
  }
}
