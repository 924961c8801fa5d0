// Folders of points: the files that are read, and are not, are listed.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/las_file.h"
#include "support/program.h"

using namespace apps_test;

namespace {

std::string tile(int x) { return bytes_of(LasFile{.points = {{.x = x}, {.x = x + 90}, {.x = x, .y = 90}}}); }

struct Listing {
  std::vector<std::string> names;  ///< a name that ends in / is a folder with a tile in it
  std::string said;                ///< after "rbpa: t: "; for a refusal the found and expected
  int code = 0;
};

const std::string several = "found points in files of several formats, such as ",
                  one = ", expected one format, or the names of files\n";

const std::vector<Listing> listings = {
    {{"a.las", "b.LAS"}, "2 files are read: a.las, b.LAS\n"},
    {{"a.las"}, "1 file is read: a.las\n"},
    {{"a.las", "index.csv", "sub/", "readme.md", "preview.png", "outline.geojson", "a.prj"},
     "1 file is read: a.las; not read: a.prj, index.csv, outline.geojson, preview.png, readme.md and 1 more\n"},
    {{"a.las", "b.las", "c.las", "d.las", "e.las", "f.las", "g.las", "sub/"},
     "7 files are read: a.las, b.las, c.las, d.las, e.las and 2 more; not read: sub/\n"},
    {{"a.csv", "b.txt", "c.xyz"}, "3 files are read: a.csv, b.txt, c.xyz\n"},
    {{"a.csv", "notes.md"}, "1 file is read: a.csv; not read: notes.md\n"},
    {{"a.laz", "b.copc.laz", "index.csv"}, "2 files are read: a.laz, b.copc.laz; not read: index.csv\n"},
    {{"a.las", "a.laz"}, "t: " + several + "a.las, a.laz" + one, 3},
    {{"a.las", "B.LAZ"}, "t: " + several + "B.LAZ, a.las" + one, 3},
    {{"a.las", "b.e57"},
     "t/b.e57: found points in a format that is not read, in a folder whose files are all read, expected a folder "
     "without them, or the names of files (pdal translate t/b.e57 points.las)\n",
     3},
    {{"a.las", "b.xyz"}, "t: " + several + "a.las, b.xyz" + one, 3},
    {{"a.las", "b.ply"}, "t: " + several + "a.las, b.ply" + one, 3},
    {{"a.csv", "b.geojson"}, "t: " + several + "a.csv, b.geojson" + one, 3},
    {{"readme.md", "sub/"}, "", 3}};

}  // namespace

TEST_SUITE("stream folders") {
  TEST_CASE(
      "the files of a folder that are read, and are not, are listed, and points that cannot be read are refused") {
    for (const Listing& listing : listings) {
      const Folder folder;
      std::filesystem::create_directory(folder.path("t"));
      int x = 0;
      for (const std::string& name : listing.names) {
        CAPTURE(name);
        if (name.back() == '/') {
          std::filesystem::create_directory(folder.path("t/" + name));
          folder.file("t/" + name + "inner.las", tile(x += 100));
        } else {
          const bool is_las = name.ends_with(".las") || name.ends_with(".LAS") || name.ends_with(".laz");
          folder.file("t/" + name, is_las ? tile(x += 100) : "0 0\n0.9 0\n0 0.9\n");
        }
      }
      CAPTURE(listing.said);
      const Outcome outcome = folder.rbpa("stream t --alpha 9 -o o.wkt");
      CHECK(outcome.code == listing.code);
      if (listing.code == 0) {
        CHECK(outcome.err.starts_with("rbpa: t: " + listing.said));
        CHECK(folder.rbpa("stream t --alpha 9 -o o.wkt -q").err.empty());
      } else {
        CHECK(folder.names() == std::vector<std::string>{"t"});
        if (!listing.said.empty()) CHECK(outcome.err == "rbpa: " + listing.said);
      }
    }
  }

  TEST_CASE("limits of areas are those of rbpa shape, need polygons, and say when no part is left") {
    const Folder folder("p.xy", corner);
    for (const std::string option : {"--min-hole-area", "--min-part-area"}) {
      CHECK(folder.rbpa("stream p.xy --alpha 2 -o o.npy " + option + " 3").err ==
            "rbpa: " + option + " requires polygons: -o FILE.geojson or FILE.wkt\n");
      const std::string bad = " p.xy --alpha 2 -o o.wkt " + option + " x";
      CHECK(folder.rbpa("stream" + bad).err == folder.rbpa("shape" + bad).err);
      CHECK(folder.names() == std::vector<std::string>{"p.xy"});
    }
    const Outcome outcome = folder.rbpa("stream p.xy --alpha 2 -o o.wkt --min-part-area 1000", 0);
    CHECK(outcome.err.starts_with("rbpa: the shape is empty: no part has an area >= 1000\n"));
    CHECK(folder.content("o.wkt") == "MULTIPOLYGON EMPTY\n");
  }
}
