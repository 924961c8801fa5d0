#include "plane/shape_outputs.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <system_error>

#include "io/bytes/same_file.h"
#include "io/failure.h"
#include "io/polygon/ogr.h"
#include "picture/picture.h"

namespace rbpa::app {
namespace {

/// Returns the first target in the format; null if there is none.
const Target* find(const std::vector<Target>& targets, Format format) {
  const auto first =
      std::find_if(targets.begin(), targets.end(), [&](const Target& target) { return target.format == format; });
  return first == targets.end() ? nullptr : &*first;
}

}  // namespace

void add_ogr(Run& run, const Target& target, const std::vector<OgrFile>& files) {
  const std::vector<std::string> endings = ogr_endings(target.format), paths = ogr_paths(target);
  for (std::size_t i = 0; i < endings.size(); ++i) {
    const auto made =
        std::find_if(files.begin(), files.end(), [&](const OgrFile& file) { return file.ending == endings[i]; });
    if (made != files.end())
      run.add(paths[i], [&](OutputFile& file) { file.write(made->bytes); });
    else if (std::filesystem::exists(paths[i]))
      // Refuse an old .prj: its coordinate system would apply to the new file.
      throw Failure(paths[i] + ": found an old file, expected none next to " + target.path + " (remove it)");
  }
}

void add_picture(Run& run, const Target& target, const Drawing& drawing, int width, const std::optional<Crs>& crs) {
  const Scene scene = place(drawing, width);
  run.add(target.path, [&](OutputFile& file) { write_picture(file, target.format, scene); });
  const double size = scene.pixel_size, x = scene.corner.x + size / 2, y = scene.corner.y - size / 2;
  const bool is_on_map =
      crs && !crs->is_geocentric() && size > 0 && std::isfinite(size) && std::isfinite(x) && std::isfinite(y);
  const auto world = target.format == Format::png ? world_file_of(target.path) : std::nullopt;
  if (!world) return;
  if (is_on_map)
    run.add_world_file(*world,
                       [&](OutputFile& file) { file.write_all(size, "\n0\n0\n", -size, "\n", x, "\n", y, "\n"); });
  else if (std::error_code error; std::filesystem::exists(*world, error))
    run.summarize(*world + ": this world file is of an earlier picture");
}

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
