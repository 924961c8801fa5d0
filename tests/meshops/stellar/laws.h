// The laws that every stellar operator keeps on every mesh, and the meshes on which they are checked.
#pragma once

#include <doctest/doctest.h>

#include <functional>
#include <optional>
#include <string>

#include "meshops/core/contract.h"
#include "meshops/core/delta.h"
#include "meshops/core/live.h"
#include "meshops/stellar/keep.h"
#include "support/arguments.h"
#include "support/check_sound.h"
#include "support/corpus.h"
#include "support/on_corpus.h"
#include "support/snapshot.h"

namespace meshops::test {

/// Returns the six counts of a mesh.
Delta counts(const Connectivity& mesh);

/// Returns whether no two edges join the same vertices, and no two triangles have the same corners.
bool is_simplicial(const Connectivity& mesh);

/// Visits the corpus and 300 random gluings of a few triangles (fewer outside nightly runs), in which everything that
/// can coincide does; once with each Keep. The mesh may be changed and must be restored.
void on_every_mesh(const std::function<void(TestMesh&, Keep)>& visit);

/// Makes the least sphere: two triangles with three common edges.
void two_triangle_sphere(TestMesh& mesh);

/// Makes a small mesh with degenerate places, closed or with a boundary; the same mesh for the same number.
void random_tiny_mesh(TestMesh& mesh, unsigned number);

inline bool is_large(const Connectivity& mesh) { return mesh.n_faces() > 300; }

/// Returns the stride over elements: every seventh element of a large mesh is tried, fewer outside nightly runs.
inline int stride(const Connectivity& mesh) { return !is_large(mesh) ? 1 : rbpa_test::all_trials() ? 7 : 61; }

/// Checks that the blocker returns a reason and the operator throws the same, with nothing changed; or that both
/// accept.
template <typename Operate>
bool refuses(TestMesh& mesh, const std::optional<Blocker>& blocker, Operate operate) {
  if (!blocker) return false;
  const auto before = snapshot(mesh);
  std::string thrown;
  try {
    operate();
  } catch (const ContractViolation& violation) {
    thrown = violation.what();
  }
  CHECK_MESSAGE(thrown.ends_with(": " + describe(*blocker)), describe(*blocker), " but thrown was: ", thrown);
  CHECK(snapshot(mesh) == before);
  return true;
}

/// Checks that a split does what it promises, and that `inverse` of its effect restores every live record.
template <typename Split, typename Inverse>
void check_split(TestMesh& mesh, Keep keep, Split split, Inverse inverse) {
  const auto live = live_snapshot(mesh);
  const Delta before = counts(mesh);
  const bool was_simplicial = !is_large(mesh) && is_simplicial(mesh);
  const auto effect = split();
  check_sound(mesh);
  CHECK(counts(mesh) == before + effect.delta());
  if (was_simplicial && keep == Keep::simplicial) CHECK(is_simplicial(mesh));
  inverse(effect);
  check_sound(mesh);
  CHECK(live_snapshot(mesh) == live);
  mesh.garbage_collection();
  CHECK(live_snapshot(mesh) == live);
}

/// Checks that a weld does what it promises, that `inverse` of its effect restores the mesh up to handles, and
/// `take_back` every bit.
template <typename Weld, typename Inverse, typename TakeBack>
void check_weld(TestMesh& mesh, Keep keep, const std::string& shape, Weld weld, Inverse inverse, TakeBack take_back) {
  const auto records = snapshot(mesh);
  const Delta before = counts(mesh);
  const bool was_simplicial = !is_large(mesh) && is_simplicial(mesh);
  const auto effect = weld();
  check_sound(mesh);
  CHECK(counts(mesh) == before + effect.delta());
  if (was_simplicial && keep == Keep::simplicial) CHECK(is_simplicial(mesh));
  TestMesh copy = mesh;
  inverse(copy, effect);
  check_sound(copy);
  CHECK(isomorphism_class(copy) == shape);
  take_back(effect);
  CHECK(snapshot(mesh) == records);
}

}  // namespace meshops::test
