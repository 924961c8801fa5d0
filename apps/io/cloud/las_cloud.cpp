#include <algorithm>
#include <cmath>
#include <utility>

#include "io/cloud/cloud.h"
#include "io/cloud/copc.h"
#include "io/cloud/las_fields.h"
#include "io/cloud/las_header.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/laz/laz_records.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

/// Throws BadInput if the largest integers give coordinates beyond the range of a double; if it does not throw, all
/// points are finite.
void require_range(const LasHeader& header, std::size_t axis, const std::string& name) {
  constexpr double largest = 0x1p31;
  if (!std::isfinite(largest * std::abs(header.scale[axis]) + std::abs(header.offset[axis])))
    bad_input(name,
              "a scale of " + in_quotes(text_of(header.scale[axis])) + " and an offset of " +
                  in_quotes(text_of(header.offset[axis])) + " for " + "xyz"[axis],
              "coordinates within the range of a double");
}

/// Returns whether the field is a channel of the colors, which CloudBlock already has for points in space.
bool is_color(std::string_view name) { return name == "red" || name == "green" || name == "blue"; }

class LasCloud final : public Cloud {
 public:
  LasCloud(Content content, const CloudRequest& request)
      : content_(std::move(content)),
        in_space_(request.in_space),
        has_z_(request.in_space || request.heights),
        skip_invalid_(request.skip_invalid) {
    constexpr std::size_t most_header = 65536, signature = 2;
    const std::string& name = content_.name();
    header_ = read_las_header(content_.ahead(most_header), content_.size(), name);
    const std::string_view first = content_.ahead(header_.begin + signature);
    header_ = read_las_header(first, content_.size(), name);
    for (const std::size_t axis : {0U, 1U, 2U}) axes_.emplace_back(header_.scale[axis], header_.offset[axis]);
    std::optional<LazFormat> laz;
    withheld_ = find_las_field("withheld", header_.format, header_.minor);
    for (const std::size_t axis : {0U, 1U}) require_range(header_, axis, name);
    const std::vector<NamedLasField> fields =
        all_las_fields(header_.format, header_.minor, header_.length, las_record(first, header_, "LASF_Spec", 4));
    if (request.where) {
      selection_.emplace(*request.where);
      places_ = find_las_places(*request.where, header_.format, header_.minor, fields, name);
      for (std::size_t i = 0; request.keeps && i < request.where->columns(); ++i)
        places_[i].is_kept = !places_[i].axis && request.where->column(i).kind == WantedColumn::Kind::by_value;
    }
    if (has_z_) {
      require_las_axis(header_, 2, name);
      require_range(header_, 2, name);
    }
    if (request.scan_counts) {
      class_ = find_las_field("classification", header_.format, header_.minor);
      return_ = find_las_field("return_number", header_.format, header_.minor);
    }
    if (in_space_) {
      red_ = find_las_field("red", header_.format, header_.minor);
      if (red_) facts_.colors = Channels::bytes;
    }
    if (header_.is_compressed) laz = read_laz_format(laszip_record(first, header_), header_.length, name);
    if (request.keeps)
      for (const NamedLasField& field : fields)
        if (request.keeps->has(field.name) && !(red_ && !request.keeps->names && is_color(field.name))) {
          facts_.file.kept.push_back({.name = field.name, .type = field.field.kept_type()});
          kept_.push_back(field.field);
        }
    const std::string_view copc = laz ? las_record(first, header_, "copc", 1) : std::string_view();
    facts_.file.scan = ScanFacts{.minor = header_.minor,
                                 .format = header_.format,
                                 .compressor = laz ? laz->compressor : 0,
                                 .is_copc = !copc.empty(),
                                 .scale = header_.scale,
                                 .offset = header_.offset};
    std::optional<std::vector<LazNode>> nodes;
    if (request.window.selects()) {
      window_ = request.window;
      facts_.is_in_window = true;
      if (!copc.empty() && !content_.is_compressed()) nodes = find_copc_nodes(content_, copc, header_.scale, window_);
      filter_.emplace(window_, in_space_, !nodes);  // levels of COPC thin the points already
    }
    const LasCrs system = find_system(first);
    facts_.file.crs = system.crs;
    if (content_.is_compressed() && !header_.is_compressed) {
      count_ = header_.count.sought(skip_invalid_);
    } else {
      settle(header_.count);
    }
    if (laz)
      laz_.emplace(content_, header_.begin, *laz, count_,
                   LazChoice{read_bytes(), skip_invalid_, request.threads, std::move(nodes)});
    if (!system.warning.empty() && !in_space_) facts_.file.warnings.push_back(system.warning);
    if (in_space_ && system.crs) facts_.file.degrees = system.crs->degrees;
    // Expect a point for each record unless points are selected; but LAZ may promise many more points than bytes.
    if (!selection_ && !request.window.selects() && is_settled_ && !content_.is_compressed() &&
        count_ <= content_.size())
      facts_.expected = count_;
    content_.skip(header_.begin);
  }

  bool next(CloudBlock& block) override {
    block.count = 0;
    while (block.count == 0 && first_ < count_) {
      stop_if_interrupted();
      const std::size_t count = std::min(points_at_once, count_ - first_);
      const std::string_view bytes = laz_ ? laz_->ahead() : content_.ahead(count * header_.length);
      const std::size_t whole = std::min(count, bytes.size() / header_.length);
      if (laz_ && whole > 0) first_ = laz_->first();
      read(bytes.data(), whole, block);
      laz_ ? laz_->skip(whole * header_.length) : content_.skip(whole * header_.length);
      first_ += whole;
      if (laz_ && whole == 0)
        laz_->fault().empty() ? static_cast<void>(first_ = count_)
                              : leave_out_rest();  // after the last node, or a fault
      else if (!laz_ && whole < count)
        settle(header_.count.with_room(first_));
    }
    if (block.count == 0 && !ended_) end();
    return block.count > 0;
  }

  void finish() override {
    std::vector<std::string>& warnings = facts_.file.warnings;
    facts_.file.all_points = count_;
    if (selection_) selection_->warning("point", warnings);
    if (filter_) warnings.push_back(warning_on_window(window_, taken_, count_));
    if (withheld_points_ > 0)
      warnings.push_back(counted(withheld_points_, "point") + (withheld_points_ == 1 ? " is" : " are") +
                         " marked as withheld (--where \"not withheld\" leaves them out)");
  }

  std::uint64_t bytes_read() const override { return laz_ ? laz_->bytes_read() : content_.bytes_read(); }

 private:
  /// Returns the coordinate system of the file; also reads the records after the points.
  LasCrs find_system(std::string_view before) const {
    // A COPC file has the name of its system before the points, and the whole hierarchy behind the points.
    const bool has_more = !facts_.file.scan->is_copc && !content_.is_compressed() && header_.extended_records > 0 &&
                          header_.extended_begin > header_.begin && header_.extended_begin < content_.size();
    if (!has_more) return las_crs(before, {}, header_);
    constexpr std::size_t most = std::size_t{16} << 20U;
    Content more = content_.again();
    more.skip(header_.extended_begin);
    return las_crs(before, more.ahead(most), header_);
  }

  /// Returns for each byte of a record whether it is read.
  std::vector<bool> read_bytes() const {
    std::vector<bool> wanted(header_.length);
    const auto want = [&](std::size_t offset, std::size_t size) {
      std::fill_n(wanted.begin() + static_cast<std::ptrdiff_t>(offset), size, true);
    };
    want(0, has_z_ ? 12 : 8);
    for (const LasPlace& place : places_) want(place.field.offset, size_of(place.field.type));
    if (withheld_) want(withheld_->offset, 1);
    if (red_) want(red_->offset, 6);
    for (const LasField& field : kept_) want(field.offset, size_of(field.type));
    for (const std::optional<LasField>& field : {class_, return_})
      if (field) want(field->offset, 1);
    return wanted;
  }

  /// Ends the points before those that cannot be decoded from LAZ; --skip-invalid leaves the latter out.
  void leave_out_rest() {
    facts_.file.warnings.push_back(std::to_string(count_ - first_) + " of the " + counted(count_, "point") +
                                   " in the header are left out: " + laz_->fault());
    count_ = first_;
  }

  bool is_selected(const char* record, std::size_t point) {
    const auto number = [&](std::size_t i) {
      const LasPlace& place = places_[i];
      if (const Scalar type = place.field.kept_type(); !place.axis && is_integer(type) && size_of(type) == 8)
        load_exactly(type, record + place.field.offset, std::endian::little,
                     [&] { return content_.name() + ": point " + std::to_string(point); });  // refuses to round
      return place.value(record, axes_);
    };
    if (!selection_->holds(number, [](std::size_t) { return false; })) return false;
    for (std::size_t i = 0; i < selection_->column_values().size(); ++i)
      if (!places_[i].is_kept) selection_->values()[i] = number(i);
    return true;
  }

  std::array<double, 3> position(const char* record) const {
    std::array<double, 3> position{};
    for (std::size_t axis = 0; axis < (has_z_ ? 3 : 2); ++axis)
      position[axis] = axes_[axis](load_little<std::int32_t>(record + 4 * axis));
    return position;
  }

  void read(const char* records, std::size_t count, CloudBlock& block) {
    const std::size_t length = header_.length, dimension = in_space_ ? 3 : 2;
    for (std::size_t axis = 0; axis < dimension; ++axis) block.column[axis].resize(count);
    double* const x = block.column[CloudBlock::x].data();
    double* const y = block.column[CloudBlock::y].data();
    std::vector<double>& heights = in_space_ ? block.column[CloudBlock::z] : block.heights;
    if (has_z_) heights.resize(count);
    double* const z = has_z_ ? heights.data() : nullptr;
    for (std::size_t k = 0; red_ && k < 3; ++k) block.column[CloudBlock::color + k].resize(count);
    if (selection_) clear_fields(block, selection_->column_values().size());
    block.index.clear();
    std::size_t taken = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const char* const record = records + i * length;
      if (selection_ && !is_selected(record, first_ + i)) continue;
      if (filter_ && !filter_->keeps(position(record))) continue;
      if (selection_) append_fields(selection_->column_values(), block);
      if (selection_ || filter_) block.index.push_back(first_ + i);
      x[taken] = axes_[0](load_little<std::int32_t>(record));
      y[taken] = axes_[1](load_little<std::int32_t>(record + 4));
      if (z != nullptr) z[taken] = axes_[2](load_little<std::int32_t>(record + 8));
      for (std::size_t k = 0; red_ && k < 3; ++k) {
        const auto channel = load_little<std::uint16_t>(record + red_->offset + 2 * k);
        greatest_channel_ = std::max(greatest_channel_, channel);
        block.column[CloudBlock::color + k][taken] = channel;
      }
      if (withheld_ && withheld_->value(record) != 0) ++withheld_points_;
      for (std::size_t k = 0; k < kept_.size(); ++k) kept_[k].append_to(facts_.file.kept[k], record);
      if (class_) ++facts_.file.scan->classes[static_cast<std::size_t>(class_->value(record))];
      if (return_) ++facts_.file.scan->returns[static_cast<std::size_t>(return_->value(record))];
      ++taken;
    }
    if (taken < count)
      for (std::vector<double>& column : block.column) column.resize(std::min(column.size(), taken));
    block.heights.resize(std::min(block.heights.size(), taken));
    block.count = taken;
    taken_ += taken;
  }

  void settle(const LasCount& count) {
    count_ = count.settle(skip_invalid_, content_.name(), facts_.file.warnings);
    is_settled_ = true;
  }

  void end() {
    ended_ = true;
    if (!is_settled_) {
      // Count until the end: a decompressed file does not show the number of records before.
      std::size_t found = first_;
      for (; found < header_.count.room() && content_.ahead(header_.length).size() >= header_.length; ++found)
        content_.skip(header_.length);
      settle(header_.count.with_room(found));
    }
    // Drop black: programs without colors write it. Channels have 16 bits, but many programs write 8.
    if (red_ && greatest_channel_ == 0) facts_.colors.reset();
    if (red_ && greatest_channel_ > 255) facts_.colors = Channels::wide;
  }

  Content content_;
  bool in_space_, has_z_, skip_invalid_;
  LasHeader header_ = {};
  std::vector<ScaledInteger> axes_ = {};
  std::optional<LazRecords> laz_ = std::nullopt;  // the records, if they are compressed
  std::optional<Selection> selection_ = std::nullopt;
  std::vector<LasPlace> places_ = {};
  std::vector<LasField> kept_ = {};
  std::optional<LasField> withheld_ = std::nullopt, red_ = std::nullopt;  // green and blue follow red
  std::optional<LasField> class_ = std::nullopt, return_ = std::nullopt;  // present if points are counted by them
  PointWindow window_ = {};
  std::optional<WindowFilter> filter_ = std::nullopt;  // for the window, if it selects
  std::size_t first_ = 0, count_ = 0, taken_ = 0, withheld_points_ = 0;
  std::uint16_t greatest_channel_ = 0;
  bool is_settled_ = false, ended_ = false;
};

}  // namespace

/// Reads LAS and LAZ 1.0 to 1.4, point formats 0 to 10, with red, green and blue unless all points are black.
const CloudFormat las_reader = {
    .open = open_as<LasCloud>, .fields = names_of_las_fields, .streams = true, .skips_invalid = true};

}  // namespace rbpa::app
