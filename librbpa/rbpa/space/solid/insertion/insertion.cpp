#include "rbpa/space/solid/insertion/insertion.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "rbpa/base/run/checkpoint_of_threads.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/predicate/orientation.h"

namespace rbpa::space {
namespace {

constexpr std::uint32_t none = 0xffffffff;
constexpr std::size_t places_of_hint = 8;
constexpr std::size_t counted_at_once = 256;
constexpr std::size_t growth = 8;  // vertices after a pass, divided by those before it

}  // namespace

/// Counts inserted vertices in several threads, and reports them to `progress`, one call at a time.
template <bool weighted>
class BasicInsertion<weighted>::Counter {
 public:
  Counter(const OnProgress& progress, std::size_t size)
      : progress_([this, &progress, size] {
          return !progress || progress({done_, size});
        }),
        report_([this] { return checkpoint_.goes_on(); }) {}
  /// Returns what report() calls, to be counted in steps.
  const GoOn& report() const { return report_; }
  void add(std::size_t vertices) { done_ += vertices; }

 private:
  std::atomic<std::size_t> done_ = 0;
  GoOn progress_;
  CheckpointOfThreads checkpoint_ = CheckpointOfThreads(progress_);
  GoOn report_;
};

template <bool weighted>
BasicInsertion<weighted>::BasicInsertion(std::span<const Point3> points, std::span<const Point3> scaled,
                                         const Spread& spread, const SpatialOrder& order, Threads& threads,
                                         std::span<const double> radii, std::span<const double> scaled_radii,
                                         Division division)
    : threads_(threads),
      division_{division.workers > 0 ? division.workers : std::min<std::size_t>(threads.count(), 255), division.least},
      // The usual number of tetrahedra of points that fill a volume, including ghosts and deleted tetrahedra, and more
      // for several workers, whose room cannot grow. Memory that is not used is not touched.
      all_(points, scaled, spread, order.order, radii, scaled_radii,
           (division_.workers > 1 ? 9 : 7) * order.order.size() + 256, threads) {
  const std::size_t vertices = order.order.size();
  if (vertices <= 2 * division_.least) division_.workers = 1;
  workers_.reserve(division_.workers);
  for (std::size_t w = 0; w < division_.workers; ++w) workers_.push_back({BasicInserter<weighted>(all_), {}, false});
  if (division_.workers == 1) return;
  place_.resize(vertices + 1);
  std::copy(order.place.begin(), order.place.end(), place_.begin() + 1);
  hint_.assign(vertices / places_of_hint + 1, none);
  owner_.resize(vertices + 1);
}

/// Makes four points that are not in a plane vertices 1 to 4, and their tetrahedron. Returns false if there are none.
template <bool weighted>
bool BasicInsertion<weighted>::begin() {
  const auto exchange = [&](Vertex v, Vertex w) {
    all_.exchange(v, w);
    if (!place_.empty()) std::swap(place_[v], place_[w]);
  };
  const auto point = [&](Vertex v) { return all_.point(v); };
  Vertex third = 3, fourth;
  while (third <= size() && are_collinear(point(1), point(2), point(third))) ++third;
  if (third > size()) return false;
  exchange(3, third);
  for (fourth = 4; fourth <= size(); ++fourth)
    if (orientation(point(1), point(2), point(3), point(fourth)) != 0) break;
  if (fourth > size()) return false;
  exchange(4, fourth);
  if (orientation(point(1), point(2), point(3), point(4)) < 0) exchange(1, 2);
  workers_[0].inserter.begin();
  return true;
}

template <bool weighted>
bool BasicInsertion<weighted>::insert_all(const OnProgress& progress) {
  if (!begin()) return false;
  Counter counter(progress, size());
  Steps step(counter.report());
  const auto insert = [&](Vertex v) {
    insert_alone(v);
    counter.add(1);
    step(1 + workers_[0].inserter.made());
  };
  counter.add(4);
  const auto first = static_cast<Vertex>(workers_.size() > 1 ? 2 * division_.least : size());
  for (Vertex v = 5; v <= first; ++v) insert(v);
  std::vector<Vertex> vertices;
  for (std::size_t begin = first + 1, end; begin <= size(); begin = end) {
    end = std::min<std::size_t>(begin * growth, size() + 1);
    vertices.clear();
    for (std::size_t v = begin; v < end; ++v) vertices.push_back(static_cast<Vertex>(v));
    all_.make_room(all_.used() / begin * (end + end / 4));
    const std::size_t pieces = std::min(workers_.size(), begin / division_.least);
    insert_shared(vertices, pieces, false, counter);
    waited_[0] += vertices.size();
    for (std::size_t fewer = std::max<std::size_t>(pieces / 2, 2); fewer >= 2; fewer /= 2)
      insert_shared(vertices, fewer, true, counter);
    if (pieces > 2) insert_shared(vertices, 2, false, counter);
    waited_[1] += vertices.size();
    for (const Vertex v : vertices) insert(v);
  }
  return true;
}

/// Inserts vertices by the workers of pieces of the curve. Keeps those that wait in `vertices`. If `is_moved`, the
/// pieces begin half a piece earlier.
template <bool weighted>
void BasicInsertion<weighted>::insert_shared(std::vector<Vertex>& vertices, std::size_t pieces, bool is_moved,
                                             Counter& counter) {
  const std::size_t hints = size() / pieces / places_of_hint + 1;  // in a piece
  pieces_ = pieces;
  piece_ = hints * places_of_hint;
  moved_by_ = is_moved ? hints / 2 * places_of_hint : 0;
  for_each_part(threads_, owner_.size(), 1u << 16, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) owner_[v] = static_cast<std::uint8_t>(owner_of_place(place_[v]));
  });
  for (std::size_t w = 0; w < workers_.size(); ++w) {
    workers_[w].inserter.own(owner_.data(), static_cast<std::uint8_t>(w));
    workers_[w].vertices.clear();
    workers_[w].has_begun = false;
  }
  // A worker may read a tetrahedron only if it owns all corners.
  for_each_part(threads_, hint_.size(), 1u << 13, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      std::uint32_t& t = hint_[i];
      if (t != none && (all_.is_deleted(t) || !workers_[owner_of_place(i * places_of_hint)].inserter.owns(t))) t = none;
    }
  });
  for (const Vertex v : vertices) workers_[owner_[v]].vertices.push_back(v);
  for_each_index(threads_, pieces_, [&](std::size_t number) { insert_part(number, counter); });
  vertices.clear();
  for (Worker& worker : workers_) {
    vertices.insert(vertices.end(), worker.vertices.begin(), worker.vertices.end());
    worker.inserter.own(nullptr, 0);
  }
}

/// Inserts the vertices of a worker, and keeps those that wait.
template <bool weighted>
void BasicInsertion<weighted>::insert_part(std::size_t number, Counter& counter) {
  Worker& worker = workers_[number];
  BasicInserter<weighted>& inserter = worker.inserter;
  Steps step(counter.report());
  std::size_t waiting = 0, done = 0;
  for (const Vertex v : worker.vertices) {
    InsertionResult result = InsertionResult::not_reached;
    if (worker.has_begun) result = inserter.insert(v, inserter.last());
    if (result == InsertionResult::not_reached)
      if (const std::uint32_t t = hint_near(place_[v], number); t != none) result = inserter.insert(v, t);
    if (result == InsertionResult::yes) {
      worker.has_begun = true;
      hint_[place_[v] / places_of_hint] = inserter.last();
      if (++done % counted_at_once == 0) counter.add(counted_at_once);
    } else {
      worker.vertices[waiting++] = v;
    }
    step(1 + inserter.made());
  }
  counter.add(done % counted_at_once);
  worker.vertices.resize(waiting);
}

/// Returns a tetrahedron near a place of the curve, in places of one worker; `none` if there is none nearby.
template <bool weighted>
std::uint32_t BasicInsertion<weighted>::hint_near(std::size_t place, std::size_t number) const {
  const auto at = static_cast<std::ptrdiff_t>(place / places_of_hint), end = static_cast<std::ptrdiff_t>(hint_.size());
  for (const std::ptrdiff_t away : {0, -1, 1, -2, 2, -3, 3, -4, 4}) {
    const std::ptrdiff_t i = at + away;
    if (i < 0 || i >= end || owner_of_place(static_cast<std::size_t>(i) * places_of_hint) != number) continue;
    const std::uint32_t t = hint_[static_cast<std::size_t>(i)];
    if (t != none && !all_.is_deleted(t)) return t;
  }
  return none;
}

template <bool weighted>
void BasicInsertion<weighted>::insert_alone(Vertex v) {
  BasicInserter<weighted>& inserter = workers_[0].inserter;
  std::uint32_t t = none;
  if (!hint_.empty()) t = hint_near(place_[v], owner_of_place(place_[v]));
  if (t == none) t = inserter.last();
  while (all_.is_deleted(t)) t = t + 1 < all_.used() ? t + 1 : 0;  // another worker has deleted it
  inserter.insert(v, t);
  if (!hint_.empty()) hint_[place_[v] / places_of_hint] = inserter.last();
}

template class BasicInsertion<false>;
template class BasicInsertion<true>;

}  // namespace rbpa::space
