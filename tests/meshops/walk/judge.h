// What: compares a step of an operator, done or refused, with the same step on a model (model.h).
// Law:  a step that is done agrees with the model and leaves the mesh as sound as before; a step that is refused
//       changes no bit, and would have been bad: no manifold, not simplicial if that is required, or a case that the
//       operator excludes.
#pragma once

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/core/validate.h"
#include "meshops/stellar/keep.h"
#include "support/meshes.h"
#include "support/snapshot.h"
#include "walk/model.h"

namespace meshops::test {

/// Exception for a step that broke the law; the message names the step and the fault.
struct WalkFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reasons for which an operator may refuse, in addition to its own cases.
struct Rules {
  Keep keep = Keep::manifold;
  std::vector<int> one_fan = {};  ///< vertices that must have one fan
  std::vector<int> touched = {};  ///< vertices at which a doubled edge or triangle counts as made by the operator
};

class Judge {
 public:
  struct Tally {
    int done = 0, refused = 0;
  };

  Judge(const TestMesh& mesh, bool with_bowties) : mesh_(mesh), with_bowties_(with_bowties) {}

  void begin(std::string name) {
    name_ = std::move(name);
    before_ = Model(mesh_);
    records_ = snapshot(mesh_);
  }
  const Model& before() const { return before_; }
  const std::vector<int>& records() const { return records_; }
  const std::map<std::string, Tally>& tally() const { return tally_; }
  [[noreturn]] void fail(const std::string& what) const { throw WalkFailure(name_ + " " + what); }

  /// Runs an operator, which must agree with its blocker. Returns its effect if it was done.
  template <typename Operate>
  auto run(const std::optional<Blocker>& blocker, Operate operate) -> std::optional<decltype(operate())> {
    blocker_ = blocker;
    if (blocker) check_named(*blocker);
    try {
      auto effect = operate();
      if (blocker) fail("was done although the blocker returned: " + describe(*blocker));
      return effect;
    } catch (const ContractViolation& violation) {
      if (!blocker) fail("was refused without a blocker: " + std::string(violation.what()));
      if (!std::string(violation.what()).ends_with(": " + describe(*blocker)))
        fail("said \"" + std::string(violation.what()) + "\" and not: " + describe(*blocker));
      if (snapshot(mesh_) != records_) fail("changed what it refused to change");
      return std::nullopt;
    }
  }

  /// Compares with the result of `apply(model)` on the mesh before; `apply` returns why the step has no meaning, or "".
  /// If the step was done, `delta` is the change of the counts that it returned.
  template <typename Apply>
  void compare(const std::optional<Delta>& delta, const Rules& rules, Apply apply) {
    Model expected = before_;
    std::string bad = apply(expected);
    if (bad.empty()) bad = badness(expected, rules);
    if (!delta) {
      if (bad.empty() && !is_doubled_at(rules, expected))
        fail("was refused, but would have been right: " + describe(*blocker_));
      ++tally_[name_].refused;
      return;
    }
    if (!bad.empty()) fail("was done, but is bad: " + bad);
    if (!(Model(mesh_) == expected)) fail("left another mesh than it should");
    check_sound();
    if (!with_bowties_ && !(expected.counts() == before_.counts() + *delta)) fail("returned a wrong delta");
    ++tally_[name_].done;
  }

  /// Judges the undo of an effect: it is done unless there is a `reason` against it, and `apply(model)` on the
  /// resulting mesh gives the mesh before. Returns whether it was done.
  template <typename TakeBack, typename Apply>
  bool compare_back(const std::string& reason, TakeBack take_back, Apply apply) {
    try {
      take_back();
    } catch (const ContractViolation& violation) {
      if (snapshot(mesh_) != records_) fail("changed what it refused to change");
      if (reason.empty()) fail("was refused, but would have been right: " + std::string(violation.what()));
      ++tally_[name_].refused;
      return false;
    }
    if (!reason.empty()) fail("was done, but is bad: " + reason);
    check_sound();
    Model back(mesh_);
    if (const std::string bad = badness(back, {}); !bad.empty()) fail("was done, but is bad: " + bad);
    if (const std::string bad = apply(back); !bad.empty()) fail("left a mesh on which it cannot be repeated: " + bad);
    if (!(back == before_)) fail("is not the inverse");
    ++tally_[name_].done;
    return true;
  }

  /// Checks that there are no defects except those allowed from the beginning: in a walk with bowties, vertices with
  /// several fans.
  void check_sound() const {
    for (const Defect& defect : validate(mesh_))
      if (!with_bowties_ || defect.kind != DefectKind::vertex_has_several_fans) fail("left " + describe(defect));
  }

  bool needs_one_fan(const Rules& rules) const {
    for (const int v : rules.one_fan)
      if (before_.has_several_fans(v)) return true;
    return false;
  }

 private:
  /// Checks that the reason concerns an element as its kind says.
  void check_named(const Blocker& blocker) const {
    const auto is = [&](auto handle) { return is_live(mesh_, handle); };
    const bool live = blocker.element == ElementKind::vertex     ? is(Vertex(blocker.index))
                      : blocker.element == ElementKind::halfedge ? is(Halfedge(blocker.index))
                      : blocker.element == ElementKind::edge     ? is(Edge(blocker.index))
                                                                 : is(Face(blocker.index));
    const bool should_live = blocker.kind != BlockerKind::missing && blocker.kind != BlockerKind::none_given;
    if (live != should_live) fail("named an element that is live or not, contrary to the reason: " + describe(blocker));
    const Vertex v(blocker.index);
    const Edge e(blocker.index);
    const bool on_vertex = blocker.element == ElementKind::vertex, on_edge = blocker.element == ElementKind::edge;
    if ((blocker.kind == BlockerKind::several_fans && !before_.has_several_fans(v.idx())) ||
        (blocker.kind == BlockerKind::not_triangle && mesh_.valence(Face(blocker.index)) == 3) ||
        (blocker.kind == BlockerKind::wrong_degree && mesh_.valence(v) == static_cast<unsigned>(blocker.count)) ||
        (blocker.kind == BlockerKind::on_boundary && on_vertex && !mesh_.is_boundary(v)) ||
        (blocker.kind == BlockerKind::on_boundary && on_edge && !mesh_.is_boundary(e)) ||
        (blocker.kind == BlockerKind::not_on_boundary && on_edge && mesh_.is_boundary(e)) ||
        (blocker.kind == BlockerKind::not_on_boundary && on_vertex && mesh_.is_boundary(v)))
      fail("named an element for which the reason is wrong: " + describe(blocker));
  }

  std::string badness(const Model& after, const Rules& rules) const {
    if (needs_one_fan(rules)) return "a vertex has several fans";
    if (std::string broken = after.broken(); !broken.empty()) return broken;
    if (after.excess_fans() > before_.excess_fans()) return "a vertex gets several fans";
    if (rules.keep == Keep::simplicial && after.doubled() > before_.doubled()) return "not simplicial";
    return "";
  }
  static bool is_doubled_at(const Rules& rules, const Model& after) {
    if (rules.keep == Keep::manifold) return false;
    for (const int v : rules.touched)
      if (after.doubled(v) > 0) return true;
    return false;
  }

  const TestMesh& mesh_;
  bool with_bowties_;
  std::string name_;
  Model before_;
  std::vector<int> records_;
  std::optional<Blocker> blocker_;
  std::map<std::string, Tally> tally_;
};

}  // namespace meshops::test
