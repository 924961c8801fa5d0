#include "shared/representative_files.h"

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/mesh/vtu.h"
#include "io/number.h"
#include "io/polygon/write_shapes.h"
#include "io/values_at.h"
#include "rbpa/plane/triangles_by_level.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t top_unless_said = 100;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

/// Writes the elements of a JSON list with separators between them.
class Between {
 public:
  explicit Between(OutputFile& file) : file_(file) {}
  void operator()(const Json& json) {
    stop_if_interrupted();
    file_.write(before_);
    file_.write(json.dump());
    before_ = ",\n";
  }
  bool is_empty() const { return before_ == "\n"; }

 private:
  OutputFile& file_;
  std::string_view before_ = "\n";
};

/// Returns a GeoJSON geometry of `type`, or of the corresponding Multi type unless there is exactly one part.
Json geometry(const std::string& type, const std::vector<Json>& parts) {
  if (parts.size() == 1) return {{"type", type}, {"coordinates", parts.front()}};
  return {{"type", "Multi" + type}, {"coordinates", parts}};
}

Json coordinates(const std::vector<Point3>& line) {
  Json list = Json::array();
  for (const Point3& p : line) list.push_back({p.x, p.y});
  return list;
}

Json geometry(std::span<const Point> points, const Polygon& polygon, bool cuts) {
  std::vector<PositionRing> rings;
  const auto add = [&](const Ring& ring) {
    rings.emplace_back();
    for (const std::uint32_t i : ring.points) rings.back().push_back({points[i].x, points[i].y, 0});
  };
  add(polygon.shell);
  for (const Ring& hole : polygon.holes) add(hole);
  std::vector<std::vector<PositionRing>> all = {rings};
  if (cuts) all = within_antimeridian(rings);
  std::vector<Json> parts;
  for (std::vector<PositionRing>& part : all) {
    Json& closed = parts.emplace_back(Json::array());
    for (PositionRing& ring : part) {
      ring.push_back(ring.front());
      closed.push_back(coordinates(ring));
    }
  }
  return geometry("Polygon", parts);
}

Json polygon_feature(std::span<const Point> points, std::size_t number, const PersistencePair& pair, const char* when,
                     const Polygon& polygon, bool cuts) {
  std::vector<std::uint32_t> indices = polygon.shell.points;
  for (const Ring& hole : polygon.holes) indices.insert(indices.end(), hole.points.begin(), hole.points.end());
  return {{"type", "Feature"},
          {"properties",
           {{"pair", number},
            {"dimension", 1},
            {"birth", pair.birth},
            {"death", or_null(pair.death)},
            {"when", when},
            {"area", polygon.area},
            {"points", indices}}},
          {"geometry", geometry(points, polygon, cuts)}};
}

Json line_feature(std::span<const Point> points, std::size_t number, const PersistencePair& pair,
                  const std::array<std::uint32_t, 2>& edge, bool cuts) {
  const Point3 a{points[edge[0]].x, points[edge[0]].y, 0}, b{points[edge[1]].x, points[edge[1]].y, 0};
  std::vector<Json> parts;
  for (const std::vector<Point3>& part : cuts ? within_antimeridian(a, b) : std::vector<std::vector<Point3>>{{a, b}})
    parts.push_back(coordinates(part));
  return {
      {"type", "Feature"},
      {"properties",
       {{"pair", number}, {"dimension", 0}, {"birth", pair.birth}, {"death", or_null(pair.death)}, {"points", edge}}},
      {"geometry", geometry("LineString", parts)}};
}

void write_json(OutputFile& file, const SpaceRepresentatives& all) {
  file.write("[");
  Between write(file);
  for (std::size_t i = 0; i < all.pairs.size(); ++i) {
    const SolidPair& pair = all.pairs[i];
    const SolidRepresentative& of = all.of_pairs[i];
    Json one = {{"dimension", pair.dimension}, {"birth", pair.birth}, {"death", or_null(pair.death)}};
    if (pair.dimension == 2) {
      one["volume"] = of.volume;
      one["area"] = of.area;
      one["triangles"] = renumbered(of.faces, all.index);
    } else {
      one["length"] = of.length;
      if (pair.dimension == 1) one["is_shortest"] = of.is_shortest;
      one["edges"] = Json::array();
      for (const std::uint32_t edge : of.cells)
        one["edges"].push_back(renumbered(all.filtration.edges[edge], all.index));
    }
    write(one);
  }
  file.write(write.is_empty() ? "]\n" : "\n]\n");
}

/// Writes the vertices of one group after another. The vertices of the file are numbered from 1, in the order in which
/// the groups use them.
class Vertices {
 public:
  Vertices(OutputFile& file, std::span<const Point3> points) : file_(file), points_(points) {}

  void begin() { number_.clear(); }
  void add(std::uint32_t point) {
    if (!number_.try_emplace(point, written_ + 1).second) return;
    ++written_;
    const Point3& p = points_[point];
    file_.write("v");
    for (const double value : {p.x, p.y, p.z}) {
      file_.write(" ");
      file_.write_number(value);
    }
    file_.write("\n");
  }
  std::uint64_t number(std::uint32_t point) const { return number_.at(point); }

 private:
  OutputFile& file_;
  std::span<const Point3> points_;
  std::unordered_map<std::uint32_t, std::uint64_t> number_;
  std::uint64_t written_ = 0;
};

template <typename Cells>
void write_cells(OutputFile& file, const char* sign, const Cells& cells, Vertices& vertices) {
  for (const auto& cell : cells)
    for (const std::uint32_t point : cell) vertices.add(point);
  for (const auto& cell : cells) {
    file.write(sign);
    for (const std::uint32_t point : cell) file.write_all(" ", vertices.number(point));
    file.write("\n");
  }
}

std::vector<std::array<std::uint32_t, 2>> edges_of(const SpaceRepresentatives& all, std::size_t i) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const std::uint32_t edge : all.of_pairs[i].cells) edges.push_back(all.filtration.edges[edge]);
  return edges;
}

void write_obj(OutputFile& file, const SpaceRepresentatives& all) {
  constexpr std::array<const char*, 3> names = {"component", "tunnel", "void"};
  std::array<std::size_t, 3> count = {0, 0, 0};
  Vertices vertices(file, all.points);
  for (std::size_t i = 0; i < all.pairs.size(); ++i) {
    stop_if_interrupted();
    const auto dimension = static_cast<std::size_t>(all.pairs[i].dimension);
    if (all.of_pairs[i].cells.empty()) continue;  // a component that never ends has no cells
    file.write("g " + std::string(names[dimension]) + "_" + std::to_string(++count[dimension]) + "\n");
    vertices.begin();
    if (dimension == 2)
      write_cells(file, "f", all.of_pairs[i].faces, vertices);
    else
      write_cells(file, "l", edges_of(all, i), vertices);
  }
}

void write_vtu(OutputFile& file, const SpaceRepresentatives& all) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::size_t> pairs, pairs_of_edges;  // the pair of each cell, triangles first
  for (std::size_t i = 0; i < all.pairs.size(); ++i) {
    if (all.pairs[i].dimension == 2) {
      triangles.insert(triangles.end(), all.of_pairs[i].faces.begin(), all.of_pairs[i].faces.end());
      pairs.resize(triangles.size(), i);
    } else {
      for (const auto& edge : edges_of(all, i)) edges.push_back(edge);
      pairs_of_edges.resize(edges.size(), i);
    }
  }
  pairs.insert(pairs.end(), pairs_of_edges.begin(), pairs_of_edges.end());
  const std::span<const std::size_t> rows = pairs;
  const auto number = [](auto of_pair) {
    return [of_pair](std::size_t i) { return static_cast<std::uint32_t>(of_pair(i)); };
  };
  VtuGrid grid{.positions = vtu_positions(all.points), .triangles = triangles, .edges = edges};
  grid.of_cells = {vtu_array("pair", rows, number([](std::size_t i) { return i + 1; })),
                   vtu_array("dimension", rows, number([&](std::size_t i) { return all.pairs[i].dimension; })),
                   vtu_array("birth", rows, [&](std::size_t i) { return all.pairs[i].birth; }),
                   // every pair with cells ends
                   vtu_array("death", rows, [&](std::size_t i) { return *all.pairs[i].death; })};
  write_vtu(file, grid);
}

}  // namespace

std::optional<RepresentativeRequest> parse_representatives(const RepresentativeArguments& arguments, bool in_space) {
  if (!arguments.representatives) {
    refuse_given({{arguments.top.has_value(), "--top"},
                  {arguments.min_persistence.has_value(), "--min-persistence"},
                  {arguments.levels.has_value(), "--levels"}},
                 "requires --representatives");
    return std::nullopt;
  }
  const std::string& path = *arguments.representatives;
  const auto is_geojson = [](Format format) { return format == Format::geojson; };
  RepresentativeRequest request{.target = in_space ? target_of("--representatives", path, Use::cycles)
                                                   : target_of("--representatives", path, Use::triangles, is_geojson),
                                .choice = {},
                                .levels = {},
                                .leaf_capacity = {}};
  if (arguments.levels && in_space) throw WrongUsage("--levels applies only to --dimension 2");
  if (constexpr std::string_view with_capacity = "hrbpa:";
      arguments.levels && arguments.levels->starts_with(with_capacity))
    request.leaf_capacity =
        parse_whole("--levels hrbpa:K", arguments.levels->substr(with_capacity.size()), {.least = 1}, "points");
  else if (arguments.levels == "hrbpa")
    request.leaf_capacity = usual_leaf_capacity;
  else if (arguments.levels)
    request.levels = parse_ascending("--levels", *arguments.levels,
                                     "hrbpa or hrbpa:K, the radii of the levels of rbpa mesh --method hrbpa");
  if (arguments.min_persistence)
    request.choice.min_persistence =
        parse_real("--min-persistence", *arguments.min_persistence, {}, "a length, at least 0");
  if (arguments.top)
    request.choice.top = parse_whole("--top", *arguments.top, {.least = 1});
  else if (!arguments.min_persistence)
    request.choice.top = top_unless_said;
  return request;
}

void write_representatives(OutputFile& file, std::span<const Point> points, const std::optional<Crs>& crs, bool degrees,
                           std::span<const Representative> representatives, std::span<const std::uint32_t> index) {
  file.write(geojson_collection(crs));
  const bool cuts = is_cut_in_geojson(points, crs, degrees);
  const auto numbered = [&](Json feature) {
    Json& numbers = feature["properties"]["points"];
    numbers = renumbered(numbers.get<std::vector<std::uint32_t>>(), index);
    return feature;
  };
  Between write(file);
  std::size_t number = 0;
  for (const Representative& one : representatives) {
    ++number;
    if (one.pair.dimension == 1) {
      write(numbered(polygon_feature(points, number, one.pair, "birth", one.at_birth, cuts)));
      write(numbered(polygon_feature(points, number, one.pair, "death", one.before_death, cuts)));
    } else if (one.joined_at) {
      write(numbered(line_feature(points, number, one.pair, *one.joined_at, cuts)));
    }
  }
  file.write("\n]}\n");
}

void write_representatives(OutputFile& file, Format format, const SpaceRepresentatives& all) {
  if (format == Format::json) return write_json(file, all);
  if (format == Format::obj) return write_obj(file, all);
  write_vtu(file, all);
}

}  // namespace rbpa::app
