#include "meshtopo/report_text.h"

#include <algorithm>

#include "io/interrupt.h"
#include "meshtopo/places.h"

namespace rbpa::app {
namespace {

std::string right(std::string text, std::size_t width) {
  if (text.size() < width) text.insert(0, width - text.size(), ' ');
  return text;
}

/// Why there is no genus: a piece has one side only, or else three faces meet in an edge.
std::string genus_text(const meshops::TopologyReport& t) {
  if (t.genus) return std::to_string(*t.genus);
  const bool orientable = std::all_of(t.per_component.begin(), t.per_component.end(),
                                      [](const meshops::ComponentReport& piece) { return piece.orientable; });
  return orientable ? "not a manifold" : "not orientable";
}

std::string genus_text(const meshops::ComponentReport& piece) {
  return piece.orientable ? std::to_string(*piece.genus()) : "not orientable";
}

std::string numbers(const Findings& findings) {
  const meshops::TopologyReport& t = findings.topology;
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
      {"defects", std::to_string(findings.defects.size())},
      {"geometric defects", std::to_string(findings.geometric_defects.size())}};
  std::size_t width = 0;
  for (const auto& row : rows)
    if (row.first != "genus") width = std::max(width, row.second.size());  // which may be words
  std::string text;
  for (const auto& [label, value] : rows) {
    text += label;
    text += right(value, 19 - label.size() + width) + "\n";
  }
  return text;
}

/// "  ... and 5 more".
std::string rest(std::size_t all, std::size_t shown) {
  return all > shown ? "  ... and " + std::to_string(all - shown) + " more\n" : "";
}

std::string pieces(const std::vector<meshops::ComponentReport>& all, std::size_t most) {
  const bool orientable = std::all_of(all.begin(), all.end(), [](const auto& piece) { return piece.orientable; });
  const std::size_t width = orientable ? 10 : genus_text(meshops::ComponentReport{.orientable = false}).size();
  std::string text = "\npieces of surface, connected through edges\n";
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
          genus_text(piece)})
      text += "  " + right(value, width);
    text += "\n";
  }
  return text + rest(all.size(), shown);
}

/// What is wrong, or steps of a repair.
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

}  // namespace

std::string report_text(const Findings& findings, std::size_t most) {
  std::string text = numbers(findings);
  if (findings.topology.per_component.size() > 1) text += pieces(findings.topology.per_component, most);
  if (!findings.defects.empty()) text += "\ndefects\n" + listed(findings.defects, findings.mesh, most);
  if (!findings.geometric_defects.empty())
    text += "\ngeometric defects\n" + listed(findings.geometric_defects, findings.mesh, most);
  if (findings.repair)
    text += findings.repair->empty() ? "\nrepair: nothing to do\n"
                                     : "\nrepair\n" + listed(*findings.repair, findings.mesh, most);
  return text;
}

}  // namespace rbpa::app
