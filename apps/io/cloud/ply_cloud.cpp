#include <algorithm>
#include <cmath>
#include <utility>

#include "io/bytes/number.h"
#include "io/cloud/ply.h"
#include "io/cloud/readers.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/text/vertex_lines.h"

namespace rbpa::app {
namespace {

class PlyCloud final : public Cloud {
 public:
  PlyCloud(Content content, const CloudRequest& request)
      : content_(std::move(content)),
        header_(read_ply_header(content_.ahead(), content_.name())),
        vertex_(vertices_of(header_, content_.name())),
        in_space_(request.in_space) {
    lay_out();
    if (request.where) lay_out_condition(*request.where);
    if (header_.binary) {
      binary_.emplace(header_, content_.name());
    } else {
      text_.emplace(header_, content_.name());
    }
    for (const PlyElement& element : header_.elements) {
      if (&element == &vertex_) break;
      if (binary_) binary_->require_room(element);
      binary_ ? binary_->skip(element) : text_->skip(element);
    }
    binary_ ? binary_->require_room(vertex_) : text_->require_room(vertex_);
    facts_.expected = vertex_.count;
  }

  bool next(CloudBlock& block) override {
    block.count = 0;
    while (block.count == 0 && first_ < vertex_.count) {
      stop_if_interrupted();
      block.count = std::min(points_at_once, vertex_.count - first_);
      for (const auto& [column, property] : columns_) block.column[column].resize(block.count);
      for (std::vector<double>& field : fields_) field.resize(block.count);
      if (text_)
        read_text(block);
      else if (vertex_.has_lists())
        read_with_lists(block);
      else
        read_rows(block);
      if (selection_)
        selection_->select(block, fields_, std::exchange(first_, first_ + block.count), content_.name());
      else
        require_finite(block, std::exchange(first_, first_ + block.count), content_.name());
    }
    if (block.count == 0 && binary_) pass_rest();
    return block.count > 0;
  }

  void finish() override {
    if (selection_) selection_->remark(facts_.file.remarks);
  }

 private:
  void add(std::size_t column, std::size_t property) { columns_.emplace_back(column, property); }

  /// Where columns are among the properties of a vertex.
  void lay_out() {
    const std::string wanted = in_space_ ? "x, y and z" : "x and y";
    add(CloudBlock::x, find_number(vertex_, "x", wanted, content_.name()));
    add(CloudBlock::y, find_number(vertex_, "y", wanted, content_.name()));
    if (!in_space_) {
      height_ = number_place(vertex_, "z");
      return;
    }
    add(CloudBlock::z, find_number(vertex_, "z", wanted, content_.name()));
    const std::vector<std::size_t> normal = places_of({"nx", "ny", "nz"}), color = places_of({"red", "green", "blue"});
    facts_.normals = normal.size() == 3;
    for (std::size_t k = 0; facts_.normals && k < 3; ++k) add(CloudBlock::normal + k, normal[k]);
    if (normal.size() == 1 || normal.size() == 2)
      facts_.file.remarks.emplace_back("normals are left out, as not all of nx, ny and nz are there");
    const bool bytes = std::all_of(color.begin(), color.end(),
                                   [&](std::size_t place) { return vertex_.properties[place].type == Scalar::uint8; });
    if (color.size() == 3 && bytes) {
      facts_.colors = Channels::bytes;
      for (std::size_t k = 0; k < 3; ++k) add(CloudBlock::color + k, color[k]);
    } else if (!color.empty()) {
      facts_.file.remarks.emplace_back("colours are left out, as red, green and blue are not three of type uchar");
    }
  }

  std::vector<std::size_t> places_of(std::initializer_list<std::string_view> names) const {
    std::vector<std::size_t> places;
    for (const std::string_view name : names)
      if (const std::optional<std::size_t> place = number_place(vertex_, name)) places.push_back(*place);
    return places;
  }

  void lay_out_condition(const Condition& where) {
    for (const std::string& field : where.fields()) {
      const std::optional<std::size_t> place = number_place(vertex_, field);
      if (!place)
        bad_input(at_line(content_.name(), vertex_.line), "vertices without " + in_quotes(field),
                  "a number property of that name, as --where asks");
      asked_.push_back(*place);
    }
    fields_.resize(asked_.size());
    selection_.emplace(where);
  }

  bool looks_at_heights() const { return height_ && !facts_.file.heights.differ(); }

  void read_rows(CloudBlock& block) {
    std::vector<std::size_t> offsets;
    std::size_t size = 0;
    for (const PlyProperty& property : vertex_.properties) {
      offsets.push_back(size);
      size += size_of(property.type);
    }
    const char* const rows = binary_->take_rows(vertex_, block.count);
    const auto load = [&](std::vector<double>& column, std::size_t property) {
      load_column(column, vertex_.properties[property].type, rows + offsets[property], size, block.count,
                  *header_.binary);
    };
    for (const auto& [column, property] : columns_) load(block.column[column], property);
    for (std::size_t k = 0; k < asked_.size(); ++k) load(fields_[k], asked_[k]);
    if (!looks_at_heights()) return;
    std::vector<double> heights;
    load(heights, *height_);
    for (const double z : heights) facts_.file.heights.take(z);
  }

  void read_with_lists(CloudBlock& block) {
    binary_->pass(vertex_, first_, first_ + block.count, [&](std::size_t i, const std::vector<const char*>& at) {
      const auto number = [&](std::size_t property) {
        return load_number(vertex_.properties[property].type, at[property], *header_.binary);
      };
      for (const auto& [column, property] : columns_) block.column[column][i - first_] = number(property);
      for (std::size_t k = 0; k < asked_.size(); ++k) fields_[k][i - first_] = number(asked_[k]);
      if (looks_at_heights()) facts_.file.heights.take(number(*height_));
    });
  }

  /// What is behind the last property that counts is not looked at.
  void read_text(CloudBlock& block) {
    std::vector<double*> target(vertex_.properties.size(), nullptr);  // where the numbers of a property go
    for (std::size_t k = 0; k < asked_.size(); ++k) target[asked_[k]] = fields_[k].data();
    for (const auto& [column, property] : columns_) target[property] = block.column[column].data();
    std::vector<char> is_channel(target.size(), 0);
    for (const auto& [column, property] : columns_) is_channel[property] = column >= CloudBlock::color ? 1 : 0;
    while (target.back() == nullptr) target.pop_back();
    const std::size_t size = target.size(), first = first_;
    const std::string& name = content_.name();
    text_->pass(vertex_, first, first + block.count, [&](std::size_t i, std::string_view& rest) {
      for (std::size_t k = 0; k < size; ++k) {
        if (target[k] == nullptr) {
          text_->pass_words(vertex_.properties[k], rest);
          continue;
        }
        target[k][i - first] = take_coordinate(rest, text_->lines(), name);
        if (is_channel[k] != 0) require_channel(target[k][i - first]);
      }
      if (looks_at_heights()) take_height();
    });
    for (std::size_t k = 0; k < asked_.size(); ++k)  // which may be a column as well
      std::copy_n(target[asked_[k]], block.count, fields_[k].data());
  }

  void require_channel(double number) const {
    if (!(number >= 0 && number <= 255 && number == std::floor(number)))
      bad_input(at_line(content_.name(), text_->lines().number()), in_quotes(ShortestText(number)),
                "a channel of a colour, from 0 to 255");
  }

  /// Lists before it are none of a file with heights that we would know.
  void take_height() {
    if (vertex_.has_lists()) return height_.reset();
    std::string_view line = text_->lines().line();
    for (std::size_t k = 0; k < *height_; ++k) take_word(line);
    const ParsedNumber z = parse_whole_number(take_word(line));
    if (z.fault == NumberFault::none) facts_.file.heights.take(z.value);
  }

  /// The elements behind the vertices of a binary file.
  void pass_rest() {
    for (const PlyElement* element = &vertex_ + 1; element != header_.elements.data() + header_.elements.size();
         ++element) {
      binary_->require_room(*element);
      binary_->skip(*element);
    }
    binary_.reset();
  }

  Content content_;
  PlyHeader header_;
  const PlyElement& vertex_;
  bool in_space_;
  std::vector<std::pair<std::size_t, std::size_t>> columns_ = {};  // of a block, each with its property
  std::optional<std::size_t> height_ = std::nullopt;               // the property z where it is no column
  std::optional<PointSelection> selection_ = std::nullopt;
  std::vector<std::size_t> asked_ = {};           // properties that the condition asks for
  std::vector<std::vector<double>> fields_ = {};  // their columns
  std::optional<PlyBinary> binary_ = std::nullopt;
  std::optional<PlyText> text_ = std::nullopt;
  std::size_t first_ = 0;
};

}  // namespace

std::unique_ptr<Cloud> open_ply(Content content, const CloudRequest& request) {
  return std::make_unique<PlyCloud>(std::move(content), request);
}

}  // namespace rbpa::app
