#include <algorithm>
#include <array>
#include <stdexcept>

#include "drawings/figures.h"
#include "drawings/sheet.h"
#include "meshops/topology/soup_defects.h"

namespace figures {
namespace {

using meshops::SoupDefect;
using meshops::SoupDefectKind;

/// Faces over places; several places may be one point.
struct Specimen {
  SoupDefectKind kind;
  std::vector<Place> places;
  std::vector<Corners> faces;
  std::vector<std::uint32_t> point_of = {};  ///< the point of each place; empty: a place is its own point
  std::size_t missing = 0;                   ///< number of places at the end that are no points
  std::uint32_t point(std::uint32_t place) const { return point_of.empty() ? place : point_of[place]; }
};

const std::vector<Specimen>& specimens() {
  static const std::vector<Specimen> all = {
      {SoupDefectKind::corner_out_of_range, {{0, 0}, {1.2, 1.2}, {0, 1.7}, {1.9, 0}}, {{0, 1, 2}, {0, 3, 1}}, {}, 1},
      {SoupDefectKind::degenerate_face, {{0, 0}, {1.3, 0}, {0.7, 1.5}, {1.9, 1.3}}, {{0, 1, 2}, {1, 3, 3}}},
      {SoupDefectKind::duplicate_face, {{0, 0}, {2, 0}, {1, 1.7}}, {{0, 1, 2}, {1, 2, 0}}},
      {SoupDefectKind::non_manifold_edge,
       {{1, 0}, {1, 1.7}, {0, 1.1}, {2, 1.6}, {1.9, 0.2}},
       {{0, 1, 2}, {1, 0, 3}, {1, 0, 4}}},
      {SoupDefectKind::inconsistent_orientation, {{0, 0.2}, {1, 0}, {1, 1.7}, {2, 1.1}}, {{0, 1, 2}, {1, 2, 3}}},
      {SoupDefectKind::not_orientable,
       {{0, 0.3}, {0, 1.3}, {0.8, 0.3}, {0.8, 1.3}, {1.6, 0.3}, {1.6, 1.3}, {2.4, 0.3}, {2.4, 1.3}},
       {{0, 2, 1}, {2, 3, 1}, {2, 4, 3}, {4, 5, 3}, {4, 6, 5}, {6, 7, 5}},
       {0, 1, 2, 3, 4, 5, 1, 0}},
      {SoupDefectKind::pinch, {{0, 0.1}, {1, 0.85}, {0, 1.6}, {2, 0.1}, {2, 1.6}}, {{0, 1, 2}, {1, 3, 4}}}};
  return all;
}

/// Returns the first defect of the kind that the specimen shows.
SoupDefect defect_of(const Specimen& specimen) {
  meshops::PolygonSoup soup;
  for (std::uint32_t p = 0; p < specimen.places.size() - specimen.missing; ++p)
    soup.points = std::max<std::size_t>(soup.points, specimen.point(p) + 1);
  for (const Corners& face : specimen.faces) {
    Corners cycle;
    for (const std::uint32_t place : face) cycle.push_back(specimen.point(place));
    soup.add_face(cycle);
  }
  for (const SoupDefect& defect : meshops::find_defects(soup))
    if (defect.kind == specimen.kind) return defect;
  throw std::logic_error("no such defect: " + std::string(meshops::name(specimen.kind)));
}

/// Returns whether the defect is one of an edge, not of a face or a point.
bool is_of_edge(const SoupDefect& defect) {
  return defect.kind == SoupDefectKind::non_manifold_edge || defect.kind == SoupDefectKind::inconsistent_orientation ||
         defect.kind == SoupDefectKind::not_orientable;
}

/// Draws a face a little inside its corners, with its direction; the second of two equal faces lies further inside.
void draw_face(Canvas& canvas, const Frame& frame, const Specimen& specimen, std::size_t f, bool bad, double inset) {
  const Corners& face = specimen.faces[f];
  Place center;
  for (const std::uint32_t place : face)
    center = center + (1.0 / static_cast<double>(face.size())) * specimen.places[place];
  std::vector<Segment> sides;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const auto corner = [&](std::size_t c) {
      const Place at = specimen.places[face[c % face.size()]];
      return frame(at + inset * (center - at));
    };
    sides.push_back({corner(i), corner(i + 1), {}});
  }
  const std::string_view ink = bad ? color::touched : color::inner;
  canvas.outline(sides, bad ? color::touched_face : color::face);
  for (const Segment& side : sides) {
    canvas.segment(side, {ink, 1.4});
    if (length(side.to - side.from) > 20) canvas.head(side.middle(), side.to - side.from, ink, 8);
  }
}

void draw_specimen(Canvas& canvas, const Frame& frame, const Specimen& specimen, const SoupDefect& defect) {
  const bool of_edge = is_of_edge(defect);
  const auto has = [&](std::uint32_t place) {
    return std::find(defect.points.begin(), defect.points.end(), specimen.point(place)) != defect.points.end();
  };
  Place middle;
  for (const Place p : specimen.places) middle = middle + (1.0 / static_cast<double>(specimen.places.size())) * p;
  for (std::size_t f = 0; f < specimen.faces.size(); ++f) {
    const bool second = defect.kind == SoupDefectKind::duplicate_face && f == 1;
    const bool bad = !of_edge && defect.kind != SoupDefectKind::pinch && f == defect.faces.back();
    draw_face(canvas, frame, specimen, f, bad, second ? 0.3 : 0.07);
  }
  if (of_edge)
    for (const Corners& face : specimen.faces)
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
        if (has(a) && has(b))
          canvas.segment(frame.of({specimen.places[a], specimen.places[b], {}}), {color::touched, 3.2});
      }
  for (std::uint32_t p = 0; p < specimen.places.size(); ++p) {
    const Place at = frame(specimen.places[p]);
    const bool missing = p + specimen.missing >= specimen.places.size();
    const bool bad = has(p) && (of_edge || defect.kind == SoupDefectKind::pinch);
    if (missing)
      canvas.ring(at, 4, color::touched);
    else
      canvas.dot(at, bad ? 4.6 : 3.4, bad ? color::touched : color::text);
    const Place outward = direction(at - frame(middle));
    const Place beside = length(at - frame(middle)) < 5 ? Place{0, -1} : outward;
    canvas.text(at + 14 * beside + Place{0, 4}, std::to_string(specimen.point(p)), Lettering::small, Align::middle);
  }
}

std::string defects() {
  Sheet sheet("What keeps a soup of faces from being an oriented manifold", 50, 178);
  std::vector<Panel> panels;
  for (const Specimen& specimen : specimens()) {
    const SoupDefect defect = defect_of(specimen);
    const std::string words = meshops::describe(defect), kind(meshops::name(defect.kind));
    Panel panel;
    panel.heading = kind;
    panel.caption = {words.substr(std::min(words.size(), kind.size() + 2))};
    panel.extent = specimen.places;
    panel.extent.insert(panel.extent.end(), {{0, -0.15}, {2.4, 1.85}});
    panel.more = [&specimen, defect](Canvas& canvas, const Frame& frame) {
      draw_specimen(canvas, frame, specimen, defect);
    };
    panels.push_back(panel);
  }
  const auto half = panels.begin() + 4;
  return sheet.row({panels.begin(), half}).row({half, panels.end()}).svg();
}

}  // namespace

std::span<const Figure> defect_figures() {
  static constexpr std::array figures = {Figure{"defects", defects}};
  return figures;
}

}  // namespace figures
