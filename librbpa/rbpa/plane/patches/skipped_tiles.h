// What: the tiles that are left to the remainder unseen, since those before them settled hardly any star.
// Why:  along curves tiles decide nothing, and are cut in vain. All points are triangulated once more then, by the remainder.
// How:  after four tiles in a row that settle few stars, each of which may be small, the next four are skipped; after another such
//       tile eight, 16, … 64. A tile that settles more ends it.
// Law:  a function of the stars that tiles settle, not of threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace rbpa {

class SkippedTiles {
 public:
  /// In any thread. Once the tiles before have been joined the answer is final; before, only true is.
  bool contains(std::size_t tile) const { return tile < next_.load(std::memory_order_relaxed); }

  /// When a tile is joined that is not skipped, one after another: it owns so many sites, and settles so many stars.
  void joined(std::size_t tile, std::size_t owned, std::size_t settled) {
    in_vain_ = few * settled >= owned ? 0 : in_vain_ + 1;
    gap_ = in_vain_ < patience ? 0 : std::clamp(2 * gap_, patience, most);
    next_.store(tile + 1 + gap_, std::memory_order_relaxed);
  }

 private:
  static constexpr std::size_t few = 64;      // stars are few when they are less than one of so many
  static constexpr std::size_t patience = 4;  // tiles in vain
  static constexpr std::size_t most = 64;     // tiles skipped in a row
  std::size_t in_vain_ = 0;
  std::size_t gap_ = 0;
  std::atomic<std::size_t> next_ = 0;
};

}  // namespace rbpa
