// What: keeps the counts of a mesh and the components of its vertices up to date while operators change it.
// Law:  counts() equals count_topology(mesh) when every operator was reported.
// Cost: union–find time for operators that only join; for operators that split a component, the size of the smaller
//       of its two parts.
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

/// Tracker of the counts of a mesh. Report each operator to note(), with the effect that the operator returned, before
/// the next operator. The members glue() and zip_curves() perform and report the operator; glue() needs no search
/// through components. A flip changes nothing that is tracked. In place of remove_triangle(), call unglue() for each
/// glued side and then destroy_triangle().
/// Throws: ContractViolation when an effect names elements that do not exist, or vertices that the tracker does not
///         know because an operator was not reported; the counts are then unchanged.
class MESHOPS_API TopologyTracker {
 public:
  /// Counts the mesh. Keeps a reference to the mesh. Requires: validate(mesh) is empty; not checked. Cost: near-linear.
  explicit TopologyTracker(Connectivity& mesh);

  const TopologyCounts& counts() const { return counts_; }
  /// Returns whether two vertices are in one component, in union–find time. Throws ContractViolation unless both live.
  bool in_same_component(Vertex a, Vertex b);

  /// Glues as glue() does (handle/glue.h), with the same requirements, and notes the effect. Cost: union–find time when
  /// the edges are on two components or adjacent; otherwise the shorter of two ways along a curve, or the shorter of
  /// two curves; and the degrees of vertices that become one.
  GlueEffect glue(Halfedge first, Halfedge second);
  /// Sews as zip_curves() does (handle/zip_curves.h), with the same requirements and cost, and notes the effect.
  ZipCurvesEffect zip_curves(Halfedge first, Halfedge second);

  void note_destroyed();  ///< for destroy_triangle()
  void note(const CreateTriangleEffect& effect);
  void note(const GlueEffect& effect);
  void note(const UnglueEffect& effect);
  void note(const CloseCurveEffect& effect);
  void note(const OpenCurveEffect& effect);
  void note(const SplitEffect& effect);
  void note(const WeldEffect& effect);
  void note_undone(const WeldEffect& effect);  ///< for undo(): takes the effect that was undone

 private:
  void change(const Delta& delta);
  void put(Vertex v, std::uint32_t node);
  std::uint32_t node(Vertex v) const;
  GlueCase case_of(Halfedge first, Halfedge second);
  std::uint32_t new_node();
  void forget_old_nodes();

  Connectivity& mesh_;
  TopologyCounts counts_;
  std::vector<std::uint32_t> node_of_;  // for each vertex; a component that splits off gets a new node
  DisjointSets nodes_;
};

}  // namespace meshops
