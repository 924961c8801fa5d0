#include "rbpa/space/balls/periodic/periodic_regular.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "rbpa/base/error.h"
#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/space/balls/periodic/cell_axes.h"

namespace rbpa::space {
namespace {

using Row = std::array<std::uint32_t, 4>;
constexpr std::array<double Point3::*, 3> coordinates = {&Point3::x, &Point3::y, &Point3::z};
constexpr Boxes in_cell = {0, 0, 0};
constexpr double most_images = 0x1p26;

/// The translations by which a cell repeats. Edges and wrapped points are multiples of a step along each axis of space,
/// so that the images of a wrapped point, up to CellAxes::most_layers away, are doubles.
class Lattice {
 public:
  explicit Lattice(const RepeatingCell& cell) : edges_(cell.edges), axes_(cell) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double sum = 0;
      for (const Point3& edge : edges_) sum += std::abs(edge.*coordinates[axis]);
      if (!(sum >= 0x1p-900 && sum <= 0x1p900))
        throw InvalidInput("found a cell with edges beyond 2^-900 to 2^900, expected edges within");
      int exponent = 0;
      std::frexp(sum, &exponent);
      step_[axis] = std::ldexp(1.0, exponent + 7 - 53);  // 2⁷ > CellAxes::most_layers + 2
    }
    for (Point3& edge : edges_) edge = rounded(edge);
    shorten();
    axes_ = CellAxes({edges_});
  }

  const CellAxes& axes() const { return axes_; }
  double volume() const { return RepeatingCell{edges_}.volume(); }
  const std::array<std::array<std::int64_t, 3>, 3>& sums() const { return sums_; }

  /// Returns an image of p in the cell, up to rounding. Throws InvalidInput that names center i if p is too far away.
  Point3 wrapped(const Point3& p, std::size_t i) const {
    Boxes offset{};
    for (std::size_t k = 0; k < 3; ++k) offset[k] = -CellAxes::whole(axes_.along(p)[k], i);
    return rounded(moved(p, offset));
  }
  /// Returns p moved by numbers of edges. Exact for a wrapped point and at most CellAxes::most_layers of each edge.
  Point3 moved(const Point3& p, const Boxes& offset) const { return space::moved(p, edges_, offset); }

 private:
  Point3 rounded(Point3 p) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double& x = p.*coordinates[axis];
      x = std::nearbyint(x / step_[axis]) * step_[axis] + 0.0;  // no −0
    }
    return p;
  }

  /// Subtracts multiples of edges from others while these become shorter, so that few layers are required. Exact.
  void shorten() {
    const auto product = [](const Point3& p, const Point3& q) {
      return dot(Vector3<double>{p.x, p.y, p.z}, {q.x, q.y, q.z});
    };
    for (std::size_t unchanged = 0; unchanged < 9;)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j, ++unchanged) {
          const double times = std::nearbyint(product(edges_[i], edges_[j]) / product(edges_[j], edges_[j]));
          if (i == j || !(std::abs(times) < 0x1p30)) continue;
          Boxes offset{};
          offset[j] = -static_cast<std::int32_t>(times);
          const Point3 shorter = moved(edges_[i], offset);
          if (!(product(shorter, shorter) < product(edges_[i], edges_[i]))) continue;
          edges_[i] = shorter;
          for (std::size_t k = 0; k < 3; ++k) sums_[i][k] += offset[j] * sums_[j][k];
          unchanged = 0;
        }
  }

  std::array<Point3, 3> edges_;
  std::array<std::array<std::int64_t, 3>, 3> sums_ = {
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // edges_ in edges of the cell
  CellAxes axes_;
  std::array<double, 3> step_{};
};

class CellFinder {
 public:
  CellFinder(std::span<const Point3> centers, std::span<const double> radii, const RepeatingCell& cell)
      : lattice_(cell) {
    std::vector<Point3> places;
    for (std::size_t i = 0; i < centers.size(); ++i) places.push_back(lattice_.wrapped(centers[i], i));
    order_.resize(centers.size());
    std::iota(order_.begin(), order_.end(), 0U);
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t i, std::uint32_t j) {
      return std::tuple(places[i], -radii[i], i) < std::tuple(places[j], -radii[j], j);
    });
    for (const std::uint32_t i : order_) {
      places_.push_back(places[i]);
      radii_.push_back(radii[i]);
    }
  }

  PeriodicRegular find(double least_margin, const SolidOptions& options) {
    constexpr double spacings = 4;  // enough if balls are distributed evenly
    const auto [low, high] = std::minmax_element(radii_.begin(), radii_.end());
    const double spacing = std::cbrt(lattice_.volume() / static_cast<double>(places_.size()));
    for (double margin = std::max(least_margin, spacings * spacing + (*high - *low));; margin *= 1.5) {
      found_ = {};
      found_.margin = margin;
      add_images();
      found_.cells = regular_triangulation(found_.centers, found_.radii,
                                           {.threads = options.threads, .progress = options.progress});
      if (is_linked()) break;
    }
    found_.edges = lattice_.sums();
    for (std::uint32_t& ball : found_.ball) ball = order_[ball];
    return std::move(found_);
  }

 private:
  /// The images of a ball, ascending by offset.
  struct Copies {
    std::uint32_t first;
    Boxes low, high;
  };

  /// Adds the balls of the cell and their images within the margin, in ascending order of places_ and offsets.
  void add_images() {
    copies_.clear();
    for (std::uint32_t i = 0; i < places_.size(); ++i) {
      Copies& copies = copies_.emplace_back();
      copies.first = static_cast<std::uint32_t>(found_.ball.size());
      const std::array<double, 3> along = lattice_.axes().along(places_[i]);
      double count = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        const double reach = found_.margin * lattice_.axes().per_length(k) + 0x1p-30;
        count *= reach < CellAxes::most_layers - 2 ? 2 * reach + 2 : most_images;
        if (!(copies.first + count < most_images))
          throw InvalidInput(
              "found a cell so flat, or with balls so few, that more than 100 images along an edge, or 2^26 in all, "
              "are "
              "required, expected a cell of several such cells");
        copies.low[k] = static_cast<std::int32_t>(std::ceil(-reach - along[k]));
        copies.high[k] = static_cast<std::int32_t>(std::floor(1 + reach - along[k]));
      }
      Boxes offset{};
      for (offset[0] = copies.low[0]; offset[0] <= copies.high[0]; ++offset[0])
        for (offset[1] = copies.low[1]; offset[1] <= copies.high[1]; ++offset[1])
          for (offset[2] = copies.low[2]; offset[2] <= copies.high[2]; ++offset[2]) {
            found_.ball.push_back(i);
            found_.offsets.push_back(offset);
            found_.centers.push_back(lattice_.moved(places_[i], offset));
            found_.radii.push_back(radii_[i]);
          }
    }
  }

  bool is_in_cell(std::uint32_t image) const { return found_.offsets[image] == in_cell; }

  /// Returns the number of an image, or PeriodicRegular::none if it is not within the margin.
  std::uint32_t number_of(std::uint32_t ball, const Boxes& offset) const {
    const Copies& copies = copies_[ball];
    std::uint32_t number = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (offset[k] < copies.low[k] || offset[k] > copies.high[k]) return PeriodicRegular::none;
      number = number * static_cast<std::uint32_t>(copies.high[k] - copies.low[k] + 1) +
               static_cast<std::uint32_t>(offset[k] - copies.low[k]);
    }
    return copies.first + number;
  }

  /// Returns the kept tetrahedron of which a tetrahedron is an image. Images have their corners in the same order.
  TetrahedronImage image_of(std::uint32_t t) const {
    Row row = found_.cells.simplices[t];
    const Boxes moved = found_.offsets[row[0]];
    for (std::uint32_t& corner : row) {
      corner = number_of(found_.ball[corner], minus(found_.offsets[corner], moved));
      if (corner == PeriodicRegular::none) return {};
    }
    const auto at = std::lower_bound(kept_rows_.begin(), kept_rows_.end(), row);
    if (at == kept_rows_.end() || *at != row) return {};
    return {static_cast<std::uint32_t>(at - kept_rows_.begin()), moved};
  }

  /// Keeps the tetrahedra whose first corner is in the cell. Returns whether they are the triangulation.
  bool is_linked() {
    const auto& [simplices, neighbors] = std::tie(found_.cells.simplices, found_.cells.neighbors);
    kept_rows_.clear();
    ExactSum volumes;
    for (std::uint32_t t = 0; t < simplices.size(); ++t) {
      if (!is_in_cell(simplices[t][0])) continue;
      found_.kept.push_back(t);
      kept_rows_.push_back(simplices[t]);
      volumes.add(volume<double>(found_.centers, simplices[t]) / lattice_.volume());
    }
    if (!(std::abs(volumes.rounded() - 1) < 0.5)) return false;
    return has_stars() && has_neighbors();
  }

  /// Finds the images of the tetrahedra at balls in the cell. Returns whether all are images of kept ones.
  bool has_stars() {
    found_.kept_as.assign(found_.cells.simplices.size(), PeriodicRegular::none);
    for (std::uint32_t t = 0; t < found_.kept_as.size(); ++t) {
      const Row &row = found_.cells.simplices[t], &beyond = found_.cells.neighbors[t];
      if (std::none_of(row.begin(), row.end(), [&](std::uint32_t corner) { return is_in_cell(corner); })) continue;
      found_.kept_as[t] = image_of(t).t;
      if (found_.kept_as[t] == PeriodicRegular::none ||
          std::find(beyond.begin(), beyond.end(), PeriodicRegular::none) != beyond.end())
        return false;
    }
    return true;
  }

  /// Finds the neighbors of the kept tetrahedra. Returns whether they are images of kept ones that agree.
  bool has_neighbors() {
    for (const std::uint32_t t : found_.kept) {
      auto& row = found_.neighbors.emplace_back();
      for (std::size_t k = 0; k < 4; ++k) {
        row[k] = image_of(found_.cells.neighbors[t][k]);
        if (row[k].t == PeriodicRegular::none) return false;
      }
    }
    for (std::uint32_t i = 0; i < found_.kept.size(); ++i)
      for (const TetrahedronImage& beyond : found_.neighbors[i]) {
        const auto& back = found_.neighbors[beyond.t];
        const auto is_back = [&](const TetrahedronImage& other) {
          return other.t == i && other.moved == minus(in_cell, beyond.moved);
        };
        if (std::none_of(back.begin(), back.end(), is_back)) return false;
      }
    return true;
  }

  Lattice lattice_;
  std::vector<std::uint32_t> order_;  // input ball of each of the following
  std::vector<Point3> places_;        // wrapped centers; ascending
  std::vector<double> radii_;
  std::vector<Copies> copies_;
  std::vector<Row> kept_rows_;  // the kept tetrahedra, ascending
  PeriodicRegular found_;       // `ball` has positions in order_
};

}  // namespace

PeriodicRegular periodic_regular(std::span<const Point3> centers, std::span<const double> radii,
                                 const RepeatingCell& cell, double least_margin, const SolidOptions& options) {
  return CellFinder(centers, radii, cell).find(least_margin, options);
}

}  // namespace rbpa::space
