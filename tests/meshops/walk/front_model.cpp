#include "walk/front_model.h"

#include <algorithm>

namespace meshops::test {

SiteCycle canonical(SiteCycle cycle) {
  std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  return cycle;
}

namespace {

std::set<Arrow> sides_of(const SiteCycle& face) {
  std::set<Arrow> sides;
  for (std::size_t i = 0; i < face.size(); ++i) sides.insert({face[i], face[(i + 1) % face.size()]});
  return sides;
}

Arrow back(const Arrow& arrow) { return {arrow.second, arrow.first}; }

}  // namespace

FrontModel::FrontModel(std::size_t sites) : sites_(sites) {}

FrontModel::FrontModel(std::size_t sites, const std::set<SiteCycle>& faces, const std::set<Site>& missing)
    : sites_(sites), missing_(missing), faces_(faces) {
  for (const SiteCycle& face : faces)
    for (const Arrow& side : sides_of(face)) sides_.insert(side);
  for (const Arrow& side : sides_)
    if (!has_side(back(side))) boundary_[back(side)] = State::active;
}

FrontModel::Star FrontModel::star(Site s) const {
  Star star;
  std::set<Site> behind;
  for (const SiteCycle& face : faces_) {
    const auto at = std::find(face.begin(), face.end(), s);
    if (at == face.end()) continue;
    const Site next = at + 1 == face.end() ? face.front() : *(at + 1);
    const Site previous = at == face.begin() ? face.back() : *(at - 1);
    star.after[next] = {previous, &face};
    behind.insert(previous);
  }
  for (const auto& [neighbor, unused] : star.after)
    if (!behind.contains(neighbor)) star.first.insert(neighbor);
  return star;
}

std::set<std::set<SiteCycle>> FrontModel::fans(Site s) const {
  Star star = this->star(s);
  std::set<std::set<SiteCycle>> fans;
  const auto follow = [&](Site from) {
    std::set<SiteCycle> fan;
    for (auto at = star.after.find(from); at != star.after.end(); at = star.after.find(from)) {
      fan.insert(*at->second.second);
      from = at->second.first;
      star.after.erase(at);
    }
    fans.insert(fan);
  };
  for (const Site first : star.first) follow(first);
  while (!star.after.empty()) follow(star.after.begin()->first);
  return fans;
}

bool FrontModel::is_free(Site s) const { return star(s).after.empty(); }

bool FrontModel::is_closed(Site s) const {
  const Star star = this->star(s);
  return !star.after.empty() && star.first.empty();
}

std::set<RefusalKind> FrontModel::against(const std::array<Site, 3>& corners) const {
  std::set<RefusalKind> against;
  std::set<Site> fresh;
  for (const Site s : corners)
    if (s >= sites_) fresh.insert(s);
  if (!fresh.empty() && *fresh.rbegin() >= sites_ + fresh.size()) against.insert(RefusalKind::no_such_site);
  for (std::size_t i = 0; i < 3; ++i) {
    const Site s = corners[i], next = corners[(i + 1) % 3];
    if (s == next) against.insert(RefusalKind::corner_repeated);
    if (missing_.contains(s)) against.insert(RefusalKind::no_such_site);
    if (has_side({s, next})) against.insert(RefusalKind::side_taken);
    if (is_closed(s)) against.insert(RefusalKind::site_closed);
  }
  return against;
}

void FrontModel::add(const std::array<Site, 3>& corners) {
  for (const Site s : corners) sites_ = std::max<std::size_t>(sites_, s + std::size_t{1});
  const SiteCycle face = canonical({corners.begin(), corners.end()});
  faces_.insert(face);
  level_of_[face] = level_;
  for (const Arrow& side : sides_of(face)) {
    sides_.insert(side);
    if (boundary_.erase(side) == 0) boundary_[back(side)] = State::active;
  }
}

std::set<RefusalKind> FrontModel::against_removing(const SiteCycle& face) const {
  if (face.size() != 3) return {RefusalKind::no_triangle};
  const std::set<Arrow> sides = sides_of(face);
  if (std::all_of(sides.begin(), sides.end(), [&](const Arrow& side) { return has_side(back(side)); }))
    return {RefusalKind::not_at_front};
  return {};
}

void FrontModel::remove(const SiteCycle& face) {
  faces_.erase(face);
  for (const Arrow& side : sides_of(face)) {
    sides_.erase(side);
    if (boundary_.erase(back(side)) == 0) boundary_[side] = State::active;
  }
}

std::vector<Site> FrontModel::carried() const {
  std::vector<Site> carried;
  for (Site s = 0; s < sites_; ++s)
    if (exists(s) && !is_closed(s)) carried.push_back(s);
  return carried;
}

void FrontModel::next_level() {
  ++level_;
  for (auto& [arrow, state] : boundary_)
    if (state == State::frozen) state = State::active;
}

}  // namespace meshops::test
