#include "rbpa/fill/edge_tree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "support/random.h"

TEST_SUITE_BEGIN("fill");

TEST_CASE("a look visits every edge that meets the box, whatever has come and gone, of any length and anywhere") {
  rbpa_test::Random random(5);
  for (const double far : {0.0, 1e6, -0x1p52}) {
    const double extent = far == -0x1p52 ? 64 : 1;
    rbpa::EdgeTree tree({{far, far}, {far + extent, far + extent}});
    std::vector<rbpa::Point> ends;
    std::vector<rbpa::FrontEdge> edges;
    for (meshops::Site i = 0; i < 400; ++i) {
      const rbpa::Point p{far + extent * random.unit(), far + extent * random.unit()};
      const double length = std::ldexp(extent, -random.integer(0, 50));
      const auto other = [&](double from) {
        return std::clamp(from + length * random.between(-1, 1), far, far + extent);
      };
      ends.push_back(p);
      ends.push_back({other(p.x), other(p.y)});
      edges.push_back({2 * i, 2 * i + 1});
      tree.insert(edges.back(), ends[2 * i], ends[2 * i + 1]);
    }
    for (int i = 0; i < 150; ++i) {
      const std::size_t gone = random.below(edges.size());
      tree.erase(edges[gone], ends[edges[gone].from], ends[edges[gone].to]);
      edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(gone));
    }
    for (int i = 0; i < 300; ++i) {
      const double size = std::ldexp(extent, -random.integer(0, 50));
      const rbpa::Point& near = ends[random.below(ends.size())];
      const rbpa::Box box{{near.x - size * random.unit(), near.y - size * random.unit()},
                          {near.x + size * random.unit(), near.y + size * random.unit()}};
      std::set<meshops::Site> visited;
      tree.for_each_near(box, [&](const rbpa::FrontEdge& edge) { CHECK(visited.insert(edge.from).second); });
      for (const rbpa::FrontEdge& edge : edges) {
        const rbpa::Point &a = ends[edge.from], &b = ends[edge.to];
        const bool meets = std::max(a.x, b.x) >= box.low.x && std::min(a.x, b.x) <= box.high.x &&
                           std::max(a.y, b.y) >= box.low.y && std::min(a.y, b.y) <= box.high.y;
        if (meets) CHECK(visited.contains(edge.from));
      }
      for (const meshops::Site from : visited)
        CHECK(std::any_of(edges.begin(), edges.end(), [&](const rbpa::FrontEdge& e) { return e.from == from; }));
    }
  }
}

TEST_SUITE_END();
