#include "io/points/npy_points.h"

#include <charconv>
#include <optional>

#include "io/claim.h"
#include "io/failure.h"
#include "io/lines.h"
#include "io/points/binary_points.h"

namespace rbpa::app {
namespace {

constexpr std::string_view magic = "\x93NUMPY";

struct NpyHeader {
  std::string_view text;  ///< the Python dictionary
  std::size_t data;       ///< where the array begins
};

NpyHeader find_header(std::string_view bytes, const std::string& name) {
  if (bytes.substr(0, magic.size()) != magic) bad_input(name, "no NumPy signature", "an .npy file");
  const std::size_t version = bytes.size() > magic.size() ? static_cast<unsigned char>(bytes[magic.size()]) : 0;
  const std::size_t length_bytes = version == 1 ? 2 : 4;
  const std::size_t start = magic.size() + 2 + length_bytes;
  if (bytes.size() < start) bad_input(name, counted(bytes.size(), "byte"), "a whole .npy header");
  if (version < 1 || version > 3) bad_input(name, ".npy version " + std::to_string(version), "version 1, 2 or 3");
  const char* at = bytes.data() + magic.size() + 2;
  const std::size_t length =
      version == 1 ? load<std::uint16_t>(at, std::endian::little) : load<std::uint32_t>(at, std::endian::little);
  if (bytes.size() - start < length)
    bad_input(name, counted(bytes.size(), "byte"), "an .npy header of " + std::to_string(length) + " bytes");
  return {bytes.substr(start, length), start + length};
}

/// The text of the value of `key`, up to the comma or brace behind it at the same depth; empty when there is no such key.
std::string_view value_of(std::string_view dictionary, std::string_view key) {
  for (const char quote : {'\'', '"'}) {
    const std::string wanted = quote + std::string(key) + quote;
    const std::size_t found = dictionary.find(wanted);
    if (found == std::string_view::npos) continue;
    std::string_view rest = trimmed(dictionary.substr(found + wanted.size()));
    if (rest.empty() || rest.front() != ':') continue;
    rest = trimmed(rest.substr(1));
    int depth = 0;
    std::size_t end = 0;
    for (; end < rest.size(); ++end) {
      const char c = rest[end];
      if (c == '(' || c == '[' || c == '{') ++depth;
      if (depth == 0 && (c == ',' || c == '}')) break;
      if (c == ')' || c == ']' || c == '}') --depth;
    }
    return trimmed(rest.substr(0, end));
  }
  return {};
}

struct NumberType {
  Scalar type;
  std::endian order;
};

std::optional<NumberType> parse_type(std::string_view descr) {
  if (descr.size() < 4) return std::nullopt;
  descr = descr.substr(1, descr.size() - 2);  // the quotes
  std::endian order = std::endian::native;
  if (descr.front() == '<') order = std::endian::little;
  if (descr.front() == '>') order = std::endian::big;
  if (std::string_view("<>|=").find(descr.front()) != std::string_view::npos) descr.remove_prefix(1);
  constexpr std::pair<std::string_view, Scalar> known[] = {
      {"f8", Scalar::float64}, {"f4", Scalar::float32}, {"i8", Scalar::int64},  {"i4", Scalar::int32},
      {"i2", Scalar::int16},   {"i1", Scalar::int8},    {"u8", Scalar::uint64}, {"u4", Scalar::uint32},
      {"u2", Scalar::uint16},  {"u1", Scalar::uint8}};
  for (const auto& [text, type] : known)
    if (descr == text) return NumberType{type, order};
  return std::nullopt;
}

struct ArrayShape {
  std::size_t rows, columns;
};

std::optional<ArrayShape> parse_shape(std::string_view text, std::array<std::size_t, 2> columns) {
  if (text.size() < 2 || text.front() != '(' || text.back() != ')') return std::nullopt;
  text = text.substr(1, text.size() - 2);
  std::vector<std::size_t> sizes;
  while (!(text = trimmed(text)).empty()) {
    std::size_t size = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
    if (error != std::errc()) return std::nullopt;
    sizes.push_back(size);
    text = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
    if (!text.empty() && text.front() == ',') text.remove_prefix(1);
  }
  if (sizes.size() != 2 || (sizes[1] != columns[0] && sizes[1] != columns[1])) return std::nullopt;
  return ArrayShape{sizes[0], sizes[1]};
}

}  // namespace

NpyLayout read_npy_layout(std::string_view bytes, std::size_t size, const std::string& name,
                          std::array<std::size_t, 2> columns) {
  const NpyHeader header = find_header(bytes, name);
  const std::string_view descr = value_of(header.text, "descr");
  const std::optional<NumberType> number = parse_type(descr);
  if (!number) bad_input(name, "numbers of type " + in_quotes(descr), "float32, float64 or integers");
  const std::string_view shape_text = value_of(header.text, "shape");
  const std::optional<ArrayShape> shape = parse_shape(shape_text, columns);
  if (!shape)
    bad_input(name, "shape " + in_quotes(shape_text),
              "(n, " + std::to_string(columns[0]) + ") or (n, " + std::to_string(columns[1]) + ")");
  const std::string_view order = value_of(header.text, "fortran_order");
  if (order != "True" && order != "False") bad_input(name, "fortran_order " + in_quotes(order), "True or False");

  const NpyLayout layout{shape->rows, shape->columns, number->type, number->order, order == "True", header.data};
  const std::size_t available = size - header.data;
  if (shape->rows > available / layout.row())
    bad_input(name, counted(available, "byte") + " of data",
              std::to_string(shape->rows) + " rows of " + std::to_string(layout.row()) + " bytes as the header says");
  return layout;
}

double claimed_npy_size(std::string_view first, const std::string& name) {
  return read_npy_layout(first, unknown_size, name).end();
}

PointFile read_npy_points(std::string_view bytes, const std::string& name) {
  const NpyLayout array = read_npy_layout(bytes, bytes.size(), name);
  const char* data = bytes.data() + array.data;
  const std::size_t item = array.item();
  const std::size_t stride = array.columns_first ? item : array.row(),
                    column = array.columns_first ? array.rows * item : item;
  PointFile file{.points =
                     load_points({array.rows, data, data + column, stride, array.type, array.type, array.order}, name)};
  for (std::size_t i = 0; array.columns == 3 && i < array.rows && !file.heights.differ(); ++i)
    file.heights.take(load_number(array.type, data + 2 * column + i * stride, array.order));
  return file;
}

}  // namespace rbpa::app
