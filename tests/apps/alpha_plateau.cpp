// Plateaus: the recommendation of `rbpa alpha`, and `--alpha plateau[:K]`.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/program.h"
#include "support/radii.h"

using namespace apps_test;
using Json = nlohmann::json;

namespace {

const std::string quakes = "'" RBPA_TEST_DATA "/geo_usgs_quakes_week.xy' ";

/// Two squares of 10 × 10 points, 20 apart, and one point far from both.
std::string two_squares() {
  std::string points = "5000 5000\n";
  for (const int left : {0, 29})
    for (int x = 0; x < 10; ++x)
      for (int y = 0; y < 10; ++y) points += std::to_string(left + x) + " " + std::to_string(y) + "\n";
  return points;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_SUITE("alpha plateau") {
  TEST_CASE("the plateau of the footprint is named for unevenly dense points only") {
    const Folder folder;
    std::mt19937 random(1);
    const auto jitter = [&] { return static_cast<double>(random() % 1000) / 4000; };
    std::string even, uneven;
    for (int x = 0; x < 60; ++x)
      for (int y = 0; y < 60; ++y) even += std::to_string(x + jitter()) + " " + std::to_string(y + jitter()) + "\n";
    uneven = even;
    for (int x = 0; x < 10; ++x)  // far apart, as between the lines of a scanner
      for (int y = 0; y < 4; ++y)
        for (const auto& [i, j] : {std::pair(0, 0), {1, 0}, {0, 1}})
          uneven += std::to_string(68 + 12 * x + i) + " " + std::to_string(12 * y + j) + "\n";
    folder.file("even.xy", even);
    folder.file("uneven.xy", uneven);
    const std::string advice = "for the footprint of a scan take --alpha plateau:2\n";
    const Outcome shape = folder.rbpa("shape uneven.xy --alpha plateau -o u.wkt");
    CHECK(shape.err.starts_with("rbpa: --alpha plateau: at "));
    CHECK(contains(shape.err, " there are 41 parts, as points are not evenly dense, and at plateau:2, which is "));
    CHECK(contains(shape.err, advice));
    CHECK(contains(folder.rbpa("alpha uneven.xy").out, "for the footprint of a scan take --alpha plateau:2.\n"));
    CHECK(folder.rbpa("shape uneven.xy --alpha plateau -o u.wkt -q").err.empty());
    CHECK(!contains(folder.rbpa("shape uneven.xy --alpha plateau:2 -o u.wkt").err, "evenly"));
    CHECK(!contains(folder.rbpa("shape even.xy --alpha plateau -o u.wkt").err, "evenly"));
    CHECK(!contains(folder.rbpa("alpha even.xy").out, "evenly"));
  }

  TEST_CASE("--alpha plateau warns only when no plateau stands out") {
    const Folder folder({{"p.xy", corner}, {"two.xy", two_squares()}});
    const std::string words =
        "rbpa: --alpha plateau: no range of alpha stands out, and the longest one may be chance (rbpa alpha POINTS "
        "shows the choices, and recommends auto)\n";
    CHECK(folder.rbpa("shape p.xy --alpha plateau -o s.wkt").err.starts_with(words));
    CHECK(folder.rbpa("mesh p.xy --alpha plateau -o m.off").err.starts_with(words));
    CHECK(folder.rbpa("mesh p.xy --alpha plateau:1 -o m.off").err.starts_with(words));
    CHECK(contains(folder.rbpa("alpha p.xy").out, "Recommended: --alpha auto, which is "));
    CHECK(folder.rbpa("shape p.xy --alpha plateau -o s.wkt -q").err.empty());
    CHECK(!contains(folder.rbpa("shape two.xy --alpha plateau -o s.wkt").err, "stands out"));
    // A rank that does not exist gives this message only.
    CHECK(!contains(folder.rbpa("shape p.xy --alpha plateau:9 -o s.wkt").err, "stands out"));
  }

  TEST_CASE("two squares are recommended as two, with an outlier that ruins min and auto") {
    const Folder folder("p.xy", two_squares());
    const Json report = radii_of(folder, "p.xy");
    CHECK(report["auto"] > 1000.0);
    CHECK(report["min"] > 1000.0);
    const Json& best = report["plateaus"][0];
    CHECK(best["from"] == 0.7071067811865476);
    CHECK(best["to"].get<double>() == doctest::Approx(10.0).epsilon(0.05));  // half the gap, and a corner of a cell
    CHECK(best["kind"] == "structured");
    CHECK(best["long"] == true);
    CHECK(best["solid_components"] == 2);
    CHECK(best["holes"] == 0);
    CHECK(best["covered"] == 200);
    CHECK(best["area"] == 162.0);
    CHECK(report["recommended"]["choice"] == "plateau");
    CHECK(report["recommended"]["alpha"] == best["alpha"]);
    CHECK(report["recommended"]["why"].get<std::string>().starts_with("from 0.7071 up to "));
    CHECK(report["recommended"]["why"].get<std::string>().ends_with(", the shape has 2 parts and 0 holes"));
  }

  TEST_CASE("--alpha plateau:K is the alpha of line K, and its complex has the counts of that line") {
    const Folder folder;
    const Json plateaus = radii_of(folder, quakes)["plateaus"];
    REQUIRE(plateaus.size() > 2);
    for (const std::size_t rank : {1u, 2u, 3u}) {
      const Json& plateau = plateaus[rank - 1];
      const std::string choice = "plateau:" + std::to_string(rank);
      for (const std::string verb : {"mesh ", "shape "}) {
        const Json stats = stats_of(folder, verb + quakes + "--alpha " + choice);
        CHECK(stats["alpha"] == plateau["alpha"]);
        CHECK(stats["alpha_rule"] == (rank == 1 ? "plateau" : choice));
        for (const char* key : {"triangles", "solid_components", "components", "holes"})
          CHECK(stats[key] == plateau[key]);
        CHECK(stats["vertices"] == plateau["covered"]);
      }
    }
    CHECK(stats_of(folder, "mesh " + quakes + "--alpha plateau")["alpha"] == plateaus[0]["alpha"]);
    CHECK(stats_of(folder, "mesh " + quakes + "--alpha plateau --method hrbpa")["alpha"] == plateaus[0]["alpha"]);
  }

  TEST_CASE("the table has a line for every plateau, then min and auto with the names that others give them") {
    const Folder folder("p.xy", two_squares());
    const std::size_t plateaus = radii_of(folder, "p.xy")["plateaus"].size();
    const std::vector<std::string> lines = lines_of(folder.rbpa("alpha p.xy -q").out);
    const auto head = std::find_if(lines.begin(), lines.end(), [](auto& line) { return line.starts_with("choice "); });
    REQUIRE(lines.end() - head == static_cast<std::ptrdiff_t>(plateaus) + 6);
    CHECK(head[1] == "plateau        1.414    0.7071     10.01       2      0   99.5 %        162");
    CHECK(head[1].size() == head[0].size());
    const std::string &min = head[static_cast<std::ptrdiff_t>(plateaus) + 1],
                      &automatic = head[static_cast<std::ptrdiff_t>(plateaus) + 2];
    CHECK(min.starts_with("min "));
    CHECK(min.ends_with("  MATLAB 'all-points'"));
    CHECK(automatic.starts_with("auto "));
    CHECK(automatic.ends_with("  MATLAB 'one-region', CGAL find_optimal_alpha(1)"));
    CHECK(lines.end()[-2].starts_with("Recommended: --alpha plateau, which is "));
    CHECK(lines.back().ends_with("the shape has 2 parts and 0 holes."));
    // The choices of MATLAB and CGAL cover every point in one piece: they are not named with other options.
    for (const std::string other : {"--cover 0.9", "--components 2"}) {
      const std::string text = folder.rbpa("alpha p.xy -q " + other).out;
      CHECK(!contains(text, "one-region"));
      CHECK(contains(text, "plateau:2"));
    }
  }

  TEST_CASE("one part and one hole are printed in the singular") {
    const Folder folder;
    std::string ring;
    for (int x = -12; x <= 12; ++x)
      for (int y = -12; y <= 12; ++y)
        if (x * x + y * y <= 144 && x * x + y * y >= 64) ring += std::to_string(x) + " " + std::to_string(y) + "\n";
    folder.file("ring.xy", ring);
    CHECK(folder.rbpa("alpha ring.xy -q").out.ends_with(", the shape has 1 part and 1 hole.\n"));
  }

  TEST_CASE("auto is recommended when no plateau stands out, and points without a triangle have no plateau") {
    const Folder folder("p.xy", "0 0\n6 0\n0 8\n");
    const Json one = radii_of(folder, "p.xy");
    REQUIRE(one["plateaus"].size() == 1);
    CHECK(one["plateaus"][0]["alpha"] == 5.0);
    CHECK(one["plateaus"][0]["to"].is_null());
    CHECK(one["plateaus"][0]["long"] == false);
    CHECK(one["recommended"]["why"].get<std::string>().starts_with("no range of alpha stands out: "));
    CHECK(one["recommended"]["choice"] == "auto");
    CHECK(one["recommended"]["alpha"] == 5.0);
    folder.file("few.xy", "0 0\n1 0\n0 1\n3 0\n3 2\n");
    const Json few = radii_of(folder, "few.xy");
    CHECK(few["recommended"]["choice"] == "auto");
    CHECK(few["recommended"]["alpha"] == few["auto"]);
    CHECK(few["plateaus"][0]["alpha"] < few["auto"]);
    CHECK(contains(folder.rbpa("alpha few.xy").out, "Recommended: --alpha auto, which is "));
    for (const char* none : {"# none\n", "1 1\n1 1\n1 1\n", "0 0\n1 1\n3 3\n"}) {
      folder.file("none.xy", none);
      const Json report = radii_of(folder, "none.xy");
      CHECK(report["plateaus"].empty());
      CHECK(report["recommended"].is_null());
      CHECK(!contains(folder.rbpa("alpha none.xy").out, "choice"));
      const Outcome shape = folder.rbpa("shape none.xy --alpha plateau -o s.wkt", 0);
      CHECK(shape.err.ends_with(", alpha plateau = none -> s.wkt\n"));
    }
  }

  TEST_CASE("the order of the points changes neither the table nor a byte of the shape") {
    const Folder folder;
    std::vector<std::string> lines = lines_of(read_file(RBPA_TEST_DATA "/geo_usgs_quakes_week.xy"));
    std::mt19937 random(3);
    std::shuffle(lines.begin(), lines.end(), random);
    std::string shuffled;
    for (const std::string& line : lines) shuffled += line + "\n";
    folder.file("q.xy", shuffled);
    CHECK(folder.rbpa("alpha q.xy -q").out == folder.rbpa("alpha " + quakes + "-q").out);
    CHECK(folder.rbpa("alpha q.xy -q --json").out == folder.rbpa("alpha " + quakes + "-q --json").out);
    REQUIRE(folder.rbpa("shape q.xy --alpha plateau -q -o q.geojson").code == 0);
    REQUIRE(folder.rbpa("shape " + quakes + "--alpha plateau -q -o p.geojson").code == 0);
    CHECK(folder.content("q.geojson") == folder.content("p.geojson"));
  }

  TEST_CASE("a wrong rank is refused at once, and one that is too high when the points are known") {
    const Folder folder("p.xy", two_squares());
    for (const std::string wrong : {"", "0", "-1", "two", "1.5"})
      CHECK(folder.rbpa("shape no_such_file.xy -o s.wkt --alpha plateau:" + wrong).err ==
            "rbpa: --alpha: found 'plateau:" + wrong +
                "', expected a radius (a number > 0, or inf), auto, min, plateau or plateau:K\n");
    const std::size_t count = radii_of(folder, "p.xy")["plateaus"].size();
    refuses(folder, "shape p.xy -o s.wkt --alpha plateau:99", 2,
            "--alpha plateau:99: there are only " + std::to_string(count) + " plateaus (rbpa alpha POINTS lists them)");
    CHECK(folder.names() == std::vector<std::string>{"p.xy"});
    for (const std::string option : {"--cover 0.9", "--components 2"})
      CHECK(folder.rbpa("shape p.xy -o s.wkt --alpha plateau " + option).code == 2);
  }
}
