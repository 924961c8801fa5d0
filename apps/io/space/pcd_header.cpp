#include "io/space/pcd_header.h"

#include <algorithm>
#include <utility>

#include "io/claim.h"
#include "io/failure.h"
#include "io/lines.h"
#include "io/vertex_lines.h"

namespace rbpa::app {
namespace {

std::optional<Scalar> scalar_of(std::string_view type, std::string_view size) {
  constexpr std::pair<std::string_view, Scalar> known[] = {
      {"F4", Scalar::float32}, {"F8", Scalar::float64}, {"I1", Scalar::int8},  {"I2", Scalar::int16},
      {"I4", Scalar::int32},   {"I8", Scalar::int64},   {"U1", Scalar::uint8}, {"U2", Scalar::uint16},
      {"U4", Scalar::uint32},  {"U8", Scalar::uint64}};
  const std::string wanted = std::string(type) + std::string(size);
  for (const auto& [text, scalar] : known)
    if (wanted == text) return scalar;
  return std::nullopt;
}

std::vector<std::string_view> words_of(std::string_view rest) {
  std::vector<std::string_view> words;
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) words.push_back(word);
  return words;
}

class HeaderReader {
 public:
  /// Of a file of `size` bytes of which `bytes` are the first.
  HeaderReader(std::string_view bytes, std::size_t size, const std::string& name)
      : lines_(bytes), missing_(size - bytes.size()), name_(name) {}

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
    return std::move(header_);
  }

 private:
  [[noreturn]] void refuse(const std::string& expected) const {
    bad_input(at_line(name_, lines_.number()), in_quotes(lines_.line()), expected);
  }
  [[noreturn]] void refuse_end() const {
    if (fields_.empty()) bad_input(name_, "no PCD header", "a .pcd file");
    bad_input(name_, "the end of the file in the header", "DATA");
  }
  std::size_t number(std::string_view rest) const {
    const std::optional<std::size_t> value = parse_count(trimmed(rest));
    if (!value) refuse("a number of points");
    return *value;
  }

  void take(std::string_view word, std::string_view rest) {
    if (word == "FIELDS" || word == "COLUMNS") {
      fields_ = words_of(rest);
      if (fields_.empty()) refuse("the names of fields");
    } else if (word == "SIZE") {
      sizes_ = words_of(rest);
    } else if (word == "TYPE") {
      types_ = words_of(rest);
    } else if (word == "COUNT") {
      counts_ = words_of(rest);
    } else if (word == "WIDTH") {
      width_ = number(rest);
      size_line_ = lines_.number();
    } else if (word == "HEIGHT") {
      height_ = number(rest);
    } else if (word == "POINTS") {
      points_ = number(rest);
      points_line_ = lines_.number();
    } else if (word == "DATA") {
      take_data(trimmed(rest));
    } else if (word != "VERSION" && word != "VIEWPOINT") {
      refuse("a line of the header, or DATA");
    }
  }

  void take_data(std::string_view kind) {
    if (kind == "binary_compressed")
      refuse("ascii or binary (pcl_convert_pcd_ascii_binary FILE points.pcd 1 writes what is compressed so)");
    if (kind != "ascii" && kind != "binary") refuse("ascii or binary");
    header_.binary = kind == "binary";
    header_.lines = lines_.number();
    header_.data = lines_.rest();
  }

  void lay_out() {
    const auto require = [&](const std::vector<std::string_view>& words, const std::string& word) {
      if (words.size() != fields_.size())
        bad_input(name_, counted(words.size(), "word") + " behind " + word,
                  std::to_string(fields_.size()) + ", one for each of FIELDS");
    };
    require(sizes_, "SIZE");
    require(types_, "TYPE");
    if (!counts_.empty()) require(counts_, "COUNT");
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const std::optional<Scalar> type = scalar_of(types_[i], sizes_[i]);
      if (!type)
        bad_input(name_ + ": field " + shown(fields_[i]),
                  in_quotes(std::string(types_[i]) + " " + std::string(sizes_[i])),
                  "a type F, I or U and its size in bytes");
      const std::optional<std::size_t> count = counts_.empty() ? 1 : parse_count(counts_[i]);
      constexpr std::size_t most = 65536;  // descriptors have some hundreds
      if (!count || *count == 0 || *count > most)
        bad_input(name_ + ": field " + shown(fields_[i]), "a count of " + in_quotes(counts_[i]),
                  "one from 1 to " + std::to_string(most));
      header_.fields.push_back({std::string(fields_[i]), *type, *count, header_.numbers, header_.size});
      header_.numbers += *count;
      header_.size += *count * size_of(*type);
    }
  }

  void count_points() {
    if (!points_ && !width_) bad_input(name_, "a header without POINTS", "how many there are");
    const std::size_t height = height_.value_or(1);
    const bool fits = !width_ || height == 0 || *width_ <= ~std::size_t{0} / height;
    if (width_ && (!fits || (points_ && *points_ != *width_ * height)))
      bad_input(name_, points_ ? counted(*points_, "point") : "WIDTH and HEIGHT beyond any file",
                std::to_string(*width_) + " times " + std::to_string(height) + " as WIDTH and HEIGHT say");
    header_.points = points_ ? *points_ : *width_ * height;
    header_.line = points_ ? points_line_ : size_line_;
    // Of text each number takes a character, and another behind it unless it is the last of the file.
    const std::size_t left = header_.data.size() + missing_;
    const std::size_t room = header_.binary ? left / header_.size : (left + 1) / (2 * header_.numbers);
    if (header_.points > room) bad_input(name_, counted(left, "byte") + " of data", announced(header_));
  }

  Lines lines_;
  std::size_t missing_;
  const std::string& name_;
  PcdHeader header_{};
  std::vector<std::string_view> fields_ = {}, sizes_ = {}, types_ = {}, counts_ = {};
  std::optional<std::size_t> width_ = std::nullopt, height_ = std::nullopt, points_ = std::nullopt;
  std::size_t size_line_ = 0, points_line_ = 0;
};

}  // namespace

const PcdField* PcdHeader::find(std::string_view name) const {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const PcdField& f) { return f.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

std::string announced(const PcdHeader& header) {
  return counted(header.points, "point") + " as line " + std::to_string(header.line) + " says";
}

PcdHeader read_pcd_header(std::string_view bytes, const std::string& name) {
  return HeaderReader(bytes, bytes.size(), name).read();
}

double claimed_pcd_size(std::string_view first, const std::string& name) {
  const PcdHeader header = HeaderReader(first, unknown_size, name).read();
  const auto points = static_cast<double>(header.points);
  if (!header.binary) return end_of_lines(first, Lines(header.data), points);
  return static_cast<double>(first.size() - header.data.size()) + points * static_cast<double>(header.size);
}

}  // namespace rbpa::app
