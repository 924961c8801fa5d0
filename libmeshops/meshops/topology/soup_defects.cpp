#include "meshops/topology/soup_defects.h"

#include <algorithm>
#include <array>
#include <map>

#include "meshops/topology/soup_anatomy.h"

namespace meshops {
namespace {

using detail::FaceFault;
using detail::SoupAnatomy;
using detail::SoupSide;
using detail::SoupSides;
using SoupEdge = std::span<const SoupSide>;

std::vector<std::size_t> faces_at(SoupEdge edge) {
  std::vector<std::size_t> faces;
  for (const SoupSide& side : edge) faces.push_back(side.face());
  return faces;
}

void find_bad_faces(const SoupAnatomy& anatomy, Steps& step, std::vector<SoupDefect>& defects) {
  constexpr std::array<std::pair<FaceFault, SoupDefectKind>, 3> kinds = {
      {{FaceFault::out_of_range, SoupDefectKind::corner_out_of_range},
       {FaceFault::degenerate, SoupDefectKind::degenerate_face},
       {FaceFault::duplicate, SoupDefectKind::duplicate_face}}};
  const auto& [of, repeats, twin] = anatomy.faults;
  defects.reserve(of.size() - static_cast<std::size_t>(std::count(of.begin(), of.end(), FaceFault::none)));
  for (const auto& [fault, kind] : kinds)
    for (std::size_t f = 0; f < anatomy.soup.faces(); ++f) {
      step();
      if (of[f] != fault) continue;
      const auto corners = anatomy.soup.face(f);
      SoupDefect defect{kind, {corners.begin(), corners.end()}, {f}};
      if (fault == FaceFault::duplicate) defect.faces = {repeats[f], f};
      defects.push_back(std::move(defect));
    }
}

void find_bad_edges(SoupAnatomy& anatomy, Steps& step, std::vector<SoupDefect>& defects) {
  const SoupSides& sides = anatomy.sides;
  const auto find = [&](SoupDefectKind kind, auto is_bad) {
    for (std::size_t e = 0; e < sides.edges(); ++e) {
      step();
      if (const SoupEdge edge = sides.edge(e); is_bad(edge))
        defects.push_back({kind, {edge[0].low, edge[0].high}, faces_at(edge)});
    }
  };
  if (anatomy.has_non_manifold_edge)
    find(SoupDefectKind::non_manifold_edge, [](SoupEdge edge) { return edge.size() > 2; });
  find(SoupDefectKind::inconsistent_orientation,
       [](SoupEdge edge) { return edge.size() == 2 && edge[0].ascending() == edge[1].ascending(); });
  // For each piece, take the first edge at which no choice of directions agrees.
  std::map<std::size_t, SoupEdge> of_piece;
  for (const SoupEdge edge : anatomy.disagreeing) of_piece.try_emplace(anatomy.pieces.find(edge[0].face()), edge);
  for (const auto& [first_face, edge] : of_piece)
    defects.push_back({SoupDefectKind::not_orientable, {edge[0].low, edge[0].high}, {first_face}});
}

void find_pinches(const SoupAnatomy& anatomy, Steps& step, std::vector<SoupDefect>& defects) {
  if (std::all_of(anatomy.fans_at.begin(), anatomy.fans_at.end(), [](std::uint32_t fans) { return fans < 2; })) return;
  struct Fan {
    std::uint32_t point;
    std::size_t face;  // the first face of the fan
  };
  std::vector<Fan> found;
  const std::vector<std::uint32_t>& count = anatomy.fans_at;
  anatomy.for_each_fan(step, [&](std::uint32_t point, std::size_t face) {
    if (count[point] > 1) found.push_back({point, face});
  });
  std::stable_sort(found.begin(), found.end(), [&](const Fan& a, const Fan& b) {
    step();
    return a.point < b.point;
  });
  for (std::size_t i = 0; i < found.size(); i += count[found[i].point]) {
    SoupDefect defect{SoupDefectKind::pinch, {found[i].point}, {}};
    for (std::size_t k = 0; k < count[found[i].point]; ++k) defect.faces.push_back(found[i + k].face);
    step(defect.faces.size());
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

namespace detail {
std::vector<SoupDefect> defects_of(SoupAnatomy& anatomy, const GoOn& go_on) {
  std::vector<SoupDefect> defects;
  Steps step(go_on);
  find_bad_faces(anatomy, step, defects);
  find_bad_edges(anatomy, step, defects);
  find_pinches(anatomy, step, defects);
  return defects;
}
}  // namespace detail

std::vector<SoupDefect> find_defects(const PolygonSoup& soup, const GoOn& go_on) {
  detail::SoupAnatomy anatomy(soup, go_on);
  return detail::defects_of(anatomy, go_on);
}

}  // namespace meshops
