#include "support/laws.h"
#include "support/check_sound.h"

namespace meshops::test {

void check_changed_by(const Delta& delta, const TopologyCounts& before, const Connectivity& mesh) {
  const TopologyCounts after = count_topology(mesh);
  const auto change = [](std::size_t b, std::size_t a) { return static_cast<int>(a) - static_cast<int>(b); };
  CHECK(change(before.vertices, after.vertices) == delta.vertices);
  CHECK(change(before.edges, after.edges) == delta.edges);
  CHECK(change(before.faces, after.faces) == delta.faces);
  CHECK(change(before.boundary_curves, after.boundary_curves) == delta.curves);
  CHECK(change(before.components, after.components) == delta.components);
  CHECK(after.genus() - before.genus() == delta.genus);
  CHECK(after.euler() - before.euler() == delta.euler());
  check_sound(mesh);
}

}  // namespace meshops::test
