// `rbpa stream --group-by` makes the bytes of `rbpa shape --group-by`.
#include <doctest/doctest.h>
#include <signal.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "robustness/moments.h"
#include "support/child.h"
#include "support/las_file.h"
#include "support/program.h"
#include "support/random.h"

using namespace apps_test;
using nlohmann::json;

namespace {

/// Points of several kinds and ages, some of them missing, on a grid, so that many repeat and outlines touch.
std::string table(std::size_t count, unsigned seed) {
  rbpa_test::Random random(seed);
  const std::vector<std::string> kinds = {"oak", "\"elm, wych\"", "", "beech", "1"};
  std::string points = "x,y,kind,age\n";
  for (std::size_t i = 0; i < count; ++i)
    points += std::to_string(random.below(60)) + "," + std::to_string(random.below(60)) + "," + kinds[random.below(5)] +
              "," + (random.below(9) == 0 ? "" : std::to_string(random.below(3))) + "\n";
  // A group on one line; one on a line in each file; a group without triangles; a group of one point.
  const std::string far = std::to_string(100 * seed);
  for (int i = 0; i < 40; ++i) {
    const std::string x = std::to_string(i);
    points += x + ",7,line,1\n" + x + "," + far + ",lines,1\n" + std::to_string(90 * i * i) + ",3,far,0\n";
  }
  return points + "3,3,lonely,2\n3,4,far,0\n1,1,short,2\n2,2,short,2\n5,5,short,2\n";
}

void check_same(const Folder& folder, const std::string& files, const std::string& options, const std::string& tiles) {
  CAPTURE(options);
  CAPTURE(tiles);
  const Outcome wanted = folder.rbpa("shape " + files + " " + options + " -o want.geojson --stats want.json");
  const Outcome made = folder.rbpa("stream " + files + " " + options + " " + tiles + " -o o.geojson --stats o.json");
  REQUIRE(wanted.code == 0);
  REQUIRE(made.code == 0);
  CHECK(folder.content("o.geojson") == folder.content("want.geojson"));
  std::string said = wanted.err;
  for (std::size_t at = 0; (at = said.find("want.geojson", at)) != std::string::npos;)
    said.replace(at, 12, "o.geojson");
  CHECK(made.err == said);
  json stats = json::parse(folder.content("o.json")), all = json::parse(folder.content("want.json"));
  for (json* report : {&stats, &all})
    for (const char* key : {"seconds", "peak_bytes", "threads"}) report->erase(key);
  CHECK(stats == all);
}

}  // namespace

TEST_CASE("groups have the bytes, the messages and the counts of shape, in memory and in tiles") {
  const Folder folder({{"a.csv", table(3000, 1)}, {"b.csv", table(900, 2)}});
  const std::vector<std::string> before = {"a.csv", "b.csv", "o.geojson", "o.json", "want.geojson", "want.json"};
  for (const char* by : {"kind", "age", "kind,age"})
    for (const char* areas : {"", "--min-hole-area 3 --min-part-area 2", "--min-hole-area inf --min-part-area 1e9"})
      for (const char* tiles : {"", "--tile-size 16 --threads 1", "--tile-size 300 --threads 3"}) {
        const std::string options = " --columns x,y --alpha 0.9 --group-by " + std::string(by) + " " + areas;
        check_same(folder, "a.csv b.csv", options, tiles);
        CHECK(folder.names() == before);
      }
  check_same(folder, "a.csv", "--columns x,y --alpha 2.5 --group-by kind --where 'x > 5' --crs EPSG:28992", "");
  check_same(folder, "a.csv", "--columns x,y --alpha 2.5 --group-by kind --bounds 90,90,95,95", "");  // no point
  CHECK(folder.rbpa("stream a.csv --columns x,y --alpha 1 --group-by kind -q -o o.geojson").err ==
        folder.rbpa("shape a.csv --columns x,y --alpha 1 --group-by kind -q -o o.geojson").err);
}

TEST_CASE("groups of LAS and GeoJSON are those of shape") {
  const Folder folder;
  rbpa_test::Random random(3);
  LasFile las;
  for (int i = 0; i < 2000; ++i)
    las.points.push_back({.x = 100 * static_cast<int>(random.below(40)),
                          .y = 100 * static_cast<int>(random.below(40)),
                          .classification = static_cast<unsigned>(random.below(4)),
                          .source = static_cast<unsigned>(random.below(2))});
  folder.file("p.las", bytes_of(las));
  for (const char* by : {"class", "point_source_id,class"})
    for (const char* tiles : {"", "--tile-size 50"})
      check_same(folder, "p.las", "--alpha 0.8 --group-by " + std::string(by), tiles);
  folder.file("p.geojson", R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"a":"10","b":10},"geometry":{"type":"Point","coordinates":[179,0]}},
{"type":"Feature","properties":{"a":"10","b":10},"geometry":{"type":"Point","coordinates":[182,0]}},
{"type":"Feature","properties":{"a":"10","b":10},"geometry":{"type":"Point","coordinates":[179,3]}},
{"type":"Feature","properties":{"a":"9","b":true},"geometry":{"type":"Point","coordinates":[1,0]}},
{"type":"Feature","properties":{"b":10},"geometry":{"type":"Point","coordinates":[0,1]}}]})");
  check_same(folder, "p.geojson", "--alpha 9 --group-by a", "");  // is cut at the antimeridian
  check_same(folder, "p.geojson", "--alpha 9 --group-by a,b", "");
  folder.file("d.csv", "lon,lat,k\n10,50,a\n10.5,50,a\n10,50.5,a\n");
  folder.file("e.csv", "x,y,k\n5,5,a\n5,5,b\n5,5,a\n");
  for (const char* options : {"d.csv --alpha 9", "e.csv --alpha 9", "d.csv --alpha 9 --crs EPSG:4326",
                              "e.csv --alpha 9 --crs EPSG:4326", "d.csv --alpha 9 --shift-longitude"}) {
    check_same(folder, options, "--group-by k", "");
    const std::string name = "rbpa: " + std::string(options, 5) + ": ";  // begins a warning
    const std::string shape = folder.rbpa("shape " + std::string(options) + " -o o.wkt").err;
    const std::string warnings = shape.substr(0, shape.find('\n', shape.rfind(name)) + 1);
    CHECK(shape.starts_with(name));
    CHECK(folder.rbpa("stream " + std::string(options) + " -o o.wkt").err.starts_with(warnings));
  }
}

TEST_CASE("groups have their areas in the counts, also without an output") {
  const Folder folder("p.csv", table(500, 6));
  const std::string options = " p.csv --columns x,y --alpha 0.9 --group-by kind --min-hole-area 3 --min-part-area 2 ";
  const Outcome wanted = folder.rbpa("shape" + options + "--stats want.json");
  const Outcome made = folder.rbpa("stream" + options + "--tile-size 16 --stats o.json");
  CHECK(wanted.code == 0);
  CHECK(made.code == 0);
  CHECK(made.err == wanted.err);
  CHECK(json::parse(folder.content("o.json"))["polygons"] == json::parse(folder.content("want.json"))["polygons"]);
}

TEST_CASE("what does not apply to groups is refused") {
  const Folder folder("p.csv", table(100, 4));
  const auto refused = [&](const std::string& options, const std::string& why) {
    refuses(folder, "stream p.csv --columns x,y --alpha 1 --group-by kind " + options, 2, why);
  };
  refused("-o o.npy", "--group-by: found o.npy, whose format has no groups here, expected geojson");
  refused("-o o.geojson --scratch s --keep-tiles", "--keep-tiles cannot be combined with --group-by");
  CHECK(folder.names() == std::vector<std::string>{"p.csv"});
  CHECK(folder.rbpa("stream p.csv --columns x,y --alpha 1 -o o.npy --scratch s --keep-tiles -q").code == 0);
  refused("-o o.geojson --scratch s --resume",
          "--group-by: found another run in s, expected an empty folder, or --scratch with a new name");
}

TEST_CASE("a run on groups that was killed leaves what the next one takes over or removes, and a signal ends it") {
  rbpa_test::Random random(8);
  const Folder folder("p.csv", table(20'000, 5));
  REQUIRE(folder.rbpa("shape p.csv --columns x,y --alpha 0.9 --group-by kind -o want.geojson -q").code == 0);
  for (int moment = 0; moment < robustness::moments(); ++moment)
    for (const bool named : {false, true}) {
      Child::Command words = {RBPA_PROGRAM,
                              "stream",
                              folder.path("p.csv"),
                              "--columns",
                              "x,y",
                              "--alpha",
                              "0.9",
                              "--group-by",
                              "kind",
                              "--tile-size",
                              "1000",
                              "-o",
                              folder.path("o.geojson"),
                              "-q"};
      if (named) words.insert(words.end(), {"--scratch", folder.path("s"), "--resume"});
      for (const int signal : {SIGKILL, SIGINT}) {
        Child child(words);
        usleep(static_cast<useconds_t>(random.below(400'000)));
        child.send(signal);
        const Ending ending = child.wait();
        // A signal before main() ends the process as any other.
        if (signal == SIGINT && ending.by_itself() && ending != Ending{0, 0}) CHECK(ending == Ending{130, 0});
      }
      Child last(words);
      CHECK(last.wait() == Ending{0, 0});
      CHECK(folder.content("o.geojson") == folder.content("want.geojson"));
      CHECK(folder.names() == std::vector<std::string>{"o.geojson", "p.csv", "want.geojson"});
    }
}
