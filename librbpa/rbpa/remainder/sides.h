// What:   a plane graph as directed sides that know their neighbours around the point they leave, in 32 bits a number.
// Law:    side s and reverse(s) are one edge; following ccw() goes around a point counter-clockwise and comes back.
// Cost:   12 bytes a side; edges that are taken out are used again, first those that were last.
// Source: Guibas, Stolfi, Primitives for the manipulation of general subdivisions (1985), without the dual.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace rbpa {

class Sides {
 public:
  using Side = std::uint32_t;
  using Corner = std::uint32_t;

  /// Edges that are not in use, of which none is another list's: who has a list of their own may add and remove beside
  /// others.
  struct Unused {
    Side first, last;
  };

  /// Room for the edges of a triangulation of so many points.
  explicit Sides(std::size_t points) : size_(6 * points), sides_(std::make_unique_for_overwrite<Links[]>(size_)) {}

  /// Enough for a triangulation of the points from `first` to before `last`; for each point once.
  /// Requires: at least one.
  Unused unused_for(std::size_t first, std::size_t last) {
    const Unused all = {static_cast<Side>(6 * first), static_cast<Side>(6 * last - 2)};
    for (Side s = all.first; s <= all.last; s += 2) put_away(s, s + 2);
    return all;
  }
  Unused joined(const Unused& a, const Unused& b) {
    sides_[a.last].ccw = b.first;
    return {a.first, b.last};
  }

  /// Sides are numbered from 0 to size() − 1; some are of edges that are not in use. Of these along_left() is 0.
  std::size_t size() const { return size_; }

  static Side reverse(Side s) { return s ^ 1; }
  Corner from(Side s) const { return sides_[s].from; }
  Corner to(Side s) const { return sides_[reverse(s)].from; }
  /// The next side that leaves the same point, counter-clockwise, clockwise.
  Side ccw(Side s) const { return sides_[s].ccw; }
  Side cw(Side s) const { return sides_[s].cw; }
  /// The next side along the face that lies left, right; both leave the point to which `s` leads.
  Side along_left(Side s) const { return cw(reverse(s)); }
  Side along_right(Side s) const { return ccw(reverse(s)); }

  /// An edge that touches no other.
  Side add(Corner from, Corner to, Unused& unused) {
    const Side s = unused.first;
    unused.first = sides_[s].ccw;
    sides_[s] = {from, s, s};
    sides_[reverse(s)] = {to, reverse(s), reverse(s)};
    return s;
  }

  /// An edge between the points that `s` and `t` leave, next to each counter-clockwise.
  Side add_after(Side s, Side t, Unused& unused) {
    const Side added = unused.first, back = reverse(added);
    unused.first = sides_[added].ccw;
    const Side s_next = ccw(s), t_next = ccw(t);
    sides_[added] = {from(s), s_next, s};
    sides_[back] = {from(t), t_next, t};
    sides_[s].ccw = sides_[s_next].cw = added;
    sides_[t].ccw = sides_[t_next].cw = back;
    return added;
  }

  /// Puts a side that is alone at its point next to another one, counter-clockwise.
  void insert(Side s, Side after) {
    const Side before = ccw(after);
    sides_[s].cw = after;
    sides_[s].ccw = before;
    sides_[after].ccw = s;
    sides_[before].cw = s;
  }

  /// The face that lies left of `s` is none any more: along_left() is 0.
  void open(Side s) { sides_[reverse(s)].cw = 0; }

  /// A number instead of what is next counter-clockwise.
  void number(Side s, int n) { sides_[s].ccw = static_cast<Side>(n); }
  int number(Side s) const { return static_cast<int>(sides_[s].ccw); }

  void remove(Side s, Unused& unused) {
    unlink(s);
    unlink(reverse(s));
    s &= ~Side{1};
    put_away(s, unused.first);
    unused.first = s;
  }

 private:
  struct Links {
    Corner from;
    Side ccw, cw;
  };
  void unlink(Side s) {
    sides_[sides_[s].ccw].cw = sides_[s].cw;
    sides_[sides_[s].cw].ccw = sides_[s].ccw;
  }
  void put_away(Side s, Side next) {
    sides_[s].ccw = next;
    sides_[s].cw = sides_[reverse(s)].cw = 0;
  }

  std::size_t size_;
  std::unique_ptr<Links[]> sides_;
};

}  // namespace rbpa
