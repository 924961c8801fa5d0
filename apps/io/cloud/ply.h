// What: reads the header of a PLY file, and passes once over its elements, one kind after another. The readers of PCD
//       and OFF also describe their points as elements.
// Law:  no step reads beyond the data; if data are missing, it throws BadInput that names the element and its count.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/interrupt.h"
#include "io/scalar.h"
#include "io/text/lines.h"

namespace rbpa::app {

struct PlyProperty {
  std::string name;
  Scalar type;                                      ///< type of the value, or of each value of the list
  std::optional<Scalar> count_type = std::nullopt;  ///< type of the length of a list; absent if it is not a list
  std::size_t count = 1;  ///< number of values, unless it is a list; 1 in PLY, any number in PCD

  /// Returns the size of the property in a binary file, in bytes; for a list, the size of an empty list.
  std::size_t least_size() const { return count_type ? size_of(*count_type) : count * size_of(type); }
};

struct PlyElement {
  std::string name;
  std::string noun;  ///< the name of one element in messages: "vertex element"
  std::size_t count = 0;
  std::size_t line = 0;  ///< number of the line of the header with the count
  std::vector<PlyProperty> properties = {};

  bool has_lists() const;
  /// Returns the size of one element in a binary file, in bytes, with every list empty.
  std::size_t least_size() const;
  /// Returns the number of words of one element in text, with every list empty.
  std::size_t least_words() const;
};

struct PlyHeader {
  std::optional<std::endian> binary = std::nullopt;  ///< the byte order; absent if the file is ASCII
  std::vector<PlyElement> elements = {};
  std::size_t lines = 0;       ///< number of lines of the header
  std::string_view data = {};  ///< the bytes after the header
};

/// Reads the header of a PLY file. Throws BadInput that names the line.
PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

/// Returns the count of an element for messages: "3 vertex elements as line 3 says".
std::string announced(const PlyElement& element);

/// Returns the element "vertex". Throws BadInput that names `name` if there is none.
const PlyElement& vertices_of(const PlyHeader& header, const std::string& name);

/// Returns the index, among the properties of `element`, of the one called `property`; nothing if there is none, or if
/// the property is not a single number.
std::optional<std::size_t> number_place(const PlyElement& element, std::string_view property);

/// Returns the indices of the properties of `element` that are called one of `names` and are single numbers, in the
/// order of `names`.
std::vector<std::size_t> number_places(const PlyElement& element, std::span<const std::string_view> names);

/// Returns the index of a property as number_place() does. Throws BadInput that lists the `wanted` properties if there
/// is none.
std::size_t find_number(const PlyElement& element, std::string_view property, std::string_view wanted,
                        const std::string& name);

/// A pass over the data of a binary file.
class PlyBinary {
 public:
  PlyBinary(const PlyHeader& header, const std::string& name)
      : order_(*header.binary), at_(header.data.data()), end_(at_ + header.data.size()), name_(name) {}

  /// Throws BadInput unless the remaining data are long enough for all of `element` with every list empty.
  void require_room(const PlyElement& element) const;

  /// Passes over the items from `first` up to, not including, `last` of `element`, and calls visit(index, offsets),
  /// where offsets[k] points to the data of property k. Requires: require_room(element) was called.
  template <typename Visit>
  void pass(const PlyElement& element, std::size_t first, std::size_t last, Visit&& visit) {
    std::vector<const char*> offsets(element.properties.size());
    for (std::size_t i = first; i < last; ++i) {
      if (i % 16384 == 0) stop_if_interrupted();
      for (std::size_t k = 0; k < offsets.size(); ++k) {
        offsets[k] = at_;
        pass(element.properties[k], element, i);
      }
      visit(i, offsets);
    }
  }
  /// Skips all items of `element`. Requires: require_room(element) was called.
  void skip(const PlyElement& element);

  /// Skips `count` items of `element`, and returns the place where they begin. Requires: `element` has no lists, and
  /// require_room(element) was called.
  const char* take_rows(const PlyElement& element, std::size_t count) {
    const char* const first = at_;
    at_ += count * element.least_size();
    return first;
  }

 private:
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  void pass(const PlyProperty& property, const PlyElement& element, std::size_t index) {
    if (property.count_type == Scalar::uint8 && at_ != end_) {  // true for nearly all lists of corners
      const std::size_t size = 1 + static_cast<unsigned char>(*at_) * size_of(property.type);
      if (size <= left()) {
        at_ += size;
        return;
      }
    }
    pass_any(property, element, index);
  }
  void pass_any(const PlyProperty& property, const PlyElement& element, std::size_t index);
  void take(std::size_t size, const PlyElement& element, std::size_t index);

  std::endian order_;
  const char* at_;
  const char* end_;
  const std::string& name_;
};

/// A pass over the data of an ASCII file: one element in each line, after which other words are ignored; or, if there
/// are too few lines, the words of all elements one after another.
class PlyText {
 public:
  /// Refers to `header` and `name`, which must outlive this object.
  PlyText(const PlyHeader& header, const std::string& name)
      : header_(header), lines_(header.data, header.lines), name_(name) {}

  /// Throws BadInput unless the remaining data are long enough for all of `element` with every list empty.
  void require_room(const PlyElement& element) const;

  /// Passes over the items from `first` up to, not including, `last` of `element`, and calls visit(index, rest), which
  /// removes the words of all properties from the front of `rest`.
  template <typename Visit>
  void pass(const PlyElement& element, std::size_t first, std::size_t last, Visit&& visit) {
    for (std::size_t i = first; i < last; ++i) {
      if (i % 16384 == 0) stop_if_interrupted();
      if (rest_.empty()) next(element, i);
      visit(i, rest_);
      rest_ = trimmed(rest_);
      if (!rest_.empty()) settle_rest(element, i);
    }
  }
  void skip(const PlyElement& element) {
    pass(element, 0, element.count, [&](std::size_t, std::string_view& rest) {
      for (const PlyProperty& property : element.properties) pass_words(property, rest);
    });
  }

  /// Removes the words of one property from `rest`. The caller has already removed the first `read` of them.
  void pass_words(const PlyProperty& property, std::string_view& rest, std::size_t read = 0) const;

  const Lines& lines() const { return lines_; }
  /// Throws BadInput if there is more text than blank lines and comments after the elements.
  void require_end();

 private:
  void next(const PlyElement& element, std::size_t index);
  void settle_rest(const PlyElement& element, std::size_t index);
  bool are_words_of_rest(const PlyElement& element, std::size_t index) const;

  const PlyHeader& header_;
  Lines lines_;
  std::string_view rest_ = {};  // rest of the line, if several elements are in a line
  bool is_by_words_ = false;
  bool is_by_lines_ = false;  // both false: not decided
  const std::string& name_;
};

}  // namespace rbpa::app
