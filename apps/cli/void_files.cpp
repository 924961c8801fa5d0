#include "cli/void_files.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/solid_boundary.h"
#include "rbpa/solid_components.h"
#include "rbpa/split_fans.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;
using Corners = std::array<std::uint32_t, 3>;

/// As if the void were a body.
Corners seen_from_around(const Corners& triangle) { return {triangle[0], triangle[2], triangle[1]}; }

void write_csv(OutputFile& file, std::span<const SolidVoid> voids) {
  file.write("number,volume,area,islands,points,low_x,low_y,low_z,high_x,high_y,high_z\n");
  std::uint64_t number = 0;
  for (const SolidVoid& hollow : voids) {
    file.write_number(++number);
    for (const double value : {hollow.volume, hollow.area}) {
      file.write(",");
      file.write_number(value);
    }
    for (const std::size_t count : {hollow.islands, hollow.points.size()}) {
      file.write(",");
      file.write_number(std::uint64_t{count});
    }
    for (const Point3& p : {hollow.low, hollow.high})
      for (const double value : {p.x, p.y, p.z}) {
        file.write(",");
        file.write_number(value);
      }
    file.write("\n");
  }
}

void write_json(OutputFile& file, const Surface& boundary, std::span<const SolidVoid> voids) {
  std::string_view before = "[\n";
  for (const SolidVoid& hollow : voids) {
    stop_if_interrupted();
    Json one = json_of(hollow);
    one["triangles"] = Json::array();
    for (const std::uint32_t t : hollow.triangles) one["triangles"].push_back(seen_from_around(boundary.triangles[t]));
    file.write(before);
    file.write(one.dump());
    before = ",\n";
  }
  file.write(voids.empty() ? "[]\n" : "\n]\n");
}

void write_obj(OutputFile& file, std::span<const Point3> points, const Surface& boundary,
               std::span<const SolidVoid> voids) {
  const SplitFans fans = split_fans(indexable_surface(boundary));
  std::uint64_t written = 0, number = 0;
  for (const SolidVoid& hollow : voids) {
    stop_if_interrupted();
    file.write("g void_" + std::to_string(++number) + "\n");
    std::unordered_map<std::uint32_t, std::uint64_t> vertex;  // of a fan, from 1
    for (const std::uint32_t t : hollow.triangles)
      for (const std::uint32_t fan : fans.triangles[t]) {
        if (!vertex.try_emplace(fan, written + 1).second) continue;
        ++written;
        const Point3& p = points[fans.point[fan]];
        file.write("v");
        for (const double value : {p.x, p.y, p.z}) {
          file.write(" ");
          file.write_number(value);
        }
        file.write("\n");
      }
    for (const std::uint32_t t : hollow.triangles) {
      file.write("f");
      for (const std::uint32_t fan : seen_from_around(fans.triangles[t])) {
        file.write(" ");
        file.write_number(vertex.at(fan));
      }
      file.write("\n");
    }
  }
}

/// How many pieces, connected through points, the triangles are.
std::size_t pieces(const Surface& boundary, const SolidVoid& hollow) {
  meshops::DisjointSets sets(hollow.points.size());
  const auto number = [&](std::uint32_t point) {
    const auto at = std::lower_bound(hollow.points.begin(), hollow.points.end(), point);
    return static_cast<std::uint32_t>(at - hollow.points.begin());
  };
  std::size_t count = hollow.points.size();
  for (const std::uint32_t t : hollow.triangles)
    for (std::size_t k = 1; k < 3; ++k) {
      const std::uint32_t a = sets.find(number(boundary.triangles[t][0])),
                          b = sets.find(number(boundary.triangles[t][k]));
      if (a == b) continue;
      sets.link(a, b);
      --count;
    }
  return count;
}

}  // namespace

FullVoids full_voids(std::span<const Point3> points, const Solid& space) {
  SolidBoundary boundary = solid_boundary(space);
  const SolidComponents components = solid_components(points, space, boundary);
  FullVoids voids;
  for (const SolidComponent& c : components.all)
    voids.all.push_back({.triangles = {},
                         .points = {},
                         .islands = 0,
                         .volume = c.volume,
                         .area = c.area,
                         .low = c.low,
                         .high = c.high});
  voids.boundary = std::move(boundary.surface);
  for (std::uint32_t t = 0; t < boundary.tetrahedra.size(); ++t) {
    auto& corners = voids.boundary.triangles[t];
    SolidVoid& hollow = voids.all[components.number[boundary.tetrahedra[t]]];
    hollow.triangles.push_back(t);
    hollow.points.insert(hollow.points.end(), corners.begin(), corners.end());
    std::swap(corners[1], corners[2]);
    std::swap(voids.boundary.neighbors[t][1], voids.boundary.neighbors[t][2]);
  }
  for (SolidVoid& hollow : voids.all) {
    std::sort(hollow.points.begin(), hollow.points.end());
    hollow.points.erase(std::unique(hollow.points.begin(), hollow.points.end()), hollow.points.end());
    hollow.islands = pieces(voids.boundary, hollow) - 1;
  }
  return voids;
}

Target parse_voids(const std::string& path) {
  const std::optional<Format> format = find_format(Use::voids, ending(path));
  if (!format)
    throw WrongUsage("--voids: found the ending " + in_quotes(ending(path)) + ", expected one of " +
                     std::string(void_formats));
  return {path, *format};
}

Json json_of(const SolidVoid& hollow) {
  const auto corner = [](const Point3& p) { return Json{p.x, p.y, p.z}; };
  return {{"volume", hollow.volume},
          {"area", hollow.area},
          {"islands", hollow.islands},
          {"box", Json::array({corner(hollow.low), corner(hollow.high)})},
          {"points", hollow.points}};
}

void write_voids(OutputFile& file, Format format, std::span<const Point3> points, const Surface& boundary,
                 std::span<const SolidVoid> voids) {
  if (format == Format::csv) return write_csv(file, voids);
  if (format == Format::json) return write_json(file, boundary, voids);
  write_obj(file, points, boundary, voids);
}

}  // namespace rbpa::app
