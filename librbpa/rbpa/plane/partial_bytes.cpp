#include "rbpa/plane/partial_bytes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "rbpa/base/error.h"
#include "rbpa/plane/partial/crc64.h"
#include "rbpa/plane/partial/rings.h"
#include "rbpa/plane/partial/state.h"

namespace rbpa {
namespace {

// The layout of a Partial in bytes: words of 8, little-endian (docs/explanation/plane.md, section 22).
constexpr std::uint64_t magic = 0x5452'4150'4150'4252;  // the letters RBPAPART
constexpr std::uint64_t version = 1;
constexpr std::size_t word = 8;

/// Returns pointers to the items, sorted by `less`.
template <typename Item, typename Less>
std::vector<const Item*> in_order(const std::vector<Item>& items, Less less) {
  std::vector<const Item*> order;
  order.reserve(items.size());
  for (const Item& item : items) order.push_back(&item);
  std::sort(order.begin(), order.end(), [&](const Item* a, const Item* b) { return less(*a, *b); });
  return order;
}

class Writer {
 public:
  void add(std::uint64_t value) {
    bytes_.resize(bytes_.size() + word);
    set(bytes_.size() - word, value);
  }
  void add(std::uint32_t value) { add(std::uint64_t{value}); }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const Point& p) {
    add(p.x);
    add(p.y);
  }
  void add(const Corner& corner) {
    add(corner.index);
    add(corner.at);
  }
  void add(const std::array<std::uint64_t, 3>& corners) {
    for (const std::uint64_t corner : corners) add(corner);
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
    add(polygon.holes);
  }
  void add(const Quadrant& quadrant) {
    add(quadrant.at);
    add(static_cast<std::uint64_t>(std::int64_t{quadrant.weight}));
  }
  void add(const SharedTriangle& triangle) {
    add(triangle.corners);
    add(std::uint64_t{triangle.component} << 2U | triangle.owned);
  }
  void add(const OpenComponent& component) {
    add(component.group);
    add(component.points);
    add(component.least);
    add(in_order(component.rings, ring_before));
    add(component.taken);
  }
  void add(const Chain& chain) {
    add(chain.component);
    add(chain.path);
  }
  void add(const Pinch& pinch) {
    add(pinch.points);
    add(pinch.members);
  }
  template <typename Item>
  void add(const Item* item) {
    add(*item);
  }
  /// Adds the number of items, and each item.
  template <typename Item>
  void add(std::span<const Item> items) {
    add(std::uint64_t{items.size()});
    for (const Item& item : items) add(item);
  }
  template <typename Item>
  void add(const std::vector<Item>& items) {
    add(std::span<const Item>(items));
  }
  void set(std::size_t at, std::uint64_t value) {
    for (unsigned shift = 0; shift < 64; shift += 8) bytes_[at++] = static_cast<std::uint8_t>(value >> shift);
  }
  std::vector<std::uint8_t>& bytes() { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

[[noreturn]] void refuse(const std::string& what) { throw InvalidInput("partial result: " + what); }

std::uint64_t word_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < word; ++i) value |= std::uint64_t{bytes[at + i]} << (8 * i);
  return value;
}

/// Checks the size and the checksum before anything else.
void check_frame(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t header = 3 * word;
  if (bytes.size() < header || word_at(bytes, 0) != magic)
    refuse("found " + std::to_string(bytes.size()) +
           " bytes that do not begin with RBPAPART, expected those that to_bytes() wrote");
  if (const std::uint64_t found = word_at(bytes, word); found != version)
    refuse("found version " + std::to_string(found) + ", expected " + std::to_string(version));
  if (const std::uint64_t size = word_at(bytes, 2 * word); size != bytes.size())
    refuse("found " + std::to_string(bytes.size()) + " bytes, expected " + std::to_string(size) +
           ", as its header says (compute the result again)");
  if (bytes.size() % word != 0 || bytes.size() < header + word)
    refuse("found " + std::to_string(bytes.size()) + " bytes, expected a multiple of 8, at least " +
           std::to_string(header + word) + " (compute the result again)");
  const std::size_t end = bytes.size() - word;
  if (crc64(bytes.first(end)) != word_at(bytes, end))
    refuse(
        "found bytes that do not have the checksum at their end, expected unchanged bytes (compute the result again)");
}

/// Reads words one by one, and never beyond the end.
class Reader {
 public:
  Reader(std::span<const std::uint8_t> bytes, std::size_t at) : bytes_(bytes), at_(at) {}

  std::uint64_t number() {
    if (left() == 0) refuse("found the end of the bytes at byte " + std::to_string(at_) + ", expected more");
    const std::uint64_t value = word_at(bytes_, at_);
    at_ += word;
    return value;
  }
  std::uint32_t small(const char* what) {
    const std::uint64_t value = number();
    if (value > std::numeric_limits<std::uint32_t>::max()) wrong(what, value, "a number below 2^32");
    return static_cast<std::uint32_t>(value);
  }
  double real() { return std::bit_cast<double>(number()); }
  /// Reads the number of items of at least `words` words each; refuses more than fit into the rest.
  std::size_t count(const char* what, std::size_t words) {
    const std::uint64_t value = number();
    if (value > left() / words) wrong(what, value, "no more than fit into the rest of the bytes");
    return static_cast<std::size_t>(value);
  }
  Point point() {
    const double x = real();
    return {x, real()};
  }
  std::vector<Corner> corners(const char* what) {
    std::vector<Corner> corners(count(what, 3));
    for (Corner& corner : corners) {
      corner.index = number();
      corner.at = point();
    }
    return corners;
  }
  std::vector<ComponentName> names() {
    std::vector<ComponentName> names(count("names", 3));
    for (ComponentName& name : names)
      for (std::uint64_t& corner : name) corner = number();
    return names;
  }
  /// Reads a sum. No sum is so large that its last digit holds more than the sign.
  ExactSum sum() {
    ExactSum::Digits digits;
    for (std::int64_t& digit : digits) {
      digit = std::bit_cast<std::int64_t>(number());
      const bool is_last = &digit == &digits.back();
      if (is_last ? digit != 0 && digit != -1 : digit < 0 || digit > 0xffffffff)
        wrong("as a digit of a sum", static_cast<std::uint64_t>(digit),
              is_last ? "0 or -1, as the last one" : "a number below 2^32");
    }
    return ExactSum::of(digits);
  }
  HoleSums hole_sums() {
    HoleSums sums;
    sums.holes = number();
    sums.names = names();
    const ExactSum twice_area = sum(), lengths = sum();
    const std::uint64_t infinite = number();
    if (infinite > 1) wrong("as a flag", infinite, "0 or 1");
    sums.measure = BoundaryMeasure(twice_area, LengthSum::of(lengths, infinite == 1));
    return sums;
  }
  CornerPolygon polygon() {
    CornerPolygon polygon;
    polygon.points = number();
    polygon.taken_holes = number();
    polygon.names = names();
    polygon.area = real();
    polygon.perimeter = real();
    polygon.shell = corners("points of a shell");
    polygon.holes.resize(count("holes", 1));
    for (CornerRing& hole : polygon.holes) hole = corners("points of a hole");
    return polygon;
  }
  void end() const {
    if (left() != 0) refuse("found " + std::to_string(8 * left()) + " bytes after the last item, expected none");
  }

 private:
  [[noreturn]] void wrong(const char* what, std::uint64_t value, const char* expected) const {
    refuse("found " + std::to_string(value) + " " + what + " at byte " + std::to_string(at_ - word) + ", expected " +
           expected);
  }
  std::size_t left() const { return (bytes_.size() - at_) / word; }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_;
};

std::vector<Quadrant> read_quadrants(Reader& reader) {
  std::vector<Quadrant> quadrants(reader.count("corners of regions", 3));
  for (Quadrant& quadrant : quadrants) {
    quadrant.at = reader.point();
    const auto weight = std::bit_cast<std::int64_t>(reader.number());
    if (std::abs(static_cast<double>(weight)) > 2)
      refuse("found a corner of a region with weight " + std::to_string(weight) +
             ", expected -2 to 2 (compute the result again)");
    quadrant.weight = static_cast<int>(weight);
  }
  return quadrants;
}

void read_rim(Reader& reader, PartialState& state) {
  state.shared.resize(reader.count("shared triangles", 4));
  for (SharedTriangle& triangle : state.shared) {
    for (std::uint64_t& corner : triangle.corners) corner = reader.number();
    const std::uint64_t both = reader.number();
    triangle.owned = static_cast<std::uint32_t>(both & 3U);
    if (both >> 34U != 0)
      refuse("found a shared triangle of component " + std::to_string(both >> 2U) +
             ", expected a number below 2^32 (compute the result again)");
    triangle.component = static_cast<std::uint32_t>(both >> 2U);
  }
  state.open.resize(reader.count("open components", 6));
  for (OpenComponent& component : state.open) {
    component.group = reader.small("as the group of a component");
    component.points = reader.number();
    component.least = reader.point();
    component.rings.resize(reader.count("rings", 1));
    for (CornerRing& ring : component.rings) ring = reader.corners("points of a ring");
    component.taken.resize(reader.count("sums of holes", 2 * std::tuple_size_v<ExactSum::Digits>));
    for (HoleSums& sums : component.taken) sums = reader.hole_sums();
  }
  state.chains.resize(reader.count("chains", 2));
  for (Chain& chain : state.chains) {
    chain.component = reader.small("as the component of a chain");
    chain.path = reader.corners("points of a chain");
  }
  state.pinches.resize(reader.count("pinches", 2));
  for (Pinch& pinch : state.pinches) {
    pinch.points = reader.number();
    pinch.members.resize(reader.count("members of a pinch", 1));
    for (std::uint32_t& member : pinch.members) member = reader.small("as a member of a pinch");
  }
}

}  // namespace

std::vector<std::uint8_t> to_bytes(const Partial& partial) {
  const PartialState& state = partial.state();
  Writer writer;
  writer.add(magic);
  writer.add(version);
  const std::size_t size_at = writer.bytes().size();
  writer.add(std::uint64_t{0});
  writer.add(state.alpha);
  for (const auto count : partial_counts) writer.add(state.counts.*count);
  writer.add(state.cover.quadrants());
  writer.add(state.shared);
  writer.add(state.open);
  writer.add(state.chains);
  writer.add(state.pinches);
  writer.add(state.held);
  writer.add(in_order(state.polygons, comes_before));
  writer.set(size_at, writer.bytes().size() + word);
  writer.add(crc64(writer.bytes()));
  return std::move(writer.bytes());
}

Partial partial_from_bytes(std::span<const std::uint8_t> bytes) {
  check_frame(bytes);
  Reader reader(bytes.first(bytes.size() - word), 3 * word);
  PartialState state;
  state.alpha = reader.real();
  for (const auto count : partial_counts) state.counts.*count = reader.number();
  state.cover = Cover(read_quadrants(reader));
  read_rim(reader, state);
  for (auto* polygons : {&state.held, &state.polygons}) {
    polygons->resize(reader.count("polygons", 7));
    for (CornerPolygon& polygon : *polygons) polygon = reader.polygon();
  }
  reader.end();
  check_state(state);
  return Partial(std::move(state));
}

}  // namespace rbpa
