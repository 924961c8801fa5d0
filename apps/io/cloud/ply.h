// What: the header of a PLY file, and the elements behind it, passed over one kind after the other. PCD and OFF describe their
//       points as one kind of elements.
// Law:  each step stays inside the data, or throws BadInput naming the element and what the header announces.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/scalar.h"
#include "io/interrupt.h"
#include "io/text/lines.h"

namespace rbpa::app {

struct PlyProperty {
  std::string name;
  Scalar type;                                      ///< of the value, or of each value of the list
  std::optional<Scalar> count_type = std::nullopt;  ///< of the length before the values, when it is a list
  std::size_t count = 1;                            ///< of the values, when it is none; of PLY always one

  /// Bytes that it takes in a binary file, as a list when it is empty.
  std::size_t least_size() const { return count_type ? size_of(*count_type) : count * size_of(type); }
};

struct PlyElement {
  std::string name;
  std::string noun;  ///< what messages call one: "vertex element"
  std::size_t count = 0;
  std::size_t line = 0;  ///< of the header, that says so
  std::vector<PlyProperty> properties = {};

  bool has_lists() const;
  /// Bytes that one takes in a binary file, with every list empty.
  std::size_t least_size() const;
  /// Words that one takes in text.
  std::size_t least_words() const;
};

struct PlyHeader {
  std::optional<std::endian> binary = std::nullopt;  ///< the byte order; none when the file is ASCII
  std::vector<PlyElement> elements = {};
  std::size_t lines = 0;       ///< of the header
  std::string_view data = {};  ///< what follows it
};

/// Throws BadInput naming the line.
PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

/// "3 vertex elements as line 3 says".
std::string announced(const PlyElement& element);

/// The element "vertex". Throws BadInput when there is none.
const PlyElement& vertices_of(const PlyHeader& header, const std::string& name);

/// Where the property that is one number lies among those of `element`; nothing when there is none.
std::optional<std::size_t> number_place(const PlyElement& element, std::string_view property);

/// The same of those of `names` that are there.
std::vector<std::size_t> number_places(const PlyElement& element, std::span<const std::string_view> names);

/// Where the property that is one number lies among those of `element`. Throws BadInput when there is none, naming the
/// `wanted` properties.
std::size_t find_number(const PlyElement& element, std::string_view property, std::string_view wanted,
                        const std::string& name);

/// For a Claim: the bytes of all elements, or as many lines. A binary list says how long it is where it stands. `header` is that of
/// `first`.
double claimed_size(const PlyHeader& header, std::string_view first);
double claimed_ply_size(std::string_view first, const std::string& name);

/// The data of a binary file.
class PlyBinary {
 public:
  PlyBinary(const PlyHeader& header, const std::string& name)
      : order_(*header.binary), at_(header.data.data()), end_(at_ + header.data.size()), name_(name) {}

  /// What comes next is long enough for `element` with every list empty.
  void require_room(const PlyElement& element) const;

  /// Passes over `element`, which has room, from one to another. `visit(index, offsets)` gets where each property begins.
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
  /// Passes over all of `element`, which has room.
  void skip(const PlyElement& element);

  /// Where `count` of `element` lie, which has no lists; passes over them.
  const char* take_rows(const PlyElement& element, std::size_t count) {
    const char* const first = at_;
    at_ += count * element.least_size();
    return first;
  }

 private:
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  void pass(const PlyProperty& property, const PlyElement& element, std::size_t index) {
    if (property.count_type == Scalar::uint8 && at_ != end_) {  // as nearly all lists of corners
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

/// The data of an ASCII file: one element a line, with more words behind it or not; or, where there are too few lines
/// for that, as many words one behind the other as all elements have.
class PlyText {
 public:
  /// Keeps the header.
  PlyText(const PlyHeader& header, const std::string& name)
      : header_(header), lines_(header.data, header.lines), name_(name) {}

  /// What comes next is long enough for `element` with every list empty.
  void require_room(const PlyElement& element) const;

  /// Passes over `element`, from one to another. `visit(index, rest)` gets the words from its first on, of which it
  /// takes those of all properties.
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

  /// Passes over the words of one property in `rest`, of which so many have been read.
  void pass_words(const PlyProperty& property, std::string_view& rest, std::size_t read = 0) const;

  const Lines& lines() const { return lines_; }
  /// Goes to what is behind all elements; false when there is nothing.
  bool has_more() { return !rest_.empty() || lines_.next_with_content(); }

 private:
  void next(const PlyElement& element, std::size_t index);
  void settle_rest(const PlyElement& element, std::size_t index);
  bool are_words_of_rest(const PlyElement& element, std::size_t index) const;

  const PlyHeader& header_;
  Lines lines_;
  std::string_view rest_ = {};  // of the line, where elements follow each other in it
  bool is_by_words_ = false;
  bool is_by_lines_ = false;  // for sure
  const std::string& name_;
};

}  // namespace rbpa::app
