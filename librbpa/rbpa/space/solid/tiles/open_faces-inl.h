// What: keeps open faces of a tile's tetrahedra, which wait at one of their corners for the one on the other side.
// How:  each corner has a line with room for fifteen faces, whose keys are compared by one comparison of registers.
//       Further faces are in one list for all corners.
//
//           keys     other corners, the lesser first:  p << 16 | q
//           faces    4 · (tetrahedron) + (corner across), and whether p comes before q as seen from outside
//           used     a bit for each waiting face
//
// Why:  the keys of the current corner are kept in registers. Keys of other corners are read and written as whole
//       lines: a load of a register from memory that was just written in parts stalls until the parts are in the cache.
// Cost: one comparison of registers to look up a face.
#if defined(RBPA_SPACE_TILES_OPEN_FACES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_SPACE_TILES_OPEN_FACES_INL_H_
#undef RBPA_SPACE_TILES_OPEN_FACES_INL_H_
#else
#define RBPA_SPACE_TILES_OPEN_FACES_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/base/lanes/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using rbpa::HWY_NAMESPACE::bits_of;
using rbpa::HWY_NAMESPACE::mask_of;

/// A face (v, first, second), counter-clockwise seen from outside of its tetrahedron.
struct OpenFace {
  std::uint32_t first, second;
  std::uint32_t face;  ///< 4 · (tetrahedron) + (the corner across), below 2^31
};

class OpenFaces {
  static constexpr std::size_t places = 15, lanes = 16;
  static constexpr std::uint32_t full = (1U << places) - 1, order_bit = std::uint32_t{1} << 31U;

  struct alignas(64) Line {
    std::uint32_t keys[lanes];
    std::uint32_t faces[places];
    std::uint32_t used;
  };

  /// The keys of a line, in registers.
  class Keys {
   public:
    HWY_INLINE explicit Keys(const std::uint32_t* from) {
      for (std::size_t i = 0; i < vectors; ++i) v_[i] = hn::Load(D(), from + i * in_vector);
    }
    HWY_INLINE void store(std::uint32_t* to) const {
      for (std::size_t i = 0; i < vectors; ++i) hn::Store(v_[i], D(), to + i * in_vector);
    }
    HWY_INLINE std::uint32_t find(std::uint32_t key) const {
      const auto wanted = hn::Set(D(), key);
      std::uint64_t bits = 0;
      for (std::size_t i = 0; i < vectors; ++i) bits |= bits_of(D(), hn::Eq(v_[i], wanted)) << i * in_vector;
      return static_cast<std::uint32_t>(bits);
    }
    HWY_INLINE void set(std::uint32_t bit, std::uint32_t key) {
      const auto wanted = hn::Set(D(), key);
      for (std::size_t i = 0; i < vectors; ++i)
        v_[i] = hn::IfThenElse(mask_of(D(), bit >> i * in_vector), wanted, v_[i]);
    }

   private:
    using D = hn::CappedTag<std::uint32_t, lanes>;
    static constexpr std::size_t in_vector = hn::MaxLanes(D()), vectors = lanes / in_vector;
    hn::Vec<D> v_[vectors];
  };

  struct Entry {
    HWY_INLINE explicit Entry(const OpenFace& of) {
      const std::uint32_t lesser = std::min(of.first, of.second);
      key = lesser << 16U | std::max(of.first, of.second);
      face = of.face | (of.first == lesser ? order_bit : 0);
    }
    std::uint32_t key, face;
  };
  struct Further {
    std::uint32_t v;
    Entry entry;
  };

 public:
  /// Removes all faces, and prepares for corners numbered below `corners`.
  void clear(std::size_t corners) {
    if (lines_.size() < corners) lines_.resize(2 * corners);
    for (std::size_t v = 0; v < corners; ++v) lines_[v].used = 0;
    further_.clear();
  }

  bool empty(std::uint32_t v) const { return lines_[v].used == 0; }

  /// Looks for the other side of `face`, a face with the same corners, at v. Removes that face and returns its
  /// OpenFace::face if it waits; otherwise adds `face` and returns `nobody`. The code does not branch on the two cases.
  HWY_INLINE std::uint32_t close_or_add(std::uint32_t v, const OpenFace& face, std::uint32_t nobody) {
    const Entry entry(face);
    Line& line = lines_[v];
    Keys keys(line.keys);
    const std::uint32_t used = line.used, found = keys.find(entry.key) & used;
    if ((used ^ found) == full || !further_.empty()) [[unlikely]]
      return close_or_add_slowly(v, entry, nobody);
    const std::uint32_t bit = found != 0 ? found : ~used & (used + 1);
    keys.set(bit, entry.key);
    keys.store(line.keys);
    const int at = std::countr_zero(bit);
    const std::uint32_t other = line.faces[at] & ~order_bit;
    line.faces[at] = entry.face;
    line.used = used ^ bit;
    return found != 0 ? other : nobody;
  }

  /// The faces at one corner. While the object exists, no function of OpenFaces may be called for this corner.
  class AtCorner {
   public:
    HWY_INLINE AtCorner(OpenFaces& faces, std::uint32_t v)
        : faces_(faces), line_(faces.lines_[v]), keys_(line_.keys), used_(line_.used), v_(v) {}
    HWY_INLINE ~AtCorner() { line_.used = used_; }
    AtCorner(const AtCorner&) = delete;
    AtCorner& operator=(const AtCorner&) = delete;

    HWY_INLINE bool empty() const { return used_ == 0; }

    /// Closes or adds a face at this corner, as OpenFaces::close_or_add() does.
    HWY_INLINE std::uint32_t close_or_add(const OpenFace& face, std::uint32_t nobody) {
      const Entry entry(face);
      const std::uint32_t found = keys_.find(entry.key) & used_;
      if ((used_ ^ found) == full || !faces_.further_.empty()) [[unlikely]] {
        line_.used = used_;
        const std::uint32_t other = faces_.close_or_add_slowly(v_, entry, nobody);
        used_ = line_.used;
        keys_ = Keys(line_.keys);
        return other;
      }
      const std::uint32_t bit = found != 0 ? found : ~used_ & (used_ + 1);
      keys_.set(bit, entry.key);
      const int at = std::countr_zero(bit);
      const std::uint32_t other = line_.faces[at] & ~order_bit;
      line_.keys[at] = entry.key;
      line_.faces[at] = entry.face;
      used_ ^= bit;
      return found != 0 ? other : nobody;
    }

    /// Removes one face and returns it. Requires: not empty().
    HWY_INLINE OpenFace pop() {
      const int at = std::countr_zero(used_);
      const std::uint32_t key = line_.keys[at], entry = line_.faces[at];
      used_ &= used_ - 1;
      if (!faces_.further_.empty()) [[unlikely]] {
        line_.used = used_;
        faces_.refill(v_);
        used_ = line_.used;
        keys_ = Keys(line_.keys);
      }
      const std::uint32_t lesser = key >> 16U, greater = key & 0xffffU;
      const std::uint32_t turn = (entry & order_bit) != 0 ? 0 : lesser ^ greater;
      return {lesser ^ turn, greater ^ turn, entry & ~order_bit};
    }

   private:
    OpenFaces& faces_;
    Line& line_;
    Keys keys_;
    std::uint32_t used_, v_;
  };

 private:
  std::uint32_t close_or_add_slowly(std::uint32_t v, const Entry& entry, std::uint32_t nobody) {
    Line& line = lines_[v];
    if (const std::uint32_t found = Keys(line.keys).find(entry.key) & line.used; found != 0) {
      const std::uint32_t other = line.faces[std::countr_zero(found)] & ~order_bit;
      line.used ^= found;
      refill(v);
      return other;
    }
    for (Further& other : further_)
      if (other.v == v && other.entry.key == entry.key) {
        const std::uint32_t waited = other.entry.face & ~order_bit;
        other = further_.back();
        further_.pop_back();
        return waited;
      }
    if (line.used == full)
      further_.push_back({v, entry});
    else
      put(line, entry);
    return nobody;
  }

  static void put(Line& line, const Entry& entry) {
    const int at = std::countr_one(line.used);
    line.keys[at] = entry.key;
    line.faces[at] = entry.face;
    line.used |= 1U << at;
  }

  /// Moves a face of v, if any, from the list to the line of v. The list has faces of v only while its line is full.
  void refill(std::uint32_t v) {
    for (Further& other : further_) {
      if (other.v != v) continue;
      put(lines_[v], other.entry);
      other = further_.back();
      further_.pop_back();
      return;
    }
  }

  std::vector<Line> lines_;
  std::vector<Further> further_;
};

}  // namespace
}  // namespace rbpa::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
