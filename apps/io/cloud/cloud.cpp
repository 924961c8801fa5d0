#include "io/cloud/cloud.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "io/failure.h"
#include "io/number.h"
#include "io/words.h"
#include "rbpa/base/triangle.h"

namespace rbpa::app {
namespace {

/// Removes the elements with kept[i] = 0.
template <typename Value>
void keep(std::vector<Value>& values, const std::vector<std::uint8_t>& kept) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (kept[i] != 0) values[count++] = values[i];
  values.resize(count);
}

}  // namespace

const CloudFormat* cloud_format(Format format) {
  const auto found = std::find_if(std::begin(format_table), std::end(format_table), [format](const FormatRow& row) {
    return row.format == format && row.points != nullptr;
  });
  return found == std::end(format_table) ? nullptr : found->points;
}

bool has(Format format, bool CloudFormat::*property) {
  const CloudFormat* known = cloud_format(format);
  return known != nullptr && known->*property;
}

std::string readable(Use use, const std::function<bool(const CloudFormat&)>& fit, std::vector<std::string> others) {
  bool tables = false;
  for (const FormatRow& row : format_table) {
    if (!row.is_for(use) || row.points == nullptr || !fit(*row.points)) continue;
    if (is_table(row.format))
      tables = true;
    else
      others.emplace_back(row.endings);
  }
  std::sort(others.begin(), others.end());
  if (tables) others.emplace_back("text");
  return listed(others, " or ");
}

std::string with_fields(Use use) {
  std::vector<std::string> others;
  if (use == Use::points) others.emplace_back("geojson");
  return readable(
      use, [](const CloudFormat& reader) { return reader.fields != nullptr; }, std::move(others));
}

std::string streamed_formats() {
  std::map<Format, std::string> found;
  for (const FormatRow& row : format_table)
    if (row.points != nullptr && row.points->streams) {
      if (is_table(row.format))
        found[Format::text] = "tables";
      else
        found[row.format] = is_las(row.format) ? in_capitals(row.endings) : "." + std::string(row.endings);
    }
  std::vector<std::string> names;
  for (const auto& [format, name] : found) names.push_back(name);
  return listed(names, " and ");
}

Decompression decompression_of(Format format, std::string_view path, std::string way_out) {
  const CloudFormat* known = cloud_format(format);
  return {known == nullptr || known->has_signature || is_gzip_name(path), known != nullptr && known->is_text,
          std::move(way_out)};
}

std::optional<FieldNames> fields_of(Format format) {
  if (format == Format::by_content || format == Format::geojson) return names_of_columns();
  const CloudFormat* known = cloud_format(format);
  if (known == nullptr || known->fields == nullptr) return std::nullopt;
  return known->fields();
}

void refuse_integer(const std::string& where, const std::string& integer) {
  bad_input(where, integer, "an integer up to 2^53, which a double holds (store it as double, or subtract an offset)");
}

void load_column(std::vector<double>& column, Scalar type, const char* at, std::size_t stride, std::size_t count,
                 std::endian order, std::size_t first, const std::string& name) {
  column.resize(count);
  const auto load_all = [&](auto value, std::endian known) {
    for (double& number : column) {
      value = load<decltype(value)>(at, known);
      if (!is_exact_in_double(value))
        refuse_integer(name + ": point " + std::to_string(first + static_cast<std::size_t>(&number - column.data())),
                       std::to_string(value));
      number = static_cast<double>(value);
      at += stride;
    }
  };
  with_type(type, [&](auto value) {  // so that the usual byte order is a compile-time constant
    order == std::endian::native ? load_all(value, std::endian::native) : load_all(value, order);
  });
}

void clear_fields(CloudBlock& block, std::size_t columns) {
  block.fields.resize(columns);
  for (std::vector<double>& field : block.fields) field.clear();
}

void append_fields(std::span<const double> values, CloudBlock& block) {
  for (std::size_t k = 0; k < values.size(); ++k) block.fields[k].push_back(values[k]);
}

void append_fields(const CloudBlock& block, std::vector<std::vector<double>>& fields) {
  fields.resize(block.fields.size());
  for (std::size_t k = 0; k < fields.size(); ++k)
    fields[k].insert(fields[k].end(), block.fields[k].begin(), block.fields[k].end());
}

void append_index(const CloudBlock& block, std::vector<std::uint32_t>& index) {
  for (const std::uint64_t i : block.index) {
    if (i >= no_index)
      bad_input("POINTS", "a selected point that is number " + std::to_string(i) + " of the file, from 0",
                "fewer than 2^32 - 1 points before it (rbpa stream reads more)");
    index.push_back(static_cast<std::uint32_t>(i));
  }
}

std::vector<std::uint32_t> unless_identity(std::vector<std::uint32_t> index) {
  for (std::size_t i = 0; i < index.size(); ++i)
    if (index[i] != i) return index;
  return {};
}

PointChoice::PointChoice(const CloudRequest& request)
    : skips_(request.skip_invalid), checked_(request.needs_normals ? CloudBlock::color : CloudBlock::normal) {
  if (request.where) selection_.emplace(*request.where);
}

std::string PointChoice::fault_of(const CloudBlock& block, std::size_t i, std::size_t point,
                                  const std::string& name) const {
  const auto found = [&](bool is_normal, const std::string& what) {
    return name + (is_normal ? ": normal of point " : ": point ") + std::to_string(point) + ": found " + what;
  };
  for (std::size_t k = 0; k < checked_; ++k)
    if (!block.column[k].empty() && !std::isfinite(block.column[k][i]))
      return found(k >= CloudBlock::normal, in_quotes(text_of(block.column[k][i])) + ", expected a finite number");
  if (!skips_ || checked_ == CloudBlock::normal || block.column[CloudBlock::normal].empty()) return {};
  const auto is_zero = [&](std::size_t k) { return block.column[CloudBlock::normal + k][i] == 0; };
  return is_zero(0) && is_zero(1) && is_zero(2) ? found(true, "a length of 0") : std::string();
}

std::vector<std::uint8_t> PointChoice::operator()(CloudBlock& block, std::span<const std::vector<double>> fields,
                                                  std::size_t first, const std::string& name) {
  bool is_finite = true;
  for (std::size_t k = 0; k < checked_; ++k)
    for (const double value : block.column[k]) is_finite &= value - value == 0;
  if (is_finite && !may_leave_out()) return {};
  std::vector<std::uint8_t> kept(may_leave_out() ? block.count : 0, 1);
  if (selection_) clear_fields(block, selection_->column_values().size());
  block.index.clear();
  for (std::size_t i = 0; i < block.count; ++i) {
    if (selection_) {
      for (std::size_t k = 0; k < fields.size(); ++k) selection_->values()[k] = fields[k][i];
      if (!selection_->holds()) {
        kept[i] = 0;
        continue;
      }
    }
    const std::string fault = fault_of(block, i, first + i, name);
    if (!fault.empty() && !skips_) throw BadInput(fault + std::string(way_without_such_points));
    if (!fault.empty()) {
      kept[i] = 0;
      if (skipped_++ == 0) first_skipped_ = fault;
    } else if (may_leave_out()) {
      if (selection_) append_fields(selection_->column_values(), block);
      block.index.push_back(first + i);
    }
  }
  if (may_leave_out()) keep_points(block, kept);
  chosen_ += block.count;
  return kept;
}

void PointChoice::add_warnings(const std::string& name, std::vector<std::string>& warnings) const {
  if (selection_) selection_->warning("point", warnings);
  if (skipped_ == 0) return;
  if (chosen_ == 0)
    bad_input(name, counted(skipped_, "point") + " and none that is valid", "one (" + first_skipped_ + ")");
  warnings.push_back(counted(skipped_, "point") + (skipped_ == 1 ? " is" : " are") +
                     " left out: " + (skipped_ == 1 ? "" : "the first is ") + first_skipped_);
}

void keep_points(CloudBlock& block, const std::vector<std::uint8_t>& kept) {
  for (std::vector<double>& column : block.column) keep(column, kept);
  keep(block.heights, kept);
  block.count = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), std::uint8_t{1}));
}

void refuse_flat_points(const std::string& name) {
  bad_input(name, "points without z", "points with z, as --bounds of six numbers requires (four bound x and y)");
}

std::string warning_on_window(const PointWindow& window, std::size_t selected, std::size_t all) {
  const std::string options = !window.resolution ? "--bounds"
                              : window.bounds    ? "--bounds and --resolution"
                                                 : "--resolution";
  return options + (window.bounds && window.resolution ? " select " : " selects ") + std::to_string(selected) + " of " +
         counted(all, "point");
}

namespace {

/// Leaves out points of another reader that are not in a window.
class WindowCloud final : public Cloud {
 public:
  WindowCloud(std::unique_ptr<Cloud> cloud, std::string name, const CloudRequest& request)
      : cloud_(std::move(cloud)),
        name_(std::move(name)),
        window_(request.window),
        z_(request.in_space ? &block_.column[CloudBlock::z] : &block_.heights),
        filter_(request.window, request.in_space, true) {
    cloud_->facts().expected = 0;
  }

  bool next(CloudBlock& block) override {
    block.count = 0;
    while (block.count == 0) {
      if (!cloud_->next(block_)) break;
      const std::size_t before = selected_;
      select();
      keep_values(facts().file.kept, before, kept_);
      std::swap(block, block_);
    }
    return block.count > 0;
  }

  void finish() override {
    cloud_->finish();
    PointFile& file = facts().file;
    file.all_points = std::max(file.all_points, read_);
    file.warnings.push_back(warning_on_window(window_, selected_, file.all_points));
  }
  CloudFacts& facts() override { return cloud_->facts(); }
  std::uint64_t bytes_read() const override { return cloud_->bytes_read(); }

 private:
  void select() {
    const bool has_z = !z_->empty();
    if (!has_z && window_.bounds && window_.bounds->has_heights()) refuse_flat_points(name_);
    if (block_.index.empty())
      for (std::size_t i = 0; i < block_.count; ++i) block_.index.push_back(read_ + i);
    read_ += block_.count;
    kept_.assign(block_.count, 0);
    for (std::size_t i = 0; i < block_.count; ++i)
      kept_[i] =
          filter_.keeps({block_.column[CloudBlock::x][i], block_.column[CloudBlock::y][i], has_z ? (*z_)[i] : 0});
    for (std::vector<double>& field : block_.fields) keep(field, kept_);
    keep(block_.index, kept_);
    keep_points(block_, kept_);
    selected_ += block_.count;
  }

  std::unique_ptr<Cloud> cloud_;
  std::string name_;
  PointWindow window_;
  CloudBlock block_ = {};
  const std::vector<double>* z_;  // heights of block_
  WindowFilter filter_;
  std::vector<std::uint8_t> kept_ = {};
  std::size_t read_ = 0, selected_ = 0;
};

}  // namespace

std::unique_ptr<Cloud> open_cloud(const CloudFormat& format, Content content, const CloudRequest& request) {
  const std::string name = content.name();
  CloudRequest with_heights = request;
  if (request.window.bounds && request.window.bounds->has_heights()) with_heights.heights = true;
  std::unique_ptr<Cloud> cloud = format.open(std::move(content), with_heights);
  if (!request.window.selects() || cloud->facts().is_in_window) return cloud;
  return std::make_unique<WindowCloud>(std::move(cloud), name, request);
}

FieldNames names_of_properties() {
  FieldNames names = names_of_columns();
  return {names.are, "the name of a field (in double quotes unless it is a word)", false};
}

}  // namespace rbpa::app
