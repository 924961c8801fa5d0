#include <array>
#include <bit>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/space/pcd_header.h"
#include "io/space/readers.h"
#include "io/vertex_lines.h"

namespace rbpa::app {
namespace {

struct PcdColumns {
  std::vector<const PcdField*> numbers = {};  ///< of x, y, z and, when there are six, of the normal
  const PcdField* color = nullptr;            ///< 0xRRGGBB in an integer, or in the bits of a float
};

PcdColumns lay_out(const PcdHeader& header, const std::string& name, std::vector<std::string>& remarks) {
  PcdColumns layout;
  for (const std::string_view axis : {"x", "y", "z"}) {
    layout.numbers.push_back(header.find(axis));
    if (layout.numbers.back() == nullptr) bad_input(name, "points without " + in_quotes(axis), "the fields x, y and z");
  }
  std::vector<const PcdField*> normal;
  for (const std::string_view axis : {"normal_x", "normal_y", "normal_z"})
    if (const PcdField* field = header.find(axis)) normal.push_back(field);
  if (normal.size() == 3) layout.numbers.insert(layout.numbers.end(), normal.begin(), normal.end());
  if (normal.size() == 1 || normal.size() == 2)
    remarks.emplace_back("normals are left out, as not all of normal_x, normal_y and normal_z are there");
  const PcdField* color = header.find("rgb") != nullptr ? header.find("rgb") : header.find("rgba");
  if (color != nullptr && size_of(color->type) == 4) layout.color = color;
  if (color != nullptr && layout.color == nullptr)
    remarks.emplace_back("colours are left out, as " + color->name + " is not of 4 bytes");
  return layout;
}

std::array<std::uint8_t, 3> channels(std::uint32_t bits) {
  const auto byte = [bits](unsigned shift) { return static_cast<std::uint8_t>(bits >> shift & 0xFFU); };
  return {byte(16), byte(8), byte(0)};
}

void read_binary(const PcdHeader& header, const PcdColumns& layout, const std::string& name, SpacePoints& file) {
  constexpr std::endian order = std::endian::little;
  std::array<double, 6> value{};
  for (std::size_t i = 0; i < header.points; ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    const char* const point = header.data.data() + i * header.size;
    for (std::size_t k = 0; k < layout.numbers.size(); ++k)
      value[k] = load_number(layout.numbers[k]->type, point + layout.numbers[k]->offset, order);
    append_numbers({value.data(), layout.numbers.size()}, file, name);
    if (layout.color != nullptr)
      file.colors.push_back(channels(load<std::uint32_t>(point + layout.color->offset, order)));
  }
}

/// The bits of a colour in text: of a float those of the number that is written.
std::uint32_t color_bits(double number, const PcdField& field, const std::string& here) {
  const bool bits_of_float = field.type == Scalar::float32;
  const double least = bits_of_float ? -0x1.fffffep127 : -0x1p31,
               greatest = bits_of_float ? 0x1.fffffep127 : 0x1p32 - 1;
  if (!(number >= least && number <= greatest)) bad_input(here, in_quotes(ShortestText(number)), "a colour of 4 bytes");
  if (bits_of_float) return std::bit_cast<std::uint32_t>(static_cast<float>(number));
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(number));  // signed, or not
}

void read_ascii(const PcdHeader& header, const PcdColumns& layout, const std::string& name, SpacePoints& file) {
  constexpr std::size_t color = 6, nothing = 7;
  std::vector<std::size_t> role(header.numbers, nothing);
  for (std::size_t k = 0; k < layout.numbers.size(); ++k) role[layout.numbers[k]->first] = k;
  if (layout.color != nullptr) role[layout.color->first] = color;
  Lines lines(header.data, header.lines);
  std::array<double, 6> value{};
  for (std::size_t i = 0; i < header.points; ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    if (!lines.next_with_content()) bad_input(name, counted(i, "point"), announced(header));
    std::string_view rest = lines.line();
    for (const std::size_t what : role) {
      if (what == nothing) {
        if (take_word(rest).empty()) bad_input(at_line(name, lines.number()), in_quotes(lines.line()), "more values");
        continue;
      }
      const double number = take_coordinate(rest, lines, name);
      if (what == color) {
        file.colors.push_back(channels(color_bits(number, *layout.color, at_line(name, lines.number()))));
      } else {
        value[what] = number;
      }
    }
    append_numbers({value.data(), layout.numbers.size()}, file, name);
  }
}

}  // namespace

SpacePoints read_pcd_space(std::string_view bytes, const std::string& name) {
  const PcdHeader header = read_pcd_header(bytes, name);
  SpacePoints file;
  const PcdColumns layout = lay_out(header, name, file.remarks);
  if (header.points == 0) return file;  // however many numbers each is said to have
  reserve_points(file, header.points, layout.numbers.size() == 6, layout.color != nullptr);
  header.binary ? read_binary(header, layout, name, file) : read_ascii(header, layout, name, file);
  return file;
}

}  // namespace rbpa::app
