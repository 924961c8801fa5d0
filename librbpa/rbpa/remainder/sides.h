// What:   a plane graph as directed sides that know their neighbours around the point they leave, in 32 bits a number.
// Law:    side s and reverse(s) are one edge; following ccw() goes around a point counter-clockwise and comes back.
// Cost:   12 bytes a side; edges that are taken out are used again.
// Source: Guibas, Stolfi, Primitives for the manipulation of general subdivisions (1985), without the dual.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace rbpa {

class Sides {
 public:
  using Side = std::uint32_t;
  using Corner = std::uint32_t;
  static constexpr Side none = std::numeric_limits<Side>::max();

  /// No edges yet; as many as a triangulation of so many points can have will need no more memory.
  explicit Sides(std::size_t points) { sides_.reserve(6 * points); }

  /// Sides are numbered from 0 to size() − 1; some are of edges that were taken out.
  std::size_t size() const { return sides_.size(); }
  bool is_used(Side s) const { return sides_[s].cw != none; }
  std::size_t edges() const { return edges_; }

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
  Side add(Corner from, Corner to) {
    ++edges_;
    Side s = unused_;
    if (s != none) {
      unused_ = sides_[s].ccw;
    } else {
      s = static_cast<Side>(sides_.size());
      sides_.resize(sides_.size() + 2);
    }
    sides_[s] = {from, s, s};
    sides_[reverse(s)] = {to, reverse(s), reverse(s)};
    return s;
  }

  /// An edge between the points that `s` and `t` leave, next to each counter-clockwise.
  Side add_after(Side s, Side t) {
    const Side added = add(from(s), from(t));
    insert(added, s);
    insert(reverse(added), t);
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

  void remove(Side s) {
    --edges_;
    unlink(s);
    unlink(reverse(s));
    s &= ~Side{1};
    sides_[s].ccw = unused_;
    sides_[s].cw = sides_[reverse(s)].cw = none;
    unused_ = s;
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

  std::vector<Links> sides_;
  Side unused_ = none;
  std::size_t edges_ = 0;
};

}  // namespace rbpa
