// `rbpa info` about LAS and LAZ: what the header says, and the numbers of points by class and by return.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/las_file.h"
#include "support/laz_file.h"
#include "support/program.h"

using namespace apps_test;
using Json = nlohmann::json;

namespace {

/// A file of format `format` with points of several classes and returns.
LasFile classes(unsigned format) {
  LasFile file{.minor = format >= 6 ? 4U : 2U, .format = format, .scale = {0.01, 0.001, 0.5}, .offset = {1e5, -3, 0}};
  for (int i = 0; i < 1000; ++i)
    file.points.push_back({.x = i * 7 % 1000,
                           .y = i,
                           .return_number = static_cast<unsigned>(i % 3 + (format >= 6 ? 10 : 1)),
                           .number_of_returns = 4,
                           .classification = static_cast<unsigned>(i % 10 < 7    ? 2
                                                                   : format >= 6 ? 200
                                                                                 : 31)});
  return file;
}

Json las_of(const Folder& folder, const std::string& arguments) {
  return Json::parse(folder.rbpa("info " + arguments + " --json", 0).out).value("las", Json());
}

}  // namespace

TEST_SUITE("info about laser scans") {
  TEST_CASE("the header and the counts are those of the file, compressed or not, in both families of formats") {
    const Folder folder;
    for (const unsigned format : {0U, 6U}) {
      CAPTURE(format);
      const std::string las = bytes_of(classes(format));
      LazOptions options{.compressor = 2, .items = {{0, 20, 2}}, .chunks = {600, 400}, .varies = true};
      if (format == 6) options = {.compressor = 3, .items = {{10, 30, 3}}, .chunks = {600, 400}, .varies = true};
      folder.file("p.las", las);
      folder.file("p.laz", laz_of(las, options));
      const std::string high = format == 6 ? "200" : "31", first = format == 6 ? "10" : "1",
                        second = format == 6 ? "11" : "2", third = format == 6 ? "12" : "3";
      const Json expected = {{"version", format == 6 ? "1.4" : "1.2"},
                             {"point_format", format},
                             {"laszip", nullptr},
                             {"scale", {0.01, 0.001, 0.5}},
                             {"offset", {1e5, -3, 0}},
                             {"classes", {{"2", 700}, {high, 300}}},
                             {"returns", {{first, 334}, {second, 333}, {third, 333}}}};
      Json found = las_of(folder, "p.las");
      found.erase("copc");
      CHECK(found == expected);
      CHECK(las_of(folder, "- <p.las") == las_of(folder, "p.las"));
      Json compressed = las_of(folder, "p.laz");
      CHECK(compressed["laszip"] == options.compressor);
      compressed["laszip"] = nullptr;
      compressed.erase("copc");
      CHECK(compressed == expected);
      const Json some = las_of(folder, "p.laz --where \"class != 2 and return_number == " + first + "\"");
      CHECK(some["classes"] == Json{{high, 100}});
      CHECK(some["returns"] == Json{{first, 100}});
    }
  }

  TEST_CASE("the text has lines for people, and other formats have none of them") {
    const Folder folder;
    const std::string path = std::string(RBPA_TEST_DATA) + "/laz/point-color-time.las.laz";
    const std::string out = folder.rbpa("info " + path).out;
    CHECK(out.substr(out.find("format")) ==
          "format      LAS 1.2, point format 3, LASzip 2\n"
          "scale       0.01 0.01 0.01\n"
          "offset      -0 -0 -0\n"
          "classes     1: 789, 2: 276\n"
          "returns     1: 925, 2: 114, 3: 21, 4: 5\n");
    folder.file("p.las", bytes_of({.minor = 0, .format = 1}));
    CHECK(folder.rbpa("info p.las")
              .out.ends_with("format      LAS 1.0, point format 1, not compressed\n"
                             "scale       0.01 0.01 0.01\n"
                             "offset      0 0 0\n"
                             "classes     none\n"
                             "returns     none\n"));
    folder.file("p.xy", corner);
    CHECK(!contains(folder.rbpa("info p.xy").out, "format"));
    CHECK(las_of(folder, "p.xy").is_null());
  }
}
