// Triangles laid in patches make the same mesh as one by one.
#include "meshops/patch/assembler.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/front/engine.h"
#include "support/arguments.h"
#include "support/check_sound.h"
#include "support/meshes.h"
#include "support/snapshot.h"
#include "support/soups.h"

using namespace meshops;
using namespace meshops::test;

namespace {

using Corners = std::array<Site, 3>;
using Arrow = std::pair<Site, Site>;
using Cycle = std::vector<Site>;

std::size_t below(std::mt19937& random, std::size_t bound) { return random() % bound; }

struct Complex {
  std::size_t sites;
  std::vector<Corners> triangles;

  Arrow side(std::size_t s) const { return {triangles[s / 3][s % 3], triangles[s / 3][(s + 1) % 3]}; }
};

/// Returns some of the triangles of a grid, a band or a torus, in any order, on some of the sites in any order. The
/// fewer are kept, the more holes, pinches and components there are.
Complex random_complex(std::mt19937& random) {
  const auto columns = static_cast<std::uint32_t>(4 + below(random, 4)),
             rows = static_cast<std::uint32_t>(4 + below(random, 4));
  const bool wrap_x = below(random, 2) == 0, wrap_y = below(random, 3) == 0;
  const PolygonSoup grid = shuffled(grid_soup(columns, rows, wrap_x, wrap_y), random, true).soup;
  const std::size_t spare = below(random, 4);
  std::vector<Site> site(grid.points + spare);
  for (std::size_t i = 0; i < site.size(); ++i) site[i] = static_cast<Site>(i);
  std::shuffle(site.begin(), site.end(), random);
  Complex complex{site.size(), {}};
  const std::size_t kept = 2 + below(random, 9);
  for (std::size_t f = 0; f < grid.faces(); ++f) {
    if (below(random, 10) >= kept) continue;
    const auto corners = grid.face(f);
    complex.triangles.push_back({site[corners[0]], site[corners[1]], site[corners[2]]});
  }
  return complex;
}

/// Returns the cycle with the least site first.
Cycle canonical(Cycle cycle) {
  std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  return cycle;
}

/// Shape of a mesh in terms of sites: equal for fronts on which the same triangles are joined in the same way.
struct Shape {
  std::vector<Cycle> triangles;
  std::size_t vertices, edges;
  std::vector<std::pair<Site, Cycle>> fans;  ///< for each fan, the sites around it
  std::vector<Cycle> curves;
  std::vector<Arrow> boundary;

  friend bool operator==(const Shape&, const Shape&) = default;
};

Shape shape(const Front& front) {
  const Connectivity& mesh = front.mesh();
  Shape shape{{}, 0, front.edges(), {}, {}, {}};
  REQUIRE(mesh.n_edges() >= front.edges());
  REQUIRE(mesh.n_faces() >= front.faces());
  for (std::size_t f = 0; f < front.faces(); ++f) {
    Cycle corners;
    const Halfedge first = mesh.halfedge_handle(Face(static_cast<int>(f)));
    Halfedge h = first;
    do {
      REQUIRE(mesh.face_handle(h).idx() == static_cast<int>(f));
      corners.push_back(front.from_site(h));
      h = mesh.next_halfedge_handle(h);
    } while (h != first && corners.size() < 4);
    REQUIRE(corners.size() == 3);
    shape.triangles.push_back(canonical(corners));
  }
  for (int v = 0; v < static_cast<int>(mesh.n_vertices()); ++v) shape.vertices += !mesh.is_isolated(Vertex(v));
  for (Site s = 0; s < front.sites(); ++s) {
    front.for_each_fan(s, [&](Vertex v) {
      CHECK(front.site(v) == s);
      Cycle around;
      const Halfedge first = mesh.halfedge_handle(v);
      Halfedge h = first;
      do {
        around.push_back(front.to_site(h));
        h = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(h));
      } while (h != first);
      shape.fans.emplace_back(s, mesh.is_boundary(v) ? around : canonical(around));
    });
  }
  for (const BoundaryCurve& curve : front.curves()) {
    Cycle sites;
    for (const Halfedge h : curve) {
      sites.push_back(front.from_site(h));
      shape.boundary.emplace_back(front.from_site(h), front.to_site(h));
    }
    // A curve may pass a site twice.
    Cycle least = sites;
    for (std::size_t i = 0; i < sites.size(); ++i) {
      std::rotate(sites.begin(), sites.begin() + 1, sites.end());
      least = std::min(least, sites);
    }
    shape.curves.push_back(least);
  }
  std::sort(shape.triangles.begin(), shape.triangles.end());
  std::sort(shape.fans.begin(), shape.fans.end());
  std::sort(shape.curves.begin(), shape.curves.end());
  std::sort(shape.boundary.begin(), shape.boundary.end());
  return shape;
}

/// Returns the shape of the complex built triangle by triangle.
Shape built_singly(const Complex& complex) {
  TestMesh mesh;
  Front front(mesh, complex.sites);
  for (const Corners& t : complex.triangles) front.create(t[0], t[1], t[2]);
  check_sound(mesh);
  return shape(front);
}

/// Returns for each active or frozen halfedge whether it is frozen. Empties the queue.
std::map<Arrow, bool> frozen_by_side(Front& front) {
  std::map<Arrow, bool> found;
  const auto note = [&](Halfedge h, bool frozen) {
    CHECK(front.mesh().is_boundary(h));
    CHECK(found.try_emplace({front.from_site(h), front.to_site(h)}, frozen).second);
  };
  for (const Halfedge h : front.frozen()) note(h, true);
  for (Halfedge h = front.pop(); h.is_valid(); h = front.pop()) note(h, false);
  return found;
}

/// Sides that patches mark as `nothing`, where that is true.
using Holes = std::set<Arrow>;

/// Returns the triangles whose patch_of is not negative, in `count` patches.
std::vector<Patch> patches(const Complex& complex, const std::vector<int>& patch_of, int count, const Holes& holes) {
  std::map<Arrow, std::pair<int, int>> side_at;  // for each side, its patch and its number there
  std::vector<Patch> made(static_cast<std::size_t>(count));
  for (std::size_t t = 0; t < complex.triangles.size(); ++t) {
    if (patch_of[t] < 0) continue;
    Patch& patch = made[static_cast<std::size_t>(patch_of[t])];
    for (std::size_t i = 0; i < 3; ++i)
      side_at[complex.side(3 * t + i)] = {patch_of[t], static_cast<int>(3 * patch.triangles.size() + i)};
    patch.triangles.push_back(complex.triangles[t]);
  }
  for (int p = 0; p < count; ++p) {
    Patch& patch = made[static_cast<std::size_t>(p)];
    for (const Corners& t : patch.triangles) {
      auto& across = patch.across.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const Site from = t[i], to = t[(i + 1) % 3];
        const auto beyond = side_at.find({to, from});
        if (beyond != side_at.end() && beyond->second.first == p)
          across[i] = beyond->second.second;
        else
          across[i] = beyond == side_at.end() && holes.contains({from, to}) ? Patch::nothing : Patch::open;
      }
    }
  }
  return made;
}

Holes some_sides(const Complex& complex, std::mt19937& random) {
  Holes holes;
  for (std::size_t s = 0; s < 3 * complex.triangles.size(); ++s)
    if (below(random, 2) == 0) holes.insert(complex.side(s));
  return holes;
}

/// Policy that proposes the triangles of a complex.
struct Known {
  explicit Known(const Complex& complex) : triangles(complex.triangles) {
    for (const Corners& t : triangles)
      for (std::size_t i = 0; i < 3; ++i) apex[{t[i], t[(i + 1) % 3]}] = t[(i + 2) % 3];
  }
  std::optional<Corners> seed(const Front& front) {
    std::set<Cycle> there;
    for (const Cycle& t : shape(front).triangles) there.insert(t);
    for (const Corners& t : triangles)
      if (!there.contains(canonical({t.begin(), t.end()}))) return t;
    return std::nullopt;
  }
  std::optional<Site> propose(const Front& front, Halfedge h) {
    const auto found = apex.find({front.from_site(h), front.to_site(h)});
    if (found == apex.end()) return std::nullopt;
    return found->second;
  }
  std::vector<Corners> triangles;
  std::map<Arrow, Site> apex;
};

/// Visitor that checks the mesh at every step.
struct Watch : FrontVisitor {
  void seeded(const Front& front, const InsertedTriangle&) { check_sound(front.mesh()); }
  void attached(const Front& front, Halfedge, const InsertedTriangle&) { check_sound(front.mesh()); }
};

}  // namespace

TEST_SUITE("patch") {
  TEST_CASE("patches laid and joined make the same mesh as their triangles one by one, however they are divided") {
    std::mt19937 random(1);
    for (int round = 0; round < rbpa_test::trials(300); ++round) {
      CAPTURE(round);
      const Complex complex = random_complex(random);
      const Shape expected = built_singly(complex);
      const std::size_t size = complex.triangles.size();
      for (const std::size_t most : {std::size_t{1}, std::size_t{3}, size + 1}) {
        CAPTURE(most);
        const auto count = static_cast<int>(1 + below(random, most));
        std::vector<int> patch_of(size);
        for (int& p : patch_of) p = static_cast<int>(below(random, static_cast<std::size_t>(count)));
        const Holes holes = some_sides(complex, random);
        TestMesh mesh;
        PatchAssembler assembler(mesh, complex.sites);
        for (const Patch& patch : patches(complex, patch_of, count, holes)) assembler.lay(patch);
        CHECK(assembler.faces() == size);
        Front front(std::move(assembler).join());
        check_sound(mesh);
        CHECK(front.faces() == size);
        CHECK(mesh.n_faces() == size);
        CHECK(mesh.n_edges() == front.edges());
        REQUIRE(shape(front) == expected);
        // It does not matter how the patch beyond would mark its side: nothing lies there.
        std::map<Arrow, bool> sides;
        for (const auto& [from, to] : expected.boundary) sides[{from, to}] = holes.contains({to, from});
        CHECK(frozen_by_side(front) == sides);
      }
    }
  }

  TEST_CASE("a side beyond which nothing lies is frozen, and others on its sites are glued as usual") {
    TestMesh mesh;
    PatchAssembler assembler(mesh, 4);
    assembler.lay({{{0, 1, 2}}, {{Patch::open, Patch::nothing, Patch::nothing}}});
    assembler.lay({{{3, 1, 0}}, {{Patch::nothing, Patch::open, Patch::nothing}}});
    Front front(std::move(assembler).join());
    check_sound(mesh);
    CHECK(mesh.n_edges() == 5);
    CHECK(frozen_by_side(front) ==
          std::map<Arrow, bool>{{{2, 1}, true}, {{0, 2}, true}, {{1, 3}, true}, {{3, 0}, true}});
  }

  TEST_CASE("patches filled later, in any order, make the same mesh as lay()") {
    std::mt19937 random(4);
    for (int round = 0; round < 100; ++round) {
      CAPTURE(round);
      const Complex complex = random_complex(random);
      std::vector<int> patch_of(complex.triangles.size());
      for (int& p : patch_of) p = static_cast<int>(below(random, 6));
      const std::vector<Patch> all = patches(complex, patch_of, 6, some_sides(complex, random));
      TestMesh laid, filled;
      PatchAssembler assembler(laid, complex.sites), other(filled, complex.sites);
      std::vector<Outline> outlines(all.size());
      std::vector<Placement> placements(all.size());
      for (std::size_t i = 0; i < all.size(); ++i) {
        assembler.lay(all[i]);
        survey(all[i], outlines[i]);
        other.place(all[i], outlines[i], placements[i]);
      }
      std::vector<std::size_t> order = {0, 1, 2, 3, 4, 5};
      std::shuffle(order.begin(), order.end(), random);
      for (const std::size_t i : order) other.fill(all[i], outlines[i], placements[i]);
      (void)std::move(assembler).join();
      (void)std::move(other).join();
      CHECK(snapshot(filled) == snapshot(laid));
    }
  }

  TEST_CASE("a front continues laid patches as if they had been built triangle by triangle") {
    std::mt19937 random(2);
    for (int round = 0; round < 60; ++round) {
      CAPTURE(round);
      const Complex complex = random_complex(random);
      Known policy(complex);
      std::vector<int> patch_of;
      for (std::size_t t = 0; t < complex.triangles.size(); ++t)
        patch_of.push_back(static_cast<int>(below(random, 4)) - 1);
      Holes holes;  // only where it is true
      for (std::size_t s = 0; s < 3 * complex.triangles.size(); ++s) {
        const auto [from, to] = complex.side(s);
        if (!policy.apex.contains({to, from}) && below(random, 2) == 0) holes.insert({from, to});
      }
      TestMesh mesh;
      PatchAssembler assembler(mesh, complex.sites);
      for (const Patch& patch : patches(complex, patch_of, 3, holes)) assembler.lay(patch);
      Front front(std::move(assembler).join());
      Watch watch;
      advance(front, policy, watch);
      const Shape expected = built_singly(complex);
      REQUIRE(shape(front) == expected);
      std::set<Site> to_carry;
      for (const auto& [from, to] : expected.boundary) to_carry.insert({from, to});
      std::map<Arrow, bool> sides;
      for (const Arrow& arrow : expected.boundary) sides[arrow] = true;
      CHECK(frozen_by_side(front) == sides);
      for (Site s = 0; s < front.sites(); ++s)
        if (front.is_free(s)) to_carry.insert(s);
      const LevelTransfer transfer = front.next_level();
      CHECK(transfer.carried == std::vector<Site>(to_carry.begin(), to_carry.end()));
      CHECK(transfer.reactivated == expected.boundary.size());
      const std::vector<Site> left = front.finish();
      CHECK(left.size() == expected.vertices);
      CHECK(mesh.n_vertices() == expected.vertices);
      check_sound(mesh);
    }
  }

  TEST_CASE("finish() leaves the same mesh and returns the same sites as a front") {
    std::mt19937 random(6);
    for (int round = 0; round < 100; ++round) {
      CAPTURE(round);
      const Complex complex = random_complex(random);
      std::vector<int> patch_of(complex.triangles.size());
      for (int& p : patch_of) p = static_cast<int>(below(random, 3));
      const std::vector<Patch> all = patches(complex, patch_of, 3, some_sides(complex, random));
      TestMesh mesh, of_front;
      PatchAssembler assembler(mesh, complex.sites), other(of_front, complex.sites);
      for (const Patch& patch : all) {
        assembler.lay(patch);
        other.lay(patch);
      }
      AssembledPatches assembled = std::move(assembler).join();
      Front front(std::move(other).join());
      CHECK(assembled.faces() == front.faces());
      CHECK(assembled.sites() == front.sites());
      for (Site s = 0; s < front.sites(); ++s) CHECK(assembled.is_free(s) == front.is_free(s));
      CHECK(std::move(assembled).finish() == front.finish());
      CHECK(snapshot(mesh) == snapshot(of_front));
      check_sound(mesh);
    }
  }

  TEST_CASE("no patch, or an empty one, leaves a front without triangles") {
    for (const bool empty : {false, true}) {
      TestMesh mesh;
      PatchAssembler assembler(mesh, 3);
      if (empty) assembler.lay({});
      Front front(std::move(assembler).join());
      check_sound(mesh);
      CHECK(mesh.n_vertices() == 3);
      CHECK(front.faces() == 0);
      CHECK_FALSE(front.pop().is_valid());
      front.create(0, 1, 2);
      CHECK(front.faces() == 1);
    }
  }

  TEST_CASE("patches are laid in an empty mesh, and need an entry of across for every triangle") {
    const Patch without{{{0, 1, 2}}, {}};
    const Patch beyond{{}, {{Patch::open, Patch::open, Patch::open}}};
    TestMesh mesh;
    PatchAssembler assembler(mesh, 6);
    const auto empty = snapshot(mesh);
    CHECK_THROWS_AS(assembler.lay(without), ContractViolation);
    CHECK_THROWS_AS(assembler.lay(beyond), ContractViolation);
    CHECK(snapshot(mesh) == empty);
    CHECK_THROWS_AS(PatchAssembler(mesh, 6), ContractViolation);
  }

  TEST_CASE("the outline of another patch is refused") {
    const Patch patch{{{0, 1, 2}}, {{Patch::open, Patch::open, Patch::open}}};
    TestMesh mesh;
    PatchAssembler assembler(mesh, 3);
    const auto empty = snapshot(mesh);
    Placement placement;
    CHECK_THROWS_AS(assembler.place(patch, {}, placement), ContractViolation);
    CHECK_THROWS_AS(assembler.place(patch, {{0, 1}, {}, {}, {}}, placement), ContractViolation);
    CHECK_THROWS_AS(assembler.place(patch, {{0, 1, 2, 3, 4}, {}, {}, {}}, placement), ContractViolation);
    CHECK_THROWS_AS(assembler.place(patch, {{0, 1}, {2}, {}, {}}, placement), ContractViolation);
    CHECK(snapshot(mesh) == empty);
    assembler.place(patch, {{0, 1, 2}, {}, {}, {}}, placement);
    assembler.fill(patch, {{0, 1, 2}, {}, {}, {}}, placement);
    (void)std::move(assembler).join();
    check_sound(mesh);
  }

  TEST_CASE("insert() with the existing sides equals create() on a front") {
    std::mt19937 random(3);
    for (int round = 0; round < 60; ++round) {
      CAPTURE(round);
      const Complex complex = random_complex(random);
      TestMesh created, inserted;
      Front one(created, complex.sites), other(inserted, complex.sites);
      for (const Corners& t : complex.triangles) {
        one.create(t[0], t[1], t[2]);
        Fit fit(t);
        for (const auto h : inserted.halfedges())
          for (std::size_t i = 0; i < 3; ++i)
            if (h.is_boundary() && other.from_site(h) == t[i] && other.to_site(h) == t[(i + 1) % 3])
              fit.sides.side[i] = h;
        const InsertedTriangle triangle = other.insert(fit);
        for (std::size_t i = 0; i < 3; ++i) {
          CHECK(other.from_site(triangle.side[i]) == t[i]);
          CHECK(other.to_site(triangle.side[i]) == t[(i + 1) % 3]);
        }
        REQUIRE(snapshot(inserted) == snapshot(created));
      }
      CHECK(shape(other) == shape(one));
      CHECK(frozen_by_side(other) == frozen_by_side(one));
    }
  }
}
