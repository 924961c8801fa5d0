#include "meshops/front/outline.h"

#include <cstddef>

#include "meshops/core/contract.h"

namespace meshops {
namespace {

/// The side of the same triangle that ends where this one begins.
int last(int side) { return side % 3 == 0 ? side + 2 : side - 1; }

class Surveyor {
 public:
  explicit Surveyor(const Patch& patch) : patch_(patch), sides_(static_cast<int>(3 * patch.triangles.size())) {}

  void survey(Outline& outline) const {
    for (int s = 0; s < sides_; ++s) {
      const int other = across(s);
      require(Patch::nothing <= other && other < sides_ && other != s && (other < 0 || across(other) == s),
              "survey: a side is not across of what is across of it");
    }
    for (int s = 0; s < sides_; ++s)
      if (across(s) == Patch::nothing)
        outline.holes.push_back(s);
      else if (across(s) < 0)
        outline.rim.push_back(s);
      else if (comes_first(s) && is_last_inside(s))
        outline.inside.push_back(s);
  }

 private:
  int across(int side) const {
    const auto s = static_cast<std::size_t>(side);
    return patch_.across[s / 3][s % 3];
  }
  bool comes_first(int side) const { return side < across(side); }

  /// The triangles where the side begins close, and no other of their sides out of there that comes first is later.
  bool is_last_inside(int side) const {
    for (int out = next_out(side); out != side; out = next_out(out))
      if (out < 0 || (out > side && comes_first(out))) return false;
    return true;
  }
  /// The next side out of the same site; negative beyond the last.
  int next_out(int side) const { return across(last(side)); }

  const Patch& patch_;
  int sides_;
};

}  // namespace

void survey(const Patch& patch, Outline& outline) {
  require(patch.across.size() == patch.triangles.size(), "survey: a patch tells what is across of each triangle");
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
