// Frames of atoms as columns, elements by names, water and alternate locations, radii, and the formats of simulations.
#include "io/cloud/atoms.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "io/cloud/atom_frames.h"
#include "io/cloud/ball_radii.h"
#include "io/cloud/chemical_elements.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "support/program.h"
#include "support/refusal_of.h"

using namespace apps_test;
using rbpa::Point3;
using rbpa::app::AtomChoice;
using rbpa::app::AtomFrame;
using rbpa::app::AtomFrames;
using rbpa::app::AtomRow;
using rbpa::app::BallRadii;
using rbpa::app::CellEdges;
using rbpa::app::Format;
using rbpa::app::parse_frames;

namespace {

std::vector<AtomFrame> frames_of(const std::string& text, Format format, const AtomChoice& choice = {},
                                 std::vector<std::string>* warnings = nullptr) {
  std::vector<AtomFrame> all;
  AtomFrames file(text, "m", format, choice);
  for (AtomFrame frame; file.next(frame);) all.push_back(frame);
  if (warnings != nullptr) *warnings = file.warnings();
  return all;
}
AtomFrame frame_of(const std::string& text, Format format, const AtomChoice& choice = {}) {
  return frames_of(text, format, choice).at(0);
}
const AtomChoice all_frames = {.frames = {.all = true}};

template <typename Read>
std::string refusal_of(const Read& read) {
  return rbpa_test::refusal_of<rbpa::app::BadInput, rbpa::app::WrongUsage>(read);
}
std::string refusal(const std::string& text, Format format, const AtomChoice& choice = {.frames = {.all = true}}) {
  return refusal_of([&] { frames_of(text, format, choice); });
}

/// Returns a line of PDB: the name in columns 13 to 16, and the location, residue and number.
std::string pdb_line(const std::string& name, char altloc = ' ', const std::string& residue = "ALA", int number = 1,
                     double occupancy = 1, const std::string& element = "  ", const std::string& record = "ATOM  ") {
  char line[100];
  std::snprintf(line, sizeof line, "%s%5d %4s%c%-4sA%4d    %8.3f%8.3f%8.3f%6.2f%6.2f          %2s\n", record.c_str(), 7,
                name.c_str(), altloc, residue.c_str(), number, 1.5, 2.25, -3.125 + number, occupancy, 0.0,
                element.c_str());
  return line;
}

std::string names_of(const AtomFrame& frame) {
  std::string all;
  for (const AtomRow& row : frame.rows)
    all += (all.empty() ? "" : " ") + frame.text(row.name) + (row.altloc == 0 ? "" : ":" + frame.text(row.altloc));
  return all;
}
std::string element(const AtomFrame& frame, std::size_t atom) { return frame.text(frame.rows.at(atom).element); }
std::vector<Point3> centers(const AtomFrame& frame) { return frame.column(&AtomRow::center); }
std::vector<double> radii(const AtomFrame& frame) { return frame.column(&AtomRow::radius); }

}  // namespace

TEST_SUITE("atoms") {
  TEST_CASE("elements are those of their columns, else of the names by the rules of each format") {
    struct Row {
      const char *name, *residue;
      std::size_t begins;
      const char *column, *expected;
    };
    for (const Row& row : {Row{"CA", "ALA", 14, "C", "C"}, {"CA", "CA", 13, "CA", "Ca"}, {"CA", "ALA", 14, "", "C"},
                           {"CA", "CA", 13, "", "Ca"},     {"CA", "ALA", 13, "", "C"},   {"CA", "LIG", 14, "", "C"},
                           {"CA", "LIG", 13, "", "Ca"},    {"CA", "LIG", 0, "", "C"},    {"CL1", "LIG", 13, "", "Cl"},
                           {"CL1", "LIG", 0, "", "Cl"},    {"1HB", "ALA", 13, "", "H"},  {"HG11", "VAL", 13, "", "H"},
                           {"HG11", "LIG", 13, "", "H"},   {"HG", "HG", 13, "", "Hg"},   {"FE", "HEM", 13, "", "Fe"},
                           {"FE", "HEM", 0, "", "Fe"},     {"NA", "HEM", 14, "", "N"},   {"NA", "HEM", 0, "", "N"},
                           {"NA", "NA+", 0, "", "Na"},     {"CU", "CU1", 0, "", "Cu"},   {"SOD", "SOD", 0, "", "Na"},
                           {"CLA", "CLA", 14, "", "Cl"},   {"SE", "MSE", 13, "", "Se"},  {"CE", "MSE", 0, "", "C"},
                           {"ZN", "ZN", 13, "", "Zn"},     {"Zn1", "X", 0, "", "Zn"},    {"OW", "SOL", 0, "", "O"},
                           {"SI1", "QTZ", 0, "", "Si"},    {"D", "DOD", 14, "D", "D"},   {"DA", "ALA", 14, "", "D"},
                           {"C1", "LIG", 0, "Fe3+", "Fe"}, {"", "", 0, "26", "Fe"},      {"C5'", "DA", 14, "", "C"},
                           {"N", "ALA", 14, "1A", "N"},    {"XX", "LIG", 0, "", ""},     {"12", "", 0, "", ""},
                           {"UNK", "UNX", 13, "X", ""},    {"UNK", "UNX", 13, "", ""},   {"UN1", "UNK", 0, "", ""},
                           {"U", "U4", 13, "U", "U"},      {"C1", "LIG", 13, "X", ""},   {"CL", "CL", 14, "", "Cl"},
                           {"NA", "NA", 14, "", "Na"},     {"CA", "CA", 14, "", "Ca"},   {"CD", "CD", 14, "", "Cd"},
                           {"HG", "HG", 14, "", "Hg"},     {"Cl-", "Cl-", 14, "", "Cl"}, {"CA", "CAL", 14, "", "C"},
                           {"BB", "LYS", 0, "", ""},       {"SC1", "LYS", 0, "", ""},    {"BB", "ALA", 14, "", ""},
                           {"SG", "CYS", 14, "", "S"},     {"SD", "MET", 0, "", "S"},    {"OXT", "LYS", 0, "", "O"}}) {
      CAPTURE(row.name);
      CAPTURE(row.residue);
      CAPTURE(row.begins);
      rbpa::app::Atom atom;
      atom.fields[rbpa::app::AtomColumn::name] = row.name;
      atom.fields[rbpa::app::AtomColumn::resname] = row.residue;
      atom.fields[rbpa::app::AtomColumn::element] = row.column;
      atom.name_begins = row.begins;
      CHECK(rbpa::app::element_of(atom) == row.expected);
    }
    CHECK(element(frame_of(pdb_line("CA  ", ' ', "CA") + pdb_line(" CA "), Format::pdb), 0) == "Ca");
  }

  TEST_CASE("all columns of an atom are kept, and those of records HETATM are marked") {
    const AtomFrame pdb =
        frame_of("CRYST1   10.000   20.000   30.000  90.00  90.00 120.00 P 1\n" +
                     pdb_line(" CB ", ' ', "LEU", -4, 0.75, " C") + pdb_line("ZN  ", ' ', "ZN", 201, 1, "ZN", "HETATM"),
                 Format::pdb);
    CHECK(centers(pdb) == std::vector<Point3>{{1.5, 2.25, -7.125}, {1.5, 2.25, 197.875}});
    CHECK(pdb.title(pdb.rows[0]) == "atom CB of residue LEU A -4");
    CHECK(pdb.column(&AtomRow::serial) == std::vector<double>{7, 7});
    CHECK(pdb.column(&AtomRow::occupancy) == std::vector<double>{0.75, 1});
    CHECK(pdb.column(&AtomRow::line) == std::vector<std::size_t>{2, 3});
    CHECK(pdb.text(pdb.rows[0].record) == "ATOM");
    CHECK(pdb.text(pdb.rows[1].record) == "HETATM");
    CHECK(!pdb.has_radii);
    REQUIRE(pdb.cell.edges);
    const CellEdges& edges = *pdb.cell.edges;
    CHECK(edges[0] == Point3{10, 0, 0});
    CHECK(edges[1].x == -10);
    CHECK(edges[1].y == doctest::Approx(20 * std::sqrt(0.75)));
    CHECK(edges[2] == Point3{0, 0, 30});
    CHECK(pdb.cell.fault == "CRYST1 with angles of 90, 90 and 120 degrees");

    const AtomFrame cif = frame_of(
        "data_x\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
        "_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.label_seq_id\n_atom_site.Cartn_x\n"
        "_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.pdbx_PDB_ins_code\n"
        "ATOM 1 C CA ALA A 5 1 2 3 B\nHETATM 2 CA CA CA B . 4 5 6 ?\n_cell.length_a 9\n_cell.length_b 8\n"
        "_cell.length_c 7\n_cell.angle_alpha 90\n_cell.angle_beta 90\n_cell.angle_gamma 90\n",
        Format::cif, all_frames);
    CHECK(cif.title(cif.rows[0]) == "atom CA of residue ALA A 5B");
    CHECK(element(cif, 0) == "C");
    CHECK(element(cif, 1) == "Ca");
    CHECK(std::isnan(cif.rows[1].resseq));
    CHECK(cif.text(cif.rows[0].record) == "ATOM");
    CHECK(cif.text(cif.rows[1].record) == "HETATM");
    CHECK(cif.cell.sides == Point3{9, 8, 7});
  }

  TEST_CASE("water is left out and ligands are kept, each with a choice and a count") {
    const std::string text = pdb_line(" CA ") + pdb_line(" HA ") + pdb_line(" C1 ", ' ', "LIG", 2, 1, " C", "HETATM") +
                             pdb_line(" O  ", ' ', "HOH", 3, 1, " O", "HETATM") + pdb_line(" OW ", ' ', "SOL", 4) +
                             pdb_line(" OH2", ' ', "TIP3", 5);
    const auto names = [&](const AtomChoice& choice) { return names_of(frame_of(text, Format::pdb, choice)); };
    CHECK(names({}) == "CA HA C1");
    CHECK(names({.waters = true}) == "CA HA C1 O OW OH2");
    CHECK(names({.ligands = false}) == "CA HA");
    CHECK(names({.waters = true, .ligands = false}) == "CA HA O OW OH2");
    CHECK(names({.hydrogens = false}) == "CA C1");
    CHECK(names({.where = "name != 'CA'"}) == "HA C1");
    CHECK(names({.where = "resname == 'HOH'"}) == "O");
    const AtomFrame some = frame_of(text, Format::pdb, {.ligands = false, .hydrogens = false, .where = "serial == 7"});
    CHECK(some.counts.in_file == 6);
    CHECK(some.rows.size() == 1);
    CHECK(some.counts.waters == 3);
    CHECK(some.counts.ligands == 1);
    CHECK(some.counts.hydrogens == 1);
    CHECK(some.counts.deselected == 0);
    CHECK(refusal(pdb_line(" O  ", ' ', "HOH"), Format::pdb) ==
          "m: found no atoms but those of water, expected others (--waters reads water too)");
    CHECK(refusal(text, Format::pdb, {.where = "serial == 8"}) ==
          "m: found no atom in frame 1 that is not left out, expected at least one");
  }

  TEST_CASE("of several faults the first in the file is named, whatever the number of threads") {
    const std::string head =
        "data_x\nloop_\n_atom_site.id\n_atom_site.label_comp_id\n_atom_site.Cartn_x\n"
        "_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
    const auto atoms = [](std::size_t count, const std::string& residue = "ALA") {
      std::string rows;
      for (std::size_t i = 0; i < count; ++i) rows += std::to_string(i) + " " + residue + " 1 2 3\n";
      return rows;
    };
    const std::string number = "7 ALA 1 two 3\n", water = "7 HOH 1 two 3\n", quote = "8 ALA 1 2 '3\n",
                      odd = "9 ALA 1\n";
    const std::string of_number = "found 'two' as y", of_quote = "found ''3'", of_odd = "found 3 values";
    struct Row {
      std::string text, line, expected;
    };
    const Row rows[] = {
        {number + quote, "8", of_number},
        {atoms(300) + number + atoms(3) + quote, "308", of_number},
        {atoms(300) + quote + number, "308", of_quote},
        {water + atoms(2000) + quote, "2009", of_quote},
        {water + atoms(300), "", ""},
        {atoms(3) + odd + atoms(2000) + quote, "11", of_odd},
        {number + odd + atoms(2000), "8", of_number},
        {atoms(2000) + number + atoms(2000) + odd + atoms(1), "2008", of_number},
    };
    for (const Row& row : rows)
      for (const unsigned threads : {1U, 2U, 0U}) {
        CAPTURE(row.line);
        CAPTURE(threads);
        const std::string found = refusal(head + row.text, Format::cif, {.threads = threads});
        CHECK(found.substr(0, row.expected.empty() ? found.size() : 4 + row.line.size() + row.expected.size()) ==
              (row.expected.empty() ? "" : "m:" + row.line + ": " + row.expected));
      }
  }

  TEST_CASE("of alternate locations a residue has one, of the highest occupancy, else of the first letter") {
    using Rows = std::vector<std::string>;
    for (const auto& [rows, kept] :
         {std::pair(Rows{pdb_line(" N  "), pdb_line(" CB ", 'A', "ALA", 1, 0.4), pdb_line(" CB ", 'B', "ALA", 1, 0.6)},
                    "N CB:B"),
          {Rows{pdb_line(" CB ", 'B', "ALA", 1, 0.5), pdb_line(" CB ", 'A', "ALA", 1, 0.5)}, "CB:A"},
          // The residue's location is B, also for CG, whose two occupancies are equal.
          {Rows{pdb_line(" CB ", 'A', "LEU", 1, 0.3), pdb_line(" CB ", 'B', "LEU", 1, 0.7),
                pdb_line(" CG ", 'A', "LEU", 1, 0.5), pdb_line(" CG ", 'B', "LEU", 1, 0.5)},
           "CB:B CG:B"},
          // An atom that the location does not have keeps its own best one.
          {Rows{pdb_line(" N  ", 'A', "LEU", 1, 0.5), pdb_line(" N  ", 'B', "LEU", 1, 0.5),
                pdb_line(" CB ", 'C', "LEU", 1, 0.9), pdb_line(" CB ", 'A', "LEU", 1, 0.1)},
           "N:A CB:C"},
          // Two residues at one place: the atoms of one of them.
          {Rows{pdb_line(" CA ", 'A', "SER", 1, 0.4), pdb_line(" OG ", 'A', "SER", 1, 0.4),
                pdb_line(" CA ", 'B', "ALA", 1, 0.6), pdb_line(" CB ", 'B', "ALA", 1, 0.6)},
           "CA:B CB:B"},
          {Rows{pdb_line(" CA ", 'A', "SER", 1, 0.6), pdb_line(" CA ", 'B', "SER", 1, 0.4),
                pdb_line(" CA ", 'A', "SER", 2, 0.4), pdb_line(" CA ", 'B', "SER", 2, 0.6)},
           "CA:A CA:B"}}) {
      std::string text;
      for (const std::string& row : rows) text += row;
      CAPTURE(text);
      const AtomFrame frame = frame_of(text, Format::pdb);
      CHECK(names_of(frame) == kept);
      CHECK(frame.counts.alternates == rows.size() - frame.rows.size());
      CHECK(frame_of(text, Format::pdb, {.alternates = true}).rows.size() == rows.size());
    }
  }

  TEST_CASE("frames are models, each with its box, and the choice names some") {
    const std::string cell = "CRYST1   10.000   10.000   10.000  90.00  90.00  90.00 P 1\n",
                      wide = "CRYST1   12.000   10.000   10.000  90.00  90.00  90.00 P 1\n";
    const std::string models = cell + "MODEL        1\n" + pdb_line(" CA ") + pdb_line(" CB ") + "ENDMDL\n" + wide +
                               "MODEL        2\n" + pdb_line(" CG ") + "ENDMDL\nMODEL        3\n" + pdb_line(" CD ") +
                               "ENDMDL\nEND\n";
    std::vector<std::string> warnings;
    std::vector<AtomFrame> all = frames_of(models, Format::pdb, all_frames, &warnings);
    REQUIRE(all.size() == 3);
    CHECK(names_of(all[0]) == "CA CB");
    CHECK(names_of(all[1]) == "CG");
    CHECK(all[0].cell.sides->x == 10);
    CHECK(all[1].cell.sides->x == 12);
    CHECK(all[2].cell.sides->x == 12);
    CHECK(all[2].number == 3);
    CHECK(warnings == std::vector<std::string>{"frame 2 has 1 atom, frame 1 has 2: is the file whole?"});
    // Waters that are left out may be more in one frame than in another.
    const std::string water = pdb_line(" O  ", ' ', "HOH", 2);
    const std::string wet = pdb_line(" CA ") + water + "ENDMDL\n" + pdb_line(" CA ") + water + water + "ENDMDL\n";
    for (const auto& [choice, differs] : {std::pair(all_frames, false),
                                          {AtomChoice{.frames = {.all = true}, .where = "name == 'CA'"}, false},
                                          {AtomChoice{.frames = {.all = true}, .where = "resname != 'HOH'"}, true},
                                          {AtomChoice{.frames = {.all = true}, .waters = true}, true}}) {
      frames_of(wet, Format::pdb, choice, &warnings);
      CHECK(warnings.empty() != differs);
    }
    all = frames_of(models, Format::pdb, {.frames = parse_frames("--models", "3,1-2,2")});
    CHECK(all.size() == 3);
    all = frames_of(models, Format::pdb, {.frames = parse_frames("--models", "2")}, &warnings);
    REQUIRE(all.size() == 1);
    CHECK(names_of(all[0]) == "CG");
    CHECK(warnings == std::vector<std::string>{"the atoms are those of frame 2 of 3"});
    CHECK(refusal(models, Format::pdb, {.frames = parse_frames("--models", "2,4")}) ==
          "m: found 3 frames, expected frame 4");
    for (const std::string text :
         {"", "0", "1,", "2-1", "x", "1,,2", "-1", ":", ":2", "2:1", "1:3:0", "1:2:3:4", "1-2-3", "1,1:3"})
      CHECK(refusal_of([&] { parse_frames("--models", text); }) ==
            "--models: found '" + text +
                "', expected all, numbers from 1 such as 1,3,10-20, or FIRST:LAST:STEP such as 1:1000:10");
    for (const auto& [text, read] : {std::pair("1:3:2", "1 3 "),
                                     {"1:3", "1 2 3 "},
                                     {"2::1", "2 3 "},
                                     {"1::2", "1 3 "},
                                     {"3:", "3 "},
                                     {"2:2:9", "2 "}}) {
      const std::string shown_text = text;
      CAPTURE(shown_text);
      std::string numbers;
      for (const AtomFrame& one : frames_of(models, Format::pdb, {.frames = parse_frames("--models", text)}))
        numbers += std::to_string(one.number) + " ";
      CHECK(numbers == read);
    }
    CHECK(refusal(models, Format::pdb, {.frames = parse_frames("--models", "4::2")}) ==
          "m: found 3 frames, expected frame 4");

    const std::string names =
        "data_x\nloop_\n_atom_site.label_atom_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
        "_atom_site.Cartn_z\n_atom_site.pdbx_PDB_model_num\n";
    all = frames_of(names + "CA 1 2 3 1\nCB 1 2 3 1\nCG 4 5 6 7\n", Format::cif, all_frames);
    REQUIRE(all.size() == 2);
    CHECK(names_of(all[0]) == "CA CB");
    CHECK(names_of(all[1]) == "CG");
    // The first model has the cell, too, before the atoms or after them.
    const std::string atoms = "CA 1 2 3 1\nCB 1 2 3 2\n",
                      lengths = "_cell.length_a 10\n_cell.length_b 11\n_cell.length_c 12\n",
                      angles = "_cell.angle_alpha 90\n_cell.angle_beta 90\n_cell.angle_gamma 90\n";
    for (const std::string& text :
         {"data_x\n" + lengths + angles + names.substr(7) + atoms, names + atoms + lengths + angles})
      for (const rbpa::app::AtomChoice& choice : {rbpa::app::AtomChoice(), all_frames})
        CHECK(frames_of(text, Format::cif, choice).at(0).cell.sides->y == 11);
    CHECK(refusal(names + "CA 1 2 3 1\nCB 1 2 3 2\nCG 4 5 6 1\n", Format::cif) ==
          "m:10: found an atom of model '1' behind another model, expected all atoms of a model together");
  }

  TEST_CASE("charges of PDB are a digit and a sign in either order, and anything else is none") {
    const std::string atom = "ATOM      1  N   LYS A   1       1.000   2.000   3.000  1.00  5.28           N";
    REQUIRE(atom.size() == 78);
    for (const char a : {' ', '0', '1', '9', '+', '-', 'A'})
      for (const char b : {' ', '0', '2', '9', '+', '-', '*'}) {
        CAPTURE(a);
        CAPTURE(b);
        const double charge = frame_of(atom + a + b + "\n", Format::pdb).rows[0].charge;
        const bool comes_last = a >= '0' && a <= '9' && (b == '+' || b == '-');
        const bool comes_first = b >= '0' && b <= '9' && (a == '+' || a == '-');
        if (!comes_last && !comes_first) CHECK(std::isnan(charge));
        if (comes_last) CHECK(charge == (b == '-' ? '0' - a : a - '0'));
        if (comes_first) CHECK(charge == (a == '-' ? '0' - b : b - '0'));
      }
  }

  TEST_CASE("PQR is read in words and in columns, with charges and radii") {
    for (const std::string line :
         {"ATOM      1  CA  ALA A  12B     1.500   2.000  -3.000 -0.5000 1.9080\n",
          "ATOM 1 CA ALA A 12B 1.5 2 -3 -0.5 1.908\n", "ATOM 1 CA ALA A12B 1.5 2 -3 -0.5 1.908\n",
          "ATOM  1 CA ALA A 12B   1.5  2.0 -3.0 -0.5 1.908 \n"}) {
      CAPTURE(line);
      const AtomFrame frame = frame_of("REMARK 1\n" + line + "END\n", Format::pqr);
      CHECK(frame.title(frame.rows[0]) == "atom CA of residue ALA A 12B");
      CHECK(centers(frame) == std::vector<Point3>{{1.5, 2, -3}});
      CHECK(frame.column(&AtomRow::charge) == std::vector<double>{-0.5});
      CHECK(radii(frame) == std::vector<double>{1.908});
      CHECK(element(frame, 0) == "C");
    }
    const AtomFrame touching =
        frame_of("ATOM  12345 HH11AARG A1234    -132.386-100.407-109.247  0.5000 0.0000\n", Format::pqr);
    CHECK(centers(touching) == std::vector<Point3>{{-132.386, -100.407, -109.247}});
    CHECK(radii(touching) == std::vector<double>{0});
    CHECK(rbpa::app::space_points_in("ATOM 1 CA ALA 12 1.5 2 -3 -0.5 1.908\n", "m", Format::pqr).points ==
          std::vector<Point3>{{1.5, 2, -3}});
    CHECK(refusal("ATOM 1 CA ALA A 12 1.5 2 -3 -0.5\n", Format::pqr) ==
          "m:1: found 'ATOM 1 CA ALA A 12 1.5 2 -3 -0.5', expected an atom of PQR: serial, name, residue, chain or "
          "none, number, x, y, z, charge and radius");
    CHECK(refusal("\nATOM 1 CA ALA A 12 1.5 2 -3 -0.5 -1\n", Format::pqr) ==
          "m:2: found '-1' as a radius, expected a number of at least 0");
    CHECK(refusal("END\n", Format::pqr) ==
          "m: found no record ATOM or HETATM, expected the atoms of a file in PQR format");
  }

  TEST_CASE(".gro is read by its columns, in angstroms, with each frame's box") {
    const std::string frame =
        "a title, t= 0.0\n 3\n    1ALA     CA    1   0.126  -1.639   0.679\n"
        "    2SOL     OW    2   0.100   0.200   0.300  0.1000  0.2000  0.3000\n"
        "    3NA      NA    3   1.000   2.000   3.000\n";
    std::vector<std::string> warnings;
    const std::vector<AtomFrame> all =
        frames_of(frame + "   1.86824   1.86824   1.86824\n" + frame + "1 2 3 0 0 0.5 0 0.25 0.125\n\n", Format::gro,
                  all_frames, &warnings);
    REQUIRE(all.size() == 2);
    CHECK(centers(all[0]) == std::vector<Point3>{{1.26, -16.39, 6.79}, {10, 20, 30}});
    CHECK(all[0].title(all[0].rows[0]) == "atom CA of residue ALA 1");
    CHECK(element(all[0], 0) == "C");
    CHECK(element(all[0], 1) == "Na");
    CHECK(all[0].counts.waters == 1);
    CHECK(all[0].cell.sides == Point3{18.6824, 18.6824, 18.6824});
    CHECK(all[1].cell.edges == CellEdges{{{10, 0, 0}, {5, 20, 0}, {2.5, 1.25, 30}}});
    CHECK(all[1].cell.fault == "the box with edges that are not along x, y and z");
    CHECK(warnings ==
          std::vector<std::string>{"coordinates and the box are in angstroms, ten times the nanometers of the file"});
    // Other precisions have wider columns; a box of zeros is none.
    const AtomFrame precise =
        frame_of("\n1\n    1ALA     CA    1   0.12600001  -1.63900000   0.67900000\n 0 0 0\n", Format::gro);
    CHECK(centers(precise) == std::vector<Point3>{{1.2600001, -16.39, 6.79}});
    CHECK(!precise.cell.edges);
    const auto points = rbpa::app::space_points_in(frame + " 1 1 1\n", "m", Format::gro);
    CHECK(points.points.size() == 3);
    CHECK(points.points[0] == Point3{1.26, -16.39, 6.79});
    for (const auto& [text, says] :
         {std::pair("t\nx\n", "m:2: found 'x', expected the number of atoms, at least 1"),
          {"t\n0\n1 1 1\n", "m:2: found '0', expected the number of atoms, at least 1"},
          {"t\n", "m: found the end of the file behind line 1, expected a title and the number of atoms"},
          {"t\n2\n    1ALA     CA    1   0.126  -1.639   0.679\n",
           "m: found the end of the file behind line 3, expected 1 further atom"},
          {"t\n1\n    1ALA     CA    1   0.126  -1.6x9   0.679\n1 1 1\n",
           "m:3: found '-1.6x9' as y, expected a number"},
          {"t\n1\n    1ALA     CA    1   0126\n1 1 1\n",
           "m:3: found '1ALA     CA    1   0126', expected an atom of .gro in columns: residue number and name, atom "
           "name and number, x, y, z"},
          {"t\n1\n    1ALA     CA    1   0.126  -1.639   0.679\n",
           "m: found the end of the file behind line 3, expected the box, three or nine numbers"},
          {"t\n1\n    1ALA     CA    1   0.126  -1.639   0.679\n1 2\n",
           "m:4: found '1 2', expected the box, three or nine numbers"},
          {"\n", "m: found no atom, expected the atoms of a file in GROMACS' .gro format"}}) {
      const auto& shown_text = text;
      CAPTURE(shown_text);
      CHECK(refusal(text, Format::gro) == says);
    }
  }

  TEST_CASE("dumps of LAMMPS are read by the names of their columns, scaled or not") {
    const auto dump = [](const std::string& box, const std::string& atoms) {
      return "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS " + box + "ITEM: ATOMS " + atoms;
    };
    const std::string square = "pp pp pp\n-1 9\n0 20\n0 40\n", tilted = "xy xz yz pp pp pp\n-2 12 2\n0 20 -2\n0 40 0\n";
    const AtomFrame plain = frame_of(
        dump(square, "id type element x y z radius mol\n1 1 C 1 2 3 1.7 4\n2 2 O 4 5 6 1.5 4\n"), Format::dump);
    CHECK(centers(plain) == std::vector<Point3>{{1, 2, 3}, {4, 5, 6}});
    CHECK(radii(plain) == std::vector<double>{1.7, 1.5});
    CHECK(element(plain, 1) == "O");
    CHECK(plain.cell.sides == Point3{10, 20, 40});
    CHECK(radii(frame_of(dump(square, "xu yu zu diameter\n1 2 3 4\n5 6 7 3\n"), Format::dump)) ==
          std::vector<double>{2, 1.5});
    CHECK(centers(frame_of(dump(square, "type xs ys zs\n1 0.5 0.5 0.5\n1 0 0 0\n"), Format::dump)) ==
          std::vector<Point3>{{4, 10, 20}, {-1, 0, 0}});
    const AtomFrame skew = frame_of(dump(tilted, "type xs ys zs\n1 0 0 0\n1 1 1 1\n"), Format::dump);
    CHECK(skew.cell.edges == CellEdges{{{10, 0, 0}, {2, 20, 0}, {-2, 0, 40}}});
    CHECK(centers(skew) == std::vector<Point3>{{0, 0, 0}, {10, 20, 40}});
    const AtomFrame open = frame_of(dump("pp ff pp\n0 1\n0 1\n0 1\n", "x y z\n1 0 0\n0 1 0\n"), Format::dump);
    CHECK(open.cell.repeats == std::array<bool, 3>{true, false, true});
    CHECK(open.cell.fault == "BOX BOUNDS that does not repeat along all of x, y and z");
    const std::string one = dump(square, "id x y z c_s\n1 1 2 3 7\n2 4 5 6 8\n");
    CHECK(frames_of(one + one + one, Format::dump, all_frames).size() == 3);
    CHECK(radii(frame_of(one, Format::dump, {.radius = "c_s"})) == std::vector<double>{7, 8});
    CHECK(frame_of(one, Format::dump, {.where = "c_s > 7 and x > 3"}).rows.size() == 1);
    CHECK(rbpa::app::space_points_in(one, "m", Format::dump).points == std::vector<Point3>{{1, 2, 3}, {4, 5, 6}});
    for (const auto& [text, says] :
         {std::pair(std::string("x\n"), "m:1: found 'x', expected a line that begins with ITEM:"),
          {"ITEM: TIMESTEP\n", "m: found the end of the file behind line 1, expected the value of 'TIMESTEP'"},
          {"ITEM: NUMBER OF ATOMS\n-1\n", "m:2: found '-1', expected the number of atoms, at least 1"},
          {"ITEM: ATOMS x y z\n1 2 3\n",
           "m:1: found atoms without their number, expected 'ITEM: NUMBER OF ATOMS' before them"},
          {dump("pp pp pp\n0 1\n0 x\n0 1\n", "x y z\n"), "m:7: found '0 x', expected two bounds of the box"},
          {dump("abc origin pp pp pp\n", ""),
           "m:5: found a general box, expected bounds, of LAMMPS without triclinic/general"},
          {dump(square, "id x y\n1 2 3\n"),
           "m:9: found 'ITEM: ATOMS id x y', expected columns x y z, xu yu zu, xs ys zs or xsu ysu zsu"},
          {dump(square, "x yu zu\n1 2 3\n"),
           "m:9: found 'ITEM: ATOMS x yu zu', expected columns x y z, xu yu zu, xs ys zs or xsu ysu zsu"},
          {dump(square, "x y z\n1 2 3\n1 2\n"), "m:11: found 2 values ('1 2'), expected 3, one for each column"},
          {dump(square, "x y z\n1 2 3\n"), "m: found the end of the file behind line 10, expected 1 further atom"},
          {dump(square, "x y z\n1 2 3\n1 2 z\n"), "m:11: found 'z' as z, expected a number"},
          {"ITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS xs ys zs\n0 0 0\n",
           "m:3: found scaled coordinates without ITEM: BOX BOUNDS, expected a box before them"},
          {one + dump(square, "x y z\n1 2 3\n1 2 3\n"),
           "m:20: found other columns than in the first frame, expected id, x, y, z, c_s"},
          {"\n", "m: found no atom, expected frames of atoms"}}) {
      const auto& shown_text = text;
      CAPTURE(shown_text);
      CHECK(refusal(text, Format::dump) == says);
    }
    CHECK(refusal(one, Format::dump, {.radius = "radius"}) ==
          "m:9: found no column 'radius', expected one of id, x, y, z, c_s");
  }

  TEST_CASE("the .xyz of chemistry has frames, named columns and a lattice") {
    const std::string plain = "2\nframe\nO 0 0 0\nH 0 0 1\n";
    std::vector<AtomFrame> all = frames_of(plain + plain + "\n" + plain, Format::text, all_frames);
    REQUIRE(all.size() == 3);
    CHECK(element(all[2], 1) == "H");
    CHECK(!all[2].cell.is_there());
    const std::string extended =
        "2\nLattice=\"5 0 0 1 6 0 0 0 7\" Properties=species:S:1:pos:R:3:radius:R:1:charge:R:1 pbc=\"T T F\"\n"
        "Si 0 0 0 2.1 0.5\n8 0 0 1 1.5 -0.5\n";
    const AtomFrame frame = frame_of(extended, Format::text);
    CHECK(radii(frame) == std::vector<double>{2.1, 1.5});
    CHECK(frame.column(&AtomRow::charge) == std::vector<double>{0.5, -0.5});
    CHECK(element(frame, 0) == "Si");
    CHECK(element(frame, 1) == "O");
    CHECK(frame.cell.edges == CellEdges{{{5, 0, 0}, {1, 6, 0}, {0, 0, 7}}});
    CHECK(frame.cell.repeats == std::array<bool, 3>{true, true, false});
    CHECK(radii(frame_of(extended, Format::text, {.where = "charge > 0", .radius = "charge"})) ==
          std::vector<double>{0.5});
    CHECK(refusal(plain + "3\nframe\nO 0 0 0\n", Format::text) ==
          "m: found the end of the file behind line 7, expected 2 further atoms");
    CHECK(refusal(plain + "x\n", Format::text) == "m:5: found 'x', expected the number of atoms, at least 1");
    CHECK(refusal("1\nLattice=\"1 0 0\" Properties=species:S:1:pos:R:3\nO 0 0 0\n", Format::text) ==
          "m:2: found '1 0 0', expected nine numbers of Lattice");
  }

  TEST_CASE("other points are a frame without names, with radii of a column") {
    const std::string table = "x,y,z,r\n0,0,0,1\n1,0,0,2\n0,1,0,3\n";
    const AtomFrame frame = frame_of(table, Format::text, {.where = "r > 1", .radius = "r"});
    CHECK(centers(frame) == std::vector<Point3>{{1, 0, 0}, {0, 1, 0}});
    CHECK(radii(frame) == std::vector<double>{2, 3});
    CHECK(frame.column(&AtomRow::index) == std::vector<std::size_t>{1, 2});
    CHECK(frame.counts.deselected == 1);
    CHECK(refusal("x,y,z,r\n0,0,0,-1\n", Format::text, {.radius = "r"}) ==
          "m: point 0: found '-1' as a radius, expected a number of at least 0");
    CHECK(refusal_of([&] { BallRadii(std::nullopt).of(frame_of(table, Format::text), "m"); }) ==
          "m: found points without radii, expected radii (--radii column:NAME, or --radius-default R)");
    CHECK(BallRadii(std::nullopt, 2.5).of(frame_of(table, Format::text), "m") == std::vector<double>(3, 2.5));
  }

  TEST_CASE("radii are those of the file, of Bondi and Mantina, of ProtOr, or overrides") {
    const std::string text = pdb_line(" N  ", ' ', "ASP") + pdb_line(" CA ", ' ', "ASP") +
                             pdb_line(" CG ", ' ', "ASP") + pdb_line(" OD2", ' ', "ASP") +
                             pdb_line(" CZ ", ' ', "PHE", 2) + pdb_line(" OH ", ' ', "TYR", 3) +
                             pdb_line(" SG ", ' ', "CYS", 4) + pdb_line("CA  ", ' ', "CA", 5, 1, "CA", "HETATM");
    const AtomFrame frame = frame_of(text, Format::pdb);
    const auto by = [&](const std::optional<std::string>& choice) { return BallRadii(choice).of(frame, "m"); };
    const std::vector<double> bondi = {1.55, 1.7, 1.7, 1.52, 1.7, 1.52, 1.8, 2.31};
    CHECK(by("bondi") == bondi);
    CHECK(by(std::nullopt) == bondi);
    CHECK(by("protor") == std::vector<double>{1.64, 1.88, 1.61, 1.42, 1.76, 1.46, 1.77, 2.31});
    BallRadii protor("protor");
    protor.of(frame, "m");
    protor.of(frame, "m");
    std::string used;
    for (const auto& [of, row] : protor.used())
      used += of.first + " " + std::string(of.second) + " " + std::to_string(row.least) + " " +
              std::to_string(row.greatest) + " " + std::to_string(row.atoms) + "\n";
    CHECK(used ==
          "C ProtOr 1.610000 1.880000 6\nCa Mantina 2.310000 2.310000 2\nN ProtOr 1.640000 1.640000 2\n"
          "O ProtOr 1.420000 1.460000 4\nS ProtOr 1.770000 1.770000 2\n");

    const Folder folder("radii.txt", "# mine\nC 1.9\nASP CG 1.25\n* CZ 1.5 # of any residue\n");
    const std::string path = folder.path("radii.txt");
    CHECK(by(path) == std::vector<double>{1.55, 1.9, 1.25, 1.52, 1.5, 1.52, 1.8, 2.31});
    for (const std::string line : {"Q 1", "C", "C -1", "C x", "ALA CA CB 1"}) {
      folder.file("wrong.txt", "C 1.9\n" + line + "\n");
      const std::string wrong = folder.path("wrong.txt");
      CHECK(refusal_of([&] { BallRadii{wrong}; }) ==
            wrong + ":2: found '" + line + "', expected 'ELEMENT RADIUS', 'RESIDUE ATOM RADIUS' or '* ATOM RADIUS'");
    }
    folder.file("twice.txt", "C 1.9\nc 1.8\n");
    const std::string twice = folder.path("twice.txt");
    CHECK(refusal_of([&] { BallRadii{twice}; }) ==
          twice + ":2: found 'c 1.8', expected one radius for each element and each atom");

    const AtomFrame metal =
        frame_of(pdb_line(" CA ") + pdb_line("PM  ", ' ', "PM", 154, 1, "PM", "HETATM"), Format::pdb);
    CHECK(refusal_of([&] { BallRadii("bondi").of(metal, "m"); }) ==
          "m:2: found element 'Pm' of atom PM of residue PM A 154, expected one with a radius of Bondi, Mantina or "
          "Alvarez "
          "(--radii FILE names its radius, --radius-default R is for all without one)");
    struct Metal {
      const char* symbol;
      double radius;
      const char* source;
    };
    for (const Metal& of : {Metal{"FE", 2.44, "Alvarez"},
                            {"MN", 2.45, "Alvarez"},
                            {"CO", 2.40, "Alvarez"},
                            {"MO", 2.45, "Alvarez"},
                            {"V", 2.42, "Alvarez"},
                            {"W", 2.57, "Alvarez"},
                            {"GD", 2.83, "Alvarez"},
                            {"ES", 2.70, "Alvarez"},
                            {"ZN", 1.39, "Bondi"},
                            {"CU", 1.40, "Bondi"},
                            {"NI", 1.63, "Bondi"},
                            {"NA", 2.27, "Bondi"},
                            {"MG", 1.73, "Bondi"},
                            {"K", 2.75, "Bondi"},
                            {"CD", 1.58, "Bondi"},
                            {"CA", 2.31, "Mantina"}}) {
      CAPTURE(of.symbol);
      BallRadii radii("bondi");
      const std::string line = pdb_line(of.symbol, ' ', of.symbol, 1, 1, of.symbol, "HETATM");
      CHECK(radii.of(frame_of(line, Format::pdb), "m") == std::vector<double>{of.radius});
      CHECK(radii.used().begin()->first.second == of.source);
    }
    CHECK(BallRadii("bondi", 2.0).of(metal, "m") == std::vector<double>{1.7, 2});
    for (const auto& [nameless, format, place] :
         {std::tuple("data_x\nloop_\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n1 2 3\n", Format::cif,
                     "m:6: found no element of atom 0, "),
          {"data_x\nloop_\n_atom_site.label_comp_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
           "LIG 1 2 3\n",
           Format::cif, "m:7: found no element of atom 0 of residue LIG, "},
          {"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\nITEM: ATOMS x y z\n"
           "1 2 3\n",
           Format::dump, "m:10: found no element of atom 0, "}}) {
      const AtomFrame frame = frame_of(nameless, format);
      CHECK(refusal_of([&] { BallRadii("bondi").of(frame, "m"); }).starts_with(place));
    }
    CHECK(refusal_of([&] { BallRadii("protor").of(frame_of(pdb_line(" HA "), Format::pdb), "m"); }) ==
          "m:1: found hydrogen, atom HA of residue ALA A 1, expected none, as ProtOr's radii include it "
          "(--no-hydrogens)");
    CHECK(BallRadii("column:charge").column() == "charge");
    CHECK(refusal_of([] { BallRadii("column:"); }) == "--radii: found column: and no name, expected column:NAME");
    CHECK(refusal_of([] { BallRadii(std::nullopt, -1.0); }) ==
          "--radius-default: found -1, expected a number of at least 0");
  }
}
