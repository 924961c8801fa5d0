#include "meshtopo/run_topology.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "io/bytes/output_file.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/mesh/write_mesh.h"
#include "io/number.h"
#include "io/progress_line.h"
#include "meshops/topology/examine.h"
#include "meshtopo/check.h"
#include "meshtopo/generators.h"
#include "meshtopo/places.h"
#include "meshtopo/report_json.h"
#include "meshtopo/report_text.h"

namespace rbpa::app {
namespace {

std::string name_of(const MeshSource& source) { return source.path == "-" ? "standard input" : source.path; }

/// Replaces the numbers of vertices and faces in `item`, which refer to the edited mesh, by numbers in the file.
template <typename Item>
void number_as_in_file(Item& item, const EditedMesh& edited) {
  for (std::uint32_t& p : item.points) p = edited.point_was[p];
  for (std::size_t& f : item.faces) f = edited.face_was[f];
}

/// Throws BadInput unless the mesh is a surface without defects other than pinches, as `option` requires. The options
/// split pinches automatically.
void require_surface(const std::string& option, const Findings& findings,
                     const std::vector<meshops::SoupDefect>& defects, const MeshSource& source) {
  const auto defect = std::find_if(defects.begin(), defects.end(), [](const meshops::SoupDefect& d) {
    return d.kind != meshops::SoupDefectKind::pinch;
  });
  if (defect == defects.end()) return;
  bad_input(name_of(source),
            std::string(meshops::name(defect->kind)) + " (" +
                for_people({defect->points, defect->faces}, findings.mesh) + ")",
            "a surface, as " + option + " requires (--repair makes one, or rbpa surface --manifold)");
}

/// Throws BadInput if a face is not a triangle.
void require_triangles(const std::string& option, const MeshFile& mesh, const MeshSource& source) {
  if (const std::size_t polygons = polygons_in(mesh); polygons > 0)
    bad_input(name_of(source),
              app::counted(polygons, "face") + (polygons == 1 ? " that is" : " that are") + " no triangle",
              "triangles, as " + option + " requires (--repair OUT.stl writes triangles)");
}

/// The steps of a run, each with a progress line, and the data that the steps share.
class Run {
 public:
  explicit Run(const TopologyPlan& plan) : plan_(plan) {}

  ExitCode operator()() {
    if (plan_.sources.size() == 1)
      report_one();
    else
      report_all();
    outputs_.publish();
    return worst_;
  }

 private:
  /// Reads, changes, writes and checks one mesh, then calls report(findings).
  template <typename Report>
  void examine_mesh(const MeshSource& source, Report report) {
    const MeshFile mesh = read(source);
    for (const std::string& warning : mesh.warnings) say("meshtopo", name_of(source) + ": " + warning);
    if (!mesh.unused.empty() && (plan_.written || plan_.progressive))
      say("meshtopo", name_of(source) + ": the mesh is written without " + app::listed(mesh.unused, " and ") +
                          " (rbpa surface, which makes new triangles of the vertices, keeps those of vertices)");
    Findings findings = {.mesh = mesh, .given = examine(mesh)};
    std::optional<EditedMesh> edited;
    if (plan_.edits.any()) {
      edited = edit(mesh);
      findings.edits = edited->report;
    }
    const MeshFile& whole = edited ? edited->mesh : mesh;
    std::optional<MeshFile> repaired;
    if (plan_.repair) {
      meshops::Repair found = repair(whole);
      if (edited)
        for (meshops::RepairStep& step : found.steps) number_as_in_file(step, *edited);
      findings.repair = std::move(found.steps);
      repaired =
          MeshFile{.positions = whole.positions, .soup = std::move(found.soup), .point_lines = {}, .face_lines = {}};
      for (std::size_t i = whole.positions.size(); i < found.stands_on.size(); ++i)
        repaired->positions.push_back(whole.positions[found.stands_on[i]]);
    }
    const MeshFile& surface = repaired ? *repaired : whole;
    if (!repaired &&
        (plan_.fill || plan_.tunnels_below || plan_.decimate || plan_.remesh || plan_.subdivide || plan_.generators)) {
      std::vector<meshops::SoupDefect> defects =
          edited ? meshops::find_defects(whole.soup, until_interrupted()) : findings.given.defects;
      if (edited)
        for (meshops::SoupDefect& defect : defects) number_as_in_file(defect, *edited);
      require_surface(plan_.fill            ? "--fill-holes"
                      : plan_.tunnels_below ? "--close-tunnels-below"
                      : plan_.decimate      ? "--decimate"
                      : plan_.remesh        ? "--remesh"
                      : plan_.subdivide     ? "--subdivide"
                                            : "--generators",
                      findings, defects, source);
    }
    const MeshFile* last = &surface;  // the mesh of the last step
    std::optional<FilledMesh> filled;
    if (plan_.fill) {
      filled = fill(*last);
      findings.fill = filled->report;
      last = &filled->mesh;
    }
    std::optional<SimplerMesh> simpler;
    if (plan_.tunnels_below) {
      simpler = close_tunnels(*last);
      findings.tunnels = simpler->report;
      last = &simpler->mesh;
    }
    const MeshFile& closed = *last;
    std::optional<DecimatedMesh> decimated;
    if (plan_.decimate) {
      require_triangles("--decimate", *last, source);
      decimated = decimate(*last);
      findings.decimated = decimated->report;
      last = &decimated->mesh;
    }
    if (plan_.progressive)
      write(outputs_.add(*plan_.progressive),
            [&](OutputFile& file) { file.write_binary(std::span<const std::byte>(decimated->progressive)); });
    std::optional<RemeshedMesh> remeshed;
    if (plan_.remesh) {
      require_triangles("--remesh", *last, source);
      remeshed = remesh(*last, source);
      findings.remeshed = remeshed->report;
      last = &remeshed->mesh;
      warn_if_far(*plan_.remesh, remeshed->report, source);
    }
    std::optional<SubdividedMesh> subdivided;
    if (plan_.subdivide) {
      require_triangles("--subdivide", *last, source);
      subdivided = subdivide(*last, source);
      findings.subdivided = subdivided->report;
      last = &subdivided->mesh;
    }
    const MeshFile& result = *last;
    if (remeshed || subdivided || (decimated && !plan_.decimate->no_crossings))
      warn_if_crossing(closed, result, source);
    const bool is_stl = plan_.written && plan_.written->format == Format::stl;
    const bool is_wanted = findings.has_changes() || (repaired && !plan_.checks.empty());
    const bool is_kept = !is_stl || keep_in_stl(result, is_wanted, findings);
    if (is_wanted && !is_stl) findings.result = examine(result);
    if (plan_.written && is_kept)
      write(outputs_.add(plan_.written->path), [&](OutputFile& file) {
        write_mesh(file, plan_.written->format, result.positions, result.soup, plan_.shift);
      });
    if (plan_.generators) {
      const Generators found = find_loops(result);
      write(outputs_.add(plan_.generators->path), [&](OutputFile& file) {
        write_polylines(file, plan_.generators->format, result.positions, found.loops, found.kinds);
      });
    }
    check(findings, source);
    report(findings);
  }

  /// Prints a warning if faces of the result of --decimate, --remesh or --subdivide cross, and none did before.
  void warn_if_crossing(const MeshFile& before, const MeshFile& after, const MeshSource& source) const {
    const ProgressLine shown = line("crossings");
    if (count_crossings(after, 1) == 0 || count_crossings(before, 1) > 0) return;
    say("meshtopo", name_of(source) + ": faces of the result cross, and none did before (" +
                        (plan_.subdivide ? "--subdivide moves vertices"
                         : plan_.remesh  ? "--remesh with a lesser length, or error=E"
                                         : "--no-crossings") +
                        ")");
  }

  /// Prints a warning if a distance exceeds --remesh error=E: that of the result by rounding, or that of the mesh
  /// before from the result, which is not limited, by more than a fifth, as where thin parts vanish.
  static void warn_if_far(const RemeshOptions& wanted, const Remeshing& made, const MeshSource& source) {
    if (!wanted.error || (*made.distance <= *wanted.error && *made.distance_back <= 1.2 * *wanted.error)) return;
    say("meshtopo", name_of(source) + ": --remesh: the result is at most " + rounded_up(*made.distance) +
                        " from the mesh before, which is at most " + rounded_up(*made.distance_back) +
                        " from the result: more than error=" + text_of(*wanted.error) + " (a lesser error)");
  }

  /// Examines the mesh that a reader of the STL file gets, and prints warnings about losses. Returns whether to write
  /// the file.
  bool keep_in_stl(const MeshFile& mesh, bool is_wanted, Findings& findings) {
    const std::string& name = plan_.written->path;
    const TriangulatedFaces faces(mesh.positions, mesh.soup);
    const SinglePositions positions = single_positions(Format::stl, faces.vertices, faces.triangles, plan_.shift, name);
    const std::string why = why_not_kept(positions, Format::stl, faces.vertices, faces.triangles, name);
    const MeshFile kept = as_stl_mesh(positions, faces.triangles);
    const bool joins = kept.positions.size() < mesh.positions.size();  // also if a vertex has no face
    if (is_wanted || joins) findings.result = examine(kept);
    if (joins && why.empty()) {
      const auto count = [&](meshops::SoupDefectKind kind) {
        const auto& defects = findings.result->defects;
        return static_cast<std::size_t>(
            std::count_if(defects.begin(), defects.end(), [&](const auto& defect) { return defect.kind == kind; }));
      };
      const std::size_t edges = count(meshops::SoupDefectKind::non_manifold_edge),
                        vertices = count(meshops::SoupDefectKind::pinch);
      if (edges > 0)
        say("meshtopo", name + ": STL joins points at equal positions, so " + app::counted(edges, "edge") +
                            (edges == 1 ? " that was cut is" : " that were cut are") +
                            " non-manifold again (.ply, .obj and .off keep " + (edges == 1 ? "it" : "them") + " cut)");
      if (vertices > 0)
        say("meshtopo", name + ": STL cannot keep apart the vertices of " + app::counted(vertices, "place") +
                            " at which surfaces touch (.ply, .obj and .off can)");
      if (!is_wanted) findings.result.reset();
    }
    const std::string shifted = text_of_shift(Format::stl, faces.vertices, faces.triangles, plan_.shift, name);
    if (why.empty() && !shifted.empty()) say("meshtopo", shifted);
    if (why.empty()) return true;
    say("meshtopo", why + "; it is not written");
    if (worst_ == done) worst_ = check_failed;
    return false;
  }

  void report_one() {
    examine_mesh(plan_.sources.front(), [&](const Findings& findings) {
      if (plan_.report)
        write(outputs_.add(plan_.report->path), [&](OutputFile& file) {
          if (plan_.report->format == Format::json) {
            write_report_json(file, findings);
            file.write("\n");
          } else {
            file.write(report_text(findings, plan_.max_defects));
          }
        });
    });
  }

  /// Reports one mesh after another, and keeps no report in memory.
  void report_all() {
    OutputFile* const file = plan_.report ? &outputs_.add(plan_.report->path) : nullptr;
    const bool as_json = plan_.report && plan_.report->format == Format::json;
    for (std::size_t i = 0; i < plan_.sources.size(); ++i) {
      const MeshSource& source = plan_.sources[i];
      if (file && as_json) file->write(i == 0 ? "[\n" : ",\n");
      if (file && !as_json) file->write((i == 0 ? "" : "\n") + printable(source.path) + ":\n");
      try {
        examine_mesh(source, [&](const Findings& findings) {
          if (as_json)
            write_report_json(*file, findings, source.path);
          else if (file)
            file->write(report_text(findings, plan_.max_defects));
        });
      } catch (const BadInput& error) {
        say("meshtopo", error.what());
        worst_ = bad_input_given;
        if (as_json)
          write_error_json(*file, source.path, error.what());
        else if (file)
          file->write("no report: " + printable(error.what()) + "\n");
      }
    }
    if (!file) return;
    if (as_json) file->write("\n]\n");
    file->finish();
  }

  /// Evaluates the checks for the resulting mesh, and prints the checks that fail.
  void check(Findings& findings, const MeshSource& source) {
    for (const Check& wanted : plan_.checks) {
      findings.checks.push_back(evaluate(wanted, findings.result ? *findings.result : findings.given));
      if (findings.checks.back().holds) continue;
      say("meshtopo", name_of(source) + ": " + failure_of(findings.checks.back()));
      if (worst_ == done) worst_ = check_failed;
    }
  }

  /// Returns a progress line that shows `doing`. The line shows nothing with --quiet or if `in_the_way` is true.
  ProgressLine line(const std::string& doing, bool in_the_way = false) const {
    return {"meshtopo", !plan_.quiet && !in_the_way, doing};
  }

  MeshFile read(const MeshSource& source) const {
    const ProgressLine shown = line("reading", read_from_terminal(source.path));
    return plan_.at_faces ? read_progressive(source.path, *plan_.at_faces) : read_mesh(source);
  }

  Examined examine(const MeshFile& mesh) const {
    constexpr auto all = std::numeric_limits<std::size_t>::max();
    const ProgressLine shown = line("topology of " + short_number(static_cast<double>(mesh.soup.faces())) + " faces");
    meshops::Examination found = meshops::examine(mesh.soup, until_interrupted());
    return {.topology = std::move(found.report),
            .defects = std::move(found.defects),
            .geometric_defects = find_geometric_defects(mesh),
            .measures = measure(mesh),
            .crossings = requires_crossings(plan_.checks) ? count_crossings(mesh, all) : 0};
  }

  EditedMesh edit(const MeshFile& mesh) const {
    const ProgressLine shown = line("changes");
    return app::edit(mesh, plan_.edits);
  }

  meshops::Repair repair(const MeshFile& mesh) const {
    const ProgressLine shown = line("repair");
    return meshops::repair(mesh.soup, until_interrupted());
  }

  FilledMesh fill(const MeshFile& mesh) const {
    const ProgressLine shown = line("filling holes");
    return app::fill(mesh, *plan_.fill);
  }

  SimplerMesh close_tunnels(const MeshFile& mesh) const {
    const ProgressLine shown = line("closing tunnels");
    return app::close_tunnels(mesh, *plan_.tunnels_below);
  }

  DecimatedMesh decimate(const MeshFile& mesh) const {
    const ProgressLine shown = line("decimating");
    return app::decimate(mesh, *plan_.decimate, plan_.progressive.has_value());
  }

  RemeshedMesh remesh(const MeshFile& mesh, const MeshSource& source) const try {
    const ProgressLine shown = line("remeshing");
    return app::remesh(mesh, *plan_.remesh);
  } catch (const InvalidInput& error) {
    throw BadInput(name_of(source) + ": --" + error.what());
  }

  SubdividedMesh subdivide(const MeshFile& mesh, const MeshSource& source) const try {
    const ProgressLine shown = line("subdividing");
    return app::subdivide(mesh, *plan_.subdivide);
  } catch (const InvalidInput& error) {
    throw BadInput(name_of(source) + ": --" + error.what());
  }

  Generators find_loops(const MeshFile& mesh) const {
    const ProgressLine shown = line("loops");
    return generators(mesh.soup, mesh.positions, plan_.shortest);
  }

  template <typename Content>
  void write(OutputFile& file, Content content) const {
    const ProgressLine shown = line("writing", written_to_terminal(plan_.outputs()));
    content(file);
    file.finish();
  }

  const TopologyPlan& plan_;
  OutputSet outputs_;
  ExitCode worst_ = done;
};

}  // namespace

ExitCode run_topology(const TopologyArguments& arguments) {
  const TopologyPlan todo = plan(arguments);
  Run run(todo);
  return run();
}

}  // namespace rbpa::app
