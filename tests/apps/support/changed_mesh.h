// A mesh that is put together, written, changed by meshtopo and compared, without its numbers.
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

  /// A box from `low` to `high`, of six squares that face outward.
  void add_box(std::array<double, 3> low, std::array<double, 3> high);
  void add_triangle(std::array<double, 3> a, std::array<double, 3> b, std::array<double, 3> c);
  /// Other numbers of vertices and faces, and other first corners.
  void shuffle(std::mt19937& random);
  std::string off() const;
};

/// The faces of an OFF file by the places of their corners, from the least on, as a set: the mesh without its numbers.
std::multiset<Positions> places_of(const Folder& folder, const std::string& name);

/// Six times the volume that an OFF file encloses, where it is exact in doubles.
double six_volumes(const Folder& folder, const std::string& name);

/// What meshtopo reports of a change, as JSON.
nlohmann::json changed(const Folder& folder, const std::string& arguments);

}  // namespace apps_test
