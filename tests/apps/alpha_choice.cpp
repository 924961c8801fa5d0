// `--alpha auto` and `--alpha min`: the chosen radius, and how it is reported.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "support/program.h"
#include "support/radii.h"

using namespace apps_test;
using Json = nlohmann::json;

namespace {

const std::string& data = clusterable;

bool covers(const Json& step, const Json& stats) { return step["covered"] == stats["distinct"]; }

}  // namespace

TEST_SUITE("alpha choice") {
  TEST_CASE("auto and min are the radii that rbpa alpha prints") {
    const Folder folder;
    for (const std::string verb : {"mesh ", "shape "}) {
      const Json radii = radii_of(folder, data);
      CHECK(stats_of(folder, verb + data + "--alpha auto")["alpha"] == radii["auto"]);
      CHECK(stats_of(folder, verb + data + "--alpha auto --components 1")["alpha"] == radii["auto"]);
      CHECK(stats_of(folder, verb + data + "--alpha min")["alpha"] == radii["min"]);
      const Json two = radii_of(folder, data + "--components 2");
      CHECK(two["auto"] < radii["auto"]);
      CHECK(stats_of(folder, verb + data + "--alpha auto --components 2")["alpha"] == two["auto"]);
    }
  }

  TEST_CASE("the complex at auto covers every point in at most K solid components, and at no lesser radius") {
    const Folder folder;
    for (const int most : {1, 2, 5}) {
      CAPTURE(most);
      const std::string option = "--components " + std::to_string(most);
      const Json chosen = stats_of(folder, "mesh " + data + "--alpha auto " + option);
      CHECK(chosen["isolated"] == 0);
      CHECK(chosen["solid_components"] <= most);
      const Json radii = radii_of(folder, data + option);
      const auto suits = [&](const Json& step) { return covers(step, chosen) && step["solid_components"] <= most; };
      const auto first = std::find_if(radii["critical"].begin(), radii["critical"].end(), suits);
      REQUIRE(first != radii["critical"].end());
      CHECK((*first)["alpha"] == chosen["alpha"]);
    }
  }

  TEST_CASE("the complex at min covers every point, and at no lesser radius; min is not above auto") {
    const Folder folder;
    const Json chosen = stats_of(folder, "mesh " + data + "--alpha min");
    CHECK(chosen["isolated"] == 0);
    const Json radii = radii_of(folder, data);
    const auto first = std::find_if(radii["critical"].begin(), radii["critical"].end(),
                                    [&](const Json& step) { return covers(step, chosen); });
    REQUIRE(first != radii["critical"].end());
    CHECK((*first)["alpha"] == chosen["alpha"]);
    CHECK(chosen["alpha"] <= stats_of(folder, "mesh " + data + "--alpha auto")["alpha"]);
  }

  TEST_CASE("a chosen radius gives the bytes of the same radius given") {
    const Folder folder;
    const std::string radius = radii_of(folder, data)["auto"].dump();
    REQUIRE(folder.rbpa("mesh " + data + "--alpha auto -q -o a.ply -o a.svg").code == 0);
    REQUIRE(folder.rbpa("mesh " + data + "--alpha " + radius + " -q -o b.ply -o b.svg").code == 0);
    CHECK(folder.content("a.ply") == folder.content("b.ply"));
    CHECK(folder.content("a.svg") == folder.content("b.svg"));
  }

  TEST_CASE("the order of the points makes no difference to the radius and to the bytes of the shape") {
    const Folder folder;
    const std::string text = read_file(RBPA_TEST_DATA "/shape_hdbscan_clusterable.xy");
    std::vector<std::string> lines;
    for (std::size_t first = 0; first < text.size();) {
      const std::size_t end = std::min(text.find('\n', first), text.size());
      lines.push_back(text.substr(first, end - first));
      first = end + 1;
    }
    std::mt19937 random(1);
    std::shuffle(lines.begin(), lines.end(), random);
    std::string shuffled;
    for (const std::string& line : lines) shuffled += line + "\n";
    folder.file("p.xy", text);
    folder.file("q.xy", shuffled);
    REQUIRE(folder.content("p.xy") != shuffled);
    for (const std::string rule : {"auto", "auto --components 3", "min"}) {
      CAPTURE(rule);
      const Json p = stats_of(folder, "shape p.xy -o p.geojson -o p.wkt -o p.svg --alpha " + rule);
      const Json q = stats_of(folder, "shape q.xy -o q.geojson -o q.wkt -o q.svg --alpha " + rule);
      CHECK(p["alpha"] == q["alpha"]);
      for (const std::string ending : {".geojson", ".wkt", ".svg"}) {
        CAPTURE(ending);
        CHECK(folder.content("p" + ending).size() > 1000);
        CHECK(folder.content("p" + ending) == folder.content("q" + ending));
      }
    }
  }

  TEST_CASE("the summary and the statistics have the rule and its radius") {
    const Folder folder("p.xy", two_triangles);
    CHECK(folder.rbpa("mesh p.xy --alpha min -o m.off").err ==
          "rbpa: 7 points (1 duplicate), 2 triangles, 0 isolated, alpha min = 10 -> m.off\n");
    CHECK(folder.rbpa("shape p.xy --alpha auto --components 2 -o s.wkt").err ==
          "rbpa: 7 points (1 duplicate), 2 polygons with 0 holes, area 120, alpha auto = 10 -> s.wkt\n");
    CHECK(folder.rbpa("mesh p.xy --alpha auto -o m.off -q").err.empty());
    for (const std::string verb : {"mesh", "shape"}) {
      CHECK(stats_of(folder, verb + " p.xy --alpha auto")["alpha_rule"] == "auto");
      CHECK(stats_of(folder, verb + " p.xy --alpha min")["alpha_rule"] == "min");
      CHECK(stats_of(folder, verb + " p.xy --alpha 10")["alpha_rule"] == "given");
      CHECK(stats_of(folder, verb + " p.xy --alpha inf")["alpha_rule"] == "given");
    }
    CHECK(stats_of(folder, "alpha p.xy")["alpha_rule"].is_null());

    const std::string err = folder.rbpa("mesh " + data + "--alpha auto -o m.off").err;
    const std::size_t number = err.find("alpha auto = ") + 13;
    CHECK(std::stod(err.substr(number)) == radii_of(folder, data)["auto"].get<double>());
  }

  TEST_CASE("the paper's search accepts a chosen radius") {
    const Folder folder("p.xy", two_triangles);
    CHECK(stats_of(folder, "mesh p.xy --alpha min --search paper")["alpha"] == 10);
  }

  TEST_CASE("points that no radius covers give an empty complex with a message and exit code 0") {
    const Folder folder;
    const auto none = [&](const std::string& points, const std::string& rule, const std::string& reason) {
      CAPTURE(points);
      folder.file("p.xy", points);
      const Outcome mesh = folder.rbpa("mesh p.xy --alpha " + rule + " -o m.npy -q --stats s.json", 0);
      CHECK(mesh.err == "rbpa: the complex is empty: " + reason + "\n");
      CHECK(folder.has("m.npy"));
      CHECK(Json::parse(folder.content("s.json"))["alpha"].is_null());
      CHECK(Json::parse(folder.content("s.json"))["alpha_rule"] == rule);
      const Outcome shape = folder.rbpa("shape p.xy --alpha " + rule + " -o s.wkt", 0);
      CHECK(shape.err.starts_with("rbpa: the shape is empty: " + reason + "\n"));
      CHECK(shape.err.ends_with(", alpha " + rule + " = none -> s.wkt\n"));
      CHECK(folder.content("s.wkt") == "MULTIPOLYGON EMPTY\n");
    };
    for (const std::string rule : {"auto", "min"}) {
      none("# none\n", rule, "fewer than three distinct points (0)");
      none("0 0\n1 1\n0 0\n", rule, "fewer than three distinct points (2)");
      none("0 0\n1 1\n3 3\n", rule, "all points are collinear");
    }
  }

  TEST_CASE("a radius above every double is inf") {
    const Folder folder("p.xy", "-1e308 0\n0 -5e-324\n1e308 0\n0 -1e308\n");
    const Json radii = radii_of(folder, "p.xy");
    for (const std::string rule : {"auto", "min"}) {
      const Json chosen = stats_of(folder, "mesh p.xy --alpha " + rule);
      CHECK(chosen["alpha"] == radii[rule]);
      CHECK(chosen["isolated"] == 0);
    }
  }

  TEST_CASE("unknown words and --components without auto are refused before anything is read") {
    const Folder folder;
    const auto refuses_choice = [&](const std::string& options, const std::string& message) {
      for (const std::string verb : {"mesh", "shape"})
        refuses(folder, verb + " no_such_file.xy -o s.svg --alpha " + options, 2, message);
    };
    for (const std::string word : {"Auto", "automatic", "max", "-1", "0", "nan", "1e", "-inf"})
      refuses_choice(word, "--alpha: found '" + word +
                               "', expected a radius (a number > 0, or inf), auto, min, plateau or plateau:K");
    refuses_choice("''",
                   "--alpha: found '', expected a radius (a number > 0, or inf), auto, min, plateau or plateau:K");
    for (const std::string alpha : {"0.5", "inf", "min"})
      refuses_choice(alpha + " --components 2", "--components applies only to --alpha auto");
    refuses_choice("auto --components 0", "--components: found '0', expected a whole number from 1");
    refuses_choice("auto --components -3", "--components: found '-3', expected a whole number from 1");
    CHECK(folder.rbpa("mesh no_such_file.xy -o s.svg --alpha auto --components two").code == 2);
  }
}
