#include "rbpa/seed/roll.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "support/generate.h"
#include "support/samples.h"

using namespace rbpa_test;
using rbpa::Point;
using rbpa::PointGrid;
using rbpa::Roll;

TEST_SUITE_BEGIN("seed");

namespace {

using Site = std::uint32_t;
using Float = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>, boost::multiprecision::et_off>;

const Float& two_pi() {
  static const Float value = boost::math::constants::two_pi<Float>();
  return value;
}
const Float tolerance = Float(1e-20) * Float(1e-20);  // what is nearer than this is a tie

Float turn(Float angle) {  // into [0, 2π)
  angle -= two_pi() * floor(angle / two_pi());
  return angle > two_pi() - tolerance ? Float(0) : angle;
}

/// The ball touches or contains a point while the direction from v to its centre is between two angles.
struct Contact {
  Site site;
  Float direction, half_width;
  Float start() const { return direction - half_width; }
  Float end() const { return direction + half_width; }
};

/// Everything that the ball can touch when it turns around v.
std::vector<Contact> all_contacts(const std::vector<Point>& points, double alpha, Site v) {
  std::vector<Contact> result;
  for (Site q = 0; q < points.size(); ++q) {
    if (q == v) continue;
    const Float x = Float(points[q].x) - points[v].x, y = Float(points[q].y) - points[v].y;
    const Float cosine = sqrt(x * x + y * y) / (2 * Float(alpha));
    if (cosine > 1 + tolerance) continue;
    result.push_back({q, atan2(y, x), cosine >= 1 ? Float(0) : Float(acos(cosine))});
  }
  return result;
}

/// How far after `from` is `at`, in [0, 2π).
Float after(const Float& from, const Float& at) { return turn(at - from); }

/// −1 as the angle is strictly inside the contact, 0 at one of its ends, 1 outside.
int outside(const Contact& c, const Float& angle) {
  const Float since = after(c.start(), angle), width = 2 * c.half_width;
  if (since < tolerance || abs(since - width) < tolerance || since > two_pi() - tolerance) return 0;
  return since < width ? -1 : 1;
}

bool touches_nothing_inside(const std::vector<Contact>& all, const Float& angle) {
  return std::none_of(all.begin(), all.end(), [&](const Contact& c) { return outside(c, angle) < 0; });
}

bool rests_on_one(const std::vector<Contact>& all, const Contact& one, const Float& angle) {
  return std::all_of(all.begin(), all.end(), [&](const Contact& c) { return c.site == one.site || outside(c, angle) > 0; });
}

std::string text(const std::vector<Site>& sites) {
  std::string result;
  for (const Site s : sites) result += std::to_string(s) + " ";
  return result;
}

struct Statistics {
  int rolls = 0, contacts = 0, ties = 0;
};

/// One roll against the slow reference.
template <typename Real>
void check_roll(const PointGrid<Real>& grid, double alpha, Site v, const Contact& from, const Contact& until,
                const std::vector<Contact>& all, Statistics& statistics) {
  const Float begin = from.end();
  const bool all_round = from.site == until.site;
  const Float whole = all_round ? two_pi() : after(begin, until.start());
  struct Arrival {
    Float when, direction;
    Site site;
    bool alone;  // the ball rested on v alone before
  };
  std::vector<Arrival> expected;
  bool tie = false;
  for (const Contact& c : all) {
    if (c.site == from.site) continue;
    const Float when = after(begin, c.start());
    if (when > whole + tolerance || !touches_nothing_inside(all, c.start())) continue;
    bool alone = true;
    for (const Contact& other : all) {
      if (other.site == c.site || outside(other, c.start()) != 0) continue;
      tie = true;
      const bool leaves_now = after(other.start(), c.start()) > tolerance;
      const bool lies_before = !leaves_now && after(begin, other.direction) < after(begin, c.direction);
      if (leaves_now || lies_before) alone = false;
    }
    expected.push_back({when, c.direction, c.site, alone});
  }
  std::sort(expected.begin(), expected.end(), [&](const Arrival& p, const Arrival& q) {
    return abs(p.when - q.when) > tolerance ? p.when < q.when : after(begin, p.direction) < after(begin, q.direction);
  });
  std::vector<Site> exposed, alone;
  for (const Arrival& a : expected) {
    exposed.push_back(a.site);
    if (a.alone) alone.push_back(a.site);
    if (a.site == until.site) break;
  }
  std::vector<Site> found = Roll<Real>(grid, alpha, v, from.site, until.site).contacts();
  if (all_round) {
    // What is met after the ball has come back to `from` costs a search in vain, and no more.
    const Float back = two_pi() - 2 * from.half_width;
    std::erase_if(found, [&](Site s) {
      const auto contact = std::find_if(all.begin(), all.end(), [&](const Contact& c) { return c.site == s; });
      return contact != all.end() && after(begin, contact->start()) > back + tolerance;
    });
  }
  ++statistics.rolls;
  statistics.contacts += static_cast<int>(found.size());
  statistics.ties += tie;
  CAPTURE(until.site);
  CAPTURE(text(found));
  CAPTURE(text(exposed));
  CAPTURE(text(alone));
  if (!tie) {
    CHECK(found == exposed);
    return;
  }
  // With ties, at least where a chain begins, and at most where the ball can rest, in order.
  const auto is_part = [](const std::vector<Site>& part, const std::vector<Site>& whole_list) {
    std::size_t at = 0;
    for (const Site s : whole_list) at += at < part.size() && part[at] == s;
    return at == part.size();
  };
  CHECK(is_part(alone, found));
  CHECK(is_part(found, exposed));
}

/// met_before() orders by the start of the contact after the roll began, then by direction.
template <typename Real>
void check_order(const PointGrid<Real>& grid, double alpha, Site v, const Contact& from,
                 const std::vector<Contact>& all) {
  const Float begin = from.end();
  const Roll<Real> roll(grid, alpha, v, from.site, from.site);
  std::vector<const Contact*> valid;
  for (const Contact& c : all) {
    if (c.site == from.site) continue;
    const Float when = after(begin, c.start());
    // Those already left when the roll begins lie past the direction of `from`.
    if (when + c.half_width > two_pi() - from.half_width - tolerance) continue;
    valid.push_back(&c);
  }
  for (const Contact* p : valid)
    for (const Contact* q : valid) {
      const Float p_when = after(begin, p->start()), q_when = after(begin, q->start());
      const bool tie = abs(p_when - q_when) < tolerance;
      const bool expected = p->site != q->site &&
                            (tie ? after(begin, p->direction) < after(begin, q->direction) : p_when < q_when);
      CHECK(roll.met_before(p->site, q->site) == expected);
    }
}

template <typename Real>
Statistics check_set(const Points& input, double alpha) {
  CAPTURE(alpha);
  const PointGrid<Real> grid(input);
  const auto count = static_cast<std::ptrdiff_t>(grid.input_index().size());
  const std::vector<Point> points(grid.points().begin(), grid.points().begin() + count);
  Statistics statistics;
  for (Site v = 0; v < points.size(); ++v) {
    const std::vector<Contact> all = all_contacts(points, alpha, v);
    for (const Contact& from : all) {
      // The roll begins where the ball, resting on v and `from` only, lets go of `from`, and ends where it comes to
      // rest on v and `until` only: where another point is touched too, a front that ran dry has no end of a fan.
      if (!rests_on_one(all, from, from.end())) continue;
      CAPTURE(v);
      CAPTURE(from.site);
      check_order(grid, alpha, v, from, all);
      check_roll(grid, alpha, v, from, from, all, statistics);
      for (const Contact& until : all)
        if (until.site != from.site && rests_on_one(all, until, until.start()))
          check_roll(grid, alpha, v, from, until, all, statistics);
    }
  }
  return statistics;
}

}  // namespace

TEST_CASE_TEMPLATE("the ball meets what sorting the angles of its contacts says", Real, double, long double) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u})
    for (const double alpha : {0.45, 0.8, 2.5}) {
      const Statistics s = check_set<Real>(uniform(14, seed), alpha);
      CHECK(s.rolls > 0);
    }
  CHECK(check_set<Real>(clusters(2, 1), 0.02).rolls > 0);
  CHECK(check_set<Real>(moved(scaled(uniform(14, 7), -10), 1e6, -1e6), 0.0011).rolls > 0);
  CHECK(check_set<Real>(along_curves(8), 0.7).rolls > 0);
}

TEST_CASE("contacts at once and in a row are kept in order") {
  int ties = 0;
  ties += check_set<double>(perfect_grid(4, 1), 0.5).ties;
  ties += check_set<double>(perfect_grid(3, 2), 1.25).ties;
  ties += check_set<double>(rectangles_of_circumradius_5(3), 5).ties;
  ties += check_set<double>(integer_circle(65), 65).ties;
  ties += check_set<double>(pairs_at_distance_2(4, 1), 1).ties;
  ties += check_set<double>({{-6, 0}, {-5, 0}, {5, 0}, {4, 3}, {3, 4}, {0, 5}}, 5).ties;
  ties += check_set<double>({{0, -6}, {0, -5}, {0, 5}, {-3, 4}, {-4, 3}, {-5, 0}}, 5).ties;
  Random random(71);
  for (int trial = 0; trial < 60; ++trial) {
    Points points(7);
    fill(points, Kind::small_grid, random);
    ties += check_set<double>(points, random.chance(0.5) ? 1 : random.chance(0.5) ? 0.5 : 2.5).ties;
  }
  CHECK(ties > 50);
}

TEST_SUITE_END();
