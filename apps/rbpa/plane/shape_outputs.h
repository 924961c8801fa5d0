// What: adds files of polygons and of the points that belong to them, and files of other verbs that GDAL or pictures
//       need, to the output files of a run.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/crs.h"
#include "io/polygon/ogr.h"
#include "io/polygon/write_shapes.h"
#include "picture/drawing.h"
#include "shared/run.h"

namespace rbpa::app {

/// Adds `files`, which GDAL has made for a target, to the files of the run. Throws Failure if an old file of the
/// target, such as a .prj, would remain next to the new files; as Run::add() does.
void add_ogr(Run& run, const Target& target, const std::vector<OgrFile>& files);

/// Adds the picture. If the coordinates have the system `crs` and the target is a file .png, adds a world file, .pgw,
/// with the size of a pixel and the center of the upper left pixel; otherwise prints a warning, unless quiet, about a
/// world file that is there. Requires: is_picture(target.format);
/// least_width ≤ width ≤ greatest_width. Throws as Run::add() and write_picture() do.
void add_picture(Run& run, const Target& target, const Drawing& drawing, int width, const std::optional<Crs>& crs);

inline bool is_text_geometry(Format format) { return format == Format::wkt || format == Format::ewkt; }

/// Returns the prefix that EWKT adds to WKT, such as "SRID=28992;". Requires: require_srid() has not thrown.
std::string srid_of(const Shape& shape);

/// Throws WrongUsage if a target is EWKT and the points have no EPSG code, by which EWKT names the coordinate system.
void require_srid(const std::vector<Target>& targets, const std::optional<Crs>& crs);

/// Returns Shape::points: the points, then the corners of the polygons, whose rings become indices into the result.
std::vector<Point> with_corners(std::vector<Point> points, std::span<const Point> corners,
                                std::vector<Polygon>& polygons);

/// Adds a file for each target. Pictures also show the isolated points. Throws Cancelled; as Run::add() and add_ogr().
void add_shapes(Run& run, const std::vector<Target>& targets, const Shape& shape,
                std::span<const std::uint32_t> isolated, int width);

/// Prints a warning, even with --quiet, if readers of a GeoJSON file may take the coordinates for degrees although they
/// are not.
void caution(const std::vector<Target>& targets, const Shape& shape);

}  // namespace rbpa::app
