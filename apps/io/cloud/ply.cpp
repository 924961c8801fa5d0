#include "io/cloud/ply.h"

#include <algorithm>

#include "io/failure.h"
#include "io/text/lines.h"
#include "io/text/vertex_lines.h"

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
    if (!lines_.next() || lines_.line() != "ply")
      bad_input(name_, "a first line " + in_quotes(lines_.line()), "'ply', the first line of every .ply file");
    bool format_seen = false;
    while (true) {
      if (!lines_.next()) bad_input(name_, "the end of the file in the header", "end_header (copy the file again)");
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
        refuse("a line that begins with element, property, comment, format or end_header");
      }
    }
    if (!format_seen) bad_input(name_, "a header without a format line", "a line that begins with format");
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
    if (!type) refuse("a type of numbers, such as float, double, uchar or int32");
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
    const std::string_view element = take_word(rest);
    const std::optional<std::size_t> count = parse_count(take_word(rest));
    if (!count) refuse("element NAME COUNT");
    header_.elements.push_back({std::string(element), shown(element) + " element", *count, lines_.number(), {}});
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
  for (const PlyProperty& property : properties) size += property.least_size();
  return size;
}

std::size_t PlyElement::least_words() const {
  std::size_t words = 0;
  for (const PlyProperty& property : properties) words += property.count;
  return words;
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& name) { return HeaderReader(bytes, name).read(); }

std::string announced(const PlyElement& element) {
  return counted(element.count, element.noun) + " as line " + std::to_string(element.line) + " says";
}

const PlyElement& vertices_of(const PlyHeader& header, const std::string& name) {
  const auto vertex = std::find_if(header.elements.begin(), header.elements.end(),
                                   [](const PlyElement& element) { return element.name == "vertex"; });
  if (vertex == header.elements.end()) bad_input(name, "a header without vertices", "an element 'vertex'");
  return *vertex;
}

std::optional<std::size_t> number_place(const PlyElement& element, std::string_view property) {
  for (std::size_t i = 0; i < element.properties.size(); ++i)
    if (element.properties[i].name == property && !element.properties[i].count_type) return i;
  return std::nullopt;
}

std::vector<std::size_t> number_places(const PlyElement& element, std::span<const std::string_view> names) {
  std::vector<std::size_t> places;
  for (const std::string_view name : names)
    if (const std::optional<std::size_t> place = number_place(element, name)) places.push_back(*place);
  return places;
}

std::size_t find_number(const PlyElement& element, std::string_view property, std::string_view wanted,
                        const std::string& name) {
  if (const std::optional<std::size_t> place = number_place(element, property)) return *place;
  bad_input(at_line(name, element.line), "vertices without " + in_quotes(property),
            "number properties " + std::string(wanted));
}

void PlyBinary::require_room(const PlyElement& element) const {
  const std::size_t size = element.least_size();
  if (size > 0 && element.count > left() / size)
    bad_input(name_, counted(left(), "byte") + " of data", announced(element));
}

void PlyBinary::skip(const PlyElement& element) {
  if (element.has_lists()) return pass(element, 0, element.count, [](std::size_t, const std::vector<const char*>&) {});
  at_ += element.count * element.least_size();
}

void PlyBinary::pass_any(const PlyProperty& property, const PlyElement& element, std::size_t index) {
  std::size_t values = property.count;
  if (property.count_type) {
    const char* length = at_;
    take(size_of(*property.count_type), element, index);
    const double count = load_number(*property.count_type, length, order_);
    if (count < 0)
      bad_input(name_ + ": " + shown(element.name) + " " + std::to_string(index), "a negative list length",
                "a length of 0 or more");
    values = count > static_cast<double>(left()) ? left() + 1 : static_cast<std::size_t>(count);
  }
  take(values * size_of(property.type), element, index);
}

void PlyBinary::take(std::size_t size, const PlyElement& element, std::size_t index) {
  if (size > left()) bad_input(name_, counted(index, "whole " + element.noun), announced(element));
  at_ += size;
}

void PlyText::require_room(const PlyElement& element) const {
  if (element.properties.empty()) return;
  // Count two characters for each value, except one for the last of the file.
  const std::size_t left = rest_.size() + lines_.rest().size();
  if (element.count > (left + 1) / (2 * element.least_words()))
    bad_input(name_, counted(left, "byte") + " of data", announced(element));
}

void PlyText::pass_words(const PlyProperty& property, std::string_view& rest, std::size_t read) const {
  auto values = static_cast<double>(property.count - read);
  if (property.count_type) values = take_coordinate(rest, lines_, name_);
  for (double i = 0; i < values; ++i)
    if (take_word(rest).empty())
      bad_input(at_line(name_, lines_.number()), in_quotes(lines_.line()), "a value for each property");
}

void PlyText::require_end() {
  if (!rest_.empty() || lines_.next_with_content())
    bad_input(at_line(name_, lines_.number()), in_quotes(lines_.line()),
              "the end of the file after " + announced(header_.elements.back()));
}

void PlyText::next(const PlyElement& element, std::size_t index) {
  if (!lines_.next_with_content()) bad_input(name_, counted(index, element.noun), announced(element));
  rest_ = lines_.line();
}

/// Decides whether the words after an element in its line are ignored, or are the next elements.
void PlyText::settle_rest(const PlyElement& element, std::size_t index) {
  if (rest_.front() != '#' && is_by_words_) return;
  if (rest_.front() != '#' && !is_by_lines_) {
    std::size_t elements = element.count - index - 1;
    for (const PlyElement* later = &element + 1; later != header_.elements.data() + header_.elements.size(); ++later)
      elements += later->count;
    Lines ahead = lines_;
    std::size_t lines = 0;
    while (lines < elements && ahead.next_with_content()) ++lines;
    is_by_lines_ = lines == elements;
    is_by_words_ = !is_by_lines_ && are_words_of_rest(element, index);
    if (is_by_words_) return;
    if (!is_by_lines_)
      bad_input(at_line(name_, lines_.number()),
                in_quotes(rest_) + " in a " + element.noun + ", and " + counted(lines, "line") + " after it",
                counted(elements, "line") +
                    " after it, one for each element in the header, or in the line words of these elements only");
  }
  rest_ = {};
}

/// Returns whether exactly the words of all later elements follow item `index` of `element`.
bool PlyText::are_words_of_rest(const PlyElement& element, std::size_t index) const {
  Lines lines = lines_;
  std::string_view rest = rest_;
  const auto take = [&] {
    while ((rest = trimmed(rest)).empty() || rest.front() == '#') {
      if (!lines.next_with_content()) return std::string_view();
      rest = lines.line();
    }
    return take_word(rest);
  };
  for (const PlyElement* of = &element; of != header_.elements.data() + header_.elements.size(); ++of)
    for (std::size_t i = of == &element ? index + 1 : 0; i < of->count; ++i) {
      if (i % 16384 == 0) stop_if_interrupted();
      for (const PlyProperty& property : of->properties) {
        std::optional<std::size_t> values = property.count;
        if (property.count_type) values = parse_count(take());
        for (; values.value_or(0) > 0; --*values)
          if (take().empty()) return false;
        if (!values) return false;
      }
    }
  return take().empty();
}

}  // namespace rbpa::app
