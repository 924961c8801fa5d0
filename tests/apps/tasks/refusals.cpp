// What does not belong together is found and said, and never becomes a result.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/program.h"
#include "support/random.h"

using namespace apps_test;
namespace fs = std::filesystem;

namespace {

std::string said(const Folder& folder, const std::string& arguments, int code) {
  CAPTURE(arguments);
  const Outcome outcome = folder.rbpa(arguments);
  CAPTURE(outcome.err);
  CHECK(outcome.code == code);
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  return outcome.err;
}

bool has(const std::string& text, const std::string& part) {
  CAPTURE(text);
  CAPTURE(part);
  const bool found = text.find(part) != std::string::npos;
  CHECK(found);
  return found;
}

std::string points(std::uint64_t seed, std::size_t count = 400) {
  rbpa_test::Random random(seed);
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
    text += std::to_string(random.below(2000)) + " " + std::to_string(random.below(2000)) + "\n";
  return text;
}

void run_tiles(const Folder& folder, const std::string& tasks) {
  REQUIRE(folder.run("sh", "-e " + tasks + "/1-tiles.txt").code == 0);
}

/// A run of eight tiles or so in the folder "T", the tiles done.
void make_run(const Folder& folder) {
  folder.file("p.xy", points(51));
  REQUIRE(folder.rbpa("stream p.xy --alpha 90 --tile-size 60 --tasks T -o t.npy -o p.wkt -q").code == 0);
  run_tiles(folder, "T");
}

void change(const std::string& path, std::size_t at) {
  std::string content = read_file(path);
  REQUIRE(at < content.size());
  content[at] = char(content[at] ^ 4);
  std::ofstream(path, std::ios::binary) << content;
}

const std::string all = "T/partials/1-*.partial";

}  // namespace

TEST_CASE("--tasks is used alone, with an empty folder") {
  const Folder folder;
  folder.file("p.xy", corner);
  const std::string run = "stream p.xy --alpha 1 -o t.npy ";
  has(said(folder, run + "--tasks .", 2), "--tasks: found other files in .");
  has(said(folder, run + "--tasks ''", 2), "--tasks: found an empty name");
  has(said(folder, run + "--tasks T --scratch S", 2), "--scratch cannot be combined with --tasks");
  has(said(folder, run + "--tasks T --keep-tiles", 2), "--keep-tiles cannot be combined with --tasks");
  has(said(folder, run + "--tasks T --output-format wkt", 2), "--output-format cannot be combined with --tasks");
  has(said(folder, "stream p.xy --alpha 1 -o - --tasks T", 2), "-o - cannot be combined with --tasks");
  has(said(folder, "stream p.xy --alpha inf -o t.npy --tasks T", 2), "--alpha: found inf, expected a finite radius");
  has(said(folder, "stream p.xy --alpha 1 -o 'a\nb.npy' --tasks N", 2), "found a newline in the name");
  CHECK(!folder.has("T"));
  CHECK(folder.rbpa(run + "--tasks T -q").code == 0);
  has(said(folder, run + "--tasks T", 2), "--tasks: found a run in T, expected --resume to continue it");
  has(said(folder, run + "--scratch T --resume", 2), "--resume: found");  // it would remove the lists' files
  const std::string before = folder.content("T/Makefile");
  CHECK(folder.rbpa(run + "--tasks T --resume -q").code == 0);
  CHECK(folder.content("T/Makefile") == before);
  CHECK(folder.names() == std::vector<std::string>{"T", "p.xy"});
}

TEST_CASE("endings of outputs are checked") {
  const Folder folder;
  make_run(folder);
  const std::string tile = "tile T/tiles/000000.tile ";
  has(said(folder, tile, 2), "found no -o OUT");
  has(said(folder, tile + "-o a.off", 2), "a name that ends in .partial, .npy or .ply");
  has(said(folder, tile + "-o a.npy -o b.npy", 2), "expected one file of each kind");
  has(said(folder, tile + "-o a.partial --threads 0", 2), "--threads: found '0'");
  has(said(folder, tile + "-o a.partial -o a.npy --stats a.npy", 2), "a.npy");
  has(said(folder, tile + "-o no/a.partial", 1), "no/a.partial");
  has(said(folder, "tile p.xy -o a.partial", 3), "run.json: found no file");
  has(said(folder, "tile T/tiles/000099.tile -o a.partial", 3), "000099.tile: found no file");
  has(said(folder, "tile T/run.json -o a.partial", 3), "run.json");
  has(said(folder, "merge " + all, 2), "found no -o OUT");
  has(said(folder, "merge " + all + " -o a.partial -o b.npy", 2), "found a partial and 1 other file");
  has(said(folder, "merge " + all + " -o 'a*.ply'", 2), "rbpa tile writes the mesh of a tile");
  has(said(folder, "merge " + all + " -o T/partials/1-000000.partial", 2), "1-000000.partial");
  has(said(folder, "merge " + all + " -o a.wkt --memory 3", 2), "--memory: found '3'");
  has(said(folder, "merge p.xy -o a.wkt", 3), "p.xy: found a file of another kind");
  has(said(folder, "merge nothing.partial -o a.wkt", 3), "nothing.partial: found no such file");
  CHECK(folder.names() == std::vector<std::string>{"T", "p.xy"});
}

TEST_CASE("missing and repeated parts are named") {
  const Folder folder;
  make_run(folder);
  REQUIRE(folder.has("T/partials/1-000005.partial"));
  const auto partials = [&](const std::string& but) {
    std::string names;
    for (const auto& entry : fs::directory_iterator(folder.path("T/partials")))
      if (entry.path().extension() == ".partial" && entry.path().stem() != but)
        names += " T/partials/" + entry.path().filename().string();
    return names;
  };
  has(said(folder, "merge" + partials("1-000003") + " -o a.wkt", 3), "found no tile 3 in the partials, expected all ");
  has(said(folder, "merge T/partials/1-000000.partial -o a.wkt", 3), "found no tile 1 nor ");
  has(said(folder, "merge " + all + " T/partials/1-000003.partial -o a.wkt", 3),
      "T/partials/1-000003.partial: found tile 3, which T/partials/1-000003.partial has too");
  REQUIRE(folder.rbpa("merge T/partials/1-000002.partial T/partials/1-000003.partial -o two.partial -q").code == 0);
  has(said(folder, "merge two.partial" + partials("1-000002") + " -o b.partial", 3),
      "tile 3, which two.partial has too");
  // Triangles that nobody has written.
  REQUIRE(folder.rbpa("tile T/tiles/000003.tile -o T/partials/1-000003.partial -q").code == 0);
  has(said(folder, "merge " + all + " -o a.npy", 3), "found files with ");
  CHECK(folder.rbpa("merge " + all + " -o a.wkt -q").code == 0);
  CHECK(folder.names() == std::vector<std::string>{"T", "a.wkt", "p.xy", "two.partial"});
}

TEST_CASE("partials and tiles of another run are refused") {
  const Folder folder;
  make_run(folder);
  folder.file("q.xy", points(52));
  const std::string first = "T/partials/1-000000.partial ";
  const auto run = [&](const std::string& run_key, const std::string& tasks) {
    REQUIRE(folder.rbpa("stream " + run_key + " -o t.npy -o p.wkt -q --tasks " + tasks).code == 0);
    run_tiles(folder, tasks);
  };
  run("p.xy --alpha 80 --tile-size 60", "A");
  has(said(folder, "merge " + first + "A/partials/1-000001.partial -o a.partial", 3),
      "A/partials/1-000001.partial: found a partial for alpha 80, expected 90 as T/partials/1-000000.partial has");
  run("q.xy --alpha 90 --tile-size 60", "Q");
  has(said(folder, "merge " + first + "Q/partials/1-000001.partial -o a.partial", 3), "found a partial of run ");
  run("p.xy --alpha 90 --tile-size 50", "S");
  has(said(folder, "merge " + first + "S/partials/1-000001.partial -o a.partial", 3), "found a partial of run ");
  // The same run_key once more is the same run.
  run("p.xy --alpha 90 --tile-size 60", "R");
  CHECK(folder.rbpa("merge " + first + "R/partials/1-000001.partial -o a.partial -q").code == 0);

  const std::string tile = folder.content("T/tiles/000001.tile");
  folder.file("T/tiles/000001.tile", folder.content("A/tiles/000001.tile"));
  has(said(folder, "tile T/tiles/000001.tile -o b.partial", 3), "found a tile cut for alpha 80, expected 90");
  // Of the same radius: it does not fit the others.
  folder.file("T/tiles/000001.tile", folder.content("Q/tiles/000001.tile"));
  REQUIRE(folder.rbpa("tile T/tiles/000001.tile -o T/partials/1-000001.partial -q").code == 0);
  const Outcome outcome = folder.rbpa("merge " + all + " -o b.wkt");
  CHECK(outcome.code == 3);
  CHECK(!folder.has("b.wkt"));
  folder.file("T/tiles/000001.tile", tile);
  CHECK(folder.rbpa("tile T/tiles/000001.tile -o T/partials/1-000001.partial -q").code == 0);
  CHECK(folder.rbpa("merge " + all + " -o b.wkt -q").code == 0);
}

TEST_CASE("a damaged file is named and nothing is written; done again, the result is the same") {
  const Folder folder;
  make_run(folder);
  REQUIRE(folder.rbpa("merge " + all + " -o t.npy -o p.wkt -q").code == 0);
  const std::string triangles = folder.content("t.npy"), polygons = folder.content("p.wkt");
  rbpa_test::Random random(53);
  for (const char* name :
       {"T/tiles/000002.tile", "T/partials/1-000002.partial", "T/triangles/000002.npy", "T/run.json"}) {
    const std::string content = folder.content(name);
    for (int round = 0; round < 5; ++round) {
      CAPTURE(name);
      CAPTURE(round);
      const std::size_t at = random.below(content.size());
      if (round == 0)
        fs::remove(folder.path(name));
      else if (round == 1)
        fs::resize_file(folder.path(name), at);
      else if (round == 2)
        folder.file(name, content + "x");
      else
        change(folder.path(name), at);
      const bool of_tile = name[2] == 't' && name[3] == 'i';
      if (std::string_view(name) == "T/run.json") {
        has(said(folder, "tile T/tiles/000002.tile -o a.partial", 3), "run.json: found ");
      } else if (of_tile) {
        const std::string text = said(folder, "tile T/tiles/000002.tile -o a.partial", 3);
        has(text, name);
        has(text, "--resume makes it again");
        CHECK(folder.rbpa("stream p.xy --alpha 90 --tile-size 60 --tasks T -o t.npy -o p.wkt -q --resume").code == 0);
        CHECK(
            folder.rbpa("tile T/tiles/000002.tile -o T/partials/1-000002.partial -o T/triangles/000002.npy -q").code ==
            0);
      } else {
        const bool is_gone = round == 0 && name[2] == 'p';
        has(said(folder, "merge " + all + " -o u.npy -o u.wkt", 3), is_gone ? "found no tile 2 in" : name);
      }
      if (!of_tile) folder.file(name, content);
      CHECK(folder.names() == std::vector<std::string>{"T", "p.wkt", "p.xy", "t.npy"});
    }
  }
  // Polygons beside a partial.
  std::string found;
  for (const auto& entry : fs::directory_iterator(folder.path("T/partials")))
    if (entry.path().extension() == ".polygons") found = "T/partials/" + entry.path().filename().string();
  REQUIRE(!found.empty());
  const std::string content = folder.content(found);
  change(folder.path(found), content.size() / 2);
  has(said(folder, "merge " + all + " -o u.wkt", 3), found);
  folder.file(found, content);
  CHECK(folder.rbpa("merge " + all + " -o t.npy -o p.wkt -q").code == 0);
  CHECK(folder.content("t.npy") == triangles);
  CHECK(folder.content("p.wkt") == polygons);
}

TEST_CASE("a task prints what it has done, and --stats of the last has the counts of the whole") {
  const Folder folder;
  make_run(folder);
  REQUIRE(folder.rbpa("stream p.xy --alpha 90 -o p.wkt -q --stats want.json").code == 0);
  const Outcome tile = folder.rbpa("tile T/tiles/000000.tile -o 0.partial --stats 0.json");
  CHECK(tile.err.starts_with("rbpa: tile 0: "));
  CHECK(tile.err.ends_with(" -> 0.partial\n"));
  const auto of_tile = nlohmann::json::parse(folder.content("0.json"));
  CHECK(of_tile.at("points").get<int>() > 0);
  CHECK(of_tile.at("triangles").is_null());
  CHECK(of_tile.at("peak_bytes").get<double>() > 0);
  CHECK(folder.rbpa("merge T/partials/1-000000.partial T/partials/1-000001.partial -o 1.partial")
            .err.starts_with("rbpa: 2 partials of 2 of "));
  REQUIRE(folder.rbpa("merge " + all + " -o q.wkt -q --stats got.json").code == 0);
  const auto want = nlohmann::json::parse(folder.content("want.json"));
  const auto got = nlohmann::json::parse(folder.content("got.json"));
  for (const char* key :
       {"points", "distinct", "isolated", "triangles", "edges", "vertices", "boundary_curves", "solid_components",
        "components", "holes", "alpha", "polygons", "polygon_holes", "area", "perimeter"})
    CHECK(want.at(key) == got.at(key));
  CHECK(folder.rbpa("merge " + all + " -o - --output-format wkt -q").out == folder.content("q.wkt"));
}

TEST_CASE("the only tile of a run, in place of another's, is recognized by its points") {
  const Folder folder;
  folder.file("p.xy", points(54));
  folder.file("q.xy", points(54, 399));
  for (const char* name : {"p", "q"})
    REQUIRE(folder.rbpa(std::string("stream ") + name + ".xy --alpha 90 -o w.wkt -q --tasks " + name).code == 0);
  folder.file("p/tiles/000000.tile", folder.content("q/tiles/000000.tile"));
  REQUIRE(folder.rbpa("tile p/tiles/000000.tile -o a.partial -q").code == 0);
  has(said(folder, "merge a.partial -o w.wkt", 3), "found 399 points in the partials, expected the 400 of the run");
}
