#include "plane/valid_features.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>

#include "io/failure.h"
#include "io/interrupt.h"
#include "rbpa/fill/validity.h"

namespace rbpa::app {
namespace {

template <typename Visit>
void for_each_ring(std::vector<Polygon>& polygons, Visit visit) {
  for (Polygon& polygon : polygons) {
    visit(polygon.shell.points);
    for (Ring& hole : polygon.holes) visit(hole.points);
  }
}

/// Returns the reason why a geometry is not valid, or nothing. Reads only the range of `points` that `polygons` use.
std::optional<std::string> why_geometry_is_invalid(std::span<const Point> points, std::vector<Polygon> polygons) {
  std::uint32_t first = std::numeric_limits<std::uint32_t>::max(), last = 0;
  for_each_ring(polygons, [&](const std::vector<std::uint32_t>& ring) {
    for (const std::uint32_t i : ring) {
      first = std::min(first, i);
      last = std::max(last, i);
    }
  });
  if (first > last) return std::nullopt;
  for_each_ring(polygons, [&](std::vector<std::uint32_t>& ring) {
    for (std::uint32_t& i : ring) i -= first;
  });
  return why_invalid(points.subspan(first, last - first + std::size_t{1}), polygons, until_interrupted());
}

}  // namespace

ValidFeatures valid_features(const PolygonFile& file, const std::string& name, bool skip_invalid) {
  ValidFeatures valid;
  const auto polygons_of = [&](std::size_t g) {
    const bool is_last = g + 1 == file.geometries.size();
    const std::size_t end = is_last ? file.polygons.size() : file.geometries[g + 1].first_polygon;
    return std::span(file.polygons).subspan(file.geometries[g].first_polygon, end - file.geometries[g].first_polygon);
  };
  for (std::size_t g = 0; g < file.geometries.size();) {
    const std::size_t feature = file.geometries[g].feature;
    std::size_t last = g;  // end of the geometries of the feature
    std::optional<std::string> why;
    for (; last < file.geometries.size() && file.geometries[last].feature == feature; ++last) {
      if (why) continue;
      const auto polygons = polygons_of(last);
      why = why_geometry_is_invalid(file.vertices.points, {polygons.begin(), polygons.end()});
    }
    if (why) {
      if (file.features > 1) why = "feature " + std::to_string(feature) + ": " + *why;
      if (!skip_invalid)
        throw BadInput(name + ": " + *why + (file.features > 1 ? " (--skip-invalid leaves it out)" : ""));
      valid.why_left_out.push_back(*why);
    }
    for (; g < last; ++g) {
      if (why) continue;
      valid.groups.push_back(valid.polygons.size());
      valid.feature.push_back(static_cast<std::uint32_t>(feature));
      const auto polygons = polygons_of(g);
      valid.polygons.insert(valid.polygons.end(), polygons.begin(), polygons.end());
    }
  }
  return valid;
}

}  // namespace rbpa::app
