// Tables whose numbers may not be the coordinates that they seem to be: read rightly, refused, or read with a warning.
#include <doctest/doctest.h>

#include <initializer_list>
#include <string>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/cloud/read_points.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "io/number.h"
#include "io/text/columns.h"
#include "io/text/fields.h"
#include "io/text/odd_fields.h"
#include "support/read_table.h"

using namespace apps_test;
using rbpa::Point;
using namespace rbpa::app;

namespace {

using Points = std::vector<Point>;
const Points corners = {{0, 0}, {4, 0}, {0, 3}};
const CloudRequest skipping{.skip_invalid = true};

}  // namespace

TEST_SUITE("table doubts") {
  TEST_CASE("a first column of numbers of points gives a warning, with any number of columns") {
    const std::string way = "(--columns 2,3 takes the columns after it)";
    for (const std::string more : {"", ",12.5", ",12.5,TREE", ",oak,,7"})
      for (const std::initializer_list<const char*> ids : {std::initializer_list<const char*>{"101", "102", "103"},
                                                           {"3", "7", "90"},
                                                           {"90", "7", "3"},
                                                           {"1700000000", "1700000037", "1700000071"}}) {
        std::string text;
        for (const char* const id : ids)
          text += id + std::string(",") + std::string(id).back() + "12.25,567.5" + more + "\n";
        CAPTURE(text);
        CHECK(warnings_with(text, way).size() == 1);
      }
    CHECK(read_table("1,1.5,7.2\n2,,7.3\n5,1.9,NA\n", skipping).warnings.size() == 2);
    CHECK(read_table("1,1.5,7.2\n2,,7.3\n3,1.9,7.1\n", skipping).warnings.size() == 2);
    for (const std::string text :
         {"0,1.5,7.2\n0,1.7,7.3\n10,1.9,7.4\n", "1.0,11.5,48.1\n2.0,11.6,48.2\n3.0,11.7,48.1\n",
          "1;11,5;48,1\n1;11,6;48,2\n0;11,7;48,1\n", "0.1 12.5 3.2\n0.2 12.7 3.9\n0.3 12.9 3.1\n",
          "1606608000.75,12.5,3.2\n1606608001.25,12.7,3.9\n1606608007.75,12.9,3.1\n"})
      CHECK(warnings_with(text, way).size() == 1);
    for (const std::string text : {"1.5,1.5,7.2\n2,1.7,7.3\n3,1.9,7.4\n", "0.1,5.5,7.2\n0.2,5.5,7.3\n0.3,5.5,7.4\n",
                                   "10,1,2\n20,2,7\n30,5,2\n", "id,x,y\n1,1.5,2.5\n2,3.5,4.5\n3,5.5,6.5\n"})
      CHECK(warnings_with(text, way).empty());
    const std::string second = "12.5,1,3.2\n12.7,2,3.9\n11.9,3,4.1\n";
    CHECK(warnings_with(second, "y is column 2, which numbers the lines (--columns 1,3 leaves it out)").size() == 1);
    CHECK(read_table(second, {.columns = parse_columns("1,3")}).warnings.empty());
  }

  TEST_CASE("numbers in the order of latitude and longitude give a warning without a header") {
    const std::string way = "are they exchanged? (--columns 2,1 takes them in the other order)";
    for (const std::string text :
         {"47.6,-122.3\n47.7,-122.4\n", "35.6 139.7\n35.7 139.6\n", "47.6;-122.3\n48.1;11.5\n-33.9;151.2\n"})
      CHECK(warnings_with(text, way).size() == 1);
    for (const std::string text : {"-122.3,47.6\n-122.4,47.7\n", "5,3\n60,120\n", "100,-122\n5,6\n", "5,200\n6,190\n",
                                   "x,y\n47.6,-122.3\n47.7,-122.4\n", "11.5,48.1\n11.6,48.2\n"})
      CHECK(warnings_with(text, way).empty());
  }

  TEST_CASE("a word of a name is enough if one pair of columns has it") {
    for (const auto& [x, y] : std::initializer_list<std::pair<std::string, std::string>>{
             {"lon_wgs84", "lat_wgs84"},
             {"LONG_DD", "LAT_DD"},
             {"X_WGS84", "Y_WGS84"},
             {"x_25832", "y_25832"},
             {"E_ETRS89", "N_ETRS89"},
             {"RD_X", "RD_Y"},
             {"RW", "HW"},
             {"GK_Rechts", "GK_Hoch"},
             {"Rechts", "Hoch"},
             {"stopLon", "stopLat"},
             {"location-long", "location-lat"},
             {"pickup_longitude", "pickup_latitude"},
             {"center_x", "center_y"},
             {"LONGITUDE_X", "LATITUDE_Y"},
             {"E-Koordinate", "N-Koordinate"},
             {"Ostkoordinate", "Nordkoordinate"},
             {"Geogr. L\u00E4nge", "Geogr. Breite"},
             {"coordonn\u00E9es X", "coordonn\u00E9es Y"},
             {"\u0414\u043E\u043B\u0433\u043E\u0442\u0430", "\u0428\u0438\u0440\u043E\u0442\u0430"},
             {"\u7ECF\u5EA6", "\u7EAC\u5EA6"},
             {"\u7D4C\u5EA6", "\u7DEF\u5EA6"},
             {"\u039C\u03AE\u03BA\u03BF\u03C2", "\u03A0\u03BB\u03AC\u03C4\u03BF\u03C2"}}) {
      const auto& shown_x = x;
      CAPTURE(shown_x);
      CHECK(read_table("id;" + y + ";" + x + ";val\n1;0;0;7\n2;0;4;7\n3;3;0;7\n").points == corners);
    }
    CHECK(read_table("id,lat_wgs84,lon_wgs84\n1,0,0\n").degrees);
    CHECK(read_table("lat_error,lon_error,lat_dd,lon_dd\n9,9,0,0\n9,9,0,4\n9,9,3,0\n").points == corners);
  }

  TEST_CASE("a header without known names above three numbers is refused, and names likely columns") {
    struct Header {
      std::string text, likely;
    };
    for (const Header& header :
         std::initializer_list<Header>{{"id,a,b\n1,0.5,0.5\n", "a,b"},
                                       {"id,name,value,a,b\n1,n,0,0.5,0.5\n", "a,b"},
                                       {"a,b,c\n1,2,3\n", "a,b"},
                                       {"start_lat,start_lng,end_lat,end_lng\n1,2,3,4\n", "start_lng,start_lat"},
                                       {"time,latitudeE7,longitudeE7\n1,2,3\n", "longitudeE7,latitudeE7"},
                                       {"id,lat,x\n1,48,11\n2,49,12\n", "x,lat"},
                                       {"pt,c1,c2\n1,48.5,11\n2,49,12\n", "c1,c2"},
                                       {"pt,c1,c2\n1,48,11\n2,48,11\n", "c1,c2"},
                                       {"id;px (m);py (m)\n1;0.5;0.5\n", "2,3"},
                                       {"id;L\xE4ngs;Quer\n1;0.5;0.5\n", "2,3"}}) {
      const std::string line = header.text.substr(0, header.text.find('\n'));
      is_refused_whole(header.text, "t:1: found " + in_quotes(line) +
                                        ", expected known names of coordinates, such as x and y (--columns " +
                                        header.likely + " chooses columns)");
      CHECK(read_table(header.text, {.columns = parse_columns(header.likely)}).points.size() > 0);
    }
    CHECK(read_table("name,a,b,2019\noak,0,0,1\noak,4,0,1\noak,0,3,1\n", {.columns = parse_columns("2,3")}).points ==
          corners);
  }

  TEST_CASE("angles are read to the nearest double, by their letters, signs and minutes") {
    struct Written {
      std::string text;
      double degrees;
      char hemisphere = '\0';
    };
    for (const Written& angle :
         std::initializer_list<Written>{{"52.5 N", 52.5, 'N'},
                                        {"52.5S", -52.5, 'S'},
                                        {"W 13.25", -13.25, 'W'},
                                        {"13,25E", 13.25, 'E'},
                                        {"52.5\u00B0", 52.5},
                                        {"-52\u00B030'", -52.5},
                                        {"52\u00B034'03.07\"N", 189243.07 / 3600, 'N'},
                                        {"52\u00B0 34\u2032 3.07\u2033 S", -189243.07 / 3600, 'S'},
                                        {"52 34 03.07", 189243.07 / 3600},
                                        {"-0 30 0", -0.5},
                                        {"52:00:12.5", 187212.5 / 3600},
                                        {"52 30.125", 3150.125 / 60},
                                        {"52\u02DA34'03.07\"N", 189243.07 / 3600, 'N'},
                                        {"52 deg 34' 3.07\" S", -189243.07 / 3600, 'S'},
                                        {"52d34'03.07\"N", 189243.07 / 3600, 'N'},
                                        {"52d34m03.07s", 189243.07 / 3600},
                                        {"52-34-03.07W", -189243.07 / 3600, 'W'},
                                        {"52.5n", 52.5, 'N'},
                                        {"52.5s", -52.5, 'S'}}) {
      CAPTURE(angle.text);
      const std::optional<Angle> read = parse_angle(angle.text);
      REQUIRE(read);
      CHECK(read->degrees == doctest::Approx(angle.degrees).epsilon(1e-15));
      CHECK(read->hemisphere == angle.hemisphere);
    }
    for (const std::string text : {"",       "N",          "-",    "52.5",      "52 60 1", "52.5 30",    "1 234",
                                   "5'678",  "52 34 03 1", "N52E", "--5\u00B0", "52 34x",  "2024-05-01", "1e5N",
                                   "52 100", "5m",         "5s3",  "e2",        "n 5",     "52m34d",     "12-5"})
      CHECK_FALSE(parse_angle(text));
    const std::string table = "id;lat;lon\n1;52\u00B034'03.07\"N;13\u00B030'E\n2;52:30;13 15\n3;52.5;13.25 W\n";
    CHECK(refusal_of_table(table) == "");
    CHECK(read_table(table).points[1] == Point{13.25, 52.5});
    CHECK(read_table(table).points[2] == Point{-13.25, 52.5});
    CHECK(read_table("13.5E 52.5N\n13E 52N\n").degrees);
    CHECK(refusal_of_table("52.5N 13.5E\n") ==
          "t:1: found '52.5N' as x, expected a longitude (--columns chooses the order of columns)");
    // Times, and minutes of no angle.
    CHECK(refusal_of_table("a,b\n12:30,1\n") == "t:2: found '12:30', expected decimal degrees, 12.5");
    CHECK(refusal_of_table("x;y\n1 30;1\n").starts_with("t:2: found '1 30', expected decimal degrees"));
  }

  TEST_CASE("signs and minutes in other columns, or in names, are refused") {
    is_refused_whole("id,Latitude,Longitude (W)\n1,52.5,13.25\n",
                     "t:1: found the name 'Longitude (W)' above positive numbers");
    is_refused_whole("lat [\u00B0S];lon\n52.5;13.25\n", "t:1: found the name 'lat [\u00B0S]' above positive numbers");
    is_refused_whole("id;Lat N;Long W\n1;52.5;13.25\n", "t:1: found the name 'Long W' above positive numbers");
    is_refused_whole("lat,NS,lon,EW\n5,N,1,E\n5,N,1,W\n", "t:1: found column 4 with 'W' for '1'");
    is_refused_whole("lat_deg,lat_min,lon_deg,lon_min\n52,30,13,15\n",
                     "t:1: found the column 'lat_min' beside whole degrees");
    is_refused_whole("latdeg,latmin,londeg,lonmin\n48,6.1,11,30.7\n",
                     "t:1: found the column 'latmin' beside whole degrees");
    is_refused_whole("lat_d,lat_m,lon_d,lon_m\n48,6.1,11,30.7\n",
                     "t:1: found the column 'lat_m' of minutes or seconds");
    CHECK(read_table("lat [m],lon [m]\n52.5,13.25\n").points == Points{{13.25, 52.5}});
    // Letters and ddmm.mmm without a header that names the columns.
    for (const std::string s : {",", ";", " "}) {
      const std::string west = "47.6" + s + "N" + s + "122.3" + s + "W\n",
                        rmc = "A" + s + "4807.038" + s + "N" + s + "01131.000" + s + "E\n";
      const auto refusal = [](const std::string& text, const std::string& columns) {
        return refusal_of_table(text, {.columns = parse_columns(columns)});
      };
      CHECK(contains(refusal_of_table(west), "letter of a hemisphere"));
      CHECK(!contains(refusal_of_table(west), "--columns"));
      CHECK(refusal(west, "3,1").starts_with("t:1: found column 4 with 'W' for '122.3'"));
      CHECK(refusal("a" + s + "b" + s + "c" + s + "d\n" + west, "3,1").starts_with("t:1: found column 4 with 'W'"));
      CHECK(contains(refusal(rmc, "4,2"), "degrees and minutes in one number"));
      CHECK(refusal("47.6" + s + "N" + s + "122.3" + s + "E\n", "3,1") == "");
      CHECK(refusal("5334123.5" + s + "N" + s + "691234.5" + s + "E\n", "3,1") == "");  // metres
    }
    CHECK(read_table("lat,lon (W)\n52.5,-13.25\n").points == Points{{-13.25, 52.5}});
    CHECK(read_table("lat,NS,lon,EW\n5,N,1,E\n").points == Points{{1, 5}});
    CHECK(read_table("lon,lat,name\n1,5,south\n").points == Points{{1, 5}});  // the name of a part of the town
    CHECK(read_table("lat,lon,minutes\n52.5,13.25,7\n").points == Points{{13.25, 52.5}});
    CHECK(contains(refusal_of_table("lat,ns,lon,ew\n5200.5,N,01300.5,E\n", {.columns = parse_columns("2,3")}),
                   "hemisphere"));
  }

  TEST_CASE("how a number is written is named, with the way to mend it") {
    struct Field {
      std::string text, expected;
    };
    const std::string plain = " (export the table with cells in a plain format)";
    for (const Field& field :
         std::initializer_list<Field>{{"48\u00B006'60.0\"N", "minutes and seconds below 60"},
                                      {"1\xA0"
                                       "234",
                                       "a number in UTF-8 (iconv -f CP1252 -t UTF-8)"},
                                      {"48\xB0"
                                       "06'N",
                                       "a number in UTF-8 (iconv -f CP1252 -t UTF-8)"},
                                      {"48.1,11.5", "one number in each column (split this column into two)"},
                                      {"Lat: 48.1", "a number without other characters, 48.1" + plain},
                                      {"y=48.1", "a number without other characters, 48.1" + plain},
                                      {"691234.5m", "a number without other characters, 691234.5" + plain},
                                      {"122.3-", "a number with its sign before it, -122.3" + plain}})
      for (const std::string header : {"id;x;y\n", ""}) {
        const std::string text = header + "7;1;" + field.text + "\n", at = header.empty() ? "t:1" : "t:2";
        CHECK(refusal_of_table(text, {.columns = parse_columns("2,3")}) ==
              at + ": found " + in_quotes(field.text) + ", expected " + field.expected);
      }
  }

  TEST_CASE("columns of zones and of different units give warnings") {
    const std::string zones = "Zone,X,Y\n32,1,2\n32,3,4\n33,5,1\n", doubt = "are there points of two systems?";
    CHECK(warnings_with(zones, "the column 'Zone' has 32 and 33: " + doubt + " (--where 'Zone == 32' selects one)")
              .size() == 1);
    CHECK(warnings_with("utm_zone,X,Y\n32U,1,2\n33U,3,4\n", "--where 'utm_zone == \"32U\"' selects one").size() == 1);
    for (const std::string text :
         {"Zone,X,Y\n32,1,2\n32,3,4\n", "Zone,X,Y\ncore,1,2\nrim,3,4\n", "Ozone,X,Y\n32,1,2\n33,3,4\n"})
      CHECK(warnings_with(text, doubt).empty());
    const CloudRequest one{.where = Condition("zone == 32", names_of_columns())};
    for (const std::string& warning : read_table(zones, one).warnings) CHECK(!contains(warning, doubt));
    const std::string units = "have different units";
    CHECK(warnings_with("X [ft],Y [m]\n1,2\n", units).size() == 1);
    CHECK(warnings_with("x_km,y_m\n1,2\n", units).size() == 1);
    for (const std::string text :
         {"X [m],Y [m]\n1,2\n", "X (ft),Y (feet)\n1,2\n", "lon [deg],lat [m]\n1,2\n", "x,y [m]\n1,2\n"})
      CHECK(warnings_with(text, units).empty());
  }

  TEST_CASE("'|' separates, and several points in a line are refused") {
    CHECK(read_table("id|x|y|name\n1|0|0|a, b\n2|4|0|c; d\n3|0|3|e\n").points == corners);
    CHECK(read_table("0|0\n4|0\n0|3\n").points == corners);
    CHECK(
        read_table("| id | x | y |\n|----|---|---|\n| 1 | 0 | 0 |\n| 2 | 4 | 0 |\n| 3 | 0 | 3 |\n", skipping).points ==
        corners);
    is_refused_whole("13.2,52.5,0 13.3,52.5,0 13.4,52.6,0\n",
                     "t:1: found '13.2,52.5,0 13.3,52.5,0 13.4,52.6,0', several points");
    is_refused_whole("13.2,52.5 13.3,52.5\n13.2,52.5 13.3,52.5\n", "t:1: found '13.2,52.5 13.3,52.5', several points");
  }

  TEST_CASE("numbers that may have signs between thousands, or decimal commas between commas, give warnings") {
    CHECK(warnings_with("x;y\n9;5\n1.011;8\n1.300;1.025\n", "is it 10").size() == 2);
    CHECK(warnings_with("x;y\n9;5\n1.011;8\n1.300;1.025\n", "as in 1.011").size() == 1);
    for (const std::string text :
         {"x;y\n950;900\n1.011;998\n1.300;1.025\n", "x;y\n923;463,1\n1,049;463,9\n", "923 463.1\n1.049 463.9\n"})
      CHECK(contains(refusal_of_table(text, skipping), "with three digits after each sign"));
    for (const std::string text :
         {"x;y\n950;900\n1.01;998\n1.300;1.02\n", "x;y\n1.011;998.5\n1.3;1.025\n", "x;y\n0.125;0\n0.250;1\n0;0\n",
          "x;y\n1.125;2.250\n3.125;4.375\n", "x;y\n5000;1\n1.125;2\n"})
      CHECK(warnings_with(text, "thousands").empty());
    for (const std::string text :
         {"13,28,52,56\n13,36,52,51\n13,21,52,52\n13,07,52,40\n", "691234,56,5334123,41\n691235,56,5334123,41\n",
          "1,5, 2,5\n2,5, 7,5\n", "7, 1,5, 2,5\n8, 2,5, 7,5\n",
          "1,13,28,52,56\n2,13,36,52,51\n3,13,21,52,52\n4,13,99,52,40\n"}) {
      is_refused_whole(text, "t:1: found '" + text.substr(0, text.find('\n')) + "', whose commas may be decimal signs");
      CHECK(read_table(text, {.columns = parse_columns("1,2")}).points.size() > 1);
    }
    CHECK_THROWS_AS(space_points_in("13,5,52,7,9,05\n", "t", Format::text, {}), BadInput);
    CHECK(space_points_in("13,5,52,0,0,1\n", "t", Format::text, {}).points.size() == 1);
    CHECK(read_table("1, 5, 2, 5\n2, 5, 7, 5\n").warnings.empty());
    CHECK(read_table("1,2,30,40\n5,6,30,41\n7,8,30,41\n").points.size() == 3);
  }

  TEST_CASE("text around a number, in a field or as a field, is named") {
    const std::string plain = " (export the table with cells in a plain format)";
    for (const std::string field : {"'10.5'", "'10.5", "=\"10.5\"", "10.5 m", "10.5%", "(10.5", "[10.5", "10.5 # p0"})
      CHECK(refusal_of_table("x;y\n" + field + ";1\n") ==
            "t:2: found '" + field + "', expected a number without other characters, 10.5" + plain);
    for (const std::string field : {"P0", "10.5metres", "2024-05-01", "a", "33UUU12"})
      CHECK(refusal_of_table("x;y\n" + field + ";1\n") == "t:2: found '" + field + "', expected a number");
    for (const std::string field : {"\"(52.5, 13.2)\"", "52.5, 13.2"})
      CHECK(contains(refusal_of_table("id;place\n1;" + field + "\n"), "expected one number in each column"));
    CHECK(read_table("id;x;y\n1;\u00A00;0\u00A0\n2;4 \u00A0;0\n3;0;3\n").points == corners);
    const std::string way = "(in well-known text: ST_AsText() of PostGIS, -lco GEOMETRY=AS_WKT of ogr2ogr)";
    CHECK(refusal_of_table("id,geom\n1,0101000020E6100000000000000000F03F000000000000F03F\n").ends_with(way));
    CHECK(refusal_of_table("id;geometry\n1;{\"type\":\"Point\",\"coordinates\":[1,2]}\n").ends_with(way));
  }

  TEST_CASE("fields that a separator, or quotes around the line, make too many or too few are named") {
    CHECK(refusal_of_table("x,y\n3,5,4,5\n") ==
          "t:2: found 4 columns ('3,5,4,5'), expected 2 as in line 1 (with semicolons if these commas are decimal "
          "signs)");
    CHECK(refusal_of_table("id,x,y\n\"1,2,3\"\n") ==
          "t:2: found 1 column ('\"1,2,3\"'), expected 3 as in line 1 (without the quotes around the whole line)");
    CHECK(refusal_of_table("\"id,x,y\"\n\"1,2,3\"\n").ends_with("(without the quotes around the whole line)"));
    CHECK(refusal_of_table("id;geom\n1;SRID=4326;POINT(1 2)\n").ends_with("(with quotes around SRID=...;POINT ...)"));
    CHECK(refusal_of_table("1,2\n", {.columns = parse_columns("2")}) ==
          "t:1: found '2', expected a geometry, such as 'POINT (1 2)' (--columns X,Y takes two columns)");
    CHECK(refusal_of_table("id;wkt\n1;POINT(11.5,48.1)\n") == "t:2: found ',48.1)', expected a number after a blank");
    CHECK(refusal_of_table("x,y\n1,2,a\n") == "t:2: found 3 columns ('1,2,a'), expected 2 as in line 1");
  }

  TEST_CASE("points that stand for missing numbers, and points that are all one, give warnings") {
    const auto warnings = [](const std::string& text, const std::string& part) {
      std::size_t count = 0;
      for (const std::string& warning : points_in(text, "t.xy", {}).warnings) count += contains(warning, part);
      return count;
    };
    const std::string far = "far from all others", town = "3512 5678\n3513 5679\n3514 5671\n";
    for (const std::string odd : {"0 0\n", "-9999 -9999\n", "-9999 -9999\n-9999 -9999\n", "99999 99999\n"})
      CHECK(warnings(town + odd, far) == 1);
    for (const std::string& text : {town, town + "-9999 0\n", std::string("0 0\n1 2\n2 1\n5 7\n"),
                                    std::string("0 0\n3 3\n"), std::string("0 0\n8 2\n2 8\n3 3\n")})
      CHECK(warnings(text, far) == 0);
    CHECK(warnings("3,51E+06;5,68E+06\n3,51E+06;5,68E+06\n3,51E+06;5,68E+06\n",
                   "all 3 points are (3510000, 5680000): were") == 1);
    CHECK(warnings("0 0\n0 0\n0 0\n", "all 3 points are (0, 0): were") == 1);
    CHECK(warnings("1 2\n1 2\n", "were digits lost") == 0);
  }
}
