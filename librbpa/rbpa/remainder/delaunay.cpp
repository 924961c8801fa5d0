#include "rbpa/remainder/delaunay.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "rbpa/predicate/predicates.h"
#include "rbpa/remainder/sides.h"

namespace rbpa {
namespace {

using P = Predicates<double>;
using Side = Sides::Side;
using Corner = Sides::Corner;

constexpr std::size_t few = 16;  ///< points, which are cut along one axis only

/// A point, and its position in the input.
struct Place {
  Point at;
  std::uint32_t index;
};

/// The order along x is lexicographic; the one along y is the same after a quarter turn. Two sets of which one comes
/// before the other have a line between them.
struct AlongX {
  bool operator()(const Place& p, const Place& q) const {
    return (p.at.x < q.at.x) | ((p.at.x == q.at.x) & (p.at.y < q.at.y));
  }
};
struct AlongY {
  bool operator()(const Place& p, const Place& q) const {
    return (p.at.y < q.at.y) | ((p.at.y == q.at.y) & (p.at.x > q.at.x));
  }
};

/// Sorts a few points: by counting for each how many come before it, as no branch can be mispredicted then.
template <typename Order>
void sort_few(std::span<Place> places, Order before) {
  std::array<Place, few> sorted;
  for (const Place& p : places) {
    std::size_t rank = 0;
    for (const Place& q : places) rank += before(q, p);
    sorted[rank] = p;
  }
  std::copy_n(sorted.begin(), places.size(), places.begin());
}

/// The middle one of a few points, taken at distances.
template <typename Order>
Place middle_of_some(std::span<const Place> places, Order before) {
  constexpr std::size_t some = 5, many = 15;
  const std::size_t count = places.size() < 32 * some ? some : many;
  std::array<Place, many> sample;
  for (std::size_t i = 0; i < count; ++i) sample[i] = places[(2 * i + 1) * places.size() / (2 * count)];
  sort_few(std::span<Place>(sample.data(), count), before);
  return sample[count / 2];
}

/// Puts the points of one part before those of the other; returns where the second begins. Neither is less than an
/// eighth of all.
template <typename Order>
std::size_t cut(std::span<Place> places, Order before) {
  const std::size_t n = places.size();
  const Place pivot = middle_of_some(places, before);
  std::size_t m = 0;
  for (Place& p : places) {
    const Place moved = p;
    p = places[m];
    places[m] = moved;
    m += before(moved, pivot);
  }
  if (m >= n / 8 && n - m >= n / 8) return m;
  std::nth_element(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(n / 2), places.end(), before);
  return n / 2;
}

/// The edge above which a merge goes on, from its right end to its left one, and how points compete for it: of those
/// above, the one with the least circle has the least k = dot / cross, as in pivot/candidate.h.
class Base {
 public:
  Base(const Point& left, const Point& right) : a_(left), b_(right), ab_(P::from(left, right)) {}

  struct Candidate {
    Point at;
    double dot, cross, dot_size, cross_size;
  };
  Candidate candidate(const Point& p) const {
    const auto ap = P::from(a_, p), bp = P::from(b_, p);
    return {p, P::dot(ap, bp), P::cross(ab_, ap), P::dot_size(ap, bp), P::cross_size(ab_, ap)};
  }
  bool is_above(const Candidate& p) const {
    const double bound = 5 * P::unit * p.cross_size;
    if (p.cross > bound) return true;
    return p.cross >= -bound && P::orientation(a_, b_, p.at) > 0;
  }
  /// q is inside the circle through the edge and p. Requires p to be above, and q another point.
  bool is_inside(const Candidate& q, const Candidate& p) const {
    const double difference = p.dot * q.cross - q.dot * p.cross;
    const double bound = 16 * P::unit * (p.dot_size * q.cross_size + q.dot_size * p.cross_size);
    if (difference > bound) return true;
    return difference >= -bound && P::in_perturbed_circle(a_, b_, p.at, q.at) > 0;
  }

 private:
  Point a_, b_;
  P::Vector ab_;
};

class Triangulation {
 public:
  Triangulation(std::span<const Point> points, const std::function<void()>& working)
      : sides_(points.size()), hull_(points.size()), working_(working) {
    places_.reserve(points.size());
    for (const Point& p : points) places_.push_back({p, static_cast<std::uint32_t>(places_.size())});
  }

  void run(meshops::Patch& patch) {
    const Extremes extremes = triangulate(0, places_.size(), true);
    hand_over(extremes.first_x, patch);
  }

 private:
  /// Corners of a hull: the first and the last in either order.
  struct Extremes {
    Corner first_x, last_x, first_y, last_y;
  };

  Extremes triangulate(std::size_t first, std::size_t last, bool along_x) {
    const std::span<Place> places(places_.data() + first, last - first);
    if (places.size() <= few) {
      sort_few(places, AlongX());
      return triangulate_sorted(first, last);
    }
    const std::size_t middle = first + (along_x ? cut(places, AlongX()) : cut(places, AlongY()));
    const Extremes a = triangulate(first, middle, !along_x), b = triangulate(middle, last, !along_x);
    merge(along_x ? a.last_x : a.last_y, along_x ? b.first_x : b.first_y, static_cast<Corner>(middle));
    return {first_of<AlongX>(a.first_x, b.first_x), last_of<AlongX>(a.last_x, b.last_x),
            first_of<AlongY>(a.first_y, b.first_y), last_of<AlongY>(a.last_y, b.last_y)};
  }

  Extremes triangulate_sorted(std::size_t first, std::size_t last) {
    if (last - first <= 3) return triangulate_three(first, last);
    const std::size_t middle = (first + last) / 2;
    const Extremes a = triangulate_sorted(first, middle), b = triangulate_sorted(middle, last);
    merge(a.last_x, b.first_x, static_cast<Corner>(middle));
    return {a.first_x, b.last_x, first_of<AlongY>(a.first_y, b.first_y), last_of<AlongY>(a.last_y, b.last_y)};
  }

  template <typename Order>
  Corner first_of(Corner p, Corner q) const {
    return Order()(places_[p], places_[q]) ? p : q;
  }
  template <typename Order>
  Corner last_of(Corner p, Corner q) const {
    return Order()(places_[p], places_[q]) ? q : p;
  }

  /// Two or three points.
  Extremes triangulate_three(std::size_t first, std::size_t last) {
    const auto a = static_cast<Corner>(first), c = static_cast<Corner>(last - 1);
    Extremes extremes = {a, c, first_of<AlongY>(a, c), last_of<AlongY>(a, c)};
    if (last - first == 2) {
      hull_[a] = sides_.add(a, c);
      hull_[c] = Sides::reverse(hull_[a]);
      return extremes;
    }
    const Corner b = a + 1;
    extremes.first_y = first_of<AlongY>(extremes.first_y, b);
    extremes.last_y = last_of<AlongY>(extremes.last_y, b);
    const Side ab = sides_.add(a, b), bc = sides_.add(b, c);
    sides_.insert(bc, Sides::reverse(ab));
    const int turn = P::orientation(places_[a].at, places_[b].at, places_[c].at);
    hull_[a] = ab;
    hull_[b] = bc;
    hull_[c] = Sides::reverse(bc);
    if (turn == 0) return extremes;
    const Side ca = sides_.add_after(Sides::reverse(bc), ab);
    if (turn > 0) {
      hull_[c] = ca;
    } else {
      hull_[a] = Sides::reverse(ca);
      hull_[b] = Sides::reverse(ab);
    }
    return extremes;
  }

  /// Joins two triangulations with a line between them, which pass it at the given corners of their hulls. Seen along
  /// the line, with the first to the left, new edges come from below to above. Points from `middle` on are right.
  void merge(Corner left_corner, Corner right_corner, Corner middle) {
    const Side lowest = lower_tangent(left_corner, right_corner);
    hull_[sides_.to(lowest)] = Sides::reverse(lowest);
    Side edge = lowest;
    for (;;) {
      if (++steps_ % steps_at_once == 0) working_();
      const Base base(at(sides_.to(edge)), at(sides_.from(edge)));
      // The first edge above at either end, and whatever it cuts off.
      Side left = sides_.ccw(Sides::reverse(edge)), right = sides_.cw(edge);
      auto of_left = base.candidate(at(sides_.to(left))), of_right = base.candidate(at(sides_.to(right)));
      const bool is_left = base.is_above(of_left), is_right = base.is_above(of_right);
      if (!is_left && !is_right) break;
      if (is_left)
        for (;;) {
          const Side next = sides_.ccw(left);
          const Corner beyond = sides_.to(next);
          if (beyond >= middle) break;
          const auto of_next = base.candidate(at(beyond));
          if (!base.is_inside(of_next, of_left)) break;
          sides_.remove(left);
          left = next;
          of_left = of_next;
        }
      if (is_right)
        for (;;) {
          const Side next = sides_.cw(right);
          const Corner beyond = sides_.to(next);
          if (beyond < middle) break;
          const auto of_next = base.candidate(at(beyond));
          if (!base.is_inside(of_next, of_right)) break;
          sides_.remove(right);
          right = next;
          of_right = of_next;
        }
      edge = !is_left || (is_right && base.is_inside(of_right, of_left))
                 ? sides_.add_after(sides_.along_left(right), Sides::reverse(edge))
                 : sides_.add_after(sides_.cw(edge), Sides::reverse(left));
    }
    hull_[sides_.from(edge)] = edge;
  }

  /// The edge below both hulls, from right to left.
  Side lower_tangent(Corner left_corner, Corner right_corner) {
    Side left = sides_.cw(hull_[left_corner]), right = hull_[right_corner];
    for (;;) {
      const Point &l = at(sides_.from(left)), &r = at(sides_.from(right));
      if (P::orientation(l, at(sides_.to(left)), r) > 0)
        left = sides_.along_left(left);
      else if (P::orientation(r, at(sides_.to(right)), l) < 0)
        right = sides_.along_right(right);
      else
        return sides_.add_after(sides_.cw(right), left);
    }
  }

  void hand_over(Corner on_hull, meshops::Patch& patch) const {
    std::vector<int> number(sides_.size(), meshops::Patch::open);  // of each side of a triangle, in the patch
    std::vector<bool> is_outer(sides_.size(), false);
    std::size_t sides = 2 * sides_.edges();
    const Side first = Sides::reverse(hull_[on_hull]);
    Side outer = first;
    do {
      is_outer[outer] = true;
      --sides;
      outer = sides_.along_left(outer);
    } while (outer != first);
    patch.triangles.resize(sides / 3);
    patch.across.resize(sides / 3);
    // Each loop reads in order what the next address depends on, so that no load waits for another.
    int next = 0;
    for (Side s = 0; s < sides_.size(); ++s) {
      if (!sides_.is_used(s)) continue;
      const Side t = sides_.along_left(s);
      if (t < s || is_outer[s]) continue;
      const Side u = sides_.along_left(t);
      if (u < s) continue;
      auto& corners = patch.triangles[static_cast<std::size_t>(next) / 3];
      for (std::size_t i = 0; const Side side : {s, t, u}) {
        corners[i++] = static_cast<meshops::Site>(places_[sides_.from(side)].index);
        number[side] = next++;
      }
    }
    for (Side s = 0; s < sides_.size(); ++s)
      if (number[s] >= 0)
        patch.across[static_cast<std::size_t>(number[s]) / 3][static_cast<std::size_t>(number[s]) % 3] =
            number[Sides::reverse(s)];
  }

  const Point& at(Corner c) const { return places_[c].at; }

  static constexpr std::size_t steps_at_once = 4096;
  std::vector<Place> places_;
  Sides sides_;
  std::vector<Side> hull_;  // of a corner that is extreme, the side of the hull that leaves it counter-clockwise
  const std::function<void()>& working_;
  std::size_t steps_ = 0;
};

}  // namespace

void delaunay(std::span<const Point> points, meshops::Patch& patch, const std::function<void()>& working) {
  patch.clear();
  if (points.size() < 3) return;
  Triangulation(points, working).run(patch);
}

}  // namespace rbpa
