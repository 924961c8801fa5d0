// Tables as people have them: titles above the header, decimal commas, missing values, geometries in a column, .gz.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <initializer_list>
#include <random>
#include <string>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/cloud/read_points.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "io/formats.h"
#include "io/number.h"
#include "io/text/fields.h"
#include "support/program.h"
#include "support/read_table.h"
#include "support/refusal_of.h"

using namespace apps_test;
using rbpa::Point;
using namespace rbpa::app;

namespace {

const std::vector<Point> three = {{13.4, 52.5}, {7.1, 50.7}, {-3, 40}};
const CloudRequest skipping{.skip_invalid = true};

}  // namespace

TEST_SUITE("tables of people") {
  TEST_CASE("signs between thousands are refused by their name, with any separator and any sign") {
    struct Number {
      std::string written, plain;
    };
    for (const Number& number : std::initializer_list<Number>{{"345.941,89", "345941,89"},
                                                              {"5.678.656,57", "5678656,57"},
                                                              {"-1,234,567", "-1234567"},
                                                              {"1,234.5", "1234.5"},
                                                              {"1'234.5", "1234.5"},
                                                              {"1\xE2\x80\x99"
                                                               "234",
                                                               "1234"},
                                                              {"1\xE2\x80\xAF"
                                                               "234\xE2\x80\xAF"
                                                               "567,5",
                                                               "1234567,5"}})
      for (const std::string separator : {";", "\t", " "})
        for (const std::string& header : {"east" + separator + "north\n", std::string()}) {
          CAPTURE(number.written);
          CAPTURE(separator);
          CAPTURE(header);
          const std::string line = number.written + separator + number.written + "\n", text = header + line + line;
          const std::string at = header.empty() ? "t:1" : "t:2";
          const std::string why = at + ": found '" + number.written + "', expected a number without signs between " +
                                  "thousands, " + number.plain + " (export the table with cells in a plain format";
          CHECK(refusal_of_table(text) == why + ")");
          // Other numbers have no sign below a thousand, and are no points that could remain.
          CHECK(refusal_of_table(text + "1" + separator + "2\n") == why + ")");
          CHECK(contains(refusal_of_table("999.456" + separator + "123.456\n" + line, skipping), "between thousands"));
          CHECK(refusal_of_table(text, skipping) == why + ")");
          if (!header.empty()) CHECK(refusal_of_table(text, {.columns = parse_columns("east,north")}) == why + ")");
        }
    for (const std::string field : {"1.234", "1,234", "1234,567,890", "1,23,456", "1.234,5.6", "1,234.567.8", "a", "",
                                    "1,2345", "1.234,x", "POINT (1,234)"})
      CHECK_FALSE(has_thousands(field));
  }

  TEST_CASE("a title above a table and a sum below it are refused with the option that leaves them out") {
    const std::string table = "x,y\n1,2\n3,5\n";
    for (const std::string& text : {"Export 2024\n" + table, "Export\n" + table, "All of my points\n" + table,
                                    table + "Total,1500\n", table + "Total\n", table + "1500\n", table + ",7\n"})
      for (const std::string columns : {"", "1,2", "x,y"}) {
        CAPTURE(text);
        CAPTURE(columns);
        CloudRequest request;
        if (!columns.empty()) request.columns = parse_columns(columns);
        const std::string message = refusal_of_table(text, request);
        CAPTURE(message);
        CHECK(message.ends_with(skipping_way));
        request.skip_invalid = true;
        CHECK(read_table(text, request).points == std::vector<Point>{{1, 2}, {3, 5}});
      }
    // A table without points is not mended so.
    CHECK(refusal_of_table("Export\n") == "t:1: found 'Export', expected two numbers");
    CHECK(refusal_of_table("a,b\n1,2\n", {.columns = parse_columns("x,y")}) ==
          "t:1: found 'a,b', expected a header with a column 'x'");
  }

  TEST_CASE("--skip-invalid leaves out titles of any form above the header, and names the columns taken") {
    const std::vector<Point> points = {{3.5, 4.5}, {5.5, 7.5}};
    const std::string two = "3.5,4.5\n5.5,7.5\n", numbered = "1,3.5,4.5\n2,5.5,7.5\n";
    const std::string german = "1;3,5;4,5\n2;5,5;7,5\n", last_two = "x is column 2, '", first_two = "x is column 1";
    struct Table {
      std::string text, columns, left_out;
    };
    const Table tables[] = {
        {"Projekt Wald 2024\nNr;Rechtswert;Hochwert\n" + german, last_two + "Rechtswert', and y is column 3", "1 line"},
        {"Projekt Wald 2024;;\nNr;Rechtswert;Hochwert\n" + german, last_two + "Rechtswert', and y", "1 line"},
        {"Projekt;Wald;Eiche\n\nNr;Rechtswert;Hochwert\n;m;m\n" + german, last_two + "Rechtswert', and", "2 lines"},
        {"Projekt Wald 2024\nNr,X,Y\n" + numbered, last_two + "X', and y is column 3, 'Y'", "1 line"},
        {"Projekt, Wald, Eiche\nNr,X,Y\n" + numbered, last_two + "X', and y is column 3, 'Y'", "1 line"},
        {"Trees of wood\nid,x,y\n" + numbered, last_two + "x', and y is column 3, 'y'", "1 line"},
        {"id,x,y\nTrees of wood\n" + numbered, last_two + "x', and y is column 3, 'y'", "1 line"},
        {"Trees\nid x y\n" + numbered, last_two + "x', and y is column 3, 'y'", "1 line"},
        {"Projekt Wald 2024\nx;y\n3,5;4,5\n5,5;7,5\n", first_two + ", 'x', and y is column 2, 'y'", "1 line"},
        {"Projekt Wald\nx,y\nm,m\n" + two, first_two + ", 'x', and y is column 2, 'y'", "2 lines"},
        {"Projekt Wald\nRechts,Hoch\n" + two, first_two + ", 'Rechts', and y is column 2, 'Hoch'", "1 line"},
        {"Projekt,Wald\nRechts,Hoch\n" + two, first_two + ", 'Rechts', and y is column 2, 'Hoch'", "1 line"},
        {"Projekt Wald\n" + two, "no header was found; x is column 1, and y is column 2", "1 line"},
        {"Wald\nname,x,y,2019,2020\na,3.5,4.5,1,2\nb,5.5,7.5,1,2\n", last_two + "x', and y is column 3", "1 line"}};
    for (const Table& table : tables) {
      CAPTURE(table.text);
      const PointFile file = read_table(table.text, skipping);
      CHECK(file.points == points);
      CHECK(contains(file.warnings.front(), table.columns));
      CHECK(file.warnings.back().starts_with(table.left_out + (table.left_out == "1 line" ? " is" : " are")));
    }
    // Names that are requested count more than known names.
    const std::string named = "Title,of,it\neast,north,x\nx,y,n\n3.5,4.5,1\n5.5,7.5,2\n";
    CHECK(read_table(named, {.columns = parse_columns("east,north"), .skip_invalid = true}).points == points);
    CHECK(read_table(named, {.where = Condition("n == 2", names_of_columns()), .skip_invalid = true}).points ==
          std::vector<Point>{points[1]});
    CHECK(read_table("x,y\n4\n" + two, skipping).warnings.size() == 1);
    const SpacePoints space =
        space_points_in("Trees of the wood\nid,x,y,z\n1,1,2,3\n2,4,5,7\n", "t", Format::text, skipping);
    CHECK(space.points.size() == 2);
    CHECK(space.warnings.front().starts_with("the columns 'x', 'y', 'z' are read"));
  }

  TEST_CASE("a quoted decimal comma between commas is refused with the way out") {
    CHECK(refusal_of_table("id,\"East\",\"North\"\n1,\"3,5\",\"4,5\"\n") ==
          "t:2: found '3,5', expected a number with a decimal point (export the table with semicolons: between commas "
          "no decimal comma is read)");
  }

  TEST_CASE("a decimal comma is distinguished from a separator") {
    const std::vector<Point> points = {{13.4, 52.5}, {7, -0.25}, {1e10, 3}};
    for (const std::string text :
         {"13,4;52,5\n7;-0,25\n1e10;3\n", "x;y\n13,4;52,5\n7;-0,25\n1e10;3\n", "13,4\t52,5\n7\t-0,25\n1e10\t3\n",
          "13,4 52,5\n7 -0,25\n1e10  3\n", "\"13,4\";\"52,5\"\n7;\"-0,25\"\n1e10;3\n"}) {
      CAPTURE(text);
      const PointFile file = read_table(text);
      CHECK(file.points == points);
      CHECK(file.warnings == std::vector<std::string>{"the decimal sign is a comma: 13,4 is read as 13.4"});
    }
    CHECK(read_table("1;2\n3;4\n1,5;2,5\n").points == std::vector<Point>{{1, 2}, {3, 4}, {1.5, 2.5}});
    CHECK(read_table("1,2\n3,4\n").points == std::vector<Point>{{1, 2}, {3, 4}});
    CHECK(read_table("1,2,a;b\n", {}).points == std::vector<Point>{{1, 2}});
    for (const std::string line : {"a,5;2", ",5;2", "1,;2", "1,b;2", "1,2,3;4"}) CHECK(separator_of(line) == ',');
    CHECK(separator_of("1,5;2") == ';');
    CHECK(refusal_of_table("1.5;2\n1,5;2\n") ==
          "t:2: found '1,5', expected a number with a decimal point, as in lines before (one decimal sign in all "
          "lines; " +
              skipping_way);
    CHECK(refusal_of_table("1,5;2\n1.5;2\n") ==
          "t:2: found '1.5', expected a number with a decimal comma, as in line 1 (one decimal sign in all lines; " +
              skipping_way);
  }

  TEST_CASE("every double is read to the last bit, with a comma as with a point") {
    std::mt19937_64 random(8);
    std::vector<Point> points;
    std::string text = "y;name;x\n";
    while (points.size() < 2000) {
      const std::array<std::uint64_t, 2> bits = {random(), random()};
      const Point p{std::bit_cast<double>(bits[0]), std::bit_cast<double>(bits[1])};
      if (!rbpa::is_finite(p)) continue;
      points.push_back(p);
      std::string line = text_of(p.y) + ";a;" + text_of(p.x) + "\n";
      std::replace(line.begin(), line.end(), '.', ',');
      text += line;
    }
    const std::vector<Point> found = read_table(text).points;
    REQUIRE(found.size() == points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      CHECK(std::bit_cast<std::uint64_t>(found[i].x) == std::bit_cast<std::uint64_t>(points[i].x));
      CHECK(std::bit_cast<std::uint64_t>(found[i].y) == std::bit_cast<std::uint64_t>(points[i].y));
    }
  }

  TEST_CASE("lines that are not points are refused, or left out and counted") {
    const std::string& hint = skipping_hint;
    for (const std::string sign : {"NA", "N/A", "null", "", "-", "None", "\\N"}) {
      CAPTURE(sign);
      CHECK(refusal_of_table("x,y\n1,2\n3," + sign + "\n") == "t:3: found '" + sign + "', expected a number" + hint);
    }
    CHECK(refusal_of_table("x,y\n1,2\n3,nan\n") == "t:3: found 'nan', expected a finite number" + hint);
    const PointFile file = read_table("x,y\nNA,NA\n1,2\n3,NA\n5,six\n7\n-inf,8\n9,10\n1e999,0\n", skipping);
    CHECK(file.points == std::vector<Point>{{1, 2}, {9, 10}});
    CHECK(file.warnings ==
          std::vector<std::string>{"6 lines are left out: the first is t:2: found 'NA', expected a number"});
    CHECK(read_table("1,2\n3,NA\n", skipping).warnings ==
          std::vector<std::string>{"1 line is left out: t:2: found 'NA', expected a number"});
    CHECK(read_table("NA,NA\n3,4\n", skipping).points == std::vector<Point>{{3, 4}});  // no header
    CHECK(refusal_of_table("NA,NA\n3,4\n") == "t:1: found 'NA', expected a number" + hint);
    CHECK(refusal_of_table("x,y\nNA,1\n2,NA\n", skipping) ==
          "t: found 2 lines and no point, expected at least one point (t:2: found 'NA', expected a number)");
    CHECK(read_table("x,y\n1,2\n", skipping).warnings.empty());
  }

  TEST_CASE("lines that spreadsheets write before the table are skipped") {
    CHECK(read_table("sep=;\nx;y\n1,5;2\n").points == std::vector<Point>{{1.5, 2}});
    CHECK(read_table("\xEF\xBB\xBFsep=,\r\nlat,lon\r\n1,2\r\n").points == std::vector<Point>{{2, 1}});
    CHECK(read_table("sep=,x\n1,2\n").points == std::vector<Point>{{1, 2}});  // a header
    CHECK(refusal_of_table(std::string("\xFF\xFE"
                                       "1\0,\0",
                                       6)) ==
          "t: found text in UTF-16LE, expected UTF-8 (iconv -f UTF-16LE -t UTF-8 t > FILE makes it)");
  }

  TEST_CASE("--where compares texts that stand in quotes") {
    const auto where = [](const std::string& text) {
      return CloudRequest{.where = Condition(text, names_of_columns())};
    };
    const std::string text =
        "x,y,grp,\"my kind\",n\n0,0,A,\"a, b\",1\n1,0,B,c,2\n2,0,\"A\",,3\n3,0, a ,it's,4\n4,0,6,c,5\n";
    const auto xs = [&](const std::string& condition) {
      CAPTURE(condition);
      std::vector<double> found;
      for (const Point& p : read_table(text, where(condition)).points) found.push_back(p.x);
      return found;
    };
    using Xs = std::vector<double>;
    for (const std::string quote : {"\"", "'"}) {
      const auto quoted = [&](const std::string& word) { return quote + word + quote; };
      CHECK(xs("grp == " + quoted("A")) == Xs{0, 2});
      CHECK(xs("grp=" + quoted("a")) == Xs{3});
      CHECK(xs("GRP != " + quoted("A")) == Xs{1, 3, 4});
      CHECK(xs("\"my kind\" == " + quoted("a, b")) == Xs{0});
      CHECK(xs("\"my kind\" <> " + quoted("c") + " and n < 4") == Xs{0, 2});
      CHECK(xs("\"my kind\" == " + quoted("")) == Xs{2});
      CHECK(xs("grp in (" + quoted("A") + ", " + quoted("B") + ")") == Xs{0, 1, 2});
      CHECK(xs("grp not in (" + quoted("A") + "," + quoted("B") + ") or n == 2") == Xs{1, 3, 4});
      CHECK(xs("not grp == " + quoted("A") + " and (n > 4 or grp == " + quoted("B") + ")") == Xs{1, 4});
      CHECK(xs("grp == " + quoted("6") + " and n != 2") == Xs{4});
    }
    CHECK(xs("\"my kind\" == \"it's\"") == Xs{3});
    // A text compared with a number, and fields that are neither.
    CHECK(refusal_of_table(text, where("grp == 6")) ==
          "t:2: found 'A', expected a number, as --where compares the column with numbers (== \"...\" compares it with "
          "a text; " +
              skipping_way);
    CHECK(contains(refusal_of_table(text, where("kind == 'A'")), "expected a header with a column 'kind'"));
    const auto refused = [](const std::string& condition) -> std::string {
      return rbpa_test::refusal_of<WrongUsage>([&] { const Condition parsed(condition, names_of_columns()); });
    };
    CHECK(refused("grp < 'A'") == "--where: found ''A'', expected a number (a text is compared with == and !=)");
    CHECK(contains(refused("3 == 'A'"), "expected a number or the name of a column"));
    CHECK(refused("grp in ('A', 3)") == "--where: found '3', expected a text in quotes, as the list has texts");
    CHECK(refused("grp in ('A' 'B')") == "--where: found ''B'', expected ',' or ')'");
    CHECK(contains(refused("'A' == grp"), "expected a number or the name of a column"));
    CHECK(contains(refused("grp == 'A"), "expected a number or the name of a column"));
  }

  TEST_CASE("geometries are preferred to coordinates in the same table, with a message") {
    const std::string lines = "lon,lat,name,WKT\n9,9,a,POINT (1 2)\n8,8,b,MULTIPOINT(3 4)\n";
    const PointFile file = read_table(lines);
    CHECK(file.points == std::vector<Point>{{1, 2}, {3, 4}});
    CHECK(file.warnings ==
          std::vector<std::string>{
              "the geometries of column 'WKT' are read, and not 'lon' and 'lat' (--columns chooses these)"});
    CHECK(read_table("geom\tx\ty\nSRID=28992;point(1 2)\t7\t7\n").points == std::vector<Point>{{1, 2}});
    CHECK(read_table(lines, {.columns = std::vector<Column>{{.name = "lon"}, {.name = "lat"}}}).points ==
          std::vector<Point>{{9, 9}, {8, 8}});
    // A geometry as bytes, or wrong ones.
    CHECK(read_table("x,y,geom\n1,2,0101000000000000000000F03F\n3,4,\n").points == std::vector<Point>{{1, 2}, {3, 4}});
    CHECK(read_table("x,y,geom\n1,2,\n").warnings.empty());
  }

  TEST_CASE("a column of geometries is read") {
    const std::vector<Point> points = {{1, 2}, {3, 4}, {5, 6}};
    CHECK(read_table("id,WKT\n7,POINT (1 2)\n8,\"MULTIPOINT (3 4, 5 6)\"\n").points == points);
    CHECK(read_table("WKT\nPOINT (1 2)\nMULTIPOINT ((3 4), (5 6))\n").points == points);
    CHECK(read_table("the_geom;a\nPOINT Z (1 2 9);x\n\"MULTIPOINT (3 4, 5 6)\";y\n").points == points);
    CHECK(read_table("geometry\tid\nPOINT(1 2)\t1\nMULTIPOINT(3 4,5 6)\t1\n").points == points);
    const PointFile srid = read_table("id,geom\n7,SRID=28992;POINT (1 2)\n");
    CHECK(srid.crs->text() == "EPSG:28992");
    CHECK(refusal_of_table("id,geom\n7,SRID=28992;POINT (1 2)\n7,SRID=4326;POINT (1 2)\n") ==
          "t:3: found EPSG:4326, expected EPSG:28992 as in lines before" + skipping_hint);
    const std::string lines = "id,geom\n7,\"LINESTRING (1 2, 3 4)\"\n8,POINT(5 6)\n";
    CHECK(refusal_of_table(lines) ==
          "t:2: found LINESTRING, expected POINT or MULTIPOINT (--vertices takes the vertices of lines and polygons; " +
              skipping_way);
    CHECK(read_table(lines, {.vertices = true}).points == points);
    CHECK(refusal_of_table("id,geom\n7,POINT EMPTY\n") ==
          "t:2: found 'POINT EMPTY', expected a geometry, such as 'POINT (1 2)'");
    CHECK(refusal_of_table("id,geom\n7,POINT (1 x)\n") == "t:2: found 'x', expected a number");
    CHECK(read_table("id,geom\n7,POINT EMPTY\n8,\"MULTIPOINT (1 2, 3\"\n9,POINT (1 2)\n9\n", skipping).points ==
          std::vector<Point>{{1, 2}});
  }

  TEST_CASE("gzip is read for every format and several members, and broken files are refused") {
    const Folder folder;
    std::string text;
    for (int i = 0; i < 200000; ++i) text += std::to_string(i) + " " + std::to_string(i * 7 % 1000) + "\n";
    folder.file("p.xy", text);
    folder.file("q.xy", "0.5 0.5\n");
    REQUIRE(folder.rbpa("mesh p.xy --alpha 2 -o m.off -o m.ply -q").code == 0);
    REQUIRE(
        folder
            .run("/bin/sh",
                 "-c 'gzip -k p.xy m.off m.ply; cat p.xy q.xy > r.xy; gzip -c p.xy > r.xy.gz; gzip -c q.xy >> r.xy.gz'")
            .code == 0);
    for (const std::string name : {"p.xy", "m.off", "m.ply", "r.xy"}) {
      CAPTURE(name);
      CHECK(folder.rbpa("info " + name + ".gz --json").out == folder.rbpa("info " + name + " --json", 0).out);
    }
    CHECK(folder.rbpa("info - < p.xy.gz").out == folder.rbpa("info p.xy").out);
    CHECK(folder.meshtopo("m.off.gz").out == folder.meshtopo("m.off").out);
    const std::string compressed = folder.content("p.xy.gz");
    const auto refuses_bytes = [&](const std::string& bytes, const std::string& message) {
      folder.file("b.xy.gz", bytes);
      refuses(folder, "info b.xy.gz", 3, "b.xy.gz: found " + message);
    };
    for (const std::size_t size : {std::size_t{3}, std::size_t{12}, compressed.size() / 2, compressed.size() - 1})
      refuses_bytes(compressed.substr(0, size),
                    "the end of the file inside compressed data, expected a whole gzip file (copy it again)");
    refuses_bytes(compressed + "junk", "4 bytes after the compressed data, expected the end of the file");
    std::string wrong = compressed;
    wrong[wrong.size() - 6] ^= 1;  // of the check sum
    refuses_bytes(wrong, "damaged gzip data (incorrect data check), expected a whole gzip file (copy it again)");
    // Numbers may look like a gzip file.
    folder.file("n.f64xy", std::string("\x1F\x8B\x08\x00\x00\x00\xF0\x3F\x00\x00\x00\x00\x00\x00\xF0\x3F", 16));
    CHECK(folder.rbpa("info n.f64xy").out.starts_with("points      1\n"));
  }

  TEST_CASE("a coordinate system is reported, or refused") {
    const Folder folder("p.xy", corner);
    for (const std::string name :
         {"EPSG:28992", "epsg:28992", "urn:ogc:def:crs:EPSG::28992", "http://www.opengis.net/def/crs/EPSG/0/28992"})
      CHECK(contains(folder.rbpa("info p.xy --crs " + name).out, "crs         EPSG:28992\n"));
    CHECK(contains(folder.rbpa("info p.xy --crs OGC:CRS84").err, "coordinates are degrees"));
    for (const std::string name : {"28992", "EPSG:", "EPSG:abc", ":1", "''"}) {
      CAPTURE(name);
      CHECK(folder.rbpa("info p.xy --crs " + name, 2).err.starts_with("rbpa: --crs: found "));
    }
  }

  TEST_CASE("a format that is not read is refused with the program that converts it") {
    const Folder folder;
    CHECK(contains(folder.rbpa("info p.e57").err, "(pdal translate p.e57 points.las)"));
    const std::string of_gpx =
        rbpa::app::has_gdal() ? "p.gpx: " : "(this build has no GDAL: ogr2ogr -f GeoJSON points.geojson p.gpx)";
    CHECK(contains(folder.rbpa("info p.gpx").err, of_gpx));
    CHECK(!contains(folder.rbpa("info p.foo").err, "("));
  }

  TEST_CASE("--where selects lines by columns that the header names") {
    const auto where = [](const std::string& condition, bool skip = false) {
      return CloudRequest{.where = Condition(condition, names_of_columns()), .skip_invalid = skip};
    };
    const std::string text =
        "class;x;y;z;Point Class;\xC3\xA9tage\n"
        "6;0;0;1;2;0\n2;1;0;2;2;1\n6;2;0;3,5;3;0\n6;3;0;4;3;1\n";
    const auto xs = [&](const std::string& condition) {
      std::vector<double> found;
      for (const Point& p : read_table(text, where(condition)).points) found.push_back(p.x);
      return found;
    };
    using Xs = std::vector<double>;
    CHECK(xs("class==6 and z>3") == Xs{2, 3});
    CHECK(xs("CLASS != 6") == Xs{1});
    CHECK(xs("\"point class\" == 3 and not \xC3\xA9tage") == Xs{2});
    CHECK(xs("class > 2 and Class < 7 and CLASS in (6)") == Xs{0, 2, 3});  // one column under three names
    CHECK(xs("x < 1 or x > 2") == Xs{0, 3});
    CHECK(xs("z == 3.5") == Xs{2});
    CHECK(xs("1 == 1") == Xs{0, 1, 2, 3});
    CHECK(xs("class == 7").empty());
    CHECK(read_table(text, where("class==6 and z>3")).warnings.back() == "--where selects 2 of 4 lines");
    CHECK(read_table("id,wkt\n1,POINT(1 2)\n2,POINT(3 4)\n", where("id > 1")).points == std::vector<Point>{{3, 4}});

    // Coordinates of a line that is not selected are not read; the fields of the condition are.
    const std::string holes = "x,y,n\n1,2,5\nNA,2,4\n3,4,NA\n5,6\n";
    CHECK(read_table("x,y,n\n1,2,5\nNA,2,4\n", where("n == 5")).points == std::vector<Point>{{1, 2}});
    CHECK(refusal_of_table(holes, where("n == 4")).starts_with("t:3: found 'NA', expected a number"));
    CHECK(refusal_of_table(holes, where("n == 5")) ==
          "t:4: found 'NA', expected a number, as --where compares the column with numbers (== \"...\" compares it "
          "with a text; " +
              skipping_way);
    const PointFile skipped = read_table(holes, where("n == 5", true));
    CHECK(skipped.points == std::vector<Point>{{1, 2}});
    CHECK(skipped.warnings.size() == 2);
    CHECK(skipped.warnings[0] == "--where selects 1 of 2 lines");
    CHECK(skipped.warnings[1].starts_with("2 lines are left out: the first is t:4: found 'NA'"));
    CHECK(read_table(holes, where("n == 7", true)).points.empty());
    CHECK(refusal_of_table("x,y\n1,2\n", where("z > 3")) == "t:1: found 'x,y', expected a header with a column 'z'");
    CHECK(refusal_of_table("1,2\n", where("z > 3")) ==
          "t: found no header line, expected one with the names that --where requires");

    const auto refused = [](const std::string& condition) -> std::string {
      return rbpa_test::refusal_of<WrongUsage>([&] { const Condition parsed(condition, names_of_columns()); });
    };
    const std::string name =
        ", expected a number or the name of a column (in double quotes unless it is a word other than and, or, not, "
        "in)";
    CHECK(refused("class == ") == "--where: found the end" + name);
    CHECK(refused("class == and") == "--where: found 'and'" + name);
    CHECK(refused("\"point class == 3") == "--where: found '\"point class == 3'" + name);
    CHECK(refused("\"\" == 3") == "--where: found '\"\"'" + name);
    CHECK(refused("\"") == "--where: found '\"'" + name);
    CHECK(refused("== 3") == "--where: found '=='" + name);
    CHECK(refused("point class") == "--where: found 'class', expected 'and', 'or' or the end");

    const Folder folder("p.csv", "x,y,class\n0,0,6\n1,0,6\n0,1,6\n9,9,2\n");
    const Outcome outcome = folder.rbpa("mesh p.csv --where 'class==6' --alpha inf -o m.off");
    CHECK(outcome.err ==
          "rbpa: p.csv: --where selects 3 of 4 lines\nrbpa: 3 points, 1 triangle, 0 isolated -> m.off\n");
    CHECK(folder.rbpa("info p.csv --where 'class=='").code == 2);
    CHECK(folder.rbpa("info p.csv --where 'z>3'").code == 3);
  }
}
