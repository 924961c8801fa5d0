#include "meshops/front/waiting_edges.h"

#include <algorithm>

#include "meshops/core/contract.h"

namespace meshops::detail {

void WaitingEdges::set_state(Halfedge h, State state) {
  const auto edge = static_cast<std::size_t>(h.idx()) / 2;
  if (edge >= state_.size()) {
    if (state == State::neither) return;
    state_.resize(edge + 1, State::neither);
  }
  state_[edge] = state;
}

void WaitingEdges::queue(Halfedge h) {
  // The entries before head_ are used up. They are removed when they are most of the queue, so that the length of the
  // queue is bounded by the size of the front, not by the length of the run.
  if (active_.size() == active_.capacity() && head_ > active_.size() / 2) {
    active_.erase(active_.begin(), active_.begin() + static_cast<std::ptrdiff_t>(head_));
    head_ = 0;
  }
  active_.push_back(h);
  set_state(h, State::active);
}

void WaitingEdges::queue_all(std::vector<Halfedge>&& active) {
  active_ = std::move(active);
  head_ = 0;
  state_.resize(mesh_.n_edges(), State::neither);
  for (const Halfedge h : active_) set_state(h, State::active);
}

Halfedge WaitingEdges::next() {
  while (head_ < active_.size())
    if (const Halfedge h = active_[head_++]; state(h) == State::active) return checked(h);
  active_.clear();
  head_ = 0;
  return Halfedge();
}

void WaitingEdges::requeue(std::span<const Halfedge> first) {
  std::vector<Halfedge> queue;
  std::vector<bool> queued(state_.size(), false);
  const auto add = [&](Halfedge h) {
    if (state(h) != State::active) return;
    auto is_queued = queued[static_cast<std::size_t>(h.idx()) / 2];
    if (!is_queued) queue.push_back(h);
    is_queued = true;
  };
  for (const Halfedge h : first) add(h);
  for (std::size_t i = head_; i < active_.size(); ++i) add(active_[i]);
  for (std::size_t i = 0; i < 2 * state_.size(); ++i) add(Halfedge(static_cast<int>(i)));
  active_ = std::move(queue);
  head_ = 0;
}

void WaitingEdges::defer(Halfedge h, std::size_t revision) {
  if (revision != deferred_revision_) {
    deferred_revision_ = revision;
    deferred_now_ = deferred_.size();
  }
  set_state(h, State::deferred);
  last_deferral_.resize(std::max(last_deferral_.size(), state_.size()), 0);
  last_deferral_[static_cast<std::size_t>(h.idx()) / 2] = ++deferrals_;
  deferred_.push_back({h, deferrals_});
}

bool WaitingEdges::wake_deferred(std::size_t revision) {
  const std::size_t end = revision == deferred_revision_ ? deferred_now_ : deferred_.size();
  if (end <= deferred_head_) return false;
  bool woken = false;
  for (std::size_t i = deferred_head_; i < end; ++i)
    if (is_current(deferred_[i])) {
      queue(checked(deferred_[i].h));
      woken = true;
    }
  deferred_.erase(deferred_.begin(), deferred_.begin() + static_cast<std::ptrdiff_t>(end));
  deferred_head_ = deferred_now_ = 0;
  return woken;
}

Halfedge WaitingEdges::next_deferred() {
  while (deferred_head_ < deferred_.size())
    if (const Deferred entry = deferred_[deferred_head_++]; is_current(entry)) return checked(entry.h);
  deferred_.clear();
  deferred_head_ = deferred_now_ = 0;
  return Halfedge();
}

std::size_t WaitingEdges::wake_all() {
  std::size_t woken = 0;
  for (const Halfedge h : frozen_) {
    if (!is_frozen(h)) continue;
    queue(h);
    ++woken;
  }
  frozen_.clear();
  return woken;
}

void WaitingEdges::clear() {
  // An assignment of {} would empty the vector but keep its memory.
  state_ = std::vector<State>();
  active_ = std::vector<Halfedge>();
  head_ = 0;
  frozen_ = std::vector<Halfedge>();
  deferred_ = std::vector<Deferred>();
  last_deferral_ = std::vector<std::size_t>();
  deferred_head_ = deferred_now_ = 0;
}

void WaitingEdges::deleted_by_others() {
  throw ContractViolation("Front: the mesh was changed by others: an edge of the front is marked deleted");
}

}  // namespace meshops::detail
