#include "meshops/topology/soup_defects.h"

#include <algorithm>
#include <array>
#include <map>

#include "meshops/topology/soup_sides.h"

namespace meshops {
namespace {

using detail::FaceFault;
using detail::SoupSide;
using Edge = std::span<const SoupSide>;

std::vector<std::size_t> faces_at(Edge edge) {
  std::vector<std::size_t> faces;
  for (const SoupSide& side : edge) faces.push_back(side.face);
  return faces;
}

void find_bad_faces(const PolygonSoup& soup, const detail::FaceFaults& faults, std::vector<SoupDefect>& defects) {
  constexpr std::array<std::pair<FaceFault, SoupDefectKind>, 3> kinds = {
      {{FaceFault::out_of_range, SoupDefectKind::corner_out_of_range},
       {FaceFault::degenerate, SoupDefectKind::degenerate_face},
       {FaceFault::duplicate, SoupDefectKind::duplicate_face}}};
  for (const auto& [fault, kind] : kinds)
    for (std::size_t f = 0; f < soup.faces(); ++f) {
      if (faults.of[f] != fault) continue;
      const auto corners = soup.face(f);
      SoupDefect defect{kind, {corners.begin(), corners.end()}, {f}};
      if (fault == FaceFault::duplicate) defect.faces = {faults.repeats[f], f};
      defects.push_back(std::move(defect));
    }
}

void find_bad_edges(const PolygonSoup& soup, const detail::SoupSides& sides, std::vector<SoupDefect>& defects) {
  for (std::size_t e = 0; e < sides.edges(); ++e)
    if (const Edge edge = sides.edge(e); edge.size() > 2)
      defects.push_back({SoupDefectKind::non_manifold_edge, {edge[0].low, edge[0].high}, faces_at(edge)});
  for (std::size_t e = 0; e < sides.edges(); ++e)
    if (const Edge edge = sides.edge(e); edge.size() == 2 && edge[0].ascending == edge[1].ascending)
      defects.push_back({SoupDefectKind::inconsistent_orientation, {edge[0].low, edge[0].high}, faces_at(edge)});
  // The first edge of each piece at which no choice of directions agrees.
  std::vector<Edge> disagreeing;
  auto pieces = detail::pieces_of(soup, sides, [&](Edge edge) { disagreeing.push_back(edge); });
  std::map<std::size_t, Edge> of_piece;
  for (const Edge edge : disagreeing) of_piece.try_emplace(pieces.find(edge[0].face), edge);
  for (const auto& [first_face, edge] : of_piece)
    defects.push_back({SoupDefectKind::not_orientable, {edge[0].low, edge[0].high}, {first_face}});
}

void find_pinches(const PolygonSoup& soup, const detail::FaceFaults& faults, const detail::SoupSides& sides,
                  std::vector<SoupDefect>& defects) {
  auto fans = detail::fans_of(soup, sides, [](Edge) { return true; });
  struct Fan {
    std::uint32_t point;
    std::size_t face;  // the first
  };
  std::vector<Fan> found;
  std::vector<std::uint32_t> count(soup.points, 0);
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    if (faults.of[f] != FaceFault::none) continue;
    for (std::size_t c = soup.begin[f]; c < soup.begin[f + 1]; ++c)
      if (const auto corner = static_cast<std::uint32_t>(c); fans.find(corner) == corner) {
        found.push_back({soup.corners[c], f});
        ++count[soup.corners[c]];
      }
  }
  std::erase_if(found, [&](const Fan& fan) { return count[fan.point] < 2; });
  std::stable_sort(found.begin(), found.end(), [](const Fan& a, const Fan& b) { return a.point < b.point; });
  for (std::size_t i = 0; i < found.size(); i += count[found[i].point]) {
    SoupDefect defect{SoupDefectKind::pinch, {found[i].point}, {}};
    for (std::size_t k = 0; k < count[found[i].point]; ++k) defect.faces.push_back(found[i + k].face);
    defects.push_back(std::move(defect));
  }
}

void append(std::string& text, const char* word, const auto& numbers) {
  if (numbers.empty()) return;
  text += word;
  if (numbers.size() > 1) text += 's';
  for (const auto number : numbers) text += ' ' + std::to_string(number);
}

}  // namespace

std::string_view name(SoupDefectKind kind) {
  static constexpr std::array<std::string_view, 7> names = {
      "corner out of range",      "degenerate face", "duplicate face", "non-manifold edge",
      "inconsistent orientation", "not orientable",  "pinch"};
  return names[static_cast<std::size_t>(kind)];
}

std::string describe(const SoupDefect& defect) {
  std::string text(name(defect.kind));
  append(text, ": point", defect.points);
  append(text, defect.points.empty() ? ": face" : ", face", defect.faces);
  return text;
}

std::vector<SoupDefect> find_defects(const PolygonSoup& soup) {
  std::vector<SoupDefect> defects;
  const detail::FaceFaults faults = detail::find_face_faults(soup);
  const detail::SoupSides sides(soup, faults);
  find_bad_faces(soup, faults, defects);
  find_bad_edges(soup, sides, defects);
  find_pinches(soup, faults, sides, defects);
  return defects;
}

}  // namespace meshops
