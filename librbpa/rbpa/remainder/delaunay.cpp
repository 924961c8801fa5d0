#include "rbpa/remainder/delaunay.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <mutex>
#include <vector>

#include "rbpa/parallel/in_order.h"
#include "rbpa/predicate/chord.h"
#include "rbpa/remainder/sides.h"

namespace rbpa {
namespace {

using Side = Sides::Side;
using Corner = Sides::Corner;

/// Calls working() once in many steps, in one thread at a time; none is called after one that has thrown.
class Steps {
 public:
  explicit Steps(const std::function<void()>& working) : working_(working) {}

  void step(std::size_t& taken) {
    if (++taken < at_once) return;
    taken -= at_once;
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
    try {
      working_();
    } catch (...) {
      failure_ = std::current_exception();
      throw;
    }
  }

 private:
  static constexpr std::size_t at_once = 4096;
  const std::function<void()>& working_;
  std::exception_ptr failure_;
  std::mutex mutex_;
};

template <typename Real>
class Triangulation {
  using P = Predicates<Real>;

 public:
  Triangulation(std::span<Place> places, Threads& threads, const std::function<void()>& working)
      : places_(places), sides_(places.size()), hull_(places.size()), threads_(threads), steps_(working) {}

  void run(const Fate& fate, meshops::Patch& patch, meshops::Outline& outline) {
    const Part all = triangulate(0, places_.size());
    hand_over(all.first_x, fate, patch, outline);
  }

 private:
  /// Corners of a hull: the first and the last in either order.
  struct Extremes {
    Corner first_x, last_x, first_y, last_y;
  };
  /// What a part of the points has for itself, so that another thread can work on another part.
  struct Own {
    Sides::Unused unused;
    std::size_t steps;  // since the last time that `working` was called
  };
  struct Part : Extremes, Own {};

  Part triangulate(std::size_t first, std::size_t last) {
    const std::span<Place> places = places_.subspan(first, last - first);
    if (places.size() <= few) {
      sort_few(places, AlongX());
      Own own = {sides_.unused_for(first, last), 0};
      const Extremes extremes = triangulate_sorted(first, last, own);
      return {extremes, own};
    }
    const Sample sample(places);
    const bool along_x = sample.is_wide();
    const std::size_t middle = first + (along_x ? cut(places, sample, AlongX()) : cut(places, sample, AlongY()));
    Part a, b;
    const auto triangulate_half = [&](std::size_t half) {
      (half == 0 ? a : b) = half == 0 ? triangulate(first, middle) : triangulate(middle, last);
    };
    if (places.size() >= fewest_for_threads) {
      for_each_index(threads_, 2, triangulate_half);
    } else {
      triangulate_half(0);
      triangulate_half(1);
    }
    Own own = {sides_.joined(a.unused, b.unused), a.steps + b.steps};
    merge(along_x ? a.last_x : a.last_y, along_x ? b.first_x : b.first_y, static_cast<Corner>(middle), own);
    return {{first_of<AlongX>(a.first_x, b.first_x), last_of<AlongX>(a.last_x, b.last_x),
             first_of<AlongY>(a.first_y, b.first_y), last_of<AlongY>(a.last_y, b.last_y)},
            own};
  }

  Extremes triangulate_sorted(std::size_t first, std::size_t last, Own& own) {
    if (last - first <= 3) return triangulate_three(first, last, own.unused);
    const std::size_t middle = (first + last) / 2;
    const Extremes a = triangulate_sorted(first, middle, own), b = triangulate_sorted(middle, last, own);
    merge(a.last_x, b.first_x, static_cast<Corner>(middle), own);
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
  Extremes triangulate_three(std::size_t first, std::size_t last, Sides::Unused& unused) {
    const auto a = static_cast<Corner>(first), c = static_cast<Corner>(last - 1);
    Extremes extremes = {a, c, first_of<AlongY>(a, c), last_of<AlongY>(a, c)};
    if (last - first == 2) {
      hull_[a] = sides_.add(a, c, unused);
      hull_[c] = Sides::reverse(hull_[a]);
      return extremes;
    }
    const Corner b = a + 1;
    extremes.first_y = first_of<AlongY>(extremes.first_y, b);
    extremes.last_y = last_of<AlongY>(extremes.last_y, b);
    const Side ab = sides_.add(a, b, unused), bc = sides_.add(b, c, unused);
    sides_.insert(bc, Sides::reverse(ab));
    const int turn = P::orientation(at(a), at(b), at(c));
    hull_[a] = ab;
    hull_[b] = bc;
    hull_[c] = Sides::reverse(bc);
    if (turn == 0) return extremes;
    const Side ca = sides_.add_after(Sides::reverse(bc), ab, unused);
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
  void merge(Corner left_corner, Corner right_corner, Corner middle, Own& own) {
    Side edge = lower_tangent(left_corner, right_corner, own.unused);
    hull_[sides_.to(edge)] = Sides::reverse(edge);
    for (;;) {
      steps_.step(own.steps);
      const Chord<Real> base(at(sides_.to(edge)), at(sides_.from(edge)));
      // The first edge above at either end, and whatever it cuts off.
      const Side back = Sides::reverse(edge);
      Side left = sides_.ccw(back), right = sides_.cw(edge);
      auto of_left = base.candidate(at(sides_.to(left))), of_right = base.candidate(at(sides_.to(right)));
      const bool is_left = base.is_left(of_left), is_right = base.is_left(of_right);
      if (!is_left && !is_right) break;
      if (is_left)
        for (;;) {
          const Side next = sides_.ccw(left);
          const Corner beyond = sides_.to(next);
          if (beyond >= middle) break;
          const auto of_next = base.candidate(at(beyond));
          if (!base.is_inside(of_next, of_left)) break;
          sides_.remove(left, own.unused);
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
          sides_.remove(right, own.unused);
          right = next;
          of_right = of_next;
        }
      edge = !is_left || (is_right && base.is_inside(of_right, of_left))
                 ? sides_.add_after(sides_.along_left(right), back, own.unused)
                 : sides_.add_after(sides_.cw(edge), Sides::reverse(left), own.unused);
    }
    hull_[sides_.from(edge)] = edge;
  }

  /// The edge below both hulls, from right to left.
  Side lower_tangent(Corner left_corner, Corner right_corner, Sides::Unused& unused) {
    Side left = sides_.cw(hull_[left_corner]), right = hull_[right_corner];
    for (;;) {
      const Point &l = at(sides_.from(left)), &r = at(sides_.from(right));
      if (P::orientation(l, at(sides_.to(left)), r) > 0)
        left = sides_.along_left(left);
      else if (P::orientation(r, at(sides_.to(right)), l) < 0)
        right = sides_.along_right(right);
      else
        return sides_.add_after(sides_.cw(right), left, unused);
    }
  }

  /// What lies beyond the hull is no triangle: from now on its sides lead nowhere.
  void open_hull(Corner on_hull) {
    const Side first = Sides::reverse(hull_[on_hull]);
    Side outer = first;
    do {
      const Side next = sides_.along_left(outer);
      sides_.open(outer);
      sides_.number(outer, meshops::Patch::nothing);
      outer = next;
    } while (outer != first);
  }

  /// Triangles that have their least sides among some, and are kept.
  struct Found {
    std::vector<Side> least;
    std::vector<std::array<Side, 3>> sides;
    std::vector<std::array<Corner, 3>> corners;
    std::size_t size = 0, first = 0;  // how many; where in the patch
  };

  /// Loops have no branch that could not be foreseen, and read what is still at hand.
  void hand_over(Corner on_hull, const Fate& fate, meshops::Patch& patch, meshops::Outline& outline) {
    open_hull(on_hull);
    patch.triangles.resize(2 * places_.size());
    patch.across.resize(2 * places_.size());
    corners_.resize(2 * places_.size());
    std::size_t kept = 0;
    in_order<Found>(
        threads_, (sides_.size() + sides_at_once - 1) / sides_at_once,
        [&](std::size_t part, Found& found) { find(part * sides_at_once, fate, found); },
        [&](std::size_t, Found& found) {
          found.first = kept;
          kept += found.size;
        },
        [&](std::size_t, const Found& found) { enter(found, patch); });
    patch.triangles.resize(kept);
    patch.across.resize(kept);
    corners_.resize(kept);
    for_each_part(threads_, kept, triangles_at_once, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t)
        for (int& side : patch.across[t]) side = sides_.number(Sides::reverse(static_cast<Side>(side)));
    });
    tell_outline(patch, outline);
  }

  /// In the plane triangles close around a corner if none of its sides lies at the rim or at a hole.
  void tell_outline(const meshops::Patch& patch, meshops::Outline& outline) const {
    constexpr int nowhere = -1, open = std::numeric_limits<int>::max();
    std::vector<int> last_out(places_.size(), nowhere);  // of each corner, of the sides out of it that come first
    int side = 0;
    for (std::size_t t = 0; t < corners_.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i, ++side) {
        const int across = patch.across[t][i];
        int& last = last_out[corners_[t][i]];
        if (across < 0) {
          (across == meshops::Patch::nothing ? outline.holes : outline.rim).push_back(side);
          last = last_out[corners_[t][(i + 1) % 3]] = open;
        } else {
          last = std::max(last, side < across ? side : nowhere);
        }
      }
    for (const int last : last_out)
      if (last != nowhere && last != open) outline.inside.push_back(last);
    for (const int hole : outline.holes) outline.next_hole.push_back(next_hole(patch, hole));
  }

  void find(std::size_t first, const Fate& fate, Found& found) {
    found.least.resize(sides_at_once);
    found.sides.resize(sides_at_once);
    found.corners.resize(sides_at_once);
    std::size_t triangles = 0;
    for (auto s = static_cast<Side>(first); s < std::min(first + sides_at_once, sides_.size()); ++s) {
      const Side t = sides_.along_left(s), u = sides_.along_left(t);
      found.least[triangles] = s;
      triangles += static_cast<std::size_t>(s < t) & static_cast<std::size_t>(s < u);
    }
    found.size = 0;
    for (std::size_t k = 0; k < triangles; ++k) {
      const Side s = found.least[k], t = sides_.along_left(s), u = sides_.along_left(t);
      const std::array corners = {sides_.from(s), sides_.from(t), sides_.from(u)};
      found.sides[found.size] = {s, t, u};
      found.corners[found.size] = corners;
      const int told = fate(places_[corners[0]], places_[corners[1]], places_[corners[2]]);
      for (const Side side : {s, t, u}) sides_.number(side, told);
      found.size += told >= 0;
    }
  }

  /// As `across` the sides of each triangle, until all have their numbers.
  void enter(const Found& found, meshops::Patch& patch) {
    for (std::size_t k = 0; k < found.size; ++k) {
      const std::size_t t = found.first + k;
      corners_[t] = found.corners[k];
      for (std::size_t i = 0; i < 3; ++i) {
        patch.triangles[t][i] = places_[found.corners[k][i]].site;
        patch.across[t][i] = static_cast<int>(found.sides[k][i]);
        sides_.number(found.sides[k][i], static_cast<int>(3 * t + i));
      }
    }
  }

  const Point& at(Corner c) const { return places_[c].at; }

  static constexpr std::size_t sides_at_once = 1u << 13, triangles_at_once = 1u << 14;
  static constexpr std::size_t fewest_for_threads = 10000;  // a millisecond or two
  std::span<Place> places_;
  Sides sides_;
  std::vector<std::array<Corner, 3>> corners_;  // of the triangles of the patch
  std::vector<Side> hull_;  // of a corner that is extreme, the side of the hull that leaves it counter-clockwise
  Threads& threads_;
  Steps steps_;
};

}  // namespace

template <typename Real>
void delaunay(std::span<Place> places, const Fate& fate, Threads& threads, meshops::Patch& patch,
              meshops::Outline& outline, const std::function<void()>& working) {
  patch.clear();
  outline.clear();
  if (places.size() < 3) return;
  Triangulation<Real>(places, threads, working).run(fate, patch, outline);
}

template void delaunay<double>(std::span<Place>, const Fate&, Threads&, meshops::Patch&, meshops::Outline&,
                               const std::function<void()>&);
template void delaunay<long double>(std::span<Place>, const Fate&, Threads&, meshops::Patch&, meshops::Outline&,
                                    const std::function<void()>&);

}  // namespace rbpa
