// Simplification of any manifold, by a careless policy and by decimate(): the mesh stays sound, with its topology.
#include "meshops/simplify/simplify.h"

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "fuzz/target.h"
#include "meshops/core/live.h"
#include "meshops/core/validate.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/repair.h"
#include "meshops/topology/report.h"
#include "rbpa/base/error.h"
#include "rbpa/space/simplify/decimate_mesh.h"
#include "walk/choices.h"

namespace {

using meshops::Connectivity;
using meshops::Edge;
using meshops::Vertex;
using meshops::test::ByteChoices;

struct Thrown : std::runtime_error {
  Thrown() : std::runtime_error("thrown by the policy") {}
};

/// Returns at times a wrong value, or throws.
struct Careless {
  ByteChoices& choices;
  double number() {
    switch (choices.below(64)) {
      case 1:
        return std::numeric_limits<double>::quiet_NaN();
      case 2:
        return std::numeric_limits<double>::infinity();
      case 3:
        throw Thrown();
      default:
        return choices.below(256);
    }
  }
  std::optional<double> cost(const Connectivity&, Edge) {
    return choices.below(16) == 1 ? std::nullopt : std::optional(number());
  }
  double place(const Connectivity&, Edge) { return number(); }
  bool allows(const Connectivity&, Edge, double) { return choices.below(8) != 1; }
  double key(const Connectivity&, Vertex) { return choices.below(4); }
  Vertex survivor(const Connectivity& mesh, Edge e, double) {
    if (choices.below(64) == 1) return Vertex(static_cast<int>(choices.below(300)) - 2);
    return mesh.to_vertex_handle(mesh.halfedge_handle(e, choices.below(2)));
  }
  void merge(Connectivity&, const meshops::WeldEffect&, double) {
    if (choices.below(64) == 1) throw Thrown();
  }
  bool stops(const Connectivity&, Edge, double) { return choices.below(128) == 1; }
};

/// Fills an empty mesh with the repair of some triangles. Returns the place of each vertex, of small whole coordinates.
std::vector<rbpa::Point3> build(ByteChoices& choices, Connectivity& mesh) {
  meshops::PolygonSoup soup;
  soup.points = 3 + choices.below(14);
  std::vector<rbpa::Point3> points;
  for (std::size_t i = 0; i < soup.points; ++i)
    points.push_back({double(choices.below(4)), double(choices.below(4)), double(choices.below(3))});
  const auto corner = [&] { return choices.below(static_cast<unsigned>(soup.points)); };
  for (unsigned faces = choices.below(60); faces > 0 && choices.any_left(); --faces)
    soup.add_face(std::array<std::uint32_t, 3>{corner(), corner(), corner()});
  const meshops::Repair repaired = meshops::repair(soup);
  for (std::size_t f = 0; f < repaired.soup.faces(); ++f)
    if (repaired.soup.face(f).size() != 3) return {};  // a corner was dropped
  std::vector<rbpa::Point3> places;
  for (const std::uint32_t point : meshops::build_mesh(mesh, repaired.soup))
    places.push_back(points[repaired.stands_on[point]]);
  return places;
}

void check_same(const Connectivity& mesh, const meshops::TopologyReport& before) {
  fuzz::require(meshops::validate(mesh).empty(), "the mesh stays sound");
  const meshops::TopologyReport now = meshops::report(mesh);
  fuzz::require(now.betti == before.betti && now.genus == before.genus, "Betti numbers and genus stay");
  fuzz::require(now.boundary_curves == before.boundary_curves, "every boundary curve stays one");
  fuzz::require(now.components == before.components && now.solid_components == before.solid_components,
                "components stay");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ByteChoices choices({data, size});
  const bool is_careless = choices.one_in(2);
  OpenMesh::PolyConnectivity mesh;
  meshops::request_status(mesh);
  std::vector<rbpa::Point3> places = build(choices, mesh);
  const meshops::TopologyReport before = meshops::report(mesh);
  if (is_careless) {
    try {
      meshops::simplify(mesh, Careless{choices}, {.faces = choices.below(20)});
    } catch (const Thrown&) {
    } catch (const meshops::ContractViolation&) {
    }
    check_same(mesh, before);
    return 0;
  }
  rbpa::DecimationOptions options{
      .faces = choices.below(20), .measured = choices.one_in(2), .no_crossings = choices.one_in(2)};
  if (choices.one_in(2)) options.error = choices.below(256) / 64.0;
  const std::vector<rbpa::Point3> given = places;
  const rbpa::Decimation counts = rbpa::decimate(mesh, places, options, {.at_ends = choices.one_in(2)});
  check_same(mesh, before);
  fuzz::require(counts.left == meshops::report(mesh).faces, "the faces left are counted");
  fuzz::require(counts.left <= options.faces || counts.is_exhausted, "the run ends at the limit, or with no edge left");
  fuzz::require(counts.distance.has_value() == (options.measured || options.error), "the distance is there if wanted");
  if (options.error) fuzz::require(*counts.distance <= *options.error, "the distance is within the error");
  for (const rbpa::Point3& p : places) fuzz::require(rbpa::is_finite(p), "places are finite");
  return 0;
}
