// Regions, cut anyhow and merged in any order, are the whole.
#include "rbpa/partial/partial.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "partial/cuts.h"
#include "rbpa/partial/bytes.h"
#include "rbpa/triangulate.h"
#include "support/generate.h"
#include "support/pictures.h"
#include "support/sets.h"
#include "support/shrink.h"
#include "support/tile_sets.h"

using namespace rbpa_test;
using rbpa::Partial;
using rbpa::Point;
using rbpa::Region;

TEST_SUITE_BEGIN("partial");

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Triangles and isolated points of all regions are those of the whole.
std::string wrong_with_items(const Points& points, double alpha, const Regions& regions) {
  const rbpa::Triangulation expected = rbpa::triangulate(points, alpha, {.threads = 1});
  rbpa::OwnedItems all;
  for (const Region& region : regions) {
    const auto [partial, owned] = rbpa::partial_and_items(region, given(region, points, alpha), alpha, {.threads = 1});
    if (partial.counts().triangles != owned.triangles.size()) return "triangles counted";
    if (!std::is_sorted(owned.triangles.begin(), owned.triangles.end())) return "order of triangles";
    all.triangles.insert(all.triangles.end(), owned.triangles.begin(), owned.triangles.end());
    all.isolated.insert(all.isolated.end(), owned.isolated.begin(), owned.isolated.end());
  }
  std::sort(all.triangles.begin(), all.triangles.end());
  std::sort(all.isolated.begin(), all.isolated.end());
  const auto same = [](const auto& a, const auto& b) { return std::equal(a.begin(), a.end(), b.begin(), b.end()); };
  if (!std::equal(all.triangles.begin(), all.triangles.end(), expected.triangles.begin(), expected.triangles.end(),
                  [&](const auto& a, const auto& b) { return same(a, b); }))
    return "triangles";
  return same(all.isolated, expected.isolated) ? "" : "isolated points";
}

/// Empty when merging the regions in several orders is the whole, and always the same bytes.
std::string wrong_with_cut(const Points& points, double alpha, const Regions& regions, int orders, Random& random) {
  const rbpa::WholeComplex expected = whole(points, alpha);
  const std::vector<Partial> parts = partials(regions, points, alpha);
  Bytes bytes;
  for (int order = 0; order < orders; ++order) {
    Partial all = merged(parts, random);
    const Bytes now = rbpa::to_bytes(all);
    if (order > 0 && now != bytes) return "other bytes";
    bytes = now;
    if (!all.is_whole()) return "not whole";
    if (std::string wrong = difference(rbpa::finish(std::move(all)), expected); !wrong.empty()) return wrong;
  }
  return wrong_with_items(points, alpha, regions);
}

/// Cuts into about so many regions, each checked; what fails is made small.
void check_cuts(const Points& points, double alpha, std::size_t regions, int cuts, int orders, Random& random) {
  for (int cut = 0; cut < cuts; ++cut) {
    const Regions chosen = any_cut(points, regions, random);
    const std::string wrong = wrong_with_cut(points, alpha, chosen, orders, random);
    CHECK_MESSAGE(wrong.empty(), wrong, ", alpha ", literal(alpha), ", ", points.size(), " points, ", chosen.size(),
                  " regions");
    if (!wrong.empty()) return;
  }
}

}  // namespace

TEST_CASE("generated sets of every kind, at the radii where ties decide") {
  Random random(1);
  for (const NamedSet& set : generated_sets()) {
    CAPTURE(set.name);
    const Points points = set.make();
    for (const double alpha : set.alphas)
      if (std::isfinite(alpha)) check_cuts(points, alpha, 12, 1, 2, random);
  }
}

TEST_CASE("sets that are hard for tiles") {
  Random random(2);
  for (const TileSet& set : tile_sets()) {
    CAPTURE(set.name);
    for (const double alpha : {0.3, 0.75, 1.0, 3.0, 40.0}) check_cuts(set.points, alpha, 9, 1, 2, random);
  }
}

TEST_CASE("a few points of any kind, and borders through most of them") {
  Random random(3);
  for (int run = 0; run < 1500; ++run) {
    const TileSet set = few_points(random);
    CAPTURE(set.name);
    const double alpha = std::ldexp(random.between(0.5, 1), random.integer(-3, 5));
    check_cuts(set.points, alpha, 8, 1, 2, random);
  }
}

TEST_CASE("pinches, chains of holes and islands: random pictures") {
  Random random(4);
  for (int run = 0; run < 250; ++run) {
    const Picture picture = random_picture(10, 10, random.between(0.2, 0.9), random);
    check_cuts(points_of(picture), picture_alpha, 10, 1, 3, random);
  }
}

TEST_SUITE_END();
