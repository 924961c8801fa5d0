#include "meshtopo/run_topology.h"

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <algorithm>
#include <utility>

#include "io/bytes/output_file.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/mesh/write_mesh.h"
#include "io/progress_line.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/examine.h"
#include "meshtopo/generators.h"
#include "meshtopo/places.h"
#include "meshtopo/report_json.h"
#include "meshtopo/report_text.h"

namespace rbpa::app {
namespace {

using PositionSpan = std::span<const std::array<double, 3>>;

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

std::vector<Polyline> generators_of(const meshops::PolygonSoup& soup, PositionSpan positions) {
  OpenMesh::PolyConnectivity mesh;
  const std::vector<std::uint32_t> point_of = meshops::build_mesh(mesh, soup, until_interrupted());
  return generators(mesh, point_of, positions);
}

/// The parts of a run, each with its line on the terminal, and what is passed from one to the next.
class Run {
 public:
  explicit Run(const TopologyPlan& plan) : plan_(plan) {}

  void operator()() {
    const MeshFile mesh = read();
    Findings findings = examine(mesh);
    OutputSet outputs;
    const meshops::PolygonSoup* surface = &mesh.soup;
    std::vector<std::array<double, 3>> moved;  // when there are more than in the file
    std::optional<meshops::Repair> repaired;
    if (plan_.repaired) {
      repaired = repair(mesh, findings);
      surface = &repaired->soup;
      moved = mesh.positions;
      for (std::size_t i = moved.size(); i < repaired->stands_on.size(); ++i)
        moved.push_back(mesh.positions[repaired->stands_on[i]]);
      write(outputs.add(plan_.repaired->path),
            [&](OutputFile& file) { write_mesh(file, plan_.repaired->format, moved, *surface); });
    }
    if (plan_.generators) {
      if (!repaired) require_surface(findings, plan_.source);
      const PositionSpan positions = repaired ? PositionSpan(moved) : PositionSpan(mesh.positions);
      const std::vector<Polyline> loops = find_loops(*surface, positions);
      write(outputs.add(plan_.generators->path),
            [&](OutputFile& file) { write_polylines(file, plan_.generators->format, positions, loops); });
    }
    if (plan_.report)
      write(outputs.add(plan_.report->path), [&](OutputFile& file) {
        if (plan_.report->format == Format::json)
          write_report_json(file, findings);
        else
          file.write(report_text(findings, plan_.max_defects));
      });
    outputs.publish();
  }

 private:
  /// Shown unless quiet, and unless it would be in the way of what is read or written at the terminal.
  ProgressLine line(const std::string& doing, bool in_the_way = false) const {
    return {"meshtopo", !plan_.quiet && !in_the_way, doing};
  }

  MeshFile read() const {
    const ProgressLine shown = line("reading", read_from_terminal(plan_.source.path));
    return read_mesh(plan_.source);
  }

  Findings examine(const MeshFile& mesh) const {
    const ProgressLine shown = line("topology of " + short_number(static_cast<double>(mesh.soup.faces())) + " faces");
    meshops::Examination found = meshops::examine(mesh.soup, until_interrupted());
    return {.mesh = mesh,
            .topology = std::move(found.report),
            .defects = std::move(found.defects),
            .geometric_defects = find_geometric_defects(mesh)};
  }

  meshops::Repair repair(const MeshFile& mesh, Findings& findings) const {
    const ProgressLine shown = line("repair");
    meshops::Repair repaired = meshops::repair(mesh.soup, until_interrupted());
    findings.repair = repaired.steps;
    return repaired;
  }

  std::vector<Polyline> find_loops(const meshops::PolygonSoup& soup, PositionSpan positions) const {
    const ProgressLine shown = line("loops");
    return generators_of(soup, positions);
  }

  template <typename Content>
  void write(OutputFile& file, Content content) const {
    const ProgressLine shown = line("writing", written_to_terminal(plan_.outputs()));
    content(file);
    file.finish();
  }

  const TopologyPlan& plan_;
};

}  // namespace

void run_topology(const TopologyArguments& arguments) {
  const TopologyPlan todo = plan(arguments);
  Run run(todo);
  run();
}

}  // namespace rbpa::app
