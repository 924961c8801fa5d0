// Atoms of PDB and PDBx/mmCIF files as points in space.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "io/cloud/atom_frames.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "io/text/condition.h"
#include "support/program.h"
#include "support/refusal_of.h"

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
  return rbpa_test::refusal_of<rbpa::app::BadInput>([&] { read(text, format); });
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
  TEST_CASE("atoms of the first model are read by the columns of the format, which may touch") {
    const SpacePoints atoms = read(pdb, Format::pdb);
    CHECK(atoms.points ==
          std::vector<Point3>{{3.246, 10.041, 10.379}, {-132.386, -100.407, -109.247}, {2.5, 10.5, 9.25}, {1, 2, 3}});
    CHECK(atoms.normals.empty());
    CHECK(atoms.colors.empty());
    CHECK(atoms.warnings == std::vector<std::string>{"the atoms are those of the first of 2 models",
                                                     "1 atom has alternate locations, each a point of its own (where "
                                                     "\"altloc in ('', 'A')\" takes one of each)"});
    CHECK(read(cif, Format::cif).points ==
          std::vector<Point3>{{3.246, 10.041, 10.379}, {-132.386, -100.407, -109.247}, {1, 2, 3}});
    CHECK(read(cif, Format::cif).warnings == std::vector<std::string>{atoms.warnings[0]});
    const std::string text = "_struct.title\n;loop_\n_atom_site.id\n ; 1 2\n;\n";
    CHECK(read(text + cif, Format::cif).points.size() == 3);
    CHECK(read(cif + text, Format::cif).points.size() == 3);
    CHECK(read(pdb.substr(pdb.find("ATOM")), Format::pdb).points.size() == 4);  // without a line before
  }

  TEST_CASE("conditions select by the fields of an atom") {
    const auto count = [](const std::string& where) { return read(pdb, Format::pdb, where).points.size(); };
    CHECK(count("element == 'N'") == 1);
    CHECK(count("element == 'NA' and resname == 'NA'") == 1);
    CHECK(count("altloc in ('?', 'A')") == 3);
    CHECK(count("name == 'CA'") == 2);
    CHECK(count("bfactor < 8") == 2);
    CHECK(count("record == 'HETATM'") == 1);
    CHECK(read(cif, Format::cif, "record != 'HETATM'").points.size() == 2);
    CHECK(count("occupancy == 0.5") == 2);
    CHECK(count("chain == 'B' and resseq == 201") == 1);
    CHECK(count("serial >= 3") == 2);
    CHECK(read(cif, Format::cif, "name == \"C5'\" and altloc == 'A'").points.size() == 1);
    CHECK(read(cif, Format::cif, "name == 'N A'").points.size() == 1);
    CHECK(count("altloc in ('', 'A')") == 3);
    CHECK(count("element == 'X' and name < 3") ==
          0);  // a field that is not a number is not read if the first condition decides
    CHECK_THROWS_WITH(read(pdb, Format::pdb, "element == 'N' and name < 3 or name < 3"),
                      "m:3: found 'N' as name, expected a number, as --where compares the column with numbers (== "
                      "\"...\" compares it with a text)");
    CHECK(count("ELEMENT != 'X' or name < 3") == 4);
  }

  TEST_CASE("a second condition is read if the first does not decide, in any parentheses") {
    const std::string table = "x,y,z,kind,size\n0,0,0,a,1\n1,0,0,b,?\n0,1,0,a,3\n";
    const auto count = [&](const std::string& where) { return read(table, Format::text, where).points.size(); };
    for (const auto& [where, points] : {std::pair("kind == 'a' and size > 1", 1U),
                                        {"kind == 'b' or size > 1", 2U},
                                        {"not (kind == 'b') and size", 2U},
                                        {"kind == 'a' and (size == 1 or size == 3)", 2U},
                                        {"(kind == 'b' or size == 1) and x < 2", 2U},
                                        {"kind == 'b' and x == 0 and size > 1", 0U},
                                        {"not (kind == 'b' or size > 1)", 1U},
                                        {"x and (y or kind == 'b')", 1U},
                                        {"2 and kind == 'a'", 2U}}) {
      const auto& shown_where = where;
      CAPTURE(shown_where);
      CHECK(count(where) == points);
    }
    CHECK_THROWS_AS(read(table, Format::text, "size > 1 and kind == 'a'"), rbpa::app::BadInput);
  }

  TEST_CASE("an error is refused by its line") {
    CHECK(refusal("HEADER\nATOM      1  N   LYS A   1       3.2x6  10.041  10.379  1.00  5.28           N\n",
                  Format::pdb) == "m:2: found '3.2x6' as x, expected a number");
    CHECK(refusal("HEADER\n" + pdb.substr(pdb.find("ATOM"), 79) + "ATOM      2  CA\n", Format::pdb)
              .starts_with("m:3: found '' as x, expected a number"));
    std::string wrong = cif;
    wrong.replace(wrong.find(" 7.90 1\n"), 8, " 7.90\n");
    CHECK(refusal(wrong, Format::cif) ==
          "m:20: found 9 values ('ATOM   2 C  \"C5'\" A -132.386 -100.407 -109.247 7.90'), expected 10, one for each "
          "name of _atom_site");
    wrong = cif;
    wrong.insert(wrong.find("HETATM"), "HETATM\n");
    CHECK(refusal(wrong, Format::cif) ==
          "m:21: found 1 value ('HETATM'), expected 10, one for each name of _atom_site");
    CHECK(refusal(cif.substr(0, cif.find(" 7.90 1")), Format::cif) ==
          "m:20: found 8 values ('ATOM   2 C  \"C5'\" A -132.386 -100.407 -109.247'), expected 10, one for each name "
          "of _atom_site");
    CHECK(refusal("data_x\nloop_\n_atom_site.id\n'1\n", Format::cif) ==
          "m:4: found ''1', expected a value whose quotes end in its line");
    CHECK(refusal("data_x\n_struct.title\n;1\n", Format::cif) ==
          "m:3: found a multi-line text without an end, expected a later line that begins with ';'");
    CHECK(refusal(cif + cif.substr(cif.find("loop_\n_atom_site.")), Format::cif) ==
          "m:40: found a second loop of _atom_site in a block of data, expected one loop in each block");
    std::string without = cif;
    without.replace(without.find("Cartn_z"), 7, "Cartn_w");
    CHECK(refusal(without, Format::cif) ==
          "m:19: found atoms without _atom_site.Cartn_z, expected the Cartesian coordinates Cartn_x, Cartn_y and "
          "Cartn_z");
  }

  TEST_CASE("serials and residues beyond their columns are read in each way that programs write them") {
    const auto atom = [](const std::string& record_and_serial, const std::string& residue) {
      return record_and_serial + "  CA  RES A" + residue + "      4.000   0.500   0.000  1.00  0.00           C\n";
    };
    const std::string text = atom("ATOM  99999", "9999 ") + atom("ATOM 100000", "A000 ") +
                             atom("ATOM  A0001", "10001") + atom("ATOM  *****", "A002A") +
                             atom("HETATMa0000", "-1  B") + atom("HETATMzzzzz", "zzzz ") + "ATOM  100000 CA  RES A" +
                             "   1       4.000   0.500   0.000\nATOM1234567  CA  RES A   1" +
                             "       4.000   0.500   0.000\n";
    CHECK(read(text, Format::pdb).points == std::vector<Point3>(8, {4, 0.5, 0}));
    for (const auto& [where, points] : {std::pair("serial == 100000", 2U),
                                        {"serial == 100001", 1U},
                                        {"serial == 43770016", 1U},
                                        {"serial == 87440031", 1U},
                                        {"serial == 1234567", 1U},
                                        {"serial == '?'", 1U},
                                        {"not (serial > 0)", 1U},
                                        {"resseq == 10000", 1U},
                                        {"resseq == 10001", 1U},
                                        {"resseq == 10002 and icode == 'A'", 1U},
                                        {"resseq == -1 and icode == 'B'", 1U},
                                        {"resseq == 2436111", 1U}}) {
      const auto& shown_where = where;
      CAPTURE(shown_where);
      CHECK(read(text, Format::pdb, where).points.size() == points);
    }
  }

  TEST_CASE("residues, chains and names of CIF are the author's, and the archive's where he gives none") {
    const std::string names =
        "data_x\nloop_\n_atom_site.label_asym_id\n_atom_site.label_seq_id\n_atom_site.label_comp_id\n"
        "_atom_site.label_atom_id\n_atom_site.pdbx_PDB_ins_code\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
        "_atom_site.Cartn_z\n";
    const std::string author =
        "_atom_site.auth_asym_id\n_atom_site.auth_seq_id\n_atom_site.auth_comp_id\n_atom_site.auth_atom_id\n";
    const auto count = [&](const std::string& text, const std::string& where) {
      return read(text, Format::cif, where).points.size();
    };
    const std::string with = names + author + "A 1 SER CA B 0 0 0 H 195 DSER CX\nA 2 SER CA ? 0 0 0 . ? ? .\n";
    CHECK(count(with, "chain == 'H' and resseq == 195 and icode == 'B' and resname == 'DSER' and name == 'CX'") == 1);
    CHECK(count(with, "chain == 'A' and resseq == 2 and icode == '?' and resname == 'SER' and name == 'CA'") == 1);
    CHECK(count(names + "A 1 SER CA ? 0 0 0\n", "chain == 'A' and resseq == 1 and name == 'CA'") == 1);
  }

  TEST_CASE("CIF is read as tokens, with case, lines, quotes, comments and texts by its syntax") {
    const std::vector<Point3> expected = {{0, 0.5, 1}, {2, 3, 4}};
    for (const std::string text :
         {"DATA_x LOOP_ _ATOM_SITE.id _Atom_Site.CARTN_X _atom_site.cartn_y _atom_site.cartn_z "
          "_atom_site.label_atom_id 1 0 .5 1 CA 2 2 3 4 CA",
          "data_x\nloop_\n_atom_site.id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
          "_atom_site.label_atom_id\n1 0\n.5 1\n;C\nA\n;\n2 # two\n2\n3 4 'C A'\n#\n",
          "data_x\r\nloop_\r\n_atom_site.id _atom_site.Cartn_x _atom_site.Cartn_y\r\n_atom_site.Cartn_z "
          "_atom_site.label_atom_id\r\n1 0 5.0e-1 1 \r\n;data_y\r\nloop_\r\n;\r\n2 2 3 4 \"C'A\"\r\n",
          "data_x\rloop_\r_atom_site.id\r_atom_site.Cartn_x\r_atom_site.Cartn_y\r_atom_site.Cartn_z\r_atom_site.label_"
          "atom_id\r1 0 0.5(3) 1 'a # b'\r2 2 3 4 'O5''\r",
          "data_x loop_ _atom_site_label _atom_site_Cartn_x _atom_site_Cartn_y _atom_site_Cartn_z _atom_site_occupancy "
          "C1 0 0.5 1 1 C2 2 3 4 1 loop_ _atom_site_aniso_label C1 C2 _end 1"}) {
      CAPTURE(text);
      CHECK(read(text, Format::cif).points == expected);
    }
    CHECK(read("data_x _atom_site.id 1 _atom_site.Cartn_x 1 _atom_site.Cartn_y 2 _atom_site.Cartn_z 3 _cell.length_a 5",
               Format::cif)
              .points == std::vector<Point3>{{1, 2, 3}});
    const std::string atoms = "loop_ _atom_site.Cartn_x _atom_site.Cartn_y _atom_site.Cartn_z 1 2 3\n";
    const SpacePoints blocks = read("data_x\n_a.b 1\ndata_y\n" + atoms + "data_z\n" + atoms, Format::cif);
    CHECK(blocks.points == std::vector<Point3>{{1, 2, 3}});
    CHECK(blocks.warnings == std::vector<std::string>{"the atoms are those of the first of 2 blocks of data"});
  }

  TEST_CASE("a file without an atom is refused with the reason") {
    const std::string no_record = "m: found no record ATOM or HETATM, expected the atoms of a file in PDB format";
    const std::string no_category =
        "m: found no atom in a category _atom_site, expected the atoms of a file in PDBx/mmCIF";
    for (const std::string text : {"END\n", "garbage\nthis is no pdb\n", "ATOMS ARE HERE\n", "\n", "atom      1\n"}) {
      CAPTURE(text);
      CHECK(refusal(text, Format::pdb) == no_record);
      CHECK(refusal(text, Format::cif) == no_category);
    }
    CHECK(refusal("data_x\nloop_\n_atom_site.id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n",
                  Format::cif) == no_category);
    CHECK(refusal("data_x\nloop_\n_atom_site_label\n_atom_site_fract_x\nC1 0.5\n", Format::cif) ==
          "m:5: found atoms in fractions of the cell (_atom_site.fract_x), expected the Cartesian coordinates Cartn_x, "
          "Cartn_y and Cartn_z (Python: atoms = ase.io.read(FILE); rbpa.balls(atoms, box=atoms.cell[:]))");
    for (const Format format : {Format::pdb, Format::cif})
      CHECK(refusal(std::string("\xFF\xFE"
                                "A\0T\0",
                                6),
                    format) ==
            "m: found text in UTF-16LE, expected UTF-8 (iconv -f UTF-16LE -t UTF-8 m > FILE makes it)");
  }

  TEST_CASE("frames of a simulation are models, however they end") {
    const std::string atom = "ATOM      1  CA  RES A   1       4.000   0.000   0.000\n";
    for (const std::string& text : {"MODEL        1\n" + atom + "MODEL        2\n" + atom,
                                    atom + "END\n" + atom + "END\n", atom + "ENDMDL\n" + atom + "ENDMDL\nEND\n",
                                    "MODEL        1\nENDMDL\n" + atom + "END\nMODEL        2\n" + atom}) {
      CAPTURE(text);
      const SpacePoints atoms = read(text, Format::pdb);
      CHECK(atoms.points.size() == 1);
      CHECK(atoms.warnings == std::vector<std::string>{"the atoms are those of the first of 2 models"});
    }
    CHECK(read(atom + "END\n", Format::pdb).warnings.empty());
  }

  TEST_CASE("the cell is read if its angles are right, else the reason is given") {
    const std::string atom = "ATOM      1  CA  RES A   1       4.000   0.000   0.000\n";
    const std::string cif_atom = "\nloop_\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n1 2 3\n";
    const auto of_pdb = [&](const std::string& cell) { return read(cell + "\n" + atom, Format::pdb).cell; };
    const auto of_cif = [&](const std::string& a, const std::string& gamma) {
      const std::string cell = "_cell.length_a " + a +
                               " _cell.length_b 56.886(3)\n_CELL.length_c\n'80.993' _cell.angle_alpha 90 "
                               "_cell.angle_beta 90.00 _cell.angle_gamma " +
                               gamma;
      const rbpa::app::UnitCell before = read("data_x " + cell + cif_atom, Format::cif).cell;
      const rbpa::app::UnitCell behind =
          read("data_x " + cif_atom + cell + " data_y _cell.length_a 7", Format::cif).cell;
      CHECK(before.sides == behind.sides);
      CHECK(before.fault == behind.fault);
      return before;
    };
    const Point3 sides = {55.865, 56.886, 80.993};
    CHECK(of_pdb("CRYST1   55.865   56.886   80.993  90.00  90.00  90.00 P 1           1").sides == sides);
    CHECK(of_cif("55.865", "90").sides == sides);
    CHECK(of_pdb("CRYST1  146.200  146.200  214.861  90.00  90.00 120.00 P 65 2 2     12").symmetry == "P 65 2 2");
    CHECK(of_pdb("CRYST1  146.200  146.200  214.861  90.00  90.00 120.00 P 65 2 2     12").fault ==
          "CRYST1 with angles of 90, 90 and 120 degrees");
    CHECK(of_cif("55.865", "120").fault == "_cell with angles of 90, 90 and 120 degrees");
    CHECK(of_pdb("CRYST1    1.000    1.000    1.000  90.00  90.00  90.00 P 1           1").fault ==
          "CRYST1 of 1 x 1 x 1, which stands for none");
    CHECK(of_pdb("CRYST1    0.000    0.000    0.000  90.00  90.00  90.00 P 1           1").fault ==
          "CRYST1 with '0.000' as a length");
    CHECK(of_cif("?", "90").fault == "_cell with '' as a length");
    const std::string loop =
        "loop_\n_cell.entry_id\n_cell.length_a\n_cell.length_b\n_cell.length_c\n_cell.angle_alpha\n_cell.angle_beta\n"
        "_cell.angle_gamma\n";
    const std::string row = "X 55.865 56.886(3)\n80.993 90 90.00 90\n";
    CHECK(read("data_x\n" + loop + row + cif_atom, Format::cif).cell.sides == sides);
    CHECK(read("data_x" + cif_atom + loop + row, Format::cif).cell.sides == sides);
    CHECK(read("data_x\n" + loop + row + "Y 1 2 3 90 90 90\n" + cif_atom, Format::cif).cell.sides == sides);
    CHECK(read("data_x" + cif_atom + "data_y\n" + loop + row, Format::cif).cell.fault.empty());
    for (const std::string name : {"_symmetry.space_group_name_H-M", "_space_group.name_H-M_alt"})
      CHECK(read("data_x " + name + " 'P 43 21 2'" + cif_atom + loop + row, Format::cif).cell.symmetry == "P 43 21 2");
    CHECK(of_pdb("REMARK").fault.empty());
    CHECK(!of_pdb("REMARK").sides);
  }

  TEST_CASE("the symmetry of a cell gives a warning with --box auto, and a last line that is cut within z is refused") {
    const std::string atom = "ATOM      1  CA  RES A   1       4.000   0.000   0.000";
    const std::string cell = "CRYST1   55.865   56.886   80.993  90.00  90.00  90.00 ";
    for (const std::string verb : {"balls", "solid --alpha 2 -o t.npy"})
      for (const std::string group : {"P 43 21 2", "C 1 2 1", "P 1", "P1", ""}) {
        CAPTURE(group);
        const Folder folder("m.pdb", cell + group + "\n" + atom + "\n");
        const Outcome outcome = folder.rbpa(verb + " m.pdb --box auto");
        CHECK(contains(outcome.err, "space group") == (group.size() > 3));
        CHECK(!contains(folder.rbpa(verb + " m.pdb --box 30").err, "space group"));
      }
    for (std::size_t cut = 1; cut < 4; ++cut) {
      const Folder folder("m.pdb", atom + "\n" + atom.substr(0, atom.size() - cut));
      CHECK(contains(folder.rbpa("balls m.pdb", 3).err, "m.pdb:2: found "));
      folder.file("m.pdb", atom + "\n" + atom.substr(0, atom.size() - cut) + "\n" + atom);
      CHECK(!contains(folder.rbpa("balls m.pdb").err, "is the file whole"));
    }
  }

  TEST_CASE("atoms of water are left out on request, unless the condition names them") {
    const std::string water = "HETATM    6  O   HOH B 202       1.000   2.500   3.000  1.00 20.00           O\n";
    const std::string text = pdb.substr(0, pdb.find("ENDMDL")) + water + water;
    rbpa::app::CloudRequest request{.waters = rbpa::app::Waters::left_out};
    const SpacePoints dry = rbpa::app::space_points_in(text, "m", Format::pdb, request);
    CHECK(dry.points.size() == 4);
    CHECK(dry.warnings.front() == "2 atoms of water are left out (--waters keeps them)");
    CHECK(read(text, Format::pdb).warnings.front() ==
          "2 atoms are of water (where \"resname != 'HOH'\" leaves them out)");
    request.where = Condition("resname == 'HOH'", *rbpa::app::fields_of(Format::pdb));
    CHECK(rbpa::app::space_points_in(text, "m", Format::pdb, request).points.size() == 2);
    struct Choice {
      std::string where;
      std::size_t points, lines;
    };
    for (const Choice& choice : {Choice{"resname != 'LIG'", 4, 6},
                                 {"resname in ('LIG', 'HOH')", 2, 2},
                                 {"resname != 'HOH'", 4, 4},
                                 {"resname != 'SOL'", 4, 6},
                                 {"name in ('N', 'O')", 1, 3}}) {
      CAPTURE(choice.where);
      request.where = Condition(choice.where, *rbpa::app::fields_of(Format::pdb));
      CHECK(rbpa::app::space_points_in(text, "m", Format::pdb, request).points.size() == choice.points);
      CHECK(read(text, Format::pdb, choice.where).points.size() == choice.lines);
      rbpa::app::AtomFrame frame;
      rbpa::app::AtomFrames atoms(text, "m", Format::pdb, {.alternates = true, .where = choice.where});
      REQUIRE(atoms.next(frame));
      CHECK(frame.rows.size() == choice.points);
    }
    request.where.reset();
    CHECK_THROWS_WITH(rbpa::app::space_points_in(water, "m", Format::pdb, request),
                      "m: found no atoms but those of water, expected others (--waters reads water too)");
    request.waters = rbpa::app::Waters::counted;
    CHECK(rbpa::app::space_points_in(text, "m", Format::pdb, request).points.size() == 6);
  }

  TEST_CASE("points that are left out keep their positions in the file") {
    const auto index = [](const std::string& text, Format format, const std::string& where) {
      return read(text, format, where).index;
    };
    using Index = std::vector<std::uint32_t>;
    CHECK(index(pdb, Format::pdb, "element != 'N'") == Index{1, 2, 3});
    CHECK(index(cif, Format::cif, "serial != 2") == Index{0, 2});
    CHECK(index(pdb, Format::pdb, "serial < 5").empty());  // the first
    CHECK(index("x y z k\n0 0 0 1\n# no\n\n1 0 0 2\n2 0 0 3\n", Format::text, "k > 1") == Index{1, 2});
    CHECK(index("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
                "z\nend_header\n0 0 0\n1 0 0\n2 0 0\n",
                Format::ply, "x != 1") == Index{0, 2});
    const SpacePoints some =
        rbpa::app::space_points_in("0 0 0\n1 NA 0\n2 0 0\n", "m", Format::text, {.skip_invalid = true});
    CHECK(some.index == Index{0, 2});
  }

  TEST_CASE("files of people are read with all their atoms, or refused") {
    const std::string data = RBPA_TEST_DATA "/findings/";
    const auto count = [&](const std::string& name, const std::string& where) {
      rbpa::app::CloudRequest request;
      const Format format = name.ends_with("cif") ? Format::cif : Format::pdb;
      if (!where.empty()) request.where = Condition(where, *rbpa::app::fields_of(format));
      return rbpa::app::read_space_points(data + name, format, request).points.size();
    };
    const std::string numbers = "case_cif_residue_numbers/", tiny = "mol_01_cif_resseq/tiny.cif";
    for (const auto& [name, where, atoms] :
         {std::tuple(std::string("case_pdb_six_digit_serial/six_digits_col6.pdb"), std::string(), 8U),
          {"case_pdb_six_digit_serial/six_digits_col6.pdb", "serial >= 100000", 4U},
          {"case_no_atoms_no_word/LOOP.cif", "chain == 'H' and resseq == 57", 1U},
          {"case_no_atoms_no_word/LOOP.cif", "", 8U},
          {"case_cif_models_counted_wrong/two_models.cif", "name == 'O3 a'", 1U},
          {numbers + "m1.pdb", "chain == 'H' and resseq == 57", 1U},
          {numbers + "m1.cif", "chain == 'H' and resseq == 57", 1U},
          {numbers + "label_only.cif", "chain == 'A'", 8U},
          {tiny, "resseq == 195", 1U},
          {tiny, "resseq == 175", 0U},
          {tiny, "resname != 'HOH' and resseq == 195", 1U},
          {tiny, "resname == 'HOH' and resseq == 401", 1U}}) {
      const auto& shown_name = name;
      CAPTURE(shown_name);
      const auto& shown_where = where;
      CAPTURE(shown_where);
      CHECK(count(name, where) == atoms);
    }
    CHECK(rbpa::app::read_space_points(data + "case_cif_models_counted_wrong/two_models.cif", Format::cif).warnings ==
          std::vector<std::string>{"the atoms are those of the first of 2 models"});
    for (const auto& [name, why] : {std::pair(std::string("garbage.pdb"), std::string("no record ATOM or HETATM")),
                                    {"u16.pdb", "text in UTF-16"}})
      CHECK_THROWS_WITH_AS(count("case_no_atoms_no_word/" + name, ""), doctest::Contains(why.c_str()),
                           rbpa::app::BadInput);
  }

  TEST_CASE("the program reads molecules by their endings, compressed or not") {
    const Folder folder({{"m.pdb", pdb}, {"m.ent", pdb}, {"m.pdb1", pdb}, {"m.PDB12", pdb}, {"m.cif", cif}});
    CHECK(folder.rbpa("solid m.pdb --alpha inf -o t.npy")
              .err.find("rbpa: m.pdb: the atoms are those of the first of 2 models\n") == 0);
    std::filesystem::copy_file(folder.path("m.pdb1"), folder.path("m.pdb2"));
    REQUIRE(std::system(("gzip " + folder.path("m.pdb2")).c_str()) == 0);
    for (const std::string name : {"m.ent", "m.pdb1", "m.PDB12", "m.pdb2.gz"}) {
      CAPTURE(name);
      CHECK(folder.rbpa("solid " + name + " --alpha inf -o u.npy -q").code == 0);
      CHECK(folder.content("t.npy") == folder.content("u.npy"));
    }
    folder.file("m.pdbx1", pdb);
    CHECK(folder.rbpa("solid m.pdbx1 --alpha inf -o u.npy").code == 2);
    const std::string water = "HETATM    6  O   HOH B 202       1.000   2.500   3.000  1.00 20.00           O\n";
    folder.file("wet.pdb", pdb.substr(0, pdb.find("ENDMDL")) + water);
    CHECK(contains(folder.rbpa("solid wet.pdb --alpha inf -o t.npy").err,
                   "wet.pdb: 1 atom of water is left out (--waters keeps them)\n"));
    CHECK(contains(folder.rbpa("solid wet.pdb --alpha inf --waters --json -q").out, "\"points\": 5,"));
    CHECK(contains(folder.rbpa("alpha wet.pdb --dimension 3 --waters --json -q").out, "\"points\": 5,"));
    CHECK(contains(folder.rbpa("solid wet.pdb --alpha inf --where \"resname == 'HOH'\" --json -q").out,
                   "\"points\": 1,"));
    folder.file("t.xyz", "0 0 0\n");
    CHECK(folder.rbpa("solid t.xyz --alpha inf --waters --json").err ==
          "rbpa: --waters: found a format without atoms, expected cif, dump, gro, pdb or pqr\n");
    CHECK(contains(folder.rbpa("solid m.cif --alpha inf --json -q").out, "\"points\": 3,"));
    CHECK(contains(folder.rbpa("solid m.cif --where \"element == 'N'\" --alpha inf --json -q").out, "\"points\": 1,"));
  }
}
