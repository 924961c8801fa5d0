// What: random steps of all operators on a mesh, with valid and invalid arguments, each judged (judge.h).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "meshops/handle/glue.h"
#include "meshops/stellar/count_effects.h"
#include "meshops/stellar/flip.h"
#include "walk/arguments.h"
#include "walk/choices.h"
#include "walk/judge.h"
#include "walk/model_operators.h"

namespace meshops::test {

class Walk {
 public:
  enum class On {
    manifolds,
    bowties  ///< vertices are tied together from time to time, and no step may add defects
  };
  /// Begins on a small mesh of one of several kinds.
  Walk(Choices& choices, On on);

  /// Does one random step. Throws WalkFailure.
  void step();

  /// Returns the tally by the names of the operators.
  const std::map<std::string, Judge::Tally>& tally() const { return judge_.tally(); }

 private:
  /// A step that was done, with the records before and after.
  template <typename Effect>
  struct Done {
    Effect effect;
    std::vector<int> before, after;
  };
  template <typename Effect>
  void remember(std::vector<Done<Effect>>& all, const Effect& effect);
  template <typename Effect>
  Done<Effect> recall(const std::vector<Done<Effect>>& all);

  void start();
  void tidy();

  // walk_handle.cpp
  void create();
  void destroy();
  void remove();
  void glue();
  void unglue();
  void close();
  void open();
  void zip();
  void take_glue_back();
  void separate();

  // walk_stellar.cpp
  void split_edge();
  void split_face();
  void split_vertex();
  void flip();
  void collapse();
  void weld_edge();
  void weld_face();
  void remove_vertex();
  void insert_diagonal();
  void remove_diagonal();
  void triangulate_face();
  void take_weld_back();
  void take_flip_back();

  // walk_questions.cpp
  void ask();

  std::vector<int> corners(Face f) const;
  std::vector<int> on_curve(Halfedge h) const;
  std::vector<int> ends(Halfedge h) const;
  bool is_dead(int name, const std::vector<char>& live) const;

  Choices& choices_;
  On on_;
  TestMesh mesh_;
  Judge judge_;
  Arguments arguments_;
  std::vector<Done<GlueEffect>> glued_;
  std::vector<Done<WeldEffect>> welded_;
  std::vector<Done<FlipEffect>> flipped_;
};

template <typename Effect>
void Walk::remember(std::vector<Done<Effect>>& all, const Effect& effect) {
  if (all.size() == 8) all.erase(all.begin());
  all.push_back({effect, judge_.records(), snapshot(mesh_)});
}

/// Returns an effect: the last one most of the time, so that some can be undone exactly; a made-up one when there is
/// none.
template <typename Effect>
Walk::Done<Effect> Walk::recall(const std::vector<Done<Effect>>& all) {
  if (all.empty()) return {Effect(), {}, {}};
  return choices_.one_in(3) ? all[choices_.below(static_cast<unsigned>(all.size()))] : all.back();
}

}  // namespace meshops::test
