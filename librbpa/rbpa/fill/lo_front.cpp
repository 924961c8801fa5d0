#include "rbpa/fill/lo_front.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "rbpa/fill/plane_predicates.h"
#include "rbpa/fill/shadow.h"
#include "rbpa/fill/shape_quality.h"

namespace rbpa {
namespace {

/// A front point this near to the ideal one, in sides of the triangle, takes its place.
constexpr double near_enough = 0.75;
/// A new point is so far from the front, in sides of the triangle; where this is too much to ask, at least so far.
constexpr double clearance = 0.5, tight_clearance = 0.35;
/// A triangle of front points that is better is not bettered by a new point in a narrow place.
constexpr double good = 0.6;
/// One that is worse makes the front retreat.
constexpr double bad = 0.25;
/// So often the look around is doubled as it is. What is farther is seen past long edges, along which a front advances by
/// its own corners: these are tried first, and from then on each look is so many times as wide as the last.
constexpr int near_looks = 8;
constexpr double far_step = 16;
/// Where more edges than this are near, and all of them have been looked at so often for nothing, those that others hide are
/// left out, as long as these hide many: so many others at a time.
constexpr std::size_t few_edges = 32, most_looks = 2, most_casters = 8;
/// Edges that are asked first whether they reach into a triangle: those that did last.
constexpr std::size_t most_blockers = 4;

int orientation(const Point& a, const Point& b, const Point& c) { return plane_orientation(a, b, c); }

double distance(const Point& a, const Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  return std::sqrt(dx * dx + dy * dy);
}

double distance(const Point& p, const Point& a, const Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double along = square > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / square : 0;
  const double share = std::clamp(along, 0.0, 1.0);
  return distance(p, {a.x + share * dx, a.y + share * dy});
}

/// The inner parts of both segments have one point in common.
bool cross(const Point& p, const Point& q, const Point& r, const Point& s) {
  return orientation(p, q, r) * orientation(p, q, s) < 0 && orientation(r, s, p) * orientation(r, s, q) < 0;
}

/// The point is farther than that from the box of the segment.
bool is_surely_clear(const Point& p, const Point& a, const Point& b, double reach) {
  return p.x - std::max(a.x, b.x) > reach || std::min(a.x, b.x) - p.x > reach || p.y - std::max(a.y, b.y) > reach ||
         std::min(a.y, b.y) - p.y > reach;
}

/// How wide the segment is, seen from the point: 0 to 2, one minus the cosine of the angle.
double apparent_width(const Point& eye, const Point& p, const Point& q) {
  const double ux = p.x - eye.x, uy = p.y - eye.y, vx = q.x - eye.x, vy = q.y - eye.y;
  const double lengths = std::sqrt((ux * ux + uy * uy) * (vx * vx + vy * vy));
  return lengths > 0 ? 1 - (ux * vx + uy * vy) / lengths : 0;
}

bool is_within(const Box& box, const Point& p) {
  return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
}

std::uint64_t key_of(Site a, Site b) { return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b); }

double shortest(std::span<const FrontEdge> edges, const std::vector<Point>& places) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : edges) least = std::min(least, distance(places[from], places[to]));
  return least;
}

Box box_of(std::span<const FrontEdge> edges, const std::vector<Point>& places) {
  Box box{places[edges[0].from], places[edges[0].from]};
  for (const auto& [from, to] : edges) box = common_box(box, {places[from], places[from]});
  return box;
}

}  // namespace

LoFront::LoFront(std::vector<Point> places, std::span<const FrontEdge> edges, const SizeField& field)
    : places_(std::move(places)),
      given_faces_(edges.size()),
      field_(field),
      tree_(box_of(edges, places_)),
      least_clearance_(
          std::max(0.1 * std::min(shortest(edges, places_), field.least()), std::ldexp(tree_.least_side(), -20))),
      retreats_left_(edges.size()) {
  for (const FrontEdge& edge : edges) tree_.insert(edge, places_[edge.from], places_[edge.to]);
}

double LoFront::key(const Front& front, Halfedge h) const {
  return distance(places_[front.from_site(h)], places_[front.to_site(h)]);
}

LoFront::Task LoFront::task_of(Site from, Site to) const {
  Task task{.a = places_[from], .b = places_[to], .from = from, .to = to, .length = 0, .side = 0, .ideal = {}};
  task.length = distance(task.a, task.b);
  // The size is asked for where the apex will be, about.
  for (int turn = 0; turn < 2; ++turn) {
    const Point& at = turn == 0 ? places_[from] : task.ideal;
    task.side = std::clamp(field_.at(at), 0.6 * task.length, 1.6 * task.length);
    task.ideal = apex_at(task, 1);
  }
  return task;
}

/// At the share of the height of the ideal triangle.
Point LoFront::apex_at(const Task& task, double share) const {
  const double dx = task.b.x - task.a.x, dy = task.b.y - task.a.y, half = task.length / 2;
  const double height = std::sqrt(std::max(task.side * task.side - half * half, 0.0));
  const double rise = task.length > 0 ? share * height / task.length : 0;
  return {task.a.x + dx / 2 - rise * dy, task.a.y + dy / 2 + rise * dx};
}

/// Gathers what is within `reach` of edge and ideal apex: of the candidates those that have not been gathered before.
void LoFront::look_around(Task& task, double reach) const {
  const Box before = task.box;
  const bool again = std::exchange(task.looked, true);
  task.box = common_box(common_box({task.a, task.a}, {task.b, task.b}), {task.ideal, task.ideal});
  task.box = {{task.box.low.x - reach, task.box.low.y - reach}, {task.box.high.x + reach, task.box.high.y + reach}};
  task.near.clear();
  task.hidden.clear();
  task.candidates.clear();
  tree_.for_each_near(task.box, [&](const FrontEdge& edge) { task.near.push_back(edge); });
  task.looked_at = 0;
  if (!task.shadows.empty()) hide(task);
  for (const auto& [from, to] : task.near) {
    const Point& p = places_[from];
    // Each end of an edge begins another.
    if (is_within(task.box, p) && !(again && is_within(before, p)) && orientation(task.a, task.b, p) > 0)
      task.candidates.push_back(from);
  }
}

/// Whether it lies in one of the shadows: that which hid the last is asked first.
bool LoFront::is_hidden(Task& task, const FrontEdge& edge) const {
  const auto shadow = std::find_if(task.shadows.begin(), task.shadows.end(),
                                   [&](const Shadow& one) { return one.hides(places_[edge.from], places_[edge.to]); });
  if (shadow == task.shadows.end()) return false;
  std::swap(*shadow, task.shadows.front());
  return true;
}

/// Leaves out what lies in shadows.
void LoFront::hide(Task& task) const {
  const auto hidden =
      std::partition(task.near.begin(), task.near.end(), [&](const FrontEdge& edge) { return !is_hidden(task, edge); });
  task.hidden.insert(task.hidden.end(), hidden, task.near.end());
  task.near.erase(hidden, task.near.end());
}

/// Leaves out as much as is worth while.
void LoFront::hide_all(Task& task) const {
  task.looked_at = 0;
  if (task.shadows.empty()) {
    task.shadows.push_back(Shadow::behind(task.a, task.b));
    hide(task);
  }
  while (task.near.size() > few_edges && hide_behind_widest(task)) continue;
}

/// Leaves out what the edges that look widest hide from an end of the task's edge; false where that is less than a quarter, by
/// a sample.
bool LoFront::hide_behind_widest(Task& task) const {
  const Point middle{task.a.x + (task.b.x - task.a.x) / 2, task.a.y + (task.b.y - task.a.y) / 2};
  std::vector<std::pair<double, FrontEdge>> widest;
  for (const FrontEdge& edge : task.near)
    widest.emplace_back(apparent_width(middle, places_[edge.from], places_[edge.to]), edge);
  const auto last = widest.begin() + most_casters;
  std::partial_sort(widest.begin(), last, widest.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  task.shadows.clear();
  for (auto at = widest.begin(); at != last; ++at) {
    const Point &p = places_[at->second.from], &q = places_[at->second.to];
    for (const Point& eye : {task.a, task.b})
      if (orientation(p, q, eye) > 0) task.shadows.push_back(Shadow::cast(eye, p, q));
  }
  const std::size_t step = task.near.size() / few_edges;
  std::size_t of_sample = 0;
  for (std::size_t i = 0; i < few_edges; ++i) of_sample += is_hidden(task, task.near[i * step]);
  if (4 * of_sample < few_edges) return false;
  hide(task);
  return true;
}

/// Whether an edge of the front reaches into the triangle of the task's edge and an apex, a site or a new point.
bool LoFront::reaches_into(const FrontEdge& edge, const Task& task, const Point& apex, std::optional<Site> site) const {
  const Point &p = places_[edge.from], &q = places_[edge.to];
  if (std::max(p.x, q.x) < std::min({task.a.x, task.b.x, apex.x}) ||
      std::min(p.x, q.x) > std::max({task.a.x, task.b.x, apex.x}) ||
      std::max(p.y, q.y) < std::min({task.a.y, task.b.y, apex.y}) ||
      std::min(p.y, q.y) > std::max({task.a.y, task.b.y, apex.y}))
    return false;
  const auto holds = [&](Site end, const Point& at) {
    return end != task.from && end != task.to && end != site && orientation(task.a, task.b, at) >= 0 &&
           orientation(task.b, apex, at) >= 0 && orientation(apex, task.a, at) >= 0;
  };
  // Each end of an edge begins another, so that one of them is enough; but that one may have been left out.
  if (holds(edge.from, p) || (!task.hidden.empty() && holds(edge.to, q))) return true;
  if (cross(p, q, task.b, apex) || cross(p, q, task.a, apex)) return true;
  // A new point might lie on an edge. A site does not: fronts do not touch themselves.
  return !site && orientation(p, q, apex) == 0 && std::min(p, q) <= apex && apex <= std::max(p, q);
}

/// Whether one of the edges does that reached into the last triangles.
bool LoFront::is_known_blocked(Task& task, Site site) const {
  const auto blocker = std::find_if(task.blockers.begin(), task.blockers.end(), [&](const FrontEdge& edge) {
    return reaches_into(edge, task, places_[site], site);
  });
  if (blocker == task.blockers.end()) return false;
  std::rotate(task.blockers.begin(), blocker, blocker + 1);
  return true;
}

/// Whether the triangle of the edge and an apex within the box, a site or a new point, is empty.
bool LoFront::is_free(Task& task, const Point& apex, std::optional<Site> site) const {
  const auto blocker = std::find_if(task.near.begin(), task.near.end(),
                                    [&](const FrontEdge& edge) { return reaches_into(edge, task, apex, site); });
  compared_ += static_cast<std::size_t>(blocker - task.near.begin());
  if (blocker == task.near.end()) return true;
  if (task.blockers.size() == most_blockers) task.blockers.pop_back();
  task.blockers.insert(task.blockers.begin(), *blocker);
  task.looked_at += static_cast<std::size_t>(blocker - task.near.begin());
  if (task.near.size() > few_edges && task.looked_at > most_looks * task.near.size()) hide_all(task);
  return false;
}

/// The first of the candidates, least number first, that makes an empty triangle. Only as much is sorted as is looked at, and
/// what the known blockers hide goes in one sweep now and then: of many candidates most are hidden by few edges.
std::optional<LoFront::Ranked> LoFront::first_free(Task& task, std::vector<Ranked>& order) const {
  const auto later = [](const Ranked& a, const Ranked& b) { return b < a; };
  std::make_heap(order.begin(), order.end(), later);
  for (std::size_t tried = 1, sweep = 8; !order.empty(); ++tried) {
    std::pop_heap(order.begin(), order.end(), later);
    const Ranked first = order.back();
    order.pop_back();
    if (!is_known_blocked(task, first.second) && is_free(task, places_[first.second], first.second)) return first;
    if (tried < sweep) continue;
    sweep *= 2;
    std::erase_if(order, [&](const Ranked& other) { return is_known_blocked(task, other.second); });
    std::make_heap(order.begin(), order.end(), later);
  }
  return std::nullopt;
}

/// The nearest point of the front that can take the place of the ideal apex.
std::optional<Site> LoFront::near_ideal(Task& task, double reach) const {
  std::vector<Ranked> order;
  for (const Site s : task.candidates)
    if (const double far = distance(places_[s], task.ideal); far <= reach) order.emplace_back(far, s);
  const auto nearest = first_free(task, order);
  return nearest ? std::optional(nearest->second) : std::nullopt;
}

/// Of the points of the front in the box that which makes the best triangle.
std::optional<LoFront::Choice> LoFront::best_of(Task& task) const {
  std::vector<Ranked> order;
  for (const Site s : task.candidates)
    if (!is_known_blocked(task, s)) order.emplace_back(-shape_quality(task.a, task.b, places_[s]), s);
  const auto best = first_free(task, order);
  return best ? std::optional(Choice{best->second, -best->first}) : std::nullopt;
}

/// Of the ends of the edges beside it on the front that which makes the better triangle.
std::optional<LoFront::Choice> LoFront::corner_of(const Front& front, Halfedge h, Task& task) const {
  task.candidates.clear();
  Box box = common_box({task.a, task.a}, {task.b, task.b});
  const meshops::Connectivity& mesh = front.mesh();
  for (const Site s : {front.from_site(mesh.prev_halfedge_handle(h)), front.to_site(mesh.next_halfedge_handle(h))}) {
    if (orientation(task.a, task.b, places_[s]) <= 0) continue;
    task.candidates.push_back(s);
    box = common_box(box, {places_[s], places_[s]});
  }
  if (task.candidates.empty()) return std::nullopt;
  task.near.clear();
  task.hidden.clear();
  tree_.for_each_near(box, [&](const FrontEdge& edge) { task.near.push_back(edge); });
  return best_of(task);
}

/// A new apex, if it is as clear of the front as that.
std::optional<Point> LoFront::placed(Task& task, double share, double wanted) const {
  const Point apex = apex_at(task, share);
  const double least = std::max(wanted * task.side, least_clearance_);
  if (!is_finite(apex) || orientation(task.a, task.b, apex) <= 0) return std::nullopt;
  for (const std::vector<FrontEdge>* edges : {&task.near, &task.hidden})
    for (const auto& [from, to] : *edges)
      if (!is_surely_clear(apex, places_[from], places_[to], 2 * least) &&
          !(distance(apex, places_[from], places_[to]) >= least))
        return std::nullopt;
  if (!is_free(task, apex, std::nullopt)) return std::nullopt;
  return apex;
}

meshops::Proposal LoFront::propose(const Front& front, Halfedge h) {
  places_.resize(front.sites());
  Task task = task_of(front.from_site(h), front.to_site(h));
  const bool again = retreated_from_.contains(key_of(task.from, task.to));
  look_around(task, task.side);
  // Where the front has been before, it rather closes than that it does the same again.
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
  for (double reach = std::max(2 * task.side, tree_.least_side()); !best; reach *= looks < near_looks ? 2 : far_step) {
    if (looks == near_looks) best = corner_of(front, h, task);
    if (best) break;
    look_around(task, reach);
    best = best_of(task);
    if (!best && tree_.is_within(task.box)) return std::nullopt;  // which cannot be
    ++looks;
  }
  // What is as far as that is no nearer from behind.
  const bool is_far = looks >= near_looks;
  if (!is_far && best->quality < bad && !again && retreats_left_ > 0) {
    if (const auto face = behind(front, h)) {
      retreated_from_.insert(key_of(task.from, task.to));
      --retreats_left_;
      ++retreated_;
      return meshops::Proposal::detach(*face);
    }
  }
  return best->apex;
}

/// A triangle that can go, behind the edge or behind its neighbours on the front.
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
  for (const Halfedge side : triangle.side) {
    const Site from = front.from_site(side), to = front.to_site(side);
    if (front.mesh().is_boundary(front.mesh().opposite_halfedge_handle(side)))
      tree_.insert({to, from}, places_[to], places_[from]);
    else
      tree_.erase({from, to}, places_[from], places_[to]);
  }
}

void LoFront::detached(const meshops::DetachedTriangle& triangle) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Site from = triangle.corners[i], to = triangle.corners[(i + 1) % 3];
    if (triangle.side[i].is_valid())
      tree_.insert({from, to}, places_[from], places_[to]);
    else
      tree_.erase({to, from}, places_[to], places_[from]);
  }
}

}  // namespace rbpa
