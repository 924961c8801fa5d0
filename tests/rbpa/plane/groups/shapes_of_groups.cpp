#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/plane/choose_alpha.h"
#include "rbpa/plane/filtration.h"
#include "rbpa/plane/groups.h"
#include "rbpa/plane/plateaus.h"
#include "support/arguments.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/random.h"
#include "support/sets.h"
#include "support/spacing.h"

using namespace rbpa_test;
using rbpa::AlphaComplex;
using rbpa::AlphaRule;
using rbpa::GroupProblem;
using rbpa::Groups;
using rbpa::GroupShapes;
using rbpa::Polygon;
using rbpa::Triangle;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Every generated set of moderate size as a group; a fifth of all points are in no group. The points of the groups
/// alternate.
struct MixedSets {
  Points points;
  std::vector<std::uint32_t> labels;
  std::size_t count = 0;

  explicit MixedSets(std::size_t most, Random& random) {
    for (const NamedSet& set : generated_sets()) {
      Points some = set.first(most);
      points.insert(points.end(), some.begin(), some.end());
      labels.insert(labels.end(), some.size(), static_cast<std::uint32_t>(count++));
    }
    std::vector<std::uint32_t> order(points.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    random.shuffle(order);
    const Points as_made = points;
    const std::vector<std::uint32_t> of = labels;
    for (std::size_t i = 0; i < order.size(); ++i) {
      points[i] = as_made[order[i]];
      labels[i] = random.chance(0.2) ? rbpa::no_group : of[order[i]];
    }
  }
};

/// The result of a call for one group alone.
struct Alone {
  double alpha = none;
  std::vector<Polygon> polygons;
  std::vector<Triangle> triangles;
};

Alone alone(const Points& points, std::span<const std::uint32_t> members, const rbpa::GroupAlpha& alpha, double given) {
  Points of;
  for (const std::uint32_t i : members) of.push_back(points[i]);
  Alone found;
  found.alpha = given;
  if (std::isnan(given)) {
    const AlphaComplex all = rbpa::alpha_complex(of, infinity, {.neighbors = true});
    const rbpa::Filtration steps = rbpa::filtration(all, of);
    if (alpha.choice.rule != AlphaRule::plateau)
      found.alpha = rbpa::smallest_covering(all, steps, rbpa::covering_of(alpha.choice)).value_or(none);
    else if (const auto plateaus = rbpa::plateaus(all, of, steps); !plateaus.empty())
      found.alpha = plateaus[std::min(alpha.choice.rank, plateaus.size()) - 1].alpha;
  }
  if (std::isnan(found.alpha)) return found;
  const AlphaComplex complex = rbpa::alpha_complex(of, found.alpha, {.neighbors = true});
  found.polygons = rbpa::outline_polygons(of, complex);
  found.triangles = complex.triangles;
  for (Triangle& t : found.triangles)
    for (std::uint32_t& corner : t) corner = members[corner];
  for (Polygon& polygon : found.polygons) {
    for (std::uint32_t& i : polygon.shell.points) i = members[i];
    for (rbpa::Ring& hole : polygon.holes)
      for (std::uint32_t& i : hole.points) i = members[i];
  }
  return found;
}

/// Returns the bits of a double, as NaN is not equal to itself.
std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

bool are_equal(const GroupShapes& a, const GroupShapes& b) {
  const auto totals = [](const rbpa::PolygonTotals& s, const rbpa::PolygonTotals& t) {
    return s.holes == t.holes && bits(s.area) == bits(t.area) && bits(s.perimeter) == bits(t.perimeter);
  };
  return std::equal(a.alphas.begin(), a.alphas.end(), b.alphas.begin(), b.alphas.end(),
                    [](double s, double t) { return s == t || (std::isnan(s) && std::isnan(t)); }) &&
         a.polygons == b.polygons && a.polygon_begin == b.polygon_begin && a.triangle_begin == b.triangle_begin &&
         a.triangles == b.triangles && a.problems == b.problems &&
         std::equal(a.totals.begin(), a.totals.end(), b.totals.begin(), b.totals.end(), totals);
}

void check_as_alone(const Points& points, const Groups& groups, const rbpa::GroupAlpha& alpha) {
  const GroupShapes found = rbpa::shapes_of_groups(points, groups, alpha, {{.threads = 2}, {}, true});
  REQUIRE(found.alphas.size() == groups.size());
  REQUIRE(found.totals.size() == groups.size());
  REQUIRE(found.polygon_begin.size() == groups.size() + 1);
  REQUIRE(found.triangle_begin.size() == groups.size() + 1);
  CHECK(found.polygon_begin.back() == found.polygons.size());
  CHECK(found.triangle_begin.back() == found.triangles.size());
  std::size_t problems = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    CAPTURE(g);
    const double for_all = alpha.choice.rule == AlphaRule::given ? alpha.choice.radius : none;
    const double given = alpha.given.empty() ? for_all : alpha.given[alpha.given.size() == 1 ? 0 : g];
    const Alone expected = alone(points, groups[g], alpha, given);
    CHECK((found.alphas[g] == expected.alpha || (std::isnan(found.alphas[g]) && std::isnan(expected.alpha))));
    const auto polygon = [&](std::size_t at) { return found.polygons.begin() + static_cast<std::ptrdiff_t>(at); };
    CHECK(std::vector(polygon(found.polygon_begin[g]), polygon(found.polygon_begin[g + 1])) == expected.polygons);
    const auto triangle = [&](std::size_t at) { return found.triangles.begin() + static_cast<std::ptrdiff_t>(at); };
    CHECK(std::vector(triangle(found.triangle_begin[g]), triangle(found.triangle_begin[g + 1])) == expected.triangles);
    CHECK(bits(found.totals[g].area) == bits(rbpa::total(expected.polygons).area));
    if (expected.polygons.empty()) {
      REQUIRE(problems < found.problems.size());
      CHECK(found.problems[problems++].group == g);
    }
  }
  CHECK(problems == found.problems.size());
  for (const unsigned threads : {1U, 0U})
    CHECK(are_equal(rbpa::shapes_of_groups(points, groups, alpha, {{.threads = threads}, {}, true}), found));
}

Groups in_turn(const std::vector<Points>& sets, Points& points) {
  std::vector<std::uint32_t> labels;
  for (const Points& set : sets) {
    points.insert(points.end(), set.begin(), set.end());
    labels.insert(labels.end(), set.size(), static_cast<std::uint32_t>(&set - sets.data()));
  }
  return rbpa::groups_of(labels, sets.size());
}

std::string refusal(const Points& points, const Groups& groups, const rbpa::GroupAlpha& alpha = {}) try {
  rbpa::shapes_of_groups(points, groups, alpha);
  return "";
} catch (const rbpa::InvalidInput& error) {
  return error.what();
}

}  // namespace

TEST_SUITE_BEGIN("groups");

TEST_CASE("each group has the result of a call with its points alone, by every rule, with any number of threads") {
  Random random(5);
  const MixedSets sets(all_trials() ? 400 : 120, random);
  const Groups groups = rbpa::groups_of(sets.labels, sets.count);
  const double one[] = {1.0}, all[] = {infinity};
  check_as_alone(sets.points, groups, {.given = one});
  check_as_alone(sets.points, groups, {.given = all});
  check_as_alone(sets.points, groups, {});
  check_as_alone(sets.points, groups, {.choice = {.radius = 1}});
  check_as_alone(sets.points, groups, {.choice = {.rule = AlphaRule::least, .cover = 0.9}});
  check_as_alone(sets.points, groups, {.choice = {.rule = AlphaRule::plateau}});
  check_as_alone(sets.points, groups, {.choice = {.rule = AlphaRule::plateau, .rank = 2}});
  std::vector<double> each;
  for (std::size_t g = 0; g < groups.size(); ++g)
    each.push_back(random.chance(0.2) ? infinity : std::ldexp(1.0, random.integer(-3, 6)));
  check_as_alone(sets.points, groups, {.given = each});
}

TEST_CASE("thousands of small groups and a large one among them have the right shapes") {
  Random random(6);
  const Points points = uniform(60000, 9);
  std::vector<std::uint32_t> labels;
  for (std::size_t i = 0; i < points.size(); ++i)
    labels.push_back(random.chance(0.6) ? 777 : static_cast<std::uint32_t>(random.below(3000)));
  const Groups groups = rbpa::groups_of(labels, 3000);
  const double alpha[] = {60.0};
  check_as_alone(points, groups, {.given = alpha});
}

TEST_CASE("a problem is reported for its group, and the other groups have their shapes") {
  Points points;
  const Groups groups = in_turn({{{0, 0}, {1, 0}, {0, 1}},
                                 {},
                                 {{4, 4}},
                                 {{4, 4}, {5, 5}, {4, 4}},
                                 {{0, 0}, {1, 1}, {2, 2}, {3, 3}},
                                 {{0, 0}, {none, 1}, {2, 2}},
                                 {{0, 0}, {9, 0}, {0, 9}},
                                 {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
                                points);
  const double alpha[] = {1.0};
  const GroupShapes found = rbpa::shapes_of_groups(points, groups, {.given = alpha});
  CHECK(found.problems == std::vector<GroupProblem>{{1, "no points"},
                                                    {2, "fewer than three distinct points (1)"},
                                                    {3, "fewer than three distinct points (2)"},
                                                    {4, "all points are collinear"},
                                                    {5, "point 12 is (nan, 1), expected finite coordinates"},
                                                    {6, "no triangle has circumradius <= 1"}});
  CHECK(found.polygon_begin == std::vector<std::uint64_t>{0, 1, 1, 1, 1, 1, 1, 1, 2});
  CHECK(found.totals.front().area == 0.5);
  CHECK(found.totals.back().area == 1);
  CHECK(found.triangles.empty());
  CHECK(found.triangle_begin == std::vector<std::uint64_t>{0, 1, 1, 1, 1, 1, 1, 1, 3});

  // A radius is chosen for every group that has a triangle.
  const GroupShapes chosen = rbpa::shapes_of_groups(points, groups, {});
  std::vector<std::size_t> without;
  for (const GroupProblem& problem : chosen.problems) without.push_back(problem.group);
  CHECK(without == std::vector<std::size_t>{1, 2, 3, 4, 5});
  CHECK(std::isnan(chosen.alphas[4]));
  CHECK(chosen.alphas[7] == std::sqrt(0.5));

  const std::vector<double> each = {1, 1, 1, 1, 1, 1, 7, -1};
  const GroupShapes given = rbpa::shapes_of_groups(points, groups, {.given = each});
  CHECK(given.problems.back() == GroupProblem{7, "alpha is -1, expected a radius above 0, or infinity"});
  CHECK(given.polygon_begin[7] - given.polygon_begin[6] == 1);

  rbpa::GroupShapesOptions least;
  least.filter.min_part_area = 0.75;
  const GroupShapes large = rbpa::shapes_of_groups(points, groups, {.given = alpha}, least);
  CHECK(large.problems.front() == GroupProblem{0, "no part has an area >= 0.75"});
  CHECK(large.polygons.size() == 1);
}

TEST_CASE("wrong labels, offsets, members and radii are refused") {
  const Points points = {{0, 0}, {1, 0}, {0, 1}};
  const std::vector<std::uint32_t> labels = {0, 5, 1};
  CHECK_THROWS_WITH_AS(rbpa::groups_of(labels, 2), "point 1 has label 5, expected one of 2 groups, numbered from 0",
                       rbpa::InvalidInput);
  CHECK(rbpa::groups_of({}, 0).size() == 0);
  CHECK(refusal(points, {{0, 2}, {0, 1, 2}}) == "groups: the last offset is 2, expected 3, the number of members");
  CHECK(refusal(points, {{1, 3}, {0, 1, 2}}) ==
        "groups: the first offset is not 0, expected offsets from 0 to the number of members");
  CHECK(refusal(points, {{0, 3, 2, 3}, {0, 1, 2}}) ==
        "groups: offset 2 is less than the one before, expected ascending offsets");
  CHECK(refusal(points, {{0, 9, 3}, {0, 1, 2}}) == "groups: offset 1 is 9, expected at most 3, the number of members");
  CHECK(refusal(points, {{0, 3}, {0, 1, 3}}) ==
        "groups: found member 3 in group 0, expected indices of points, below 3 and ascending");
  CHECK(refusal(points, {{0, 3}, {0, 2, 1}}).starts_with("groups: found member 1 in group 0"));
  const double two[] = {1, 2}, zero[] = {0};
  CHECK(refusal(points, {{0, 1, 2, 3}, {0, 1, 2}}, {.given = two}) ==
        "alpha: found 2 radii for 3 groups, expected as many, or one for all");
  CHECK(rbpa::shapes_of_groups(points, {{0, 3}, {0, 1, 2}}, {.given = {&none, 1}}).problems.size() == 1);
  for (const rbpa::GroupAlpha& alpha : {rbpa::GroupAlpha{.given = zero}, {.choice = {.radius = 0}}})
    CHECK(refusal(points, {{0, 3}, {0, 1, 2}}, alpha) == "alpha is 0, expected a radius above 0, or infinity");
}

TEST_CASE("every group is visited once, with its points; an exception or cancelling ends the run") {
  const Points points = uniform(30000, 3);
  Random random(4);
  std::vector<std::uint32_t> labels;
  for (std::size_t i = 0; i < points.size(); ++i)
    labels.push_back(random.chance(0.1) ? rbpa::no_group : static_cast<std::uint32_t>(random.below(500)));
  const Groups groups = rbpa::groups_of(labels, 501);
  for (const unsigned threads : {1U, 2U}) {
    std::mutex mutex;
    std::multiset<std::size_t> seen;
    std::vector<std::size_t> dones;
    rbpa::for_each_group(points, groups,
                         [&](const rbpa::Group& group) {
                           bool is_right = group.points.size() == group.members.size();
                           for (std::size_t k = 0; is_right && k < group.members.size(); ++k)
                             is_right = points[group.members[k]] == group.points[k] &&
                                        labels[group.members[k]] == group.number;
                           const std::lock_guard lock(mutex);
                           REQUIRE(is_right);
                           seen.insert(group.number);
                         },
                         {.threads = threads, .go_on = [&](std::size_t done) {
                            dones.push_back(done);
                            return true;
                          }});
    CHECK(seen.size() == 501);
    CHECK(std::set(seen.begin(), seen.end()).size() == 501);
    CHECK(std::is_sorted(dones.begin(), dones.end()));
    CHECK(dones.back() == 501);
    const auto stop = [](std::size_t done) { return done < 100; };
    const double alpha[] = {30.0};
    CHECK_THROWS_AS(
        rbpa::for_each_group(points, groups, [](const rbpa::Group&) {}, {.threads = threads, .go_on = stop}),
        rbpa::Cancelled);
    CHECK_THROWS_AS(
        rbpa::shapes_of_groups(points, groups, {.given = alpha}, {{.threads = threads, .go_on = stop}, {}, false}),
        rbpa::Cancelled);
    CHECK_THROWS_AS(rbpa::for_each_group(points, groups,
                                         [](const rbpa::Group& group) {
                                           if (group.number == 300) throw std::runtime_error("no more");
                                         },
                                         {.threads = threads}),
                    std::runtime_error);
  }
}

TEST_CASE("a rule for groups with no component or rank 0 is refused") {
  const Points points = uniform(50, 5);
  const Groups groups = rbpa::groups_of(std::vector<std::uint32_t>(points.size(), 0), 1);
  for (const rbpa::AlphaChoice& choice : {rbpa::AlphaChoice{.rule = AlphaRule::plateau, .rank = 0},
                                          rbpa::AlphaChoice{.rule = AlphaRule::automatic, .max_components = 0}})
    CHECK_THROWS_AS(rbpa::shapes_of_groups(points, groups, {.choice = choice}), rbpa::InvalidInput);
}

TEST_CASE("work on a large group can be cancelled, by every rule") {
  const Points points = uniform(120000, 5);
  const Groups groups = rbpa::groups_of(std::vector<std::uint32_t>(points.size(), 1), 3);
  const double one[] = {60.0}, tiny[] = {1e-9};  // it has no polygons
  for (const rbpa::GroupAlpha& alpha :
       {rbpa::GroupAlpha{.given = one}, {.given = tiny}, {}, {.choice = {.rule = AlphaRule::plateau}}})
    for (const unsigned threads : {1U, 2U}) {
      std::size_t calls = 0;
      const auto first_group = [&](std::size_t done) {
        CHECK(done == 1);  // the one before, which is empty
        return ++calls < 3;
      };
      CHECK_THROWS_AS(
          rbpa::shapes_of_groups(points, groups, alpha, {{.threads = threads, .go_on = first_group}, {}, false}),
          rbpa::Cancelled);
      CHECK(calls == 3);
    }
}

TEST_SUITE_END();
