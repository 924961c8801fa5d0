#include "meshops/patch/outline.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "meshops/core/contract.h"

namespace meshops {
namespace {

/// Returns the side of the same triangle that ends at the start of `side`.
int last(int side) { return side % 3 == 0 ? side + 2 : side - 1; }

class Surveyor {
 public:
  explicit Surveyor(const Patch& patch)
      : across_(reinterpret_cast<const int*>(patch.across.data())),
        sides_(static_cast<int>(3 * patch.triangles.size())),
        seen_(3 * patch.triangles.size()) {}

  void survey(Outline& outline) {
    for (int s = 0; s < sides_; ++s) {
      const int other = across(s);
      require(Patch::nothing <= other && other < sides_ && (other < 0 || (across(other) == s && other / 3 != s / 3)),
              "survey: the entry of across for side ", s,
              " is neither open, nor nothing, nor a side of another triangle whose entry leads back");
    }
    for (int s = 0; s < sides_; ++s)
      if (across(s) == Patch::nothing)
        outline.holes.push_back(s);
      else if (across(s) < 0)
        outline.rim.push_back(s);
      else if (const std::optional<int> out = last_inside(s))
        outline.inside.push_back(*out);
  }

 private:
  int across(int side) const { return across_[side]; }
  bool comes_first(int side) const { return side < across(side); }

  /// Walks over the sides that leave the start of `side`, and marks them as seen. If the triangles at that start close,
  /// returns the greatest of the sides for which comes_first() is true. Otherwise, or at a seen side, returns nothing.
  std::optional<int> last_inside(int side) {
    int found = -1;
    for (int out = side; out >= 0 && !seen_[static_cast<std::size_t>(out)];) {
      seen_[static_cast<std::size_t>(out)] = true;
      found = std::max(found, comes_first(out) ? out : -1);  // without a branch, which would be mispredicted
      out = next_out(out);
      if (out == side) return found;
    }
    return std::nullopt;
  }
  /// Returns the next side that leaves the same site; a negative number if there is none.
  int next_out(int side) const { return across(last(side)); }

  static_assert(sizeof(std::array<int, 3>) == 3 * sizeof(int));
  const int* across_;  // the entries of Patch::across, one for each side
  int sides_;
  std::vector<std::uint8_t> seen_;  // for each side, whether last_inside() has passed it
};

}  // namespace

void survey(const Patch& patch, Outline& outline) {
  require_one_each("survey", patch.across.size(), "entries of across", patch.triangles.size(), "triangles");
  outline.clear();
  Surveyor(patch).survey(outline);
  for (const int hole : outline.holes) outline.next_hole.push_back(next_hole(patch, hole));
}

int next_hole(const Patch& patch, int hole) {
  for (int side = hole;;) {
    const int before = last(side),
              across = patch.across[static_cast<std::size_t>(before) / 3][static_cast<std::size_t>(before) % 3];
    if (across < 0) return across == Patch::nothing ? before : -1;
    side = across;
  }
}

}  // namespace meshops
