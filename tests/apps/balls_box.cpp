// `rbpa balls --box`: sizes of balls in a box that repeats, given or in the file, frame by frame, and wrong calls.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>

#include "support/program.h"

using namespace apps_test;
using Json = nlohmann::json;
using doctest::Approx;
using std::numbers::pi;

namespace {

/// Returns a frame of LAMMPS with one atom at the origin, in a box with the sides 1, 1 and z.
std::string frame(int number, const std::string& z, const std::string& repeats = "pp pp pp") {
  return "ITEM: TIMESTEP\n" + std::to_string(number) + "\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS " + repeats +
         "\n0 1\n0 1\n0 " + z + "\nITEM: ATOMS id type x y z\n1 1 0 0 0\n";
}

const std::string ball = " --radii column:r --json -q";

}  // namespace

TEST_SUITE("balls in a box") {
  TEST_CASE("a box is one length, three sides, lengths and angles, or that of each frame of the file") {
    const Folder folder({{"one.csv", "x,y,z,r\n0.3,7.1,-2,0.6\n"},
                         {"f.dump", frame(0, "1") + frame(1, "2") + frame(2, "1", "pp pp ff")}});
    const double whole = 4 * pi * 0.36, cap = 2 * pi * 0.6 * 0.1;
    const auto area = [&](const std::string& arguments, std::size_t number = 0) {
      return Json::parse(folder.rbpa("balls " + arguments, 0).out)["frames"][number]["area"].get<double>();
    };
    CHECK(area("one.csv --box 1" + ball) == Approx(whole - 6 * cap));
    CHECK(area("one.csv --box 1,2,1" + ball) == Approx(whole - 4 * cap));
    CHECK(area("one.csv --box 1,1,1,90,90,90" + ball) == Approx(whole - 6 * cap));
    const double six_in_a_plane = area("one.csv --box 1,1,2,90,90,60" + ball);
    CHECK(six_in_a_plane == Approx(area("one.csv --box 1,1,2,90,90,120" + ball)));
    CHECK(six_in_a_plane > whole - 6 * cap);  // caps overlap
    const std::string frames = "f.dump --radius-default 0.6 --models all --box auto --json -q";
    CHECK(Json::parse(folder.rbpa("balls " + frames).out)["frames"][1]["cell_volume"] == 2);
    CHECK(area(frames, 0) == Approx(whole - 6 * cap));
    CHECK(area(frames, 1) == Approx(whole - 4 * cap));
    CHECK(area(frames, 2) == Approx(whole - 4 * cap));  // does not repeat along z
  }

  TEST_CASE("contacts have the offset of the second ball") {
    const Folder folder("one.csv", "x,y,z,r\n0,0,0,0.75\n");
    REQUIRE(folder.rbpa("balls one.csv --radii column:r --box 1 --contacts c.csv -q").code == 0);
    const std::string contacts = folder.content("c.csv");
    CHECK(contacts.starts_with("point_a,point_b,area,arc,distance,offset_1,offset_2,offset_3\n0,0,"));
    CHECK(contains(contacts, ",1,0,0,1\n"));
  }

  TEST_CASE("voids of a box have the number of directions in which they percolate, frame by frame") {
    const Folder folder("f.dump", frame(0, "1") + frame(1, "2") + frame(2, "3"));
    REQUIRE(
        folder.rbpa("balls f.dump --radius-default 0.4 --probe 0.35 --models all --box auto --voids v.json -q").code ==
        0);
    const Json voids = Json::parse(folder.content("v.json"));
    REQUIRE(voids.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(voids[i]["frame"] == i + 1);
      CHECK(voids[i]["dimension"] == (i == 0 ? 0 : 2));
    }
    says(folder, "balls f.dump --radius-default 0.4 --probe 0.35 --box auto --voids v.csv", 0,
         "with the probe: 1 closed void, 0 voids that percolate");
    const std::string text = folder.content("v.csv");
    CHECK(text.find("number,volume_between_points,volume_outside_balls,area,x,y,z,radius_max,dimension,points\n1,1,") ==
          0);
    CHECK(contains(text, ",0.5,0.5,0.5,0.11602540378443"));
    CHECK(contains(text, ",0,\"0\"\n"));

    const Outcome pores = folder.rbpa("balls f.dump --radius-default 0.4 --probe 0.35 --box auto --pores --json", 0);
    CHECK(contains(pores.err, "without the probe: a ball of radius 0.466025 fits in, one of 0.307107 passes"));
    const Json found = Json::parse(pores.out)["frames"][0]["pores"];
    CHECK(found["radius_included"].get<double>() == Approx(std::sqrt(0.75) - 0.4));
    CHECK(found["radii_along_edges"][2].get<double>() == Approx(std::sqrt(0.5) - 0.4));
  }

  TEST_CASE("interfaces are those of groups with all images") {
    const Folder folder("two.csv", "x,y,z,r,kind\n0.25,0,0,1,a\n9.75,0,0,1,b\n");
    const std::string call = "balls two.csv --radii column:r --group column:kind --interfaces i.csv -q --box ";
    REQUIRE(folder.rbpa(call + "10").code == 0);
    const std::string table = folder.content("i.csv"), header = "kind_a,kind_b,area_a,area_b,contact_area\n";
    double area_a = 0, area_b = 0, contact_area = 0;
    REQUIRE(std::sscanf(table.c_str(), (header + "a,b,%lf,%lf,%lf").c_str(), &area_a, &area_b, &contact_area) == 3);
    CHECK(area_a == Approx(2 * pi * 0.75));
    CHECK(area_b == Approx(area_a));
    CHECK(contact_area == Approx(pi * (1 - 0.0625)));
    REQUIRE(folder.rbpa(call + "20").code == 0);
    CHECK(folder.content("i.csv") == header);
  }

  TEST_CASE("--box auto takes the Lattice of extended XYZ, by name and from standard input") {
    const Folder folder;
    const std::string line = " Properties=species:S:1:pos:R:3\nC 0 0 0\n";
    folder.file("one.xyz", "1\nLattice=\"2 0 0 0 3 0 0 0 3\"" + line + "1\nLattice=\"4 0 0 0 3 0 0 0 3\"" + line);
    folder.file("none.xyz", "1\n" + line.substr(1));
    const std::string given = folder.rbpa("balls one.xyz --box 2,3,3 --json -q").out;
    CHECK(folder.rbpa("balls one.xyz --box auto --json -q").out == given);
    CHECK(folder.rbpa("balls - --box auto --json -q < one.xyz").out == given);
    const Json all = Json::parse(folder.rbpa("balls one.xyz --box auto --models all --json -q").out);
    CHECK(all["frames"][0] == Json::parse(given)["frames"][0]);
    CHECK(all["frames"][1]["area"] > all["frames"][0]["area"]);  // its images do not meet along x
    CHECK(folder.rbpa("balls none.xyz --box auto").err ==
          "rbpa: none.xyz: found no cell in frame 1, expected a cell for --box auto (--box LX,LY,LZ gives one)\n");
  }

  TEST_CASE("a box that atoms do not fit into is reported; a missing one and wrong calls are refused") {
    const Folder folder;
    folder.file("two.csv", "x,y,z,r\n0,0,0,1\n30,0,0,1\n");
    folder.file("two.pdb", "ATOM      1  CA  ALA A   1       0.000   0.000   0.000  1.00  0.00           C\n");
    folder.file("flat.dump", frame(0, "0"));
    folder.file("flat.csv", "x,y,z,r\n0,0,0,0.4\n");
    CHECK(
        contains(folder.rbpa("balls two.csv --radii column:r --box 10").err,
                 "points reach over 30 x 0 x 0, more than twice the box, which reaches over 10 x 10 x 10: is it in "));
    for (const std::string box : {"40", "15"})
      CHECK(!contains(folder.rbpa("balls two.csv --radii column:r --box " + box).err, "reach over"));
    CHECK(contains(folder.rbpa("balls two.csv --radii column:r --box 14.9").err, "reach over"));
    const std::pair<const char*, const char*> calls[] = {
        {"two.csv --radii column:r --box 1,2", "--box: found '1,2', expected the sides"},
        {"two.csv --radii column:r --box 0", "--box: found '0', expected the sides"},
        {"two.csv --radii column:r --box 1,1,1,90,90,180", "--box: found '1,1,1,90,90,180'"},
        {"two.csv --radii column:r --box auto", "--box auto"},
        {"two.csv --radii column:r --box 0.01", "two.csv: radius 0 is 1, expected at most 50 times the distance"},
        {"two.pdb --box auto", "two.pdb: found no cell in frame 1, expected a cell for --box auto"},
        {"flat.dump --radius-default 1 --box auto", "flat.dump: found BOX BOUNDS without a volume"},
        {"two.pdb --box 9 --pockets p.csv",
         "--pockets cannot be combined with --box, which has no outside to open to (--voids has what percolates; "
         "without --box, molecules that are whole have pockets)"},
        {"two.pdb --pores", "--pores requires --box"},
        {"two.pdb --box 9 --voids v.obj", "--voids: found the ending 'obj', expected one of json, csv"},
        {"flat.csv --radii column:r --box 1,1,3000 --voids v.csv", "flat.csv: found a cell so flat"}};
    for (const auto& row : calls) {
      const std::string call = row.first, message = row.second;
      CAPTURE(call);
      const Outcome outcome = folder.rbpa("balls " + call);
      CHECK(outcome.code != 0);
      CHECK_MESSAGE(contains(outcome.err, message), outcome.err);
    }
  }
}
