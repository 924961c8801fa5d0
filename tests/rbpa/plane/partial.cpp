// Regions cut in any way and merged in any order give the whole.
#include "rbpa/plane/partial.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "plane/partial/cuts.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/partial_bytes.h"
#include "support/arguments.h"
#include "support/data_folder.h"
#include "support/generate.h"
#include "support/pictures.h"
#include "support/read_points.h"
#include "support/sets.h"
#include "support/shrink.h"
#include "support/spacing.h"
#include "support/tile_sets.h"

using namespace rbpa_test;
using rbpa::Partial;
using rbpa::Point;
using rbpa::Region;

TEST_SUITE_BEGIN("partial");

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Checks that triangles and isolated points of all regions are those of the whole.
std::string wrong_with_items(const Points& points, double alpha, const Regions& regions) {
  const rbpa::AlphaComplex expected = rbpa::alpha_complex(points, alpha, {.threads = 1});
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

/// Returns "" when merging the regions in several orders gives the whole, and always the same bytes.
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

/// Cuts into about `regions` regions, and checks each cut; a failure is reduced to a small case.
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

TEST_CASE("merged regions are the whole on generated sets of every kind, also at radii where ties decide") {
  Random random(1);
  for (const NamedSet& set : generated_sets()) {
    CAPTURE(set.name);
    const Points points = set.make();
    std::vector<double> alphas = set.alphas;
    const double spacing = mean_spacing(points);
    alphas.insert(alphas.end(), {spacing / 2, spacing});
    for (const double alpha : alphas)
      if (alpha > 0 && std::isfinite(alpha)) check_cuts(points, alpha, 12, 1, 2, random);
  }
}

TEST_CASE("merged regions are the whole on sets that are hard for tiles") {
  Random random(2);
  for (const TileSet& set : tile_sets()) {
    CAPTURE(set.name);
    for (const double alpha : {0.3, 0.75, 1.0, 3.0, 40.0}) check_cuts(set.points, alpha, 9, 1, 2, random);
  }
}

TEST_CASE("merged regions are the whole on few points of any kind, with borders through most of them") {
  Random random(3);
  for (int run = 0; run < trials(1500); ++run) {
    const TileSet set = few_points(random);
    CAPTURE(set.name);
    const double alpha = std::ldexp(random.between(0.5, 1), random.integer(-3, 5));
    check_cuts(set.points, alpha, 8, 1, 2, random);
  }
}

TEST_CASE("merged regions are the whole on random pictures with pinches, chains of holes and islands") {
  Random random(4);
  for (int run = 0; run < trials(250); ++run) {
    const Picture picture = random_picture(10, 10, random.between(0.2, 0.9), random);
    check_cuts(points_of(picture), picture_alpha, 10, 1, 3, random);
  }
}

TEST_CASE("merged regions are the whole with a ring around everything, and a hole that many regions see") {
  Random random(5);
  Points points;
  for (int x = -40; x <= 40; ++x)
    for (int y = -40; y <= 40; ++y)
      if (const int far = x * x + y * y;
          (far >= 36 * 36 && far <= 40 * 40) || (far >= 18 * 18 && far <= 20 * 20) || far < 9)
        points.push_back({double(x), double(y)});
  for (const std::size_t regions : {2U, 40U, 400U}) check_cuts(points, 0.8, regions, 4, 2, random);
}

TEST_CASE("merged regions are the whole at a radius larger than most regions") {
  Random random(6);
  const Points points = uniform(300, 8);
  for (const double alpha : {2.0, 6.0, 50.0}) check_cuts(points, alpha, 150, 3, 2, random);
}

TEST_CASE("merged regions are the whole with one dense cell and much empty land") {
  Random random(7);
  Points points = uniform(1500, 9);
  for (Point& p : points) p = {p.x * 0x1p-10, p.y * 0x1p-10};
  for (int i = 0; i < 60; ++i) points.push_back({random.between(-50, 50), random.between(-50, 50)});
  for (const double alpha : {0.0008, 0.02, 9.0}) check_cuts(points, alpha, 30, 3, 2, random);
}

TEST_CASE("merged regions are the whole with duplicates, on lattices whose lines are borders") {
  Random random(8);
  for (int run = 0; run < 60; ++run) {
    const Points points = random_grid(8, 90, true, random.bits());
    for (const double alpha : {0.75, 1.0, 1.25, 2.5}) check_cuts(points, alpha, 12, 1, 2, random);
  }
  check_cuts(duplicates(200, 5, 1), 0.3, 12, 5, 2, random);
}

TEST_CASE("merged regions are the whole at the limits of double, with halos beyond them") {
  Random random(9);
  const double most = std::numeric_limits<double>::max();
  const Points points{{-most, -most}, {most, -most}, {0, most},   {most, most},
                      {0, 0},         {-0.0, 0.0},   {5e-324, 0}, {0, 5e-324}};
  for (const double alpha : {5e-324, 1e-300, 1.0, 1e307, most}) check_cuts(points, alpha, 6, 30, 2, random);
}

TEST_CASE("merged regions are the whole on real data, cut at random") {
  Random random(10);
  std::size_t sets = 0;
  for (const PointFile& file : point_files(bundled_data())) {
    const Points points = read_points(file);
    if (points.size() > 5000) continue;
    ++sets;
    CAPTURE(file.name);
    for (const double spacings : {0.5, 1.0, 2.0}) check_cuts(points, spacings * mean_spacing(points), 16, 1, 2, random);
  }
  CHECK(sets >= 20);
}

TEST_CASE("how all further data is cut at random" * doctest::skip()) {
  Random random(11);
  std::vector<PointFile> files = point_files(bundled_data());
  const std::vector<PointFile> further = point_files(further_data());
  files.insert(files.end(), further.begin(), further.end());
  for (const PointFile& file : files) {
    const Points points = read_points(file);
    CAPTURE(file.name);
    for (const double spacings : {0.3, 0.6, 1.0, 2.0, 5.0})
      check_cuts(points, spacings * mean_spacing(points), 60, 2, 3, random);
  }
}

TEST_CASE("how thousands of random sets and cuts are merged to the whole" * doctest::skip()) {
  Random random(12);
  for (int run = 0; run < trials(20'000); ++run) {
    const TileSet set = few_points(random);
    CAPTURE(set.name);
    check_cuts(set.points, std::ldexp(random.between(0.5, 1), random.integer(-4, 6)), 12, 1, 3, random);
    const Points pixels = points_of(random_picture(14, 14, random.between(0.2, 0.9), random));
    check_cuts(pixels, picture_alpha, 20, 1, 3, random);
  }
}

TEST_SUITE_END();
