#include "rbpa/space/repair/closing/least_triangulation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "rbpa/space/predicate/orientation.h"

namespace rbpa::space {
namespace {

constexpr std::uint32_t no_corner = 0xffffffff;
constexpr float impossible = 8;  // a turn greater than any possible one

/// A triangle of places: its unit normal and area.
struct Facet {
  Vector unit;
  double area;
};

class Search {
 public:
  Search(const Rim& rim, const Chords& chords, std::span<const RimTriangle> forbidden, meshops::Steps& step)
      : rim_(rim),
        chords_(chords),
        forbidden_(forbidden),
        step_(step),
        last_(static_cast<std::uint32_t>(rim.size()) - 1),
        parts_(chords.size()),
        from_(chords.size()),
        to_(chords.size()),
        around_(rim.size() + 1) {
    // Twice the vector area of a part is a sum along the rim plus one product at its chord.
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Vector product = cross(rim.places[i], rim.places[(i + 1) % rim.size()]);
      around_[i + 1] = {around_[i].x + product.x, around_[i].y + product.y, around_[i].z + product.z};
    }
  }

  std::optional<RimFilling> run() {
    find_least_turns();
    // Parts of fewer corners come first.
    std::vector<std::uint32_t> first(rim_.size() + 1, 0), order(chords_.size());
    for (std::size_t c = 0; c < chords_.size(); ++c) ++first[chords_[c].second - chords_[c].first + 1];
    for (std::size_t span = 1; span < first.size(); ++span) first[span] += first[span - 1];
    for (std::uint32_t c = 0; c < chords_.size(); ++c) order[first[chords_[c].second - chords_[c].first]++] = c;
    for (const std::uint32_t c : order) settle(c);
    const std::uint32_t root = chords_.number_of({0, last_});
    if (from_.turn[root] == impossible) return std::nullopt;
    return filling_behind(root);
  }

 private:
  /// The best triangulation of the part behind a chord.
  struct Part {
    Vector unit{};                   // normal of the triangle at the chord
    std::uint32_t apex = no_corner;  // third corner of that triangle; no_corner for a side of the rim
    float least = 0;                 // lower bound of the turn of any triangulation of the part
  };
  /// Weights of the parts, by the number or by the place of their chords.
  struct Weights {
    explicit Weights(std::size_t size) : turn(size, 0), area(size, 0) {}
    std::vector<float> turn;
    std::vector<double> area;
  };
  /// The best triangulation of a part among those that were tried, and the bound at which the search ends.
  struct Best {
    FillingWeight weight{.turn = impossible, .area = 0};
    Part part{};
    double enough = -1;  // lower bound of the area; the search ends at this area if the turn is also least

    bool is_final() const { return weight.area <= enough && weight.turn <= part.least; }
  };

  /// Returns the unit normal and the area of the triangle, both 0 if the triangle is too thin for double. Returns
  /// nothing if its corners are on a line.
  std::optional<Facet> facet(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Vector u = rim_.places[b] - rim_.places[a], v = rim_.places[c] - rim_.places[a], n = cross(u, v);
    const double length = std::sqrt(dot(n, n));
    // Places are rounded by less than 2^-52.
    constexpr double certain = 0x1p-48;
    if (!(length > certain) && are_collinear(rim_.points[a], rim_.points[b], rim_.points[c])) return std::nullopt;
    if (!(length > 0)) return Facet{{0, 0, 0}, 0};
    return Facet{{n.x / length, n.y / length, n.z / length}, length / 2};
  }

  /// Sets least_turns_ to a lower bound of the turn over each side: the least turn of all triangles at the side; 0 if
  /// not all chords are known.
  void find_least_turns() {
    least_turns_.assign(rim_.size(), 0);
    if (!chords_.are_all()) return;
    for (std::uint32_t i = 0; i <= last_; ++i) {
      float least = most_turn;
      const std::uint32_t next = i == last_ ? 0 : i + 1;
      for (std::uint32_t m = 0; m <= last_ && least > 0; ++m) {
        if (m == i || m == next) continue;
        if (const auto at = facet(i, next, m)) least = std::min(least, turn_between(at->unit, rim_.normals[i]));
      }
      least_turns_[i] = least;
    }
  }

  double least_area(const Chord& chord) const {
    const Vector closing = cross(rim_.places[chord.second], rim_.places[chord.first]);
    const Vector &from = around_[chord.first], &to = around_[chord.second];
    const Vector area = {to.x - from.x + closing.x, to.y - from.y + closing.y, to.z - from.z + closing.z};
    return std::sqrt(dot(area, area)) / 2;
  }

  void settle(std::uint32_t number) {
    const Chord& chord = chords_[number];
    Best best;
    if (chord.second == chord.first + 1) {
      best.weight = {};
      best.part.unit = rim_.normals[chord.first];
      best.part.least = least_turns_[chord.first];
    } else if (chords_.is_complete()) {
      // There are chords to all corners in between, which are adjacent in both orders.
      const std::uint32_t count = chord.second - chord.first - 1;
      const std::uint32_t first = chords_.first_from(chord.first),
                          second = chords_.first_to(chord.second) + chord.first + 1;
      for (std::uint32_t k = 0; k < count && !best.is_final(); ++k) attempt(chord, first + k, second + k, best);
      step_(count / 8 + 1);
    } else {
      const std::uint32_t end = chords_.first_to(chord.second + 1);
      std::uint32_t second = chords_.first_to(chord.second);
      for (std::uint32_t first = chords_.first_from(chord.first); first < number && !best.is_final(); ++first) {
        const std::uint32_t m = chords_.highs()[first];
        while (second < end && chords_.lows()[second] < m) ++second;
        if (second == end) break;
        if (chords_.lows()[second] == m) attempt(chord, first, second, best);
      }
      step_((number - chords_.first_from(chord.first)) / 8 + 1);
    }
    parts_[number] = best.part;
    const std::uint32_t place = chords_.place_to(number);
    from_.turn[number] = to_.turn[place] = best.weight.turn;
    from_.area[number] = to_.area[place] = best.weight.area;
  }

  /// Tries the triangle at the chord with the parts behind its other two sides. `first` is the number of one side,
  /// `second` the place of the other side in the order of the high ends.
  void attempt(const Chord& chord, std::uint32_t first, std::uint32_t second, Best& best) {
    FillingWeight weight{std::max(from_.turn[first], to_.turn[second]), 0};
    if (weight.turn > best.weight.turn || weight.turn == impossible) return;
    weight.area = from_.area[first] + to_.area[second];
    if (weight.turn == best.weight.turn && weight.area >= best.weight.area) return;
    const std::uint32_t m = chords_.highs()[first];
    const auto at = facet(chord.first, m, chord.second);
    if (!at || (!forbidden_.empty() &&
                std::binary_search(forbidden_.begin(), forbidden_.end(), RimTriangle{chord.first, m, chord.second})))
      return;
    const Part &before = parts_[first], &behind = parts_[chords_.number_at(second)];
    weight.turn = std::max({weight.turn, turn_between(at->unit, before.unit), turn_between(at->unit, behind.unit)});
    if (chord.first == 0 && chord.second == last_)
      weight.turn = std::max(weight.turn, turn_between(at->unit, rim_.normals[last_]));
    weight.area += at->area;
    if (!(weight < best.weight)) return;
    if (best.enough < 0) {
      best.enough = least_area(chord) * (1 + 0x1p-40);
      best.part.least = std::max(before.least, behind.least);
    }
    best.weight = weight;
    best.part.apex = m;
    best.part.unit = at->unit;
  }

  RimFilling filling_behind(std::uint32_t root) const {
    RimFilling filling;
    filling.weight = {from_.turn[root], from_.area[root]};
    std::vector<std::uint32_t> waiting = {root};
    while (!waiting.empty()) {
      const std::uint32_t number = waiting.back();
      waiting.pop_back();
      const std::uint32_t m = parts_[number].apex;
      if (m == no_corner) continue;
      const auto [low, high] = chords_[number];
      filling.triangles.push_back({low, m, high});
      waiting.push_back(chords_.number_of({low, m}));
      waiting.push_back(chords_.number_of({m, high}));
    }
    return filling;
  }

  const Rim& rim_;
  const Chords& chords_;
  std::span<const RimTriangle> forbidden_;
  meshops::Steps& step_;
  std::uint32_t last_;       // the last corner of the rim
  std::vector<Part> parts_;  // the parts, by the number of their chords
  Weights from_, to_;        // weights of the parts, by number and by place of their chords
  std::vector<Vector> around_;
  std::vector<float> least_turns_;
};

}  // namespace

std::optional<RimFilling> least_triangulation(const Rim& rim, std::vector<Chord> candidates,
                                              std::span<const Chord> forbidden_chords,
                                              std::span<const RimTriangle> forbidden_triangles, meshops::Steps& step) {
  const Chords chords(rim.size(), std::move(candidates), forbidden_chords);
  return Search(rim, chords, forbidden_triangles, step).run();
}

}  // namespace rbpa::space
