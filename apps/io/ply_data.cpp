#include "io/ply_data.h"

#include <algorithm>

#include "io/claim.h"
#include "io/failure.h"
#include "io/vertex_lines.h"

namespace rbpa::app {

std::string announced(const PlyElement& element) {
  return counted(element.count, shown(element.name) + " element") + " as line " + std::to_string(element.line) +
         " says";
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

std::size_t find_number(const PlyElement& element, std::string_view property, std::string_view wanted,
                        const std::string& name) {
  if (const std::optional<std::size_t> place = number_place(element, property)) return *place;
  bad_input(at_line(name, element.line), "vertices without " + in_quotes(property),
            "number properties " + std::string(wanted));
}

namespace {

/// Where in `data` the element that begins at `at` ends; nothing when a length of its lists is not there.
std::optional<double> end_of_element(const PlyElement& element, double at, std::string_view data, std::endian order) {
  for (const PlyProperty& property : element.properties) {
    double values = 1;
    if (property.count_type) {
      const double length = at;
      at += static_cast<double>(size_of(*property.count_type));
      if (at > static_cast<double>(data.size())) return std::nullopt;
      values = load_number(*property.count_type, data.data() + static_cast<std::size_t>(length), order);
    }
    at += std::max(values, 0.0) * static_cast<double>(size_of(property.type));
  }
  return at;
}

double end_of_elements(const PlyHeader& header) {
  double at = 0;
  for (const PlyElement& element : header.elements) {
    std::size_t left = element.count;
    for (; element.has_lists() && left > 0; --left) {
      if (left % 16384 == 0) stop_if_interrupted();
      const std::optional<double> end = end_of_element(element, at, header.data, *header.binary);
      if (!end) break;
      at = *end;
    }
    at += static_cast<double>(left) * static_cast<double>(element.least_size());
  }
  return at;
}

}  // namespace

double claimed_ply_size(std::string_view first, const std::string& name) {
  const PlyHeader header = read_ply_header(first, name);
  if (header.binary) return static_cast<double>(first.size() - header.data.size()) + end_of_elements(header);
  double lines = 0;
  for (const PlyElement& element : header.elements) lines += static_cast<double>(element.count);
  return end_of_lines(first, Lines(header.data), lines);
}

void PlyBinary::require_room(const PlyElement& element) const {
  const std::size_t size = element.least_size();
  if (size > 0 && element.count > left() / size)
    bad_input(name_, counted(left(), "byte") + " of data", announced(element));
}

void PlyBinary::skip(const PlyElement& element) {
  if (element.has_lists()) return pass(element, [](std::size_t, const std::vector<const char*>&) {});
  at_ += element.count * element.least_size();
}

void PlyBinary::pass_any(const PlyProperty& property, const PlyElement& element, std::size_t index) {
  std::size_t values = 1;
  if (property.count_type) {
    const char* length = at_;
    take(size_of(*property.count_type), element, index);
    const double count = load_number(*property.count_type, length, order_);
    if (count < 0)
      bad_input(name_ + ": " + shown(element.name) + " " + std::to_string(index), "a negative list length", "none");
    values = count > static_cast<double>(left()) ? left() + 1 : static_cast<std::size_t>(count);
  }
  take(values * size_of(property.type), element, index);
}

void PlyBinary::take(std::size_t size, const PlyElement& element, std::size_t index) {
  if (size > left()) bad_input(name_, counted(index, "whole " + shown(element.name) + " element"), announced(element));
  at_ += size;
}

void PlyText::require_room(const PlyElement& element) const {
  if (element.properties.empty()) return;
  // Each value takes a character, and another behind it unless it is the last of the file.
  const std::size_t left = lines_.rest().size();
  if (element.count > (left + 1) / (2 * element.properties.size()))
    bad_input(name_, counted(left, "byte") + " of data", announced(element));
}

void PlyText::pass_words(const PlyProperty& property, std::string_view& rest) const {
  double values = 1;
  if (property.count_type) values = take_coordinate(rest, lines_, name_);
  for (double i = 0; i < values; ++i)
    if (take_word(rest).empty()) bad_input(at_line(name_, lines_.number()), in_quotes(lines_.line()), "more values");
}

void PlyText::next(const PlyElement& element, std::size_t index) {
  if (!lines_.next_with_content())
    bad_input(name_, counted(index, shown(element.name) + " element"), announced(element));
}

}  // namespace rbpa::app
