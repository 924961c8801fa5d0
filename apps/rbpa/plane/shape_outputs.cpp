#include "plane/shape_outputs.h"

#include <algorithm>

#include "io/failure.h"
#include "io/polygon/ogr.h"
#include "picture/picture.h"
#include "plane/ogr_outputs.h"
#include "plane/picture_outputs.h"

namespace rbpa::app {
namespace {

/// Returns the first target in the format; null if there is none.
const Target* find(const std::vector<Target>& targets, Format format) {
  const auto first =
      std::find_if(targets.begin(), targets.end(), [&](const Target& target) { return target.format == format; });
  return first == targets.end() ? nullptr : &*first;
}

}  // namespace

std::string srid_of(const Shape& shape) { return "SRID=" + *shape.crs->srid() + ";"; }

void require_srid(const std::vector<Target>& targets, const std::optional<Crs>& crs) {
  const Target* first = find(targets, Format::ewkt);
  if (first == nullptr || (crs && crs->srid())) return;
  bad_usage(first->path == "-" ? "-o -" : first->path,
            "points in " + (crs ? crs->text() : "an unknown coordinate system"),
            "one with an EPSG code, which EWKT contains (--crs EPSG:28992, or the ending wkt)");
}

std::vector<Point> with_corners(std::vector<Point> points, std::span<const Point> corners,
                                std::vector<Polygon>& polygons) {
  const auto first = static_cast<std::uint32_t>(points.size());
  const auto move = [&](Ring& ring) {
    for (std::uint32_t& corner : ring.points) corner += first;
  };
  for (Polygon& polygon : polygons) {
    move(polygon.shell);
    std::for_each(polygon.holes.begin(), polygon.holes.end(), move);
  }
  points.insert(points.end(), corners.begin(), corners.end());
  return points;
}

void add_shapes(Run& run, const std::vector<Target>& targets, const Shape& shape,
                std::span<const std::uint32_t> isolated, int width) {
  std::optional<Drawing> drawing;
  for (const Target& target : targets) {
    stop_if_interrupted();
    if (is_ogr(target.format)) {
      add_ogr(run, target, ogr_polygons(target.format, shape));
      continue;
    }
    if (is_picture(target.format)) {
      if (!drawing) drawing = drawing_of(shape.points, shape.polygons, isolated);
      add_picture(run, target, *drawing, width, shape.crs);
      continue;
    }
    run.add(target.path, [&](OutputFile& file) {
      if (target.format == Format::csv) return write_points_csv(file, shape);
      if (target.format == Format::ewkt) file.write(srid_of(shape));
      write_polygons(file, target.format == Format::geojson ? Format::geojson : Format::wkt, shape);
    });
  }
}

void caution(const std::vector<Target>& targets, const Shape& shape) {
  const Target* first = find(targets, Format::geojson);
  if (first == nullptr) return;
  if (const std::optional<std::string> why = geojson_caution(shape))
    say("rbpa", output_name(first->path) + ": " + *why);
}

}  // namespace rbpa::app
