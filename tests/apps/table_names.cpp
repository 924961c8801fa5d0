// Tables as people have them: which columns are read as coordinates, by their names, and warnings about them.
#include <doctest/doctest.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/cloud/read_points.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "io/number.h"
#include "io/text/fields.h"
#include "support/program.h"
#include "support/read_table.h"

using namespace apps_test;
using rbpa::Point;
using namespace rbpa::app;

namespace {

const std::vector<Point> three = {{13.4, 52.5}, {7.1, 50.7}, {-3, 40}};

}  // namespace

TEST_SUITE("names of columns") {
  TEST_CASE("columns are found by their names, in any order and among any others") {
    struct Names {
      std::string x, y;
      bool degrees;
    };
    const Names names[] = {{"lon", "lat", true},
                           {"Longitude", "Latitude", true},
                           {"LNG", "LAT", true},
                           {"long", "lat", true},
                           {"decimalLongitude", "decimalLatitude", true},
                           {"x", "y", false},
                           {"X", "Y", false},
                           {"x_coord", "y_coord", false},
                           {"POINT_X", "POINT_Y", false},
                           {"Easting", "Northing", false},
                           {"E", "N", false},
                           {"x [m]", "y [m]", false},
                           {"Longitude (deg)", "Latitude (deg)", true},
                           {"L\xC3\xA4nge", "Breite", true},
                           {"L\xE4nge", "Breite", true},  // in Latin-1
                           {"La\xCC\x88nge", "BREITE", true},
                           {"LAENGE", "Breite", true},
                           {"L\xC3\x84NGENGRAD", "Breitengrad", true},
                           {"Laengengrad [deg]", "Breitengrad [deg]", true},
                           {"longitud", "latitud", true},
                           {"longitudine", "latitudine", true},
                           {"lengtegraad", "breedtegraad", true},
                           {"l\xC3\xA6ngdegrad", "breddegrad", true},
                           {"D\xC5\x82ugo\xC5\x9B\xC4\x87", "Szeroko\xC5\x9B\xC4\x87", true},
                           {"abscisse",
                            "ordonn\xC3\xA9"
                            "e",
                            false},
                           {"Coordonn\xC3\xA9"
                            "e X",
                            "Coordonn\xC3\xA9"
                            "e Y",
                            false},
                           {"Ost", "Nord", false},
                           {"este", "norte", false}};
    for (const Names& name : names)
      for (const char separator : {',', ';', '\t'})
        for (const std::string order : {"xy", "yx", "ixy", "iyx", "xiy", "yix", "iixyi", "iiyxi"}) {
          CAPTURE(name.x);
          CAPTURE(order);
          std::string text;
          const auto add_line = [&](const std::string& x, const std::string& y, const std::string& other) {
            std::string before;
            for (const char column : order) {
              text += before + (column == 'x' ? x : column == 'y' ? y : other);
              before = separator;
            }
            text += '\n';
          };
          add_line(name.x, name.y, "name");
          add_line("13.4", "52.5", "Berlin");
          add_line("7.1", "\"50.7\"", "Bonn");
          add_line("-3", "40", "\"17\"");
          const PointFile file = read_table(text);
          CHECK(file.points == three);
          CHECK(file.degrees == name.degrees);
          const bool said = order != "xy";
          CHECK(file.warnings.size() == (said ? 1 : 0));
        }
  }

  TEST_CASE("columns taken by name are reported") {
    CHECK(read_table("lat,lon\n1,2\n").warnings ==
          std::vector<std::string>{
              "x is column 2, 'lon', and y is column 1, 'lat', as the header says (--columns chooses others)"});
    const PointFile transposed =
        read_table("lat,lon\n1,2\n", {.columns = std::vector<Column>{{.name = "lat"}, {.name = "lon"}}});
    CHECK(transposed.points == std::vector<Point>{{1, 2}});
    CHECK(transposed.warnings ==
          std::vector<std::string>{"x is the latitude 'lat' and y the longitude 'lon', as --columns requires"});
    CHECK_FALSE(transposed.degrees);
  }

  TEST_CASE("a header without a known name gives a warning, in the plane and in space, for any number of columns") {
    struct Header {
      std::string names;
      bool in_space;
      std::string columns, way;  ///< of the warning; none without columns
      std::string why = "no name of a column is that";
    };
    const std::string x = "x is column 1, ", y = "y is column 2, ";
    for (const Header& header : std::initializer_list<Header>{
             {"a,b", false, x + "'a', and " + y + "'b'", "--columns 2,1 exchanges them"},
             {"lat,b", false, x + "'lat', and " + y + "'b'", "--columns 2,1 exchanges them"},
             {"x,y", false, "", ""},
             {"x,b", false, x + "'x', and " + y + "'b'", "--columns 2,1 exchanges them", "'b' is no name"},
             {"lon,elev", false, x + "'lon', and " + y + "'elev'", "--columns 2,1 exchanges them", "'elev' is no name"},
             {"a,North", false, x + "'a', and " + y + "'North'", "--columns 2,1 exchanges them", "'a' is no name"},
             {"a,b,c", true, x + "'a', " + y + "'b', and z is column 3, 'c'", "--columns chooses another order"},
             {"a,b,H\xC3\xB6he", true, x + "'a', " + y + "'b', and z is column 3, 'H\xC3\xB6he'",
              "--columns chooses another order", "'a' and 'b' are no names"},
             {"x,y,c", true, x + "'x', " + y + "'y', and z is column 3, 'c'", "--columns chooses another order",
              "'c' is no name"}}) {
      CAPTURE(header.names);
      const bool three = header.names.find(',') != header.names.rfind(',');
      const std::string text = header.names + (three ? "\n1,2,3\n4,5,7\n" : "\n1,2\n4,5\n");
      const std::vector<std::string> warnings =
          header.in_space ? space_points_in(text, "t", Format::text, {}).warnings : read_table(text).warnings;
      if (header.columns.empty()) {
        CHECK(warnings.empty());
      } else {
        CHECK(warnings ==
              std::vector<std::string>{header.why + " of a coordinate; " + header.columns + " (" + header.way + ")"});
      }
      const std::vector<Column> chosen = {{.number = 1}, {.number = 2}};
      CHECK(read_table(text, {.columns = chosen}).warnings.empty());
    }
    const PointFile titled = read_table("title\nlon,y\n1.5,2.5\n2.5,3.5\n", {.skip_invalid = true});
    REQUIRE_FALSE(titled.warnings.empty());
    CHECK(titled.warnings.front() == "x is column 1, 'lon', and y is column 2, 'y' (--columns 2,1 exchanges them)");
  }

  TEST_CASE("a first column that numbers the lines of a table without a header gives a warning") {
    const std::string lines = "1,345.1,678.2\n2,345.9,678.4\n3,346.2,677.9\n";
    const std::vector<std::string> numbered = {
        "x is column 1, which numbers the lines (--columns 2,3 takes the columns after it)"};
    std::string grid;
    for (const char* const y : {"0", "1"})
      for (int i = 0; i < 100; ++i) grid += std::to_string(i) + " " + y + " 5.5\n";
    struct Table {
      std::string text;
      bool is_numbered;
    };
    for (const Table& table :
         std::initializer_list<Table>{{lines, true},
                                      {"# points\n\n" + lines, true},
                                      {"0 5 7\n1 6 7\n2 7 7\n3 7 9\n", true},
                                      {"17;1,5;2\n18;2,5;3\n19;1,5;4\n", true},
                                      {"1,345.1,678.2\n2,345.9,678.4\n", false},  // too few to tell
                                      {"1,345.1,678.2\n2,345.9,678.4\n2,1,2\n", false},
                                      {"1,5,678.2\n2,5,678.4\n3,5,6\n", false},  // a row of a grid
                                      {"1,5,a\n2,6,b\n3,7,c\n", false},          // no third number
                                      {"1,5\n2,6\n3,7\n", false},
                                      {grid, false},
                                      {"x,y,z\n" + lines, false}}) {
      CAPTURE(table.text);
      const std::vector<std::string> warnings = read_table(table.text).warnings;
      CHECK((std::find(warnings.begin(), warnings.end(), numbered.front()) != warnings.end()) == table.is_numbered);
      CHECK(read_table(lines, {.columns = parse_columns("2,3")}).warnings.empty());
    }
    CHECK(read_table(lines).points.front() == Point{1, 345.1});
    CHECK(space_points_in(lines, "t", Format::text, {}).warnings.empty());
    const Folder folder({{"n.csv", lines}, {"n.xyz", lines}});
    CHECK(folder.rbpa("info n.csv").err == "rbpa: n.csv: " + numbered.front() + "\n");
    CHECK(folder.rbpa("info - < n.csv").err == "rbpa: standard input: " + numbered.front() + "\n");
    CHECK(!contains(folder.rbpa("info n.xyz").err, "numbers the lines"));
  }

  TEST_CASE("of several pairs of names a clear one is taken, and the other is said with its columns") {
    struct Header {
      std::string names, taken, others;
      Point first;
    };
    for (const Header& header : std::initializer_list<Header>{
             {"E,N,x,y", "x is column 3, 'x', and y is column 4, 'y'", "'E' and 'N' (--columns 1,2", {3, 4}},
             {"E,n,lon,lat", "x is column 3, 'lon', and y is column 4, 'lat'", "'E' and 'n' (--columns 1,2", {3, 4}},
             {"N,E,lat,lon", "x is column 4, 'lon', and y is column 3, 'lat'", "'E' and 'N' (--columns 2,1", {4, 3}},
             {"E,N,stop_lon,stop_lat", "x is column 3, 'stop_lon', and y is", "'E' and 'N' (--columns 1,2", {3, 4}},
             {"X,Y,Latitude,Longitude",
              "x is column 1, 'X', and y",
              "'Longitude' and 'Latitude' (--columns 4,3",
              {1, 2}},
             {"x,y,x,y", "x is column 1, 'x', and y is column 2, 'y'", "'x' and 'y' (--columns 3,4", {1, 2}},
             {"Lat,Lon,Lat,Lon", "x is column 2, 'Lon', and y is", "'Lon' and 'Lat' (--columns 4,3", {2, 1}},
             {"L\u00E4nge,Breite,X,Y",
              "x is column 3, 'X', and y",
              "'L\u00E4nge' and 'Breite' (--columns 1,2",
              {3, 4}}})
      for (const char separator : {',', ';', '\t'}) {
        std::string text = header.names + "\n1,2,3,4\n";
        std::replace(text.begin(), text.end(), ',', separator);
        CAPTURE(text);
        const PointFile file = read_table(text);
        CHECK(file.points == std::vector<Point>{header.first});
        CHECK(file.warnings.front().starts_with(header.taken));
        CHECK(file.warnings.front().ends_with(", as the header says, and not " + header.others + " chooses these)"));
      }
    const SpacePoints space = space_points_in("x,y,z,lon,lat\n1,2,3,4,5\n", "t", Format::text, {});
    CHECK(space.warnings.front().ends_with("and not 'lon' and 'lat' (--columns chooses these)"));
    for (const std::string& names : {std::string("N,S,E,W"), std::string("west,south,east,north")})
      CHECK(contains(refusal_of_table(names + "\n4,3,13,12\n5,4,14,13\n"), "the sides of boxes"));
  }

  TEST_CASE("names are known by an ending that two of them have, and in further languages") {
    for (const std::string& names : {std::string("INTPTLAT;INTPTLONG"), std::string("ptlatitude;ptlongitude"),
                                     std::string("Pohjoinen;It\u00E4"), std::string("p\u00F3\u0142noc;wsch\u00F3d")})
      CHECK(read_table("GEOID;" + names + "\n1;47.5;-122.5\n2;48.5;-122.5\n").points ==
            std::vector<Point>{{-122.5, 47.5}, {-122.5, 48.5}});
    for (const std::string& names : {std::string("errlat;errlon"), std::string("flat;colon")})
      CHECK(contains(refusal_of_table("GEOID;" + names + "\n1;47.5;-122.5\n"), "expected known names"));
  }

  TEST_CASE("the leftmost of several clear pairs of names is taken, and without one the first columns") {
    CHECK(read_table("x,y,lon,lat\n1,2,3,4\n").points == std::vector<Point>{{1, 2}});
    CHECK(read_table("lat,lon,x,y\n1,2,3,4\n").points == std::vector<Point>{{2, 1}});
    CHECK(read_table("id,x,y,lon,lat\n0,1,2,3,4\n").points == std::vector<Point>{{1, 2}});
    CHECK(read_table("x,y,WKT\n1,2,POINT (3 4)\n").points == std::vector<Point>{{3, 4}});
    CHECK(read_table("lat,lon\n1,2\n", {.columns = parse_columns("1,2")}).points == std::vector<Point>{{1, 2}});
  }

  TEST_CASE("longitudes and latitudes give warnings about degrees and the antimeridian, with the option to use") {
    const Folder folder("fiji.csv", "lat,lon\n-18,179\n-17,-179.5\n-16.5,178.25\n-17,-180\n");
    const std::string columns =
        "rbpa: fiji.csv: x is column 2, 'lon', and y is column 1, 'lat', as the header says (--columns chooses "
        "others)\n";
    const std::string degrees =
        "rbpa: fiji.csv: coordinates are degrees, and so are radii, lengths and areas; a degree of longitude is as "
        "long as 0.95 to 0.96 degrees of latitude there; project them first";
    const Outcome far = folder.rbpa("info fiji.csv");
    CHECK(far.err == columns + degrees +
                         "\nrbpa: fiji.csv: points lie on both sides of the antimeridian, longitude 180, and are far "
                         "apart in the plane (--shift-longitude adds 360 to longitudes below 0)\n");
    CHECK(contains(far.out, "box         x -180 .. 179\n"));
    const Outcome near = folder.rbpa("info fiji.csv --shift-longitude");
    CHECK(near.err == columns + degrees + ", to UTM zone 60S (EPSG:32760), for example\n");
    CHECK(contains(near.out, "box         x 178.25 .. 180.5\n"));
    CHECK(folder.rbpa("info fiji.csv -q").err.empty());
    // Around the world, but not around the antimeridian.
    folder.file("atlantic.csv", "lon,lat\n-170,0\n-60,0\n60,1\n170,3\n");
    CHECK(!contains(folder.rbpa("info atlantic.csv").err, "antimeridian"));
    folder.file("exchanged.csv", "lon,lat\n52,113\n50,107\n");
    CHECK(folder.rbpa("info exchanged.csv").err ==
          "rbpa: exchanged.csv: expected longitudes and latitudes, found numbers up to 52 and 113: are they exchanged? "
          "(in a table --columns takes them in the other order)\n");
    folder.file("metres.csv", "lon,lat\n500000,5800000\n");
    CHECK(contains(folder.rbpa("info metres.csv").err, "are they degrees?"));
    refuses(folder, "info metres.csv --shift-longitude", 3,
            "metres.csv: found x = '5e+05', expected a longitude of -180 to 360 (leave out --shift-longitude if x is "
            "not in degrees)");
  }
}
