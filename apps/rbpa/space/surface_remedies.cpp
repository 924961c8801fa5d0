#include "space/surface_remedies.h"

#include <nlohmann/json.hpp>

#include "io/bytes/number.h"
#include "io/failure.h"
#include "triangulation/filling_counts.h"
#include "triangulation/list_of_causes.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;

// Names and texts by RemedyKind.
constexpr std::array names{"none", "turn_normals", "larger_ball", "filling"};
constexpr std::array<const char*, 4> texts{"by nothing", "with normals turned around", "by one more radius each",
                                           "by --fill-holes"};

std::string text_of_nothing(const HoleRemedy& remedy) {
  switch (remedy.filled.value_or(HoleOutcome::filled)) {
    case HoleOutcome::crosses:
      return "nothing closes it: each filling crosses";
    case HoleOutcome::edge_taken:
      return "nothing closes it: each filling has an edge that already has two triangles";
    case HoleOutcome::no_area:
      return "nothing closes it: its points are on a line";
    case HoleOutcome::too_much_work:
      return "nothing closes it: its surroundings exceed the limit of work";
    case HoleOutcome::filled:
      break;
  }
  return "nothing closes it as it is";
}

}  // namespace

SurfaceRemedies::Key SurfaceRemedies::key_of(const Hole& curve) {
  return {curve.edges.front().from, curve.edges.front().to, curve.edges.size()};
}

SurfaceRemedies::SurfaceRemedies(std::span<const Hole> holes, std::span<const HoleRemedy> remedies) {
  for (std::size_t i = 0; i < holes.size(); ++i) remedies_.emplace(key_of(holes[i]), remedies[i]);
}

std::vector<std::optional<HoleRemedy>> SurfaceRemedies::of(std::span<const Hole> curves,
                                                           std::span<const CurveKind> kinds) const {
  std::vector<std::optional<HoleRemedy>> result(curves.size());
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (kinds[i] != CurveKind::hole) continue;
    const auto found = remedies_.find(key_of(curves[i]));
    result[i] = found != remedies_.end() ? found->second : HoleRemedy{};
  }
  return result;
}

std::string remedy_text(const HoleRemedy& remedy, const std::vector<double>& radii) {
  switch (remedy.kind) {
    case RemedyKind::turn_normals:
      return remedy.points.size() == 1
                 ? "closed with the normal of point " + std::to_string(remedy.points.front()) + " turned around"
                 : "closed with the normals of " + counted(remedy.points.size(), "point") + " turned around";
    case RemedyKind::larger_ball: {
      std::string list;
      for (const double radius : radii) list += text_of(radius) + ",";
      return "closed by --radius " + list + text_of(remedy.radius);
    }
    case RemedyKind::filling:
      return "closed by --fill-holes";
    case RemedyKind::none:
      break;
  }
  return text_of_nothing(remedy);
}

std::string remedies_text(std::span<const HoleRemedy> remedies) {
  std::array<std::size_t, 4> counts{};
  for (const HoleRemedy& remedy : remedies) ++counts[static_cast<std::size_t>(remedy.kind)];
  return "closed: " + list_of_causes(counts, texts);
}

Json as_json(const HoleRemedy& remedy) {
  Json result = {{"kind", names[static_cast<std::size_t>(remedy.kind)]}};
  if (remedy.kind == RemedyKind::larger_ball) result["radius"] = remedy.radius;
  if (remedy.kind == RemedyKind::turn_normals) result["points"] = remedy.points;
  if (remedy.kind == RemedyKind::none)
    result["filling"] = remedy.filled ? Json(outcome_names[static_cast<std::size_t>(*remedy.filled)]) : Json(nullptr);
  return result;
}

Json counts_as_json(const std::vector<std::optional<HoleRemedy>>& remedies) {
  std::array<std::size_t, 4> counts{};
  for (const auto& remedy : remedies)
    if (remedy) ++counts[static_cast<std::size_t>(remedy->kind)];
  Json result;
  for (const RemedyKind kind :
       {RemedyKind::turn_normals, RemedyKind::larger_ball, RemedyKind::filling, RemedyKind::none})
    result[names[static_cast<std::size_t>(kind)]] = counts[static_cast<std::size_t>(kind)];
  return result;
}

}  // namespace rbpa::app
