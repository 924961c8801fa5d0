#include "rbpa/space/cells/cells.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "rbpa/base/sort/distribute.h"

namespace rbpa::space {
namespace {

/// Numbers of cells along an axis. If coordinates differ by at most two radii, their cells' numbers differ by at most
/// two.
class Numbering {
 public:
  explicit Numbering(double radius) : radius_(radius), inverse_(1 / (radius * (1 + 0x1p-6))) {}

  std::int64_t operator()(double coordinate) const {
    if (const double quotient = coordinate * inverse_; std::abs(quotient) < 0x1p40)
      return static_cast<std::int64_t>(std::floor(quotient));
    const long double quotient = std::floor(coordinate / (radius_ * (1 + 0x1p-6L)));
    if (std::abs(quotient) < 0x1p57L) return static_cast<std::int64_t>(quotient);
    // No other double is within two radii of this coordinate, so only equal coordinates need equal numbers.
    return std::bit_cast<std::int64_t>(coordinate + 0.0);
  }
  std::array<std::int64_t, 3> operator()(const Point3& p) const { return {(*this)(p.x), (*this)(p.y), (*this)(p.z)}; }

 private:
  double radius_, inverse_;
};

using Key = std::array<std::int64_t, 3>;

/// A point, and its cell as one number; these numbers are in the order of keys.
struct Keyed {
  std::uint64_t cell;
  std::uint32_t index;

  friend bool operator<(const Keyed& p, const Keyed& q) {
    return p.cell != q.cell ? p.cell < q.cell : p.index < q.index;
  }
};

constexpr std::size_t at_a_time = 1u << 14;

/// A map from the keys between two corners of a box to integers of bits() bits, in the order of keys.
class Packing {
 public:
  Packing(const Key& low, const Key& high) : low_(low) {
    for (std::size_t i = 0; i < 3; ++i) width_[i] = static_cast<int>(std::bit_width(extent(high, i)));
  }
  int bits() const { return width_[0] + width_[1] + width_[2]; }
  std::uint64_t operator()(const Key& key) const {
    return (extent(key, 0) << (width_[1] + width_[2])) | (extent(key, 1) << width_[2]) | extent(key, 2);
  }

 private:
  std::uint64_t extent(const Key& key, std::size_t i) const {
    return static_cast<std::uint64_t>(key[i]) - static_cast<std::uint64_t>(low_[i]);
  }

  Key low_;
  std::array<int, 3> width_;
};

/// Returns the points sorted by cell, then by index. The highest eleven of `bits` bits are sorted by counting.
std::vector<Keyed> sorted(std::vector<Keyed> input, int bits, Threads& threads) {
  constexpr int digits = 11;
  const std::size_t n = input.size();
  if (n < at_a_time) {
    std::sort(input.begin(), input.end());
    return input;
  }
  const int shift = std::max(0, bits - digits);
  constexpr std::size_t values = std::size_t{1} << digits;
  std::vector<Keyed> output(n);
  const std::vector<std::uint32_t> start = distribute(
      n, values, at_a_time, threads, [&](std::size_t i) { return input[i].cell >> shift; },
      [&](std::size_t i, std::uint32_t at) { output[at] = input[i]; });
  for_each_index(threads, values, [&](std::size_t value) {
    std::sort(output.begin() + start[value], output.begin() + start[value + 1]);
  });
  return output;
}

/// Returns the indices of the points in the order of cells, ascending within a cell.
std::vector<std::uint32_t> by_cell(std::span<const Point3> points, const Numbering& number, Threads& threads) {
  std::vector<Key> least((points.size() + at_a_time - 1) / at_a_time), greatest(least.size());
  for_each_part(threads, points.size(), at_a_time, [&](std::size_t from, std::size_t to) {
    Key low, high;
    low.fill(std::numeric_limits<std::int64_t>::max());
    high.fill(std::numeric_limits<std::int64_t>::min());
    for (std::size_t i = from; i < to; ++i) {
      const Key key = number(points[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], key[k]);
        high[k] = std::max(high[k], key[k]);
      }
    }
    least[from / at_a_time] = low;
    greatest[from / at_a_time] = high;
  });
  std::vector<std::uint32_t> order(points.size());
  if (points.empty()) return order;
  Key low = least[0], high = greatest[0];
  for (std::size_t part = 0; part < least.size(); ++part)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], least[part][k]);
      high[k] = std::max(high[k], greatest[part][k]);
    }

  const Packing packing(low, high);
  if (packing.bits() > 64) {
    std::vector<Key> keys(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) keys[i] = number(points[i]);
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t i, std::uint32_t j) { return keys[i] != keys[j] ? keys[i] < keys[j] : i < j; });
    return order;
  }
  std::vector<Keyed> keyed(points.size());
  for_each_part(threads, points.size(), at_a_time, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) keyed[i] = {packing(number(points[i])), static_cast<std::uint32_t>(i)};
  });
  keyed = sorted(std::move(keyed), packing.bits(), threads);
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = keyed[i].index;
  return order;
}

/// Returns whether two points are equal. Cost: quadratic; for a few points.
bool have_equals(std::span<const Point3> points) {
  for (std::size_t i = 1; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (points[i].x == points[j].x && points[i] == points[j]) return true;
  return false;
}

}  // namespace

Cells::Cells(std::span<const Point3> points, double radius, Threads& threads) : radius_(radius), sites_(points.size()) {
  const Numbering number(radius);
  input_index_ = by_cell(points, number, threads);
  for_each_part(threads, sites_.size(), at_a_time, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) sites_[i] = points[input_index_[i]];
  });
  for (std::size_t i = 0; i < sites_.size(); ++i)
    if (const Key key = number(sites_[i]); cells_.empty() || key != cells_.back().key)
      cells_.push_back({key, static_cast<Site>(i)});
  cells_.push_back({{}, static_cast<Site>(sites_.size())});

  // Sort the points of cells that may have equal ones, so that equal points are adjacent, the lowest index first.
  constexpr std::size_t few = 24, cells_at_a_time = 1024;
  std::vector<std::uint8_t> has_equals((size() + cells_at_a_time - 1) / cells_at_a_time, 0);
  for_each_part(threads, size(), cells_at_a_time, [&](std::size_t from, std::size_t to) {
    std::vector<std::uint32_t> order;
    for (std::size_t cell = from; cell < to; ++cell) {
      const Site first = first_in(cell), last = first_in(cell + 1);
      const std::span<Point3> sites(sites_.data() + first, last - first);
      if (sites.size() <= few && !have_equals(sites)) continue;
      const std::span<std::uint32_t> indices(input_index_.data() + first, last - first);
      std::sort(indices.begin(), indices.end(), [&](std::uint32_t i, std::uint32_t j) {
        return points[i] != points[j] ? points[i] < points[j] : i < j;
      });
      for (std::size_t i = 0; i < sites.size(); ++i) sites[i] = points[indices[i]];
      if (std::adjacent_find(sites.begin(), sites.end()) != sites.end()) has_equals[from / cells_at_a_time] = 1;
    }
  });
  if (std::find(has_equals.begin(), has_equals.end(), 1) == has_equals.end()) return;
  Site count = 0;
  for (std::size_t cell = 0; cell < size(); ++cell) {
    const Site first = first_in(cell), last = first_in(cell + 1);
    cells_[cell].first = count;
    for (Site i = first; i < last; ++i) {
      if (i != first && sites_[i] == sites_[count - 1]) {
        equals_.push_back({count - 1, input_index_[i]});
        continue;
      }
      sites_[count] = sites_[i];
      input_index_[count++] = input_index_[i];
    }
  }
  cells_.back().first = count;
  sites_.resize(count);
  input_index_.resize(count);
}

std::vector<Duplicate> Cells::duplicates() const {
  std::vector<Duplicate> all;
  for (const auto& [site, index] : equals_) all.push_back({index, input_index_[site]});
  std::sort(all.begin(), all.end(), [](const Duplicate& d, const Duplicate& e) { return d.index < e.index; });
  return all;
}

std::size_t Cells::cell_of(Site site) const {
  const auto next = std::upper_bound(cells_.begin(), cells_.end(), site,
                                     [](Site wanted, const Cell& cell) { return wanted < cell.first; });
  return static_cast<std::size_t>(next - cells_.begin()) - 1;
}

std::size_t Cells::first_not_before(const Key& key, std::size_t from) const {
  // In ascending queries, the wanted cell is usually a few steps ahead, so these are tried before a binary search.
  constexpr std::size_t steps = 16;
  for (std::size_t step = 0; step < steps; ++step, ++from)
    if (from == size() || !(cells_[from].key < key)) return from;
  const auto found = std::lower_bound(cells_.begin() + static_cast<std::ptrdiff_t>(from), cells_.end() - 1, key,
                                      [](const Cell& cell, const Key& wanted) { return cell.key < wanted; });
  return static_cast<std::size_t>(found - cells_.begin());
}

}  // namespace rbpa::space
