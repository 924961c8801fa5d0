#include "space/solid_report.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

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
  Json report = base(facts);
  report["threads"] = facts.threads;
  report["seconds"] = {{"read", facts.read_seconds},
                       {"build", facts.build_seconds},
                       {"choose", facts.choose_seconds ? Json(*facts.choose_seconds) : Json()},
                       {"count", facts.count_seconds},
                       {"write", facts.write_seconds}};
  report["peak_bytes"] = peak_bytes();
  write_json(file, report, 2);
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

}  // namespace rbpa::app
