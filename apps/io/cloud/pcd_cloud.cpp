// What:   points of the Point Cloud Library's format, version 0.5 to 0.7.
// Source: https://pointclouds.org/documentation/tutorials/pcd_file_format.html
#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "io/bytes/number.h"
#include "io/cloud/colors.h"
#include "io/cloud/readers.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/text/lines.h"
#include "io/text/vertex_lines.h"

namespace rbpa::app {
namespace {

struct PcdField {
  std::string name;
  Scalar type;
  std::size_t count;   ///< numbers of it in each point
  std::size_t first;   ///< which number of the point is its first
  std::size_t offset;  ///< where it begins among the bytes of a point
};

struct PcdHeader {
  std::vector<PcdField> fields;
  std::size_t points;
  std::size_t line;         ///< that says how many
  bool binary;              ///< else ASCII
  std::size_t lines;        ///< of the header
  std::string_view data;    ///< what follows it
  std::size_t numbers = 0;  ///< of a point
  std::size_t size = 0;     ///< of a point in bytes

  const PcdField* find(std::string_view name) const;  ///< null when there is none
};

const PcdField* PcdHeader::find(std::string_view name) const {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const PcdField& f) { return f.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

/// "3 points as line 9 says".
std::string announced(const PcdHeader& header) {
  return counted(header.points, "point") + " as line " + std::to_string(header.line) + " says";
}

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

std::vector<std::string_view> all_words(std::string_view rest) {
  std::vector<std::string_view> words;
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) words.push_back(word);
  return words;
}

class PcdHeaderReader {
 public:
  /// Of a file of `size` bytes of which `bytes` are the first.
  PcdHeaderReader(std::string_view bytes, std::size_t size, const std::string& name)
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

/// The three bytes 0xRRGGBB behind the colours of a block.
void append_color(std::uint32_t bits, CloudBlock& block) {
  for (std::size_t k = 0; k < 3; ++k) block.column[CloudBlock::color + k].push_back(bits >> (16 - 8 * k) & 0xFFU);
}

/// The bits of a colour in text: of a float those of the number that is written.
std::uint32_t color_bits(double number, const PcdField& field, const std::string& here) {
  const bool bits_of_float = field.type == Scalar::float32;
  const double least = bits_of_float ? -0x1.fffffep127 : -0x1p31,
               greatest = bits_of_float ? 0x1.fffffep127 : 0x1p32 - 1;
  if (!(number >= least && number <= greatest)) bad_input(here, in_quotes(ShortestText(number)), "a colour of 4 bytes");
  if (bits_of_float) return std::bit_cast<std::uint32_t>(static_cast<float>(number));
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(number));  // signed, or not
}

class PcdCloud final : public Cloud {
 public:
  PcdCloud(Content content, const CloudRequest& request)
      : content_(std::move(content)),
        name_(content_.name()),
        header_(PcdHeaderReader(content_.ahead(), content_.ahead().size(), name_).read()),
        lines_(header_.data, header_.lines) {
    lay_out();
    if (request.where) lay_out_condition(*request.where);
    facts_.expected = header_.points;
  }

  bool next(CloudBlock& block) override {
    block.count = 0;
    while (block.count == 0 && first_ < header_.points) {
      stop_if_interrupted();
      block.count = std::min(points_at_once, header_.points - first_);
      clear_colors(block);
      header_.binary ? read_binary(block) : read_text(block);
      const std::size_t first = std::exchange(first_, first_ + block.count);
      selection_ ? selection_->select(block, fields_, first, name_) : require_finite(block, first, name_);
    }
    return block.count > 0;
  }

  void finish() override {
    if (selection_) selection_->remark(facts_.file.remarks);
  }

 private:
  void lay_out() {
    for (const std::string_view axis : {"x", "y", "z"}) {
      numbers_.push_back(header_.find(axis));
      if (numbers_.back() == nullptr) bad_input(name_, "points without " + in_quotes(axis), "the fields x, y and z");
    }
    std::vector<const PcdField*> normal;
    for (const std::string_view axis : {"normal_x", "normal_y", "normal_z"})
      if (const PcdField* field = header_.find(axis)) normal.push_back(field);
    facts_.normals = normal.size() == 3;
    if (facts_.normals) numbers_.insert(numbers_.end(), normal.begin(), normal.end());
    if (normal.size() == 1 || normal.size() == 2)
      facts_.file.remarks.emplace_back("normals are left out, as not all of normal_x, normal_y and normal_z are there");
    const PcdField* color = header_.find("rgb") != nullptr ? header_.find("rgb") : header_.find("rgba");
    if (color != nullptr && size_of(color->type) == 4) color_ = color;
    if (color_ != nullptr) facts_.colors = Channels::bytes;
    if (color != nullptr && color_ == nullptr)
      facts_.file.remarks.emplace_back("colours are left out, as " + color->name + " is not of 4 bytes");
  }

  void lay_out_condition(const Condition& where) {
    for (const std::string& field : where.fields()) {
      asked_.push_back(header_.find(field));
      if (asked_.back() == nullptr)
        bad_input(name_, "points without " + in_quotes(field), "a field of that name, as --where asks");
    }
    fields_.resize(asked_.size());
    selection_.emplace(where);
  }

  void read_binary(CloudBlock& block) {
    constexpr std::endian order = std::endian::little;
    const char* const points = header_.data.data() + first_ * header_.size;
    const auto load_field = [&](std::vector<double>& column, const PcdField& field) {
      load_column(column, field.type, points + field.offset, header_.size, block.count, order);
    };
    for (std::size_t k = 0; k < numbers_.size(); ++k) load_field(block.column[k], *numbers_[k]);
    for (std::size_t k = 0; k < asked_.size(); ++k) load_field(fields_[k], *asked_[k]);
    for (std::size_t i = 0; color_ != nullptr && i < block.count; ++i)
      append_color(load<std::uint32_t>(points + i * header_.size + color_->offset, order), block);
  }

  void read_text(CloudBlock& block) {
    std::vector<bool> counts(header_.numbers, false);
    const auto mark = [&](const PcdField* field) { counts[field->first] = true; };
    std::for_each(numbers_.begin(), numbers_.end(), mark);
    std::for_each(asked_.begin(), asked_.end(), mark);
    if (color_ != nullptr) mark(color_);
    for (std::size_t k = 0; k < numbers_.size(); ++k) block.column[k].resize(block.count);
    for (std::vector<double>& field : fields_) field.resize(block.count);
    std::vector<double> value(header_.numbers);
    for (std::size_t i = 0; i < block.count; ++i) {
      if (!lines_.next_with_content()) bad_input(name_, counted(first_ + i, "point"), announced(header_));
      std::string_view rest = lines_.line();
      for (std::size_t k = 0; k < counts.size(); ++k) {
        if (counts[k])
          value[k] = take_coordinate(rest, lines_, name_);
        else if (take_word(rest).empty())
          bad_input(at_line(name_, lines_.number()), in_quotes(lines_.line()), "more values");
      }
      if (color_ != nullptr)
        append_color(color_bits(value[color_->first], *color_, at_line(name_, lines_.number())), block);
      for (std::size_t k = 0; k < numbers_.size(); ++k) block.column[k][i] = value[numbers_[k]->first];
      for (std::size_t k = 0; k < asked_.size(); ++k) fields_[k][i] = value[asked_[k]->first];
    }
  }

  Content content_;
  const std::string& name_;
  PcdHeader header_;
  Lines lines_;                                // of the points of text
  std::vector<const PcdField*> numbers_ = {};  // of x, y, z and, when there are six, of the normal
  const PcdField* color_ = nullptr;            // 0xRRGGBB in an integer, or in the bits of a float
  std::optional<PointSelection> selection_ = std::nullopt;
  std::vector<const PcdField*> asked_ = {};       // fields that the condition asks for
  std::vector<std::vector<double>> fields_ = {};  // their columns
  std::size_t first_ = 0;
};

}  // namespace

std::unique_ptr<Cloud> open_pcd(Content content, const CloudRequest& request) {
  return std::make_unique<PcdCloud>(std::move(content), request);
}

double claimed_pcd_size(std::string_view first, const std::string& name) {
  const PcdHeader header = PcdHeaderReader(first, unknown_size, name).read();
  const auto points = static_cast<double>(header.points);
  if (!header.binary) return end_of_lines(first, Lines(header.data), points);
  return static_cast<double>(first.size() - header.data.size()) + points * static_cast<double>(header.size);
}

}  // namespace rbpa::app
