// Coordinate systems: the one of a text that counts for the plane, its name, and that two are never joined.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "io/crs.h"
#include "support/las_file.h"
#include "support/program.h"

using namespace apps_test;
using namespace rbpa::app;

namespace {

const std::string geogcs =
    "GEOGCS[\"NAD83\",DATUM[\"North_American_Datum_1983\",SPHEROID[\"GRS "
    "1980\",6378137,298.257222101,AUTHORITY[\"EPSG\",\"7019\"]],AUTHORITY[\"EPSG\",\"6269\"]],UNIT[\"degree\",0."
    "0174532925199433,AUTHORITY[\"EPSG\",\"9122\"]],AUTHORITY[\"EPSG\",\"4269\"]]";
const std::string vertical =
    "VERT_CS[\"NAVD88 "
    "height\",VERT_DATUM[\"NAVD88\",2005,AUTHORITY[\"EPSG\",\"5103\"]],UNIT[\"metre\",1,AUTHORITY[\"EPSG\",\"9001\"]],"
    "AUTHORITY[\"EPSG\",\"5703\"]]";
const std::string vertical2 = "VERTCRS[\"NAVD88 height\",VDATUM[\"N\"],CS[vertical,1],ID[\"EPSG\",5703]]";

/// Returns a projected system of the first version of WKT, with a unit and more elements.
std::string projcs(const std::string& unit, const std::string& more) {
  return "PROJCS[\"NAD83, \"\"in\"\" zone [10](N)\"," + geogcs + ",PROJECTION[\"Transverse_Mercator\"],UNIT[" + unit +
         "]" + more + "]";
}
const std::string code = ",AUTHORITY[\"EPSG\",\"26910\"]", metre = "\"metre\",1,AUTHORITY[\"EPSG\",\"9001\"]";

/// Returns a projected system of the second version of WKT.
std::string projcrs(const std::string& id) {
  return "PROJCRS[\"NAD83 / UTM zone 10N\",BASEGEOGCRS[\"NAD83\",DATUM[\"D\",ELLIPSOID[\"GRS "
         "1980\",6378137,298.25]],ID[\"EPSG\",4269]],CONVERSION[\"UTM\",METHOD[\"Transverse "
         "Mercator\",ID[\"EPSG\",9807]]],CS[Cartesian,2],AXIS[\"(E)\",east,LENGTHUNIT[\"metre\",1]]" +
         id + "]";
}

struct Text {
  std::string wkt, crs;  ///< "none", or its name, " in degrees" or not
};
const std::vector<Text> texts = {
    {projcs(metre, code), "EPSG:26910"},
    {projcs(metre, ""), "none"},  // the code of a part is not that of the whole
    {"COMPD_CS[\"both\"," + projcs(metre, code) + "," + vertical + "]", "EPSG:26910"},
    {"COMPD_CS[\"both\"," + vertical + "," + projcs(metre, code) + "]", "EPSG:26910"},
    {"COMPD_CS[\"both\"," + projcs(metre, code) + "," + vertical + ",AUTHORITY[\"EPSG\",\"7415\"]]", "EPSG:26910"},
    {"COMPD_CS[\"both\"," + projcs(metre, "") + "," + vertical + ",AUTHORITY[\"EPSG\",\"7415\"]]", "EPSG:7415"},
    {"COMPD_CS[\"both\"," + projcs(metre, "") + "," + vertical + ",AUTHORITY[\"EPSG\",\"5703\"]]", "none"},
    {"COMPD_CS[\"both\"," + projcs(metre, "") + "," + vertical + "]", "none"},
    {"COMPD_CS [\"both\",\n  " + projcs(metre, ", AUTHORITY [ \"EPSG\" , \"26910\" ] ") + " ,\n  " + vertical + "\n]",
     "EPSG:26910"},
    {"COMPD_CS(\"both\"," + geogcs + "," + vertical + ")", "EPSG:4269 in degrees"},
    {projcs(metre, code) + "," + vertical, "EPSG:26910"},  // as ESRI has it
    {"PROJCS[\"NAD_1983\",GEOGCS[\"GCS_North_American_1983\"]],VERTCS[\"NAVD88\",AUTHORITY[\"EPSG\",\"5703\"]]",
     "none"},
    {vertical, "none"},
    {vertical2, "none"},
    {geogcs, "EPSG:4269 in degrees"},
    {projcrs(",ID[\"EPSG\",26910]"), "EPSG:26910"},
    {projcrs(",ID[\"EPSG\",26910,\"10.0\",URI[\"urn:ogc:def:crs:EPSG::26910\"]]"), "EPSG:26910"},
    {projcrs(""), "none"},
    {"COMPOUNDCRS[\"both\"," + projcrs(",ID[\"EPSG\",26910]") + "," + vertical2 + "]", "EPSG:26910"},
    {"COMPOUNDCRS[\"both\"," + projcrs("") + "," + vertical2 + "]", "none"},
    {"BOUNDCRS[SOURCECRS[" + projcrs(",ID[\"EPSG\",26910]") + "],TARGETCRS[GEOGCRS[\"WGS 84\",ID[\"EPSG\",4326]]]]",
     "EPSG:26910"},
    {"COMPOUNDCRS[\"both\",BOUNDCRS[SOURCECRS[" + projcrs(",ID[\"EPSG\",26910]") +
         "],TARGETCRS[GEOGCRS[\"WGS 84\",ID[\"EPSG\",4326]]]]," + vertical2 + "]",
     "EPSG:26910"},
    {"COORDINATEMETADATA[" + projcrs(",ID[\"EPSG\",26910]") + ",EPOCH[2016.47]]", "EPSG:26910"},
    {"GEOGCRS[\"WGS 84\",CS[ellipsoidal,2],ID[\"EPSG\",4326]]", "EPSG:4326 in degrees"},
    {"GEODCRS[\"WGS 84\",CS[ellipsoidal,3],ID[\"EPSG\",4979]]", "EPSG:4979 in degrees"},
    {"GEODCRS[\"WGS 84\",CS[Cartesian,3],ID[\"EPSG\",4978]]", "EPSG:4978"},
    {"LOCAL_CS[\"a yard\"]", "none"},
    {"", "none"},
    {"COMPD_CS[\"cut off\",PROJCS[\"x\"", "none"}};

std::string text_of(const std::optional<Crs>& crs) {
  return crs ? crs->text() + (crs->degrees ? " in degrees" : "") : "none";
}

LasRecord record(const std::string& wkt) { return {"LASF_Projection", 2112, wkt + '\0'}; }
LasRecord keys(const std::vector<std::vector<unsigned>>& entries) {
  std::string data = little(1, 2) + little(1, 2) + little(0, 2) + little(entries.size(), 2);
  for (const auto& entry : entries)
    for (const unsigned number : entry) data += little(number, 2);
  return {"LASF_Projection", 34735, data};
}

std::string las(const std::vector<LasRecord>& records, bool behind = false) {
  LasFile file{.points = {{}, {.x = 100}, {.y = 100}, {.x = 100, .y = 100}}};
  (behind ? file.extended : file.records) = records;
  if (behind) file.minor = 4, file.format = 6;
  return bytes_of(file);
}

std::string crs_of(const Folder& folder, const std::string& arguments) {
  const std::string out = folder.rbpa("info " + arguments).out, key = "crs         ";
  const std::size_t at = out.find(key);
  return at == std::string::npos ? "none" : out.substr(at + key.size(), out.find('\n', at) - at - key.size());
}

const std::string findings = std::string(RBPA_TEST_DATA) + "/findings/";

}  // namespace

TEST_SUITE("systems of coordinates") {
  TEST_CASE("well-known text names the system of the plane by its horizontal part, and never by a vertical one") {
    const Folder folder;
    for (const Text& text : texts) {
      CAPTURE(text.wkt);
      CHECK(text_of(crs_of_wkt(text.wkt)) == text.crs);
      const std::string name = text.crs.substr(0, text.crs.find(' '));
      for (const bool behind : {false, true}) {
        folder.file("p.las", las({record(text.wkt)}, behind));
        CHECK(crs_of(folder, "p.las") == name);
        const bool said = contains(folder.rbpa("info p.las").err, "--crs EPSG:CODE names it");
        CHECK(said == (name == "none"));
      }
    }
  }

  TEST_CASE("systems are named in either case, and a compound one by its horizontal part") {
    for (const auto& [name, crs] : std::vector<std::pair<std::string, std::string>>{
             {"EPSG:6339", "EPSG:6339"},
             {"epsg:6339+5703", "EPSG:6339"},
             {"EPSG:4326+5773", "EPSG:4326 in degrees"},
             {"urn:ogc:def:crs:EPSG::6339", "EPSG:6339"},
             {"urn:ogc:def:crs:EPSG:10.0:6339", "EPSG:6339"},
             {"urn:ogc:def:crs,crs:EPSG::6339,crs:EPSG::5703", "EPSG:6339"},
             {"urn:ogc:def:crs:OGC:1.3:CRS84", "OGC:CRS84 in degrees"},
             {"http://www.opengis.net/def/crs/EPSG/0/6339", "EPSG:6339"},
             {"EPSG:5703", "none"},
             {"urn:ogc:def:crs:EPSG::5703", "none"},
             {"EPSG:+5703", "none"},
             {"EPSG:", "none"},
             {"6339", "none"}}) {
      const auto& shown_name = name;
      CAPTURE(shown_name);
      CHECK(text_of(crs_of_name(name)) == crs);
    }
  }

  TEST_CASE("LAS files of others have their systems") {
    const Folder folder;
    for (const auto& [file, crs] :
         std::vector<std::pair<std::string, std::string>>{{"case_las_compound_crs/wkt_compound.las", "EPSG:26910"},
                                                          {"case_las_compound_crs/wkt2.las", "EPSG:26910"},
                                                          {"case_las_compound_crs/geographic.las", "EPSG:4326"},
                                                          {"gis_las_compound_crs/e_comp3.las", "EPSG:6339"},
                                                          {"gis_las_compound_crs/i_compft.las", "EPSG:2229"},
                                                          {"case_las_vertical_crs/wkt_no_code.las", "none"},
                                                          {"case_las_vertical_crs/vertical_only.las", "none"}}) {
      const auto& shown_file = file;
      CAPTURE(shown_file);
      CHECK(crs_of(folder, findings + file) == crs);
    }
    folder.rbpa("shape " + findings + "case_las_vertical_crs/wkt_no_code.las --alpha 1 -o o.ewkt", 2);
    CHECK_FALSE(folder.has("o.ewkt"));
  }

  TEST_CASE("a vertical system is never that of the plane") {
    const Folder folder;
    for (const std::string vertical_code : {"5703", "3855", "5773", "6360", "9279"}) {
      CAPTURE(vertical_code);
      const std::string warning =
          "EPSG:" + vertical_code + " is a system of heights, and the horizontal system is not known";
      const auto is_none = [&](const std::string& arguments) {
        CHECK(crs_of(folder, arguments) == "none");
        const std::string err = folder.rbpa("info " + arguments).err;
        CHECK(contains(err, warning));
        CHECK(err.find(warning) == err.rfind(warning));
        CHECK(crs_of(folder, arguments + " --crs EPSG:28992") == "EPSG:28992");
      };
      folder.file("p.ewkt", "SRID=" + vertical_code + ";POINT(1 2)\nSRID=" + vertical_code + ";POINT(3 4)\n");
      is_none("p.ewkt");
      folder.file("t.csv", "id,geom\n1,\"SRID=" + vertical_code + ";POINT(1 2)\"\n2,\"SRID=" + vertical_code +
                               ";POINT(1 3)\"\n");
      is_none("t.csv");
      folder.file(
          "p.geojson",
          "{\"type\":\"MultiPoint\",\"crs\":{\"type\":\"name\",\"properties\":{\"name\":\"urn:ogc:def:crs:EPSG::" +
              vertical_code + "\"}},\"coordinates\":[[1,2],[3,4]]}");
      is_none("p.geojson");
      const auto number = static_cast<unsigned>(std::stoul(vertical_code));
      folder.file("p.las", las({keys({{1024, 0, 1, 1}, {3072, 0, 1, number}})}));
      is_none("p.las");
      folder.file("p.las", las({keys({{1024, 0, 1, 2}, {2048, 0, 1, number}})}));
      is_none("p.las");
      folder.file("p.las", las({keys({{1024, 0, 1, 1}, {3072, 0, 1, 26910}, {4096, 0, 1, number}})}));
      CHECK(crs_of(folder, "p.las") == "EPSG:26910");
      folder.file("p.xy", corner);
      refuses(folder, "info p.xy --crs EPSG:" + vertical_code, 2,
              "--crs: found 'EPSG:" + vertical_code +
                  "', a system of heights, expected a horizontal one, such as EPSG:28992");
    }
  }

  TEST_CASE("a code in meters together with feet gives a warning with the codes to give") {
    const Folder folder;
    const auto warning = [&](const LasRecord& one) {
      folder.file("p.las", las({one}));
      CHECK(crs_of(folder, "p.las") == "none");
      return folder.rbpa("info p.las").err;
    };
    const auto expected = [](const std::string& unit) {
      return "rbpa: p.las: the system of coordinates is EPSG:26910, which is in meters, but the file names " + unit +
             ", and it is not carried over (--crs EPSG:CODE names the right one, --crs EPSG:26910 takes this one "
             "nevertheless)\n";
    };
    const auto with_unit = [](unsigned unit) {
      return keys({{1024, 0, 1, 1}, {3072, 0, 1, 26910}, {3076, 0, 1, unit}});
    };
    CHECK(warning(with_unit(9003)) == expected("US survey feet"));
    CHECK(warning(with_unit(9002)) == expected("feet"));
    CHECK(warning(with_unit(9036)) == expected("another unit, number 9036 of EPSG"));
    CHECK(warning(record(projcs("\"US survey foot\",0.304800609601219", code))) == expected("US survey feet"));
    CHECK(warning(record(projcs("\"foot\",0.3048", code))) == expected("feet"));
    // Other kinds of feet.
    for (const auto& [own, unit, number] : std::vector<std::tuple<std::string, std::string, unsigned>>{
             {"2229", "\"US survey foot\",0.3048006096", 9003}, {"2222", "\"foot\",0.3048", 9002}}) {
      folder.file("p.las", las({record(projcs(unit, ",AUTHORITY[\"EPSG\",\"" + own + "\"]"))}));
      CHECK(crs_of(folder, "p.las") == "EPSG:" + own);
      folder.file("p.las", las({keys({{3072, 0, 1, static_cast<unsigned>(std::stoul(own))}, {3076, 0, 1, number}})}));
      CHECK(crs_of(folder, "p.las") == "EPSG:" + own);
    }
  }

  TEST_CASE("no verb joins files of two systems, or of one and none") {
    const Folder folder;
    std::filesystem::create_directory(folder.path("tiles"));
    const std::string named = las({record(projcs(metre, code))}),
                      other = las({record(projcs(metre, ",AUTHORITY[\"EPSG\",\"26911\"]"))}), unnamed = las({});
    const std::vector<std::string> verbs = {"stream {} --alpha 9 -o o.wkt",
                                            "stream tiles --alpha 9 -o o.wkt",
                                            "shape {} --group-by-file --alpha 9 -o o.geojson",
                                            "shape {} --group-by intensity --alpha 9 -o o.geojson",
                                            "mesh {} --group-by-file --alpha 9 -o o.ply",
                                            "alpha {} --group-by-file",
                                            "info {} --group-by-file"};
    const auto check = [&](const std::string& first, const std::string& second, const std::string& said) {
      folder.file("tiles/a.las", first);
      folder.file("tiles/b.las", second);
      for (std::string verb : verbs) {
        CAPTURE(verb);
        if (const std::size_t at = verb.find("{}"); at != std::string::npos)
          verb.replace(at, 2, "tiles/a.las tiles/b.las");
        const Outcome outcome = folder.rbpa(verb + " -q");
        CHECK(outcome.code == (said.empty() ? 0 : 3));
        if (!said.empty()) CHECK(outcome.err == "rbpa: tiles/b.las: found points in " + said + " applies to all)\n");
        if (!said.empty()) CHECK_FALSE(folder.has("o.wkt"));
        CHECK(folder.rbpa(verb + " -q --crs EPSG:26910").code == 0);
        for (const std::string name : {"o.wkt", "o.geojson", "o.ply"}) std::filesystem::remove(folder.path(name));
      }
    };
    check(named, named, "");
    check(unnamed, unnamed, "");
    check(named, unnamed, "no system, expected EPSG:26910, as in tiles/a.las (--crs EPSG:26910");
    check(unnamed, named, "EPSG:26910, expected no system, as in tiles/a.las (--crs EPSG:26910");
    check(named, other, "EPSG:26911, expected EPSG:26910, as in tiles/a.las (--crs EPSG:CODE");
  }
}
