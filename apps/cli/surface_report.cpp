#include "cli/surface_report.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <numeric>

#include "cli/stats.h"
#include "io/bytes/number.h"
#include "io/failure.h"
#include "io/interrupt.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t named_holes = 10;

constexpr std::array rim_names{"nothing_within_reach", "normals_disagree", "blocked"};
constexpr std::array rim_texts{"with nothing within reach", "where normals disagree",
                               "blocked by what smaller radii made"};
constexpr std::array unused_names{"no_ball_rests", "hidden", "normals_disagree", "blocked"};
constexpr std::array unused_texts{"on which no ball rests", "hidden among others", "where normals disagree",
                                  "blocked by what smaller radii made"};

/// "3 where ..., 2 ..." of the counts that are not 0, the greatest first.
template <std::size_t n>
std::string list_of_causes(const std::array<std::size_t, n>& counts, const std::array<const char*, n>& texts) {
  std::array<std::size_t, n> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return counts[a] > counts[b]; });
  std::string text;
  for (const std::size_t i : order) {
    if (counts[i] == 0) break;
    if (!text.empty()) text += ", ";
    text += std::to_string(counts[i]) + " " + texts[i];
  }
  return text;
}

Json base(const SurfaceFacts& facts) {
  const SurfaceCounts& counts = facts.counts;
  return {{"points", facts.points},
          {"distinct", facts.distinct},
          {"unused", facts.unused.size()},
          {"triangles", counts.triangles},
          {"vertices", counts.vertices},
          {"edges", counts.edges},
          {"boundary_curves", counts.boundary_curves},
          {"components", counts.components},
          {"genus", counts.genus},
          {"radii", facts.radii},
          {"radius_rule", facts.chosen_radii ? Json("auto") : Json(nullptr)},
          {"normals", facts.normals}};
}

/// At which of the three corners to which the ball comes the cause is.
Json corners_of(const RimEdge& edge) {
  Json corners = Json::array();
  for (std::size_t k = 0; k < 3; ++k)
    if (edge.corners[k]) corners.push_back(edge.next[k]);
  return corners;
}

}  // namespace

std::string text_of_radii(const std::vector<double>& radii) {
  std::string text;
  for (const double radius : radii) text += (text.empty() ? "" : ", ") + text_of(radius);
  return text;
}

std::vector<std::string> explanations(const SurfaceFacts& facts) {
  std::vector<std::string> lines;
  if (!facts.unused.empty()) {
    std::array<std::size_t, 4> causes{};
    for (const UnusedPoint& point : facts.unused) ++causes[static_cast<std::size_t>(point.cause)];
    lines.push_back(counted(facts.unused.size(), "point") + " unused: " + list_of_causes(causes, unused_texts));
  }
  std::vector<const Hole*> holes;
  for (const Hole& hole : facts.holes) holes.push_back(&hole);
  std::stable_sort(holes.begin(), holes.end(), [](const Hole* a, const Hole* b) { return a->length > b->length; });
  const auto add_holes = [&](std::size_t first, std::size_t last, const std::string& which) {
    std::array<std::size_t, 3> causes{};
    double length = 0;
    std::size_t edges = 0;
    for (std::size_t i = first; i < last; ++i) {
      for (const RimEdge& edge : holes[i]->edges) ++causes[static_cast<std::size_t>(edge.cause)];
      length += holes[i]->length;
      edges += holes[i]->edges.size();
    }
    lines.push_back(which + " of length " + rounded(length, 6) + ", " + counted(edges, "edge") + ": " +
                    list_of_causes(causes, rim_texts));
  };
  for (std::size_t i = 0; i < std::min(named_holes, holes.size()); ++i) add_holes(i, i + 1, "hole");
  if (holes.size() > named_holes)
    add_holes(named_holes, holes.size(), counted(holes.size() - named_holes, "more hole"));
  return lines;
}

void write_surface_stats(OutputFile& file, const SurfaceFacts& facts) {
  Json report = base(facts);
  report["threads"] = facts.threads;
  report["seconds"] = {{"read", facts.read_seconds},
                       {"normals", facts.normals_seconds},
                       {"build", facts.build_seconds},
                       {"write", facts.write_seconds}};
  report["peak_bytes"] = peak_bytes();
  file.write(report.dump(2) + "\n");
}

void write_surface_json(OutputFile& file, const SurfaceFacts& facts) {
  Json report = base(facts);
  report["unused_points"] = Json::array();
  for (const UnusedPoint& point : facts.unused)
    report["unused_points"].push_back(
        {{"point", point.index}, {"cause", unused_names[static_cast<std::size_t>(point.cause)]}});
  report["holes"] = Json::array();
  for (const Hole& hole : facts.holes) {
    stop_if_interrupted();
    Json edges = Json::array();
    for (const RimEdge& edge : hole.edges)
      edges.push_back({{"from", edge.from},
                       {"to", edge.to},
                       {"radius", facts.radii.at(edge.level)},
                       {"cause", rim_names[static_cast<std::size_t>(edge.cause)]},
                       {"next", edge.next},
                       {"at", corners_of(edge)}});
    report["holes"].push_back({{"length", hole.length}, {"points", hole.edges.size()}, {"edges", edges}});
  }
  file.write(report.dump(1) + "\n");
}

}  // namespace rbpa::app
