// Text files that people reported: each is read as meant, or refused with the place.
#include <doctest/doctest.h>

#include <string>

#include "support/program.h"

using namespace apps_test;

namespace {

const std::string data = RBPA_TEST_DATA "/findings/";

void says(const Outcome& outcome, const std::string& text) {
  CAPTURE(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(contains((outcome.out + outcome.err), text));
}

}  // namespace

TEST_SUITE("reported texts") {
  TEST_CASE("a byte-order mark changes neither points nor format") {
    const Folder folder;
    const std::string lost = data + "case_bom_loses_first_point/", refused = data + "case_bom_refused/";
    says(folder.rbpa("solid " + lost + "bom.pdb --alpha inf -o out.npy"), "rbpa: 8 points");
    says(folder.meshtopo(lost + "bom.obj --json"), "\"vertices\": 5");
    says(folder.rbpa("fill " + lost + "square.poly --size 1 --size-at " + lost + "bom.size -o out.off"),
         "50 triangles");
    says(folder.meshtopo(refused + "crlf_bom.off --json"), "\"vertices\": 8");
    says(folder.meshtopo(refused + "bom.ply --json"), "\"vertices\": 4");
    for (const std::string name : {"bom", "nobom"})
      REQUIRE(folder.rbpa("shape " + refused + name + ".wkt --alpha inf -o " + name + ".wkt").code == 0);
    CHECK(folder.content("bom.wkt") == folder.content("nobom.wkt"));
  }

  TEST_CASE("CR ends a line") {
    const Folder folder;
    const std::string cr = data + "case_cr_line_ends/";
    says(folder.rbpa("info " + cr + "cr_only.csv"), "points      5");
    says(folder.rbpa("info " + cr + "cr.xy"), "points      3");
    says(folder.rbpa("solid " + cr + "cr.obj --alpha inf -o out.npy"), "rbpa: 4 points");
    says(folder.rbpa("solid " + cr + "cr.pdb --alpha inf -o out.npy"), "rbpa: 8 points");
  }

  TEST_CASE("CSV is read by RFC 4180, and as spreadsheets and ogr2ogr write it") {
    const Folder folder;
    const std::string doubled = data + "case_csv_doubled_quotes/", broken = data + "case_csv_line_break_in_quotes/",
                      comma = data + "case_comma_in_text_of_first_line/", ogr = data + "gis_ogr_csv/";
    says(folder.rbpa("info " + doubled + "bom_quoted.csv"), "points      5");
    says(folder.rbpa("info " + doubled + "inch.csv"), "points      3");
    says(folder.rbpa("shape " + doubled + "group.csv --group-by g --alpha inf -o out.geojson"), "3 points, 1 group");
    CHECK(contains(folder.content("out.geojson"), "\"group\":\"6\\\" pipe\""));
    says(folder.rbpa("info " + broken + "newline_in_quotes.csv"), "points      5");
    says(folder.rbpa("shape " + broken + "phantom.csv --alpha inf -o - --output-format wkt"),
         "MULTIPOLYGON (((4.88 52.37, 4.9 52.37, 4.9 52.38, 4.88 52.37)))");
    for (const std::string name : {"quoted.csv", "sep_hint.csv", "tabs.tsv"})
      for (const std::string options : {"", " --columns lon,lat --skip-invalid"})
        says(folder.rbpa("shape " + comma + name + options + " --alpha inf -o out.wkt"), "area 0.0001");
    for (const std::string options : {"", " --columns position"})
      says(folder.rbpa("shape " + data + "case_csv_wkt_column/point_column.csv --alpha inf -o out.wkt" + options),
           "area 0.0002");
    for (const std::string name : {"bothtrail.csv", "linetrail.csv", "sp.xy"})
      says(folder.rbpa("info " + ogr + name), "points      3");
    says(folder.rbpa("info " + ogr + "xy.csv"), "points      ");
  }

  TEST_CASE("the first text is recognized as a number, a name or a count") {
    const Folder folder;
    const std::string first = data + "case_first_line_lost_as_header/",
                      skipped = data + "case_skip_invalid_first_line/", cloud = data + "case_cloudcompare_header/";
    says(folder.rbpa("info " + first + "fortran.xy"), "points      4");
    const Outcome typo =
        folder.rbpa("fill " + first + "square.poly --size 1 --size-at " + first + "typo.size -o out.off", 3);
    CHECK(typo.err.ends_with("typo.size:1: found 'O', expected a number\n"));
    says(folder.rbpa("solid " + skipped + "hc.csv --alpha inf --skip-invalid -o out.npy"), "1 line is left out");
    says(folder.rbpa("solid " + skipped + "hc.csv --alpha inf -o out.npy"), "rbpa: 4 points");
    REQUIRE(folder.run("/bin/cp", cloud + "pcv.pts pcv.txt").code == 0);
    for (const std::string& arguments :
         {cloud + "pcv.pts", cloud + "named.txt", cloud + "named.txt --columns 1,2,3 --skip-invalid",
          std::string("pcv.txt"), std::string("pcv.txt --columns 1,2,3,12,13,14 --skip-invalid")})
      says(folder.rbpa("surface " + arguments + " --radius 0.3 -o out.ply"), "400 points");
  }

  TEST_CASE(".xyz of chemistry holds atoms") {
    const Folder folder;
    const std::string atoms = data + "case_xyz_of_molecules/";
    for (const std::string name : {"symbols", "numbers", "extended"})
      says(folder.rbpa("solid " + atoms + name + ".xyz --alpha inf -o out.npy"), "18 points");
    says(folder.rbpa("solid " + atoms + "numbers.xyz --alpha inf --columns 2,3,4 --skip-invalid -o out.npy"),
         "18 points");
    says(folder.rbpa("solid " + data + "mol_08_molecular_xyz/molecule.xyz --alpha 3.1 -o out.npy"), "300 points");
    REQUIRE(folder.run("/bin/sh", "-c 'tail -n +3 " + atoms + "numbers.xyz > bare.xyz'").code == 0);
    CHECK(folder.rbpa("shape bare.xyz --alpha inf -o out.wkt").code == 3);
    says(folder.rbpa("shape bare.xyz --columns 2,3 --alpha inf -o out.wkt"), "18 points");
  }

  TEST_CASE("a feature of GeoJSON is named") {
    const Folder folder;
    CHECK(contains(
        folder.rbpa("shape " + data + "case_geojson_place/null_coordinates.geojson --alpha inf -o out.wkt").err,
        "null_coordinates.geojson:1: feature 0 (id \"a\"): found null"));
  }
}
