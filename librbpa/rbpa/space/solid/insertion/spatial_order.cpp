#include "rbpa/space/solid/insertion/spatial_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <tuple>
#include <utility>

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
  Sorter(std::span<const Point3> points, std::span<const Point3> scaled, const Checkpoint& checkpoint)
      : points_(points), scaled_(scaled), checkpoint_(checkpoint) {}

  void sort(std::span<Place> places) {
    if (checkpoint_) checkpoint_();
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
    for (Place& place : places) {
      const Point3& p = scaled_[place.index];
      place.key = hilbert_index(cell(p.x, low.x), cell(p.y, low.y), cell(p.z, low.z), levels);
    }
    std::sort(places.begin(), places.end(),
              [](const Place& a, const Place& b) { return std::tie(a.key, a.index) < std::tie(b.key, b.index); });
    for (std::size_t first = 0, last; first < places.size(); first = last) {
      last = first + 1;
      while (last < places.size() && places[last].key == places[first].key) ++last;
      if (last - first > 1) sort(places.subspan(first, last - first));
    }
  }

 private:
  /// Sorts by coordinates, so that equal points are adjacent, the lowest index first.
  void sort_by_coordinates(std::span<Place> places) const {
    std::sort(places.begin(), places.end(), [&](const Place& a, const Place& b) {
      const Point3 &p = points_[a.index], &q = points_[b.index];
      return p < q || (p == q && a.index < b.index);
    });
  }

  std::span<const Point3> points_, scaled_;
  const Checkpoint& checkpoint_;
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
                                          const Checkpoint& checkpoint) {
  std::vector<Place> places(points.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i].index = static_cast<std::uint32_t>(i);
  Sorter(points, scaled, checkpoint).sort(places);
  std::vector<std::uint32_t> order(places.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = places[i].index;
  return order;
}

SpatialOrder spatial_order(std::span<const Point3> points, std::span<const Point3> scaled,
                           const Checkpoint& checkpoint) {
  SpatialOrder result;
  std::vector<std::uint32_t> on_curve;
  on_curve.reserve(points.size());
  std::array<std::size_t, 64 / bits_of_round + 1> in_round{};
  for (const std::uint32_t index : order_on_curve(points, scaled, checkpoint)) {
    if (!on_curve.empty() && points[on_curve.back()] == points[index]) {
      result.duplicates.push_back({index, on_curve.back()});
      continue;
    }
    ++in_round[round_of(on_curve.size())];
    on_curve.push_back(index);
  }
  std::sort(result.duplicates.begin(), result.duplicates.end(),
            [](const Duplicate& d, const Duplicate& e) { return d.index < e.index; });

  std::size_t start = 0;
  for (std::size_t round = in_round.size(); round-- > 0;) start += std::exchange(in_round[round], start);
  result.order.resize(on_curve.size());
  for (std::size_t i = 0; i < on_curve.size(); ++i) result.order[in_round[round_of(i)]++] = on_curve[i];
  return result;
}

}  // namespace rbpa::space
