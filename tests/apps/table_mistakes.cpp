// Tables with mistakes of those who wrote them: stray quotes, names that lack, exchanged axes, mixed decimal signs.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/cloud/read_points.h"
#include "io/crs.h"
#include "io/text/columns.h"
#include "support/program.h"
#include "support/read_table.h"

using namespace apps_test;
using rbpa::Point;
using namespace rbpa::app;

namespace {

const std::vector<Point> corners = {{0, 0}, {4, 0}, {0, 3}};
const CloudRequest skipping{.skip_invalid = true};

}  // namespace

TEST_SUITE("table mistakes") {
  TEST_CASE("a quoted text that spans lines of data is open, other texts of several lines are read") {
    struct Table {
      std::string text;
      std::size_t open, row;  ///< numbers of the line with the quote, and of the first line in it
      std::size_t kept;       ///< number of points without the line with the quote
    };
    for (const Table& table :
         {Table{"id,name,x,y\n1,a,0,0\n2,\"b,4,0\n3,c,0,3\n4,pipe 5\",1,1\n", 3, 4, 3},
          Table{"id\tx\ty\tnote\n1\t0\t0\t\"dead, see 1\n2\t4\t0\toak\n3\t0\t3\tgirth 5\"\n4\t1\t1\toak\n", 2, 3, 3},
          Table{"id,x,y,note\n1,0,0,oak\n2,4,0,\"\n3,0,3,\"\n4,1,1,a\n5,2,2,b\n", 3, 4, 3},
          Table{"id,name,x,y\n2,\"b,4,0\n3,pipe 5\",0,3\n4,c,1,1\n", 2, 3, 2}}) {
      CAPTURE(table.text);
      CHECK(refusal_of_table(table.text)
                .starts_with("t:" + std::to_string(table.open) +
                             ": found a text in quotes with lines of data, the first of them " +
                             std::to_string(table.row) + ", expected a closing quote before them"));
      CHECK(read_table(table.text, skipping).points.size() == table.kept);
    }
    for (const std::string text :
         {"name,x,y\n\"a\nb\",0,0\n\"c\n\nd, 1\",4,0\ne,0,3\n", "x,y,note\n0,0,\"a 1\n2, b\"\n4,0,\"5\n6\"\n0,3,\n",
          "x,a,y,b\n0,\"p\nq\",0,\"r\ns\"\n4,\"\n1,1\n\",0,t\n0,u,3,v\n"})
      CHECK(read_table(text).points == corners);
  }

  TEST_CASE("lines of separators above a header are passed over, and a file of blank lines is refused") {
    for (const std::string s : {",", ";", "|", "\t"})
      for (const std::string& before : {s + s + s + "\n", s + " " + s + s + "\n\n" + s + s + s + "\n"})
        CHECK(read_table(before + s + "id" + s + "lon" + s + "lat\n" + s + "1" + s + "0" + s + "0\n" + s + "2" + s +
                         "4" + s + "0\n" + s + "3" + s + "0" + s + "3\n")
                  .points == corners);
    for (const std::string text : {"\n", " \n\n \t\n", ";;;\n,,\n"})
      CHECK(refusal_of_table(text) == "t: found blank lines only, expected points");
  }

  TEST_CASE("of names that differ in the letter case, the pair of one case is taken") {
    for (const std::string header : {"X,x,y,sp", "x,X,Y,sp", "\"X\",\"x\",\"y\",\"sp\"", "Lon,lon,lat,n"})
      CHECK(read_table(header + "\n1,0,0,a\n2,4,0,b\n3,0,3,c\n").points == corners);
    CHECK(read_table("x,y,X\n0,0,1\n4,0,2\n0,3,3\n").points == corners);
    CHECK(read_table("x,Y\n0,0\n4,0\n0,3\n").points == corners);
  }

  TEST_CASE("a header with one name fewer than there are columns is refused, unless it may be R's") {
    const std::string way = ", expected a name for each column (add that of the column without a name";
    for (const std::string header : {"id,lon,lat", "Nr,x,y"})
      CHECK(refusal_of_table(header + "\n1,13.3,52.4,34.1\n2,13.4,52.4,35.0\n")
                .starts_with("t:1: found '" + header + "', 3 names above lines of 4 columns" + way));
    CHECK(refusal_of_table("x,y\n388281.4,5820515.9,34.1\n388300.0,5820600.0,34.2\n")
              .starts_with("t:1: found 'x,y', 2 names above lines of 3 columns" + way));
    CHECK(read_table("id,x,y\n\"1\",7,0,0\n\"2\",8,4,0\n\"3\",9,0,3\n").points == corners);
    CHECK(read_table("id x y\n1 oak 0 0\n2 elm 4 0\n3 ash 0 3\n").points == corners);
    CHECK(read_table("x y id\n1 0 0 7\n2 4 0 8\n3 0 3 9\n").points == corners);
  }

  TEST_CASE("identifiers far below whole coordinates, and northings as x, give warnings") {
    const std::string ids = "x is column 1, whole numbers that all differ", order = "are they exchanged? (--columns ";
    CHECK(warnings_with("4711,388281,5820516\n1203,388300,5820600\n8871,388400,5820500\n", ids).size() == 1);
    for (const std::string text : {"47,88,516\n12,83,600\n88,84,500\n", "7,388,516\n7,383,600\n8,384,500\n"})
      CHECK(warnings_with(text, ids).empty());
    CHECK(warnings_with("P;Y;X\n1;388281,5;5820515,9\n2;388300,0;5820600,0\n", order + "2,3 takes").size() == 1);
    CHECK(warnings_with("5820515 388281\n5820600 388300\n", order + "2,1 takes").size() == 1);
    const std::string pnezd = "100,5820516.2,388281.1,34.1\n101,5820600.1,388300.5,34.2\n";
    CHECK(read_table(pnezd, {.columns = parse_columns("2,3")}).warnings.size() == 1);
    CHECK(read_table(pnezd, {.columns = parse_columns("3,2")}).warnings.empty());
    for (const std::string text : {"388281 5820515\n388300 5820600\n", "Easting,Northing\n2100000,700000\n",
                                   "2600000 1200000\n2600100 1200100\n", "x,y\n5820515,388281\n7,388300\n"})
      CHECK(warnings_with(text, order).empty());
  }

  TEST_CASE("points before three digits are refused beside decimal commas") {
    is_refused_whole("Nr;x;y;h\n1;1.005;5.006;34,5\n2;1.198;5.143;34,6\n",
                     "t:1: found column 2 with three digits after each point, beside decimal commas in column 4");
    for (const std::string text : {"Nr;lon;lat;h\n1;11.005;48.006;34,5\n", "Nr;x;y;h\n1;1.005;5.006;34.5\n",
                                   "Nr;x;y;h\n1;1.05;5.006;34,5\n2;1.19;5.14;34,6\n"})
      CHECK(refusal_of_table(text) == "");
  }

  TEST_CASE("messages on odd fields and lines name the way out") {
    struct Row {
      std::string text, found;
    };
    for (const Row& row : std::initializer_list<Row>{
             {"Nr;Breite;L\u00E4nge\n1;52\u00B024'00\"N;13\u00B018'00\"O\n",
              "E or W in place of O, which is Ost in German"},
             {"% made by hand\n% x y\n0 0\n4 0\n", "comments begin with #"},
             {"id^lon^lat\n1^13.30^52.40\n", "expected two numbers (between , ; | tabs or blanks)"},
             {"Name,Position\nW1,N52 25.358 E13 21.886\n", "split the column of latitudes and longitudes into two"},
             {"Name;Position\nW1;52\u00B025'N 13\u00B021'E\n", "split the column of latitudes and longitudes into two"},
             {"id;lon;lat\n1;13.30;52.40\n2;13,35;52,48\n", "as in lines before (one decimal sign in all lines"},
             {"id;lon;lat\n1;13,30;52,40\n2;13.35;52.48\n", "as in line 2 (one decimal sign in all lines"},
             {"id;lon;lat\n1;(122.40);37.2\n", "a number with its sign before it, -122.40"}}) {
      const std::string refusal = refusal_of_table(row.text);
      CAPTURE(refusal);
      CHECK(contains(refusal, row.found));
    }
    CHECK(read_table("% made by hand\n0 0\n4 0\n0 3\n", skipping).points == corners);
    const std::string units = refusal_of_table("time,lat,lon\nUTC,north,east\n7,0,0\n8,0,4\n");
    CHECK(units.find("--skip-invalid") == units.rfind("--skip-invalid"));
    for (const char* const json : {"[{\"id\":1,\"lon\":13.3}]\n", "[\n  {\"id\": 1}\n]\n"})
      CHECK_THROWS_WITH(points_in(json, "t.txt", {}),
                        "t.txt: found JSON, expected a table (jq -r '.[] | [.lon, .lat] | @csv' makes one of records)");
  }

  TEST_CASE("a projected system of longitudes and latitudes, and names of groups in Latin-1, give warnings") {
    const auto count = [](const std::vector<std::string>& warnings, const std::string& part) {
      return std::count_if(warnings.begin(), warnings.end(),
                           [&](const std::string& warning) { return contains(warning, part); });
    };
    const std::string contradicts = "a projected system, contradicts";
    CHECK(count(points_in("lon,lat\n13.3,52.4\n", "t.csv", {.crs = parse_crs("EPSG:25833")}).warnings, contradicts) ==
          1);
    CHECK(count(points_in("lon,lat\n13.3,52.4\n", "t.csv", {.crs = parse_crs("EPSG:4326")}).warnings, contradicts) ==
          0);
    CHECK(count(points_in("x,y\n13.3,52.4\n", "t.csv", {.crs = parse_crs("EPSG:25833")}).warnings, contradicts) == 0);
    const Folder folder({{"l.csv", "art,x,y\nM\xFCller,1,1\nM\xFCller,2,1\nM\xFCller,1,2\n"},
                         {"u.csv", "art,x,y\nM\u00FCller,1,1\nM\u00FCller,2,1\nM\u00FCller,1,2\n"}});
    for (const std::string name : {"l", "u"})
      CHECK(!contains(folder.rbpa("shape " + name + ".csv --group-by art --alpha inf -o " + name + ".geojson").err,
                      "UTF-8"));
    CHECK(contains(folder.content("u.geojson"), "\"M\u00FCller\""));
    CHECK(folder.content("l.geojson") == folder.content("u.geojson"));
  }
}
