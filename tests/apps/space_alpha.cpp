// `rbpa alpha --dimension 3`: births and deaths of components, tunnels and voids.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "support/program.h"

using namespace apps_test;
using nlohmann::json;

namespace {

std::string sphere(int count) {
  std::ostringstream text;
  text.precision(17);
  for (int i = 0; i < count; ++i) {
    const double z = (2.0 * i + 1) / count - 1, r = std::sqrt(1 - z * z);
    text << r * std::cos(2.4 * i) << ' ' << r * std::sin(2.4 * i) << ' ' << z << '\n';
  }
  return text.str();
}

}  // namespace

TEST_SUITE("space alpha") {
  TEST_CASE("a sphere has one void that lasts, in words, JSON and CSV") {
    const Folder folder;
    folder.file("s.xyz", sphere(500));
    const Outcome text = folder.rbpa("alpha s.xyz --dimension 3 -q");
    REQUIRE(text.code == 0);
    CHECK(text.out.starts_with("500 points\nmin "));
    CHECK(text.out.find("; longest, by death / birth:\n") != std::string::npos);
    const Outcome outcome = folder.rbpa("alpha s.xyz --dimension 3 --json --persistence --stats t.json -q");
    REQUIRE(outcome.code == 0);
    const json report = json::parse(outcome.out);
    CHECK(report["points"] == 500);
    CHECK(report["components"] == 500);
    double longest = 0;
    for (const json& pair : report["pairs"])
      if (pair["dimension"] == 2)
        longest = std::max(longest, pair["death"].get<double>() / pair["birth"].get<double>());
    CHECK(longest > 5);
    CHECK(report["pairs"].size() == report["components"].get<std::size_t>() + report["tunnels"].get<std::size_t>() +
                                        report["voids"].get<std::size_t>());
    CHECK(json::parse(folder.content("t.json"))["seconds"]["build"].get<double>() > 0);
    const Outcome csv = folder.rbpa("alpha s.xyz --dimension 3 --csv -q");
    CHECK(csv.out.starts_with("dimension,birth,death\n0,0,"));
    CHECK(static_cast<std::size_t>(std::count(csv.out.begin(), csv.out.end(), '\n')) == report["pairs"].size() + 1);
    CHECK(!json::parse(folder.rbpa("alpha s.xyz --dimension 3 --json -q").out).contains("pairs"));
    // As `rbpa solid` chooses.
    const Outcome solid = folder.rbpa("solid s.xyz --alpha auto --json -q");
    CHECK(json::parse(solid.out)["alpha"] == report["auto"]);
  }

  TEST_CASE("what it does not know is refused") {
    const Folder folder;
    folder.file("s.xyz", sphere(20));
    folder.file("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
    const auto refuses = [&](const std::string& options, int code, const std::string& message) {
      CAPTURE(options);
      const Outcome outcome = folder.rbpa("alpha " + options);
      CHECK(outcome.code == code);
      CHECK(outcome.err.find(message) != std::string::npos);
    };
    refuses("s.xyz --dimension 4", 2, "--dimension: found '4', expected 2 or 3");
    refuses("s.xyz --dimension 3 -o plot.svg", 2, "--output: found --dimension 3 as well");
    refuses("s.xyz --dimension 3 --complex full --persistence", 2, "--complex: found --dimension 3 as well");
    refuses("s.xyz --dimension 3 --cover 0.9", 2, "--cover: found --dimension 3 as well");
    refuses("flat.xyz --dimension 3", 3, "the points are in a plane");
    refuses("missing.xyz --dimension 3", 3, "missing.xyz");
  }
}
