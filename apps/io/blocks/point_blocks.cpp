#include "io/blocks/point_blocks.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "io/available_memory.h"
#include "io/blocks/array_blocks.h"
#include "io/blocks/byte_blocks.h"
#include "io/failure.h"
#include "io/lines.h"
#include "io/points/longitude.h"
#include "io/table/text_points.h"

namespace rbpa::app {
namespace {

/// Text by some megabytes, cut where lines end.
class TextBlocks final : public PointBlocks {
 public:
  explicit TextBlocks(const PointSource& source)
      : bytes_(source.path, true),
        table_(source.path, {.columns = source.columns,
                             .skip_invalid = source.skip_invalid,
                             .vertices = source.vertices,
                             .where = source.where}) {
    if (bytes_.file_size() == 0) bad_input(bytes_.name(), "an empty file", "points");
  }

  bool next(std::vector<Point>& block) override {
    block.clear();
    while (block.empty() && !ended_) read_text(block);
    if (block.empty()) tell();
    return !block.empty();
  }
  std::uint64_t bytes_read() const override { return bytes_.bytes_read(); }

 private:
  static constexpr std::size_t at_once = std::size_t{1} << 20U;

  void read_text(std::vector<Point>& block) {
    const std::size_t before = text_.size();
    text_.resize(before + at_once);
    const std::size_t count = bytes_.read(text_.data() + before, at_once);
    text_.resize(before + count);
    ended_ = count < at_once;
    const std::size_t last = std::string_view(text_).substr(before).rfind('\n');  // before it none ends
    if (last == std::string_view::npos && !ended_) return require_memory();
    const std::size_t end = ended_ ? text_.size() : before + last + 1;
    table_.read(std::string_view(text_).substr(0, end));
    text_.erase(0, end);
    block = table_.file().points;
  }

  /// For a line that has not ended so far.
  void require_memory() const {
    constexpr double bytes_for_each = 5;  // the string, a larger one when it grows, and the point or its vertices
    const std::optional<double> there = available_memory();
    const auto size = static_cast<double>(text_.size());
    if (there && bytes_for_each * size > *there)
      bad_input(bytes_.name(), "a line of more than " + bytes_text(size), "lines for which memory suffices");
  }

  void tell() {
    if (told_) return;
    told_ = true;
    table_.finish();
    about_.crs = table_.file().crs;
    about_.degrees = table_.file().degrees;
    about_.remarks = std::move(table_.file().remarks);
  }

  ByteBlocks bytes_;
  TextTable table_;
  std::string text_ = {};
  bool ended_ = false, told_ = false;
};

/// A file that has to be in memory as a whole.
class WholeFile final : public PointBlocks {
 public:
  explicit WholeFile(const PointSource& source) {
    if (source.format != PointFormat::ogr) size_ = ByteBlocks(source.path, false).file_size();
    about_ = read_points(source);
    points_ = std::move(about_.points);
    about_.points = {};
  }

  bool next(std::vector<Point>& block) override {
    const std::size_t count = std::min(points_in_block, points_.size() - first_);
    const auto begin = points_.begin() + static_cast<std::ptrdiff_t>(first_);
    block.assign(begin, begin + static_cast<std::ptrdiff_t>(count));
    first_ += count;
    if (count == 0) points_ = {};
    return count > 0;
  }
  std::uint64_t bytes_read() const override { return size_; }

 private:
  std::vector<Point> points_;
  std::size_t first_ = 0;
  std::uint64_t size_ = 0;
};

/// What the command line says of the points, as read_points() obeys it.
class Settled final : public PointBlocks {
 public:
  Settled(std::unique_ptr<PointBlocks> blocks, const PointSource& source)
      : blocks_(std::move(blocks)), source_(source) {}

  bool next(std::vector<Point>& block) override {
    if (blocks_->next(block)) {
      if (source_.shift_longitude) {
        PointFile file{.points = std::move(block)};
        shift_longitude(file, source_.path);
        block = std::move(file.points);
      }
      return true;
    }
    about_ = blocks_->about();
    settle_crs(about_, source_.crs);
    if (source_.shift_longitude) about_.degrees = true;
    return false;
  }
  std::uint64_t bytes_read() const override { return blocks_->bytes_read(); }

 private:
  std::unique_ptr<PointBlocks> blocks_;
  PointSource source_;
};

}  // namespace

std::unique_ptr<PointBlocks> open_point_blocks(const PointSource& source) {
  const auto settled = [&](std::unique_ptr<PointBlocks> blocks) {
    return std::make_unique<Settled>(std::move(blocks), source);
  };
  switch (source.format) {
    case PointFormat::raw:
      return settled(open_raw_blocks(source));
    case PointFormat::npy:
      return settled(open_npy_blocks(source));
    case PointFormat::las:
      return settled(open_las_blocks(source));
    case PointFormat::text:
      return settled(std::make_unique<TextBlocks>(source));
    default:
      return std::make_unique<WholeFile>(source);
  }
}

}  // namespace rbpa::app
