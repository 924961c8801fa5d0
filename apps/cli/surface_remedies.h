// What: remedies of a surface's holes in `rbpa surface`: found for what the ball made, kept while components are dropped and
//       curves cut, and as text and JSON.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rbpa/curve_kinds.h"
#include "rbpa/hole_remedies.h"

namespace rbpa::app {

/// By curves: where one begins, and its number of edges.
class SurfaceRemedies {
 public:
  SurfaceRemedies() = default;
  SurfaceRemedies(std::span<const Hole> holes, std::span<const HoleRemedy> remedies);

  /// Of each curve of kind `hole`; none where it is no more what it was.
  std::vector<std::optional<HoleRemedy>> of(std::span<const Hole> curves, std::span<const CurveKind> kinds) const;

 private:
  using Key = std::array<std::size_t, 3>;
  static Key key_of(const Hole& curve);

  std::map<Key, HoleRemedy> remedies_;
};

/// "closed by --radius 0.1,0.25".
std::string remedy_text(const HoleRemedy& remedy, const std::vector<double>& radii);
/// "closed: 3 by --fill-holes, 1 by nothing".
std::string remedies_text(std::span<const HoleRemedy> remedies);

/// {"kind", and what belongs to it}.
nlohmann::ordered_json as_json(const HoleRemedy& remedy);
/// {"turn_normals", "larger_ball", "filling", "none"}: how many there are of each.
nlohmann::ordered_json counts_as_json(const std::vector<std::optional<HoleRemedy>>& remedies);

}  // namespace rbpa::app
