// `--cover`, and radii in the terms of other programs: `--alpha-squared`, `--alpha-inverse`.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program.h"
#include "support/radii.h"

using namespace apps_test;
using Json = nlohmann::json;

namespace {

const std::string& data = clusterable;

}  // namespace

TEST_SUITE("alpha cover") {
  TEST_CASE("min of a share is the first critical radius that covers it, for every verb") {
    const Folder folder;
    const Json all = radii_of(folder, data);
    const double distinct = all["critical"].back()["covered"];
    double before = 0;
    for (const std::string share : {"0.1", "0.5", "0.9", "0.99", "1"}) {
      CAPTURE(share);
      const auto first = std::find_if(all["critical"].begin(), all["critical"].end(), [&](const Json& step) {
        return step["covered"].get<double>() / distinct >= std::stod(share);
      });
      REQUIRE(first != all["critical"].end());
      CHECK(radii_of(folder, data + "--cover " + share)["min"] == (*first)["alpha"]);
      CHECK(stats_of(folder, "mesh " + data + "--alpha min --cover " + share)["alpha"] == (*first)["alpha"]);
      CHECK(stats_of(folder, "shape " + data + "--alpha min --cover " + share)["alpha"] == (*first)["alpha"]);
      CHECK((*first)["alpha"] > before);
      before = (*first)["alpha"];
    }
    CHECK(all["min"] == before);
  }

  TEST_CASE("auto of a share ignores outliers that make a triangle of their own") {
    const Folder folder;
    std::string points;
    for (int i = 0; i < 15; ++i)
      for (int j = 0; j < 15; ++j) points += std::to_string(i) + " " + std::to_string(j) + "\n";
    folder.file("grid.xy", points);
    folder.file("dust.xy", points + "1000 1000\n1001 1000\n1000 1001\n");
    const double alone = radii_of(folder, "grid.xy")["auto"];
    CHECK(radii_of(folder, "dust.xy")["auto"] > 100.0);
    CHECK(radii_of(folder, "dust.xy --cover 0.98")["auto"] == alone);
    CHECK(radii_of(folder, "dust.xy --cover 0.98 --components 2")["auto"] == alone);
    CHECK(stats_of(folder, "mesh dust.xy --alpha auto --cover 0.98")["alpha"] == alone);
    // 3 of 228 are more than a hundredth.
    CHECK(radii_of(folder, "dust.xy --cover 0.99")["auto"] > 100.0);
    CHECK(radii_of(folder, "dust.xy --cover 0.99 --components 2")["auto"] == alone);
  }

  TEST_CASE("the report and the summary name the share") {
    const Folder folder("p.xy", two_triangles);
    const std::string text = folder.rbpa("alpha p.xy --cover 0.5").out;
    CHECK(contains(text, "min       5  (least alpha that covers a share of 0.5 of the points)\n"));
    CHECK(contains(text, "auto      5  (moreover with at most 1 solid component, without the others)\n"));
    CHECK(folder.rbpa("mesh p.xy --alpha min --cover 0.5 -o m.off").err ==
          "rbpa: 7 points (1 duplicate), 1 triangle, 3 isolated, alpha min = 5 with --cover 0.5 -> m.off\n");
    CHECK(folder.rbpa("mesh p.xy --alpha min --cover 1 -o m.off").err ==
          folder.rbpa("mesh p.xy --alpha min -o m.off").err);
  }

  TEST_CASE("a squared radius and an inverse one are the radius") {
    const Folder folder("p.xy", two_triangles);
    const auto same = [&](const std::string& option, const std::string& alpha) {
      CAPTURE(option);
      for (const std::string verb : {"mesh p.xy -o a.svg ", "shape p.xy -o a.svg "}) {
        CHECK(stats_of(folder, verb + option)["alpha"] == stats_of(folder, verb + "--alpha " + alpha)["alpha"]);
        CHECK(stats_of(folder, verb + option)["alpha_rule"] == "given");
      }
    };
    same("--alpha-squared 25", "5");
    same("--alpha-squared 2", "1.4142135623730951");
    same("--alpha-squared inf", "inf");
    same("--alpha-inverse 0.125", "8");
    same("--alpha-inverse 3", "0.3333333333333333");
    same("--alpha-inverse 0", "inf");
    CHECK(folder.rbpa("mesh p.xy --alpha-squared 25 -o m.off").err ==
          "rbpa: 7 points (1 duplicate), 1 triangle, 3 isolated, alpha 5 of --alpha-squared 25 -> m.off\n");
    CHECK(folder.rbpa("shape p.xy --alpha-inverse 4 -o s.wkt")
              .err.starts_with("rbpa: the shape is empty: no triangle has circumradius <= 0.25\n"));
  }

  TEST_CASE("wrong shares, squares and inverses are refused before anything is read") {
    const Folder folder;
    const auto refuses_both = [&](const std::string& arguments, const std::string& message) {
      for (const std::string verb : {"mesh", "shape"})
        refuses(folder, verb + " no_such_file.xy -o s.svg " + arguments, 2, message);
    };
    for (const std::string share : {"0", "1.01", "-0.5", "nan", "inf", "half", "50%", "99"}) {
      const std::string message = "--cover: found '" + share + "', expected a share of the points, > 0 and <= 1";
      refuses_both("--alpha min --cover " + share, message);
      CHECK(folder.rbpa("alpha no_such_file.xy --cover " + share).err == "rbpa: " + message + "\n");
    }
    for (const std::string given : {"--alpha 0.5", "--alpha inf", "--alpha-squared 4", "--alpha-inverse 4"}) {
      refuses_both(given + " --cover 0.9", "--cover applies only to --alpha auto or min");
      refuses_both(given + " --components 2", "--components applies only to --alpha auto");
    }
    for (const std::string wrong : {"0", "-1", "nan", "-inf", "auto"})
      refuses_both("--alpha-squared " + wrong,
                   "--alpha-squared: found '" + wrong + "', expected the square of a radius, > 0, or inf");
    for (const std::string wrong : {"-1", "nan", "inf", "auto"})
      refuses_both("--alpha-inverse " + wrong,
                   "--alpha-inverse: found '" + wrong + "', expected one over a radius, finite and >= 0");
    for (const std::string two :
         {"--alpha 1 --alpha-squared 1", "--alpha 1 --alpha-inverse 1", "--alpha-squared 1 --alpha-inverse 1"})
      CHECK(folder.rbpa("mesh no_such_file.xy -o s.svg " + two).err ==
            "rbpa: --alpha, --alpha-squared and --alpha-inverse cannot be combined (see rbpa mesh --help)\n");
  }

  TEST_CASE("a verb without a required argument points to its own help") {
    const Folder folder;
    for (const std::string verb : {"mesh", "shape"}) {
      CHECK(folder.rbpa(verb + " p.xy -o s.svg").err ==
            "rbpa: --alpha is required: a radius, plateau, auto, min or inf (rbpa alpha POINTS lists the choices) (see "
            "rbpa " +
                verb + " --help)\n");
      CHECK(folder.rbpa(verb + " p.xy").code == 2);
    }
    for (const std::string verb : {"mesh", "shape", "alpha", "info"})
      CHECK(folder.rbpa(verb).err == "rbpa: POINTS is required (see rbpa " + verb + " --help)\n");
    CHECK(folder.rbpa("").err.ends_with(" (see rbpa --help)\n"));
  }
}
