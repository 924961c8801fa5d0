// `rbpa alpha`: radii, pairs, pictures, representatives and statistics.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/program.h"

using namespace apps_test;
using Json = nlohmann::json;

namespace {

const std::string points = "'" RBPA_TEST_DATA "/shape_hdbscan_clusterable.xy' ";

/// Two right triangles of circumradius 5 and 10, far from each other.
const char* const two_triangles = "0 0\n6 0\n0 8\n100 0\n112 0\n100 16\n0 0\n";

/// Returns a number in 17 digits, which a command line reads back exactly.
std::string text_of(const Json& number) { return number.dump(); }

}  // namespace

TEST_SUITE("alpha") {
  TEST_CASE("every critical radius has the counts of rbpa mesh at that alpha") {
    const Folder folder("p.xy", two_triangles);
    const Outcome outcome = folder.rbpa("alpha p.xy --json -q", 0);
    CHECK(outcome.err.empty());
    const Json report = Json::parse(outcome.out);
    CHECK(report["critical"][0] == Json::parse(R"({"alpha": 5.0, "triangles": 1, "solid_components": 1,
        "components": 1, "holes": 0, "covered": 3, "area": 24.0})"));
    CHECK(report["critical"][1] == Json::parse(R"({"alpha": 10.0, "triangles": 2, "solid_components": 2,
        "components": 2, "holes": 0, "covered": 6, "area": 120.0})"));
    CHECK(report["min"] == 10.0);
    CHECK_FALSE(report.contains("pairs"));
    for (const Json& step : report["critical"]) {
      REQUIRE(folder.rbpa("mesh p.xy --alpha " + text_of(step["alpha"]) + " -q --stats s.json").code == 0);
      const Json stats = Json::parse(folder.content("s.json"));
      for (const char* key : {"triangles", "solid_components", "components", "holes"}) CHECK(step[key] == stats[key]);
      CHECK(step["covered"] == stats["vertices"]);
    }
  }

  TEST_CASE("auto covers every point in few enough solid components, and min is not above it") {
    const Folder folder;
    const Json one = Json::parse(folder.rbpa("alpha " + points + "--json -q").out);
    REQUIRE(folder.rbpa("mesh " + points + "--alpha " + text_of(one["auto"]) + " -q --stats s.json").code == 0);
    Json stats = Json::parse(folder.content("s.json"));
    CHECK(stats["isolated"] == 0);
    CHECK(stats["solid_components"] == 1);
    REQUIRE(folder.rbpa("mesh " + points + "--alpha " + text_of(one["min"]) + " -q --stats s.json").code == 0);
    stats = Json::parse(folder.content("s.json"));
    CHECK(stats["isolated"] == 0);
    CHECK(one["min"].get<double>() <= one["auto"].get<double>());
    const std::string components = stats["solid_components"].dump();
    CHECK(Json::parse(folder.rbpa("alpha " + points + "--json -q --components " + components).out)["auto"] ==
          one["min"]);
  }

  TEST_CASE("CSV has the lines of the JSON") {
    const Folder folder("p.xy", two_triangles);
    CHECK(
        folder.rbpa("alpha p.xy --csv -q")
            .out.starts_with(
                "alpha,triangles,solid_components,components,holes,covered,area\n5,1,1,1,0,3,24\n10,2,2,2,0,6,120\n"));
    const std::string pairs = folder.rbpa("alpha p.xy --csv -q --persistence").out;
    CHECK(pairs.starts_with("dimension,birth,death\n0,5,\n0,10,"));
    const Json report = Json::parse(folder.rbpa("alpha p.xy --json -q --persistence").out);
    CHECK(static_cast<std::size_t>(std::count(pairs.begin(), pairs.end(), '\n')) == report["pairs"].size() + 1);
  }

  TEST_CASE("pairs alive at a critical radius are its components and holes; the full complex starts with the points") {
    const Folder folder;
    const Json solid = Json::parse(folder.rbpa("alpha " + points + "--json --persistence -q").out);
    const auto alive = [](const Json& report, int dimension, const Json& alpha) {
      return std::count_if(report["pairs"].begin(), report["pairs"].end(), [&](const Json& pair) {
        return pair["dimension"] == dimension && pair["birth"] <= alpha &&
               (pair["death"].is_null() || alpha < pair["death"]);
      });
    };
    for (std::size_t i = 0; i < solid["critical"].size(); i += 97) {
      const Json& step = solid["critical"][i];
      CHECK(alive(solid, 0, step["alpha"]) == step["components"].get<long>());
      CHECK(alive(solid, 1, step["alpha"]) == step["holes"].get<long>());
    }
    const Json full = Json::parse(folder.rbpa("alpha " + points + "--json --persistence --complex full -q").out);
    CHECK(full["critical"] == solid["critical"]);
    CHECK(alive(full, 0, 0.0) == 2309);
  }

  TEST_CASE("points without a triangle are reported, and auto and min are null") {
    const Folder folder("line.xy", "0 0\n1 1\n3 3\n");
    const Outcome line = folder.rbpa("alpha line.xy --json --persistence --complex full -q", 0);
    CHECK(line.err == "rbpa: the complex is empty at every alpha: all points are collinear\n");
    const Json report = Json::parse(line.out);
    CHECK(report["auto"].is_null());
    CHECK(report["min"].is_null());
    CHECK(report["critical"].empty());
    CHECK(report["pairs"].size() == 3);
    folder.file("two.xy", "0 0\n1 1\n0 0\n");
    CHECK(folder.rbpa("alpha two.xy").err.ends_with("fewer than three distinct points\n"));
    CHECK(contains(folder.rbpa("alpha two.xy").out, "none"));
  }

  TEST_CASE("numbers above every double are \"inf\", and the JSON stays valid") {
    const Folder folder("p.xy", "-1e308 0\n0 -5e-324\n1e308 0\n0 -1e308\n");
    const Json report = Json::parse(folder.rbpa("alpha p.xy --json -q").out);
    CHECK(report["critical"].back()["alpha"] == "inf");
    CHECK(report["critical"].back()["area"] == "inf");
  }

  TEST_CASE("text has min, auto and the range of radii") {
    const Folder folder("p.xy", two_triangles);
    const Outcome outcome = folder.rbpa("alpha p.xy", 0);
    CHECK(contains(outcome.out, "7, 6 of them distinct"));
    CHECK(contains(outcome.out, "min       10 "));
    CHECK(contains(outcome.out, "from 5 to "));
  }

  TEST_CASE("a picture has both marks, and is the same for shuffled points") {
    const Folder folder({{"p.xy", two_triangles}, {"q.xy", "100 16\n0 8\n112 0\n0 0\n100 0\n6 0\n"}});
    REQUIRE(folder.rbpa("alpha p.xy -q -o p.svg").code == 0);
    REQUIRE(folder.rbpa("alpha q.xy -q -o q.svg").code == 0);
    const std::string picture = folder.content("p.svg");
    CHECK(picture == folder.content("q.svg"));
    CHECK(contains(picture, ">min = 10<"));
    CHECK(contains(picture, ">auto = "));
    CHECK(contains(picture, ">plateau = "));
    REQUIRE(folder.rbpa("alpha p.xy -q --csv -o csv.svg").code == 0);
    CHECK(picture == folder.content("csv.svg"));
    CHECK(picture.ends_with("</svg>\n"));
  }

  TEST_CASE("a picture of one triangle, and of none, has axes and only finite numbers") {
    const Folder folder;
    for (const char* points : {corner, "0 0\n1 1\n3 3\n"}) {
      folder.file("p.xy", points);
      REQUIRE(folder.rbpa("alpha p.xy -q -o p.svg").code == 0);
      const std::string picture = folder.content("p.svg");
      CHECK(contains(picture, ">alpha<"));
      CHECK(!contains(picture, "nan"));
      CHECK(!contains(picture, "inf"));
    }
  }

  TEST_CASE("representatives are GeoJSON: holes at their birth and before their death, edges at which components end") {
    const Folder folder;
    REQUIRE(folder.rbpa("alpha " + points + "--representatives r.geojson --top 3 -q").code == 0);
    const Json made = Json::parse(folder.content("r.geojson"));
    std::size_t holes = 0, lines = 0;
    for (const Json& feature : made["features"]) {
      const Json& properties = feature["properties"];
      const Json& coordinates = feature["geometry"]["coordinates"];
      CHECK(properties["birth"] < properties["death"]);
      if (properties["dimension"] == 0) {
        CHECK(coordinates.size() == 2);
        CHECK(properties["points"].size() == 2);
        ++lines;
        continue;
      }
      CHECK(feature["geometry"]["type"] == "Polygon");
      CHECK(coordinates[0].front() == coordinates[0].back());
      std::size_t corners = 0;
      for (const Json& ring : coordinates) corners += ring.size() - 1;
      CHECK(properties["points"].size() == corners);
      CHECK(properties["area"].get<double>() > 0);
      holes += properties["when"] == "birth" ? 1u : 0u;
    }
    CHECK(holes == 3);
    CHECK(lines == 2);  // one of the three never ends
    REQUIRE(
        folder.rbpa("alpha " + points + "--representatives all.geojson --min-persistence 0 --complex full -q").code ==
        0);
    CHECK(Json::parse(folder.content("all.geojson"))["features"].size() > 1000);
    const double birth = made["features"].back()["properties"]["birth"];
    const auto births_at = [&](const std::string& levels) {
      folder.rbpa("alpha " + points + "--representatives l.geojson --min-persistence 0 -q --levels " + levels, 0);
      std::set<double> births;
      const Json written = Json::parse(folder.content("l.geojson"));
      for (const Json& feature : written["features"]) births.insert(feature["properties"]["birth"].get<double>());
      return births;
    };
    CHECK(births_at(Json(birth / 4).dump() + "," + Json(birth).dump()) == std::set<double>{birth / 4, birth});
    CHECK(births_at("hrbpa:16").size() > 3);
    CHECK(births_at("hrbpa").size() < births_at("hrbpa:16").size());
    const auto refuses = [&](const std::string& arguments, const std::string& why) {
      says(folder, "alpha " + points + arguments, 2, why);
    };
    refuses("--representatives r.geojson --levels 2,1", "--levels: found '1' after 2, expected ascending radii");
    refuses("--representatives r.geojson --levels all",
            "--levels: found 'all', expected numbers above 0 with commas between them, or hrbpa");
    refuses("--levels 1", "--levels requires --representatives");
    says(folder, "alpha " + points + "--representatives r.obj", 2,
         "--representatives: found the ending 'obj', expected one of geojson, json");
  }

  TEST_CASE("a picture that cannot be written is refused, and leaves no file") {
    const Folder folder("p.xy", corner);
    CHECK(folder.rbpa("alpha p.xy -o p.tiff").code == 2);
    CHECK(folder.rbpa("alpha p.xy -o -").code == 2);
    CHECK(folder.rbpa("alpha p.xy -o no_folder/p.svg").code == 1);
    CHECK(folder.names() == std::vector<std::string>{"p.xy"});
  }

  TEST_CASE("ticks of a picture are at their values, up to the ends of the range of double and beyond") {
    const Folder folder;
    for (const char* points : {
             "0 0\n5e-324 0\n0 1e-323\n1e308 0\n0 1.5e308\n1 1\n",  // all of it
             "0 0\n5e-324 0\n0 5e-324\n",                           // one radius, below the least double
             "-1e308 0\n1e308 1e308\n0 -1e308\n1e308 -1.1e308\n",   // near the largest
             "0 0\n1.7e-300 0\n0 1.6e-300\n",
             "0 0\n3 0\n0 4\n",
         }) {
      CAPTURE(std::string(points));
      folder.file("p.xy", points);
      REQUIRE(folder.rbpa("alpha p.xy -q -o p.svg").code == 0);
      // Pixels per power of ten: the first two ticks give the scale, and the others must agree.
      std::vector<std::pair<double, double>> ticks;
      std::istringstream lines(folder.content("p.svg"));
      for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("<text") || !contains(line, "y=\"520\"")) continue;
        const long double value = std::strtold(line.c_str() + line.find('>') + 1, nullptr);
        CHECK(value > 0);
        CHECK(std::isfinite(value));
        ticks.emplace_back(std::stod(line.substr(line.find("x=\"") + 3)), static_cast<double>(std::log10(value)));
      }
      REQUIRE(ticks.size() >= 2);
      const double scale = (ticks.back().first - ticks[0].first) / (ticks.back().second - ticks[0].second);
      CHECK(scale > 0);
      for (const auto& [at, logarithm] : ticks)
        CHECK(std::abs(at - ticks[0].first - scale * (logarithm - ticks[0].second)) <= 1);
    }
  }

  TEST_CASE("all files of a run appear, or none does") {
    const Folder folder({{"p.xy", corner}, {"p.svg", "before"}});
    const Outcome no_folder = folder.rbpa("alpha p.xy -o p.svg --stats no_folder/s.json", 1);
    CHECK(no_folder.out.empty());
    CHECK(folder.rbpa("alpha p.xy -o p.svg --stats s.json > /dev/full 2> /dev/null && true").code == 1);
    CHECK(folder.rbpa("alpha p.xy -o no_folder/p.svg --stats s.json").code == 1);
    CHECK(folder.rbpa("alpha p.xy -o p.svg --stats /dev/full").code == 1);
    CHECK(folder.content("p.svg") == "before");
    CHECK(folder.names() == std::vector<std::string>{"p.svg", "p.xy"});
    CHECK(folder.rbpa("alpha p.xy -o p.svg --stats s.json").code == 0);
    CHECK(folder.content("p.svg") != "before");
    CHECK(folder.names() == std::vector<std::string>{"p.svg", "p.xy", "s.json"});
  }

  TEST_CASE("contradicting options are refused before anything is read") {
    const Folder folder;
    for (const std::string wrong : {"--json --csv", "--components 0", "--components -1", "--complex full",
                                    "--persistence --complex half", "--stats -"}) {
      CAPTURE(wrong);
      const Outcome outcome = folder.rbpa("alpha no_such_file.xy " + wrong, 2);
      CHECK(outcome.out.empty());
      CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    }
  }

  TEST_CASE("statistics have sizes and times") {
    const Folder folder("p.xy", two_triangles);
    REQUIRE(folder.rbpa("alpha p.xy --stats s.json").code == 0);
    const Json stats = Json::parse(folder.content("s.json"));
    CHECK(stats["points"] == 7);
    CHECK(stats["distinct"] == 6);
    for (const char* phase : {"read", "build", "write"}) CHECK(stats["seconds"][phase] >= 0.0);
  }
}
