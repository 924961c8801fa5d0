// What: an undo stack over handle and stellar operators, which performs, undoes and redoes them as steps.
// Law:  undo() of a step restores every record of the mesh, including records of elements marked deleted, and removes
//       the elements that the step added. redo() of the step restores every record after the step. So any sequence of
//       steps that are all undone is the identity.
// Cost: undo() and redo() cost as much as the operator. A step keeps a few handles; for a seam, or for the sides of a
//       face, a few handles for each edge.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/contract.h"
#include "meshops/core/element_counts.h"
#include "meshops/handle/close_curve.h"
#include "meshops/handle/create.h"
#include "meshops/handle/glue.h"
#include "meshops/handle/unglue.h"
#include "meshops/handle/zip_curves.h"
#include "meshops/stellar/collapse.h"
#include "meshops/stellar/diagonal.h"
#include "meshops/stellar/flip.h"
#include "meshops/stellar/remove_vertex.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_face.h"
#include "meshops/stellar/split_vertex.h"
#include "meshops/stellar/triangulate_face.h"
#include "meshops/stellar/weld_edge.h"
#include "meshops/stellar/weld_face.h"

namespace meshops {

/// History of operators on one mesh. Each member with the name of an operator performs the operator as one step, and
/// returns the operator's result. To undo several steps together, keep the value of steps(), and pass it to undo_to()
/// later. undo() does not restore properties that hooks or other code wrote to old elements. redo() makes the same
/// elements with the same handles, and calls the hooks of splits again. The history keeps copies of arguments; only the
/// mesh and the objects to which hooks refer must continue to exist. A history can be neither copied nor moved, because
/// its steps refer to it.
/// Requires: the mesh outlives the history and is sound; no other code changes the links of the mesh. Not checked.
/// Throws:   ContractViolation if the mesh lacks status of some kind, if the operator refuses (its blocker has the
///           reason), or if other code has added elements or collected garbage since the last step; other changes of
///           links are not noticed. Also throws whatever a hook or a weight throws. The history is then unchanged, and
///           so is the mesh, except as split_hooks.h says.
class MESHOPS_API History {
 public:
  /// Begins a history without steps. Keeps a reference to the mesh.
  explicit History(Connectivity& mesh);
  History(const History&) = delete;
  History& operator=(const History&) = delete;

  CreateTriangleEffect create_triangle();
  Delta destroy_triangle(Face f);
  Delta remove_triangle(Face f);
  GlueEffect glue(Halfedge first, Halfedge second);
  UnglueEffect unglue(Halfedge h);
  CloseCurveEffect close_curve(Halfedge h);
  OpenCurveEffect open_curve(Face f);
  ZipCurvesEffect zip_curves(Halfedge first, Halfedge second);

  FlipEffect flip(Edge e, Keep keep = Keep::simplicial);
  WeldEffect collapse(Halfedge h, Keep keep = Keep::simplicial);
  WeldEdgeEffect weld_edge(Halfedge h, Keep keep = Keep::simplicial);
  WeldFaceEffect weld_face(Vertex v, Keep keep = Keep::simplicial);
  WeldEffect remove_vertex(Vertex v, Keep keep = Keep::simplicial);
  InsertDiagonalEffect insert_diagonal(Halfedge from, Halfedge to, Keep keep = Keep::simplicial);
  RemoveDiagonalEffect remove_diagonal(Halfedge h);
  SplitEdgeEffect split_edge(Halfedge h, Keep keep = Keep::simplicial);
  SplitFaceEffect split_face(Face f);
  SplitVertexEffect split_vertex(std::optional<Halfedge> left, std::optional<Halfedge> right,
                                 Keep keep = Keep::simplicial);
  /// Triangulates with a copy of the weight. redo() calls the copy again, which must then return the same values.
  template <TriangleWeight Weight>
  TriangulateFaceEffect triangulate_face(Face f, Weight weight, Keep keep = Keep::simplicial) {
    return perform<TriangulateFaceEffect>([this, f, weight, keep] {
      TriangulateFaceEffect effect = meshops::triangulate_face(mesh_, f, weight, keep);
      Undo undo = undo_of_diagonals(effect.diagonals);
      return std::pair(std::move(effect), std::move(undo));
    });
  }
  /// Splits with a hook (split_hooks.h), by default PlaceVertex, for example split_edge(mesh, h, CarryOver()). The
  /// history keeps a copy of the hook, which redo() calls again; objects to which it refers must still exist then.
  /// Requires: `mesh` is the mesh of the history. Throws ContractViolation.
  template <typename Mesh, SplitHook<Mesh, SplitEdgeEffect> Hook = PlaceVertex>
  SplitEdgeEffect split_edge(Mesh& mesh, Halfedge h, Hook hook = {}, Keep keep = Keep::simplicial) {
    return split([&mesh = checked(mesh), h, hook, keep] { return meshops::split_edge(mesh, h, hook, keep); });
  }
  template <typename Mesh, SplitHook<Mesh, SplitFaceEffect> Hook = PlaceVertex>
  SplitFaceEffect split_face(Mesh& mesh, Face f, Hook hook = {}) {
    return split([&mesh = checked(mesh), f, hook] { return meshops::split_face(mesh, f, hook); });
  }
  template <typename Mesh, SplitHook<Mesh, SplitVertexEffect> Hook = PlaceVertex>
  SplitVertexEffect split_vertex(Mesh& mesh, std::optional<Halfedge> left, std::optional<Halfedge> right,
                                 Hook hook = {}, Keep keep = Keep::simplicial) {
    return split([&mesh = checked(mesh), left, right, hook, keep] {
      return meshops::split_vertex(mesh, left, right, hook, keep);
    });
  }

  /// Returns the number of steps that undo() can undo.
  std::size_t steps() const { return done_.size(); }
  /// Returns the number of steps that redo() can redo; 0 after a new step.
  std::size_t undone_steps() const { return undone_.size(); }
  /// Undoes the last step. Requires: steps() > 0. Throws ContractViolation otherwise.
  void undo();
  /// Performs the step that was undone last again. Requires: undone_steps() > 0. Throws ContractViolation otherwise.
  void redo();
  /// Undoes steps until `steps` steps are left. Requires: steps() ≥ `steps`. Throws ContractViolation otherwise.
  void undo_to(std::size_t steps);

 private:
  using Undo = std::function<void()>;
  struct Step {
    std::function<Undo()> again;
    Undo back;
    ElementCounts before, after;
  };

  /// Performs one split by `operate`, which must hold copies of its arguments, because redo() calls it again.
  template <typename Operate>
  auto split(Operate operate) {
    using Effect = decltype(operate());
    return perform<Effect>([operate, this]() mutable {
      const Effect effect = operate();
      return std::pair(effect, undo_of_split(effect.halfedge));
    });
  }
  template <typename Mesh>
  Mesh& checked(Mesh& mesh) const {
    require(static_cast<const Connectivity*>(&mesh) == &mesh_, "History: the mesh is not that of the history");
    return mesh;
  }
  template <typename Effect, typename Perform>
  Effect perform(Perform perform) {
    require_own();
    const auto before = ElementCounts::of(mesh_);
    auto [effect, back] = perform();
    remember(
        {[perform]() mutable { return Undo(perform().second); }, std::move(back), before, ElementCounts::of(mesh_)});
    return effect;
  }
  /// Performs one step by `operate`, an operator that returns a WeldEffect.
  template <typename Operate>
  auto weld(Operate operate) {
    using Effect = decltype(operate());
    return perform<Effect>([operate, this] {
      const Effect effect = operate();
      return std::pair(effect, undo_of_weld(effect));
    });
  }
  Undo undo_of_split(Halfedge halfedge);
  Undo undo_of_diagonals(const std::vector<Halfedge>& diagonals);
  Undo undo_of_weld(const WeldEffect& effect);
  Undo named_again(std::vector<Vertex> vertices) const;
  void require_own() const;
  void remember(Step step);

  Connectivity& mesh_;
  std::vector<Step> done_, undone_;
};

}  // namespace meshops
