// Remeshing of any manifold to any length: the mesh stays sound, with its topology, and is the same in another order.
#include "rbpa/space/simplify/remesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/small_mesh.h"
#include "fuzz/target.h"
#include "meshops/topology/report.h"
#include "rbpa/base/error.h"

namespace {

using meshops::test::ByteChoices;

/// Returns a number of small size or, at times, of any bits.
double any_number(ByteChoices& choices, double unit) {
  if (!choices.one_in(8)) return unit * (1 + choices.below(256));
  std::uint64_t bits = 0;
  for (int i = 0; i < 8; ++i) bits = bits << 8 | choices.below(256);
  return std::bit_cast<double>(bits);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ByteChoices choices({data, size});
  rbpa::RemeshOptions options{.length = any_number(choices, 1.0 / 64),
                              .rounds = choices.below(4),
                              .sharp_angle = any_number(choices, 180.0 / 256),
                              .keep_boundary = choices.one_in(2),
                              .most_faces = 2000,
                              .measured = choices.one_in(2),
                              .single_precision = choices.one_in(2)};
  int calls = choices.one_in(8) ? static_cast<int>(choices.below(256)) : -1;
  options.go_on = [&] { return calls-- != 0; };
  const int power = choices.one_in(4) ? static_cast<int>(choices.below(256)) * 2 - 256 : 0;
  const bool is_odd = choices.one_in(16);
  OpenMesh::PolyConnectivity mesh;
  meshops::request_status(mesh);
  std::vector<rbpa::Point3> places = fuzz::build(choices, mesh);
  for (rbpa::Point3& p : places)
    p = {std::ldexp(p.x, power), std::ldexp(p.y, power), std::ldexp(p.z + 0.25 * choices.below(4), power)};
  options.length = std::ldexp(options.length, power);
  if (is_odd && !places.empty()) places[choices.below(static_cast<unsigned>(places.size()))].x = any_number(choices, 1);
  const std::vector<rbpa::Point3> given = places;
  const meshops::TopologyReport before = meshops::report(mesh);
  const auto corners = meshops::soup_of(mesh).corners;
  try {
    const rbpa::Remeshing counts = rbpa::remesh(mesh, places, options);
    fuzz::require(counts.left == mesh.n_faces() && counts.given == before.faces, "triangles are counted");
    fuzz::require(counts.distance.has_value() == options.measured, "the distance is there if wanted");
    fuzz::require(places.size() == mesh.n_vertices(), "each vertex has a place");
    fuzz::require(std::is_sorted(places.begin(), places.end()), "vertices ascend by their places");
    for (const rbpa::Point3& p : places) fuzz::require(rbpa::is_finite(p), "places are finite");
  } catch (const rbpa::InvalidInput& why) {
    fuzz::require(std::string(why.what()).starts_with("remesh: found "), "a refusal tells what was found");
    fuzz::require(places == given || is_odd, "a refusal leaves the places alone");
    fuzz::require(meshops::soup_of(mesh).corners == corners, "a refusal leaves the mesh alone");
  } catch (const meshops::Cancelled&) {
    fuzz::require(places == given && meshops::soup_of(mesh).corners == corners,
                  "a run that is cancelled changes nothing");
  }
  fuzz::check_same(mesh, before);
  return 0;
}
