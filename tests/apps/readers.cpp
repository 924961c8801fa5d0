// Every reader of files: its result is the same for names that are not UTF-8, and for pipes.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/claiming_files.h"
#include "support/gzip.h"
#include "support/image_files.h"
#include "support/mesh_files.h"
#include "support/program.h"

using namespace apps_test;

namespace {

/// A command that reads a file; the name comes between the two parts.
struct Reader {
  File file;
  std::string before, behind;
};

std::vector<Reader> readers() {
  const std::string doubles(64, '\0'), polygon = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n";
  std::vector<Reader> all;
  const auto add = [&](const std::vector<File>& files, const std::string& before, const std::string& behind) {
    for (const File& file : files) all.push_back({file, before, behind});
  };
  const std::string rbpa = RBPA_PROGRAM, meshtopo = MESHTOPO_PROGRAM;
  add(claiming_points(), rbpa + " info ", "");
  add({{"p.xy", corner},
       {"p.csv", "x,y\n0,0\n1,0\n0,1\n"},
       {"p.geojson", R"({"type": "MultiPoint", "coordinates": [[0,0],[1,0],[0,1]]})"},
       {"p.wkt", "MULTIPOINT (0 0, 1 0, 0 1)\n"},
       {"p.f64xy", doubles},
       {"p.png", png({2, 2, {0, 255, 255, 255}}, PngKind::grey, 8)}},
      rbpa + " info ", "");
  const std::string to_output = " --radius 1 -q -o - --output-format off";
  add(claiming_space(), rbpa + " surface ", to_output);
  add({{"p.xyz", "0 0 0\n1 0 0\n0 1 0\n"}, {"p.obj", pyramid_obj}}, rbpa + " surface ", to_output);
  add(claiming_meshes(), meshtopo + " ", "");
  add({{"p.obj", pyramid_obj}, {"t.stl", stl_text(pyramid_triangles)}}, meshtopo + " ", "");
  const std::string size = " --size 0.5 -q -o - --output-format off";
  add({{"q.wkt", polygon},
       {"q.json", R"({"type": "Polygon", "coordinates": [[[0,0],[1,0],[1,1],[0,1],[0,0]]]})"},
       {"q.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n"}},
      rbpa + " fill ", size);
  add({{"sizes", "0 0 0.2\n1 1 0.4\n"}}, rbpa + " fill square.wkt --size-at ", size);
  return all;
}

Outcome run(const Folder& folder, const Reader& reader, const std::string& name, const std::string& first = "") {
  return folder.run("/bin/sh", "-c '" + first + reader.before + name + reader.behind + "'");
}

/// Runs each reader on its file, and calls check(folder, reader, output).
template <typename Check>
void for_each_reader(const Check& check) {
  const Folder folder("square.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n");
  for (const Reader& reader : readers()) {
    CAPTURE(reader.file.name);
    folder.file(reader.file.name, reader.file.content);
    const Outcome plain = run(folder, reader, reader.file.name);
    CHECK(plain.code == 0);
    CHECK_FALSE(plain.out.empty());
    check(folder, reader, plain.out);
  }
}

}  // namespace

TEST_SUITE("readers") {
  TEST_CASE("files with names in Latin-1 are read, compressed or not") {
    for_each_reader([](const Folder& folder, const Reader& reader, const std::string& expected) {
      const auto& [name, content, behind] = reader.file;
      const std::string latin = "\xE9t\xE9 " + name, shown = "\\xe9t\\xe9 " + name;
      folder.file(latin, content);
      folder.file(latin + ".gz", compressed(content));
      for (const std::string& file : {latin, latin + ".gz"})
        CHECK(run(folder, reader, "\"" + file + "\"").out == expected);
      folder.file(latin, "");
      const Outcome empty = run(folder, reader, "\"" + latin + "\"");
      CHECK(empty.code == 3);
      CHECK(contains(empty.err, ": " + shown + ": found "));
    });
  }

  TEST_CASE("named pipes are read whose bytes, compressed or not, come late and by pieces") {
    for_each_reader([](const Folder& folder, const Reader& reader, const std::string& expected) {
      const auto& [name, content, behind] = reader.file;
      for (const bool is_compressed : {false, true}) {
        CAPTURE(is_compressed);
        const std::string bytes = is_compressed ? compressed(content) : content;
        folder.file("first", bytes.substr(0, bytes.size() / 2));
        folder.file("second", bytes.substr(bytes.size() / 2));
        const std::string pipe = "pipe." + name + (is_compressed ? ".gz" : "");
        REQUIRE(mkfifo(folder.path(pipe).c_str(), 0600) == 0);
        const Outcome outcome =
            run(folder, reader, pipe, "(sleep 0.01; cat first; sleep 0.01; cat second) > " + pipe + " & ");
        CHECK(outcome.code == 0);
        CHECK(outcome.out == expected);
        std::filesystem::remove(folder.path(pipe));
      }
    });
  }
}
