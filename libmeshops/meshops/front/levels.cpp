#include "meshops/front/levels.h"

#include <algorithm>
#include <iterator>

namespace meshops::detail {
namespace {

void sort_and_unite(std::vector<Site>& some) {
  std::sort(some.begin(), some.end());
  some.erase(std::unique(some.begin(), some.end()), some.end());
}

}  // namespace

std::size_t Levels::level(Face f) const {
  const auto begun = std::upper_bound(faces_before_.begin(), faces_before_.end(), static_cast<std::size_t>(f.idx()));
  return static_cast<std::size_t>(begun - faces_before_.begin());
}

LevelTransfer Levels::begin_next(const SiteVertices& vertices, std::vector<Site> on_boundary, std::size_t faces) {
  for (auto s = static_cast<Site>(carried_before_); s < vertices.sites(); ++s)
    if (vertices.exists(s)) carried_.push_back(s);
  carried_before_ = vertices.sites();
  if (!reopened_.empty()) {
    carried_.insert(carried_.end(), reopened_.begin(), reopened_.end());
    reopened_.clear();
    sort_and_unite(carried_);
  }
  sort_and_unite(on_boundary);
  // A site on the boundary may have been left behind: if the caller decides which sides are glued, a fan can begin on
  // it.
  std::vector<Site> carried;
  std::ranges::set_union(carried_, on_boundary, std::back_inserter(carried));
  carried_.swap(carried);
  std::vector<Site> free;
  std::copy_if(carried_.begin(), carried_.end(), std::back_inserter(free), [&](Site s) { return vertices.is_free(s); });
  LevelTransfer transfer;
  transfer.carried.resize(on_boundary.size() + free.size());
  std::merge(on_boundary.begin(), on_boundary.end(), free.begin(), free.end(), transfer.carried.begin());
  transfer.left_behind = carried_.size() - transfer.carried.size();
  carried_ = transfer.carried;
  faces_before_.push_back(faces);
  return transfer;
}

void Levels::clear_sites() {
  // An assignment of {} would empty the vector but keep its memory.
  carried_ = std::vector<Site>();
  reopened_ = std::vector<Site>();
}

}  // namespace meshops::detail
