#include "meshtopo/report_text.h"

#include <algorithm>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "meshtopo/places.h"

namespace rbpa::app {
namespace {

std::string right(std::string text, std::size_t width) {
  if (text.size() < width) text.insert(0, width - text.size(), ' ');
  return text;
}

std::string genus_of_piece(const meshops::ComponentReport& piece) {
  return piece.orientable ? std::to_string(*piece.genus()) : "not orientable";
}

std::string sizes(const Measures& measures) {
  std::string text = "area               " + rounded(measures.area, 9) + "\n";
  if (measures.volume) text += "volume             " + rounded(*measures.volume, 9) + "\n";
  if (!measures.box) return text;
  const auto& [low, high] = *measures.box;
  for (std::size_t k = 0; k < 3; ++k)
    text += std::string(k == 0 ? "box                " : "                   ") + "xyz"[k] + " " + text_of(low[k]) +
            " .. " + text_of(high[k]) + "\n";
  return text;
}

std::string numbers(const Examined& mesh) {
  const meshops::TopologyReport& t = mesh.topology;
  const auto& [b0, b1, b2] = t.betti;
  const std::pair<std::string, std::string> rows[] = {
      {"vertices", std::to_string(t.vertices)},
      {"edges", std::to_string(t.edges)},
      {"faces", std::to_string(t.faces)},
      {"euler", std::to_string(t.euler())},
      {"components", std::to_string(t.components)},
      {"boundary curves", std::to_string(t.boundary_curves)},
      {"genus", genus_text(t)},
      {"betti", std::to_string(b0) + " " + std::to_string(b1) + " " + std::to_string(b2)},
      {"pinches", std::to_string(t.pinches)},
      {"isolated", std::to_string(t.isolated)},
      {"defects", std::to_string(mesh.defects.size())},
      {"geometric defects", std::to_string(mesh.geometric_defects.size())}};
  std::size_t width = 0;
  for (const auto& row : rows)
    if (row.first != "genus") width = std::max(width, row.second.size());  // the genus may be words
  std::string text;
  for (const auto& [label, value] : rows) {
    text += label;
    text += right(value, 19 - label.size() + width) + "\n";
  }
  return text + sizes(mesh.measures);
}

/// Returns the line "  ... and 5 more" for 5 items that are not shown; "" if all are shown.
std::string rest(std::size_t all, std::size_t shown) {
  return all > shown ? "  ... and " + std::to_string(all - shown) + " more\n" : "";
}

std::string pieces(const std::vector<meshops::ComponentReport>& all, std::size_t most) {
  const bool orientable = std::all_of(all.begin(), all.end(), [](const auto& piece) { return piece.orientable; });
  const std::size_t width = orientable ? 10 : genus_of_piece(meshops::ComponentReport{.orientable = false}).size();
  std::string text = "\ncomponents, connected through edges\n";
  for (const char* title : {"first face", "vertices", "edges", "faces", "euler", "curves", "genus"})
    text += "  " + right(title, width);
  text += "\n";
  const std::size_t shown = std::min(all.size(), most);
  for (std::size_t i = 0; i < shown; ++i) {
    stop_if_interrupted();
    const meshops::ComponentReport& piece = all[i];
    for (const std::string& value :
         {std::to_string(piece.first_face), std::to_string(piece.vertices), std::to_string(piece.edges),
          std::to_string(piece.faces), std::to_string(piece.euler()), std::to_string(piece.boundary_curves),
          genus_of_piece(piece)})
      text += "  " + right(value, width);
    text += "\n";
  }
  return text + rest(all.size(), shown);
}

/// Returns a line for each of the first `most` defects or repair steps, and a line with the number of the others.
template <typename Item>
std::string listed(const std::vector<Item>& items, const MeshFile& mesh, std::size_t most) {
  std::string text;
  const std::size_t shown = std::min(items.size(), most);
  for (std::size_t i = 0; i < shown; ++i) {
    stop_if_interrupted();
    text += "  " + std::string(name(items[i].kind)) + ": " + for_people({items[i].points, items[i].faces}, mesh) + "\n";
  }
  return text + rest(items.size(), shown);
}

/// Returns a count with its noun: `one` for 1, otherwise `several`.
std::string counted(std::size_t count, const char* one, const char* several) {
  return std::to_string(count) + " " + (count == 1 ? one : several);
}

std::string changes(const Findings& findings) {
  const EditReport& report = findings.edits;
  std::string text = "\nchanges\n";
  if (report.weld)
    text += "  weld " + text_of(report.weld->distance) + ": " +
            counted(report.weld->vertices, "vertex merged", "vertices merged") + ", " +
            counted(report.weld->degenerate_faces, "degenerate face", "degenerate faces") + " and " +
            counted(report.weld->duplicate_faces, "duplicate face", "duplicate faces") + " dropped\n";
  if (report.drop)
    text += "  drop: " + counted(report.drop->components, "component", "components") + ", " +
            counted(report.drop->faces, "face", "faces") + ", " + counted(report.drop->vertices, "vertex", "vertices") +
            "\n";
  if (report.orient) {
    text += "  orient: " + counted(report.orient->faces, "face reversed", "faces reversed") + ", " +
            counted(report.orient->outward, "closed component faces outward", "closed components face outward") + "\n";
    if (report.orient->nested > 0)
      text += "  orient: " + counted(report.orient->nested, "closed component lies", "closed components lie") +
              " inside others; " + std::to_string(report.orient->inward) + " of them inside an odd number of others, " +
              (report.orient->inward == 1 ? "the wall of a cavity, faces" : "walls of cavities, face") + " inward\n";
    for (const std::size_t face : report.orient->not_orientable)
      text +=
          "  orient: the component of face " + std::to_string(face) + " is not orientable: its faces stay unchanged\n";
  }
  if (findings.fill) {
    const auto& [rims, holes, islands] = findings.fill->not_chosen;
    text += "  fill: " + filled_text(findings.fill->counts) + "\n";
    if (findings.fill->counts.left() > 0) text += "  fill: " + left_text(findings.fill->counts) + "\n";
    if (holes > 0)
      text += "  fill: " + counted(holes, "hole", "holes") + " left open, larger than --fill-holes allows\n";
    if (rims > 0)
      text += "  fill: " + counted(rims, "rim of a sheet", "rims of sheets") +
              " left open (--fill-holes rims fills them)\n";
    if (islands > 0) text += "  fill: " + counted(islands, "rim of an island", "rims of islands") + " left open\n";
    if (findings.fill->merged > 0)
      text += "  fill: " + counted(findings.fill->merged, "vertex merged", "vertices merged") +
              " with one at the same position\n";
  }
  if (findings.tunnels) {
    text += "  tunnels: " + std::to_string(findings.tunnels->closed) + " closed, " +
            counted(findings.tunnels->removed, "face", "faces") + " removed and " +
            std::to_string(findings.tunnels->added) + " added\n";
    if (findings.tunnels->left > 0)
      text += "  tunnels: " + counted(findings.tunnels->left, "loop", "loops") +
              " shorter than --close-tunnels-below left as they are\n";
  }
  if (findings.decimated) text += "  " + decimated_text(*findings.decimated) + "\n";
  if (findings.remeshed)
    text += "  remeshed from " + std::to_string(findings.remeshed->given) + " to " +
            app::counted(findings.remeshed->left, "triangle") + ", at most " +
            rounded_up(*findings.remeshed->distance) + " from those before, which are at most " +
            rounded_up(*findings.remeshed->distance_back) + " from them\n";
  if (findings.subdivided)
    text += "  subdivided by " + std::string(name(findings.subdivided->rule)) + " " +
            app::counted(findings.subdivided->times, "time") + ", from " + std::to_string(findings.subdivided->given) +
            " to " + app::counted(findings.subdivided->left, "triangle") + "\n";
  return text;
}

std::size_t zero_area_faces(const Examined& mesh) {
  const auto& all = mesh.geometric_defects;
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [](const auto& d) { return d.kind == GeometryKind::zero_area_face; }));
}

std::string indented(const std::string& lines) {
  std::string text;
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = lines.find('\n', begin) + 1;
    text += "  " + lines.substr(begin, end - begin);
    begin = end;
  }
  return text;
}

std::string checks(const std::vector<CheckResult>& results) {
  std::string text = "\nchecks\n";
  for (const CheckResult& result : results) {
    const std::optional<long>& number = result.check.number;
    text += "  " + result.check.name + (number ? "=" + std::to_string(*number) : "") +
            (result.holds ? ": holds\n" : ": does not hold, found " + result.found + "\n");
  }
  return text;
}

}  // namespace

// Tell why the genus is undefined: a component is not orientable, or else an edge has more than two faces.
std::string genus_text(const meshops::TopologyReport& topology) {
  if (topology.genus) return std::to_string(*topology.genus);
  const bool orientable = std::all_of(topology.per_component.begin(), topology.per_component.end(),
                                      [](const meshops::ComponentReport& piece) { return piece.orientable; });
  return orientable ? "not a manifold" : "not orientable";
}

std::string report_text(const Findings& findings, std::size_t most) {
  const Examined& given = findings.given;
  std::string text = numbers(given);
  if (given.topology.per_component.size() > 1) text += pieces(given.topology.per_component, most);
  if (!given.defects.empty()) text += "\ndefects\n" + listed(given.defects, findings.mesh, most);
  if (!given.geometric_defects.empty())
    text += "\ngeometric defects\n" + listed(given.geometric_defects, findings.mesh, most);
  if (findings.repair)
    text += findings.repair->empty() ? "\nrepair: nothing to do\n"
                                     : "\nrepair\n" + listed(*findings.repair, findings.mesh, most);
  if (const std::size_t flat = zero_area_faces(given); findings.repair && !findings.edits.any() && flat > 0)
    text += "  left as they are: " + app::counted(flat, "zero-area face") + "\n";
  if (findings.has_changes()) text += changes(findings);
  if (findings.result) text += "\nresult\n" + indented(numbers(*findings.result));
  if (!findings.checks.empty()) text += checks(findings.checks);
  return text;
}

}  // namespace rbpa::app
