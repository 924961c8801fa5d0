// What: the options and the result of a run of the simplification engine, and the run itself.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <ranges>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/core/element_counts.h"
#include "meshops/core/live_range.h"
#include "meshops/core/progress.h"
#include "meshops/simplify/edges_by_cost.h"
#include "meshops/simplify/simplify_policy.h"
#include "meshops/simplify/simplify_visitor.h"
#include "meshops/stellar/collapse.h"
#include "meshops/stellar/split_hooks.h"

namespace meshops {

struct SimplifyOptions {
  std::size_t faces = 0;         ///< the run ends as soon as at most this number of faces is left
  std::optional<double> cost{};  ///< the run ends before the first edge of a greater cost; must not be NaN
  Keep keep = Keep::simplicial;  ///< the property that every collapse keeps
  GoOn go_on{};                  ///< progress function; the run throws Cancelled when it returns false
};

/// Reason for the end of a run: the limit options.faces, the limit options.cost, stops() of the policy, or that no edge
/// is left that can be collapsed.
enum class SimplifyEnd { faces, cost, policy, exhausted };

struct SimplifyResult {
  std::size_t collapses = 0;
  std::size_t faces = 0;         ///< number of faces that are left
  std::optional<double> cost{};  ///< the greatest cost of a collapse; absent if there was no collapse
  SimplifyEnd end = SimplifyEnd::exhausted;
};

namespace detail {

template <typename V>
concept KeepsSimplifyEvents = std::same_as<decltype(&V::collapsed), decltype(&SimplifyVisitor::collapsed)> &&
    std::same_as<decltype(&V::refused), decltype(&SimplifyVisitor::refused)> &&
    std::same_as<decltype(&V::disallowed), decltype(&SimplifyVisitor::disallowed)>;

[[noreturn]] MESHOPS_API void violate_number(const char* what, Edge e, double number, const char* expected);

/// Throws ContractViolation if the place has a number that is not finite.
template <typename Place>
void require_finite_place(Edge e, const Place& place) {
  if constexpr (std::floating_point<Place>) {
    if (!std::isfinite(place)) [[unlikely]]
      violate_number("place", e, static_cast<double>(place), "finite coordinates");
  } else if constexpr (requires {
                         { is_finite(place) } -> std::same_as<bool>;
                       }) {
    require(is_finite(place), "simplify: the policy's place of edge ", e.idx(), " is not finite");
  } else if constexpr (std::ranges::range<const Place>) {
    if constexpr (std::floating_point<std::ranges::range_value_t<const Place>>)
      for (const auto number : place) require_finite_place(e, number);
  }
}

template <typename Mesh, typename Policy, typename Visitor>
class SimplifyRun {
 public:
  SimplifyRun(Mesh& mesh, Policy& policy, Visitor& visitor, const SimplifyOptions& options)
      : mesh_(mesh),
        policy_(policy),
        visitor_(visitor),
        options_(options),
        counts_(ElementCounts::of(mesh)),
        step_(options.go_on),
        edges_(mesh.n_edges()),
        left_at_(mesh.n_vertices(), false) {
    require(!options.cost || !std::isnan(*options.cost), "simplify: options.cost is NaN, expected a number");
  }

  SimplifyResult run() {
    for ([[maybe_unused]] const Face f : live_faces(mesh_)) ++result_.faces;
    for (const Edge e : live_edges(mesh_)) {
      queue(e);
      step_(steps_of_a_cost);
    }
    result_.end = advance();
    return result_;
  }

 private:
  using Key = std::remove_cvref_t<decltype(std::declval<Policy&>().key(std::declval<const Mesh&>(), Vertex()))>;
  static constexpr std::size_t steps_of_a_cost = 4, steps_of_a_collapse = 64;

  const Mesh& seen() const { return mesh_; }
  // ask() and tell() call the policy or the visitor. They throw ContractViolation if the call changed element counts.
  template <typename Call>
  auto ask(Call call) {
    auto answer = call();
    require_intact();
    return answer;
  }
  template <typename Call>
  void tell(Call call) {
    call();
    require_intact();
  }
  void require_intact() const {
    require(ElementCounts::of(mesh_) == counts_,
            "simplify: the policy or the visitor added elements to the mesh or removed some");
  }
  Key key(Vertex v) {
    return ask([&] { return policy_.key(seen(), v); });
  }
  std::pair<Vertex, Vertex> ends(Edge e) const {
    const Halfedge h = mesh_.halfedge_handle(e, 0);
    return {mesh_.from_vertex_handle(h), mesh_.to_vertex_handle(h)};
  }

  /// Computes the cost of the edge. Makes the edge wait, unless it has no cost.
  void queue(Edge e) {
    const std::optional<double> cost = ask([&]() -> std::optional<double> { return policy_.cost(seen(), e); });
    if (!cost) {
      edges_.remove(e);
      return leave(e, [] {});
    }
    if (!std::isfinite(*cost)) [[unlikely]]
      violate_number("cost", e, *cost, "a finite number, or nothing for an edge that stays");
    const auto [a, b] = ends(e);
    edges_.push(e, *cost, key(a), key(b));
  }

  /// Notes that the edge does not wait for its turn any more, and calls `event`.
  template <typename Event>
  void leave(Edge e, Event event) {
    const auto [a, b] = ends(e);
    left_at_[index(a)] = left_at_[index(b)] = true;
    tell(event);
  }
  static std::size_t index(Vertex v) { return static_cast<std::size_t>(v.idx()); }

  SimplifyEnd advance() {
    while (result_.faces > options_.faces) {
      const auto next = edges_.pop();
      if (!next) return SimplifyEnd::exhausted;
      const Edge e = next->first.edge;
      const double cost = next->first.cost;
      if (!is_live(mesh_, e)) continue;
      if (next->second) {
        queue(e);
        continue;
      }
      if (options_.cost && cost > *options_.cost) return SimplifyEnd::cost;
      if constexpr (StoppingPolicy<Policy, Mesh>)
        if (ask([&] { return policy_.stops(seen(), e, cost); })) return SimplifyEnd::policy;
      try_edge(e, cost);
      step_(steps_of_a_collapse);
    }
    return SimplifyEnd::faces;
  }

  void try_edge(Edge e, double cost) {
    const auto place = ask([&] { return policy_.place(seen(), e); });
    require_finite_place(e, place);
    if (!ask([&] { return policy_.allows(seen(), e, place); }))
      return leave(e, [&] { visitor_.disallowed(seen(), e); });
    const auto tried = try_collapse(mesh_, toward(e, place), options_.keep);
    if (const auto* blocker = std::get_if<Blocker>(&tried))
      return leave(e, [&] { visitor_.refused(seen(), e, *blocker); });
    const WeldEffect& effect = std::get<WeldEffect>(tried);
    const auto merge = [&](Mesh& mesh, const WeldEffect& done) {
      if constexpr (MergingPolicy<Policy, Mesh>)
        tell([&] { policy_.merge(mesh, done, place); });
      else if constexpr (HasPoints<Mesh>)
        mesh.set_point(done.survivor, place);
    };
    with_hook(mesh_, effect, merge);
    ++result_.collapses;
    result_.faces -= effect.removed.faces().size();
    result_.cost = result_.cost ? std::max(*result_.cost, cost) : cost;
    tell([&] { visitor_.collapsed(seen(), effect, cost); });
    require(is_live(mesh_, effect.survivor), "simplify: the visitor removed elements of the mesh");
    update_around(effect.survivor);
  }

  /// Returns the halfedge of the edge that ends at the surviving vertex.
  template <typename Place>
  Halfedge toward(Edge e, const Place& place) {
    const auto [a, b] = ends(e);
    Vertex survivor;
    if constexpr (ChoosingPolicy<Policy, Mesh>) {
      survivor = ask([&] { return policy_.survivor(seen(), e, place); });
      require(survivor == a || survivor == b, "simplify: the policy's survivor, vertex ", survivor.idx(),
              ", is not an end of the edge that collapses");
    } else {
      const Key of_a = key(a), of_b = key(b);
      survivor = of_a < of_b || (!(of_b < of_a) && a < b) ? a : b;
    }
    return mesh_.halfedge_handle(e, survivor == b ? 0 : 1);
  }

  /// Updates the costs of the edges at a vertex into which another was merged. Edges at its neighbors that did not
  /// collapse in their turn wait again.
  void update_around(Vertex merged) {
    bool costs_grow = false;
    if constexpr (GrowingPolicy<Policy>) costs_grow = policy_.costs_grow;
    for (const Halfedge out : mesh_.voh_range(merged)) {
      const Edge e = mesh_.edge_handle(out);
      if (costs_grow && edges_.waits(e))
        edges_.mark_outdated(e);
      else
        queue(e);
      const Vertex neighbor = mesh_.to_vertex_handle(out);
      if (!left_at_[index(neighbor)]) continue;
      left_at_[index(neighbor)] = false;
      for (const Halfedge beyond : mesh_.voh_range(neighbor))
        if (const Edge further = mesh_.edge_handle(beyond); !edges_.waits(further)) queue(further);
    }
  }

  Mesh& mesh_;
  Policy& policy_;
  Visitor& visitor_;
  const SimplifyOptions& options_;
  const ElementCounts counts_;
  Steps step_;
  EdgesByCost<Key> edges_;
  std::vector<bool> left_at_;  // for each vertex, whether an edge at it may have left the queue
  SimplifyResult result_;
};

}  // namespace detail
}  // namespace meshops
