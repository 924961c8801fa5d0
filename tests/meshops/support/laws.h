// Checks of the laws of every operator.
#pragma once

#include <string>

#include "meshops/core/delta.h"
#include "meshops/topology/count.h"
#include "support/meshes.h"

namespace meshops::test {

/// Asserts that the counts changed exactly by `delta`, and that the mesh is sound.
void check_changed_by(const Delta& delta, const TopologyCounts& before, const Connectivity& after);

/// Asserts that `operate` throws a ContractViolation with the text `reason`, and changes no bit of the mesh.
template <typename Operate>
void check_refused(const TestMesh& mesh, const std::string& reason, Operate operate);

}  // namespace meshops::test

#include <doctest/doctest.h>

#include "meshops/core/contract.h"
#include "support/snapshot.h"

template <typename Operate>
void meshops::test::check_refused(const TestMesh& mesh, const std::string& reason, Operate operate) {
  const auto before = snapshot(mesh);
  std::string said;
  try {
    operate();
  } catch (const ContractViolation& violation) {
    said = violation.what();
  }
  CHECK(said.ends_with(reason));
  CHECK(snapshot(mesh) == before);
}
