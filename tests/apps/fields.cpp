// Fields: the values beside coordinates are at the vertices of meshes, with the types that they have in the file.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/las_file.h"
#include "support/laz_file.h"
#include "support/program.h"
#include "support/vertex_fields.h"

using namespace apps_test;

TEST_SUITE("fields") {
  TEST_CASE("columns of a table have the types of their values, exactly") {
    const Folder folder("p.csv",
                        "x,y,count,id,ratio,label,code,\"a \"\"b\" & <c>\",größe,mixed,huge\n"
                        "0,0,1,9223372036854775807,0.5,oak,007,1,1.25,1,18446744073709551615\n"
                        "1,0,-2,-9223372036854775808,,elm,8,2,NaN,x,1\n"
                        "0,1,3,9007199254740993,1e300,oak,9,3,-0.5,2.5,2\n");
    folder.rbpa("mesh p.csv --alpha inf -o m.vtu -o m.ply", 0);
    FieldMap vtu = fields_of_vtu(folder.content("m.vtu"));
    CHECK(vtu["count"].type == "Int64");
    CHECK(vtu["count"].values<std::int64_t>() == std::vector<std::int64_t>{1, -2, 3});
    CHECK(vtu["id"].type == "Int64");
    CHECK(vtu["id"].values<std::int64_t>() == std::vector<std::int64_t>{std::numeric_limits<std::int64_t>::max(),
                                                                        std::numeric_limits<std::int64_t>::min(),
                                                                        9007199254740993});
    CHECK(vtu["ratio"].type == "Float64");
    const std::vector<double> ratio = vtu["ratio"].values<double>();
    CHECK(ratio[0] == 0.5);
    CHECK(std::isnan(ratio[1]));
    CHECK(ratio[2] == 1e300);
    CHECK(vtu["label"].type == "Int32");
    CHECK(vtu["label"].values<std::int32_t>() == std::vector<std::int32_t>{0, 1, 0});
    CHECK(vtu["code"].values<std::int32_t>() == std::vector<std::int32_t>{0, 1, 2});
    CHECK(vtu["a &quot;b&quot; &amp; &lt;c&gt;"].values<std::int64_t>() == std::vector<std::int64_t>{1, 2, 3});
    CHECK(vtu["größe"].type == "Float64");
    CHECK(vtu["mixed"].values<std::int32_t>() == std::vector<std::int32_t>{0, 1, 2});
    CHECK(vtu["huge"].type == "Int32");
    CHECK(vtu.size() == 9);
    CHECK(comments_of(folder.content("m.vtu"), "<!--") ==
          "<!-- label: 0 = oak, 1 = elm -->\n<!-- code: 0 = 007, 1 = 8, 2 = 9 -->\n"
          "<!-- mixed: 0 = 1, 1 = x, 2 = 2.5 -->\n<!-- huge: 0 = 18446744073709551615, 1 = 1, 2 = 2 -->\n");

    FieldMap ply = fields_of_ply(folder.content("m.ply"));
    CHECK(ply["count"].type == "int");
    CHECK(ply["count"].values<std::int32_t>() == std::vector<std::int32_t>{1, -2, 3});
    CHECK(ply.count("id") == 0);  // no number of PLY holds it
    CHECK(ply["a_\"b\"_&_<c>"].values<std::int32_t>() == std::vector<std::int32_t>{1, 2, 3});
    CHECK(ply["ratio"].bytes == vtu["ratio"].bytes);
    CHECK(comments_of(folder.content("m.ply"), "comment ").starts_with("comment label: 0 = oak, 1 = elm\n"));
    CHECK(contains(
        folder.rbpa("mesh p.csv --alpha inf -o m.ply", 0).err,
        "rbpa: p.csv: field 'id' is left out of m.ply: no number of PLY holds integers beyond 2^53 (.vtu does)\n"));
    CHECK(fields_of_ply(folder.content("m.ply")).size() == 3 + 8);
  }

  TEST_CASE("--fields chooses by name, and what is not there or cannot be held is refused") {
    const Folder folder("p.csv", "x,y,a,b\n0,0,1,4\n1,0,2,5\n0,1,3,6\n");
    folder.rbpa("mesh p.csv --alpha inf -o m.ply --fields B", 0);
    CHECK(fields_of_ply(folder.content("m.ply")).count("b") == 1);
    CHECK(fields_of_ply(folder.content("m.ply")).count("a") == 0);
    folder.rbpa("mesh p.csv --alpha inf -o n.ply --fields none", 0);
    CHECK(fields_of_ply(folder.content("n.ply")).size() == 3);
    folder.file("q.xy", corner);
    folder.rbpa("mesh q.xy --alpha inf -o o.ply", 0);  // a file without fields
    CHECK(folder.content("o.ply") == folder.content("n.ply"));
    const auto refused = [&](const std::string& arguments) { return folder.rbpa(arguments).err; };
    CHECK(
        refused("mesh p.csv --alpha inf -o m.ply --fields a,c") ==
        "rbpa: p.csv: no column has a known name of heights, so there is no z (--columns X,Y,Z takes z from 'a' or "
        "'b')\nrbpa: p.csv: found no field 'c' beside the coordinates, expected some of 'a' (--fields chooses them)\n");
    CHECK(refused("mesh q.xy --alpha inf -o m.ply --fields c") ==
          "rbpa: q.xy: found no field 'c' beside the coordinates, expected one, as --fields requires\n");
    CHECK(refused("mesh p.csv --alpha inf -o m.off --fields a") ==
          "rbpa: --fields requires a mesh in ply or vtu, which hold fields\n");
    CHECK(refused("mesh p.csv --alpha inf -o m.ply --fields a,,b").starts_with("rbpa: --fields: found 'a,,b'"));
  }

  TEST_CASE("fields follow their points through conditions, boxes, --compact and duplicates") {
    const Folder folder;
    std::string text = "x,y,n\n";
    std::mt19937 random(3);
    for (int i = 0; i < 9000; ++i)
      text += std::to_string(random() % 100) + "," + std::to_string(random() % 100) + "," + std::to_string(i) + "\n";
    folder.file("p.csv", text);
    for (const std::string choice :
         {"", "--where \"n > 4500\"", "--bounds 10,10,70,60", "--bounds 10,10,70,60 --where \"n < 6000\""})
      for (const std::string compact : {"", " --compact"}) {
        CAPTURE(choice);
        const Outcome outcome = folder.rbpa("mesh p.csv --alpha inf -o m.ply " + choice + compact, 0);
        CHECK(contains(outcome.err, " on others: triangles have the fields of the first point of each place\n"));
        FieldMap fields = fields_of_ply(folder.content("m.ply"));
        const std::vector<double> x = fields["x"].values<double>(), y = fields["y"].values<double>();
        const std::vector<std::int32_t> n = fields["n"].values<std::int32_t>();
        REQUIRE(n.size() > 100);
        for (std::size_t i = 0; i < n.size(); ++i)
          REQUIRE(contains(text, "\n" + std::to_string(static_cast<int>(x[i])) + "," +
                                     std::to_string(static_cast<int>(y[i])) + "," + std::to_string(n[i]) + "\n"));
      }
  }

  TEST_CASE("fields of LAS and LAZ are kept by their types, with extra bytes") {
    const Folder folder;
    std::string extra(4 * 192, '\0');
    const auto describe = [&](std::size_t k, unsigned type, unsigned options, const std::string& name) {
      extra[192 * k + 2] = static_cast<char>(type);
      extra[192 * k + 3] = static_cast<char>(options);
      extra.replace(192 * k + 4, name.size(), name);
    };
    describe(0, 8, 0, "big id");          // int64
    describe(1, 0, 2, "without a type");  // two bytes
    describe(2, 3, 24, "height");         // uint16, scaled
    describe(3, 14, 24, "pair");          // a list of two int16, scaled
    for (const std::size_t k : {2U, 3U}) {
      extra.replace(k * 192 + 112, 16, little(0.5) + little(2.));
      extra.replace(k * 192 + 136, 16, little(-10.) + little(1.));
    }
    LasFile las{.minor = 4, .format = 6, .records = {{"LASF_Spec", 4, extra}}, .extra_bytes = 16};
    for (int i = 0; i < 50; ++i)
      las.points.push_back({.x = i * i % 37 * 100,
                            .y = i * 100,
                            .z = i,
                            .intensity = 65000U + static_cast<unsigned>(i),
                            .return_number = static_cast<unsigned>(i % 15),
                            .classification = static_cast<unsigned>(i % 2 == 0 ? 2 : 255),
                            .scan_angle = -1000 * i / 50,
                            .time = 1e9 + i / 3.});
    std::string bytes = bytes_of(las);
    const std::size_t first = bytes.size() - 50 * 46;
    for (std::size_t i = 0; i < 50; ++i)
      bytes.replace(first + 46 * i + 30, 16,
                    little((1ULL << 62U) + i, 8) + "ab" + little(i, 2) + little(i, 2) + little(-i, 2));
    folder.file("p.las", bytes);
    folder.file("p.laz", laz_of(bytes, {.compressor = 3, .items = {{10, 30, 3}, {14, 16, 3}}, .chunks = {50}}));
    for (const std::string name : {"p.las", "p.laz"}) {
      folder.rbpa("mesh " + name + " --alpha inf -o m.vtu", 0);
      FieldMap vtu = fields_of_vtu(folder.content("m.vtu"));
      CHECK(vtu["intensity"].type == "UInt16");
      CHECK(vtu["classification"].type == "UInt8");
      CHECK(vtu["gps_time"].type == "Float64");
      CHECK(vtu["scan_angle"].type == "Float64");
      CHECK(vtu["big id"].type == "Int64");
      CHECK(vtu.count("without a type") == 0);
      CHECK(vtu["height"].type == "Float64");
      for (std::size_t i = 0; i < 50; ++i) {
        CHECK(vtu["intensity"].values<std::uint16_t>()[i] == 65000U + i);
        CHECK(vtu["classification"].values<std::uint8_t>()[i] == (i % 2 == 0 ? 2 : 255));
        CHECK(vtu["return_number"].values<std::uint8_t>()[i] == i % 15);
        CHECK(vtu["gps_time"].values<double>()[i] == 1e9 + static_cast<int>(i) / 3.);
        CHECK(vtu["big id"].values<std::int64_t>()[i] == static_cast<std::int64_t>((1ULL << 62U) + i));
        CHECK(vtu["height"].values<double>()[i] == 0.5 * static_cast<double>(i) - 10);
        CHECK(vtu["pair[0]"].values<double>()[i] == 0.5 * static_cast<double>(i) - 10);
        CHECK(vtu["pair[1]"].values<double>()[i] == 1 - 2. * static_cast<double>(i));
      }
      folder.rbpa("mesh " + name + " --alpha inf -o m.ply --fields gps_time,classification", 0);
      FieldMap ply = fields_of_ply(folder.content("m.ply"));
      CHECK(ply["gps_time"].bytes == vtu["gps_time"].bytes);
      CHECK(ply["classification"].type == "uchar");
      CHECK(ply.size() == 5);
    }
  }

  TEST_CASE("groups have the fields of the first point of each place, with a warning") {
    const Folder folder("p.csv", "x,y,g,n\n0,0,a,1\n1,0,a,2\n0,1,a,3\n0,0,a,4\n0,0,b,5\n2,0,b,6\n0,2,b,7\n");
    const Outcome outcome = folder.rbpa("mesh p.csv --group-by g --alpha inf -o m.ply --compact", 0);
    CHECK(
        contains(outcome.err, "1 point lies on others: triangles have the fields of the first point of each place\n"));
    CHECK(fields_of_ply(folder.content("m.ply"))["n"].values<std::int32_t>() ==
          std::vector<std::int32_t>{1, 2, 3, 5, 6, 7});
    folder.file("q.csv", "x,y,g,n\n0,0,a,1\n1,0,a,2\n0,1,a,3\n0,0,b,5\n2,0,b,6\n0,2,b,7\n");
    CHECK(!contains(folder.rbpa("mesh q.csv --group-by g --alpha inf -o m.ply", 0).err, "lies on others"));
  }

  TEST_CASE("a name chooses the field with exactly this name before those that differ in case and underscores") {
    const Folder folder("p.csv", "x,y,a_b,ab,AB\n0,0,1,4,7\n1,0,2,5,8\n0,1,3,6,9\n");
    for (const auto& [name, sum] : {std::pair("ab", 15), {"AB", 24}, {"a_b", 6}, {"Ab", 15}, {"A_b", 6}}) {
      const auto& shown_name = name;
      CAPTURE(shown_name);
      folder.rbpa(std::string("shape p.csv --alpha inf -o s.geojson --summarize ") + name + ":sum", 0);
      const std::string file = folder.content("s.geojson");
      CHECK(contains(file, "_sum\":" + std::to_string(sum)));
    }
  }

  TEST_CASE("surfaces and solids keep fields of PLY and PCD, also at vertices that fillings add") {
    const Folder folder;
    std::string rows, words;
    int count = 0;
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j < 12; ++j) {
        if (i > 2 && i < 9 && j > 2 && j < 9) continue;  // a hole
        ++count;
        rows += std::to_string(i) + " " + std::to_string(j) + " 0 0 0 1 " + std::to_string(i / 4.) + " " +
                std::to_string(j < 6 ? 7 : 9) + "\n";
        words += std::to_string(i) + " " + std::to_string(j) + " " + std::to_string(i % 2) + " " +
                 std::to_string(count) + "\n";
      }
    folder.file("p.ply", "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) +
                             "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty "
                             "float ny\nproperty float nz\nproperty double level\nproperty ushort label\nend_header\n" +
                             rows);
    folder.rbpa("surface p.ply --radius 0.8 --fill-holes all --refine -o s.ply -o s.vtu", 0);
    FieldMap ply = fields_of_ply(folder.content("s.ply")), vtu = fields_of_vtu(folder.content("s.vtu"));
    CHECK(ply["label"].type == "ushort");
    CHECK(ply["label"].bytes == vtu["label"].bytes);
    CHECK(ply["level"].bytes == vtu["level"].bytes);
    const std::vector<double> x = ply["x"].values<double>(), level = ply["level"].values<double>();
    const std::vector<std::uint16_t> label = ply["label"].values<std::uint16_t>();
    REQUIRE(x.size() > static_cast<std::size_t>(count));  // vertices are added
    for (std::size_t i = 0; i < x.size(); ++i) {
      CHECK((label[i] == 7 || label[i] == 9));
      CHECK(level[i] >= 0);
      CHECK(level[i] <= 11 / 4.);
      if (i < static_cast<std::size_t>(count)) CHECK(level[i] == x[i] / 4);
    }
    folder.file("p.pcd", "VERSION 0.7\nFIELDS x y z id\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH " +
                             std::to_string(count) + "\nHEIGHT 1\nPOINTS " + std::to_string(count) + "\nDATA ascii\n" +
                             words);
    folder.rbpa("solid p.pcd --alpha inf -o t.vtu --boundary b.ply", 0);
    FieldMap solid = fields_of_vtu(folder.content("t.vtu")), boundary = fields_of_ply(folder.content("b.ply"));
    CHECK(solid["id"].type == "UInt32");
    CHECK(solid["id"].values<std::uint32_t>().back() == static_cast<std::uint32_t>(count));
    const std::vector<std::uint32_t> id = boundary["id"].values<std::uint32_t>(),
                                     point = boundary["point"].values<std::uint32_t>();
    REQUIRE(id.size() > 10);
    for (std::size_t i = 0; i < id.size(); ++i) CHECK(id[i] == point[i] + 1);
  }

  TEST_CASE("a name that a mesh uses gets a suffix, and a wrong word leaves out its column alone") {
    const Folder folder("p.csv", "x,y,z,point,point,a\n0,0,0,1,4,7\n1,0,0,2,5,8\n0,1,0,3,6,9\n0,0,1,4,7,9\n");
    folder.rbpa("surface p.csv --normals none --radius 2 -o s.ply --manifold", 0);
    const FieldMap fields = fields_of_ply(folder.content("s.ply"));
    CHECK(fields.count("point_2") == 1);
    CHECK(fields.count("point_3") == 1);
    CHECK(fields.count("a") == 1);
    folder.file("q.ply",
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty int a\nproperty "
                "uchar b\nend_header\n0 0 1 2\n1 0 x 3\n0 1 2 4\n");
    const Outcome outcome = folder.rbpa("mesh q.ply --alpha inf -o m.ply", 0);
    CHECK(contains(outcome.err, "field 'a' is left out: q.ply:10: found 'x', expected a number of its type\n"));
    FieldMap left = fields_of_ply(folder.content("m.ply"));
    CHECK(left.count("a") == 0);
    CHECK(left["b"].values<std::uint8_t>() == std::vector<std::uint8_t>{2, 3, 4});
  }
}
