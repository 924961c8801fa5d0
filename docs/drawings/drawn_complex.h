// What: draws points, solid alpha complexes and alpha solids.
#pragma once

#include <span>
#include <vector>

#include "drawings/canvas.h"
#include "drawings/drawn_mesh.h"
#include "drawings/sheet.h"
#include "rbpa/plane/outline_polygons.h"
#include "rbpa/rbpa.h"

namespace figures {

using Points = std::vector<rbpa::Point>;

inline Place place_of(const rbpa::Point& p) { return {p.x, p.y}; }

/// Returns an empty panel as large as the points, with lines of text under it.
Panel panel_over(const Points& points, std::string heading, std::vector<std::string> caption);

void draw_points(Canvas& canvas, const Frame& frame, std::span<const rbpa::Point> points, double radius,
                 std::string_view ink);

/// Draws faces, inner edges and boundary, with lines of the given width at the boundary and thinner lines inside.
void draw_complex(Canvas& canvas, const Frame& frame, const rbpa::SolidAlphaComplex& complex, double width);

/// Draws the solid and the boundary of each polygon.
void draw_solid(Canvas& canvas, const Frame& frame, const Points& points, std::span<const rbpa::Polygon> solid,
                double width);

}  // namespace figures
