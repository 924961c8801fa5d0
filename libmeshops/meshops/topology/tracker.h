// What: keeps the counts of a mesh and the components of its vertices up to date while operators change it.
// Law:  after every operator that was recorded, counts() equals count_topology(mesh).
// Cost: union–find time for operators that only join; what parts a component pays for the smaller of the two parts.
#pragma once

#include <cstdint>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/disjoint_sets.h"
#include "meshops/handle/close_curve.h"
#include "meshops/handle/glue.h"
#include "meshops/handle/unglue.h"
#include "meshops/handle/zip_curves.h"
#include "meshops/stellar/effect.h"
#include "meshops/topology/count.h"

namespace meshops {

/// Report each operator with note() and the effect it returned, before the next operator. Operators that depend on
/// components are also members: these use the tracker's components instead of a search. A flip
/// changes nothing that is tracked. A remove_triangle() is to be done as its unglue() and destroy_triangle().
/// What names elements that are not there, or that was not recorded, is a ContractViolation, and nothing is changed.
class MESHOPS_API TopologyTracker {
 public:
  /// Counts once. Keeps a reference. Requires: validate(mesh) is empty.
  explicit TopologyTracker(Connectivity& mesh);

  const TopologyCounts& counts() const { return counts_; }
  /// Whether two live vertices are in one component. Cost: union–find time.
  bool in_same_component(Vertex a, Vertex b);

  /// glue(), in one step. Cost: union–find time when the edges are on two components or adjacent; otherwise the
  /// shorter of two ways along a curve, or the shorter of two curves.
  GlueEffect glue(Halfedge first, Halfedge second);
  /// zip_curves(), in one step.
  ZipCurvesEffect zip_curves(Halfedge first, Halfedge second);

  void note_created(Halfedge first_side);  ///< of create_triangle(): what it returned
  void note_destroyed();                   ///< of destroy_triangle()
  void note(const GlueEffect& effect);
  void note(const UnglueEffect& effect);
  void note(const CloseCurveEffect& effect);
  void note(const OpenCurveEffect& effect);
  void note(const SplitEffect& effect);
  void note(const WeldEffect& effect);
  void note_undone(const WeldEffect& effect);  ///< of undo(): what the weld or collapse had returned

 private:
  void change(const Delta& delta);
  void put(Vertex v, std::uint32_t node);
  std::uint32_t node(Vertex v) const;
  GlueCase case_of(Halfedge first, Halfedge second);
  std::uint32_t new_node();
  void forget_old_nodes();

  Connectivity& mesh_;
  TopologyCounts counts_;
  std::vector<std::uint32_t> node_of_;  // of each vertex; vertices that parted from others get another node
  DisjointSets nodes_;
};

}  // namespace meshops
