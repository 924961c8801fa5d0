#include "walk/front_policies.h"

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include "meshops/core/validate.h"
#include "meshops/front/engine.h"
#include "support/meshes.h"

namespace meshops::test {
namespace {

void demand(bool holds, const char* law) {
  if (!holds) throw LawBroken(law);
}

/// Policy that returns anything.
struct AnyAnswers {
  Choices& choices;
  AdvanceCounts& counts;
  std::size_t questions;
  bool lists = false;  // the last answer was a list

  bool tired() { return counts.proposals >= questions || !choices.any_left(); }
  Site any_site(const Front& front) {
    if (choices.one_in(60)) return static_cast<Site>(-1);
    return below(choices,
                 static_cast<std::uint32_t>(front.sites()) + (choices.one_in(12) && front.sites() < 60 ? 2 : 0));
  }
  std::array<Site, 3> any_triangle(const Front& front) { return {any_site(front), any_site(front), any_site(front)}; }
  /// Returns a random list of triangles, half of them at the edge.
  std::vector<Proposal::Triangle> any_list(const Front& front, Halfedge h) {
    std::vector<Proposal::Triangle> list(below(choices, 5));
    for (Proposal::Triangle& triangle : list) triangle = any_triangle(front);
    if (!list.empty() && choices.one_in(2)) list[0] = {front.from_site(h), front.to_site(h), any_site(front)};
    return list;
  }
  std::optional<std::array<Site, 3>> seed(const Front& front) {
    if (tired() || choices.one_in(6)) return std::nullopt;
    if (choices.one_in(400)) throw std::runtime_error("tired of seeds");
    return any_triangle(front);
  }
  Proposal propose(const Front& front, Halfedge h) {
    ++counts.proposals;
    if (tired()) return std::nullopt;
    if (choices.one_in(400)) throw std::runtime_error("tired");
    const std::uint32_t answer = below(choices, 10);
    lists = answer == 3;
    switch (answer) {
      case 0:
        return std::nullopt;
      case 1:
        return choices.one_in(4)
                   ? Proposal::detach(
                         Face(static_cast<int>(below(choices, static_cast<std::uint32_t>(front.faces()) + 3)) - 1))
                   : Proposal(std::nullopt);
      case 2:
        return front.to_site(front.mesh().next_halfedge_handle(h));
      case 3:
        ++counts.lists;
        return Proposal::triangles(any_list(front, h));
      case 4:
        return Proposal::defer();
      default:
        return any_site(front);
    }
  }
};

template <bool gluing>
struct AnyGlues : AnyAnswers {};
template <>
struct AnyGlues<true> : AnyAnswers {
  bool glues(const Front& front, Halfedge h, Site apex) {
    if (choices.one_in(400)) throw std::runtime_error("tired of gluing");
    demand(front.is_boundary(h) && apex != front.from_site(h) && apex != front.to_site(h),
           "glues() is called for a boundary halfedge and the apex of a triangle");
    const bool yes = choices.one_in(2);
    ++(yes ? counts.glued : counts.not_glued);
    return yes;
  }
};

enum class Order { first_in, keys, keys_again };

/// Policy whose keys throw, too.
template <Order order, bool gluing>
struct AnyPolicy : AnyGlues<gluing> {
  static constexpr bool rekeys_neighbors = order == Order::keys_again;
  std::uint32_t key(const Front&, Halfedge) {
    if (this->choices.one_in(400)) throw std::runtime_error("tired of keys");
    return below(this->choices, 5);
  }
};
template <bool gluing>
struct AnyPolicy<Order::first_in, gluing> : AnyGlues<gluing> {};
static_assert(FrontPolicy<AnyPolicy<Order::first_in, false>> && !OrderedFrontPolicy<AnyPolicy<Order::first_in, true>>);
static_assert(OrderedFrontPolicy<AnyPolicy<Order::keys, false>> && !RekeyingFrontPolicy<AnyPolicy<Order::keys, false>>);
static_assert(RekeyingFrontPolicy<AnyPolicy<Order::keys_again, true>>);
static_assert(GluingFrontPolicy<AnyPolicy<Order::keys, true>> && !GluingFrontPolicy<AnyPolicy<Order::keys, false>>);

/// Visitor that keeps its own account of triangles, halfedges and curves; it throws, too.
struct Account : CurveVisitor {
  Account(Front& advanced, AnyAnswers& asked, bool glues)
      : changeable(advanced), policy(asked), gluing(glues), counts(asked.counts) {}
  Front& changeable;
  AnyAnswers& policy;
  bool gluing;
  AdvanceCounts& counts;
  std::size_t triangles = 0;
  long curves = 0;
  Halfedge refused_at;

  void may_throw() {
    if (policy.choices.one_in(800)) throw std::runtime_error("tired of events");
  }
  /// Called after a throw. The events of the last triangle were sent nevertheless.
  void begin_anew(const Front& front) {
    demand(front.faces() == triangles, "a throw neither adds nor removes a triangle");
    demand(curves == static_cast<long>(front.curves().size()), "a throw loses no event of a curve");
    refused_at = Halfedge();
  }

  void seeded(const Front& front, const InsertedTriangle&) {
    ++counts.seeded;
    demand(front.faces() == ++triangles, "a seed adds a triangle");
    may_throw();
  }
  void attached(const Front& front, Halfedge h, const InsertedTriangle& t) {
    ++counts.attached;
    demand(front.faces() == ++triangles, "an attached event adds a triangle");
    demand(policy.lists || t.side[0] == h, "an apex is attached at the edge");
    may_throw();
  }
  void deferred(const Front& front, Halfedge h) {
    ++counts.deferred;
    demand(front.is_active(h) && !front.is_frozen(h), "a deferred edge is active");
    may_throw();
  }
  void detached(const Front& front, const DetachedTriangle&) {
    ++counts.detached;
    demand(front.faces() == --triangles, "a detached event removes a triangle");
    may_throw();
  }
  void refused(const Front& front, Halfedge h, const Refusal& refusal) {
    ++counts.refused;
    counts.there += refusal.kind == RefusalKind::triangle_there;
    demand((policy.lists || front.is_boundary(h)) && !describe(refusal).empty(),
           "a refusal names a boundary halfedge and a reason");
    if (front.is_boundary(h)) refused_at = h;
    may_throw();
  }
  void seed_refused(const Front& front, const std::array<Site, 3>& seed, const Refusal& refusal) {
    ++counts.seeds_refused;
    demand(gluing || front.create_blocker(seed[0], seed[1], seed[2]) == refusal,
           "a seed is refused for the blocker's reason");
    if (!front.frozen().empty() && policy.choices.one_in(2))
      if (const Halfedge h = front.frozen().back(); front.is_frozen(h)) changeable.activate(h);
    may_throw();
  }
  void frozen(const Front& front, Halfedge h) {
    ++counts.frozen;
    demand(front.is_frozen(h), "the edge that the event names is frozen");
    demand(!refused_at.is_valid() || refused_at == h, "after a refusal the edge is frozen next");
    refused_at = Halfedge();
    demand(curves == static_cast<long>(front.curves().size()), "the events of curves add up to their number");
    may_throw();
  }
  void curve_begun(const Front&, Halfedge) { ++curves; }
  void curves_joined(const Front&, Halfedge) { --curves; }
  void curve_split(const Front&, Halfedge, Halfedge) { ++curves; }
  void curve_closed(const Front&) { --curves; }
};

/// Checks that after a throw each active edge waits once, including deferred ones.
void check_queue(Front& front) {
  std::size_t active = 0;
  for (const BoundaryCurve& curve : front.curves())
    for (const Halfedge h : curve) active += front.is_active(h);
  std::vector<Halfedge> popped;
  for (Halfedge h = front.pop(); h.is_valid(); h = front.pop()) popped.push_back(h);
  demand(popped.size() == active, "each active edge is in the queue once after a throw");
  for (const Halfedge h : popped) front.activate(h);
}

template <Order order, bool gluing>
void advance_once(Choices& choices, std::size_t questions, AdvanceCounts& counts) {
  TestMesh mesh;
  Front front(mesh, 3 + below(choices, choices.one_in(3) ? 40 : 10));
  AnyPolicy<order, gluing> policy{{{choices, counts, questions}}};
  Account account(front, policy, gluing);
  ++counts.policies;
  for (unsigned level = 0; level < 4 && !policy.tired(); ++level) {
    bool thrown = false;
    try {
      advance(front, policy, account);
    } catch (const LawBroken&) {
      throw;
    } catch (const std::runtime_error&) {
      ++counts.thrown;
      thrown = true;
      account.begin_anew(front);
      if (choices.one_in(2)) check_queue(front);
    }
    demand(validate(mesh).empty(), "the mesh is sound, whatever the policy returns");
    for (const BoundaryCurve& curve : front.curves())
      for (const Halfedge h : curve)
        demand(front.is_frozen(h) || (thrown && front.is_active(h)),
               "every edge is frozen at the end, or active after a throw");
    if (!thrown || choices.one_in(2)) front.next_level();
  }
  front.finish();
  demand(validate(mesh).empty(), "the mesh is sound after finish()");
}

template <Order order>
void advance_once(Choices& choices, std::size_t questions, AdvanceCounts& counts) {
  if (choices.one_in(2))
    advance_once<order, true>(choices, questions, counts);
  else
    advance_once<order, false>(choices, questions, counts);
}

}  // namespace

void advance_at_random(Choices& choices, std::size_t questions, AdvanceCounts& counts) {
  while (counts.proposals < questions && choices.any_left()) switch (below(choices, 3)) {
      case 0:
        advance_once<Order::first_in>(choices, questions, counts);
        break;
      case 1:
        advance_once<Order::keys>(choices, questions, counts);
        break;
      default:
        advance_once<Order::keys_again>(choices, questions, counts);
    }
}

}  // namespace meshops::test
