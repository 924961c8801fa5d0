// Members that have the name of an optional member but another form are found at compile time; members of the right
// form, or with other names, are accepted.
#include "meshops/front/near_miss.h"

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>

#include "meshops/front/engine.h"
#include "support/meshes.h"

using namespace meshops;
using namespace meshops::test;
using detail::misses_curves;
using detail::misses_events;
using detail::misses_glues;
using detail::misses_key;
using detail::misses_rekeys;

namespace {

struct Plain {
  std::optional<std::array<Site, 3>> seed(const Front& front) {
    return front.faces() == 0 ? std::optional(std::array<Site, 3>{0, 1, 2}) : std::nullopt;
  }
  std::optional<Site> propose(const Front&, Halfedge) { return std::nullopt; }
};
static_assert(!misses_key<Plain> && !misses_glues<Plain>);

struct OnlyLess {
  double value;
  bool operator<(const OnlyLess& other) const { return value < other.value; }
};

struct KeyOfMutableFront : Plain {
  int key(Front&, Halfedge) { return 0; }
};
struct KeyWithoutHalfedge : Plain {
  int key(const Front&) { return 0; }
};
struct KeyWithOnlyLess : Plain {
  OnlyLess key(const Front&, Halfedge) { return {0}; }
};
class PrivateKey : public Plain {
  [[maybe_unused]] int key(const Front&, Halfedge) { return 0; }
};
struct FinalKey final : Plain {
  int key(Front&, Halfedge) { return 0; }
};
struct OverloadedKey : Plain {
  int key(Front&, Halfedge) { return 0; }
  int key(Front&) { return 0; }
};
static_assert(misses_key<KeyOfMutableFront> && misses_key<KeyWithoutHalfedge> && misses_key<KeyWithOnlyLess>);
static_assert(misses_key<PrivateKey> && misses_key<FinalKey> && misses_key<OverloadedKey>);

struct GoodKey : Plain {
  int key(const Front&, Halfedge) const { return 0; }
};
struct GenericKey : Plain {
  template <typename AnyFront>
  int key(const AnyFront&, Halfedge) const {
    return 0;
  }
};
struct ChangingKey : Plain {
  int key(const Front&, Halfedge) { return 0; }
};
static_assert(!misses_key<GoodKey> && !misses_key<GenericKey> && !misses_key<ChangingKey>);
static_assert(misses_key<const ChangingKey> || !FrontPolicy<const ChangingKey>);

struct IntGlues : Plain {
  int glues(const Front&, Halfedge, Site) { return 1; }
};
struct GluesWithoutApex : Plain {
  bool glues(const Front&, Halfedge) { return true; }
};
struct GoodGlues : Plain {
  bool glues(const Front&, Halfedge, Site) { return true; }
};
static_assert(misses_glues<IntGlues> && misses_glues<GluesWithoutApex> && !misses_glues<GoodGlues>);

struct Rekeys : GoodKey {
  static constexpr bool rekeys_neighbors = true;
};
struct RekeysNot : Plain {
  static constexpr bool rekeys_neighbors = false;
};
struct RekeysWithoutKey : Plain {
  static constexpr bool rekeys_neighbors = true;
};
struct RekeysAtRunTime : GoodKey {
  bool rekeys_neighbors = true;
};
struct RekeysByCall : GoodKey {
  static constexpr bool rekeys_neighbors() { return true; }
};
static_assert(misses_rekeys<RekeysWithoutKey> && misses_rekeys<RekeysAtRunTime> && misses_rekeys<RekeysByCall>);
static_assert(!misses_rekeys<Rekeys> && !misses_rekeys<RekeysNot> && !misses_rekeys<Plain> && !misses_rekeys<GoodKey>);

struct CurvesOverridden : FrontVisitor {
  void curve_split(const Front&, Halfedge, Halfedge) {}
};
struct CurvesInOtherForm : FrontVisitor {
  void curve_closed() {}
};
struct Follows : CurveVisitor {
  void curve_split(const Front&, Halfedge, Halfedge) {}
};
struct Frozen : FrontVisitor {
  void frozen(const Front&, Halfedge) {}
};
static_assert(misses_curves<CurvesOverridden>() && misses_curves<CurvesInOtherForm>());
static_assert(!misses_curves<Follows>() && !misses_curves<Frozen>() && !misses_curves<FrontVisitor>());

struct Freezed : Frozen {
  void freezed(const Front&, Halfedge) {}
};
struct CurvesClosed : Follows {
  void curves_closed(const Front&) {}
};
struct NoEvent : FrontVisitor {
  void when_frozen(const Front&, Halfedge) {}
};
struct BothAtOnce : Plain, Frozen {};  // `seed` of a policy is not an event
struct HasHelper : Frozen {
  void freeze() {}
};
static_assert(misses_events<Freezed>() && misses_events<CurvesClosed>() && misses_events<NoEvent>());
static_assert(!misses_events<FrontVisitor>() && !misses_events<CurveVisitor>() && !misses_events<Follows>());
static_assert(!misses_events<BothAtOnce>() && !misses_events<HasHelper>() && !misses_events<Frozen>());

/// Policy whose proposals have this type.
template <typename Answer>
struct Proposing {
  std::optional<std::array<Site, 3>> seed(const Front&) { return std::nullopt; }
  Answer propose(const Front&, Halfedge);
};
static_assert(FrontPolicy<Proposing<Site>> && FrontPolicy<Proposing<std::optional<Site>>> &&
              FrontPolicy<Proposing<Proposal>> && FrontPolicy<Proposing<std::nullopt_t>>);
static_assert(!FrontPolicy<Proposing<int>> && !FrontPolicy<Proposing<long>> && !FrontPolicy<Proposing<std::size_t>> &&
              !FrontPolicy<Proposing<double>> && !FrontPolicy<Proposing<bool>> && !FrontPolicy<Proposing<Halfedge>> &&
              !FrontPolicy<Proposing<std::optional<int>>> && !FrontPolicy<Proposing<void>>);
static_assert(!std::is_convertible_v<int, Proposal> && !std::is_constructible_v<Proposal, int> &&
              !std::is_constructible_v<Proposal, std::optional<int>> && std::is_convertible_v<Site, Proposal>);

}  // namespace

TEST_SUITE("near misses") {
  TEST_CASE("members with the right signature are accepted, generic ones too") {
    const auto runs = [](auto policy) {
      TestMesh mesh;
      Front front(mesh, 3);
      advance(front, policy, Follows{});
      return front.faces() == 1;
    };
    CHECK(runs(Plain{}));
    CHECK(runs(GoodKey{}));
    CHECK(runs(GenericKey{}));
    CHECK(runs(ChangingKey{}));
    CHECK(runs(Rekeys{}));
    CHECK(runs(RekeysNot{}));
    CHECK(runs(GoodGlues{}));
  }
}
