#include "space/surface_repairs.h"

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>

#include "io/failure.h"
#include "io/number.h"
#include "triangulation/filling_counts.h"
#include "triangulation/list_of_causes.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;

// Names and texts of repairs, indexed by SuggestedRepairKind.
constexpr std::array repair_names{"none", "turn_normals", "larger_ball", "filling"};
constexpr std::array<const char*, 4> texts{"by nothing", "with normals turned around", "by one more radius each",
                                           "by --fill-holes"};

std::string text_of_nothing(const SuggestedRepair& repair) {
  switch (repair.filled.value_or(HoleOutcome::filled)) {
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

std::string repair_text(const SuggestedRepair& repair, const std::vector<double>& radii) {
  switch (repair.kind) {
    case SuggestedRepairKind::turn_normals:
      return repair.points.size() == 1
                 ? "closed with the normal of point " + std::to_string(repair.points.front()) + " turned around"
                 : "closed with the normals of " + counted(repair.points.size(), "point") + " turned around";
    case SuggestedRepairKind::larger_ball: {
      std::string list;
      for (const double radius : radii) list += text_of(radius) + ",";
      return "closed by --radius " + list + text_of(repair.radius);
    }
    case SuggestedRepairKind::filling:
      return "closed by --fill-holes";
    case SuggestedRepairKind::none:
      break;
  }
  return text_of_nothing(repair);
}

std::string repairs_text(std::span<const SuggestedRepair> repairs) {
  std::array<std::size_t, 4> counts{};
  for (const SuggestedRepair& repair : repairs) ++counts[static_cast<std::size_t>(repair.kind)];
  return "closed: " + list_of_causes(counts, texts);
}

Json as_json(const SuggestedRepair& repair) {
  Json result = {{"kind", repair_names[static_cast<std::size_t>(repair.kind)]}};
  if (repair.kind == SuggestedRepairKind::larger_ball) result["radius"] = repair.radius;
  if (repair.kind == SuggestedRepairKind::turn_normals) result["points"] = repair.points;
  if (repair.kind == SuggestedRepairKind::none)
    result["filling"] = repair.filled ? Json(outcome_names[static_cast<std::size_t>(*repair.filled)]) : Json(nullptr);
  return result;
}

Json counts_as_json(const std::vector<std::optional<SuggestedRepair>>& repairs) {
  std::array<std::size_t, 4> counts{};
  for (const auto& repair : repairs)
    if (repair) ++counts[static_cast<std::size_t>(repair->kind)];
  Json result;
  for (const SuggestedRepairKind kind : {SuggestedRepairKind::turn_normals, SuggestedRepairKind::larger_ball,
                                         SuggestedRepairKind::filling, SuggestedRepairKind::none})
    result[repair_names[static_cast<std::size_t>(kind)]] = counts[static_cast<std::size_t>(kind)];
  return result;
}

}  // namespace rbpa::app
