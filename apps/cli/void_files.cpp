#include "cli/void_files.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
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

}  // namespace

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
