// Arguments and messages of `rbpa stream`.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program.h"

using namespace apps_test;

namespace {

const std::string square = "0 0\n1 0\n0 1\n1 1\n";

std::string said(const Folder& folder, const std::string& arguments, int code) {
  CAPTURE(arguments);
  const Outcome outcome = folder.rbpa("stream " + arguments, code);
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  return outcome.err;
}

}  // namespace

TEST_CASE("a run prints what it has made, and leaves nothing else") {
  const Folder folder({{"a.xy", square}, {"b.xy", "1 1\n5 5\n"}});
  const Outcome outcome = folder.rbpa("stream a.xy b.xy --alpha 1 -o t.npy -o p.wkt --stats s.json", 0);
  CHECK(outcome.err ==
        "rbpa: 6 points (1 duplicate) in 1 tile, 2 triangles, 1 isolated, 1 polygon with 0 holes, area 1 -> t.npy, "
        "p.wkt\n");
  CHECK(folder.content("p.wkt") == "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)))\n");
  CHECK(folder.names() == std::vector<std::string>{"a.xy", "b.xy", "p.wkt", "s.json", "t.npy"});
  const auto stats = nlohmann::json::parse(folder.content("s.json"));
  CHECK(stats.at("points") == 6);
  CHECK(stats.at("distinct") == 5);
  CHECK(stats.at("triangles") == 2);
  CHECK(stats.at("edges") == 5);
  CHECK(stats.at("holes") == 0);
  CHECK(stats.at("polygons") == 1);
  CHECK(stats.at("tiles") == 1);
  const auto& seconds = stats.at("seconds");
  CHECK(seconds.at("count").get<double>() + seconds.at("cut").get<double>() == seconds.at("read").get<double>());
  CHECK(folder.rbpa("stream a.xy --alpha 1 -o - --output-format wkt -q").out ==
        "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)))\n");
  CHECK(folder.rbpa("stream a.xy --alpha 1 -o /dev/null --output-format npy -q").code == 0);
  CHECK(folder.rbpa("stream a.xy --alpha 0.1 -o e.wkt")
            .err.starts_with("rbpa: the complex is empty: no triangle has circumradius <= 0.1\n"));
  CHECK(folder.content("e.wkt") == "MULTIPOLYGON EMPTY\n");
}

TEST_CASE("folders are read as their files of points by name, and each tile has a mesh file") {
  const Folder folder;
  std::filesystem::create_directory(folder.path("in"));
  std::filesystem::create_directory(folder.path("out"));
  std::string grid;  // too many for one tile
  for (int x = 0; x < 12; ++x)
    for (int y = 0; y < 4; ++y) grid += std::to_string(x) + " " + std::to_string(y) + "\n";
  folder.file("in/b.xy", grid);
  folder.file("in/a.csv", "20,0\n20,1\n");
  folder.file("in/readme.md", "no points");
  CHECK(folder.rbpa("stream in --alpha 1 --tile-size 16 -o t.npy -o 'out/*.ply' -q").code == 0);
  folder.file("all.xy", "20 0\n20 1\n" + grid);
  REQUIRE(folder.rbpa("mesh all.xy --alpha 1 -o want.npy -q").code == 0);
  CHECK(folder.content("t.npy") == folder.content("want.npy"));
  const auto tiles = std::filesystem::directory_iterator(folder.path("out"));
  std::size_t faces = 0;
  for (const auto& tile : tiles) {
    const std::string ply = read_file(tile.path());
    const std::size_t at = ply.find("element face ");
    REQUIRE(at != std::string::npos);
    faces += std::stoul(ply.substr(at + 13));
  }
  CHECK(faces == 66);
}

TEST_CASE("wrong arguments are refused with the reason") {
  const Folder folder({{"a.xy", square}, {"b.geojson", "x"}});
  std::filesystem::create_directory(folder.path("none"));
  CHECK(contains(said(folder, "a.xy -o t.npy", 2), "--alpha is required"));
  for (const char* alpha : {"inf", "auto", "min", "plateau"}) {
    const std::string text = said(folder, std::string("a.xy -o t.npy --alpha ") + alpha, 2);
    CHECK(contains(text, "rbpa alpha on a sample"));
    CHECK(contains(text, alpha));
  }
  CHECK(contains(said(folder, "a.xy -o t.npy --alpha 0", 2), "expected a radius"));
  CHECK(contains(said(folder, "- -o t.npy --alpha 1", 2), "read twice"));
  CHECK(contains(said(folder, "a.xy --alpha 1", 2), "-o: found no OUT"));
  CHECK(contains(said(folder, "a.xy --alpha 1 -o t.off", 2), "found the ending 'off', expected one of geojson"));
  CHECK(contains(said(folder, "a.xy --alpha 1 -o t.ply", 2), "found no '*' in the name of the file"));
  CHECK(contains(said(folder, "a.xy --alpha 1 -o a.xy --output-format wkt", 2), "a.xy"));
  CHECK(contains(said(folder, "a.xy --alpha 1 -o t.npy --memory 1M", 2), "--memory: found '1M'"));
  CHECK(contains(said(folder, "a.xy --alpha 1 -o t.npy --memory lots", 2), "--memory: found 'lots'"));
  for (const std::string few : {"0", "1", "15"})
    CHECK(contains(said(folder, "a.xy --alpha 1 -o t.npy --tile-size " + few, 2), "--tile-size: found '" + few + "'"));
  CHECK(contains(said(folder, "a.xy --alpha 1 -o t.npy --resume", 2), "--resume requires --scratch"));
  CHECK(contains(said(folder, "a.xy --alpha 1 -o t.npy --keep-tiles", 2), "--keep-tiles requires --scratch"));
  CHECK(contains(said(folder, "none --alpha 1 -o t.npy", 3), "a folder without files of points"));
  CHECK(said(folder, "c.xy --alpha 1 -o t.npy", 3) == "rbpa: c.xy: found no such file, expected a file of points\n");
  CHECK(contains(said(folder, "a.xy --alpha 1 -o t.npy --scratch .", 2), "found files of another program in ."));
  CHECK(contains(said(folder, "a.xy --alpha 1 -o t.npy --scratch a.xy", 1), "cannot make the folder"));
  CHECK(contains(said(folder, "a.xy --alpha 1 -o nowhere/t.npy", 1), "nowhere"));
  CHECK(folder.names() == std::vector<std::string>{"a.xy", "b.geojson", "none"});
}

TEST_CASE("files of different coordinate systems are refused as one input") {
  const Folder folder(
      {{"a.csv", "geometry\n\"SRID=28992;POINT (1 2)\"\n"}, {"b.csv", "geometry\n\"SRID=31370;POINT (1 2)\"\n"}});
  CHECK(contains(said(folder, "a.csv b.csv --alpha 1 -o p.wkt", 3), "expected EPSG:28992, as in a.csv"));
  CHECK(folder.rbpa("stream a.csv b.csv --alpha 1 --crs EPSG:28992 -o p.wkt -q").code == 0);
}

TEST_CASE("too many points within 2 alpha are refused with place, number and the memory that suffices") {
  const Folder folder;
  std::string points(16 * 300'000, '\0');
  double* values = reinterpret_cast<double*>(points.data());
  unsigned state = 1;
  for (std::size_t i = 0; i < 600'000; ++i)
    values[i] = double((state = state * 1664525u + 1013904223u) >> 8U) * 0x1p-24;
  folder.file("p.f64xy", points);
  const std::string text = said(folder, "p.f64xy --alpha 5 --memory 64M -o p.wkt -q", 1);
  CHECK(contains(text, "--memory 64M: found 300000 points within 2 alpha = 10 of each other near ("));
  const std::size_t at = text.find(" (--memory ");
  REQUIRE(at != std::string::npos);
  const std::string enough = text.substr(at + 11, text.find(' ', at + 11) - at - 11);
  CHECK(folder.rbpa("stream p.f64xy --alpha 5 --memory " + enough + " -o p.wkt -q").code == 0);
  CHECK(folder.names() == std::vector<std::string>{"p.f64xy", "p.wkt"});
}

TEST_CASE("an outline that does not fit into memory for its filter is refused with the memory that suffices") {
  const Folder folder;
  std::string points;
  for (int x = 0; x < 200; ++x)
    for (int y = 0; y < 100; ++y)
      for (const auto& [right, up] : {std::pair(0, 0), {1, 0}, {0, 1}})
        points += std::to_string(9 * x + right) + " " + std::to_string(9 * y + up) + "\n";
  folder.file("p.xy", points);
  const std::string run = "p.xy --alpha 1 -o p.geojson -q --min-part-area 0.5 --memory ";
  const std::string text = said(folder, run + "64M", 1);
  CHECK(text.starts_with("rbpa: --memory 64M: found about 130000 corners of polygons, expected at most "));
  const std::size_t at = text.find(" (--memory ");
  REQUIRE(at != std::string::npos);
  CHECK(folder.rbpa("stream " + run + text.substr(at + 11, text.find(' ', at + 11) - at - 11)).code == 0);
  CHECK(folder.rbpa("shape p.xy --alpha 1 -o w.geojson -q --min-part-area 0.5").code == 0);
  CHECK(folder.content("p.geojson") == folder.content("w.geojson"));
}
