#include "rbpa/space/solid/insertion/spatial_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <mutex>
#include <tuple>
#include <utility>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/error.h"
#include "rbpa/base/sort/distribute.h"
#include "rbpa/space/predicate/bounding_box.h"
#include "rbpa/space/solid/insertion/hilbert.h"

namespace rbpa::space {
namespace {

/// A point with its position on the curve.
struct Place {
  std::uint64_t key;
  std::uint32_t index;
};

constexpr int max_levels = 21;
constexpr unsigned bits_of_round = 3;  // each round has eight times the points of the previous one

/// Sorts points along the curve recursively: cells with several points get curves of their own.
class Sorter {
 public:
  Sorter(std::span<const Point3> points, std::span<const Point3> scaled, Threads& threads, const Checkpoint& checkpoint)
      : points_(points), scaled_(scaled), threads_(threads), checkpoint_(checkpoint) {}

  /// Sorts all points, in several threads if there are many.
  void sort(std::span<Place> places) {
    Threads one(1);
    sort(places, places.size() < many ? one : threads_);
  }

 private:
  void sort(std::span<Place> places, Threads& threads) {
    if (checkpoint_) {
      const std::lock_guard<std::mutex> lock(one_call_);
      if (std::exchange(is_stopped_, true)) throw Cancelled();
      checkpoint_();
      is_stopped_ = false;
    }
    if (places.size() < 2) return;
    Box box;
    for (const Place& place : places) box.include(scaled_[place.index]);
    const Point3 &low = box.low, &high = box.high;
    const double size = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    if (!(size > 0x1p-1000) || places.size() == 2) return sort_by_coordinates(places);

    // With these levels, few cells have several points where points are spread evenly. More levels would be more work.
    const int levels = std::min(max_levels, static_cast<int>(std::bit_width(places.size())) / 3 + 2);
    const auto cells = static_cast<double>(std::uint32_t{1} << levels);
    const double cells_in_size = cells / size;  // min() in `cell` catches values rounded up beyond the last cell
    const auto cell = [&](double x, double from) {
      return static_cast<std::uint32_t>(std::min((x - from) * cells_in_size, cells - 1));
    };
    for_each_part(threads, places.size(), many, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const Point3& p = scaled_[places[i].index];
        places[i].key = hilbert_index(cell(p.x, low.x), cell(p.y, low.y), cell(p.z, low.z), levels);
      }
    });
    if (places.size() < many) return sort_by_key(places);
    constexpr int levels_of_bucket = 4;
    const meshops::FreshVector<Place> copy(places.begin(), places.end());
    const auto bucket_begin = distribute(
        copy.size(), std::size_t{1} << 3U * levels_of_bucket, many, threads,
        [&](std::size_t i) { return copy[i].key >> 3 * (levels - levels_of_bucket); },
        [&](std::size_t i, std::uint32_t at) { places[at] = copy[i]; });
    for_each_index(threads, bucket_begin.size() - 1, [&](std::size_t i) {
      sort_by_key(places.subspan(bucket_begin[i], bucket_begin[i + 1] - bucket_begin[i]));
    });
  }

  void sort_by_key(std::span<Place> places) {
    std::sort(places.begin(), places.end(),
              [](const Place& a, const Place& b) { return std::tie(a.key, a.index) < std::tie(b.key, b.index); });
    Threads one(1);
    for (std::size_t first = 0, last; first < places.size(); first = last) {
      last = first + 1;
      while (last < places.size() && places[last].key == places[first].key) ++last;
      if (last - first > 1) sort(places.subspan(first, last - first), one);
    }
  }

  /// Sorts by coordinates, so that equal points are adjacent, the lowest index first.
  void sort_by_coordinates(std::span<Place> places) const {
    std::sort(places.begin(), places.end(), [&](const Place& a, const Place& b) {
      const Point3 &p = points_[a.index], &q = points_[b.index];
      return p < q || (p == q && a.index < b.index);
    });
  }

  static constexpr std::size_t many = 1u << 15;
  std::span<const Point3> points_, scaled_;
  Threads& threads_;
  const Checkpoint& checkpoint_;
  std::mutex one_call_;
  bool is_stopped_ = false;  // after checkpoint_() has thrown
};

/// Returns a pseudo-random number. Source: Steele, Lea, Flood, Fast splittable pseudorandom number generators (2014).
std::uint64_t scrambled(std::uint64_t i) {
  i += 0x9e3779b97f4a7c15U;
  i = (i ^ (i >> 30U)) * 0xbf58476d1ce4e5b9U;
  i = (i ^ (i >> 27U)) * 0x94d049bb133111ebU;
  return i ^ (i >> 31U);
}

/// Returns the insertion round of the point at a place on the curve. Rounds descend; 0 is the last one.
unsigned round_of(std::size_t place) {
  return static_cast<unsigned>(std::countr_zero(scrambled(place) | std::uint64_t{1} << 63U)) / bits_of_round;
}

}  // namespace

std::vector<std::uint32_t> order_on_curve(std::span<const Point3> points, std::span<const Point3> scaled,
                                          Threads& threads, const Checkpoint& checkpoint) {
  std::vector<Place> places(points.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i].index = static_cast<std::uint32_t>(i);
  Sorter(points, scaled, threads, checkpoint).sort(places);
  std::vector<std::uint32_t> order(places.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = places[i].index;
  return order;
}

SpatialOrder spatial_order(std::span<const Point3> points, std::span<const Point3> scaled, Threads& threads,
                           const Checkpoint& checkpoint) {
  SpatialOrder result;
  std::vector<std::uint32_t> on_curve = order_on_curve(points, scaled, threads, checkpoint);
  std::vector<std::uint8_t> is_duplicate(on_curve.size());  // of the point before it on the curve
  for_each_part(threads, on_curve.size(), 1u << 15, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = std::max<std::size_t>(first, 1); i < last; ++i)
      is_duplicate[i] = points[on_curve[i]] == points[on_curve[i - 1]];
  });
  std::array<std::size_t, 64 / bits_of_round + 1> in_round{};
  std::size_t distinct = 0;
  for (std::size_t i = 0; i < on_curve.size(); ++i) {
    if (is_duplicate[i] != 0) {
      result.duplicates.push_back({on_curve[i], on_curve[distinct - 1]});
      continue;
    }
    ++in_round[round_of(distinct)];
    on_curve[distinct++] = on_curve[i];
  }
  on_curve.resize(distinct);
  std::sort(result.duplicates.begin(), result.duplicates.end(),
            [](const Duplicate& d, const Duplicate& e) { return d.index < e.index; });

  std::size_t start = 0;
  for (std::size_t round = in_round.size(); round-- > 0;) start += std::exchange(in_round[round], start);
  result.order.resize(on_curve.size());
  result.place.resize(on_curve.size());
  for (std::size_t i = 0; i < on_curve.size(); ++i) {
    const std::size_t at = in_round[round_of(i)]++;
    result.order[at] = on_curve[i];
    result.place[at] = static_cast<std::uint32_t>(i);
  }
  return result;
}

}  // namespace rbpa::space
