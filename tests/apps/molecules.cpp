// Atoms of PDB and PDBx/mmCIF files as points in space.
#include <doctest/doctest.h>

#include <string>

#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "io/text/condition.h"
#include "support/program.h"

using namespace apps_test;
using rbpa::Point3;
using rbpa::app::Condition;
using rbpa::app::Format;
using rbpa::app::SpacePoints;

namespace {

SpacePoints read(const std::string& text, Format format, const std::string& where = "") {
  rbpa::app::CloudRequest request;
  if (!where.empty()) request.where = Condition(where, *rbpa::app::fields_of(format));
  return rbpa::app::space_points_in(text, "m", format, request);
}

std::string refusal(const std::string& text, Format format) {
  try {
    read(text, format);
  } catch (const rbpa::app::BadInput& e) {
    return e.what();
  }
  return "";
}

const std::string pdb =
    "HEADER    HYDROLASE\n"
    "MODEL        1\n"
    "ATOM      1  N   LYS A   1       3.246  10.041  10.379  1.00  5.28           N\n"
    "ATOM      2  CA ALYS A   1    -132.386-100.407-109.247  0.50  7.90           C\n"
    "ATOM      3  CA BLYS A   1       2.500  10.500   9.250  0.50  8.90\r\n"
    "ANISOU    3  CA BLYS A   1      450    450    450      0      0      0       C\n"
    "TER       4      LYS A   1\n"
    "HETATM    5 NA    NA B 201       1.000   2.000   3.000  1.00 20.00          NA\n"
    "ENDMDL\n"
    "MODEL        2\n"
    "ATOM      1  N   LYS A   1       9.999  10.041  10.379  1.00  5.28           N\n"
    "ENDMDL\n"
    "END\n";

const std::string cif =
    "data_X\n#\nloop_\n_entity.id\n_entity.details\n1 'a protein'\n#\nloop_\n"
    "_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_alt_id\n"
    "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.B_iso_or_equiv\n_atom_site.pdbx_PDB_model_"
    "num\n"
    "ATOM   1 N  N     . 3.246 10.041 10.379 5.28 1\n"
    "ATOM   2 C  \"C5'\" A -132.386 -100.407 -109.247 7.90 1\n"
    "HETATM 3 NA 'N A' ? 1.000 2.000 3.000 ? 1\n"
    "ATOM   1 N  N     . 9.999 10.041 10.379 5.28 2\n"
    "#\nloop_\n_atom_site_anisotrop.id\n_atom_site_anisotrop.U[1][1]\n1 0.5\n2 0.6\n";

}  // namespace

TEST_SUITE("molecules") {
  TEST_CASE("atoms of the first model, by the columns of the format, which may touch") {
    const SpacePoints atoms = read(pdb, Format::pdb);
    CHECK(atoms.points ==
          std::vector<Point3>{{3.246, 10.041, 10.379}, {-132.386, -100.407, -109.247}, {2.5, 10.5, 9.25}, {1, 2, 3}});
    CHECK(atoms.normals.empty());
    CHECK(atoms.colors.empty());
    CHECK(atoms.remarks == std::vector<std::string>{"the atoms are those of the first of 2 models"});
    CHECK(read(cif, Format::cif).points ==
          std::vector<Point3>{{3.246, 10.041, 10.379}, {-132.386, -100.407, -109.247}, {1, 2, 3}});
    CHECK(read(cif, Format::cif).remarks == atoms.remarks);
    CHECK(read("END\n", Format::pdb).points.empty());
    CHECK(read("data_X\n", Format::cif).points.empty());
    const std::string text = "_struct.title\n;loop_\n_atom_site.id\n ; 1 2\n;\n";
    CHECK(read(text + cif, Format::cif).points.size() == 3);
    CHECK(read(cif + text, Format::cif).points.size() == 3);
    CHECK(read(pdb.substr(pdb.find("ATOM")), Format::pdb).points.size() == 4);  // without a line before
  }

  TEST_CASE("conditions ask for what stands beside the place of an atom") {
    const auto count = [](const std::string& where) { return read(pdb, Format::pdb, where).points.size(); };
    CHECK(count("element == 'N'") == 1);
    CHECK(count("element == 'NA' and resname == 'NA'") == 1);
    CHECK(count("altloc in ('?', 'A')") == 3);
    CHECK(count("name == 'CA'") == 2);
    CHECK(count("bfactor < 8") == 2);
    CHECK(count("occupancy == 0.5") == 2);
    CHECK(count("chain == 'B' and resseq == 201") == 1);
    CHECK(count("serial >= 3") == 2);
    CHECK(read(cif, Format::cif, "name == \"C5'\" and altloc == 'A'").points.size() == 1);
    CHECK(read(cif, Format::cif, "name == 'N A'").points.size() == 1);
  }

  TEST_CASE("what is wrong is refused by its line") {
    CHECK(refusal("HEADER\nATOM      1  N   LYS A   1       3.2x6  10.041  10.379  1.00  5.28           N\n",
                  Format::pdb) == "m:2: found '3.2x6', expected a number");
    CHECK(refusal("HEADER\n" + pdb.substr(pdb.find("ATOM"), 79) + "ATOM      2  CA\n", Format::pdb)
              .starts_with("m:3: found '?', expected a number"));
    std::string wrong = cif;
    wrong.replace(wrong.find(" 7.90 1\n"), 8, " 7.90\n");
    CHECK(refusal(wrong, Format::cif) ==
          "m:20: found 9 values ('ATOM   2 C  \"C5'\" A -132.386 -100.407 -109.247 7.90'), expected 10, one for each "
          "name "
          "of _atom_site");
    wrong = cif;
    wrong.insert(wrong.find("HETATM"), ";HETATM\n;\n");
    CHECK(refusal(wrong, Format::cif) ==
          "m:21: found 1 value (';HETATM'), expected 10, one for each name of _atom_site");
    std::string without = cif;
    without.replace(without.find("Cartn_z"), 7, "Cartn_w");
    CHECK(refusal(without, Format::cif) ==
          "m:19: found atoms without _atom_site.Cartn_z, expected Cartn_x, Cartn_y and Cartn_z");
  }

  TEST_CASE("the program reads them by their endings, packed or not") {
    const Folder folder;
    folder.file("m.pdb", pdb);
    folder.file("m.ent", pdb);
    folder.file("m.cif", cif);
    CHECK(folder.rbpa("solid m.pdb --alpha inf -o t.npy")
              .err.find("rbpa: m.pdb: the atoms are those of the first of 2 models\n") == 0);
    CHECK(folder.rbpa("solid m.ent --alpha inf -o u.npy -q").code == 0);
    CHECK(folder.content("t.npy") == folder.content("u.npy"));
    CHECK(folder.rbpa("solid m.cif --alpha inf --json -q").out.find("\"points\": 3,") != std::string::npos);
    CHECK(folder.rbpa("solid m.cif --where \"element == 'N'\" --alpha inf --json -q").out.find("\"points\": 1,") !=
          std::string::npos);
  }
}
