// What: points of known radii, and the radii that the program reports.
#pragma once

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/program.h"

namespace apps_test {

/// The file of clusters for tests of --alpha, as an argument.
inline const std::string clusterable = "'" RBPA_TEST_DATA "/shape_hdbscan_clusterable.xy' ";

/// Two right triangles of circumradius 5 and 10, far from each other.
inline constexpr const char* two_triangles = "0 0\n6 0\n0 8\n100 0\n112 0\n100 16\n0 0\n";

/// Returns the statistics of a run.
inline nlohmann::json stats_of(const Folder& folder, const std::string& arguments) {
  CAPTURE(arguments);
  REQUIRE(folder.rbpa(arguments + " -q --stats s.json").code == 0);
  return nlohmann::json::parse(folder.content("s.json"));
}

/// Returns the report of `rbpa alpha --json`.
inline nlohmann::json radii_of(const Folder& folder, const std::string& arguments) {
  return nlohmann::json::parse(folder.rbpa("alpha " + arguments + " --json -q").out);
}

}  // namespace apps_test
