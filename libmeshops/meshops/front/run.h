// What: one run of advance() (front/engine.h), which calls the policy, inserts triangles, and reports to the visitor.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "meshops/core/reach.h"
#include "meshops/front/engine_side.h"
#include "meshops/front/front.h"
#include "meshops/front/order.h"
#include "meshops/front/policy.h"

namespace meshops::detail {

/// Set of boundary curves, each given by one of its halfedges.
class DistinctCurves {
 public:
  /// Holds the curves through the valid halfedges of `through`.
  DistinctCurves(const Connectivity& mesh, const std::array<Halfedge, 3>& through) : mesh_(mesh) {
    for (const Halfedge h : through)
      if (h.is_valid()) add(h);
  }
  /// Holds the curves through the boundary vertices of `through`.
  DistinctCurves(const Connectivity& mesh, const std::array<Vertex, 3>& through) : mesh_(mesh) {
    for (const Vertex v : through)
      if (mesh.is_boundary(v)) add(mesh.halfedge_handle(v));
  }
  std::size_t count() const { return count_; }
  Halfedge operator[](std::size_t i) const { return curve_[i]; }

 private:
  void add(Halfedge h) {
    for (std::size_t i = 0; i < count_; ++i)
      if (on_same_curve(mesh_, curve_[i], h)) return;
    curve_[count_++] = h;
  }
  const Connectivity& mesh_;
  std::array<Halfedge, 3> curve_;
  std::size_t count_ = 0;
};

inline std::array<Vertex, 3> corners(const Connectivity& mesh, Face triangle) {
  const Halfedge first = mesh.halfedge_handle(triangle), second = mesh.next_halfedge_handle(first);
  return {mesh.from_vertex_handle(first), mesh.from_vertex_handle(second), mesh.to_vertex_handle(second)};
}

/// Reports the events that lead from `before` curves to the curves `now`: first the joins, then the splits. Begun −
/// joined + split − closed, as numbers of events, is the change of the number of boundary curves.
template <typename Visitor>
void notify_of_curves(Front& changed, std::size_t before, const DistinctCurves& now, Visitor& visitor,
                      AllSteps& steps) {
  const Front& front = changed;
  const auto notify = [&](auto event) { steps([&] { EngineSide(changed).notify(event); }); };
  if (before == 0 && now.count() > 0) notify([&] { visitor.curve_begun(front, now[0]); });
  for (; before > 1; --before) notify([&] { visitor.curves_joined(front, now.count() > 0 ? now[0] : Halfedge()); });
  for (std::size_t i = 1; i < now.count(); ++i) notify([&] { visitor.curve_split(front, now[i - 1], now[i]); });
  if (now.count() == 0) notify([&] { visitor.curve_closed(front); });
}

template <typename Policy, typename Visitor>
class Run {
 public:
  Run(Front& front, Policy& policy, Visitor& visitor)
      : front_(front), engine_(front), policy_(policy), visitor_(visitor), order_(front, policy) {}

  /// Runs until no halfedge is active and no seed can be inserted.
  /// Throws: whatever the policy or the visitor throws; halfedges that still waited are then in the queue of the front.
  void advance() {
    Halfedge h;  // the halfedge in processing
    // Processes halfedges until none is queued. Returns whether there was one.
    const auto follow_all = [&] {
      bool any = false;
      for (h = order_.next(); h.is_valid(); h = order_.next(), any = true)
        follow(h, engine_.ask([&]() -> Proposal { return policy_.propose(seen(), h); }));
      return any;
    };
    try {
      // The visitor may have activated halfedges while a seed was refused or a halfedge was frozen.
      do follow_all();
      while (engine_.wake_deferred() || begin() || freeze_deferred() || follow_all());
    } catch (...) {
      order_.give_back(h);
      throw;
    }
  }

 private:
  const Front& seen() const { return front_; }

  /// Carries out the proposal of the policy for the edge of `h`.
  void follow(Halfedge h, const Proposal& proposal) {
    if (proposal.apex()) {
      if (!insert(h, h, *proposal.apex())) freeze(h);
    } else if (proposal.detached()) {
      detach(h, *proposal.detached());
    } else if (proposal.is_deferred()) {
      engine_.defer(h);
      engine_.notify([&] { visitor_.deferred(seen(), h); });
    } else {
      for (const auto& [a, b, c] : proposal.triangles())
        if (!insert(h, a, b, c)) break;
      if (front_.is_boundary(h) && !front_.is_active(h)) freeze(h);
    }
  }

  /// Inserts a triangle that was proposed for h, if the triangle fits. Returns: whether it fits.
  template <typename... Place>
  bool insert(Halfedge h, Place... place) {
    const Fit fit = this->fit(place...);
    if (fit.refusal)
      engine_.notify([&] { visitor_.refused(seen(), h, *fit.refusal); });
    else
      put(fit, [&](const InsertedTriangle& triangle) { visitor_.attached(seen(), h, triangle); });
    return !fit.refusal;
  }

  /// Inserts the next seed that fits. Returns: whether there was one.
  bool begin() {
    for (;;) {
      const std::optional<std::array<Site, 3>> seed = engine_.ask([&] { return policy_.seed(seen()); });
      // A policy that returns the seed refused last, with no triangle inserted or detached since, has no other seed.
      if (!seed || seed == refused_) return false;
      const Fit fit = this->fit((*seed)[0], (*seed)[1], (*seed)[2]);
      if (!fit.refusal) {
        put(fit, [&](const InsertedTriangle& triangle) { visitor_.seeded(seen(), triangle); });
        return true;
      }
      engine_.notify([&] { visitor_.seed_refused(seen(), *seed, *fit.refusal); });
      refused_ = seed;
    }
  }

  /// Returns the place of a triangle, given by its corners, or by a halfedge and the apex. The policy decides which
  /// sides are glued if it has glues(); otherwise the sites decide.
  template <typename... Place>
  Fit fit(Place... place) {
    if constexpr (GluingFrontPolicy<Policy>)
      return front_.fit(place..., [&](Halfedge side, Site apex) {
        return engine_.ask([&] { return policy_.glues(seen(), side, apex); });
      });
    else
      return front_.fit(place...);
  }

  /// Inserts a triangle that fits. Calls `event` before the events of curves.
  template <typename Event>
  void put(const Fit& fit, Event event) {
    std::size_t before = 0;
    if constexpr (Visitor::follows_curves) before = DistinctCurves(front_.mesh(), fit.sides.side).count();
    const InsertedTriangle triangle = front_.insert(fit);
    notify_of_change([&] { return corners(front_.mesh(), triangle.face); }, before, [&] { event(triangle); });
  }

  void detach(Halfedge h, Face f) {
    if (const auto refusal = front_.detach_blocker(f)) {
      engine_.notify([&] { visitor_.refused(seen(), h, *refusal); });
      freeze(h);
      return;
    }
    front_.activate(h);  // `h` waits again, unless detach() deletes its edge
    std::size_t before = 0;
    if constexpr (Visitor::follows_curves) before = DistinctCurves(front_.mesh(), corners(front_.mesh(), f)).count();
    const DetachedTriangle triangle = front_.detach(f);
    notify_of_change([&] { return triangle.side; }, before, [&] { visitor_.detached(seen(), triangle); });
  }

  /// Reports a triangle that was inserted or detached: first updates keys, then calls the visitor. A visitor that
  /// throws at an event still receives the others. around() returns the corners of an inserted triangle, or the former
  /// sides of a detached triangle.
  template <typename Around, typename Event>
  void notify_of_change(Around around, std::size_t curves_before, Event event) {
    refused_.reset();
    if constexpr (RekeyingFrontPolicy<Policy>) neighbors_changed(around());
    if constexpr (Visitor::follows_curves) {
      const DistinctCurves now(front_.mesh(), around());
      AllSteps steps(engine_);
      steps([&] { engine_.notify(event); });
      notify_of_curves(front_, curves_before, now, visitor_, steps);
      steps.end();
    } else {
      engine_.notify(event);
    }
  }
  void neighbors_changed(const std::array<Vertex, 3>& corners) {
    for (const Vertex v : corners) order_.neighbors_changed(v);
  }
  void neighbors_changed(const std::array<Halfedge, 3>& sides) {
    for (const Halfedge side : sides)
      if (side.is_valid()) {
        order_.neighbors_changed(front_.mesh().from_vertex_handle(side));
        order_.neighbors_changed(front_.mesh().to_vertex_handle(side));
      }
  }

  void freeze(Halfedge h) {
    front_.freeze(h);
    engine_.notify([&] { visitor_.frozen(seen(), h); });
  }

  /// Freezes all deferred halfedges, for the case that nothing will change any more. Returns: whether there were any.
  /// The visitor may activate other halfedges during the calls.
  bool freeze_deferred() {
    Halfedge h = engine_.next_deferred();
    const bool any = h.is_valid();
    for (; h.is_valid(); h = engine_.next_deferred()) freeze(h);
    return any;
  }

  Front& front_;
  EngineSide engine_;
  Policy& policy_;
  Visitor& visitor_;
  typename OrderOf<Policy>::type order_;
  std::optional<std::array<Site, 3>> refused_;  // the seed refused last; reset when a triangle is inserted or detached
};

}  // namespace meshops::detail
