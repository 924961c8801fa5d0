#include "meshtopo/report_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "meshtopo/places.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<long>& value) { return value ? Json(*value) : Json(nullptr); }

/// "non_manifold_edge" for "non-manifold edge".
std::string identifier(std::string_view words) {
  std::string text(words);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ' ' || c == '-'; }, '_');
  return text;
}

/// Defects, or steps of a repair.
template <typename Item>
Json listed(const std::vector<Item>& items, const MeshFile& mesh) {
  Json list = Json::array();
  for (const Item& item : items)
    list.push_back({{"kind", identifier(name(item.kind))}, {"where", as_json({item.points, item.faces}, mesh)}});
  return list;
}

Json piece(const meshops::ComponentReport& p) {
  return {{"first_face", p.first_face}, {"vertices", p.vertices},      {"edges", p.edges},
          {"faces", p.faces},           {"euler", p.euler()},          {"boundary_curves", p.boundary_curves},
          {"orientable", p.orientable}, {"genus", or_null(p.genus())}, {"betti", p.betti()}};
}

/// A member a line, and of a list of objects an object a line.
std::string in_lines(const Json& object) {
  std::string text = "{";
  const char* before = "\n  ";
  for (const auto& [key, value] : object.items()) {
    text.append(before).append(Json(key).dump()).append(": ");
    before = ",\n  ";
    if (!value.is_array() || value.empty() || !value[0].is_object()) {
      text += value.dump();
      continue;
    }
    const char* before_item = "[\n    ";
    for (const Json& item : value) {
      text.append(before_item).append(item.dump());
      before_item = ",\n    ";
    }
    text += "\n  ]";
  }
  return text + "\n}\n";
}

}  // namespace

std::string report_json(const Findings& findings) {
  const meshops::TopologyReport& t = findings.topology;
  Json pieces = Json::array();
  for (const meshops::ComponentReport& p : t.per_component) pieces.push_back(piece(p));
  Json report = {{"vertices", t.vertices},
                 {"edges", t.edges},
                 {"faces", t.faces},
                 {"euler", t.euler()},
                 {"components", t.components},
                 {"boundary_curves", t.boundary_curves},
                 {"genus", or_null(t.genus)},
                 {"betti", t.betti},
                 {"pinches", t.pinches},
                 {"isolated", t.isolated},
                 {"defects", listed(findings.defects, findings.mesh)},
                 {"per_component", pieces}};
  if (findings.repair) report["repair"] = listed(*findings.repair, findings.mesh);
  return in_lines(report);
}

}  // namespace rbpa::app
