#include "walk/front_policies.h"

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>

#include "meshops/core/validate.h"
#include "meshops/front/engine.h"
#include "support/meshes.h"

namespace meshops::test {
namespace {

void demand(bool holds, const char* law) {
  if (!holds) throw LawBroken(law);
}

/// Answers anything.
struct AnyAnswers {
  Choices& choices;
  AdvanceCounts& counts;
  std::size_t questions;

  bool tired() { return counts.proposals >= questions || !choices.any_left(); }
  Site any_site(const Front& front) {
    if (choices.one_in(60)) return static_cast<Site>(-1);
    return below(choices,
                 static_cast<std::uint32_t>(front.sites()) + (choices.one_in(12) && front.sites() < 60 ? 2 : 0));
  }
  std::optional<std::array<Site, 3>> seed(const Front& front) {
    if (tired() || choices.one_in(6)) return std::nullopt;
    return std::array{any_site(front), any_site(front), any_site(front)};
  }
  Proposal propose(const Front& front, Halfedge h) {
    ++counts.proposals;
    if (tired()) return std::nullopt;
    if (choices.one_in(400)) throw std::runtime_error("tired");
    switch (below(choices, 8)) {
      case 0:
        return std::nullopt;
      case 1:
        return choices.one_in(4)
                   ? Proposal::detach(
                         Face(static_cast<int>(below(choices, static_cast<std::uint32_t>(front.faces()) + 3)) - 1))
                   : Proposal(std::nullopt);
      case 2:
        return front.to_site(front.mesh().next_halfedge_handle(h));
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
           "asked is of a side on the boundary, and of a triangle");
    const bool yes = choices.one_in(2);
    ++(yes ? counts.glued : counts.not_glued);
    return yes;
  }
};

/// Of which keys throw, too.
template <bool ordered, bool gluing>
struct AnyPolicy : AnyGlues<gluing> {};
template <bool gluing>
struct AnyPolicy<true, gluing> : AnyGlues<gluing> {
  std::uint32_t key(const Front&, Halfedge) {
    if (this->choices.one_in(400)) throw std::runtime_error("tired of keys");
    return below(this->choices, 5);
  }
};
static_assert(FrontPolicy<AnyPolicy<false, false>> && !OrderedFrontPolicy<AnyPolicy<false, true>>);
static_assert(OrderedFrontPolicy<AnyPolicy<true, false>>);
static_assert(GluingFrontPolicy<AnyPolicy<true, true>> && !GluingFrontPolicy<AnyPolicy<true, false>>);

template <bool ordered, bool gluing>
void advance_once(Choices& choices, std::size_t questions, AdvanceCounts& counts) {
  TestMesh mesh;
  Front front(mesh, 3 + below(choices, choices.one_in(3) ? 40 : 10));
  /// Keeps its own account of triangles, halfedges and curves.
  struct Account : CurveVisitor {
    explicit Account(AdvanceCounts& all) : counts(all) {}
    AdvanceCounts& counts;
    std::size_t triangles = 0;
    long curves = 0;
    Halfedge refused_at;
    void seeded(const Front& front, const InsertedTriangle&) {
      ++counts.seeded;
      demand(front.faces() == ++triangles, "a seed is a triangle more");
    }
    void attached(const Front& front, Halfedge h, const InsertedTriangle& t) {
      ++counts.attached;
      demand(front.faces() == ++triangles && t.side[0] == h, "what is attached is a triangle more, at the edge");
    }
    void detached(const Front& front, const DetachedTriangle&) {
      ++counts.detached;
      demand(front.faces() == --triangles, "what is detached is a triangle less");
    }
    void refused(const Front& front, Halfedge h, const Refusal& refusal) {
      ++counts.refused;
      counts.there += refusal.kind == RefusalKind::triangle_there;
      demand(front.is_boundary(h) && !describe(refusal).empty(), "refused is something at the front, with a reason");
      refused_at = h;
    }
    void seed_refused(const Front& front, const std::array<Site, 3>& seed, const Refusal& refusal) {
      ++counts.seeds_refused;
      demand(gluing || front.create_blocker(seed[0], seed[1], seed[2]) == refusal,
             "a seed is refused for what the blocker says");
    }
    void frozen(const Front& front, Halfedge h) {
      ++counts.frozen;
      demand(front.is_frozen(h), "frozen is what is told to be");
      demand(!refused_at.is_valid() || refused_at == h, "an edge where something was refused is frozen next");
      refused_at = Halfedge();
      demand(curves == static_cast<long>(front.curves().size()), "the events of curves tell how many there are");
    }
    void curve_begun(const Front&, Halfedge) { ++curves; }
    void curves_joined(const Front&, Halfedge) { --curves; }
    void curve_split(const Front&, Halfedge, Halfedge) { ++curves; }
    void curve_closed(const Front&) { --curves; }
  } account(counts);
  AnyPolicy<ordered, gluing> policy{{{choices, counts, questions}}};
  for (unsigned level = 0; level < 4 && !policy.tired(); ++level) {
    bool thrown = false;
    try {
      advance(front, policy, account);
    } catch (const LawBroken&) {
      throw;
    } catch (const std::runtime_error&) {
      ++counts.thrown;
      thrown = true;
    }
    demand(validate(mesh).empty(), "the mesh is sound, whatever the policy says");
    for (const BoundaryCurve& curve : front.curves())
      for (const Halfedge h : curve)
        demand(front.is_frozen(h) || (thrown && front.is_active(h)),
               "all is frozen at the end; or active, if it threw");
    front.next_level();
  }
  front.finish();
  demand(validate(mesh).empty(), "what finish() leaves is sound");
}

}  // namespace

void advance_at_random(Choices& choices, std::size_t questions, AdvanceCounts& counts) {
  while (counts.proposals < questions && choices.any_left()) switch (below(choices, 4)) {
      case 0:
        advance_once<false, false>(choices, questions, counts);
        break;
      case 1:
        advance_once<true, false>(choices, questions, counts);
        break;
      case 2:
        advance_once<false, true>(choices, questions, counts);
        break;
      default:
        advance_once<true, true>(choices, questions, counts);
    }
}

}  // namespace meshops::test
