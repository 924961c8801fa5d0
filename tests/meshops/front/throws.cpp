// Whatever is thrown out of a policy or a visitor, no edge of the front is lost: another advance() processes each of
// them, and makes the same mesh as a run without throws.
#include <doctest/doctest.h>

#include <stdexcept>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/front/engine.h"
#include "support/check_sound.h"
#include "support/meshes.h"
#include "support/snapshot.h"

using namespace meshops;
using namespace meshops::test;

namespace {

/// Throws at one of the calls, which it counts.
struct Fuse {
  long left = -1;
  long asked = 0;
  void burn() {
    ++asked;
    if (left >= 0 && left-- == 0) throw std::runtime_error("blown");
  }
};
Fuse fuse;  // global, because comparisons and moves of keys have no access to a policy

/// Key whose comparisons and moves throw, too.
struct Fragile {
  unsigned value = 0;
  explicit Fragile(unsigned v) : value(v) {}
  Fragile(const Fragile& other) : value(other.value) { fuse.burn(); }
  Fragile(Fragile&& other) : value(std::exchange(other.value, 999'999U)) { fuse.burn(); }
  Fragile& operator=(const Fragile& other) {
    fuse.burn();
    value = other.value;
    return *this;
  }
  Fragile& operator=(Fragile&& other) {
    fuse.burn();
    value = std::exchange(other.value, 999'999U);
    return *this;
  }
  ~Fragile() = default;
  [[maybe_unused]] friend bool operator==(const Fragile& a, const Fragile& b) { return a.value == b.value; }
  friend bool operator<(const Fragile& a, const Fragile& b) {
    fuse.burn();
    return a.value < b.value;
  }
  [[maybe_unused]] friend bool operator>(const Fragile& a, const Fragile& b) { return b < a; }
  [[maybe_unused]] friend bool operator<=(const Fragile& a, const Fragile& b) { return !(b < a); }
  [[maybe_unused]] friend bool operator>=(const Fragile& a, const Fragile& b) { return !(a < b); }
};

constexpr Site sites = 24;
unsigned mixed(Site a, Site b, unsigned salt) { return (a * 7919U + b * 104'729U + salt * 31U) % 1009U; }

/// Policy whose answer is a function of the edge.
struct OfTheEdge {
  std::optional<std::array<Site, 3>> seed(const Front& front) {
    fuse.burn();
    for (Site s = 0; s + 2 < sites; s += 5)
      if (front.is_free(s) && front.is_free(s + 1) && front.is_free(s + 2)) return std::array{s, s + 1, s + 2};
    return std::nullopt;
  }
  std::optional<Site> propose(const Front& front, Halfedge h) {
    fuse.burn();
    const unsigned m = mixed(front.from_site(h), front.to_site(h), 1);
    if (m % 7 == 0) return std::nullopt;
    if (m % 3 == 0) return front.to_site(front.mesh().next_halfedge_handle(h));
    return m % sites;
  }
};
struct ByKey : OfTheEdge {
  unsigned key(const Front& front, Halfedge h) {
    fuse.burn();
    return mixed(front.from_site(h), front.to_site(h), 2) % 11;  // many are equal
  }
};
struct ByFragileKey : OfTheEdge {
  Fragile key(const Front& front, Halfedge h) { return Fragile(mixed(front.from_site(h), front.to_site(h), 2) % 11); }
};
struct Gluing : ByKey {
  bool glues(const Front& front, Halfedge h, Site apex) {
    fuse.burn();
    return mixed(front.from_site(h), front.to_site(h), apex) % 3 != 0;
  }
};

/// Some edges wait until the front has enough triangles. Keys depend on the neighbors.
struct Waiting : OfTheEdge {
  Proposal propose(const Front& front, Halfedge h) {
    const unsigned m = mixed(front.from_site(h), front.to_site(h), 3);
    if (m % 4 > 0 || front.faces() >= m % 25) return OfTheEdge::propose(front, h);
    fuse.burn();
    return Proposal::defer();
  }
};
struct WaitingByAngle : Waiting {
  static constexpr bool rekeys_neighbors = true;
  unsigned key(const Front& front, Halfedge h) {
    fuse.burn();
    return mixed(front.from_site(front.mesh().prev_halfedge_handle(h)), front.to_site(h), 4) % 11;
  }
};
struct WaitingByFragileAngle : WaitingByAngle {
  Fragile key(const Front& front, Halfedge h) { return Fragile(WaitingByAngle::key(front, h)); }
};
/// Other edges insert several triangles at once.
struct Listing : WaitingByAngle {
  Proposal propose(const Front& front, Halfedge h) {
    const Site a = front.from_site(h), b = front.to_site(h);
    const unsigned m = mixed(a, b, 5), c = m % sites, d = m / 7 % sites;
    if (m % 3 > 0) return Waiting::propose(front, h);
    fuse.burn();
    return Proposal::triangles({{a, b, c}, {c, b, d}, {1, c, d}});
  }
};

/// Some triangles at the front are detached again, a limited number of them.
struct Detaching : OfTheEdge {
  int left = 12;
  Proposal propose(const Front& front, Halfedge h) {
    const Face behind = front.mesh().face_handle(front.mesh().opposite_halfedge_handle(h));
    if (mixed(front.from_site(h), front.to_site(h), 6) % 3 > 0 || left == 0) return OfTheEdge::propose(front, h);
    fuse.burn();
    --left;
    return Proposal::detach(behind);
  }
};

/// Visitor that counts the curves by their events, and then may throw.
struct Burning : CurveVisitor {
  int curves = 0;
  void seeded(const Front&, const InsertedTriangle&) { fuse.burn(); }
  void attached(const Front&, Halfedge, const InsertedTriangle&) { fuse.burn(); }
  void frozen(const Front&, Halfedge) { fuse.burn(); }
  void deferred(const Front&, Halfedge) { fuse.burn(); }
  void refused(const Front&, Halfedge, const Refusal&) { fuse.burn(); }
  void detached(const Front&, const DetachedTriangle&) { fuse.burn(); }
  void curve_begun(const Front&, Halfedge) { count(1); }
  void curves_joined(const Front&, Halfedge) { count(-1); }
  void curve_split(const Front&, Halfedge, Halfedge) { count(1); }
  void curve_closed(const Front&) { count(-1); }

 private:
  void count(int change) {
    curves += change;
    fuse.burn();
  }
};

/// Throws at the call `at`, then at every `every`-th call if that is not 0, advances again after each throw, and
/// returns the mesh.
template <typename Policy>
std::vector<int> run(long at, long every, std::size_t& throws) {
  TestMesh mesh;
  Front front(mesh, sites);
  Policy policy;
  Burning visitor;
  // After an exception, too, the visitor has received all events of a triangle.
  const auto has_all_events = [&] { return visitor.curves == static_cast<int>(front.curves().size()); };
  fuse = {at, 0};
  for (;;) {
    try {
      advance(front, policy, visitor);
      break;
    } catch (const std::runtime_error&) {
      ++throws;
      fuse.left = every > 0 ? every : -1;
      check_sound(mesh);
      REQUIRE(has_all_events());
      for (const BoundaryCurve& curve : front.curves())
        for (const Halfedge h : curve) REQUIRE((front.is_active(h) || front.is_frozen(h)));
    }
  }
  fuse.left = -1;
  check_sound(mesh);
  REQUIRE(has_all_events());
  for (const BoundaryCurve& curve : front.curves())
    for (const Halfedge h : curve) REQUIRE(front.is_frozen(h));
  front.finish();
  return snapshot(mesh);
}

/// Checks a policy with lists: the rest of a list is lost, so that the mesh differs.
template <typename Policy>
void check_every_throw(bool is_resumed = true) {
  std::size_t throws = 0;
  const std::vector<int> expected = run<Policy>(-1, 0, throws);
  const long questions = fuse.asked;
  REQUIRE(throws == 0);
  REQUIRE(questions > 40);
  for (long at = 0; at < questions; at += 1 + questions / 400) {
    CAPTURE(at);
    throws = 0;
    const std::vector<int> resumed = run<Policy>(at, 0, throws);
    if (is_resumed) REQUIRE(resumed == expected);
    REQUIRE(throws == 1);
  }
  // Throw repeatedly, but rarely enough that a run makes progress between two throws.
  throws = 0;
  const std::vector<int> resumed = run<Policy>(7, 2000, throws);
  if (is_resumed) CHECK(resumed == expected);
  CHECK(throws >= 1);
}

}  // namespace

TEST_SUITE("throws") {
  TEST_CASE("first in first out, the mesh is that of a run without throws, whichever call or event throws") {
    check_every_throw<OfTheEdge>();
  }
  TEST_CASE("least key first, the mesh is that of a run without throws, whichever call or event throws") {
    check_every_throw<ByKey>();
  }
  TEST_CASE("the mesh is that of a run without throws, whichever comparison or move of a key throws") {
    check_every_throw<ByFragileKey>();
  }
  TEST_CASE("the mesh is that of a run without throws, whichever call of glues() throws") {
    check_every_throw<Gluing>();
  }

  TEST_CASE("with deferred edges, the mesh is that of a run without throws, whichever call or event throws") {
    check_every_throw<Waiting>();
  }
  TEST_CASE(
      "with rekeying, the mesh is that of a run without throws, whichever call, event, comparison or move throws") {
    check_every_throw<WaitingByAngle>();
    check_every_throw<WaitingByFragileAngle>();
  }
  TEST_CASE("with detached triangles no edge is lost, whichever call or event throws") {
    check_every_throw<Detaching>(false);
  }
  TEST_CASE("with lists of triangles no edge is lost, whichever call or event throws") {
    check_every_throw<Listing>(false);
  }

  TEST_CASE("keys that throw lose no edge, and each edge is proposed for in the end") {
    struct Strip {
      std::size_t thrown = 0, proposals = 0;
      unsigned calls = 0;
      std::optional<std::array<Site, 3>> seed(const Front& front) {
        return front.faces() == 0 ? std::optional(std::array<Site, 3>{0, 1, 2}) : std::nullopt;
      }
      std::optional<Site> propose(const Front& front, Halfedge) {
        ++proposals;
        return front.sites() < 60 ? std::optional(static_cast<Site>(front.sites())) : std::nullopt;
      }
      int key(const Front&, Halfedge h) {
        if (thrown < 200 && ++calls % 7 == 0) {
          ++thrown;
          throw std::runtime_error("no key");
        }
        return h.idx();
      }
    } policy;
    TestMesh mesh;
    Front front(mesh, 3);
    // The keys of all waiting edges are computed again after a throw, so that the number of throws is limited.
    for (bool done = false; !done;) try {
        advance(front, policy);
        done = true;
      } catch (const std::runtime_error&) {
        check_sound(mesh);
      }
    CHECK(policy.thrown > 50);
    CHECK(front.sites() == 60);
    CHECK(policy.proposals == 57 + 60);
    for (const BoundaryCurve& curve : front.curves())
      for (const Halfedge h : curve) CHECK(front.is_frozen(h));
  }
}
