// What: keeps the counts of a mesh and the components of its vertices up to date while operators change the mesh.
// Law:  counts() equals count_topology(mesh) if every operator was reported.
// Cost: union–find time for operators that do not split a component; for others, the size of the smaller part.
#pragma once

#include <cstdint>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/disjoint_sets.h"
#include "meshops/handle/close_curve.h"
#include "meshops/handle/create.h"
#include "meshops/handle/glue.h"
#include "meshops/handle/unglue.h"
#include "meshops/handle/zip_curves.h"
#include "meshops/stellar/count_effects.h"
#include "meshops/topology/count.h"

namespace meshops {

/// Tracker of the counts of a mesh. Report each operator to note() before the next operator, with the effect that the
/// operator returned. The members glue() and zip_curves() perform the operator and report it; glue() then needs no
/// search through components. A flip changes nothing that is tracked. In place of remove_triangle(), call unglue() for
/// each side with a face beyond it, and then destroy_triangle().
/// Throws: ContractViolation if an effect contradicts the mesh, or names vertices that the tracker does not know
///         because an operator was not reported; the counts are then unchanged.
class MESHOPS_API TopologyTracker {
 public:
  /// Counts the mesh. Keeps a reference to the mesh. Requires: validate(mesh) is empty; not checked. Cost: near-linear.
  explicit TopologyTracker(Connectivity& mesh);

  const TopologyCounts& counts() const { return counts_; }
  /// Returns whether `a` and `b` are in one component, in union–find time. Throws ContractViolation unless both are
  /// live.
  bool in_same_component(Vertex a, Vertex b);

  /// Glues as glue() does (handle/glue.h), with the same requirements, and notes the effect. Cost: the degrees of the
  /// ends, and union–find time; for edges of one component that are not adjacent, also the shorter way between them
  /// along their curve, or the length of the shorter of their two curves.
  GlueEffect glue(Halfedge first, Halfedge second);
  /// Glues as zip_curves() does (handle/zip_curves.h), with the same requirements and cost, and notes the effect.
  ZipCurvesEffect zip_curves(Halfedge first, Halfedge second);

  void note_destroyed();  ///< notes a destroy_triangle()
  void note(const CreateTriangleEffect& effect);
  void note(const GlueEffect& effect);
  void note(const UnglueEffect& effect);
  void note(const CloseCurveEffect& effect);
  void note(const OpenCurveEffect& effect);
  void note(const SplitEffect& effect);
  void note(const WeldEffect& effect);
  void note_undone(const WeldEffect& effect);  ///< notes an undo() of this effect

 private:
  void change(const Delta& delta);
  void put(Vertex v, std::uint32_t node);
  std::uint32_t node(Vertex v) const;
  GlueCase case_of(Halfedge first, Halfedge second);
  std::uint32_t new_node();
  void forget_old_nodes();

  Connectivity& mesh_;
  TopologyCounts counts_;
  std::vector<std::uint32_t> node_of_;  // for each vertex, a number in nodes_; a part that splits off gets a new one
  DisjointSets nodes_;
};

}  // namespace meshops
