#include "io/cloud/element_cloud.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "io/cloud/colors.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/text/vertex_lines.h"

namespace rbpa::app {
namespace {

/// Appends the three bytes 0xRRGGBB to the colors of a block.
void append_color(std::uint32_t bits, CloudBlock& block) {
  for (std::size_t k = 0; k < 3; ++k) block.column[CloudBlock::color + k].push_back(bits >> (16 - 8 * k) & 0xFFU);
}

/// Returns the bits of a color in text; those of a float's representation if the property is a float.
std::uint32_t color_bits(double number, Scalar type, const std::string& here) {
  const bool bits_of_float = type == Scalar::float32;
  const double least = bits_of_float ? -0x1.fffffep127 : -0x1p31,
               greatest = bits_of_float ? 0x1.fffffep127 : 0x1p32 - 1;
  if (!(number >= least && number <= greatest)) bad_input(here, in_quotes(text_of(number)), "a color of 4 bytes");
  if (bits_of_float) return std::bit_cast<std::uint32_t>(static_cast<float>(number));
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(number));  // signed or unsigned
}

/// Returns the index of the property of numbers called `field`, or else called so in letters of either case. Throws
/// BadInput that names `option`, which requires the property, if there is none.
std::size_t find_field(const PlyElement& points, const std::string& field, std::string_view option,
                       const std::string& name) {
  for (const bool in_any_case : {false, true})
    for (std::size_t k = 0; k < points.properties.size(); ++k)
      if (const PlyProperty& property = points.properties[k]; !property.count_type)
        if (in_any_case ? same_letters(property.name, field) : property.name == field) return k;
  bad_input(name, "no field " + in_quotes(field) + " of numbers", "one, as " + std::string(option) + " requires");
}

class ElementCloud final : public Cloud {
 public:
  ElementCloud(Content content, PlyHeader header, PointLayout layout, const CloudRequest& request)
      : content_(std::move(content)),
        name_(content_.name()),
        header_(std::move(header)),
        layout_(std::move(layout)),
        vertex_(header_.elements[layout_.element]),
        keeps_heights_(request.heights),
        needs_normals_(request.needs_normals),
        choice_(request) {
    facts_ = std::move(layout_.facts);
    facts_.expected = vertex_.count;
    if (request.where) {
      for (const std::string& field : request.where->fields())
        condition_.push_back(find_field(vertex_, field, request.where->option_of(field), name_));
      fields_.resize(condition_.size());
    }
    if (request.keeps) choose_fields(*request.keeps);
    for (std::size_t k = 0; k < condition_.size(); ++k)
      is_kept_.push_back(k < request.where->columns() &&
                         request.where->column(k).kind == WantedColumn::Kind::by_value &&
                         std::find(kept_.begin(), kept_.end(), condition_[k]) != kept_.end());
    if (header_.binary) {
      binary_.emplace(header_, name_);
    } else {
      text_.emplace(header_, name_);
    }
    for (const PlyElement& element : header_.elements) {
      if (&element == &vertex_) break;
      if (binary_) binary_->require_room(element);
      binary_ ? binary_->skip(element) : text_->skip(element);
    }
    if (layout_.has_room) return;
    binary_ ? binary_->require_room(vertex_) : text_->require_room(vertex_);
  }

  bool next(CloudBlock& block) override {
    block.count = 0;
    while (block.count == 0 && first_ < vertex_.count) {
      stop_if_interrupted();
      block.count = std::min(points_at_once, vertex_.count - first_);
      for (const auto& [column, property] : layout_.columns) block.column[column].resize(block.count);
      block.heights.assign(keeps_heights_ && layout_.height ? block.count : 0,
                           std::numeric_limits<double>::quiet_NaN());
      for (std::vector<double>& field : fields_) field.resize(block.count);
      if (layout_.color || layout_.colors_behind) clear_colors(block);
      if (text_)
        read_text(block);
      else if (vertex_.has_lists())
        read_with_lists(block);
      else
        read_rows(block);
      const std::size_t first = std::exchange(first_, first_ + block.count);
      const std::vector<std::uint8_t> kept = choice_(block, fields_, first, name_);
      if (!kept.empty() && !kept_.empty()) keep_values(facts_.file.kept, taken_, kept);
      taken_ += block.count;
    }
    if (block.count == 0) pass_rest();
    if (block.count == 0 && layout_.colors_behind) colors_.settle(vertex_.count > 0, facts_);
    return block.count > 0;
  }

  void finish() override {
    facts_.file.all_points = vertex_.count;
    choice_.add_warnings(name_, facts_.file.warnings);
  }

 private:
  /// Chooses the properties that are kept: single numbers that the layout does not use.
  void choose_fields(const FieldChoice& choice) {
    for (std::size_t k = 0; k < vertex_.properties.size(); ++k) {
      const PlyProperty& property = vertex_.properties[k];
      const bool is_used = std::any_of(layout_.columns.begin(), layout_.columns.end(),
                                       [&](const auto& column) { return column.second == k; });
      if (is_used || layout_.height == k || layout_.color == k || property.count_type || property.count != 1 ||
          property.name == "_" || !choice.has(property.name))
        continue;
      facts_.file.kept.push_back({.name = property.name, .type = property.type});
      kept_.push_back(k);
    }
  }
  /// Appends a value of a binary file to a column that is kept.
  void keep(std::size_t k, const char* at) {
    PointColumn& column = facts_.file.kept[k];
    with_type(column.type, [&](auto value) { column.append(load<decltype(value)>(at, *header_.binary)); });
  }
  /// Appends a word of text to a column that is kept; leaves out the column if the word is not of its type.
  void keep_word(std::size_t k, std::string_view word) {
    PointColumn& column = facts_.file.kept[k];
    if (!column.fault.empty()) return;
    with_type(column.type, [&](auto value) {
      using Value = decltype(value);
      if constexpr (std::is_integral_v<Value>) {
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error == std::errc() && end == word.data() + word.size()) return column.append(value);
      } else {
        const ParsedNumber number = parse_whole_number(word);
        if (number.fault == NumberFault::none || number.fault == NumberFault::not_finite)
          return column.append(static_cast<Value>(number.value));
      }
      column.fault = here() + ": found " + in_quotes(word) + ", expected a number of its type";
    });
  }

  bool looks_at_heights() const { return layout_.height && (keeps_heights_ || !facts_.file.heights.differ()); }
  void take_height(CloudBlock& block, std::size_t i, double z) {
    facts_.file.heights.take(z);
    if (keeps_heights_) block.heights[i - first_] = z;
  }

  /// The values of a property of some vertices: the first, and the distance in bytes between two.
  struct Strip {
    const char* first;
    std::size_t stride;
  };
  std::vector<Strip> take_strips(std::size_t count) {
    std::vector<Strip> strips;
    const char* const rows = layout_.by_columns ? nullptr : binary_->take_rows(vertex_, count);
    const std::size_t row = vertex_.least_size();
    std::size_t before = 0;
    for (const PlyProperty& property : vertex_.properties) {
      const std::size_t size = property.least_size();
      strips.push_back(layout_.by_columns ? Strip{header_.data.data() + before * vertex_.count + first_ * size, size}
                                          : Strip{rows + before, row});
      before += size;
    }
    return strips;
  }

  void read_rows(CloudBlock& block) {
    const std::vector<Strip> strips = take_strips(block.count);
    const auto load_all = [&](std::vector<double>& column, std::size_t property) {
      load_column(column, vertex_.properties[property].type, strips[property].first, strips[property].stride,
                  block.count, *header_.binary, first_, name_);
    };
    for (const auto& [column, property] : layout_.columns) load_all(block.column[column], property);
    for (std::size_t k = 0; k < fields_.size(); ++k)
      if (!is_kept_[k]) load_all(fields_[k], condition_[k]);
    for (std::size_t k = 0; k < kept_.size(); ++k)
      for (std::size_t i = 0; i < block.count; ++i) keep(k, strips[kept_[k]].first + i * strips[kept_[k]].stride);
    for (std::size_t i = 0; layout_.color && i < block.count; ++i) {
      const Strip& color = strips[*layout_.color];
      append_color(load<std::uint32_t>(color.first + i * color.stride, *header_.binary), block);
    }
    if (!looks_at_heights()) return;
    std::vector<double> heights;
    load_all(heights, *layout_.height);
    for (std::size_t i = 0; i < block.count; ++i) take_height(block, first_ + i, heights[i]);
  }

  void read_with_lists(CloudBlock& block) {
    binary_->pass(vertex_, first_, first_ + block.count, [&](std::size_t i, const std::vector<const char*>& at) {
      const auto number = [&](std::size_t property) {
        return load_exactly(vertex_.properties[property].type, at[property], *header_.binary,
                            [&] { return name_ + ": point " + std::to_string(i); });
      };
      for (const auto& [column, property] : layout_.columns) block.column[column][i - first_] = number(property);
      for (std::size_t k = 0; k < fields_.size(); ++k)
        if (!is_kept_[k]) fields_[k][i - first_] = number(condition_[k]);
      for (std::size_t k = 0; k < kept_.size(); ++k) keep(k, at[kept_[k]]);
      if (looks_at_heights()) take_height(block, i, number(*layout_.height));
    });
  }

  void read_text(CloudBlock& block) {
    std::vector<double*> target(vertex_.properties.size(), nullptr);  // column for the numbers of a property
    std::vector<double> color(layout_.color ? block.count : 0);
    for (std::size_t k = 0; k < fields_.size(); ++k) target[condition_[k]] = fields_[k].data();
    if (layout_.color) target[*layout_.color] = color.data();
    for (const auto& [column, property] : layout_.columns) target[property] = block.column[column].data();
    const bool takes_z = keeps_heights_ && layout_.height;
    if (takes_z) target[*layout_.height] = block.heights.data();
    std::vector<char> is_channel(target.size(), 0), may_be_nan(target.size(), choice_.may_leave_out() ? 1 : 0);
    for (const auto& [column, property] : layout_.columns) {
      is_channel[property] = column >= CloudBlock::color ? 1 : 0;
      if (column >= CloudBlock::normal && column < CloudBlock::color && !needs_normals_) may_be_nan[property] = 1;
    }
    std::vector<std::size_t> kept(target.size(), kept_.size());  // index in kept_ of each property, or kept_.size()
    for (std::size_t k = 0; k < kept_.size(); ++k) kept[kept_[k]] = k;
    const std::size_t size = target.size(), first = first_;
    text_->pass(vertex_, first, first + block.count, [&](std::size_t i, std::string_view& rest) {
      for (std::size_t k = 0; k < size; ++k) {
        const bool is_wanted = target[k] != nullptr;
        if (std::string_view copy = rest; kept[k] < kept_.size()) keep_word(kept[k], take_word(copy));
        if (is_wanted)
          target[k][i - first] = may_be_nan[k] != 0
                                     ? take_number(rest, text_->lines(), name_)
                                     : take_coordinate(rest, text_->lines(), name_, way_without_such_points);
        if (is_channel[k] != 0) require_channel(target[k][i - first]);
        if (k == layout_.height && !takes_z && looks_at_heights()) find_height(block, i, rest);
        if (!is_wanted || vertex_.properties[k].count > 1)
          text_->pass_words(vertex_.properties[k], rest, is_wanted ? 1 : 0);
      }
      if (layout_.color)
        append_color(color_bits(color[i - first], vertex_.properties[*layout_.color].type, here()), block);
      if (layout_.colors_behind) colors_.take(rest.substr(0, rest.find('#')), text_->lines().number(), block);
    });
    for (const double z : block.heights) facts_.file.heights.take(z);
    for (std::size_t k = 0; k < fields_.size(); ++k)  // a field may be a column of the block as well
      std::copy_n(target[condition_[k]], block.count, fields_[k].data());
  }

  std::string here() const { return at_line(name_, text_->lines().number()); }

  void require_channel(double number) const {
    if (!(number >= 0 && number <= 255 && number == std::floor(number)))
      bad_input(here(), in_quotes(text_of(number)), "a channel of a color: a whole number from 0 to 255");
  }

  /// Records the height in the next word, if the word is a number.
  void find_height(CloudBlock& block, std::size_t i, std::string_view rest) {
    const ParsedNumber z = parse_whole_number(take_word(rest));
    if (z.fault == NumberFault::none) take_height(block, i, z.value);
  }

  /// Skips the elements after the vertices once, so that a truncated file is noticed, and text after the last element.
  void pass_rest() {
    for (std::size_t i = layout_.element + 1; i < header_.elements.size() && (binary_ || text_); ++i) {
      const PlyElement& element = header_.elements[i];
      binary_ ? binary_->require_room(element) : text_->require_room(element);
      binary_ ? binary_->skip(element) : text_->skip(element);
    }
    if (text_) text_->require_end();
    binary_.reset();
    text_.reset();
  }

  Content content_;
  const std::string& name_;
  PlyHeader header_;
  PointLayout layout_;
  const PlyElement& vertex_;
  std::vector<std::size_t> condition_ = {};       // properties that the condition reads
  std::vector<std::vector<double>> fields_ = {};  // values of these properties
  std::vector<std::size_t> kept_ = {};            // properties that are kept
  std::vector<bool> is_kept_ = {};                // whether each of fields_ is kept instead of filled in
  std::size_t taken_ = 0;                         // points in earlier blocks
  bool keeps_heights_, needs_normals_;
  PointChoice choice_;
  std::optional<PlyBinary> binary_ = std::nullopt;
  std::optional<PlyText> text_ = std::nullopt;
  TextColors colors_ = TextColors();
  std::size_t first_ = 0;
};

}  // namespace

void lay_out_normal(const PlyElement& element, const std::string_view (&names)[3], PointLayout& layout) {
  const std::vector<std::size_t> places = number_places(element, names);
  layout.facts.normals = places.size() == 3;
  for (std::size_t k = 0; layout.facts.normals && k < 3; ++k)
    layout.columns.emplace_back(CloudBlock::normal + k, places[k]);
  if (places.size() == 1 || places.size() == 2)
    layout.facts.file.warnings.push_back("normals are left out, as not all of " + std::string(names[0]) + ", " +
                                         std::string(names[1]) + " and " + std::string(names[2]) + " are there");
}

std::unique_ptr<Cloud> open_elements(Content content, PlyHeader header, PointLayout layout,
                                     const CloudRequest& request) {
  return std::make_unique<ElementCloud>(std::move(content), std::move(header), std::move(layout), request);
}

}  // namespace rbpa::app
