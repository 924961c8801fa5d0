// What: reports on a surface (`rbpa surface`) as text, JSON and statistics.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/bytes/output_file.h"
#include "rbpa/space/repair/reconstruct.h"
#include "triangulation/filling_counts.h"
#include "triangulation/surface_counts.h"

namespace rbpa::app {

/// Names of the kinds of boundary curves, indexed by CurveKind.
inline constexpr std::array kind_names{"rim", "hole", "island"};

/// A reconstruction, with its counts, and the settings and seconds of the run.
struct SurfaceFacts : Reconstruction {
  std::size_t input_points = 0;
  bool chosen_radii = false;      ///< whether --radius auto chose the radii
  std::string normals_name = {};  ///< "file", "estimate" or "none"
  std::optional<std::size_t> in_doubt =
      std::nullopt;  ///< number of estimated normals of low confidence; nullopt if no normals are estimated
  std::optional<double> outlier_factor = std::nullopt;
  unsigned threads = 1;
  SurfaceCounts counts = {};
  FillingCounts filling = {};
  bool has_repairs = false;            ///< whether repairs were requested
  bool has_viewpoint = false;          ///< whether normals were turned toward viewpoints
  bool watertight = false;             ///< whether --watertight was given; the surface is watertight then
  bool manifold = false;               ///< whether files have a vertex for each fan
  std::size_t non_manifold_edges = 0;  ///< number of edges of the files with more than two triangles
  double read_seconds = 0, normals_seconds = 0, build_seconds = 0, write_seconds = 0;
};

/// Returns the radii as text, such as "0.5, 1.25".
std::string text_of_radii(const std::vector<double>& radii);

/// Returns ", genus 2"; if components were dropped, ", genus 0 (5 before), after 3 components were dropped (88 % of the
/// triangles, 60 % of the area)".
std::string genus_text(const SurfaceFacts& facts);

/// Returns the lines of the summary after the counts: outliers, normals in doubt, "12 points unused: 10 ..., 2 ...",
/// boundary curves, dropped components, filled holes, decimation, watertightness, non-manifold edges.
std::vector<std::string> explanations(const SurfaceFacts& facts);

/// Returns the reasons why a surface is not watertight: "2 boundary curves left, the longest ...; 3 pairs of triangles
/// cross, the first ..."; "" if it is watertight.
std::string openings(const SurfaceFacts& facts);

/// Returns "there is no triangle: " and the reason. Requires: the surface has no triangle.
std::string why_empty(const SurfaceFacts& facts);

/// Write one JSON object: write_surface_stats() counts, seconds and memory; write_surface_json() counts, and every
/// hole, component and unused point.
void write_surface_stats(OutputFile& file, const SurfaceFacts& facts);
void write_surface_json(OutputFile& file, const SurfaceFacts& facts);

}  // namespace rbpa::app
