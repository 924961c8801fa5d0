#include "meshtopo/run_topology.h"

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <algorithm>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/output_file.h"
#include "io/write_mesh.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/examine.h"
#include "meshtopo/generators.h"
#include "meshtopo/places.h"
#include "meshtopo/report_json.h"
#include "meshtopo/report_text.h"

namespace rbpa::app {
namespace {

using Positions = std::vector<std::array<double, 3>>;

/// Loops need a surface: pinches come apart by themselves, anything else is refused.
void require_surface(const Findings& findings, const MeshSource& source) {
  const auto defect = std::find_if(findings.defects.begin(), findings.defects.end(), [](const meshops::SoupDefect& d) {
    return d.kind != meshops::SoupDefectKind::pinch;
  });
  if (defect == findings.defects.end()) return;
  const std::string name = source.path == "-" ? "standard input" : source.path;
  bad_input(name,
            std::string(meshops::name(defect->kind)) + " (" +
                for_people({defect->points, defect->faces}, findings.mesh) + ")",
            "a surface for --generators, or --repair");
}

std::vector<Polyline> generators_of(const meshops::PolygonSoup& soup, const Positions& positions) {
  OpenMesh::PolyConnectivity mesh;
  const std::vector<std::uint32_t> point_of = meshops::build_mesh(mesh, soup);
  stop_if_interrupted();
  return generators(mesh, point_of, positions);
}

}  // namespace

void run_topology(const TopologyArguments& arguments) {
  const TopologyPlan todo = plan(arguments);
  const MeshFile mesh = read_mesh(todo.source);
  stop_if_interrupted();
  meshops::Examination examination = meshops::examine(mesh.soup);
  Findings findings{.mesh = mesh, .topology = std::move(examination.report), .defects = std::move(examination.defects)};
  stop_if_interrupted();

  OutputSet outputs;
  const meshops::PolygonSoup* surface = &mesh.soup;
  Positions positions = mesh.positions;
  std::optional<meshops::Repair> repaired;
  if (todo.repaired) {
    repaired = meshops::repair(mesh.soup);
    findings.repair = repaired->steps;
    surface = &repaired->soup;
    for (std::size_t i = positions.size(); i < repaired->stands_on.size(); ++i)
      positions.push_back(mesh.positions[repaired->stands_on[i]]);
    stop_if_interrupted();
    OutputFile& file = outputs.add(todo.repaired->path);
    write_mesh(file, todo.repaired->format, positions, *surface);
    file.finish();
  }
  if (todo.generators) {
    if (!repaired) require_surface(findings, todo.source);
    OutputFile& file = outputs.add(todo.generators->path);
    write_polylines(file, todo.generators->format, positions, generators_of(*surface, positions));
    file.finish();
  }
  if (todo.report) {
    OutputFile& file = outputs.add(*todo.report);
    file.write(arguments.json ? report_json(findings) : report_text(findings, todo.max_defects));
    file.finish();
  }
  outputs.publish();
}

}  // namespace rbpa::app
