// What: the tiles that are left to the remainder, because the tiles before settled hardly any star.
// Why:  along curves, tiles decide nothing: to cut them is in vain, as the remainder triangulates all points again.
// How:  a tile is in vain if it settles less than one in 64 of its stars. After four tiles in vain in a row the next 4
//       are skipped; after each further tile in vain the next 8, 16, 32, 64. The first tile that is not in vain ends
//       the skipping.
// Law:  the skipped tiles depend on the stars that tiles settle, not on threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace rbpa {

class SkippedTiles {
 public:
  /// Returns whether a tile is skipped; called in any thread. The result is final once all earlier tiles are joined;
  /// before that, only `true` is final.
  bool contains(std::size_t tile) const { return tile < next_.load(std::memory_order_relaxed); }

  /// Records that a tile was joined that is not skipped, owns `owned` sites and settles `settled` stars. Requires:
  /// ascending tiles, one call at a time.
  void joined(std::size_t tile, std::size_t owned, std::size_t settled) {
    in_vain_ = few * settled >= owned ? 0 : in_vain_ + 1;
    gap_ = in_vain_ < patience ? 0 : std::clamp(2 * gap_, patience, most);
    next_.store(tile + 1 + gap_, std::memory_order_relaxed);
  }

 private:
  static constexpr std::size_t few = 64;      // stars are few if they are less than one in 64
  static constexpr std::size_t patience = 4;  // tiles in vain
  static constexpr std::size_t most = 64;     // tiles skipped in a row
  std::size_t in_vain_ = 0;
  std::size_t gap_ = 0;
  std::atomic<std::size_t> next_ = 0;
};

}  // namespace rbpa
