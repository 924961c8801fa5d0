#include <algorithm>
#include <utility>

#include "io/bytes/npy.h"
#include "io/cloud/cloud.h"
#include "io/failure.h"
#include "io/interrupt.h"

namespace rbpa::app {
namespace {

/// Reads points from the numbers of an array, stored by rows or by columns: a .npy file, or raw pairs of float64.
class ArrayCloud final : public Cloud {
 public:
  /// Requires: `content` is at the first number of `array`. `is_whole` tells whether the number of rows in `array` is
  /// known.
  ArrayCloud(Content content, const NpyLayout& array, const CloudRequest& request, bool is_whole)
      : array_(array),
        is_whole_(is_whole),
        keeps_heights_(request.heights),
        looks_at_heights_(!request.in_space && array.columns == 3),
        choice_(request) {
    const bool in_space = request.in_space;
    facts_.normals = in_space && array.columns == 6;
    facts_.expected = is_whole ? array.rows : 0;
    const std::size_t wanted = in_space ? array.columns : 2;
    for (std::size_t k = 0; k < wanted + (looks_at_heights_ ? 1 : 0); ++k) columns_.push_back(k);
    if (array.columns_first) {
      for (const std::size_t k : columns_) {
        Content& column = sources_.emplace_back(content.again());
        column.skip(array.data + std::uint64_t{array.rows} * array.item() * k);
      }
    } else {
      sources_.push_back(std::move(content));
    }
  }

  bool next(CloudBlock& block) override {
    while (read(block))
      if (block.count > 0) return true;
    return false;
  }

  void finish() override {
    facts_.file.all_points = first_;
    choice_.add_warnings(sources_.front().name(), facts_.file.warnings);
  }

  std::uint64_t bytes_read() const override {
    std::uint64_t sum = 0;
    for (const Content& source : sources_) sum += source.bytes_read();
    return sum / sources_.size();
  }

 private:
  /// Reads the next rows. Returns whether there are any; all points may be left out.
  bool read(CloudBlock& block) {
    stop_if_interrupted();
    if (looks_at_heights_ && !keeps_heights_ && facts_.file.heights.differ()) leave_out_heights();
    const std::size_t step = array_.columns_first ? array_.item() : array_.row();
    std::size_t count = std::min(points_at_once, array_.rows - first_);
    block.column[CloudBlock::z].clear();
    for (const std::size_t k : columns_) {
      Content& source = array_.columns_first ? sources_[k] : sources_.front();
      const std::string_view bytes = source.ahead(count * step);
      if (bytes.size() < count * step) count = end_early(bytes.size(), step);
      const std::size_t offset = array_.columns_first ? 0 : k * array_.item();
      load_column(block.column[k], array_.type, bytes.data() + offset, step, count, array_.order, first_,
                  source.name());
    }
    for (std::size_t k = 0; k < sources_.size(); ++k) sources_[k].skip(count * step);
    block.count = count;
    if (looks_at_heights_) {
      for (const double z : block.column[CloudBlock::z]) facts_.file.heights.take(z);
      if (keeps_heights_) block.heights.swap(block.column[CloudBlock::z]);
      block.column[CloudBlock::z].clear();
    }
    choice_(block, {}, first_, sources_.front().name());
    first_ += count;
    return count > 0;
  }
  void leave_out_heights() {
    looks_at_heights_ = false;
    columns_.pop_back();
    if (array_.columns_first) sources_.pop_back();
  }

  /// Returns the number of rows of `step` bytes in the last `size` bytes of a file. Throws BadInput if the header has
  /// announced more rows, or a row is incomplete.
  std::size_t end_early(std::size_t size, std::size_t step) {
    const std::string& name = sources_.front().name();
    if (is_whole_)
      bad_input(name, counted(first_ + size / step, "row"), std::to_string(array_.rows) + " as the header says");
    if (size % step != 0) bad_input(name, counted(first_ * step + size, "byte"), "a multiple of 16 (pairs of float64)");
    array_.rows = first_ + size / step;
    return size / step;
  }

  NpyLayout array_;
  bool is_whole_;  // the number of rows is known
  bool keeps_heights_, looks_at_heights_;
  PointChoice choice_;
  std::vector<std::size_t> columns_ = {};
  std::vector<Content> sources_ = {};  // one reader, or one for each column if the array is stored by columns
  std::size_t first_ = 0;
};

std::unique_ptr<Cloud> open_raw(Content content, const CloudRequest& request) {
  constexpr std::size_t row = 16;
  const std::size_t size = content.size();
  if (!content.is_compressed() && size % row != 0)
    bad_input(content.name(), counted(size, "byte"), "a multiple of 16 (pairs of float64)");
  const bool is_whole = !content.is_compressed();
  const NpyLayout pairs{size / row, 2, Scalar::float64, std::endian::little, false, 0};
  return std::make_unique<ArrayCloud>(std::move(content), pairs, request, is_whole);
}

std::unique_ptr<Cloud> open_npy(Content content, const CloudRequest& request) {
  constexpr std::size_t most_header = std::size_t{1} << 20U;
  const std::size_t fits[] = {request.in_space ? 3U : 2U, request.in_space ? 6U : 3U};
  const NpyLayout array = read_npy_layout(content.ahead(most_header), content.size(), content.name(), fits);
  content.skip(array.data);
  return std::make_unique<ArrayCloud>(std::move(content), array, request, true);
}

}  // namespace

/// Reads raw numbers: pairs x, y of little-endian float64 and nothing else.
const CloudFormat raw_reader = {.open = open_raw, .streams = true, .skips_invalid = true, .has_signature = false};

/// Reads an array of NumPy: of shape (n, 2) or (n, 3); in space of shape (n, 3) or (n, 6), whose last three columns are
/// normals. Ignores bytes after the array, as NumPy does.
const CloudFormat npy_reader = {.open = open_npy, .streams = true, .skips_invalid = true};

}  // namespace rbpa::app
