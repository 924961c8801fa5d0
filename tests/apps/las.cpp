// LAS byte by byte as its specification says: every version, point format and field; and files that are not LAS.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "io/cloud/las_fields.h"
#include "io/cloud/read_points.h"
#include "io/failure.h"
#include "support/data_folder.h"
#include "support/las_file.h"
#include "support/program.h"
#include "support/refusal_of.h"

using namespace apps_test;
using rbpa::Point;
using namespace rbpa::app;

namespace {

PointFile read(const std::string& bytes, const std::string& where = "") {
  PointSource source{.path = "p.las", .format = Format::las};
  if (!where.empty()) source.where = Condition(where, names_of_las_fields());
  return points_in(bytes, "p.las", source);
}

std::string refusal(const std::string& bytes, const std::string& where = "") {
  return rbpa_test::refusal_of<BadInput>([&] { read(bytes, where); });
}

std::string refused_condition(const std::string& text) {
  return rbpa_test::refusal_of<WrongUsage>([&] { const Condition condition(text, names_of_las_fields()); });
}

/// Returns the point formats of a version.
std::vector<unsigned> formats_of(unsigned minor) {
  const unsigned last[] = {1, 1, 3, 5, 10};
  std::vector<unsigned> formats;
  for (unsigned format = 0; format <= last[minor]; ++format) formats.push_back(format);
  return formats;
}

template <typename Check>
void for_each_layout(const Check& check) {
  for (unsigned minor = 0; minor <= 4; ++minor)
    for (const unsigned format : formats_of(minor))
      for (const unsigned extra : {0U, 5U}) {
        CAPTURE(minor);
        CAPTURE(format);
        CAPTURE(extra);
        check(LasFile{.minor = minor, .format = format, .extra_bytes = extra});
      }
}

/// Returns two points that differ in every field.
std::vector<LasPoint> two_points(const LasFile& file) {
  const bool flags = file.minor > 0;
  return {{.x = 1, .y = 2, .z = 3},
          {.x = -1000,
           .y = 2147483647,
           .z = -7,
           .intensity = 65535,
           .return_number = file.format < 6 ? 5U : 13U,
           .number_of_returns = file.format < 6 ? 7U : 15U,
           .scan_direction = 1,
           .edge = 1,
           .classification = file.format < 6 && flags ? 21U : 201U,
           .synthetic = flags ? 1U : 0U,
           .key_point = flags ? 1U : 0U,
           .withheld = flags ? 1U : 0U,
           .overlap = 1,
           .channel = 2,
           .scan_angle = file.format < 6 ? -90 : -15000,
           .user_data = 129,
           .source = 40000,
           .time = 12345.625,
           .red = 1000,
           .green = 50000,
           .blue = 3,
           .infrared = 60000}};
}

/// Returns a record of GeoTIFF keys: number, place, count and value of each.
LasRecord keys(const std::vector<std::vector<unsigned>>& entries) {
  std::string data = little(1, 2) + little(1, 2) + little(0, 2) + little(entries.size(), 2);
  for (const auto& entry : entries)
    for (const unsigned number : entry) data += little(number, 2);
  return {"LASF_Projection", 34735, data};
}

}  // namespace

TEST_SUITE("las") {
  TEST_CASE("every version and point format is read") {
    for_each_layout([](LasFile file) {
      file.points = two_points(file);
      file.records = {{"somebody", 7, "anything"}, {"LASF_Spec", 4, std::string(192, 'x')}};
      const std::vector<Point> expected = {{0.01, 0.02}, {-10, 21474836.47}};
      CHECK(read(bytes_of(file)).points == expected);
      file.signature_counts = true;  // as some writers of 1.0 have it
      CHECK(read(bytes_of(file)).points == expected);
    });
  }

  TEST_CASE("every field of every format distinguishes two points") {
    for_each_layout([](LasFile file) {
      file.points = two_points(file);
      const bool is_new = file.format >= 6, flags = file.minor > 0;
      const bool time = is_new || file.format == 1 || file.format >= 3;
      const bool color =
          is_new ? file.format != 6 && file.format != 9 : file.format % 4 == 2 || file.format == 3 || file.format == 5;
      const bool infrared = file.format == 8 || file.format == 10;
      struct Field {
        std::string condition;
        bool there = true;
      };
      const Field fields[] = {{"x == -10"},
                              {"y > 21474836.46"},
                              {"z = -0.07"},
                              {"intensity == 65535"},
                              {is_new ? "return_number == 13" : "return_number == 5"},
                              {is_new ? "NumberOfReturns == 15" : "NumberOfReturns == 7"},
                              {"scan_direction_flag"},
                              {"EdgeOfFlightLine == 1"},
                              {"classification == " + std::to_string(file.points[1].classification)},
                              {"synthetic == 1", flags},
                              {"key_point == 1", flags},
                              {"withheld == 1", flags},
                              {"overlap == 1", is_new},
                              {"scanner_channel == 2", is_new},
                              {"scan_angle == -90"},
                              {"user_data == 129"},
                              {"PointSourceId == 40000"},
                              {"gps_time == 12345.625", time},
                              {"red == 1000", color},
                              {"green == 50000", color},
                              {"blue == 3", color},
                              {"infrared == 60000", infrared}};
      for (const Field& field : fields) {
        CAPTURE(field.condition);
        if (field.there) {
          CHECK(read(bytes_of(file), field.condition).points == std::vector<Point>{{-10, 21474836.47}});
          CHECK(read(bytes_of(file), "not (" + field.condition + ")").points == std::vector<Point>{{0.01, 0.02}});
        } else {
          CHECK(contains(refusal(bytes_of(file), field.condition), "expected one with "));
        }
      }
    });
  }

  TEST_CASE("coordinates are the doubles nearest to their decimals") {
    std::mt19937_64 random(5);
    struct Grid {
      double scale, offset;
      int places;
    };
    for (const Grid& grid :
         {Grid{0.01, 0, 2}, Grid{0.001, 500000, 3}, Grid{0.0001, -6328493.4188, 4}, Grid{1e-7, 180, 7},
          Grid{0.25, 0.5, 2}, Grid{1, 0, 0}, Grid{100, 7, 0}, Grid{-0.01, 3, 2}}) {
      CAPTURE(grid.scale);
      LasFile file{.scale = {grid.scale, grid.scale, 1}, .offset = {grid.offset, 0, 0}};
      for (int i = 0; i < 1000; ++i)
        file.points.push_back({.x = static_cast<std::int32_t>(random()), .y = static_cast<std::int32_t>(random())});
      const std::vector<Point> points = read(bytes_of(file)).points;
      REQUIRE(points.size() == 1000);
      const std::int64_t power = std::llround(std::pow(10, grid.places));
      const auto scaled = [&](double value) { return std::llround(value * static_cast<double>(power)); };
      for (std::size_t i = 0; i < points.size(); ++i) {
        // Compared with text, which strtod() rounds.
        const auto nearest = [&](std::int32_t value, double offset) {
          std::int64_t n = value * scaled(grid.scale) + scaled(offset);
          std::string text = n < 0 ? "-" : "";
          if (n < 0) n = -n;
          text += std::to_string(n) + "e-" + std::to_string(grid.places);
          return std::strtod(text.c_str(), nullptr);
        };
        CHECK(points[i] == Point{nearest(file.points[i].x, grid.offset), nearest(file.points[i].y, 0)});
      }
    }
  }

  TEST_CASE("a scale that is no short decimal is applied by the rule of the specification") {
    const double scale = 1.029520741639058e-06, offset = 6328493.418841014;
    const LasFile file{.scale = {scale, scale, 1}, .offset = {offset, 0, 0}, .points = {{.x = 1717425, .y = -99}}};
    CHECK(read(bytes_of(file)).points == std::vector<Point>{{1717425 * scale + offset, -99 * scale}});
  }

  TEST_CASE("the coordinate reference system is that of the text, else of the keys, if these have one") {
    const LasRecord text{"LASF_Projection", 2112,
                         "PROJCS[\"Amersfoort / RD "
                         "New\",GEOGCS[\"Amersfoort\",AUTHORITY[\"EPSG\",\"4289\"]],AUTHORITY[\"EPSG\",\"28992\"]]" +
                             std::string(1, '\0')};
    const LasRecord newer{
        "LASF_Projection", 2112,
        "PROJCRS[\"WGS 84 / UTM zone 31N\",BASEGEOGCRS[\"WGS 84\",ID[\"EPSG\",4326]],ID[\"EPSG\",32631]]"};
    const auto crs = [](LasFile file) {
      file.points = {{}};
      const PointFile found = read(bytes_of(file));
      const bool said = std::any_of(found.warnings.begin(), found.warnings.end(), [](const std::string& warning) {
        return warning ==
                   "the system of coordinates has no EPSG code and is not carried over (--crs EPSG:CODE names it)" ||
               warning.starts_with(
                   "the system of coordinates is EPSG:26995, which is in meters, but the file names US");
      });
      CHECK(said == (!found.crs && !file.records.empty() && file.records.front().user == "LASF_Projection"));
      return found.crs ? found.crs->text() + (found.crs->degrees ? " in degrees" : "") : "none";
    };
    CHECK(crs({}) == "none");
    CHECK(crs({.records = {keys({{1024, 0, 1, 1}, {3072, 0, 1, 26915}})}}) == "EPSG:26915");
    CHECK(crs({.records = {keys({{1024, 0, 1, 2}, {2048, 0, 1, 4269}})}}) == "EPSG:4269 in degrees");
    CHECK(crs({.records = {keys({{1024, 0, 1, 1}, {2048, 0, 1, 4269}, {3072, 0, 1, 32767}})}}) == "none");
    CHECK(crs({.records = {keys({{1024, 0, 1, 1}, {2048, 0, 1, 4269}})}}) == "none");
    CHECK(crs({.records = {keys({{3072, 34737, 1, 26915}})}}) == "none");
    CHECK(crs({.records = {keys({{1024, 0, 1, 1}, {3072, 0, 1, 26915}, {3076, 0, 1, 9001}})}}) == "EPSG:26915");
    CHECK(crs({.records = {keys({{1024, 0, 1, 1}, {3072, 0, 1, 26995}, {3076, 0, 1, 9003}})}}) == "none");  // feet
    // Systems in feet, of either kind.
    CHECK(crs({.records = {keys({{1024, 0, 1, 1}, {3072, 0, 1, 2903}, {3076, 0, 1, 9003}})}}) == "EPSG:2903");
    CHECK(crs({.records = {keys({{1024, 0, 1, 1}, {3072, 0, 1, 2222}, {3076, 0, 1, 9002}})}}) == "EPSG:2222");
    CHECK(crs({.records = {{"other", 34735, keys({{3072, 0, 1, 26915}}).data}}}) == "none");
    CHECK(crs({.records = {keys({{3072, 0, 1, 26915}}), text}}) == "EPSG:28992");
    CHECK(crs({.minor = 4, .format = 6, .extended = {newer}}) == "EPSG:32631");
    CHECK(crs({.records = {{"LASF_Projection", 2112, "LOCAL_CS[\"a yard\"]"}}}) == "none");
  }

  TEST_CASE("records that claim too much are skipped, as they only describe the points") {
    LasFile file{.records = {{"a", 1, "0123456789"}}, .points = {{.x = 5}}};
    std::string bytes = bytes_of(file);
    bytes.replace(100, 4, little(4000000000U, 4));
    CHECK(read(bytes).points == std::vector<Point>{{0.05, 0}});
    bytes.replace(227 + 20, 2, little(65535, 2));
    CHECK(read(bytes).points == std::vector<Point>{{0.05, 0}});
  }

  TEST_CASE("broken files, other formats and claims that are too large are refused") {
    const LasFile file{.minor = 4, .format = 6, .points = {{}, {.x = 1}, {.x = 2}}};
    const std::string good = bytes_of(file);
    const auto with = [&](std::size_t at, const std::string& bytes) {
      std::string changed = good;
      return changed.replace(at, bytes.size(), bytes);
    };
    const std::string name = "p.las: found ";
    CHECK(refusal("LAS") == name + "'LAS', expected a LAS file, which begins with 'LASF'");
    CHECK(refusal(good.substr(0, 226)) == name + "226 bytes, expected a LAS header, of at least 227");
    CHECK(refusal(with(24, little(2, 1))) == name + "LAS version 2.4, expected 1.0 to 1.4");
    CHECK(refusal(with(25, little(5, 1))) == name + "LAS version 1.5, expected 1.0 to 1.4");
    CHECK(refusal(with(94, little(100, 2))) ==
          name + "a header size of 100, expected from 227 to the size of the file, 465");
    CHECK(contains(refusal(with(94, little(466, 2))), "a header size of 466"));
    CHECK(refusal(with(96, little(374, 4))) ==
          name + "an offset to point data of 374, expected one after the header, from 375 to 465");
    CHECK(contains(refusal(with(96, little(466, 4))), "an offset to point data of 466"));
    CHECK(refusal(with(104, little(6 | 0x80, 1))) ==
          "p.las: the record of LASzip: found 0 bytes, expected 34, and 6 for each item of a point");
    CHECK(refusal(with(104, little(11, 1))) == name + "point format 11, expected a format from 0 to 10");
    CHECK(refusal(with(105, little(29, 2))) ==
          name + "point records of 29 bytes, expected at least 30 of point format 6");
    CHECK(contains(refusal(with(105, little(0, 2))), "point records of 0 bytes"));
    CHECK(refusal(good.substr(0, 464)) ==
          name +
              "2 whole records of 30 bytes, expected 3 as the header says (--skip-invalid reads those that are whole)");
    CHECK(contains(refusal(with(247, little(~std::uint64_t{0}, 8))), "expected 18446744073709551615 as the header"));
    CHECK(refusal(with(131, little(0.0))) == name + "a scale of '0' for x, expected a finite number other than 0");
    CHECK(contains(refusal(with(139, little(std::nan("")))), "a scale of 'nan'"));
    CHECK(refusal(with(155, little(HUGE_VAL))) == name + "an offset of 'inf' for x, expected a finite number");
    CHECK(contains(refusal(with(131, little(1e300))), "expected coordinates within the range of a double"));
  }

  TEST_CASE("a count in the header that is too low or too high is refused, or read as far as both go") {
    const auto file = [](unsigned count) {
      LasFile las{.minor = 4, .format = 6};
      for (int i = 0; i < 20; ++i) las.points.push_back({.x = i, .y = i * i, .z = i % 3});
      las.extended = {{"LASF_Projection", 2112, "PROJCS[\"x\",AUTHORITY[\"EPSG\",\"28992\"]]"}};
      std::string bytes = bytes_of(las);
      return bytes.replace(247, 8, little(count, 8)).replace(107, 4, little(count, 4));
    };
    // Records after the points are not points.
    CHECK(read(file(20)).points.size() == 20);
    CHECK(refusal(file(7)) ==
          "p.las: found 20 whole records of 30 bytes, expected 7 as the header says (--skip-invalid reads as many as "
          "it counts)");

    const Folder folder({{"low.las", file(7)}, {"high.las", file(20).substr(0, 375 + 30 * 11 + 13)}});
    for (const std::string name : {"low.las", "high.las", "low.las.gz", "high.las.gz"}) {
      CAPTURE(name);
      if (name.ends_with(".gz")) REQUIRE(folder.run("/bin/gzip", "-kf " + name.substr(0, name.size() - 3)).code == 0);
      const bool low = name.starts_with("low");
      const std::string warning = low ? "13 whole records after the 7 points in the header are left out"
                                      : "9 of the 20 points in the header are left out: the file ends before them";
      for (const std::string& verb : std::vector<std::string>{
               "mesh " + name + " --alpha inf -o m.off", "surface " + name + " --radius 9 -o s.off",
               "stream " + name + " --alpha 9 --tile-size 1000 -o s.wkt"}) {
        CAPTURE(verb);
        says(folder, verb, 3, low ? "expected 7 as the header says" : "expected 20 as the header says");
        const Outcome taken = folder.rbpa(verb + " --skip-invalid", 0);
        CHECK(contains(taken.err, warning));
        CHECK(contains(taken.err, low ? "rbpa: 7 points" : "rbpa: 11 points"));
      }
    }
  }

  TEST_CASE("a header that counts no points, as an interrupted writer leaves it, gives all with --skip-invalid") {
    const auto file = [](unsigned minor, unsigned count) {
      LasFile las{.minor = minor, .format = minor < 4 ? 0U : 6U};
      for (int i = 0; i < 20; ++i) las.points.push_back({.x = i, .y = i * i, .z = i % 3});
      std::string bytes = bytes_of(las);
      if (minor == 4) bytes.replace(247, 8, little(count, 8));
      return bytes.replace(107, 4, little(count, 4));
    };
    CHECK(
        refusal(file(2, 0)) ==
        "p.las: found 20 whole records of 20 bytes, expected 0 as the header says (--skip-invalid reads all of them)");
    const Folder folder;
    for (const unsigned minor : {0U, 2U, 4U})
      for (const bool compressed : {false, true})
        for (const bool cut : {false, true}) {
          CAPTURE(minor);
          CAPTURE(compressed);
          CAPTURE(cut);
          std::string bytes = file(minor, 0), name = "p.las";
          if (cut) bytes.resize(bytes.size() - 3);
          folder.file(name, bytes);
          if (compressed) REQUIRE(folder.run("/bin/gzip", "-kf " + name).code == 0);
          if (compressed) name += ".gz";
          const std::string points = cut ? "19" : "20";
          for (const std::string& verb : std::vector<std::string>{
                   "mesh " + name + " --alpha inf -o m.off", "surface " + name + " --radius 9 -o s.off",
                   "stream " + name + " --alpha 9 --tile-size 1000 -o s.wkt"}) {
            CAPTURE(verb);
            CHECK(folder.rbpa(verb).code == 3);
            const Outcome taken = folder.rbpa(verb + " --skip-invalid", 0);
            CHECK(contains(taken.err,
                           "the header counts no points, and all " + points + " whole records after it are read"));
            CHECK(contains(taken.err, "rbpa: " + points + " points"));
          }
        }
    // A file without points.
    CHECK(read(bytes_of(LasFile{})).points.empty());
  }

  TEST_CASE("a signature before the points of version 1.0 is not mistaken for a point of a cut file") {
    LasFile las{.minor = 0};
    for (int i = 0; i < 5; ++i) las.points.push_back({.x = i, .y = i * i});
    las.signature_counts = true;
    std::string bytes = bytes_of(las);
    bytes.resize(bytes.size() - 7);
    PointSource source{.path = "p.las", .format = Format::las, .skip_invalid = true};
    CHECK(points_in(bytes, "p.las", source).points ==
          std::vector<Point>{{0, 0}, {0.01, 0.01}, {0.02, 0.04}, {0.03, 0.09}});
  }

  TEST_CASE("conditions select points, and wrong ones are refused") {
    LasFile file{.minor = 4, .format = 7, .scale = {1, 1, 1}};
    for (unsigned i = 0; i < 64; ++i)
      file.points.push_back(
          {.x = static_cast<std::int32_t>(i), .return_number = 1 + i % 4, .classification = i % 8, .red = i});
    const std::string bytes = bytes_of(file);
    const auto count = [&](const std::string& where, const auto& holds) {
      CAPTURE(where);
      std::vector<Point> expected;
      for (unsigned i = 0; i < 64; ++i)
        if (holds(i)) expected.push_back({static_cast<double>(i), 0});
      CHECK(read(bytes, where).points == expected);
    };
    count("classification==6 and return_number==3", [](unsigned i) { return i % 8 == 6; });
    count("Classification = 4 AND ReturnNumber = 1", [](unsigned i) { return i % 8 == 4; });
    count("classification in (2, 6)", [](unsigned i) { return i % 4 == 2; });
    count("classification not in (2, 6)", [](unsigned i) { return i % 4 != 2; });
    count("red < 10 or red >= 60 and classification != 6",
          [](unsigned i) { return i < 10 || (i >= 60 && i % 8 != 6); });
    count("(red < 10 or red >= 60) and classification <> 6",
          [](unsigned i) { return (i < 10 || i >= 60) && i % 8 != 6; });
    count("!(red<=5) && !red>6", [](unsigned i) { return i == 6; });
    count("5 < red <= 7", [](unsigned i) { return i == 6 || i == 7; });
    count("1e1 > x || x==63", [](unsigned i) { return i < 10 || i == 63; });
    count("z > -0.5", [](unsigned) { return true; });
    count("red", [](unsigned i) { return i != 0; });
    CHECK(read(bytes, "red == 1").warnings == std::vector<std::string>{"--where selects 1 of 64 points"});

    CHECK(
        refused_condition("").starts_with("--where: found the end, expected a number or a field of LAS: x, y, z, int"));
    CHECK(refused_condition("and == 2").starts_with("--where: found 'and', expected a number or a field"));
    CHECK_THROWS_AS(read(bytes, "category == 2"), rbpa::app::BadInput);
    CHECK(refused_condition("red == ").starts_with("--where: found the end, expected a number or"));
    CHECK(refused_condition("red == 2 blue == 3") == "--where: found 'blue', expected 'and', 'or' or the end");
    CHECK(refused_condition("(red == 2") == "--where: found the end, expected ')'");
    CHECK(refused_condition("red in 2") == "--where: found '2', expected '('");
    CHECK(refused_condition("red in (2 3)") == "--where: found '3', expected ',' or ')'");
    CHECK(refused_condition("red not 2") == "--where: found '2', expected 'in' and a list");
    CHECK(refused_condition("red == -blue") == "--where: found 'blue', expected a number");
    const auto nested = [](std::size_t depth) { return std::string(depth, '(') + "red = 2" + std::string(depth, ')'); };
    CHECK(contains(refused_condition(nested(101)), "at most 100 nested brackets"));
    CHECK(contains(refused_condition(nested(100) + " blue"), "found 'blue'"));
  }

  TEST_CASE("class is the classification, in conditions and for groups") {
    const Folder folder("p.las", bytes_of(LasFile{.points = {{.classification = 6},
                                                             {.x = 100, .classification = 6},
                                                             {.y = 100, .z = 900, .classification = 6},
                                                             {.x = 900, .classification = 2}}}));
    for (const std::string name : {"class", "Class", "classification", "Classification"}) {
      CAPTURE(name);
      CHECK(folder.rbpa("info p.las --where \"" + name + " == 6\"").out.starts_with("points      3\n"));
      CHECK(folder.rbpa("info p.las --where \"" + name + " == 6 and z > 3\"").out.starts_with("points      1\n"));
      CHECK(folder.rbpa("shape p.las --group-by " + name + " --alpha 9 -q -o g.csv").code == 0);
      CHECK(contains(folder.content("g.csv"), "\n6,3,"));
    }
  }

  TEST_CASE("withheld points are points, with a warning") {
    const LasFile file{.points = {{.withheld = 1}, {.x = 1}, {.x = 2, .withheld = 1}}};
    CHECK(read(bytes_of(file)).warnings ==
          std::vector<std::string>{"2 points are marked as withheld (--where \"not withheld\" leaves them out)"});
    CHECK(read(bytes_of(file), "not withheld").points == std::vector<Point>{{0.01, 0}});
  }

  TEST_CASE("further LAS files have their points, systems of coordinates and fields") {
    if (!rbpa_test::has_further_data()) return;
    const std::string folder = rbpa_test::further_data().string() + "/";
    const auto file = [&](const std::string& name) {
      return read_points({.path = folder + name, .format = Format::las});
    };
    struct Real {
      std::string name;
      std::size_t points;
      std::string crs;
    };
    for (const Real& real : {Real{"las_autzen_thin.las", 10653, ""}, Real{"las_mvk_thin.las", 6280, ""},
                             Real{"las_certainty3d.las", 10126, "EPSG:2229"}, Real{"las_extrabytes.las", 1065, ""},
                             Real{"las_v10_pf0.las", 1, "EPSG:26915"}, Real{"las_v12_pf2.las", 1, "EPSG:26915"},
                             Real{"las_v14_pf6.las", 1000, "EPSG:2903"}}) {
      CAPTURE(real.name);
      const PointFile found = file(real.name);
      CHECK(found.points.size() == real.points);
      CHECK((found.crs ? found.crs->text() : "") == real.crs);
    }
    // Points that others wrote as text agree.
    CHECK(file("las_certainty3d.las").points ==
          read_points({.path = RBPA_TEST_DATA "/lidar_certainty3d.xy", .format = Format::text}).points);
    CHECK_THROWS_AS(file("las_garbage_vlr_count.las"), BadInput);  // which lacks a part of its last point
  }

  TEST_CASE("a system in US survey feet goes from LAS to GeoJSON and on, with its coordinates") {
    const Folder folder;
    LasFile file{.offset = {1500000, 612345, 0}};
    file.records = {keys({{1024, 0, 1, 1}, {3072, 0, 1, 2903}, {3076, 0, 1, 9003}})};
    file.points = {{.x = 0, .y = 0}, {.x = 125, .y = 0}, {.x = 125, .y = 50}, {.x = 0, .y = 50}};
    folder.file("p.las", bytes_of(file));
    const Outcome outcome = folder.rbpa("shape p.las --alpha inf -o s.geojson -o s.ewkt", 0);
    CHECK(outcome.err.starts_with("rbpa: s.geojson: written in EPSG:2903, "));
    const std::string content = folder.content("s.geojson");
    CHECK(content.starts_with(
        R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::2903"}},)"));
    CHECK(contains(
        content, "[[[1500000,612345],[1500001.25,612345],[1500001.25,612345.5],[1500000,612345.5],[1500000,612345]]]"));
    CHECK(folder.content("s.ewkt").starts_with("SRID=2903;"));
    CHECK(contains(folder.rbpa("info s.geojson --vertices").out, "crs         EPSG:2903\n"));
    CHECK(folder.rbpa("shape s.geojson --vertices --alpha inf -o - --output-format json -q").out == content);
  }

  TEST_CASE("the program reads LAS with its system, also compressed by gzip") {
    const Folder folder;
    LasFile file{.minor = 4, .format = 6};
    for (int i = 0; i < 9; ++i)
      file.points.push_back({.x = 10000000 + i % 3, .y = i / 3, .classification = i < 6 ? 2U : 6U});
    file.records = {{"LASF_Projection", 2112, "PROJCS[\"x\",AUTHORITY[\"EPSG\",\"28992\"]]"}};
    folder.file("p.las", bytes_of(file));
    REQUIRE(folder.run("/bin/gzip", "-k p.las").code == 0);
    for (const std::string name : {"p.las", "p.las.gz"}) {
      const Outcome outcome = folder.rbpa("mesh " + name + " --where classification==2 --alpha inf -o m.off", 0);
      CHECK(outcome.err ==
            "rbpa: " + name + ": --where selects 6 of 9 points\nrbpa: 6 points, 4 triangles, 0 isolated -> m.off\n");
      CHECK(folder.content("m.off").starts_with("OFF\n6 4 0\n1e+05 0 0\n100000.01 0 0\n100000.02 0 0\n1e+05 0.01 0\n"));
      CHECK(contains(folder.rbpa("info " + name).out, "crs         EPSG:28992\n"));
    }
    CHECK(contains(folder.rbpa("info p.las --crs EPSG:7415").out, "crs         EPSG:7415\n"));
    CHECK(folder.rbpa("info p.las --where 'clas==2'").code == 3);
    CHECK(folder.rbpa("info p.las --where red==2").code == 3);
    CHECK(folder.rbpa("info p.npy --where x==2").err ==
          "rbpa: --where: found a format without fields, expected " + with_fields(Use::points) + "\n");
  }
}
