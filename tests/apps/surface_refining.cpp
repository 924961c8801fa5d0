// --refine of `rbpa surface`: fillings with points inside, in every kind of file, with all values of points.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "support/program.h"
#include "support/spiral.h"

using namespace apps_test;
using nlohmann::json;

namespace {

/// Returns a sphere of radius 1 without the part above `top`; each point with its normal, and all with the same color.
std::string bowl(double top, const std::string& behind) {
  std::ostringstream text;
  text.precision(17);
  for (const auto& [x, y, z] : rbpa_test::spiral(1500))
    if (z <= top) text << x << ' ' << y << ' ' << z << ' ' << x << ' ' << y << ' ' << z << behind << '\n';
  return text.str();
}

std::size_t vertices_of(const Folder& folder, const std::string& file) {
  return json::parse(folder.meshtopo(file + " --json").out)["vertices"].get<std::size_t>();
}

}  // namespace

TEST_SUITE("surface") {
  TEST_CASE("fillings get points, and the files are closed surfaces of these and the others") {
    const Folder folder("s.xyz", bowl(0.8, ""));
    const json coarse = json::parse(folder.rbpa("surface s.xyz --radius 0.12 --watertight --json -o c.off").out);
    CHECK(coarse["filled"]["points"] == 0);
    const Outcome outcome = folder.rbpa(
        "surface s.xyz --radius 0.12 --watertight --refine --json -o m.ply -o m.off -o m.obj -o m.stl -o m.glb -o "
        "m.vtu",
        0);
    const json report = json::parse(outcome.out);
    const auto added = report["filled"]["points"].get<std::size_t>();
    CHECK(added > 50);
    CHECK(report["filled"]["smooth"] == 1);
    CHECK(report["points"] == coarse["points"]);
    CHECK(report["triangles"].get<std::size_t>() == coarse["triangles"].get<std::size_t>() + 2 * added);
    CHECK(report["filled"]["triangles"].get<std::size_t>() ==
          coarse["filled"]["triangles"].get<std::size_t>() + 2 * added);
    CHECK(report["filled"]["area"].get<double>() > coarse["filled"]["area"].get<double>());
    CHECK(contains(outcome.err, ", with " + std::to_string(added) + " points added, 1 filling made smooth\n"));
    for (const std::string file : {"m.ply", "m.off", "m.obj", "m.stl"}) {
      CAPTURE(file);
      CHECK(folder.meshtopo(file + " --check closed,manifold,genus=0,components=1").code == 0);
      CHECK(vertices_of(folder, file) == vertices_of(folder, "c.off") + added);
    }
  }

  TEST_CASE("refining works with colors, estimated normals, outliers and moved points") {
    const Folder folder("s.txt", "x y z nx ny nz r g b\n9 9 9 0 0 1 1 2 3\n" + bowl(0.8, " 40 80 120"));
    const json with_outlier = json::parse(
        folder.rbpa("surface s.txt --drop-outliers auto --radius 0.12 --fill-holes all --refine --json -o m.ply").out);
    REQUIRE(with_outlier["outliers"]["points"] == 1);
    const auto added = with_outlier["filled"]["points"].get<std::size_t>();
    CHECK(added > 50);
    CHECK(contains(folder.content("m.ply"),
                   "element vertex " + std::to_string(with_outlier["points"].get<std::size_t>() + added)));
    for (const std::string more :
         {"--normals estimate", "--scale-space 1", "--scale-space 1 --moved", "--compact", "--manifold"}) {
      CAPTURE(more);
      CHECK(json::parse(folder
                            .rbpa("surface s.txt --drop-outliers auto --radius 0.12 --fill-holes all --refine --json "
                                  "-o m.ply -o m.png " +
                                      more,
                                  0)
                            .out)["filled"]["points"]
                .get<std::size_t>() > 50);
      CHECK(json::parse(folder.meshtopo("m.ply --json").out)["boundary_curves"] == 0);
    }
  }

  TEST_CASE("wrong usage of --refine is refused") {
    const Folder folder("s.xyz", bowl(0.8, ""));
    CHECK(folder.rbpa("surface s.xyz --radius 0.12 --refine -o m.off").err ==
          "rbpa: --refine requires --fill-holes or --watertight\n");
    CHECK(folder.rbpa("surface s.xyz --radius 0.12 --watertight --refine -o m.npy").err ==
          "rbpa: --refine: found 'm.npy', whose rows are numbers of input points, expected a format with points\n");
  }
}
