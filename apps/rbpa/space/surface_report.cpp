#include "space/surface_report.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "io/bytes/write_json.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "rbpa/space/repair/watertight.h"
#include "shared/stats.h"
#include "space/surface_repairs.h"
#include "triangulation/choices.h"
#include "triangulation/list_of_causes.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t named_curves = 5;

constexpr std::array rim_names{"nothing_within_reach", "normals_disagree", "blocked", "cut"};
constexpr std::array rim_texts{"with nothing within reach", "where normals disagree",
                               "blocked by triangles of smaller radii", "cut apart where sheets touch"};

/// Returns the index in rim_names of the cause of the edge. An edge was cut apart if `next` has two equal corners.
std::size_t cause_of(const RimEdge& edge) {
  return edge.next[0] == edge.next[1] ? 3 : static_cast<std::size_t>(edge.cause);
}
constexpr std::array unused_names{"no_ball_rests", "hidden", "normals_disagree", "blocked", "given_up"};
constexpr std::array unused_texts{"on which no ball rests", "hidden among others", "where normals disagree",
                                  "blocked by triangles of smaller radii",
                                  "whose triangles were removed to close the surface"};

/// Adds lines about boundary curves: a line for each of the longest curves, rims first; a line for all rims and holes
/// if there are more; and a line for the rims of islands.
void add_curves(std::vector<std::string>& lines, const SurfaceFacts& facts) {
  std::array<std::size_t, kind_names.size()> counts{};
  for (const CurveKind kind : facts.kinds) ++counts[static_cast<std::size_t>(kind)];
  std::vector<std::size_t> curves(facts.holes.size());
  std::iota(curves.begin(), curves.end(), std::size_t{0});
  const auto is_island = [&](std::size_t i) { return facts.kinds[i] == CurveKind::island; };
  std::stable_sort(curves.begin(), curves.end(), [&](std::size_t i, std::size_t j) {
    if (is_island(i) != is_island(j)) return is_island(j);
    return facts.holes[i].length > facts.holes[j].length;
  });
  const std::size_t islands = counts[static_cast<std::size_t>(CurveKind::island)], others = curves.size() - islands,
                    named = std::min(named_curves, others);
  std::stable_sort(curves.begin(), curves.begin() + static_cast<std::ptrdiff_t>(named),
                   [&](std::size_t i, std::size_t j) { return facts.kinds[i] < facts.kinds[j]; });
  const auto add = [&](std::size_t first, std::size_t last, const std::string& which) {
    std::array<std::size_t, 4> causes{};
    std::vector<SuggestedRepair> repairs;
    double length = 0;
    std::size_t edges = 0;
    for (std::size_t i = first; i < last; ++i) {
      const Hole& curve = facts.holes[curves[i]];
      for (const RimEdge& edge : curve.edges) ++causes[cause_of(edge)];
      length += curve.length;
      edges += curve.edges.size();
      if (facts.has_repairs && facts.repairs[curves[i]]) repairs.push_back(*facts.repairs[curves[i]]);
    }
    std::string line = which + (last - first == 1 ? " of length " : " of total length ") + rounded(length, 6) + ": " +
                       counted(edges, "edge") + ", " + list_of_causes(causes, rim_texts);
    if (repairs.size() == 1)
      line += "; " + repair_text(repairs.front(), facts.radii);
    else if (!repairs.empty())
      line += "; " + repairs_text(repairs);
    lines.push_back(line);
  };
  for (std::size_t i = 0; i < named; ++i) add(i, i + 1, kind_names[static_cast<std::size_t>(facts.kinds[curves[i]])]);
  if (others > named) {
    const std::string rims = counted(counts[0], kind_names[0]), holes = counted(counts[1], kind_names[1]);
    add(0, others,
        counts[0] == 0   ? "all " + holes
        : counts[1] == 0 ? "all " + rims
                         : "the " + rims + " and " + holes + " together,");
  }
  if (islands > 0)
    add(others, curves.size(), islands == 1 ? "1 rim of an island" : std::to_string(islands) + " rims of islands");
}

/// Returns a share from 0 to 1 in percent, such as "12.3 %".
std::string percent(double share) { return rounded(100 * share, 3) + " %"; }

Json filled_as_json(const FillingCounts& counts) {
  Json filled = as_json(counts);
  filled["points"] = counts.points;
  filled["smooth"] = counts.smooth;
  return filled;
}

Json base(const SurfaceFacts& facts) {
  const SurfaceCounts& counts = facts.counts;
  Json curves;
  for (std::size_t kind = 0; kind < kind_names.size(); ++kind)
    curves[kind_names[kind]] = std::count(facts.kinds.begin(), facts.kinds.end(), static_cast<CurveKind>(kind));
  std::size_t closed = 0;
  double area = 0;
  for (const SurfaceComponent& component : facts.components.all) {
    closed += component.is_closed();
    area += component.area;  // in the order of the components, so that the sum is reproducible
  }
  const DroppedComponents& dropped = facts.dropped;
  return {{"points", facts.input_points},
          {"distinct", facts.distinct},
          {"unused", facts.unused.size()},
          {"triangles", counts.triangles},
          {"vertices", counts.vertices},
          {"edges", counts.edges},
          {"boundary_curves", counts.boundary_curves},
          {"curves", curves},
          {"components", counts.components},
          {"closed_components", closed},
          {"area", area},
          {"genus", counts.genus},
          {"dropped",
           {{"components", dropped.components},
            {"triangles", dropped.triangles},
            {"points", dropped.points},
            {"area", dropped.area},
            {"genus", dropped.genus},
            {"triangle_share", dropped.triangle_share()},
            {"area_share", dropped.area_share()}}},
          {"filled", filled_as_json(facts.filling)},
          {"decimated", facts.decimated ? app::as_json(*facts.decimated) : Json(nullptr)},
          {"suggested_repairs", facts.has_repairs ? counts_as_json(facts.repairs) : Json(nullptr)},
          {"manifold", facts.manifold},
          {"watertight", facts.watertight ? Json(true) : Json(nullptr)},
          {"non_manifold_edges", facts.non_manifold_edges},
          {"touching_points", counts.touching},
          {"radii", facts.radii},
          {"radius_rule", facts.chosen_radii ? Json("auto") : Json(nullptr)},
          {"normals", facts.normals_name},
          {"normals_in_doubt", facts.in_doubt ? Json(*facts.in_doubt) : Json(nullptr)},
          {"scale_space", facts.scale_space == 0 ? Json(nullptr) : Json(facts.scale_space)},
          {"outliers", facts.outlier_factor ? Json{{"points", facts.outliers.points.size()},
                                                   {"factor", *facts.outlier_factor},
                                                   {"median_distance", facts.outliers.distance}}
                                            : Json(nullptr)}};
}

/// Returns "2 components lie inside others: 1 facing inward, as the wall of a cavity does, 1 facing outward, ...", or
/// nothing if no component lies inside another.
std::optional<std::string> inside_text(const SurfaceFacts& facts) {
  std::array<std::size_t, 2> counts{};
  for (std::size_t i = 0; i < facts.inside.size(); ++i)
    if (facts.inside[i] > 0) ++counts[facts.components.all[i].volume < 0 ? 0 : 1];
  const std::size_t all = counts[0] + counts[1];
  if (all == 0) return std::nullopt;
  constexpr std::array<const char*, 2> texts{"facing inward, as the wall of a cavity does",
                                             "facing outward, a body in a body: --keep-largest 1 leaves it out"};
  return (all == 1 ? "1 component lies inside another: " : std::to_string(all) + " components lie inside others: ") +
         list_of_causes(counts, texts);
}

/// Returns the corners of edge.next, the next triangle that the ball reaches, at which the cause of the edge lies.
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

std::string genus_text(const SurfaceFacts& facts) {
  std::string text = ", genus " + std::to_string(facts.counts.genus);
  const DroppedComponents& dropped = facts.dropped;
  if (dropped.components == 0) return text;
  if (dropped.genus > 0) text += " (" + std::to_string(dropped.of_genus) + " before)";
  return text + ", after " + counted(dropped.components, "component") + (dropped.components == 1 ? " was" : " were") +
         " dropped (" + percent(dropped.triangle_share()) + " of the triangles, " + percent(dropped.area_share()) +
         " of the area)";
}

std::vector<std::string> explanations(const SurfaceFacts& facts) {
  std::vector<std::string> lines;
  if (facts.outlier_factor)
    lines.push_back(counted(facts.outliers.points.size(), "outlier") + " left out: more than " +
                    text_of(*facts.outlier_factor) + " times as far from the 8th nearest point as the median, " +
                    rounded(facts.outliers.distance, 6));
  constexpr double worth_a_word = 0.05;
  const std::size_t estimated = facts.input_points - facts.outliers.points.size();
  if (const double share = static_cast<double>(facts.in_doubt.value_or(0)) / static_cast<double>(estimated);
      estimated > 0 && share >= worth_a_word)
    lines.push_back(percent(share) + " of the normals are in doubt" +
                    (facts.has_viewpoint ? " though seen from --viewpoint" : "") + ": --color normals shows where" +
                    (facts.has_viewpoint ? "" : ", --viewpoint decides their side"));
  if (!facts.unused.empty()) {
    std::array<std::size_t, unused_texts.size()> causes{};
    for (const UnusedPoint& point : facts.unused) ++causes[static_cast<std::size_t>(point.cause)];
    lines.push_back(counted(facts.unused.size(), "point") + " unused: " + list_of_causes(causes, unused_texts));
  }
  add_curves(lines, facts);
  const DroppedComponents& dropped = facts.dropped;
  if (dropped.components > 0)
    lines.push_back(std::to_string(dropped.components) + " of " + counted(dropped.of_components, "component") +
                    " dropped: " + std::to_string(dropped.triangles) + " of " +
                    counted(dropped.of_triangles, "triangle") + " (" + percent(dropped.triangle_share()) +
                    ") of area " + rounded(dropped.area, 6) + " (" + percent(dropped.area_share()) + "), of genus " +
                    std::to_string(dropped.genus) + ", and " + counted(dropped.points, "point") +
                    " left without a triangle");
  const FillingCounts& filling = facts.filling;
  if (filling.filled() > 0) lines.push_back(filled_text(filling));
  if (filling.given_up > 0)
    lines.push_back(counted(filling.given_up, "triangle") + " around holes removed, so that these can be filled");
  if (filling.left() > 0) lines.push_back(left_text(filling));
  if (facts.decimated) lines.push_back(decimated_text(*facts.decimated));
  if (facts.watertight) {
    lines.push_back("watertight: every edge has two triangles, and no two triangles cross" +
                    (facts.counts.touching == 0 ? std::string()
                                                : "; it touches itself in " + counted(facts.counts.touching, "point")));
    if (const auto inside = inside_text(facts)) lines.push_back(*inside);
    if (facts.components.all.front().volume < 0)
      lines.push_back("the largest component faces inward (--flip turns it around)");
  }
  if (facts.non_manifold_edges > 0)
    lines.push_back(counted(facts.non_manifold_edges, "non-manifold edge") +
                    ", with more than two triangles (--manifold splits their vertices)");
  return lines;
}

std::string why_empty(const SurfaceFacts& facts) {
  std::string why = "the ball rests on no three points at any of the tried radii";
  if (facts.dropped.components > 0)
    why = counted(facts.dropped.components, "component") + " dropped, and none kept";
  else if (facts.distinct < 3)
    why = "fewer than three distinct points";
  else if (facts.larger_ball)
    why = "with --radius " + text_of(*facts.larger_ball) + " there would be some";
  else if (facts.radii.empty())
    why = "all points are on a line";
  return "there is no triangle: " + why;
}

std::string openings(const SurfaceFacts& facts) {
  const auto& triangles = facts.surface.triangles;
  const auto& crossing = facts.crossing;
  const auto place = [&](std::uint32_t i) {
    const Point3& p = facts.points[i];
    return rounded(p.x, 6) + ", " + rounded(p.y, 6) + ", " + rounded(p.z, 6);
  };
  std::string text;
  if (triangles.empty()) text = "there is no triangle";
  if (!facts.holes.empty()) {
    const auto longest = std::max_element(facts.holes.begin(), facts.holes.end(),
                                          [](const Hole& a, const Hole& b) { return a.length < b.length; });
    text = counted(facts.holes.size(), "boundary curve") + " left" +
           (facts.filling.left() > 0 ? ", " + left_text(facts.filling) : "") + ", the longest of length " +
           rounded(longest->length, 6) + " with " + counted(longest->edges.size(), "edge") + " at " +
           place(longest->edges.front().from);
  }
  if (!crossing.empty()) {
    const auto [t, u] = crossing.front();
    const auto corners = [&](std::uint32_t triangle) {
      const auto& c = triangles[triangle];
      return "(" + std::to_string(c[0]) + " " + std::to_string(c[1]) + " " + std::to_string(c[2]) + ")";
    };
    text += (text.empty() ? "" : "; ") + std::string(crossing.size() < most_crossing_pairs ? "" : "at least ") +
            counted(crossing.size(), "pair") + " of triangles cross, the first of points " + corners(t) + " and " +
            corners(u) + " at " + place(triangles[t][0]);
  }
  return text;
}

void write_surface_stats(OutputFile& file, const SurfaceFacts& facts) {
  write_stats(file, base(facts), facts.threads,
              {{"read", facts.read_seconds},
               {"normals", facts.normals_seconds},
               {"build", facts.build_seconds},
               {"write", facts.write_seconds}});
}

void write_surface_json(OutputFile& file, const SurfaceFacts& facts) {
  Json report = base(facts);
  report["unused_points"] = Json::array();
  for (const UnusedPoint& point : facts.unused) {
    stop_if_interrupted();
    report["unused_points"].push_back(
        {{"point", point.index}, {"cause", unused_names[static_cast<std::size_t>(point.cause)]}});
  }
  if (facts.outlier_factor) report["outlier_points"] = facts.outliers.points;
  report["component_list"] = Json::array();
  for (std::size_t i = 0; i < facts.components.all.size(); ++i) {
    stop_if_interrupted();
    const SurfaceComponent& component = facts.components.all[i];
    const Point3 &low = component.low, &high = component.high;
    report["component_list"].push_back({{"triangles", component.triangles},
                                        {"boundary_curves", component.boundary_curves},
                                        {"area", component.area},
                                        {"volume", component.is_closed() ? Json(component.volume) : Json(nullptr)},
                                        {"inside", facts.inside.empty() ? Json(nullptr) : Json(facts.inside[i])},
                                        {"box", {{low.x, low.y, low.z}, {high.x, high.y, high.z}}}});
  }
  report["holes"] = Json::array();
  for (std::size_t i = 0; i < facts.holes.size(); ++i) {
    const Hole& hole = facts.holes[i];
    stop_if_interrupted();
    Json edges = Json::array();
    for (const RimEdge& edge : hole.edges)
      edges.push_back({{"from", edge.from},
                       {"to", edge.to},
                       {"radius", facts.radii.at(edge.level)},
                       {"cause", rim_names[cause_of(edge)]},
                       {"next", cause_of(edge) == 3 ? Json(nullptr) : Json(edge.next)},
                       {"at", corners_of(edge)}});
    report["holes"].push_back({{"kind", kind_names[static_cast<std::size_t>(facts.kinds[i])]},
                               {"length", hole.length},
                               {"points", hole.edges.size()},
                               {"edges", edges}});
    if (facts.has_repairs)
      report["holes"].back()["suggested_repair"] = facts.repairs[i] ? as_json(*facts.repairs[i]) : Json(nullptr);
  }
  write_json(file, report, 1);
}

}  // namespace rbpa::app
