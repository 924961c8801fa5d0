// What:   reads PCD, the format of the Point Cloud Library, versions 0.5 to 0.7.
// Source: https://pointclouds.org/documentation/tutorials/pcd_file_format.html
#include <lzf.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "io/bytes/available_memory.h"
#include "io/cloud/element_cloud.h"
#include "io/failure.h"
#include "io/scalar.h"
#include "io/text/lines.h"
#include "io/text/vertex_lines.h"

namespace rbpa::app {
namespace {

std::vector<std::string_view> all_words(std::string_view rest) {
  std::vector<std::string_view> words;
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) words.push_back(word);
  return words;
}

/// A header in the form of a PLY header, with points as the only element.
struct PcdHeader {
  PlyHeader header = {};
  bool is_compressed = false;  ///< the data are columns: all values of one field, then those of the next
};

class PcdHeaderReader {
 public:
  PcdHeaderReader(std::string_view bytes, const std::string& name) : lines_(bytes), name_(name) {}

  PcdHeader read() {
    while (header_.data.data() == nullptr) {
      if (!lines_.next_with_content()) refuse_end();
      std::string_view rest = lines_.line();
      const std::string_view word = take_word(rest);
      if (fields_.empty() && word != "VERSION" && word != "FIELDS" && word != "COLUMNS")
        bad_input(at_line(name_, lines_.number()), in_quotes(lines_.line()),
                  "a .pcd file, which begins with VERSION or FIELDS");
      take(word, rest);
    }
    lay_out();
    count_points();
    return {std::move(header_), is_compressed_};
  }

 private:
  [[noreturn]] void refuse(const std::string& expected) const {
    bad_input(at_line(name_, lines_.number()), in_quotes(lines_.line()), expected);
  }
  [[noreturn]] void refuse_end() const {
    if (fields_.empty()) bad_input(name_, "no line that begins with FIELDS", "the header of a .pcd file");
    bad_input(name_, "the end of the file in the header", "DATA");
  }
  std::size_t number(std::string_view rest) const {
    const std::optional<std::size_t> value = parse_count(trimmed(rest));
    if (!value) refuse("a number of points");
    return *value;
  }

  void take(std::string_view word, std::string_view rest) {
    if (word == "FIELDS" || word == "COLUMNS") {
      fields_ = all_words(rest);
      if (fields_.empty()) refuse("the names of fields");
    } else if (word == "SIZE") {
      sizes_ = all_words(rest);
    } else if (word == "TYPE") {
      types_ = all_words(rest);
    } else if (word == "COUNT") {
      counts_ = all_words(rest);
    } else if (word == "WIDTH") {
      width_ = number(rest);
      size_line_ = lines_.number();
    } else if (word == "HEIGHT") {
      height_ = number(rest);
    } else if (word == "POINTS") {
      count_ = number(rest);
      count_line_ = lines_.number();
    } else if (word == "DATA") {
      take_data(trimmed(rest));
    } else if (word != "VERSION" && word != "VIEWPOINT") {
      refuse("one of VERSION, FIELDS, SIZE, TYPE, COUNT, WIDTH, HEIGHT, POINTS, VIEWPOINT and DATA");
    }
  }

  void take_data(std::string_view kind) {
    is_compressed_ = kind == "binary_compressed";
    if (kind != "ascii" && kind != "binary" && !is_compressed_) refuse("ascii, binary or binary_compressed");
    if (kind != "ascii") header_.binary = std::endian::little;
    header_.lines = lines_.number();
    header_.data = lines_.rest();
  }

  void lay_out() {
    const auto require = [&](const std::vector<std::string_view>& words, const std::string& word) {
      if (words.size() != fields_.size())
        bad_input(name_, counted(words.size(), "word") + " after " + word,
                  std::to_string(fields_.size()) + ", one for each of FIELDS");
    };
    require(sizes_, "SIZE");
    require(types_, "TYPE");
    if (!counts_.empty()) require(counts_, "COUNT");
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      constexpr std::string_view letters = "IUF", kinds = "iuf";
      const std::size_t letter = letters.find(types_[i]);
      const std::optional<Scalar> type =
          scalar_of(kinds.substr(std::min(letter, kinds.size()), types_[i].size()), sizes_[i]);
      if (!type)
        bad_input(name_ + ": field " + shown(fields_[i]),
                  in_quotes(std::string(types_[i]) + " " + std::string(sizes_[i])),
                  "a type F, I or U and its size in bytes");
      const std::optional<std::size_t> count = counts_.empty() ? 1 : parse_count(counts_[i]);
      constexpr std::size_t most = 65536;  // descriptors have some hundred values
      if (!count || *count > most)
        bad_input(name_ + ": field " + shown(fields_[i]), "a count of " + in_quotes(counts_[i]),
                  "one from 0 to " + std::to_string(most));
      if (*count == 0) continue;  // a field without values has no bytes
      // Skip fields called "_": the Point Cloud Library does not write these gaps if it compresses.
      if (is_compressed_ && fields_[i] == "_") continue;
      points_.properties.push_back({std::string(fields_[i]), *type, std::nullopt, *count});
    }
  }

  void count_points() {
    if (!count_ && !width_) bad_input(name_, "a header without POINTS", "the number of points");
    const std::size_t height = height_.value_or(1);
    const bool fits = !width_ || height == 0 || *width_ <= ~std::size_t{0} / height;
    if (width_ && (!fits || (count_ && *count_ != *width_ * height)))
      bad_input(name_, count_ ? counted(*count_, "point") : "WIDTH and HEIGHT beyond any file",
                std::to_string(*width_) + " times " + std::to_string(height) + " as WIDTH and HEIGHT say");
    points_.count = count_ ? *count_ : *width_ * height;
    points_.line = count_ ? count_line_ : size_line_;
    if (!is_compressed_ && !points_.properties.empty()) require_room();
    header_.elements.push_back(std::move(points_));
  }

  /// Throws BadInput if the file is too short for its points. In text each number takes two characters, the last number
  /// one.
  void require_room() const {
    const std::size_t left = header_.data.size();
    const std::size_t room = header_.binary ? left / points_.least_size() : (left + 1) / (2 * points_.least_words());
    if (points_.count > room) bad_input(name_, counted(left, "byte") + " of data", announced(points_));
  }

  Lines lines_;
  const std::string& name_;
  PlyHeader header_{};
  bool is_compressed_ = false;
  PlyElement points_{.name = "point", .noun = "point"};
  std::vector<std::string_view> fields_ = {}, sizes_ = {}, types_ = {}, counts_ = {};
  std::optional<std::size_t> width_ = std::nullopt, height_ = std::nullopt, count_ = std::nullopt;
  std::size_t size_line_ = 0, count_line_ = 0;
};

PointLayout lay_out(const PlyElement& points, const std::string& name) {
  PointLayout layout;
  constexpr std::string_view axes[] = {"x", "y", "z"}, colors[] = {"rgb", "rgba"};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::optional<std::size_t> place = number_place(points, axes[k]);
    if (!place) bad_input(name, "points without " + in_quotes(axes[k]), "the fields x, y and z");
    layout.columns.emplace_back(k, *place);
  }
  lay_out_normal(points, {"normal_x", "normal_y", "normal_z"}, layout);
  if (const std::vector<std::size_t> color = number_places(points, colors); !color.empty()) {
    const PlyProperty& first = points.properties[color.front()];
    if (size_of(first.type) == 4) {
      layout.color = color.front();
      layout.facts.colors = Channels::bytes;
    } else {
      layout.facts.file.warnings.emplace_back("colors are left out, as " + first.name + " is not of 4 bytes");
    }
  }
  return layout;
}

/// The greatest compression ratio of the format: three bytes stand for a copy of at most 264 bytes.
constexpr std::size_t most_for_each = 88;

/// Bytes of memory for each decompressed byte: the byte itself, and two for the points, as numbers of 4 bytes become 8.
constexpr double bytes_in_memory = 3;

/// Returns the `size` bytes that LZF (M. Lehmann, liblzf) has compressed to `compressed`. Throws BadInput that names
/// `place`, where the data are, before memory is allocated if `compressed` is too short for `size` or memory does not
/// suffice.
std::vector<char> decompress_lzf(std::string_view compressed, std::size_t size, const std::string& place) {
  constexpr std::size_t most = std::numeric_limits<unsigned>::max();
  if (size > most || compressed.size() > most || size > most_for_each * compressed.size())
    bad_input(place, counted(compressed.size(), "byte") + " of compressed data",
              std::to_string(size / most_for_each + (size % most_for_each > 0 ? 1 : 0)) + " or more for " +
                  counted(size, "byte") + " decompressed");
  const std::optional<double> there = available_memory();
  if (there && bytes_in_memory * static_cast<double>(size) > *there)
    bad_input(place, bytes_text(static_cast<double>(size)) + " decompressed",
              "at most a third of the " + bytes_text(*there) + " of available memory (split the file)");
  std::vector<char> decompressed(size);
  if (size == 0) return decompressed;
  const unsigned count = lzf_decompress(compressed.data(), static_cast<unsigned>(compressed.size()),
                                        decompressed.data(), static_cast<unsigned>(size));
  if (count != size)
    bad_input(place,
              count == 0 ? "compressed data that are damaged" : "data that decompress to " + counted(count, "byte"),
              counted(size, "byte") + " of points (copy the file again, or save it as DATA binary)");
  return decompressed;
}

/// The two sizes, in bytes, that precede compressed data.
struct CompressedSizes {
  static constexpr std::size_t room = 8;
  std::uint32_t compressed = 0, decompressed = 0;

  explicit CompressedSizes(std::string_view data)
      : compressed(load<std::uint32_t>(data.data(), std::endian::little)),
        decompressed(load<std::uint32_t>(data.data() + sizeof compressed, std::endian::little)) {}
};

/// Returns the decompressed data of a file whose data are compressed. Throws BadInput that names `name`.
std::vector<char> decompress(const PlyHeader& header, const std::string& name) {
  const PlyElement& points = header.elements.front();
  const std::string_view data = header.data;
  if (data.size() < CompressedSizes::room)
    bad_input(name, counted(data.size(), "byte") + " of data",
              "at least " + std::to_string(CompressedSizes::room) +
                  ", the compressed and the decompressed size "
                  "(copy the file again)");
  const CompressedSizes sizes(data);
  const std::size_t each = points.least_size(), there = data.size() - CompressedSizes::room;
  if (points.count > sizes.decompressed / each || points.count * each != sizes.decompressed)
    bad_input(name, "a decompressed size of " + counted(sizes.decompressed, "byte"),
              announced(points) + ", with " + counted(each, "byte") + " each");
  if (sizes.compressed > there)
    bad_input(name, counted(there, "byte") + " of compressed data",
              std::to_string(sizes.compressed) + " as the compressed size after line " + std::to_string(header.lines) +
                  " says");
  return decompress_lzf(data.substr(CompressedSizes::room, sizes.compressed), sizes.decompressed,
                        name + ": after line " + std::to_string(header.lines));
}

std::unique_ptr<Cloud> open_pcd(Content content, const CloudRequest& request) {
  auto [header, is_compressed] = PcdHeaderReader(content.ahead(), content.name()).read();
  PointLayout layout = lay_out(header.elements.front(), content.name());
  if (is_compressed) {
    layout.decompressed = decompress(header, content.name());
    header.data = {layout.decompressed.data(), layout.decompressed.size()};
    layout.by_columns = layout.has_room = true;
  }
  return open_elements(std::move(content), std::move(header), std::move(layout), request);
}

}  // namespace

/// Reads PCD, the Point Cloud Library's format, versions 0.5 to 0.7, ASCII or binary, compressed or not: x, y, z;
/// normal_x, normal_y, normal_z if all three are there; rgb or rgba.
const CloudFormat pcd_reader = {.open = open_pcd, .fields = names_of_properties, .skips_invalid = true};

}  // namespace rbpa::app
