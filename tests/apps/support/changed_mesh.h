// A mesh that is built, written, changed by meshtopo, and compared regardless of its numbering.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "support/program.h"

namespace apps_test {

using Positions = std::vector<std::array<double, 3>>;
using Faces = std::vector<std::vector<std::uint32_t>>;

struct Mesh {
  Positions positions;
  Faces faces;

  /// Adds a box from `low` to `high`, of six squares that face outward.
  void add_box(std::array<double, 3> low, std::array<double, 3> high);
  void add_triangle(std::array<double, 3> a, std::array<double, 3> b, std::array<double, 3> c);
  /// Renumbers vertices and faces, and changes first corners.
  void shuffle(std::mt19937& random);
  std::string off() const;
};

/// Returns the faces of an OFF file as a set, by the positions of their corners from the least on: the mesh regardless
/// of its numbering.
std::multiset<Positions> places_of(const Folder& folder, const std::string& name);

/// Returns six times the volume that an OFF file encloses. Requires: it is exact in doubles.
double six_volumes(const Folder& folder, const std::string& name);

/// Returns the report of meshtopo on a change, as JSON.
nlohmann::json changed(const Folder& folder, const std::string& arguments);

}  // namespace apps_test
