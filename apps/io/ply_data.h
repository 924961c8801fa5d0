// What: the elements of a PLY file behind its header, passed over one kind after the other.
// Law:  each step stays inside the data, or throws BadInput naming the element and what the header announces.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/interrupt.h"
#include "io/lines.h"
#include "io/ply_header.h"

namespace rbpa::app {

/// "3 vertex elements as line 3 says".
std::string announced(const PlyElement& element);

/// The element "vertex". Throws BadInput when there is none.
const PlyElement& vertices_of(const PlyHeader& header, const std::string& name);

/// Where the property that is one number lies among those of `element`; nothing when there is none.
std::optional<std::size_t> number_place(const PlyElement& element, std::string_view property);

/// Where the property that is one number lies among those of `element`. Throws BadInput when there is none, naming the
/// `wanted` properties.
std::size_t find_number(const PlyElement& element, std::string_view property, std::string_view wanted,
                        const std::string& name);

/// A Claim: the bytes of all elements, or as many lines. A binary list says how long it is where it stands.
double claimed_ply_size(std::string_view first, const std::string& name);

/// The data of a binary file.
class PlyBinary {
 public:
  PlyBinary(const PlyHeader& header, const std::string& name)
      : order_(*header.binary), at_(header.data.data()), end_(at_ + header.data.size()), name_(name) {}

  /// What comes next is long enough for `element` with every list empty.
  void require_room(const PlyElement& element) const;

  /// Passes over all of `element`, which has room. `visit(index, offsets)` gets where each property begins.
  template <typename Visit>
  void pass(const PlyElement& element, Visit&& visit) {
    std::vector<const char*> offsets(element.properties.size());
    for (std::size_t i = 0; i < element.count; ++i) {
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

  const char* at() const { return at_; }

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

/// The data of an ASCII file: one element a line.
class PlyText {
 public:
  PlyText(const PlyHeader& header, const std::string& name) : lines_(header.data, header.lines), name_(name) {}

  /// What comes next is long enough for `element` with every list empty.
  void require_room(const PlyElement& element) const;

  /// Passes over the lines of `element`. `visit(index, rest)` gets the line, of which it may take words.
  template <typename Visit>
  void pass(const PlyElement& element, Visit&& visit) {
    for (std::size_t i = 0; i < element.count; ++i) {
      if (i % 16384 == 0) stop_if_interrupted();
      next(element, i);
      std::string_view rest = lines_.line();
      visit(i, rest);
    }
  }
  void skip(const PlyElement& element) {
    pass(element, [](std::size_t, std::string_view&) {});
  }

  /// Passes over the words of one property in `rest`.
  void pass_words(const PlyProperty& property, std::string_view& rest) const;

  const Lines& lines() const { return lines_; }

 private:
  void next(const PlyElement& element, std::size_t index);

  Lines lines_;
  const std::string& name_;
};

}  // namespace rbpa::app
