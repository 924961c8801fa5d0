// What: suggested repairs of the holes of a surface. They are found for the surface that the ball made, and looked up
//       for its curves after components are dropped. Also written as text and JSON.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rbpa/space/repair/suggested_repairs.h"
#include "rbpa/space/surface/curve_kinds.h"

namespace rbpa::app {

/// The suggested repairs by curve; a curve is identified by its first edge and its number of edges.
class SurfaceRepairs {
 public:
  SurfaceRepairs() = default;
  SurfaceRepairs(std::span<const Hole> holes, std::span<const SuggestedRepair> repairs);

  /// Returns the repair of each curve of kind `hole`, a default one if the curve has changed; nothing for other kinds.
  std::vector<std::optional<SuggestedRepair>> of(std::span<const Hole> curves, std::span<const CurveKind> kinds) const;

 private:
  using Key = std::array<std::size_t, 3>;
  static Key key_of(const Hole& curve);

  std::map<Key, SuggestedRepair> repairs_;
};

/// Returns "closed by --radius 0.1,0.25".
std::string repair_text(const SuggestedRepair& repair, const std::vector<double>& radii);
/// Returns "closed: 3 by --fill-holes, 1 by nothing".
std::string repairs_text(std::span<const SuggestedRepair> repairs);

/// Returns {"kind", and the values of that kind}.
nlohmann::ordered_json as_json(const SuggestedRepair& repair);
/// Returns the number of repairs of each kind: {"turn_normals", "larger_ball", "filling", "none"}.
nlohmann::ordered_json counts_as_json(const std::vector<std::optional<SuggestedRepair>>& repairs);

}  // namespace rbpa::app
