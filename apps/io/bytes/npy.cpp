#include "io/bytes/npy.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "io/words.h"

namespace rbpa::app {
namespace {

constexpr std::string_view magic = "\x93NUMPY";

struct NpyHeader {
  std::string_view text;  ///< the Python dictionary
  std::size_t data;       ///< offset of the array in the file
};

NpyHeader find_header(std::string_view bytes, const std::string& name) {
  if (bytes.substr(0, magic.size()) != magic)
    bad_input(name, in_quotes(bytes.substr(0, magic.size())), "an .npy file, which begins with '\\x93NUMPY'");
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

/// Returns the text of the value of `key` in a Python dictionary: up to the comma or brace at the same depth after it.
/// Empty if there is no such key.
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
  descr = descr.substr(1, descr.size() - 2);  // without the quotes
  std::endian order = std::endian::native;
  if (descr.front() == '<') order = std::endian::little;
  if (descr.front() == '>') order = std::endian::big;
  if (std::string_view("<>|=").find(descr.front()) != std::string_view::npos) descr.remove_prefix(1);
  if (const std::optional<Scalar> type = scalar_of(descr.substr(0, 1), descr.substr(1)))
    return NumberType{*type, order};
  return std::nullopt;
}

struct ArrayShape {
  std::size_t rows, columns;
};

std::optional<ArrayShape> parse_shape(std::string_view text) {
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
  if (sizes.size() != 2 || sizes[1] == 0) return std::nullopt;
  return ArrayShape{sizes[0], sizes[1]};
}

std::string shapes(std::span<const std::size_t> fits) {
  std::string text;
  for (const std::size_t columns : fits) text += (text.empty() ? "(n, " : " or (n, ") + std::to_string(columns) + ")";
  return text;
}

}  // namespace

NpyLayout read_npy_layout(std::string_view bytes, std::size_t size, const std::string& name,
                          std::span<const std::size_t> fits) {
  const NpyHeader header = find_header(bytes, name);
  const std::string_view descr = value_of(header.text, "descr");
  const std::optional<NumberType> number = parse_type(descr);
  if (!number)
    bad_input(name, "numbers of type " + in_quotes(descr), "float32, float64 or integers (numpy's astype() converts)");
  const std::string_view shape_text = value_of(header.text, "shape");
  const std::optional<ArrayShape> shape = parse_shape(shape_text);
  if (!shape || std::find(fits.begin(), fits.end(), shape->columns) == fits.end())
    bad_input(name, "shape " + in_quotes(shape_text), shapes(fits));
  const std::string_view order = value_of(header.text, "fortran_order");
  if (order != "True" && order != "False") bad_input(name, "fortran_order " + in_quotes(order), "True or False");

  const NpyLayout layout{shape->rows, shape->columns, number->type, number->order, order == "True", header.data};
  const std::size_t available = size - header.data;
  if (shape->rows > available / layout.row())
    bad_input(name, counted(available, "byte") + " of data",
              std::to_string(shape->rows) + " rows of " + std::to_string(layout.row()) + " bytes as the header says");
  return layout;
}

std::string npy_header(std::string_view type, std::uint64_t rows, std::string_view columns) {
  std::string text = "{'descr': '";
  text += type;
  text += "', 'fortran_order': False, 'shape': (";
  text += std::to_string(rows);
  text += columns;
  text += "), }";
  constexpr std::size_t before = 10, alignment = 64;  // bytes before the text; the alignment of the data
  text.append(alignment - (before + text.size() + 1) % alignment, ' ');
  text += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(text.size() & 0xFFU);
  bytes += static_cast<char>(text.size() >> 8U);
  return bytes + text;
}

}  // namespace rbpa::app
