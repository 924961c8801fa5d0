#include "rbpa/plane/partial_bytes.h"

#include <algorithm>
#include <bit>
#include <cstddef>

#include "rbpa/plane/partial/crc64.h"
#include "rbpa/plane/partial/format.h"
#include "rbpa/plane/partial/rings.h"
#include "rbpa/plane/partial/state.h"

namespace rbpa {
namespace {

class Writer {
 public:
  void add(std::uint64_t value) {
    bytes_.resize(bytes_.size() + partial_format::word);
    set(bytes_.size() - partial_format::word, value);
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const Point& p) {
    add(p.x);
    add(p.y);
  }
  void add(const std::vector<Corner>& corners) {
    add(std::uint64_t{corners.size()});
    for (const Corner& corner : corners) {
      add(corner.index);
      add(corner.at);
    }
  }
  void add(const std::vector<ComponentName>& names) {
    add(std::uint64_t{names.size()});
    for (const ComponentName& name : names)
      for (const std::uint64_t corner : name) add(corner);
  }
  void add(const ExactSum& sum) {
    for (const std::int64_t digit : sum.digits()) add(static_cast<std::uint64_t>(digit));
  }
  void add(const HoleSums& sums) {
    add(sums.holes);
    add(sums.names);
    add(sums.measure.twice_area());
    add(sums.measure.lengths().finite());
    add(std::uint64_t{sums.measure.lengths().is_infinite()});
  }
  void add(const CornerPolygon& polygon) {
    add(polygon.points);
    add(polygon.taken_holes);
    add(polygon.names);
    add(polygon.area);
    add(polygon.perimeter);
    add(polygon.shell);
    add(std::uint64_t{polygon.holes.size()});
    for (const CornerRing& hole : polygon.holes) add(hole);
  }
  void set(std::size_t at, std::uint64_t value) {
    for (unsigned shift = 0; shift < 64; shift += 8) bytes_[at++] = static_cast<std::uint8_t>(value >> shift);
  }
  std::vector<std::uint8_t>& bytes() { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

void add_counts(Writer& writer, const PartialCounts& counts) {
  for (const std::uint64_t count :
       {counts.points, counts.duplicates, counts.isolated, counts.vertices, counts.edges, counts.triangles,
        counts.solid_components, counts.components, counts.boundary_curves})
    writer.add(count);
}

/// Returns pointers to the items, sorted by `less`.
template <typename Item, typename Less>
std::vector<const Item*> in_order(const std::vector<Item>& items, Less less) {
  std::vector<const Item*> order;
  order.reserve(items.size());
  for (const Item& item : items) order.push_back(&item);
  std::sort(order.begin(), order.end(), [&](const Item* a, const Item* b) { return less(*a, *b); });
  return order;
}

void add_open(Writer& writer, const std::vector<OpenComponent>& components) {
  writer.add(std::uint64_t{components.size()});
  for (const OpenComponent& component : components) {
    writer.add(std::uint64_t{component.group});
    writer.add(component.points);
    writer.add(component.least);
    writer.add(std::uint64_t{component.rings.size()});
    for (const CornerRing* ring : in_order(component.rings, ring_before)) writer.add(*ring);
    writer.add(std::uint64_t{component.taken.size()});
    for (const HoleSums& sums : component.taken) writer.add(sums);
  }
}

void add_rim(Writer& writer, const PartialState& state) {
  writer.add(std::uint64_t{state.shared.size()});
  for (const SharedTriangle& triangle : state.shared) {
    for (const std::uint64_t corner : triangle.corners) writer.add(corner);
    writer.add(std::uint64_t{triangle.component} << 2U | triangle.owned);
  }
  add_open(writer, state.open);
  writer.add(std::uint64_t{state.chains.size()});
  for (const Chain& chain : state.chains) {
    writer.add(std::uint64_t{chain.component});
    writer.add(chain.path);
  }
  writer.add(std::uint64_t{state.pinches.size()});
  for (const Pinch& pinch : state.pinches) {
    writer.add(pinch.points);
    writer.add(std::uint64_t{pinch.members.size()});
    for (const std::uint32_t member : pinch.members) writer.add(std::uint64_t{member});
  }
}

}  // namespace

std::vector<std::uint8_t> to_bytes(const Partial& partial) {
  const PartialState& state = partial.state();
  Writer writer;
  writer.add(partial_format::magic);
  writer.add(partial_format::version);
  const std::size_t size_at = writer.bytes().size();
  writer.add(std::uint64_t{0});
  writer.add(state.alpha);
  add_counts(writer, state.counts);
  writer.add(std::uint64_t{state.cover.quadrants().size()});
  for (const Quadrant& quadrant : state.cover.quadrants()) {
    writer.add(quadrant.at);
    writer.add(static_cast<std::uint64_t>(std::int64_t{quadrant.weight}));
  }
  add_rim(writer, state);
  writer.add(std::uint64_t{state.held.size()});
  for (const CornerPolygon& polygon : state.held) writer.add(polygon);
  writer.add(std::uint64_t{state.polygons.size()});
  for (const CornerPolygon* polygon : in_order(state.polygons, comes_before)) writer.add(*polygon);
  writer.set(size_at, writer.bytes().size() + partial_format::word);
  writer.add(crc64(writer.bytes()));
  return std::move(writer.bytes());
}

}  // namespace rbpa
