// The sites visible from the edges of a front, and the cost of finding them.
#include "rbpa/fill/front/unfilled.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "fill/laws.h"
#include "rbpa/fill.h"
#include "support/random.h"

TEST_SUITE_BEGIN("fill");

using rbpa::FrontEdge;
using rbpa::Point;
using rbpa::Unfilled;
using rbpa_test::Points;
using Site = Unfilled::Site;

namespace {

/// Returns the exact orientation, as coordinates are small integers.
int orientation(const Point& a, const Point& b, const Point& c) {
  const double turn = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return (turn > 0) - (turn < 0);
}

/// A front as a list; every question is decided by exhaustive search.
struct Listed {
  Points places = {};
  std::vector<FrontEdge> edges = {};

  bool is_listed(const FrontEdge& edge) const { return std::find(edges.begin(), edges.end(), edge) != edges.end(); }
  void toggle(Site from, Site to) {
    if (is_listed({to, from}))
      std::erase(edges, FrontEdge{to, from});
    else
      edges.push_back({from, to});
  }
  bool is_empty(const FrontEdge& edge, const Point& apex) const {
    const Point &a = places[edge.from], &b = places[edge.to];
    if (orientation(a, b, apex) <= 0) return false;
    const auto crosses = [&](const Point& p, const Point& q, const Point& r, const Point& s) {
      return orientation(p, q, r) * orientation(p, q, s) < 0 && orientation(r, s, p) * orientation(r, s, q) < 0;
    };
    return std::none_of(edges.begin(), edges.end(), [&](const FrontEdge& other) {
      const Point &p = places[other.from], &q = places[other.to];
      const bool is_inside = p != a && p != b && p != apex && orientation(a, b, p) >= 0 &&
                             orientation(b, apex, p) >= 0 && orientation(apex, a, p) >= 0;
      const bool is_on_it =
          p != apex && q != apex && orientation(p, q, apex) == 0 && std::min(p, q) < apex && apex < std::max(p, q);
      return is_inside || is_on_it || crosses(p, q, a, apex) || crosses(p, q, b, apex);
    });
  }
  std::set<Site> free_sites(const FrontEdge& edge) const {
    std::set<Site> sites;
    for (const FrontEdge& other : edges)
      if (is_empty(edge, places[other.from])) sites.insert(other.from);
    return sites;
  }
  std::set<Site> sites() const {
    std::set<Site> sites;
    for (const FrontEdge& edge : edges) sites.insert(edge.from);
    return sites;
  }
  /// Returns the edges as rings. Where a ring passes a site twice, any choice is right.
  std::vector<std::vector<Site>> rings() const {
    std::multimap<Site, Site> next;
    for (const FrontEdge& edge : edges) next.emplace(edge.from, edge.to);
    std::vector<std::vector<Site>> rings;
    while (!next.empty()) {
      rings.emplace_back();
      for (auto at = next.begin(); at != next.end(); at = next.find(rings.back().back())) {
        if (rings.back().empty()) rings.back().push_back(at->first);
        rings.back().push_back(at->second);
        next.erase(at);
      }
      rings.back().pop_back();  // the first again
    }
    return rings;
  }
};

std::set<std::array<Site, 3>> triangles_of(const Unfilled& unfilled) {
  std::set<std::array<Site, 3>> triangles;
  for (std::array<Site, 3> corners : unfilled.triangles()) {
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.insert(corners);
  }
  return triangles;
}

/// Returns a star on a grid, so that many points are on one line.
Points star(rbpa_test::Random& random, int corners) {
  Points places;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / corners, radius = random.chance(0.5) ? 64 : 20;
    const Point p{std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle))};
    if (std::find(places.begin(), places.end(), p) == places.end()) places.push_back(p);
  }
  return places;
}

const rbpa::Box everywhere{{-1e9, -1e9}, {1e9, 1e9}};

}  // namespace

TEST_CASE("every edge sees exactly the sites that make empty triangles, after any sequence of filling and emptying") {
  rbpa_test::Random random(11);
  int emptied = 0, placed = 0, taken_out = 0;
  for (int turn = 0; turn < 10; ++turn) {
    Listed front{.places = star(random, 14)};
    std::vector<std::vector<Site>> rings(1);
    for (Site i = 0; i < front.places.size(); ++i) {
      rings[0].push_back(i);
      front.edges.push_back({i, static_cast<Site>((i + 1) % front.places.size())});
    }
    Unfilled unfilled(front.places, rings, {});
    std::vector<std::array<Site, 3>> filled;
    for (int step = 0; step < 40 && !front.edges.empty(); ++step) {
      std::set<Site> on_front;
      for (const FrontEdge& edge : front.edges) {
        on_front.insert(edge.from);
        unfilled.look_from(edge);
        const auto found = unfilled.free_sites(everywhere);
        REQUIRE(std::set<Site>(found.begin(), found.end()) == front.free_sites(edge));
        for (const Site s : found) REQUIRE(unfilled.is_free(edge, s));
      }
      std::set<Site> corners;
      for (const auto& [a, b, c] : unfilled.triangles()) {
        REQUIRE(orientation(front.places[a], front.places[b], front.places[c]) > 0);
        corners.insert({a, b, c});
      }
      REQUIRE(corners == on_front);
      const FrontEdge edge = front.edges[random.below(front.edges.size())];
      if (!filled.empty() && random.chance(0.3)) {  // the last goes
        const std::array<Site, 3> t = filled.back();
        filled.pop_back();
        std::array<bool, 3> is_front;
        for (std::size_t i = 0; i < 3; ++i) {
          is_front[i] = !front.is_listed({t[(i + 1) % 3], t[i]});
          front.toggle(t[i], t[(i + 1) % 3]);
        }
        unfilled.empty(t, is_front);
        ++emptied;
        taken_out += std::count(is_front.begin(), is_front.end(), true) == 1;
        continue;
      }
      const Point &a = front.places[edge.from], &b = front.places[edge.to];
      const Point apex{std::round((a.x + b.x) / 2 - (b.y - a.y) / 4), std::round((a.y + b.y) / 2 + (b.x - a.x) / 4)};
      const bool is_free = unfilled.is_free(edge, apex, 0);
      REQUIRE(is_free == front.is_empty(edge, apex));
      if (is_free) REQUIRE(!unfilled.is_free(edge, apex, 1000));
      const std::set<Site> sites = front.free_sites(edge);
      Site site = *std::next(sites.begin(), static_cast<std::ptrdiff_t>(random.below(sites.size())));
      if (is_free && random.chance(0.6)) {
        site = static_cast<Site>(front.places.size());
        front.places.push_back(apex);
        ++placed;
      }
      unfilled.fill(edge, site);
      filled.push_back({edge.from, edge.to, site});
      std::erase(front.edges, edge);
      for (const auto& [from, to] : {std::pair(site, edge.to), std::pair(edge.from, site)})
        if (front.is_listed({to, from}))
          std::erase(front.edges, FrontEdge{to, from});
        else
          front.edges.push_back({from, to});
    }
  }
  CHECK(emptied > 20);
  CHECK(placed > 20);
  CHECK(taken_out > 10);
}

TEST_CASE("after any sequence of filling and emptying the triangulation equals one that is built anew") {
  rbpa_test::Random random(12);
  int one = 0, more = 0;
  for (int turn = 0; turn < 40; ++turn) {
    // Almost surely no four places are on one circle, so that there is one triangulation. Large coordinates have
    // squares that are infinite.
    const double unit = turn % 2 == 1 ? 0x1p300 : 1;
    const auto near = [&](double x, double y) {
      return Point{unit * std::round(x / unit + random.between(-1024, 1024)),
                   unit * std::round(y / unit + random.between(-1024, 1024))};
    };
    Listed front;
    for (int i = 0; i < 8; ++i) {
      const double angle = 3.14159265358979323846 * i / 4;
      front.places.push_back(near(0x1p19 * unit * std::cos(angle), 0x1p19 * unit * std::sin(angle)));
      front.edges.push_back({static_cast<Site>(i), static_cast<Site>((i + 1) % 8)});
    }
    Unfilled unfilled(front.places, front.rings(), {});
    std::vector<std::array<Site, 3>> filled;
    for (int step = 0; step < 200; ++step) {
      const std::size_t sites = front.sites().size();
      if (step % 40 < 20 && !front.edges.empty()) {
        const FrontEdge edge = front.edges[random.below(front.edges.size())];
        const std::set<Site> free = front.free_sites(edge);
        Site apex = *std::next(free.begin(), static_cast<std::ptrdiff_t>(random.below(free.size())));
        const Point &a = front.places[edge.from], &b = front.places[edge.to];
        const Point place = near((a.x + b.x) / 2 - (b.y - a.y) / 4, (a.y + b.y) / 2 + (b.x - a.x) / 4);
        if (random.chance(0.8) && front.is_empty(edge, place)) {
          apex = static_cast<Site>(front.places.size());
          front.places.push_back(place);
        }
        unfilled.fill(edge, apex);
        filled.push_back({edge.from, edge.to, apex});
        for (std::size_t i = 0; i < 3; ++i) front.toggle(filled.back()[(i + 1) % 3], filled.back()[i]);
      } else if (!filled.empty()) {  // any that has a side on the front
        std::swap(filled[random.below(filled.size())], filled.back());
        const std::array<Site, 3> t = filled.back();
        std::array<bool, 3> is_front;
        for (std::size_t i = 0; i < 3; ++i) is_front[i] = !front.is_listed({t[(i + 1) % 3], t[i]});
        if (is_front == std::array{true, true, true}) continue;
        filled.pop_back();
        for (std::size_t i = 0; i < 3; ++i) front.toggle(t[i], t[(i + 1) % 3]);
        unfilled.empty(t, is_front);
        const std::size_t gone = sites - front.sites().size();
        one += gone == 1;
        more += gone == 3;
      }
      if (front.edges.empty()) continue;
      REQUIRE(triangles_of(unfilled) == triangles_of(Unfilled(front.places, front.rings(), {})));
    }
  }
  CHECK(one > 100);
  CHECK(more > 20);
}

TEST_CASE("a site that thousands of sites see is placed and removed") {
  // The places are near a circle, but no four are on one. A site in the middle has nearly all others as neighbors.
  constexpr int corners = 20000;
  Listed front;
  rbpa_test::Random random(13);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / corners;
    const double radius = i % 2 == 1 ? 1 << 28 : random.between(1 << 26, (1 << 26) + 8);
    front.places.push_back({std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle))});
    front.edges.push_back({static_cast<Site>(i), static_cast<Site>((i + 1) % corners)});
  }
  Unfilled unfilled(front.places, front.rings(), {});
  const auto before = triangles_of(unfilled);
  for (int turn = 0; turn < 3; ++turn) {
    FrontEdge edge{};
    do edge = front.edges[random.below(corners)];
    while (!unfilled.is_free(edge, Point{0, 0}, 0));
    front.places.push_back({0, 0});
    const std::size_t work = unfilled.passed();
    const auto middle = static_cast<Site>(front.places.size() - 1);
    unfilled.fill(edge, middle);
    CHECK(triangles_of(unfilled) != before);
    unfilled.empty({edge.from, edge.to, middle}, {true, false, false});
    CHECK(triangles_of(unfilled) == before);
    CHECK(unfilled.passed() - work < std::size_t{3 * corners / 2});
  }
}

TEST_CASE("combs, saws and stars of thousands of long edges pass few triangles for each one made") {
  constexpr int teeth = 2000;
  constexpr double width = 1.0 / teeth;
  Points comb = {{0, -1}, {1, -1}, {1, 0}}, saw = comb;
  for (int i = teeth; i > 0; --i) {
    for (const Point& p :
         Points{{(i - 0.5) * width, 0}, {(i - 0.5) * width, 1}, {(i - 1) * width, 1}, {(i - 1) * width, 0}})
      comb.push_back(p);
    saw.push_back({(i - 0.5) * width, 1});
    saw.push_back({(i - 1) * width, 0});
  }
  comb.pop_back();
  const auto star = [&](double inner) {
    Points tips;
    for (int i = 0; i < 2 * teeth; ++i) {
      const double angle = 3.14159265358979323846 * i / teeth, radius = i % 2 == 1 ? 1 : inner;
      tips.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return tips;
  };
  // Teeth as wide as the last places of their coordinates allow.
  Points narrow = {{0, 0}};
  for (int i = 1; i <= 20; ++i)
    for (const Point& p : Points{{i * 0x1p-49, 0}, {i * 0x1p-49 + 0x1p-80, 5}, {i * 0x1p-49 + 0x1p-79, 0}})
      narrow.push_back(p);
  narrow.push_back({narrow.back().x, 6});
  narrow.push_back({0, 6});
  const auto passed = [](const Points& points, const rbpa::FillOptions& options) {
    std::vector<rbpa::Polygon> polygons(1);
    for (std::uint32_t i = 0; i < points.size(); ++i) polygons[0].shell.points.push_back(i);
    const rbpa::Filling filling = rbpa::fill(points, polygons, options);
    CHECK(rbpa_test::wrong_with_filling(filling, points, polygons, false) == "");
    return filling.passed / filling.triangles.size();
  };
  // Ordinary polygons need thirty.
  CHECK(passed({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {.size = 0.02}) < 40);
  CHECK(passed(saw, {.size = 10}) < 500);
  CHECK(passed(comb, {.size = 0.05}) < 500);
  CHECK(passed(star(1e-4), {.size = 10}) < 500);
  CHECK(passed(star(0.5), {.size = 10}) < 500);
  CHECK(passed(narrow, {.size = 1, .grade = 0.05}) < 500);
}

TEST_SUITE_END();
