// Outputs of a run: statistics, help, summaries, pictures.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>

#include "support/program.h"

using namespace apps_test;

namespace {
const std::string points = "'" RBPA_TEST_DATA "/shape_hdbscan_clusterable.xy' ";
}

TEST_SUITE("outputs") {
  TEST_CASE("peak_bytes are those of the program, whatever started it") {
    const Folder folder("p.xy", corner);
    // The parent has used 400 MB, and is replaced by the program.
    folder.run("/usr/bin/python3",
               "-c 'import os; b = bytearray(b\"x\" * 400000000); os.execv(\"" RBPA_PROGRAM
               "\", [\"rbpa\", \"info\", \"p.xy\", \"--stats\", \"s.json\"])'",
               0);
    const double peak = nlohmann::json::parse(folder.content("s.json")).at("peak_bytes").get<double>();
    CHECK(peak > 1e6);
    CHECK(peak < 2e8);
  }

  TEST_CASE("the search changes no bytes") {
    const Folder folder;
    REQUIRE(folder.rbpa("mesh " + points + "--alpha 0.02 -o a.ply -o a.svg -o a.png -o a.npy -q").code == 0);
    REQUIRE(folder.rbpa("mesh " + points + "--alpha 0.02 --search paper -o b.ply -o b.svg -o b.png -o b.npy -q").code ==
            0);
    for (const std::string ending : {".ply", ".svg", ".png", ".npy"}) {
      CAPTURE(ending);
      CHECK(folder.content("a" + ending).size() > 1000);
      CHECK(folder.content("a" + ending) == folder.content("b" + ending));
    }
  }

  TEST_CASE("statistics are consistent with each other and have every key") {
    const Folder folder;
    REQUIRE(folder.rbpa("mesh " + points + "--alpha 0.02 -o a.off --stats s.json -q").code == 0);
    const auto s = nlohmann::json::parse(folder.content("s.json"));
    CHECK(s["points"] == 2309);
    CHECK(s["distinct"].get<long>() == s["vertices"].get<long>() + s["isolated"].get<long>());
    CHECK(s["components"].get<long>() - s["holes"].get<long>() ==
          s["vertices"].get<long>() - s["edges"].get<long>() + s["triangles"].get<long>());
    CHECK(s["solid_components"] >= s["components"]);
    CHECK(s["boundary_curves"] >= s["solid_components"]);
    CHECK(s["holes"] > 0);
    CHECK(s["alpha"] == 0.02);
    CHECK(s["method"] == "rbpa");
    CHECK(s["threads"] == 1);  // so few points
    for (const char* phase : {"read", "build", "write"}) CHECK(s["seconds"][phase] >= 0.0);
    CHECK(s["peak_bytes"] > 0);
    REQUIRE(folder.rbpa("mesh " + points + "--alpha inf -o a.off --stats s.json -q").code == 0);
    CHECK(nlohmann::json::parse(folder.content("s.json"))["alpha"] == "inf");
  }

  TEST_CASE("choosing alpha by a rule and building have separate times") {
    const Folder folder;
    for (const std::string verb : {"mesh ", "shape "})
      for (const auto& [alpha, chosen] : {std::pair{"auto", true}, {"min", true}, {"0.02", false}}) {
        REQUIRE(folder.rbpa(verb + points + "--alpha " + alpha + " --stats s.json -q").code == 0);
        const auto seconds = nlohmann::json::parse(folder.content("s.json"))["seconds"];
        CHECK(seconds["choose"].is_null() == !chosen);
        if (chosen) CHECK(seconds["choose"] > 0.0);
        CHECK(seconds["build"] > 0.0);
      }
  }

  TEST_CASE("no line of a help is longer than 100 columns") {
    const Folder folder;
    for (const std::string verb : {"", "mesh ", "shape ", "alpha ", "info ", "meshtopo"}) {
      CAPTURE(verb);
      const Outcome help = verb == "meshtopo" ? folder.meshtopo("--help") : folder.rbpa(verb + "--help");
      CHECK(help.code == 0);
      std::istringstream lines(help.out);
      std::size_t longest = 0;
      for (std::string line; std::getline(lines, line);) longest = std::max(longest, line.size());
      CHECK(longest > 60);
      CHECK(longest <= 100);
    }
  }

  TEST_CASE("every verb has --quiet") {
    const Folder folder;
    for (const std::string verb : {"mesh --alpha 0.02 -o a.off ", "shape --alpha 0.02 -o a.wkt ", "alpha ", "info "}) {
      CAPTURE(verb);
      const Outcome quiet = folder.rbpa(verb + points + "-q", 0);
      CHECK(quiet.err.empty());
      CHECK(quiet.out == folder.rbpa(verb + points).out);
    }
  }

  TEST_CASE("compact leaves out vertices without triangles and nothing else") {
    const Folder folder("p.xy", "50 50\n0 0\n1 0\n0 1\n");
    CHECK(folder.rbpa("mesh p.xy --alpha 1 -o - --output-format off -q").out ==
          "OFF\n4 1 0\n50 50 0\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n");
    CHECK(folder.rbpa("mesh p.xy --alpha 1 -o - --output-format off -q --compact").out ==
          "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  }

  TEST_CASE("info prints the number of points and duplicates, the box and the spacing") {
    const Folder folder("p.xy", "0 0\n4 0\n0 1\n4 1\n0 0\n");
    const auto info = nlohmann::json::parse(folder.rbpa("info p.xy --json").out);
    CHECK(info["points"] == 5);
    CHECK(info["distinct"] == 4);
    CHECK(info["duplicates"] == 1);
    CHECK(info["box"]["min"] == nlohmann::json::array({0.0, 0.0}));
    CHECK(info["box"]["max"] == nlohmann::json::array({4.0, 1.0}));
    CHECK(info["spacing"].get<double>() == doctest::Approx(1.0));
  }

  TEST_CASE("a summary is printed on standard error unless quiet") {
    const Folder folder("p.xy", "0 0\n1 0\n0 1\n0 1\n9 9\n");
    CHECK(folder.rbpa("mesh p.xy --alpha 1 -o m.off").err ==
          "rbpa: 5 points (1 duplicate), 1 triangle, 1 isolated -> m.off\n");
    CHECK(folder.rbpa("mesh p.xy --alpha 1 -o m.off --quiet").err.empty());
  }

  TEST_CASE("coordinates at the ends of double have pictures") {
    const Folder folder("p.xy", "-1.7e308 -1.7e308\n1.7e308 -1.7e308\n0 1.7e308\n5e-324 0\n");
    CHECK(folder.rbpa("mesh p.xy --alpha inf -o m.svg -o m.png -q").code == 0);
    CHECK(!contains(folder.content("m.svg"), "nan"));
    CHECK(!contains(folder.content("m.svg"), "inf"));
    CHECK(folder.content("m.png").substr(1, 3) == "PNG");
  }
}
