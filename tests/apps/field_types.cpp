// Types of fields: values of every type, and columns of atoms, are at the vertices of meshes as the file has them.
#include <doctest/doctest.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/las_file.h"
#include "support/program.h"
#include "support/vertex_fields.h"

using namespace apps_test;

namespace {

/// A type of fields: its names in .vtu, .ply (empty if it has none) and .pcd, and four values as bytes and in text.
struct TypeOfField {
  std::string vtu, ply, pcd;
  std::vector<std::string> values = {}, words = {};
};

template <typename T>
TypeOfField type_of(const std::string& vtu, const std::string& ply, const std::string& pcd) {
  TypeOfField type{vtu, ply, pcd};
  for (const T value : {std::numeric_limits<T>::lowest(), std::numeric_limits<T>::max(), static_cast<T>(1), T{}}) {
    type.values.emplace_back(reinterpret_cast<const char*>(&value), sizeof value);
    char text[64];
    type.words.emplace_back(text, std::to_chars(text, text + sizeof text, value).ptr);
  }
  return type;
}

}  // namespace

TEST_SUITE("fields") {
  TEST_CASE("values of every type, and lists of them, come from LAS, PLY, PCD and tables to every format, exactly") {
    const Folder folder;
    const std::vector<TypeOfField> types = {
        type_of<std::uint8_t>("UInt8", "uchar", "U"),    type_of<std::int8_t>("Int8", "char", "I"),
        type_of<std::uint16_t>("UInt16", "ushort", "U"), type_of<std::int16_t>("Int16", "short", "I"),
        type_of<std::uint32_t>("UInt32", "uint", "U"),   type_of<std::int32_t>("Int32", "int", "I"),
        type_of<std::uint64_t>("UInt64", "", "U"),       type_of<std::int64_t>("Int64", "", "I"),
        type_of<float>("Float32", "float", "F"),         type_of<double>("Float64", "double", "F")};
    const std::vector<std::string> corners = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
    for (std::size_t k = 0; k < types.size(); ++k) {
      const TypeOfField& type = types[k];
      CAPTURE(type.vtu);
      const std::size_t size = type.values[0].size();
      const auto values = [&](std::size_t shift) {
        std::string all;
        for (std::size_t i = 0; i < 4; ++i) all += type.values[(i + shift) % 4];
        return all;
      };
      const auto holds = [&](const std::string& file, const std::vector<std::string>& names) {
        CAPTURE(file);
        folder.rbpa("solid " + file + " --alpha inf -o m.vtu --boundary m.ply", 0);
        FieldMap vtu = fields_of_vtu(folder.content("m.vtu")), ply = fields_of_ply(folder.content("m.ply"));
        for (std::size_t i = 0; i < names.size(); ++i) {
          CHECK(vtu[names[i]].type == type.vtu);
          CHECK(vtu[names[i]].bytes == values(i));
          CHECK(ply.count(names[i]) == (type.ply.empty() ? 0 : 1));
          if (!type.ply.empty()) CHECK(ply[names[i]].type == type.ply);
          if (!type.ply.empty()) CHECK(ply[names[i]].bytes == values(i));
        }
      };
      for (std::size_t count = 1; count <= 3; ++count) {
        std::string extra(192, '\0');
        extra[2] = static_cast<char>(1 + k + 10 * (count - 1));
        extra[4] = 'v';
        LasFile las{.records = {{"LASF_Spec", 4, extra}}, .extra_bytes = static_cast<unsigned>(count * size)};
        las.points = {{}, {.x = 100}, {.y = 100}, {.z = 100}};
        std::string bytes = bytes_of(las);
        const std::size_t length = 20 + count * size, first = bytes.size() - 4 * length;
        std::vector<std::string> names;
        for (std::size_t j = 0; j < count; ++j) {
          names.push_back(count == 1 ? "v" : "v[" + std::to_string(j) + "]");
          for (std::size_t i = 0; i < 4; ++i)
            bytes.replace(first + i * length + 20 + j * size, size, values(j), i * size, size);
        }
        folder.file("p.las", bytes);
        holds("p.las", names);
      }
      std::string rows, pcd, ply, csv = "x,y,z,v\n";
      for (std::size_t i = 0; i < 4; ++i) {
        const float at[] = {i == 1 ? 1.F : 0.F, i == 2 ? 1.F : 0.F, i == 3 ? 1.F : 0.F};
        rows.append(reinterpret_cast<const char*>(at), sizeof at) += type.values[i];
        csv += corners[i] + " " + type.words[i] + "\n";
      }
      std::replace(csv.begin(), csv.end(), ' ', ',');
      folder.file("p.pcd", "VERSION 0.7\nFIELDS x y z v\nSIZE 4 4 4 " + std::to_string(size) + "\nTYPE F F F " +
                               type.pcd + "\nCOUNT 1 1 1 1\nWIDTH 4\nHEIGHT 1\nPOINTS 4\nDATA binary\n" + rows);
      holds("p.pcd", {"v"});
      if (!type.ply.empty()) {
        folder.file("p.ply",
                    "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float "
                    "y\nproperty float z\nproperty " +
                        type.ply + " v\nend_header\n" + rows);
        holds("p.ply", {"v"});
      }
      // A table has these words; what shape lists is such a table again.
      folder.file("p.csv", csv);
      for (const std::string name : {"p.las", "p.csv"}) {
        folder.rbpa("shape " + name + " --alpha inf -o o.csv", 0);
        std::string column;
        std::istringstream lines(folder.content("o.csv"));
        for (std::string line; std::getline(lines, line);)
          column += line.substr(name == "p.las" ? line.rfind(',', line.rfind(',', line.rfind(',') - 1) - 1)
                                                : line.rfind(','));
        CAPTURE(name);
        std::string expected = name == "p.las" ? ",v[0],v[1],v[2]" : ",v";
        for (std::size_t i = 0; i < 4; ++i)
          for (std::size_t j = 0; j < (name == "p.las" ? 3 : 1); ++j) expected += "," + type.words[(i + j) % 4];
        CHECK(column == expected);
      }
    }
  }

  TEST_CASE("atoms keep the columns of their file, with numbers and texts by column") {
    struct Molecule {
      std::string name, bytes, legend;
      std::vector<std::pair<std::string, std::string>> fields;  ///< name, type and values
    };
    const std::vector<Molecule> molecules = {
        {"m.pdb",
         "ATOM  99999  N   LYS 1   1       0.000   0.000   0.000  1.00  5.28           N\n"
         "ATOM  A0000  CA ALYS 1  -1A      1.000   0.000   0.000  0.50 20.00           C\n"
         "HETATM    3 NA    NA 2 201       0.000   1.000   0.000  1.00                NA1+\n"
         "HETATM    4  O   HOH 2 202       0.000   0.000   1.000  1.00 20.00           O\n",
         "<!-- chain: 0 = 1, 1 = 2 -->\n<!-- icode: 0 = , 1 = A -->\n<!-- resname: 0 = LYS, 1 = NA, 2 = HOH -->\n"
         "<!-- name: 0 = N, 1 = CA, 2 = NA, 3 = O -->\n<!-- element: 0 = N, 1 = C, 2 = NA, 3 = O -->\n"
         "<!-- altloc: 0 = , 1 = A -->\n<!-- record: 0 = ATOM, 1 = HETATM -->\n",
         {{"serial", "Int64 99999 100000 3 4"},
          {"chain", "Int32 0 0 1 1"},
          {"resseq", "Int64 1 -1 201 202"},
          {"icode", "Int32 0 1 0 0"},
          {"resname", "Int32 0 0 1 2"},
          {"name", "Int32 0 1 2 3"},
          {"element", "Int32 0 1 2 3"},
          {"altloc", "Int32 0 1 0 0"},
          {"occupancy", "Float64 1 0.5 1 1"},
          {"bfactor", "Float64 5.28 20 nan 20"},
          {"charge", "Float64 nan nan 1 nan"},
          {"record", "Int32 0 0 1 1"}}},
        {"m.pqr",
         "ATOM 1 N LYS 1 0 0 0 -0.3 1.85\nATOM 2 CA LYS 1 1 0 0 0.21 2\nATOM 3 C LYS 1 0 1 0 1 2\nATOM 4 O LYS 1 0 0 1 "
         "-1 2\n",
         "<!-- resname: 0 = LYS -->\n<!-- name: 0 = N, 1 = CA, 2 = C, 3 = O -->\n<!-- record: 0 = ATOM -->\n",
         {{"serial", "Int64 1 2 3 4"},
          {"resseq", "Int64 1 1 1 1"},
          {"resname", "Int32 0 0 0 0"},
          {"name", "Int32 0 1 2 3"},
          {"charge", "Float64 -0.3 0.21 1 -1"},
          {"record", "Int32 0 0 0 0"},
          {"radius", "Float64 1.85 2 2 2"}}},
        {"m.cif",
         "data_a\nloop_\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_asym_id\n"
         "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.B_iso_or_equiv\n"
         "_atom_site.pdbx_formal_charge\n"
         "7 N N A 0 0 0 5.28(3) 1\n8 C CA A 1 0 0 ? 0\n9 C C A 0 1 0 7 0\n10 O O B 0 0 1 7.5 -1\n",
         "<!-- chain: 0 = A, 1 = B -->\n<!-- name: 0 = N, 1 = CA, 2 = C, 3 = O -->\n"
         "<!-- element: 0 = N, 1 = C, 2 = O -->\n",
         {{"serial", "Int64 7 8 9 10"},
          {"chain", "Int32 0 0 0 1"},
          {"name", "Int32 0 1 2 3"},
          {"element", "Int32 0 1 1 2"},
          {"bfactor", "Float64 5.28 nan 7 7.5"},
          {"charge", "Int64 1 0 0 -1"}}},
        {"m.gro",
         "title\n4\n    1LYS      N    1   0.000   0.000   0.000\n    1LYS     CA    2   0.100   0.000   0.000\n"
         "    1LYS      C    3   0.000   0.100   0.000\n    2SOD     NA    4   0.000   0.000   0.100\n   5.0   5.0   "
         "5.0\n",
         "<!-- resname: 0 = LYS, 1 = SOD -->\n<!-- name: 0 = N, 1 = CA, 2 = C, 3 = NA -->\n",
         {{"serial", "Int64 1 2 3 4"},
          {"resseq", "Int64 1 1 1 2"},
          {"resname", "Int32 0 0 0 1"},
          {"name", "Int32 0 1 2 3"}}},
        {"m.dump",
         "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n4\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n"
         "ITEM: ATOMS id type x y z vx tag\n1 1 0 0 0 0.5 9007199254740993\n2 1 1 0 0 1 2\n3 2 0 1 0 2 3\n4 2 0 0 1 3 "
         "4\n",
         "",
         {{"id", "Int64 1 2 3 4"},
          {"type", "Int64 1 1 2 2"},
          {"vx", "Float64 0.5 1 2 3"},
          {"tag", "Int64 9007199254740993 2 3 4"}}},
        {"m.xyz",
         "4\nProperties=species:S:1:pos:R:3:charge:R:1\nN 0 0 0 0.5\nC 1 0 0 -1\nC 0 1 0 0\nO 0 0 1 1\n",
         "<!-- element: 0 = N, 1 = C, 2 = O -->\n",
         {{"element", "Int32 0 1 1 2"}, {"charge", "Float64 0.5 -1 0 1"}}}};
    for (const Molecule& molecule : molecules) {
      CAPTURE(molecule.name);
      const Folder folder(molecule.name, molecule.bytes);
      const auto fields = [&](const std::string& options) {
        folder.rbpa("solid " + molecule.name + " --alpha inf -o m.vtu " + options, 0);
        std::vector<std::pair<std::string, std::string>> found;
        for (const auto& [name, field] : fields_of_vtu(folder.content("m.vtu"))) {
          std::ostringstream text;
          text.precision(17);
          text << field.type;
          if (field.type == "Int32")
            for (const auto value : field.values<std::int32_t>()) text << ' ' << value;
          if (field.type == "Int64")
            for (const auto value : field.values<std::int64_t>()) text << ' ' << value;
          if (field.type == "Float64")
            for (const auto value : field.values<double>()) text << ' ' << doctest::toString(value).c_str();
          found.emplace_back(name, text.str());
        }
        return found;
      };
      auto expected = molecule.fields;
      std::sort(expected.begin(), expected.end());
      const std::string waters = molecule.name == "m.pdb" ? "--waters" : "";
      CHECK(fields(waters) == expected);
      CHECK(comments_of(folder.content("m.vtu"), "<!--") == molecule.legend);
      CHECK(fields(waters + " --fields none").empty());
      const auto chosen = fields(waters + " --fields " + expected[0].first);
      CHECK(chosen == decltype(chosen){expected[0]});
    }
  }

  TEST_CASE("fields of atoms follow them through conditions, boxes and waters") {
    const Folder folder;
    std::string text;
    for (int i = 0; i < 200; ++i) {
      char line[100];
      std::snprintf(line, sizeof line, "ATOM  %5d  CA  %s A%4d    %8.3f%8.3f%8.3f  1.00%6.2f\n", i,
                    i % 5 == 0 ? "HOH" : "LYS", i, i % 7 * 1.5, i % 11 * 1.25, i * 0.125, i / 4.);
      text += line;
    }
    folder.file("m.pdb", text);
    for (const std::string choice : {"", "--waters", "--where \"serial > 40 and bfactor < 40\"",
                                     "--bounds 0,2,6,9,3,20", "--bounds 0,2,6,9 --where \"bfactor < 40\""}) {
      CAPTURE(choice);
      folder.rbpa("solid m.pdb --alpha inf -o m.vtu --boundary m.ply " + choice, 0);
      FieldMap vtu = fields_of_vtu(folder.content("m.vtu")), ply = fields_of_ply(folder.content("m.ply"));
      const auto z = ply["z"].values<double>(), bfactor = ply["bfactor"].values<double>();
      const auto serial = ply["serial"].values<std::int32_t>();
      REQUIRE(z.size() > 10);
      CHECK(vtu["serial"].values<std::int64_t>().size() >= z.size());
      for (std::size_t i = 0; i < z.size(); ++i) {
        CHECK(z[i] == serial[i] * 0.125);
        CHECK(bfactor[i] == serial[i] / 4.);
      }
    }
  }
}
