// Lines of tables that are no points, or seem to be none: comments, headers of other forms, totals, other tables.
#include <doctest/doctest.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/cloud/read_points.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "io/text/columns.h"
#include "io/text/fields.h"
#include "support/program.h"
#include "support/read_table.h"

using namespace apps_test;
using rbpa::Point;
using namespace rbpa::app;

namespace {

using Points = std::vector<Point>;
using Texts = std::vector<std::string>;
const Points corners = {{0, 0}, {4, 0}, {0, 3}};
const CloudRequest skipping{.skip_invalid = true};

}  // namespace

TEST_SUITE("odd lines of tables") {
  TEST_CASE("comments with the numbers of a point are reported, other comments are not") {
    const std::string way = " (quotes around its first field make it a point)";
    for (const std::string mark : {"#", "# ", "//"})
      for (const std::string s : {",", ";", "\t", " "}) {
        const auto line = [&](const std::string& id, const std::string& x, const std::string& y) {
          std::string text = id;
          return text.append(s).append(x).append(s).append(y).append("\n");
        };
        const std::string table = line("tree", "x", "y") + line("1", "0", "0") + line("2", "4", "0");
        const std::string comment = line(mark + "3", "9", "9"), last = line("4", "0", "3");
        CAPTURE(table + comment);
        const PointFile file = read_table(table + comment + last);
        CHECK(file.points == corners);
        CHECK(file.warnings.back() == "1 line is a comment with numbers for a point, t:4, " +
                                          in_quotes(trimmed(comment.substr(0, comment.size() - 1))) + way);
        CHECK(read_table(table + comment + comment + last).warnings.back().starts_with("2 lines are comments with"));
        for (const std::string& other :
             Texts{" end", " 9", "3" + s + "9", "3" + s + "a" + s + "b", "1" + s + "2" + s + "3" + s + "4"})
          CHECK(read_table(table + mark + other + "\n" + last).warnings.size() == 1);
      }
    CHECK(read_table("0 0\n#9 9\n4 0\n0 3\n").warnings.empty());  // a point of two numbers, made a comment
    CHECK(read_table("id,x,y\n\"#1\",0,0\n\"#2\",4,0\n\"//\",0,3\n").points == corners);
    CHECK(refusal_of_table("#1,0,0\n#2,4,0\n") ==
          "t: found 2 comments and no point, expected points (quotes around the first field of a line make it one)");
    CHECK(refusal_of_table("id,x,y\n#1,0,0\n") ==
          "t:1: found 'id,x,y' and no line after it but comments, expected lines of points after a header (quotes "
          "around the first field of a line make it one)");
    CHECK(refusal_of_table("id,x,y\n#a\n") ==
          "t:1: found 'id,x,y' and no line after it but comments, expected lines of points after a header");
    CHECK(read_table("# no point\n# 3 of nothing\n").points.empty());
  }

  TEST_CASE("errors of spreadsheets are no comments") {
    for (const std::string error : {"#NV", "#N/A", "#REF!", "#BEZUG!", "#WERT!", "#VALUE!", "#DIV/0!", "#NAME?"}) {
      const std::string text = "x;y\n0;0\n" + error + ";1\n4;0\n0;3\n";
      CHECK(refusal_of_table(text) == "t:3: found '" + error + "', expected a number" + skipping_hint);
      CHECK(read_table(text, skipping).points == corners);
    }
    CHECK(read_table("x y\n#NAMES of all\n#REFERENCE\n0 0\n4 0\n0 3\n").points == corners);
  }

  TEST_CASE("lines of separators only are blank") {
    CHECK(read_table("id,x,y\n,,\n1,0,0\n2,4,0\n , ,\n3,0,3\n,\n").points == corners);
    CHECK(refusal_of_table("id,x,y\n1,0,0\n2,,\n").starts_with("t:3: found ''"));
  }

  TEST_CASE("a first line that numbers the columns is no point") {
    const Points points = {{1.5, 2.5}, {3.5, 4.5}, {5.5, 1.5}};
    for (const std::string s : {",", ";", "\t", "|"})
      for (const CloudRequest& request : {CloudRequest{}, skipping, CloudRequest{.columns = parse_columns("2,3")}}) {
        std::string text = ",0,1\n0,1.5,2.5\n1,3.5,4.5\n2,5.5,1.5\n";
        std::replace(text.begin(), text.end(), ',', s.front());
        CAPTURE(text);
        const PointFile file = read_table(text, request);
        CHECK(file.points == points);
        if (!request.columns)
          CHECK(file.warnings ==
                Texts{"the first line numbers the columns; x is column 2, y is column 3 (--columns chooses others)"});
      }
    CHECK(read_table("    0    1\n0  1.5  2.5\n1  3.5  4.5\n2  5.5  1.5\n").points == points);  // pandas' to_string()
    const SpacePoints space = space_points_in(",0,1,2\n0,1.5,2.5,3.5\n1,3.5,4.5,5.5\n2,1,2,3\n", "t", Format::text, {});
    CHECK(space.points.size() == 3);
    CHECK(space.points[1].z == 5.5);
    // Without the empty name it may be a point.
    const std::string doubt = "may be a header that numbers the columns (then delete it)";
    for (const std::string text :
         {"0,1\n1.5,2.5\n3.5,4.5\n", "1 2 3\n1.5 2.5 7\n3.5 4.5 8\n", "1;2\n1,5;2,5\n3,5;4,5\n"})
      CHECK(warnings_with(text, doubt).size() == 1);
    for (const std::string text : {"0,1\n1.5,2.5\n3,4.5\n", "0,1\n1,0\n2,5\n", "0,2\n1.5,2.5\n3.5,4.5\n"})
      CHECK(warnings_with(text, doubt).empty());
    CHECK(space_points_in("0 1 2\n1.5 2.5 7.5\n3.5 4.5 8.5\n", "t", Format::text, {}).warnings.size() == 1);
  }

  TEST_CASE("--skip-invalid reads no line by a header that is not its own, and is offered where points remain") {
    is_refused_whole("id,x,y\n1,0,0\nid,y,x\n2,0,4\n",
                     "t:3: found 'id,y,x', the header of another table, expected lines of");
    is_refused_whole("id;x;y\n1;0;0\n\nkind;count;sum\n1;12;5\n", "t:4: found 'kind;count;sum', the header of another");
    is_refused_whole("lat,lon\n1,2\nlon,lat\n3,4\n", "t:3: found 'lon,lat', the header of another table");
    CHECK(read_table("id,x,y\n1,0,0\nid,x,y\n2,4,0\n3,0,3\n", skipping).points == corners);
    CHECK(read_table("x,y\n0,0\nout of range,broken\n4,0\n\nNA,b\n0,3\n", skipping).points == corners);
    CHECK(read_table("x y z\n0 0 1\nERR ERR ERR\n4 0 1\nout of range\n0 3 1\n", skipping).points.size() == 3);
    for (const std::string text : {"x,y\n3,5,4,5\n6,5,7,5\n", "x,y\n1,2,3\n4,5,6\n"})
      CHECK(refusal_of_table(text, skipping)
                .starts_with("t:1: found 'x,y', a header above lines with other numbers of fields"));
    for (const std::string text : {"P1,1,2\nP2,3,4\n", "id;x;y\n1;a;b\n2;c;d\n", "id,wkt\n1,POINT EMPTY\n"}) {
      CHECK(!contains(refusal_of_table(text), "--skip-invalid"));
      CHECK(refusal_of_table(text) != "");
    }
    CHECK(refusal_of_table("id;x;y\n1;a;b\n2;3;4\n").ends_with(skipping_way));
  }

  TEST_CASE("a table of R, whose header lacks the name of the first column, is read") {
    for (const std::string s : {" ", ",", ";"})
      CHECK(read_table("\"x\"" + s + "\"y\"\n\"1\"" + s + "0" + s + "0\n\"2\"" + s + "4" + s + "0\n\"b\"" + s + "0" +
                       s + "3\n")
                .points == corners);
    for (const CloudRequest& request : {CloudRequest{}, skipping}) {  // write.table(quote = FALSE)
      CHECK(read_table("x y\n1 0 0\n2 4 0\n3 0 3\n", request).points == corners);
      CHECK(read_table("x\ty\noak\t0\t0\nelm\t4\t0\nash\t0\t3\n", request).points == corners);
    }
    for (const std::string text : {"x y\n1 0 0\n2 4 0\n3 0\n", "x y\n5 0 0\n6 4 0\n", "x y\n1.5 0 0\n2.5 4 0\n",
                                   "x,y\n1,5,4\n2,5,3\n", "x y\n1 0 0\nb 4 0\n"})
      CHECK(contains(refusal_of_table(text), "3 columns"));
  }

  TEST_CASE("lines may lack the last fields below a header, if another line has them") {
    for (const std::string s : {",", ";", "\t"}) {
      const auto line = [&](std::initializer_list<const char*> fields) {
        std::string text;
        for (const char* const field : fields) text += (text.empty() ? "" : s) + field;
        return text + "\n";
      };
      const std::string header = line({"id", "x", "y", "note"}), whole = line({"1", "0", "0", "ok"}),
                        two = line({"2", "4", "0"});
      const PointFile file = read_table(header + whole + two + two + line({"4", "0", "3"}));
      CHECK(file.points == Points{{0, 0}, {4, 0}, {4, 0}, {0, 3}});
      CHECK(file.warnings.back() ==
            "line 3 has 3 fields and line 1 4: fields that are not read may be missing at the end");
      CHECK(refusal_of_table(header + whole + line({"2", "4"})).starts_with("t:3: found 2 columns"));
      CHECK(refusal_of_table(header + two).starts_with("t:2: found 3 columns"));  // which is missing?
      CHECK(refusal_of_table(whole + two).starts_with("t:2: found 3 columns"));   // no header
    }
    CHECK(
        refusal_of_table("id x y note\n1 0 0 ok\n2 4 0\n").starts_with("t:3: found 3 columns"));  // blanks shift fields
  }

  TEST_CASE("lines of another width are left out, also after the first of them") {
    const std::string table = "id,x,y\n1,0,0\n2,4,0\n3,0,3\n";
    const PointFile file = read_table(table + "4,7,8,9\n5,8,20,9\n6,8,30,9\n", skipping);
    CHECK(file.points == corners);
    CHECK(file.warnings.back().starts_with("3 lines are left out"));
    is_refused_whole(table + "id,code,x,y\n1,7,20.5,3.1\n", "t:5: found 'id,code,x,y', the header of another table");
    is_refused_whole(table + "lon,lat\n20.5,3.1\n", "t:5: found 'lon,lat', the header of another table");
    CHECK(read_table("0 0\n4 0\n1 2 3\n1 2 3\n0 3\n1 2 3\n", skipping).points == corners);
  }

  TEST_CASE("a byte-order mark before any line of joined files is no part of it") {
    for (const std::string text : {"0,0\n\xEF\xBB\xBF"
                                   "4,0\n0,3\n",
                                   "x,y\n0,0\n\xEF\xBB\xBF"
                                   "4,0\n0,3\n",
                                   "0 0\n\xEF\xBB\xBF# b\n4 0\n\xEF\xBB\xBF"
                                   "0 3\n"})
      CHECK(read_table(text).points == corners);
    CHECK(read_table("x,y\n0,0\n4,0\n\xEF\xBB\xBFx,y\n0,3\n", skipping).points == corners);
  }

  TEST_CASE("a last line with a total gives a warning") {
    for (const std::string word : {"Sum", "Total", "\"Summe\"", "Mean", "total:"}) {
      CHECK(warnings_with("id,x,y\n1,0,0\n2,4,0\n" + word + ",4,0\n\n", "a total of others").size() == 1);
      CHECK(warnings_with("x;y;name\n0;0;a\n" + std::string("4;0;") + word, "a total of others").size() == 1);
    }
    for (const std::string word :
         {"Grand Total", "Gesamtergebnis", "TOTAL:", "Min", "Max", "Anzahl", "std", "Centroid", ""})
      for (const std::string s : {",", ";", "\t"}) {
        const std::string text =
            "name" + s + "x" + s + "y\na" + s + "0" + s + "0\nb" + s + "4" + s + "0\n" + word + s + "4" + s + "7\n";
        CAPTURE(text);
        CHECK(warnings_with(text, "a total of others (then delete it)").size() == 1);
        const CloudRequest selected{.where = Condition("name == 'a' or name == 'b'", names_of_columns())};
        CHECK(read_table(text, selected).warnings.size() == 2);  // x is column 2, and 2 of 3 lines
      }
    CHECK(warnings_with("id,x,y\nSum,0,0\nMeanwhile,4,0\n", "a total of others").empty());
    for (const std::string last : {"Max Mustermann,3,0\n", "center line,3,0\n", ",3,0\n"})
      CHECK(warnings_with("id,x,y\n1,0,0\n2,4,0\n" + last, "a total of others").empty());
    CHECK(refusal_of_table("id,x,y\n1,0,0\nTotal,,66\n").starts_with("t:3: found ''"));
  }

  TEST_CASE("what is no table is named") {
    struct File {
      std::string bytes, found;
    };
    for (const File& file :
         std::initializer_list<File>{{std::string("PK\x03\x04\x14\0", 6), "a workbook, or another zip file"},
                                     {"\xD0\xCF\x11\xE0 1 2\n", "a workbook of Excel"},
                                     {"\n<!DOCTYPE html>\n<p>404\n", "a web page"},
                                     {"<HTML>\n1 2\n", "a web page"},
                                     {"<?xml version=\"1.0\"?>\n<kml>\n", "XML"},
                                     {"<kml>\n1 2\n", "KML"},
                                     {"ncols 3\nnrows 3\nxllcorner 0\n1 2 3\n", "a grid of ESRI"},
                                     {"NCOLS\t3\r\nNROWS\t3\r\n", "a grid of ESRI"},
                                     {"{\"type\": 1}\n", "JSON"}})
      for (const CloudRequest& request : {CloudRequest{}, skipping})
        CHECK(refusal_of_table(file.bytes, request).starts_with("t: found " + file.found + ", expected "));
    const Folder folder;
    for (const std::string ending : {"xlsx", "xls", "ods", "dbf"})
      CHECK(folder.rbpa("info p." + ending)
                .err.ends_with(" (save the sheet as CSV, or ogr2ogr -f CSV points.csv p." + ending + ")\n"));
    CHECK(refusal_of_table("id;L\xE4ngs;Quer\n1;2;3\n", {.columns = parse_columns("L\u00E4ngs,Quer")}).empty());
  }
}
