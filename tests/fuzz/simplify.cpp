// Simplification of any manifold, by a careless policy and by decimate(): the mesh stays sound, with its topology.
#include "meshops/simplify/simplify.h"

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "fuzz/small_mesh.h"
#include "fuzz/target.h"
#include "meshops/topology/report.h"
#include "rbpa/space/simplify/decimate_mesh.h"

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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ByteChoices choices({data, size});
  const bool is_careless = choices.one_in(2);
  OpenMesh::PolyConnectivity mesh;
  meshops::request_status(mesh);
  std::vector<rbpa::Point3> places = fuzz::build(choices, mesh);
  const meshops::TopologyReport before = meshops::report(mesh);
  if (is_careless) {
    try {
      meshops::simplify(mesh, Careless{choices}, {.faces = choices.below(20)});
    } catch (const Thrown&) {
    } catch (const meshops::ContractViolation&) {
    }
    fuzz::check_same(mesh, before);
    return 0;
  }
  rbpa::DecimationOptions options{
      .faces = choices.below(20), .measured = choices.one_in(2), .no_crossings = choices.one_in(2)};
  if (choices.one_in(2)) options.error = choices.below(256) / 64.0;
  const std::vector<rbpa::Point3> given = places;
  const rbpa::Decimation counts = rbpa::decimate(mesh, places, options, {.at_ends = choices.one_in(2)});
  fuzz::check_same(mesh, before);
  fuzz::require(counts.left == meshops::report(mesh).faces, "the faces left are counted");
  fuzz::require(counts.left <= options.faces || counts.is_exhausted, "the run ends at the limit, or with no edge left");
  fuzz::require(counts.distance.has_value() == (options.measured || options.error), "the distance is there if wanted");
  if (options.error) fuzz::require(*counts.distance <= *options.error, "the distance is within the error");
  for (const rbpa::Point3& p : places) fuzz::require(rbpa::is_finite(p), "places are finite");
  return 0;
}
