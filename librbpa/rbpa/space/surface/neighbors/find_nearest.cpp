#include "rbpa/space/surface/neighbors/find_nearest.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <mutex>
#include <nanoflann.hpp>
#include <numbers>
#include <numeric>
#include <type_traits>
#include <utility>

namespace rbpa::space {
namespace {

/// A long double in memory that is aligned for double, as the memory of nanoflann is.
class Unaligned {
 public:
  Unaligned(long double value = 0) { std::memcpy(bytes_.data(), &value, sizeof value); }
  operator long double() const {
    long double value;
    std::memcpy(&value, bytes_.data(), sizeof value);
    return value;
  }
  Unaligned& operator+=(const Unaligned& other) { return *this = Unaligned(*this + static_cast<long double>(other)); }

 private:
  std::array<std::byte, sizeof(long double)> bytes_;
};

template <typename Real>
using Stored = std::conditional_t<std::is_same_v<Real, double>, double, Unaligned>;

/// The interface to a point set that nanoflann requires.
template <typename Real>
struct Cloud {
  std::vector<Point3>& points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  Stored<Real> kdtree_get_pt(std::size_t i, std::size_t axis) const {
    const Point3& p = points[i];
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
  }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const {
    return false;  // the tree computes its own box
  }
};

template <typename Real>
using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<Stored<Real>, Cloud<Real>>, Cloud<Real>,
                                                 3, std::uint32_t>;

/// The nearest points found up to now, without the query point. Unlike in the result set of nanoflann, the order in
/// which points at equal distances are found does not matter.
template <typename Real>
class Nearest {
 public:
  using DistanceType = Stored<Real>;
  Nearest(const std::vector<Point3>& points, std::size_t count) : points_(points), found_(count) {}

  void begin(std::uint32_t self) {
    self_ = self;
    size_ = 0;
  }
  std::uint32_t operator[](std::size_t i) const { return found_[i].point; }
  Real square(std::size_t i) const { return found_[i].distance; }  ///< squared distance
  std::size_t size() const { return size_; }

  bool full() const { return size_ == found_.size(); }
  /// Returns the distance from which on the tree skips points. It is slightly more than the farthest distance, because
  /// the tree rounds its bounds and must not skip equal distances.
  DistanceType worstDist() const {
    return full() ? found_.back().distance * (1 + Real(0x1p-40)) : std::numeric_limits<Real>::infinity();
  }
  bool addPoint(Real distance, std::uint32_t point) {
    const Found next = {distance, point};
    if (point == self_ || (full() && !is_before(next, found_.back()))) return true;
    std::size_t i = full() ? size_ - 1 : size_++;
    for (; i > 0 && is_before(next, found_[i - 1]); --i) found_[i] = found_[i - 1];
    found_[i] = next;
    return true;
  }

 private:
  struct Found {
    Real distance;
    std::uint32_t point;
  };
  bool is_before(const Found& p, const Found& q) const {
    return p.distance != q.distance ? p.distance < q.distance : points_[p.point] < points_[q.point];
  }

  const std::vector<Point3>& points_;
  std::uint32_t self_ = 0;
  std::size_t size_ = 0;
  std::vector<Found> found_;
};

/// Sorts the points by the leaves of the tree: points of a leaf become adjacent. Returns each point's new position.
template <typename Real>
std::vector<std::uint32_t> follow_leaves(Cloud<Real>& cloud, Tree<Real>& tree) {
  std::vector<Point3> in_order(cloud.points.size());
  std::vector<std::uint32_t> place(cloud.points.size());
  for (std::size_t i = 0; i < in_order.size(); ++i) {
    in_order[i] = cloud.points[tree.vAcc[i]];
    place[tree.vAcc[i]] = static_cast<std::uint32_t>(i);
  }
  cloud.points = std::move(in_order);
  std::iota(tree.vAcc.begin(), tree.vAcc.end(), std::uint32_t{0});
  return place;
}

template <typename Real>
Real square_between(const Point3& p, const Point3& q) {
  const Real x = Real(q.x) - Real(p.x), y = Real(q.y) - Real(p.y), z = Real(q.z) - Real(p.z);
  return x * x + y * y + z * z;
}

/// Fills `chosen`. The two nearest points come first, which keep neighbors on a line connected. Then come points whose
/// distance from all chosen points is at least the spacing of as many evenly spread points in the disc; then points at
/// half that spacing, and so on.
template <typename Real>
void choose_spread(const std::vector<Point3>& points, const Nearest<Real>& nearest, std::span<std::uint32_t> chosen) {
  std::vector<bool> is_chosen(nearest.size(), false);
  std::vector<std::size_t> places;
  const auto choose = [&](std::size_t k) {
    is_chosen[k] = true;
    places.push_back(k);
  };
  for (std::size_t k = 0; k < std::min<std::size_t>(2, chosen.size()); ++k) choose(k);
  // Squared spacing · number of points / squared radius of the disc. Points at this spacing leave few gaps in the disc,
  // and hardly more than that number of points find room.
  constexpr Real spread = 2.56;
  Real least = spread * nearest.square(nearest.size() - 1) / static_cast<Real>(chosen.size());
  for (; places.size() < chosen.size(); least /= 4)
    for (std::size_t k = 0; k < nearest.size() && places.size() < chosen.size(); ++k) {
      if (is_chosen[k]) continue;
      const Point3& p = points[nearest[k]];
      const auto is_near = [&](std::size_t j) { return square_between<Real>(p, points[nearest[j]]) < least; };
      if (std::none_of(places.begin(), places.end(), is_near)) choose(k);
    }
  std::sort(places.begin(), places.end());
  for (std::size_t k = 0; k < chosen.size(); ++k) chosen[k] = nearest[places[k]];
}

}  // namespace

template <typename Real>
Neighborhoods find_nearest(std::vector<Point3> points, std::size_t count, Threads& threads, const Checkpoint& go_on,
                           const SpansPlane& spans_plane) {
  constexpr std::size_t points_at_a_time = 1024;
  Neighborhoods found;
  found.points = std::move(points);
  Cloud<Real> cloud{found.points};
  Tree<Real> tree(3, cloud);
  found.place = follow_leaves(cloud, tree);
  const std::size_t others = found.points.size() - 1;
  found.count = std::min(count, others);
  found.nearest.resize(found.count * found.points.size());
  std::mutex one_call;
  for_each_part(threads, found.points.size(), points_at_a_time, [&](std::size_t first, std::size_t last) {
    const auto find = [&](Nearest<Real>& nearest, std::size_t i) {
      const Point3& p = found.points[i];
      const std::array<Stored<Real>, 3> at = {p.x, p.y, p.z};
      nearest.begin(static_cast<std::uint32_t>(i));
      tree.findNeighbors(nearest, at.data(), {});
    };
    Nearest<Real> nearest(found.points, found.count);
    for (std::size_t i = first; i < last; ++i) {
      const std::span around = std::span(found.nearest).subspan(i * found.count, found.count);
      if (found.count > 0) find(nearest, i);
      for (std::size_t k = 0; k < found.count; ++k) around[k] = nearest[k];
      if (!spans_plane) continue;
      bool spans = spans_plane(found, i);
      bool is_changed = false;
      for (std::size_t wider = 8; wider <= 16 && !spans && wider / 2 * found.count < others; wider *= 2) {
        Nearest<Real> far(found.points, std::min(wider * found.count, others));
        find(far, i);
        choose_spread(found.points, far, around);
        is_changed = true;
        spans = spans_plane(found, i);
      }
      if (spans || !is_changed) continue;
      for (std::size_t k = 0; k < found.count; ++k) around[k] = nearest[k];
      spans_plane(found, i);
    }
    if (!go_on) return;
    const std::lock_guard lock(one_call);
    go_on();
  });
  return found;
}

double spacing_of(const Neighborhoods& near) {
  std::vector<double> spacings;
  for (std::size_t i = 0; i < near.points.size(); ++i) {
    const Point3 &p = near.points[i], &q = near.points[near.around(i).back()];
    const double x = q.x - p.x, y = q.y - p.y, z = q.z - p.z;
    spacings.push_back(std::sqrt((x * x + y * y + z * z) * std::numbers::pi / static_cast<double>(near.count + 1)));
  }
  const auto median = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), median, spacings.end());
  return *median;
}

template Neighborhoods find_nearest<double>(std::vector<Point3>, std::size_t, Threads&, const Checkpoint&,
                                            const SpansPlane&);
template Neighborhoods find_nearest<long double>(std::vector<Point3>, std::size_t, Threads&, const Checkpoint&,
                                                 const SpansPlane&);

}  // namespace rbpa::space
