#include "space/solid_report.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "io/bytes/write_json.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "shared/stats.h"
#include "space/void_files.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;

Json base(const SolidFacts& facts) {
  const SolidCounts& counts = facts.counts;
  Json report = {{"points", facts.points},
                 {"distinct", facts.distinct},
                 {"isolated", facts.isolated},
                 {"alpha", std::isinf(facts.alpha) ? Json("inf") : Json(facts.alpha)},
                 {"alpha_rule", facts.alpha_rule},
                 {"tetrahedra", counts.tetrahedra},
                 {"triangles", counts.triangles},
                 {"edges", counts.edges},
                 {"boundary_triangles", counts.boundary_triangles},
                 {"solid_components", counts.solid_components},
                 {"betti", {counts.components, counts.tunnels, counts.voids}},
                 {"volume", facts.measures.volume},
                 {"area", facts.measures.area}};
  if (facts.full)
    report["full"] = {{"points", facts.full->points},
                      {"edges", facts.full->edges},
                      {"triangles", facts.full->triangles},
                      {"betti", {facts.full->components, facts.full->tunnels, facts.full->voids}}};
  if (facts.balls) report["balls"] = {{"volume", facts.balls->volume}, {"area", facts.balls->area}};
  return report;
}

Json box_of(const Point3& low, const Point3& high) { return {{low.x, low.y, low.z}, {high.x, high.y, high.z}}; }

Json base(const PeriodicFacts& facts) {
  const PeriodicTopology& topology = *facts.topology;
  return {{"points", facts.points},
          {"distinct", facts.distinct},
          {"isolated", facts.isolated},
          {"box", {facts.box.x, facts.box.y, facts.box.z}},
          {"alpha", std::isinf(facts.alpha) ? Json("inf") : Json(facts.alpha)},
          {"alpha_rule", facts.alpha_rule},
          {"complex", facts.walls == ComplexKind::full ? "full" : "solid"},
          {"tetrahedra", topology.tetrahedra},
          {"triangles", topology.triangles},
          {"edges", topology.edges},
          {"boundary_triangles", topology.boundary_triangles},
          {"solid_components", topology.solid_components.size()},
          {"voids", topology.voids.size()},
          {"betti", topology.betti},
          {"volume", topology.volume},
          {"area", topology.area}};
}

Json json_of(const PeriodicPart& part, bool is_void, const PointNames& names) {
  Json json = is_void ? json_of_volumes(part.volume, part.outside_balls) : Json{{"volume", part.volume}};
  json.update(Json{{"area", part.area},
                   {"dimension", part.dimension},
                   {"tetrahedra", part.tetrahedra},
                   {"points", names.indices(part.points)}});
  if (names.has_any()) json["atoms"] = names.atoms(part.points);
  return json;
}

}  // namespace

std::string text_of_solid(const SolidFacts& facts) {
  const SolidCounts& counts = facts.counts;
  return std::to_string(counts.tetrahedra) + (counts.tetrahedra == 1 ? " tetrahedron, " : " tetrahedra, ") +
         counted(counts.solid_components, "solid component") + ", " + counted(counts.tunnels, "tunnel") + ", " +
         counted(counts.voids, "void") + ", volume " + rounded(facts.measures.volume, 6) + ", area " +
         rounded(facts.measures.area, 6) +
         (facts.full ? "; full complex: " + counted(facts.full->components, "component") + ", " +
                           counted(facts.full->tunnels, "tunnel") + ", " + counted(facts.full->voids, "void")
                     : "") +
         (facts.balls ? "; union of balls: volume " + rounded(facts.balls->volume, 6) + ", area " +
                            rounded(facts.balls->area, 6)
                      : "");
}

void write_solid_stats(OutputFile& file, const SolidFacts& facts) {
  write_stats(file, base(facts), facts.threads,
              {{"read", facts.read_seconds},
               {"build", facts.build_seconds},
               {"choose", facts.choose_seconds ? Json(*facts.choose_seconds) : Json()},
               {"count", facts.count_seconds},
               {"write", facts.write_seconds}});
}

void write_solid_json(OutputFile& file, const SolidFacts& facts, const PointNames& names) {
  Json report = base(facts);
  report["solid_component_list"] = Json::array();
  for (const SolidComponent& component : facts.components) {
    stop_if_interrupted();
    report["solid_component_list"].push_back({{"tetrahedra", component.tetrahedra},
                                              {"boundary_triangles", component.boundary_triangles},
                                              {"volume", component.volume},
                                              {"area", component.area},
                                              {"box", box_of(component.low, component.high)}});
  }
  report["void_complex"] = facts.walls == ComplexKind::full ? "full" : "solid";
  report["void_list"] = Json::array();
  for (const SolidVoid& hollow : facts.voids) {
    stop_if_interrupted();
    report["void_list"].push_back(json_of(hollow, names));
  }
  write_json(file, report, 1);
}

std::string text_of_voids(const std::array<std::size_t, 4>& count) {
  std::string text = counted(count[0], "closed void");
  if (count[1] + count[2] + count[3] == 0) return text + ", 0 voids that percolate";
  for (std::size_t d = 1; d < count.size(); ++d)
    if (count[d] > 0)
      text += ", " + counted(count[d], "void") + (count[d] == 1 ? " that percolates in " : " that percolate in ") +
              counted(d, "direction");
  return text;
}

std::string text_of_periodic(const PeriodicFacts& facts) {
  const PeriodicTopology& topology = *facts.topology;
  std::array<std::size_t, 4> voids{};
  for (const PeriodicPart& part : topology.voids) ++voids[part.dimension];
  return std::to_string(topology.tetrahedra) + (topology.tetrahedra == 1 ? " tetrahedron, " : " tetrahedra, ") +
         counted(topology.solid_components.size(), "solid component") + ", " + text_of_voids(voids) + ", volume " +
         rounded(topology.volume, 6) + ", area " + rounded(topology.area, 6) + " (voids of the " +
         (facts.walls == ComplexKind::full ? "full complex)" : "solid)");
}

void write_periodic_stats(OutputFile& file, const PeriodicFacts& facts) {
  write_stats(file, base(facts), facts.threads,
              {{"read", facts.read_seconds},
               {"build", facts.build_seconds},
               {"count", facts.count_seconds},
               {"write", facts.write_seconds}});
}

void write_periodic_json(OutputFile& file, const PeriodicFacts& facts, const PointNames& names) {
  Json report = base(facts);
  for (const auto& [key, parts] : {std::pair{"solid_component_list", &facts.topology->solid_components},
                                   std::pair{"void_list", &facts.topology->voids}}) {
    report[key] = Json::array();
    for (const PeriodicPart& part : *parts)
      report[key].push_back(json_of(part, parts == &facts.topology->voids, names));
  }
  write_json(file, report, 1);
}

void write_periodic_voids(OutputFile& file, Format format, const PointNames& names, const PeriodicFacts& facts) {
  const std::vector<PeriodicPart>& voids = facts.topology->voids;
  if (format == Format::json) {
    std::string before = "[\n";
    for (const PeriodicPart& part : voids) {
      stop_if_interrupted();
      file.write(before + json_of(part, true, names).dump());
      before = ",\n";
    }
    return file.write(voids.empty() ? "[]\n" : "\n]\n");
  }
  file.write(volume_columns(facts.walls) + ",area,dimension,tetrahedra,points\n");
  std::uint64_t number = 0;
  for (const PeriodicPart& part : voids) {
    write_volumes(file, ++number, part.volume, part.outside_balls);
    file.write_all(",", part.area, ",", part.dimension, ",", part.tetrahedra, ",", part.points.size(), "\n");
  }
}

}  // namespace rbpa::app
