#include "rbpa/fill/front/lo_front.h"

#include <algorithm>
#include <cmath>

#include "rbpa/fill/front/shape_quality.h"
#include "rbpa/fill/rings/plane_distance.h"

namespace rbpa {
namespace {

/// The maximum distance of a front point from the ideal apex that it replaces, as a multiple of Task::side.
constexpr double near_enough = 0.75;
/// The least distance of a new point from the front, as a multiple of Task::side; `tight_clearance` applies if
/// `clearance` leaves no room.
constexpr double clearance = 0.5, tight_clearance = 0.35;
/// The quality above which a triangle of front points is not replaced by one with a new point in a narrow place.
constexpr double good = 0.6;
/// The quality below which a triangle makes the front retreat.
constexpr double bad = 0.25;
/// The number of searches whose radius doubles. If they find no apex, the next candidates are the far ends of the two
/// edges beside the current edge, as along long edges a front advances to these ends. Then the radius of each search is
/// `far_step` times that of the search before.
constexpr int near_looks = 8;
constexpr double far_step = 16;
/// Maximum number of triangles of the unfilled region that the front may cross or create, for each boundary edge and
/// each attached triangle; an ordinary front needs thirty. Beyond this limit, a search crosses at most `few_passed`
/// triangles, and the front does not retreat.
constexpr std::size_t most_work = 200, few_passed = 64;

/// Returns a key of a pair of sites, which does not depend on their order.
std::uint64_t key_of(Site a, Site b) { return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b); }

}  // namespace

LoFront::LoFront(std::vector<Point> places, std::span<const std::vector<Site>> rings, const SizeField& field,
                 const GoOn& go_on)
    : places_(std::move(places)), field_(field), unfilled_(places_, rings, go_on) {
  double least = field.least();
  bounds_ = {places_[rings[0][0]], places_[rings[0][0]]};
  for (const std::vector<Site>& ring : rings) {
    given_faces_ += ring.size();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& p = places_[ring[i]];
      least = std::min(least, distance(p, places_[ring[(i + 1) % ring.size()]]));
      bounds_ = common_box(bounds_, {p, p});
    }
  }
  retreats_left_ = given_faces_;
  least_reach_ = std::ldexp(std::max(bounds_.high.x - bounds_.low.x, bounds_.high.y - bounds_.low.y), -40);
  least_clearance_ = std::max(0.1 * least, std::ldexp(least_reach_, -20));
}

double LoFront::key(const Front& front, Halfedge h) const {
  return distance(places_[front.from_site(h)], places_[front.to_site(h)]);
}

LoFront::Task LoFront::task_of(Site from, Site to) const {
  Task task{.a = places_[from], .b = places_[to], .from = from, .to = to, .length = 0, .side = 0, .ideal = {}};
  task.length = distance(task.a, task.b);
  // The target size is that of the field near the apex: the second turn uses the apex of the first.
  for (int turn = 0; turn < 2; ++turn) {
    const Point& at = turn == 0 ? places_[from] : task.ideal;
    task.side = std::clamp(field_.at(at), 0.6 * task.length, 1.6 * task.length);
    task.ideal = apex_at(task, 1);
  }
  return task;
}

/// Returns the apex at `share` of the height of the ideal triangle.
Point LoFront::apex_at(const Task& task, double share) const {
  const double dx = task.b.x - task.a.x, dy = task.b.y - task.a.y, half = task.length / 2;
  const double height = std::sqrt(std::max(task.side * task.side - half * half, 0.0));
  const double rise = task.length > 0 ? share * height / task.length : 0;
  return {task.a.x + dx / 2 - rise * dy, task.a.y + dy / 2 + rise * dx};
}

/// Replaces task.candidates by the points of the front that form empty triangles with the edge and lie in the bounding
/// box of edge and ideal apex, widened by `reach`; leaves out points that an earlier search for this edge found.
void LoFront::look_around(Task& task, double reach) const {
  Box box = common_box(common_box({task.a, task.a}, {task.b, task.b}), {task.ideal, task.ideal});
  box = {{box.low.x - reach, box.low.y - reach}, {box.high.x + reach, box.high.y + reach}};
  const std::span<const Site> found = unfilled_.free_sites(box);
  task.candidates.assign(found.begin(), found.end());
  task.is_all = box.low.x <= bounds_.low.x && box.high.x >= bounds_.high.x && box.low.y <= bounds_.low.y &&
                box.high.y >= bounds_.high.y;
}

/// Returns the candidate nearest to the ideal apex; nothing if the distance of every candidate is above `reach`.
std::optional<Site> LoFront::near_ideal(const Task& task, double reach) const {
  std::optional<std::pair<double, Site>> nearest;
  for (const Site s : task.candidates)
    if (const double far = distance(places_[s], task.ideal); far <= reach)
      nearest = nearest ? std::min(*nearest, {far, s}) : std::pair(far, s);
  return nearest ? std::optional(nearest->second) : std::nullopt;
}

/// Returns the candidate whose triangle has the best shape, on a tie the candidate with the least site number; nothing
/// if there is no candidate.
std::optional<LoFront::Choice> LoFront::best_of(const Task& task) const {
  std::optional<Choice> best;
  for (const Site s : task.candidates) {
    const double quality = shape_quality(task.a, task.b, places_[s]);
    if (!best || quality > best->quality || (quality == best->quality && s < best->apex)) best = Choice{s, quality};
  }
  return best;
}

/// Replaces task.candidates by the far ends of the two edges beside `h` on the front, if their triangles with `h` are
/// empty. Returns the best candidate.
std::optional<LoFront::Choice> LoFront::corner_of(const Front& front, Halfedge h, Task& task) const {
  task.candidates.clear();
  const meshops::Connectivity& mesh = front.mesh();
  for (const Site s : {front.from_site(mesh.prev_halfedge_handle(h)), front.to_site(mesh.next_halfedge_handle(h))})
    if (unfilled_.is_free({task.from, task.to}, s)) task.candidates.push_back(s);
  return best_of(task);
}

/// Returns the point apex_at(task, share) if its triangle is empty and its distance from the front is at least `wanted`
/// times task.side; otherwise nothing.
std::optional<Point> LoFront::placed(const Task& task, double share, double wanted) const {
  const Point apex = apex_at(task, share);
  if (!is_finite(apex)) return std::nullopt;
  const double least = std::max(wanted * task.side, least_clearance_);
  return unfilled_.is_free({task.from, task.to}, apex, least, most_passed()) ? std::optional(apex) : std::nullopt;
}

bool LoFront::is_late() const { return unfilled_.passed() > most_work * (given_faces_ + kept_); }

std::size_t LoFront::most_passed() const { return is_late() ? few_passed : Unfilled::unlimited; }

meshops::Proposal LoFront::propose(const Front& front, Halfedge h) {
  places_.resize(front.sites());
  Task task = task_of(front.from_site(h), front.to_site(h));
  const bool again = retreated_from_.contains(key_of(task.from, task.to));
  unfilled_.look_from({task.from, task.to}, most_passed());
  look_around(task, task.side);
  // A front that has retreated from this edge accepts a farther front point in place of a new point, so that retreats
  // do not repeat.
  if (const auto site = near_ideal(task, (again ? 1.2 : near_enough) * task.side)) return *site;
  std::optional<Point> apex = placed(task, 1, clearance);
  std::optional<Choice> best;
  if (!apex) {
    best = best_of(task);
    for (const double share : {0.8, 0.6})
      if (!apex && (!best || best->quality < good)) apex = placed(task, share, tight_clearance);
  }
  if (apex) {
    places_.push_back(*apex);
    return static_cast<Site>(front.sites());
  }
  int looks = 0;
  for (double reach = std::max(2 * task.side, least_reach_); !best; reach *= looks < near_looks ? 2 : far_step) {
    if (looks == near_looks) best = corner_of(front, h, task);
    if (best) break;
    look_around(task, reach);
    best = best_of(task);
    if (!best && task.is_all) return std::nullopt;  // impossible: some site always forms an empty triangle
    ++looks;
  }
  // A far apex would also be far from the edges behind: a retreat would not help.
  const bool is_far = looks >= near_looks;
  if (!is_far && best->quality < bad && !again && retreats_left_ > 0 && !is_late()) {
    if (const auto face = behind(front, h)) {
      retreated_from_.insert(key_of(task.from, task.to));
      --retreats_left_;
      ++retreated_;
      return meshops::Proposal::detach(*face);
    }
  }
  return best->apex;
}

/// Returns an attached triangle behind `h` or behind one of the two edges beside `h` on the front; nothing if behind
/// all three edges lie initial faces.
std::optional<meshops::Face> LoFront::behind(const Front& front, Halfedge h) const {
  const meshops::Connectivity& mesh = front.mesh();
  for (const Halfedge at : {h, mesh.next_halfedge_handle(h), mesh.prev_halfedge_handle(h)}) {
    const meshops::Face face = mesh.face_handle(mesh.opposite_halfedge_handle(at));
    if (static_cast<std::size_t>(face.idx()) >= given_faces_) return face;
  }
  return std::nullopt;
}

void LoFront::attached(const Front& front, const meshops::InsertedTriangle& triangle) {
  places_.resize(front.sites());
  const meshops::Connectivity& mesh = front.mesh();
  ++kept_;
  // At least one side was on the front: a triangle lies beyond this side.
  const auto base = std::find_if(triangle.side.begin(), triangle.side.end(),
                                 [&](Halfedge side) { return !mesh.is_boundary(mesh.opposite_halfedge_handle(side)); });
  unfilled_.fill({front.from_site(*base), front.to_site(*base)}, front.to_site(mesh.next_halfedge_handle(*base)));
}

void LoFront::detached(const meshops::DetachedTriangle& triangle) {
  std::array<bool, 3> is_front;
  for (std::size_t i = 0; i < 3; ++i) is_front[i] = triangle.side[i].is_valid();
  --kept_;
  unfilled_.empty(triangle.corners, is_front);
}

}  // namespace rbpa
