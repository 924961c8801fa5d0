// What: reports on a surface (`rbpa surface`) as text, JSON and statistics.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/bytes/output_file.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/repair/suggested_repairs.h"
#include "rbpa/space/surface/curve_kinds.h"
#include "rbpa/space/surface/holes.h"
#include "rbpa/space/surface/outliers.h"
#include "rbpa/space/surface/surface.h"
#include "rbpa/space/surface/surface_components.h"
#include "rbpa/space/surface/unused_points.h"
#include "triangulation/filling_counts.h"
#include "triangulation/surface_counts.h"

namespace rbpa::app {

/// Names of the kinds of curves, by CurveKind.
inline constexpr std::array kind_names{"rim", "hole", "island"};

/// Counts of the components dropped from a surface, and of the whole surface before.
struct DroppedComponents {
  std::size_t components = 0, triangles = 0, genus = 0;
  std::size_t points = 0;  ///< left without a triangle
  double area = 0;
  std::size_t of_components = 0, of_triangles = 0, of_genus = 0;
  double of_area = 0;

  double triangle_share() const { return share(static_cast<double>(triangles), static_cast<double>(of_triangles)); }
  double area_share() const { return share(area, of_area); }
  static double share(double part, double whole) { return whole > 0 ? part / whole : 0; }
};

struct SurfaceFacts {
  std::size_t points = 0;
  std::size_t distinct = 0;
  std::vector<double> radii = {};
  bool chosen_radii = false;  ///< true: by auto
  std::string normals = {};   ///< file, estimate or none
  std::optional<std::size_t> in_doubt =
      std::nullopt;             ///< estimated normals of low confidence; absent: none are estimated
  std::size_t scale_space = 0;  ///< number of steps
  std::optional<double> outlier_factor = std::nullopt;
  Outliers outliers = {};  ///< points left out
  unsigned threads = 1;
  SurfaceCounts counts = {};
  std::vector<UnusedPoint> unused = {};
  std::vector<Hole> holes = {};
  std::vector<CurveKind> kinds = {};                         ///< of each of `holes`
  bool has_repairs = false;                                  ///< repairs were requested
  std::vector<std::optional<SuggestedRepair>> repairs = {};  ///< for each of `holes` of kind hole: the suggested repair
  std::vector<SurfaceComponent> components = {};
  std::vector<std::size_t> inside = {};  ///< for each component, inside how many others it lies; empty: not requested
  DroppedComponents dropped = {};
  FillingCounts filling = {};
  bool has_viewpoint = false;          ///< normals were turned towards it
  bool watertight = false;             ///< requested, and true of the result
  bool manifold = false;               ///< files have a vertex for each fan
  std::size_t non_manifold_edges = 0;  ///< non-manifold edges of the files: with more than two triangles
  double read_seconds = 0, normals_seconds = 0, build_seconds = 0, write_seconds = 0;
};

/// Returns "0.5, 1.25".
std::string text_of_radii(const std::vector<double>& radii);

/// Returns ", genus 2", or if components were dropped ", genus 0 (5 before), without 3 components that are dropped (88
/// % of the triangles, 60 % of the area)".
std::string genus_text(const SurfaceFacts& facts);

/// Returns the lines "12 unused points: 10 that ..., 2 ...", one for each of the longest boundary curves and one for
/// all.
std::vector<std::string> explanations(const SurfaceFacts& facts);

/// Returns why a surface is not watertight: "2 curves stay open, ..., and 3 pairs of triangles cross, ..."; "" if it
/// is.
std::string openings(const SurfaceFacts& facts, std::span<const Point3> points, const Surface& surface,
                     const std::vector<std::pair<std::uint32_t, std::uint32_t>>& crossing);

/// Write one JSON object each.
void write_surface_stats(OutputFile& file, const SurfaceFacts& facts);
void write_surface_json(OutputFile& file, const SurfaceFacts& facts);

}  // namespace rbpa::app
