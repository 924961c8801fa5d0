#include "io/cloud/point_window.h"

#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "io/failure.h"
#include "io/number.h"

namespace rbpa::app {

PointBox box_of(const std::string& option, std::span<const double> numbers) {
  const std::string expected = "x0,y0,x1,y1 or x0,y0,x1,y1,z0,z1 with x0 <= x1, y0 <= y1 and z0 <= z1";
  if (numbers.size() != 4 && numbers.size() != 6) bad_usage(option, counted(numbers.size(), "number"), expected);
  constexpr double all = std::numeric_limits<double>::infinity();
  PointBox box{{numbers[0], numbers[1], -all}, {numbers[2], numbers[3], all}};
  if (numbers.size() == 6) box.least[2] = numbers[4], box.greatest[2] = numbers[5];
  for (const double number : numbers)
    if (!std::isfinite(number)) bad_usage(option, text_of(number), expected);
  for (std::size_t k = 0; k < 3; ++k)
    if (box.least[k] > box.greatest[k])
      bad_usage(option, text_of(box.least[k]) + " above " + text_of(box.greatest[k]), expected);
  return box;
}

PointBox parse_box(const std::string& option, const std::string& text) {
  constexpr double any = std::numeric_limits<double>::max();
  std::vector<double> numbers;
  for (const std::string_view word : split_at_commas(text))
    numbers.push_back(parse_real(option, std::string(word), {-any, any}, "numbers with commas between them"));
  return box_of(option, numbers);
}

PointWindow parse_window(const std::optional<std::string>& bounds, const std::optional<std::string>& resolution) {
  PointWindow window;
  if (bounds) window.bounds = parse_box("--bounds", *bounds);
  if (resolution) window.resolution = parse_real("--resolution", *resolution, above_0, "a length above 0");
  return window;
}

std::size_t WindowFilter::Hash::operator()(const std::array<double, 3>& cell) const {
  std::uint64_t hash = 0;
  for (const double part : cell) {  // a step of splitmix64 for each part
    hash += std::bit_cast<std::uint64_t>(part) + 0x9E3779B97F4A7C15U;
    hash = (hash ^ hash >> 30U) * 0xBF58476D1CE4E5B9U;
    hash = (hash ^ hash >> 27U) * 0x94D049BB133111EBU;
    hash ^= hash >> 31U;
  }
  return hash;
}

bool WindowFilter::keeps(const std::array<double, 3>& point) {
  if (bounds_ && !bounds_->contains(point)) return false;
  if (!side_) return true;
  std::array<double, 3> cell{};
  for (std::size_t k = 0; k < (in_space_ ? 3 : 2); ++k) {
    const double number = std::floor(point[k] / *side_) + 0.0;  // + 0.0: −0 has the hash of 0
    cell[k] = std::isfinite(number) ? number : point[k];
  }
  return cells_.insert(cell).second;
}

}  // namespace rbpa::app
