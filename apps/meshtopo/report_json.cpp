#include "meshtopo/report_json.h"

#include <nlohmann/json.hpp>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/words.h"
#include "meshtopo/places.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<long>& value) { return value ? Json(*value) : Json(nullptr); }

/// Returns a defect, or a step of a repair, as JSON.
template <typename Item>
Json listed(const Item& item, const MeshFile& mesh) {
  return {{"kind", identifier(name(item.kind))}, {"where", as_json({item.points, item.faces}, mesh)}};
}

Json piece(const meshops::ComponentReport& p) {
  return {{"first_face", p.first_face}, {"vertices", p.vertices},      {"edges", p.edges},
          {"faces", p.faces},           {"euler", p.euler()},          {"boundary_curves", p.boundary_curves},
          {"orientable", p.orientable}, {"genus", or_null(p.genus())}, {"betti", p.betti()}};
}

/// Writes one object, with a line for each member and for each item of a list. Items are written one after another, as
/// a list may have millions of items.
class Object {
 public:
  explicit Object(OutputFile& file) : file_(file) {}

  void member(const std::string& key, const Json& value) {
    begin(key);
    file_.write(value.dump());
  }
  template <typename Items, typename AsJson>
  void list(const std::string& key, const Items& items, AsJson as_json) {
    begin(key);
    std::string_view before = "[\n    ";
    for (const auto& item : items) {
      stop_if_interrupted();
      file_.write(before);
      file_.write(as_json(item).dump());
      before = ",\n    ";
    }
    file_.write(items.empty() ? "[]" : "\n  ]");
  }
  void end() { file_.write("\n}"); }

 private:
  void begin(const std::string& key) {
    file_.write(before_ + Json(key).dump() + ": ");
    before_ = ",\n  ";
  }

  OutputFile& file_;
  std::string before_ = "{\n  ";
};

Json as_json(const Findings& findings) {
  const EditReport& edits = findings.edits;
  Json json = Json::object();
  if (edits.weld)
    json["weld"] = {{"distance", edits.weld->distance},
                    {"vertices_merged", edits.weld->vertices},
                    {"corners_dropped", edits.weld->corners},
                    {"degenerate_faces_dropped", edits.weld->degenerate_faces},
                    {"duplicate_faces_dropped", edits.weld->duplicate_faces}};
  if (edits.drop)
    json["drop"] = {
        {"components", edits.drop->components}, {"faces", edits.drop->faces}, {"vertices", edits.drop->vertices}};
  if (edits.orient)
    json["orient"] = {{"faces_reversed", edits.orient->faces},
                      {"facing_outward", edits.orient->outward},
                      {"facing_inward", edits.orient->inward},
                      {"nested", edits.orient->nested},
                      {"not_orientable", edits.orient->not_orientable}};
  if (findings.fill) {
    const auto& [rims, holes, islands] = findings.fill->not_chosen;
    json["fill"] = as_json(findings.fill->counts);
    json["fill"].erase("given_up");
    json["fill"]["not_chosen"] = {{"rim", rims}, {"hole", holes}, {"island", islands}};
    json["fill"]["vertices_merged"] = findings.fill->merged;
  }
  if (findings.tunnels)
    json["tunnels"] = {{"closed", findings.tunnels->closed},
                       {"left", findings.tunnels->left},
                       {"faces_removed", findings.tunnels->removed},
                       {"faces_added", findings.tunnels->added}};
  if (findings.decimated) json["decimate"] = app::as_json(*findings.decimated);
  if (findings.remeshed)
    json["remesh"] = {{"triangles_before", findings.remeshed->given},
                      {"triangles", findings.remeshed->left},
                      {"splits", findings.remeshed->splits},
                      {"collapses", findings.remeshed->collapses},
                      {"flips", findings.remeshed->flips},
                      {"distance", *findings.remeshed->distance},
                      {"distance_back", *findings.remeshed->distance_back}};
  if (findings.subdivided)
    json["subdivide"] = {{"rule", name(findings.subdivided->rule)},
                         {"times", findings.subdivided->times},
                         {"triangles_before", findings.subdivided->given},
                         {"triangles", findings.subdivided->left}};
  return json;
}

Json as_json(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json as_json(const Measures& measures) {
  return {{"area", measures.area},
          {"volume", as_json(measures.volume)},
          {"box", measures.box ? Json(*measures.box) : Json(nullptr)}};
}

Json as_json(const Examined& mesh) {
  const meshops::TopologyReport& t = mesh.topology;
  Json json = {{"vertices", t.vertices},
               {"edges", t.edges},
               {"faces", t.faces},
               {"euler", t.euler()},
               {"components", t.components},
               {"boundary_curves", t.boundary_curves},
               {"genus", or_null(t.genus)},
               {"betti", t.betti},
               {"pinches", t.pinches},
               {"isolated", t.isolated},
               {"defects", mesh.defects.size()},
               {"geometric_defects", mesh.geometric_defects.size()}};
  json.update(as_json(mesh.measures));
  return json;
}

Json as_json(const CheckResult& result) {
  const std::optional<long>& expected = result.check.number;
  return {{"check", result.check.name},
          {"expected", expected ? Json(*expected) : Json(true)},
          {"found", expected ? or_null(result.number) : Json(result.holds)},
          {"holds", result.holds}};
}

}  // namespace

void write_report_json(OutputFile& file, const Findings& findings, const std::string& name) {
  const meshops::TopologyReport& t = findings.given.topology;
  const auto in_file = [&](const auto& item) { return listed(item, findings.mesh); };
  Object report(file);
  if (!name.empty()) report.member("file", printable(name));
  report.member("vertices", t.vertices);
  report.member("edges", t.edges);
  report.member("faces", t.faces);
  report.member("euler", t.euler());
  report.member("components", t.components);
  report.member("boundary_curves", t.boundary_curves);
  report.member("genus", or_null(t.genus));
  report.member("betti", t.betti);
  report.member("pinches", t.pinches);
  report.member("isolated", t.isolated);
  report.list("defects", findings.given.defects, in_file);
  report.list("geometric_defects", findings.given.geometric_defects, in_file);
  const Json measures = as_json(findings.given.measures);
  for (const auto& [key, value] : measures.items()) report.member(key, value);
  report.list("per_component", t.per_component, piece);
  if (findings.repair) report.list("repair", *findings.repair, in_file);
  if (findings.has_changes()) report.member("changes", as_json(findings));
  if (findings.result) report.member("result", as_json(*findings.result));
  if (!findings.checks.empty())
    report.list("checks", findings.checks, [](const CheckResult& result) { return as_json(result); });
  report.end();
}

void write_error_json(OutputFile& file, const std::string& name, const std::string& error) {
  Object report(file);
  report.member("file", printable(name));
  report.member("error", printable(error));
  report.end();
}

}  // namespace rbpa::app
