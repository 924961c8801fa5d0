// `rbpa balls`: rows of atoms, groups and contacts, frames, counts of what is left out, and wrong calls.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/program.h"

using namespace apps_test;
using Json = nlohmann::json;
using std::numbers::pi;

namespace {

const std::string lysozyme = RBPA_TEST_DATA "/mol3_2lyz.pdb";

using Row = std::map<std::string, std::string>;

std::vector<std::string> fields_of(const std::string& line) {
  std::istringstream text(line + ",");
  std::vector<std::string> fields;
  for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
  return fields;
}

/// Returns the rows of a CSV file without quotes, by the names of its columns.
std::vector<Row> rows_of(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> names = fields_of(line);
  std::vector<Row> rows;
  while (std::getline(lines, line)) {
    const std::vector<std::string> fields = fields_of(line);
    REQUIRE(fields.size() == names.size());
    Row& row = rows.emplace_back();
    for (std::size_t k = 0; k < names.size(); ++k) row[names[k]] = fields[k];
  }
  return rows;
}
double number(const Row& row, const std::string& column) { return std::stod(row.at(column)); }
double sum(const std::vector<Row>& rows, const std::string& column) {
  double all = 0;
  for (const Row& row : rows) all += number(row, column);
  return all;
}

Json json_of(const Folder& folder, const std::string& arguments) {
  return Json::parse(folder.rbpa("balls " + arguments + " --json -q", 0).out);
}

/// Returns an atom of PDB at x in chain A.
std::string atom(const std::string& name, double x, int residue = 1, const std::string& rest = "  1.00  0.00",
                 const std::string& resname = "ALA", char altloc = ' ', const std::string& record = "ATOM  ",
                 char chain = 'A') {
  char line[100];
  std::snprintf(line, sizeof line, "%s    1 %-4s%c%3s %c%4d    %8.3f   0.000   0.000%s\n", record.c_str(), name.c_str(),
                altloc, resname.c_str(), chain, residue, x, rest.c_str());
  return line;
}

}  // namespace

TEST_SUITE("balls") {
  TEST_CASE("two balls have the areas and volumes of their formulas, in any format of points with radii") {
    const Folder folder;
    // Spheres of radii 2 and 1 whose centers are 2 apart meet in a circle at a distance of 7/4 from the first.
    const double cap = 2 * pi * 2 * (2 - 1.75), small_cap = 2 * pi * 1 * (1 - 0.25);
    const double areas[] = {16 * pi - cap, 4 * pi - small_cap};
    const double volumes[] = {32 * pi / 3 - pi * 0.25 * 0.25 * (6 - 0.25) / 3,
                              4 * pi / 3 - pi * 0.75 * 0.75 * (3 - 0.75) / 3};
    folder.file("b.csv", "x,y,z,r\n0,0,0,1.5\n0,0,2,0.5\n");
    folder.file("b.xyz", "2\nProperties=species:S:1:pos:R:3:radius:R:1\nC 0 0 0 1.5\nN 0 0 2 0.5\n");
    folder.file("b.pqr", "ATOM 1 CA ALA A 1 0 0 0 0 1.5\nATOM 2 CB ALA A 1 0 0 2 0 0.5\n");
    folder.file("b.ply",
                "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
                "property float r\nend_header\n0 0 0 1.5\n0 0 2 0.5\n");
    for (const std::string file : {"b.csv --radii column:r", "b.xyz", "b.pqr", "b.ply --radii column:r"}) {
      CAPTURE(file);
      const Outcome outcome = folder.rbpa("balls " + file + " --probe 0.5 -o atoms.csv --contacts contacts.csv -q", 0);
      CHECK(outcome.out + outcome.err == "");
      const std::vector<Row> rows = rows_of(folder.content("atoms.csv"));
      REQUIRE(rows.size() == 2);
      for (std::size_t i = 0; i < 2; ++i) {
        CHECK(number(rows[i], "area") == doctest::Approx(areas[i]).epsilon(1e-13));
        CHECK(number(rows[i], "volume") == doctest::Approx(volumes[i]).epsilon(1e-13));
        CHECK(number(rows[i], "radius") == (i == 0 ? 1.5 : 0.5));
        CHECK(rows[i].at("buried") == "0");
      }
      const std::vector<Row> contacts = rows_of(folder.content("contacts.csv"));
      REQUIRE(contacts.size() == 1);
      CHECK(number(contacts[0], "area") == doctest::Approx(pi * (4 - 1.75 * 1.75)).epsilon(1e-13));
      CHECK(number(contacts[0], "arc") == doctest::Approx(2 * pi * std::sqrt(4 - 1.75 * 1.75)).epsilon(1e-13));
      CHECK(contacts[0].at("distance") == "2");
      CHECK(contacts[0].at("point_a") == "0");
      CHECK(contacts[0].at("point_b") == "1");
    }
    folder.rbpa("balls b.csv --radii column:r -o t.csv --contacts c.csv -q");
    CHECK(folder.content("t.csv").starts_with("point,radius,area,volume,buried\n0,1.5,"));
    CHECK(folder.content("c.csv") == "point_a,point_b,area,arc,distance\n0,1,0,0,2\n");
  }

  TEST_CASE("the summary has counts, radii with their source, and sizes with and without the probe") {
    const Folder folder;
    const Outcome outcome = folder.rbpa("balls " + lysozyme + " --probe 1.4 -o a.csv", 0);
    CHECK(outcome.out == "");
    CHECK(outcome.err ==
          "rbpa: 1102 atoms, 1001 kept; left out: 101 of water (--waters keeps them)\n"
          "rbpa: radii: C 1.7 (613, Bondi), N 1.55 (193, Bondi), O 1.52 (185, Bondi), S 1.8 (10, Bondi)\n"
          "rbpa: probe 1.4: volume 23736.9, area 6695.65, 361 of 1001 buried; without it (van der Waals): volume "
          "10728.6, area 12660.4 -> a.csv\n");
    const Json json = json_of(folder, lysozyme + " --probe 1.4");
    CHECK(json["probe"] == 1.4);
    CHECK(json["radii"][1] ==
          Json({{"element", "N"}, {"source", "Bondi"}, {"least", 1.55}, {"greatest", 1.55}, {"atoms", 193}}));
    const Json& frame = json["frames"].at(0);
    CHECK(frame["atoms"] == 1001);
    CHECK(frame["left_out"]["waters"] == 101);
    CHECK(frame.size() == 10);
    CHECK(frame["cell_volume"].is_null());  // the others have values
    CHECK(std::count_if(frame.begin(), frame.end(), [](const Json& value) { return value.is_null(); }) == 1);
    const std::vector<Row> rows = rows_of(folder.content("a.csv"));
    REQUIRE(rows.size() == 1001);
    CHECK(sum(rows, "area") == doctest::Approx(frame["area"].get<double>()).epsilon(1e-12));
    CHECK(sum(rows, "volume") == doctest::Approx(frame["volume"].get<double>()).epsilon(1e-12));
    CHECK(sum(rows, "buried") == frame["buried"]);
    CHECK(json_of(folder, lysozyme)["frames"][0]["area"] == frame["area_vdw"]);
    const Row& last = rows.back();
    CHECK(last.at("name") + last.at("element") + last.at("resname") + last.at("resseq") + last.at("chain") ==
          "OXTOLEU129A");
    CHECK(folder.rbpa("balls " + lysozyme + " --probe 1.4").err + "" ==
          outcome.err.substr(0, outcome.err.size() - std::string(" -> a.csv\n").size()) + "\n");
  }

  TEST_CASE("rows of groups are sums of those of their atoms, and contacts those between different groups") {
    const Folder folder;
    REQUIRE(folder.rbpa("balls " + lysozyme + " --probe 1.4 -o a.csv --contacts c.csv -q").code == 0);
    const std::vector<Row> atoms = rows_of(folder.content("a.csv")), contacts = rows_of(folder.content("c.csv"));
    for (const auto& [group, column, count] :
         {std::tuple("residue", "resseq", 129U), {"chain", "chain", 1U}, {"column:element", "element", 4U}}) {
      const auto& shown_group = group;
      CAPTURE(shown_group);
      REQUIRE(folder.rbpa("balls " + lysozyme + " --probe 1.4 -o g.csv --contacts d.csv -q --group " + group).code ==
              0);
      const std::vector<Row> groups = rows_of(folder.content("g.csv")), between = rows_of(folder.content("d.csv"));
      REQUIRE(groups.size() == count);
      for (const Row& row : groups) {
        double area = 0, volume = 0, buried = 0, all = 0;
        for (const Row& of : atoms)
          if (of.at(column) == row.at(column)) {
            area += number(of, "area");
            volume += number(of, "volume");
            buried += number(of, "buried");
            ++all;
          }
        CHECK(number(row, "area") == doctest::Approx(area).epsilon(1e-12));
        CHECK(number(row, "volume") == doctest::Approx(volume).epsilon(1e-12));
        CHECK(number(row, "buried") == buried);
        CHECK(number(row, "atoms") == all);
      }
      const std::string a = column + std::string("_a"), b = column + std::string("_b");
      std::map<std::pair<std::string, std::string>, std::pair<double, double>> sums;  // number and area
      for (const Row& row : contacts)
        if (row.at(a) != row.at(b)) {
          auto& [number_of, area] = sums[std::minmax(row.at(a), row.at(b))];
          ++number_of;
          area += number(row, "area");
        }
      CHECK(between.size() == sums.size());
      for (const Row& row : between) {
        const auto& [number_of, area] = sums[std::minmax(row.at(a), row.at(b))];
        CHECK(number(row, "contacts") == number_of);
        CHECK(number(row, "area") == doctest::Approx(area).epsilon(1e-12));
      }
    }
    folder.file("t.csv", "x,y,z,r,kind\n0,0,0,1,a\n1,0,0,1,b\n5,0,0,1,a\n");
    REQUIRE(folder.rbpa("balls t.csv --radii column:r --group column:kind -o g.csv -q").code == 0);
    CHECK(folder.content("g.csv").starts_with("kind,atoms,area,volume,buried\na,2,"));
    REQUIRE(folder.rbpa("balls t.csv --radii column:r --group column:r -o g.csv -q").code == 0);
    CHECK(folder.content("g.csv").starts_with("r,atoms,area,volume,buried\n1,3,"));
  }

  TEST_CASE("--where knows elements as they are written, also those of names") {
    const Folder folder;
    const auto line = [](int serial, const std::string& name, const std::string& element) {
      char text[100];
      std::snprintf(text, sizeof text, "HETATM%5d %-4s LIG A   1    %8.3f%8.3f%8.3f  1.00  0.00          %2s\n", serial,
                    name.c_str(), 5.0 * serial, 0.0, 0.0, element.c_str());
      return std::string(text);
    };
    folder.file("l.pdb", line(1, "ZN", "ZN") + line(2, " C1", "") + line(3, " H1", "") + line(4, " H2", "H"));
    for (const auto& [where, atoms] : {std::pair("element == 'Zn'", 1),
                                       {"element == 'ZN'", 1},
                                       {"element == 'H'", 2},
                                       {"element != 'H'", 2},
                                       {"element == 'C'", 1}}) {
      const std::string condition = std::string(" --where \"") + where + "\"";
      CAPTURE(condition);
      CHECK(folder.rbpa("balls l.pdb" + condition).err.find(", " + std::to_string(atoms) + " kept") !=
            std::string::npos);
      CHECK(folder.rbpa("solid l.pdb --alpha inf -o s.npy" + condition)
                .err.find("--where selects " + std::to_string(atoms) + " of 4 ") != std::string::npos);
    }
  }

  TEST_CASE("residues that share a number cause a warning, as one row stands for them") {
    const Folder folder;
    const auto line = [](int serial, int residue) {
      char text[60];
      std::snprintf(text, sizeof text, "%5d%-5s%5s%5d%8.3f%8.3f%8.3f\n", residue, "LYS", "CA", serial, 0.4 * serial,
                    0.0, 0.0);
      return std::string(text);
    };
    folder.file("two.gro", "copies\n4\n" + line(1, 1) + line(2, 2) + line(3, 1) + line(4, 2) + "9 9 9\n");
    folder.file("one.gro", "one\n4\n" + line(1, 1) + line(2, 1) + line(3, 2) + line(4, 2) + "9 9 9\n");
    CHECK(folder.rbpa("balls two.gro --group residue -o r.csv")
              .err.find("2 residues have atoms in several places of the file and one row each") != std::string::npos);
    CHECK(folder.rbpa("balls one.gro --group residue -o r.csv").err.find("places") == std::string::npos);
    CHECK(folder.rbpa("balls two.gro -o r.csv").err.find("places") == std::string::npos);
  }

  TEST_CASE("what is left out is counted by its reason") {
    const Folder folder("m.pdb", atom(" CA ", 0) + atom(" HA ", 1) + atom(" CB ", 2, 1, "  0.40  0.00", "ALA", 'A') +
                                     atom(" CB ", 3, 1, "  0.60  0.00", "ALA", 'B') +
                                     atom(" C1 ", 9, 2, "  1.00  0.00", "LIG", ' ', "HETATM") +
                                     atom(" O  ", 19, 3, "  1.00  0.00", "HOH", ' ', "HETATM"));
    struct Choice {
      std::string options;
      std::size_t kept, where, waters, ligands, hydrogens, alternates;
    };
    for (const Choice& choice : {Choice{"", 4, 0, 1, 0, 0, 1},
                                 {"--waters", 5, 0, 0, 0, 0, 1},
                                 {"--no-ligands", 3, 0, 1, 1, 0, 1},
                                 {"--no-hydrogens", 3, 0, 1, 0, 1, 1},
                                 {"--alternates", 5, 0, 1, 0, 0, 0},
                                 {"--where \"resname == 'HOH'\"", 1, 5, 0, 0, 0, 0},
                                 {"--where 'x < 2.5' --no-hydrogens", 2, 2, 1, 0, 1, 0}}) {
      CAPTURE(choice.options);
      const Json frame = json_of(folder, "m.pdb " + choice.options)["frames"][0];
      CHECK(frame["atoms_in_file"] == 6);
      CHECK(frame["atoms"] == choice.kept);
      CHECK(frame["left_out"] == Json({{"where", choice.where},
                                       {"waters", choice.waters},
                                       {"ligands", choice.ligands},
                                       {"hydrogens", choice.hydrogens},
                                       {"alternates", choice.alternates}}));
    }
    CHECK(folder.rbpa("balls m.pdb --no-ligands --no-hydrogens")
              .err.starts_with("rbpa: 6 atoms, 2 kept; left out: 1 of water (--waters keeps them), 1 of ligands, 1 of "
                               "hydrogen and 1 at alternate locations (--alternates keeps them)\n"));
  }

  TEST_CASE("a frame among others has the rows that it has alone, for any number of threads") {
    const Folder folder;
    std::string models;
    for (int model = 1; model <= 40; ++model) {
      models += "MODEL" + std::string(9 - std::to_string(model).size(), ' ') + std::to_string(model) + "\n";
      for (int i = 0; i < 5 + model % 7; ++i) models += atom(i % 2 == 0 ? " CA " : " N  ", i * (0.5 + 0.03 * model), i);
      models += "ENDMDL\n";
    }
    folder.file("m.pdb", models);
    REQUIRE(folder.rbpa("balls m.pdb --probe 0.3 --models all -o all.csv --contacts c.csv -q --threads 1").code == 0);
    const std::string all = folder.content("all.csv"), contacts = folder.content("c.csv");
    CHECK(all.starts_with(
        "frame,point,serial,chain,resseq,icode,resname,name,element,record,radius,area,volume,buried\n"));
    for (const std::string threads : {"2", "8"}) {
      REQUIRE(
          folder.rbpa("balls m.pdb --probe 0.3 --models all -o b.csv --contacts c.csv -q --threads " + threads).code ==
          0);
      CHECK(folder.content("b.csv") == all);
      CHECK(folder.content("c.csv") == contacts);
    }
    std::string joined = all.substr(0, all.find('\n') + 1);
    for (const std::string model : {"1", "17", "40"}) {
      REQUIRE(folder.rbpa("balls m.pdb --probe 0.3 --models " + model + " -o one.csv -q").code == 0);
      std::istringstream lines(folder.content("one.csv"));
      std::string line;
      std::getline(lines, line);
      while (std::getline(lines, line)) joined += model + "," + line + "\n";
    }
    REQUIRE(folder.rbpa("balls m.pdb --probe 0.3 --models 1,17,40 -o some.csv").code == 0);
    CHECK(folder.content("some.csv") == joined);
    const Outcome outcome = folder.rbpa("balls m.pdb --probe 0.3 --models 1-3");
    CHECK(contains(outcome.err, "rbpa: 3 frames with 21 atoms, 21 kept\n"));
    CHECK(contains(outcome.err, "\nrbpa: radii in all frames: C "));
    CHECK(contains(outcome.err, " of 21 buried in all frames; without it"));
    CHECK(contains(outcome.err, ": volume "));
    CHECK(contains(outcome.err, " to "));
    CHECK(json_of(folder, "m.pdb --models 39,40")["frames"][1]["frame"] == 40);
  }

  TEST_CASE("names with commas and quotes are quoted, and texts that are not UTF-8 become so") {
    const Folder folder("q.cif",
                        "data_x\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n"
                        "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
                        "C \"C5'\" 'A,\"B' 0 0 0\nC 'C 6' \xe9 9 0 0\n");
    REQUIRE(folder.rbpa("balls q.cif -o q.csv -q").code == 0);
    const std::string text = folder.content("q.csv");
    CHECK(contains(text, "\n0,,,,,\"A,\"\"B\",C5',C,,1.7,"));
    CHECK(contains(text, "\n1,,,,,\xc3\xa9,\"C 6\",C,,1.7,"));
  }

  TEST_CASE("voids and pockets have sizes, the largest ball that fits in, and the atoms around them") {
    const Folder folder;
    // Balls around the corners of a cube leave its center free; they close its sides from a radius of √2 on.
    std::string frames;
    for (const std::string size : {"1", "1.05"}) {
      frames += "8\nProperties=species:S:1:pos:R:3:radius:R:1\n";
      for (int i = 0; i < 8; ++i)
        frames += std::string("C ") + (i & 1 ? "" : "-") + size + " " + (i & 2 ? "" : "-") + size + " " +
                  (i & 4 ? "" : "-") + size + " 1.2\n";
    }
    folder.file("c.xyz", frames);
    const Outcome outcome = folder.rbpa("balls c.xyz --models all --probe 0.25 --voids v.csv --pockets p.csv", 0);
    CHECK(outcome.err.ends_with("\nrbpa: with the probe: 1 void, 1 pocket in all frames -> v.csv, p.csv\n"));
    const std::vector<Row> voids = rows_of(folder.content("v.csv")), pockets = rows_of(folder.content("p.csv"));
    REQUIRE(voids.size() == 1);
    CHECK(voids[0].at("frame") + voids[0].at("number") == "11");
    CHECK(voids[0].at("points") == "\"0 1 2 3 4 5 6 7\"");
    CHECK(number(voids[0], "volume_between_points") == doctest::Approx(8));
    CHECK(number(voids[0], "radius_max") == doctest::Approx(std::sqrt(3) - 1.45));
    CHECK(number(voids[0], "volume_outside_balls") > 4 * pi / 3 * std::pow(std::sqrt(3) - 1.45, 3));
    CHECK(std::abs(number(voids[0], "x")) + std::abs(number(voids[0], "y")) < 1e-12);
    CHECK(number(voids[0], "area") > 4 * pi * std::pow(std::sqrt(3) - 1.45, 2));
    REQUIRE(pockets.size() == 1);
    CHECK(pockets[0].at("frame") + pockets[0].at("mouths") == "26");
    CHECK(number(pockets[0], "volume_between_points") == doctest::Approx(8 * 1.05 * 1.05 * 1.05));
    CHECK(number(pockets[0], "radius_max") == doctest::Approx(1.05 * std::sqrt(3) - 1.45));
    CHECK(number(pockets[0], "mouth_radius_max") == doctest::Approx(1.05 * std::sqrt(2) - 1.45));
    REQUIRE(folder.rbpa("balls c.xyz --probe 0.25 --voids one.csv -q").code == 0);
    const std::string one = folder.content("one.csv"), all = folder.content("v.csv");
    CHECK("frame," + one.substr(0, one.find('\n') + 1) + "1," + one.substr(one.find('\n') + 1) == all);
    CHECK(folder.rbpa("balls c.xyz --voids v.stl").err ==
          "rbpa: --voids: found the ending 'stl', expected one of obj, json, csv, pml, cxc\n");
  }

  TEST_CASE("voids as scripts name and color the atoms around, and show the largest ball") {
    const Folder folder;
    std::string numbered = "8\nProperties=id:I:1:species:S:1:pos:R:3:radius:R:1\n", bare = "x,y,z,r\n";
    for (int i = 0; i < 8; ++i) {
      const std::string x = std::to_string(i & 1), y = std::to_string(i >> 1 & 1), z = std::to_string(i >> 2);
      numbered += std::to_string(11 * i) + " C " + x + " " + y + " " + z + " 0.75\n";
      bare += x + "," + y + "," + z + ",0.75\n";
    }
    folder.file("c.xyz", numbered);
    folder.file("n.csv", bare);
    REQUIRE(folder.rbpa("balls c.xyz -q --voids v.pml").code == 0);
    std::istringstream pml(folder.content("v.pml"));
    std::string line;
    std::getline(pml, line);
    CHECK(line == "select void_1, id 0+11+22+33+44+55+66+77");
    std::getline(pml, line);
    CHECK(line == "color orange, void_1");
    std::getline(pml, line);
    double x = 0, y = 0, z = 0, radius = 0;
    REQUIRE(std::sscanf(line.c_str(), "pseudoatom void_1_ball, pos=[%lf,%lf,%lf], vdw=%lf, color=orange", &x, &y, &z,
                        &radius) == 4);
    CHECK(x == doctest::Approx(0.5));
    CHECK(z == doctest::Approx(0.5));
    CHECK(radius == doctest::Approx(std::sqrt(0.75) - 0.75));
    REQUIRE(folder.rbpa("balls n.csv --radii column:r -q --voids v.cxc").code == 0);
    const std::string cxc = folder.content("v.cxc");
    CHECK(cxc.starts_with("name void_1 @@serial_number=1 @@serial_number=2 @@serial_number=3 "));  // in order
    CHECK(contains(cxc, "\ncolor void_1 orange\nshape sphere center "));
    CHECK(cxc.ends_with(" color orange name void_1_ball\n"));
  }

  TEST_CASE("voids as JSON have the values of their rows and the area of each atom around, as OBJ a closed surface") {
    const Folder folder;
    const std::string balls = "balls " + lysozyme + " --probe 1.4 -q --voids v.";
    REQUIRE(folder.rbpa(balls + "csv --pockets p.csv").code == 0);
    REQUIRE(folder.rbpa(balls + "json --pockets p.json").code == 0);
    REQUIRE(folder.rbpa(balls + "obj --pockets p.obj").code == 0);
    for (const std::string file : {"v", "p"}) {
      const std::vector<Row> rows = rows_of(folder.content(file + ".csv"));
      const Json list = Json::parse(folder.content(file + ".json"));
      REQUIRE(list.size() == rows.size());
      REQUIRE(rows.size() > 5);
      for (std::size_t i = 0; i < rows.size(); ++i) {
        for (const std::string key : {"volume_between_points", "volume_outside_balls", "area", "radius_max"})
          CHECK(list[i].at(key).get<double>() == number(rows[i], key));
        CHECK(list[i].at("center")[2].get<double>() == number(rows[i], "z"));
        double area = 0;
        for (const Json& of : list[i].at("areas")) area += of.get<double>();
        CHECK(area == doctest::Approx(list[i].at("area").get<double>()));
        std::string points;
        for (const Json& of : list[i].at("points")) points += (points.empty() ? "\"" : " ") + of.dump();
        CHECK(rows[i].at("points") == points + "\"");
        CHECK(list[i].contains("mouths") == (file == "p"));
      }
      std::istringstream lines(folder.content(file + ".obj"));
      std::vector<std::array<double, 3>> vertices;
      std::vector<double> volumes;
      std::map<std::pair<std::size_t, std::size_t>, int> sides;
      for (std::string word; lines >> word;) {
        std::array<double, 3> p{};
        if (word == "g") {
          lines >> word;
          volumes.push_back(0);
          CHECK(word == (file == "v" ? "void_" : "pocket_") + std::to_string(volumes.size()));
        } else if (word == "v") {
          lines >> p[0] >> p[1] >> p[2];
          vertices.push_back(p);
        } else {
          std::array<std::size_t, 3> t{};
          lines >> t[0] >> t[1] >> t[2];
          for (std::size_t k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
          const auto &a = vertices.at(t[0] - 1), &b = vertices.at(t[1] - 1), &c = vertices.at(t[2] - 1);
          for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
            volumes.back() += a[k] * (b[l] * c[m] - b[m] * c[l]) / 6;
          }
        }
      }
      for (const auto& [side, count] : sides) CHECK(sides[{side.second, side.first}] == count);
      REQUIRE(volumes.size() == rows.size());
      for (std::size_t i = 0; i < rows.size(); ++i)
        CHECK(volumes[i] == doctest::Approx(number(rows[i], "volume_between_points")));
    }
    folder.file("one.csv", "x,y,z,r\n0,0,0,1\n");
    REQUIRE(folder.rbpa("balls one.csv --radii column:r -q --voids v.json --pockets p.obj").code == 0);
    CHECK(folder.content("v.json") == "[]\n");
    CHECK(folder.content("p.obj").empty());
  }

  TEST_CASE("interfaces have the areas that each group loses to the other, and the area of their contacts") {
    const Folder folder("t.csv", "x,y,z,r,kind\n0,0,0,4,b\n3,0,0,2,a\n50,0,0,2,a\n90,0,0,1,c\n");
    const Outcome outcome =
        folder.rbpa("balls t.csv --radii column:r --group column:kind --interfaces i.csv --contacts c.csv");
    CHECK(outcome.err.ends_with(" -> c.csv, i.csv\n"));
    CHECK(folder.content("i.csv").starts_with("kind_a,kind_b,area_a,area_b,contact_area\nb,a,"));
    const std::vector<Row> rows = rows_of(folder.content("i.csv")), contacts = rows_of(folder.content("c.csv"));
    REQUIRE(rows.size() == 1);
    CHECK(number(rows[0], "area_a") == doctest::Approx(2 * pi * 4 * 0.5));
    CHECK(number(rows[0], "area_b") == doctest::Approx(2 * pi * 2 * 2.5));
    CHECK(number(rows[0], "contact_area") == number(contacts.at(0), "area"));
    const std::string call = "balls t.csv --radii column:r --group column:kind --interfaces i.csv --where ";
    CHECK(folder.rbpa(call + "'x < 2'").err.ends_with("\nrbpa: 0 interfaces (one group) -> i.csv\n"));
    CHECK(folder.rbpa(call + "'x > 9'").err.ends_with("\nrbpa: 0 interfaces (no two groups meet) -> i.csv\n"));
    CHECK(folder.rbpa("balls t.csv --radii column:r --interfaces i.csv").err ==
          "rbpa: --interfaces requires --group (chain, for example)\n");
  }

  TEST_CASE("nested and equal balls, and points in a plane, have rows too") {
    const Folder folder("n.csv", "x,y,z,r\n0,0,0,2\n0,0,0,1\n0,0,0,2\n5,0,0,1\n9,0,0,0\n");
    REQUIRE(folder.rbpa("balls n.csv --radii column:r -o n.csv.csv -q").code == 0);
    const std::vector<Row> rows = rows_of(folder.content("n.csv.csv"));
    REQUIRE(rows.size() == 5);
    const double expected[] = {16 * pi, 0, 0, 4 * pi, 0};
    for (std::size_t i = 0; i < 5; ++i) {
      CHECK(number(rows[i], "area") == doctest::Approx(expected[i]));
      CHECK(rows[i].at("buried") == (expected[i] == 0 ? "1" : "0"));
    }
  }

  TEST_CASE("wrong calls and broken files are refused, and leave no file") {
    const Folder folder;
    folder.file("m.pdb", atom(" CA ", 0));
    folder.file("metal.pdb", atom(" CA ", 0) + atom("PM  ", 3, 154, "  1.00  0.00          PM", "PM ", ' ', "HETATM"));
    folder.file("bad.pdb", "MODEL        1\n" + atom(" CA ", 0) + "ENDMDL\nMODEL        2\n" +
                               "ATOM      1  CA  ALA A   1       0.000   x.000   0.000\nENDMDL\n");
    folder.file("t.csv", "x,y,z,r\n0,0,0,1\n1,0,0,-1\n");
    folder.file("w.pdb", atom(" O  ", 0, 1, "", "HOH"));
    const std::vector<std::string> before = folder.names();
    struct Call {
      std::string arguments;
      int code;
      std::string says;
    };
    for (const Call& call :
         {Call{"m.pdb --probe x", 2, "--probe: found 'x', expected a length, at least 0"},
          {"m.pdb --probe -1", 2, "--probe: found '-1', expected a length, at least 0"},
          {"m.pdb --probe inf", 2, "--probe: found 'inf', expected a length, at least 0"},
          {"m.pdb --radius-default -2", 2, "--radius-default: found '-2', expected a length, at least 0"},
          {"m.pdb --group atom", 2, "--group: found 'atom', expected residue, chain or column:NAME"},
          {"m.pdb --group column:", 2, "--group: found 'column:', expected residue, chain or column:NAME"},
          {"m.pdb --group column:size", 3, "m.pdb: found no column 'size', expected a column of atoms"},
          {"m.pdb --models 0", 2,
           "--models: found '0', expected all, numbers from 1 such as 1,3,10-20, or FIRST:LAST:STEP such as 1:1000:10"},
          {"m.pdb --models 1,2", 3, "m.pdb: found 1 frame, expected frame 2"},
          {"m.pdb --contacts c.txt", 2, "--contacts: found the ending 'txt', expected csv"},
          {"m.pdb -o a.pdb", 2, "a.pdb: found the ending 'pdb', expected csv, or --output-format"},
          {"m.pdb -o a.csv --contacts a.csv", 2, ""},
          {"m.pdb -o m.pdb --output-format csv", 2, ""},
          {"m.pdb --json -o - --output-format csv", 2, ""},
          {"m.pdb --radii mine.txt", 3,
           "mine.txt: found no such file, expected a file of radii, or bondi, protor or column:NAME"},
          {"t.csv", 3,
           "t.csv: found points without radii, expected radii (--radii column:NAME, or --radius-default R)"},
          {"t.csv --radii column:r -o a.csv", 3,
           "t.csv: point 1: found '-1' as a radius, expected a number of at least 0"},
          {"t.csv --radius-default 1 --group residue -o a.csv", 3,
           "t.csv: found no residues for --group, expected some (--group column:NAME takes any column)"},
          {"t.csv --radius-default 1 --group chain -o a.csv", 3,
           "t.csv: found no chains for --group, expected some (--group residue, or column:NAME)"},
          {"m.pdb --probe 1e308 --radius-default 1 --radii huge.txt", 3, ""},
          {"w.pdb", 3, "w.pdb: found no atoms but those of water, expected others (--waters reads water too)"},
          {"metal.pdb -o a.csv", 3,
           "metal.pdb:2: found element 'Pm' of atom PM of residue PM A 154, expected one with a radius of Bondi, "
           "Mantina or Alvarez (--radii FILE names its radius, --radius-default R is for all without one)"},
          {"bad.pdb --models all -o a.csv --contacts c.csv", 3, "bad.pdb:5: found 'x.000' as y, expected a number"}}) {
      CAPTURE(call.arguments);
      const Outcome outcome = folder.rbpa("balls " + call.arguments);
      CHECK(outcome.code == call.code);
      CHECK(outcome.out == "");
      if (call.says.empty())
        CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
      else
        CHECK(outcome.err == "rbpa: " + call.says + "\n");
      CHECK(folder.names() == before);
    }
  }

  TEST_CASE("every key of JSON and every column stands on the page about formats") {
    const std::string page = read_file(RBPA_TEST_DATA "/../../docs/reference/file_formats.md");
    std::set<std::string> known, found;
    std::istringstream quoted(page.substr(page.find("**Balls.**"), page.find("\n## 7.") - page.find("**Balls.**")));
    for (std::string text; std::getline(quoted, text, '`') && std::getline(quoted, text, '`');) {
      std::istringstream words(text);
      for (std::string word; words >> word;) known.insert(word);
    }
    const auto add = [&](const Json& json, const auto& self) -> void {
      for (const auto& [key, value] : json.items()) {
        if (json.is_object()) found.insert(key);
        if (value.is_structured()) self(value, self);
      }
    };
    const Folder folder("two.csv", "x,y,z,r\n0,0,0,0.3\n0.5,0.5,0.5,0.3\n");
    const std::string box = "balls two.csv --radii column:r --box 1 --pores --voids v.json --stats s.json --json -q";
    add(Json::parse(folder.rbpa(box, 0).out), add);
    REQUIRE(folder.rbpa("balls " + lysozyme + " --probe 1.4 --models all --voids w.json --pockets p.json -q").code ==
            0);
    for (const std::string file : {"s.json", "v.json", "w.json", "p.json"}) add(Json::parse(folder.content(file)), add);
    for (const std::string& options : {std::string(), std::string(" --group residue")}) {
      REQUIRE(folder
                  .rbpa("balls " + lysozyme +
                        " --probe 1.4 --models all -o a.csv --contacts c.csv --voids v.csv "
                        "--pockets p.csv -q" +
                        options)
                  .code == 0);
      for (const std::string file : {"a.csv", "c.csv", "v.csv", "p.csv"}) {
        std::istringstream lines(folder.content(file));
        std::string head;
        std::getline(lines, head);
        for (std::string column : fields_of(head)) {
          if (file == "c.csv" && (column.ends_with("_a") || column.ends_with("_b"))) column.resize(column.size() - 2);
          found.insert(column);
        }
      }
    }
    CHECK(found.size() > 50);
    for (const std::string& key : found) CHECK_MESSAGE(known.contains(key), key);
  }

  TEST_CASE("--stats has times, and standard input and output are read and written") {
    const Folder folder;
    REQUIRE(folder.rbpa("balls " + lysozyme + " --radii protor --stats s.json -q").code == 0);
    const Json stats = Json::parse(folder.content("s.json"));
    CHECK(stats["seconds"]["measure"] > 0);
    CHECK(stats["radii"][0]["source"] == "ProtOr");
    REQUIRE(folder.rbpa("balls " + lysozyme + " -o a.csv -q").code == 0);
    const Outcome outcome = folder.rbpa("balls - --format pdb -o - --output-format csv -q < " + lysozyme, 0);
    CHECK(outcome.out == folder.content("a.csv"));
    for (const std::string call :
         {"balls --probe 1.4 -o ", "balls --probe 1.4 --contacts ", "balls --probe 1.4 --voids ",
          "balls --probe 1.4 --pockets ", "balls --group chain --interfaces ", "solid --alpha 3.1 --voids ",
          "solid --alpha 3.1 --pockets "}) {
      CAPTURE(call);
      REQUIRE(folder.rbpa(call + "t.csv -q " + lysozyme).code == 0);
      CHECK(folder.rbpa(call + "- -q " + lysozyme, 0).out == folder.content("t.csv"));
    }
  }
}
