#include "io/ply_header.h"

#include <algorithm>
#include <charconv>

#include "io/failure.h"
#include "io/lines.h"

namespace rbpa::app {
namespace {

std::optional<Scalar> scalar_named(std::string_view word) {
  constexpr std::pair<std::string_view, Scalar> names[] = {
      {"char", Scalar::int8},     {"uchar", Scalar::uint8},     {"short", Scalar::int16},
      {"ushort", Scalar::uint16}, {"int", Scalar::int32},       {"uint", Scalar::uint32},
      {"float", Scalar::float32}, {"double", Scalar::float64},  {"int8", Scalar::int8},
      {"uint8", Scalar::uint8},   {"int16", Scalar::int16},     {"uint16", Scalar::uint16},
      {"int32", Scalar::int32},   {"uint32", Scalar::uint32},   {"int64", Scalar::int64},
      {"uint64", Scalar::uint64}, {"float32", Scalar::float32}, {"float64", Scalar::float64}};
  for (const auto& [text, type] : names)
    if (word == text) return type;
  return std::nullopt;
}

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::string& name) : lines_(bytes), name_(name) {}

  PlyHeader read() {
    if (!lines_.next() || lines_.line() != "ply") bad_input(name_, "no PLY signature", "a .ply file");
    bool format_seen = false;
    while (true) {
      if (!lines_.next()) bad_input(name_, "the end of the file in the header", "end_header");
      std::string_view rest = lines_.line();
      const std::string_view word = take_word(rest);
      if (word == "end_header") break;
      if (word == "format") {
        read_format(rest);
        format_seen = true;
      } else if (word == "element") {
        read_element(rest);
      } else if (word == "property") {
        read_property(rest);
      } else if (!word.empty() && word != "comment" && word != "obj_info") {
        refuse("a PLY header line");
      }
    }
    if (!format_seen) bad_input(name_, "a header without a format line", "one");
    header_.lines = lines_.number();
    header_.data = lines_.rest();
    return std::move(header_);
  }

 private:
  [[noreturn]] void refuse(const std::string& expected) const {
    bad_input(at_line(name_, lines_.number()), in_quotes(lines_.line()), expected);
  }
  Scalar scalar(std::string_view word) const {
    const std::optional<Scalar> type = scalar_named(word);
    if (!type) refuse("a known number type");
    return *type;
  }
  void read_format(std::string_view rest) {
    const std::string_view format = take_word(rest), version = take_word(rest);
    if (version != "1.0") refuse("format version 1.0");
    if (format == "binary_little_endian") {
      header_.binary = std::endian::little;
    } else if (format == "binary_big_endian") {
      header_.binary = std::endian::big;
    } else if (format != "ascii") {
      refuse("ascii, binary_little_endian or binary_big_endian");
    }
  }
  void read_element(std::string_view rest) {
    const std::string_view element = take_word(rest), number = take_word(rest);
    std::size_t count = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), count);
    if (error != std::errc() || end != number.data() + number.size()) refuse("element NAME COUNT");
    header_.elements.push_back({std::string(element), count, lines_.number(), {}});
  }
  void read_property(std::string_view rest) {
    if (header_.elements.empty()) refuse("an element before its properties");
    std::string_view type = take_word(rest);
    std::optional<Scalar> count_type;
    if (type == "list") {
      count_type = scalar(take_word(rest));
      if (!is_integer(*count_type)) refuse("an integer type for the length of a list");
      type = take_word(rest);
    }
    const std::string_view property = take_word(rest);
    if (property.empty()) refuse("property TYPE NAME");
    header_.elements.back().properties.push_back({std::string(property), scalar(type), count_type});
  }

  Lines lines_;
  const std::string& name_;
  PlyHeader header_{};
};

}  // namespace

bool PlyElement::has_lists() const {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& p) { return p.count_type.has_value(); });
}

std::size_t PlyElement::least_size() const {
  std::size_t size = 0;
  for (const PlyProperty& property : properties) size += size_of(property.count_type.value_or(property.type));
  return size;
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& name) { return HeaderReader(bytes, name).read(); }

}  // namespace rbpa::app
