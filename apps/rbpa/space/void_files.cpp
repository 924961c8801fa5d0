#include "space/void_files.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "rbpa/space/surface/split_fans.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t serial = 0;  // index in columns_of_names()
using Corners = std::array<std::uint32_t, 3>;

/// Returns a triangle of the boundary, turned around so that it faces outward from the void.
Corners seen_from_around(const Corners& triangle) { return {triangle[0], triangle[2], triangle[1]}; }

void write_life_csv(OutputFile& file, const VoidLife& life) {
  file.write_all(",", life.closes, ",", life.filled, ",", life.depth);
}

void add_life(Json& json, const VoidLife& life) {
  json["closes"] = life.closes;
  json["filled"] = life.filled;
  json["depth"] = life.depth;
}

void write_csv(OutputFile& file, std::span<const SolidVoid> voids, ComplexKind walls,
               const std::optional<std::vector<VoidLife>>& lives) {
  file.write(volume_columns(walls) + ",area,islands,points,low_x,low_y,low_z,high_x,high_y,high_z");
  file.write(!lives ? "\n" : ",closes,filled,depth\n");
  std::uint64_t number = 0;
  for (const SolidVoid& hollow : voids) {
    write_volumes(file, ++number, hollow.volume, hollow.outside_balls);
    file.write_all(",", hollow.area, ",", hollow.islands, ",", hollow.points.size());
    for (const Point3& p : {hollow.low, hollow.high}) file.write_all(",", p.x, ",", p.y, ",", p.z);
    if (lives) write_life_csv(file, (*lives)[number - 1]);
    file.write("\n");
  }
}

void write_json(OutputFile& file, const PointNames& names, const Surface& boundary, std::span<const SolidVoid> voids,
                const std::optional<std::vector<VoidLife>>& lives) {
  std::size_t number = 0;
  std::string_view before = "[\n";
  for (const SolidVoid& hollow : voids) {
    stop_if_interrupted();
    Json one = json_of(hollow, names);
    if (lives) add_life(one, (*lives)[number]);
    ++number;
    one["triangles"] = Json::array();
    for (const std::uint32_t t : hollow.triangles)
      one["triangles"].push_back(names.indices(seen_from_around(boundary.triangles[t])));
    file.write(before);
    file.write(one.dump());
    before = ",\n";
  }
  file.write(voids.empty() ? "[]\n" : "\n]\n");
}

void write_obj(OutputFile& file, std::span<const Point3> points, const Surface& boundary,
               std::span<const SolidVoid> voids) {
  const SplitFans fans = split_fans(indexable_surface(boundary, until_interrupted()), until_interrupted());
  std::uint64_t written = 0, number = 0;
  for (const SolidVoid& hollow : voids) {
    stop_if_interrupted();
    file.write("g void_" + std::to_string(++number) + "\n");
    std::unordered_map<std::uint32_t, std::uint64_t> vertex;  // number, from 1, of the vertex of each fan
    for (const std::uint32_t t : hollow.triangles)
      for (const std::uint32_t fan : fans.triangles[t]) {
        if (!vertex.try_emplace(fan, written + 1).second) continue;
        ++written;
        const Point3& p = points[fans.point[fan]];
        file.write_all("v ", p.x, " ", p.y, " ", p.z, "\n");
      }
    for (const std::uint32_t t : hollow.triangles) {
      file.write("f");
      for (const std::uint32_t fan : seen_from_around(fans.triangles[t])) file.write_all(" ", vertex.at(fan));
      file.write("\n");
    }
  }
}

}  // namespace

VoidLives::VoidLives(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                     ComplexKind walls, unsigned threads)
    : delaunay_(delaunay),
      radii_(radii),
      tree_(void_tree(points, delaunay, radii, walls, threads, until_interrupted())) {}

std::vector<VoidLife> VoidLives::of(double alpha, const Surface& boundary, std::span<const SolidVoid> voids) const {
  std::vector<VoidLife> lives;
  for (const std::uint32_t node : nodes_of(tree_, delaunay_, radii_, alpha, boundary, voids))
    lives.push_back(life(node));
  return lives;
}

std::vector<Pocket> VoidLives::pockets(double alpha) const {
  std::vector<Pocket> pockets;
  for (std::uint32_t n = 0; n < tree_.nodes.size(); ++n)
    if (tree_.nodes[n].closes > alpha) pockets.push_back({life(n), tree_.nodes[n].volume, tree_.nodes[n].mouth});
  std::stable_sort(pockets.begin(), pockets.end(),
                   [](const Pocket& a, const Pocket& b) { return a.volume > b.volume; });
  return pockets;
}

VoidLife VoidLives::life(std::uint32_t node) const {
  VoidLife life{tree_.nodes[node].closes, tree_.nodes[node].filled, 0};
  for (std::uint32_t n = tree_.nodes[node].parent; n != VoidTree::none; n = tree_.nodes[n].parent) ++life.depth;
  return life;
}

Json json_of(const SolidVoid& hollow, const PointNames& names) {
  const auto corner = [](const Point3& p) { return Json{p.x, p.y, p.z}; };
  Json json = json_of_volumes(hollow.volume, hollow.outside_balls);
  json.update(Json{{"area", hollow.area},
                   {"islands", hollow.islands},
                   {"box", Json::array({corner(hollow.low), corner(hollow.high)})},
                   {"points", names.indices(hollow.points)}});
  if (names.has_any()) json["atoms"] = names.atoms(hollow.points);
  return json;
}

std::string volume_columns(ComplexKind walls) {
  return walls == ComplexKind::full ? "number,volume_between_points,volume_outside_balls"
                                    : "number,volume_between_points";
}

void write_volumes(OutputFile& file, std::uint64_t number, double between_points, std::optional<double> outside_balls) {
  file.write_all(number, ",", between_points);
  if (outside_balls) file.write_all(",", *outside_balls);
}

Json json_of_volumes(double between_points, std::optional<double> outside_balls) {
  Json json = {{"volume_between_points", between_points}};
  if (outside_balls) json["volume_outside_balls"] = *outside_balls;
  return json;
}

void write_voids(OutputFile& file, Format format, const PointNames& names, const Surface& boundary,
                 std::span<const SolidVoid> voids, ComplexKind walls,
                 const std::optional<std::vector<VoidLife>>& lives) {
  if (format == Format::csv) return write_csv(file, voids, walls, lives);
  if (format == Format::json) return write_json(file, names, boundary, voids, lives);
  write_obj(file, names.points(), boundary, voids);
}

void write_pockets(OutputFile& file, Format format, const PointNames& names, std::span<const Pocket> pockets) {
  const bool is_csv = format == Format::csv, has_serials = names.has(serial);
  file.write(is_csv ? "number,volume_between_points,closes,filled,depth,mouth_a,mouth_b,mouth_c" : "[");
  if (is_csv) file.write(has_serials ? ",serial_a,serial_b,serial_c\n" : "\n");
  std::uint64_t number = 0;
  for (const Pocket& pocket : pockets) {
    stop_if_interrupted();
    ++number;
    if (is_csv) {
      file.write_all(number, ",", pocket.volume);
      write_life_csv(file, pocket.life);
      for (const std::uint32_t corner : pocket.mouth) file.write_all(",", names.index(corner));
      for (std::size_t k = 0; has_serials && k < pocket.mouth.size(); ++k)
        file.write("," + names.text(serial, pocket.mouth[k]));
      file.write("\n");
    } else {
      Json one = json_of_volumes(pocket.volume, {});
      add_life(one, pocket.life);
      one["mouth"] = names.indices(pocket.mouth);
      if (names.has_any()) one["mouth_atoms"] = names.atoms(pocket.mouth);
      file.write(number == 1 ? "\n" : ",\n");
      file.write(one.dump());
    }
  }
  if (!is_csv) file.write(number == 0 ? "]\n" : "\n]\n");
}

}  // namespace rbpa::app
