#include "io/cloud/point_blocks.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "io/box.h"
#include "io/bytes/content.h"
#include "io/cloud/cloud.h"
#include "io/cloud/read_points.h"
#include "io/cloud/units.h"
#include "io/formats.h"

namespace rbpa::app {
namespace {

/// A file that is read piece by piece.
class CloudBlocks final : public PointBlocks {
 public:
  explicit CloudBlocks(const PointSource& source)
      : source_(source),
        cloud_(open_plane_cloud(Content::of_file(source.path, decompression_of(source.format, source.path).is_wanted),
                                source)) {}

  bool next(std::vector<Point>& block) override {
    block.clear();
    fields_.clear();
    while (block.size() < points_in_block && !ended_) {
      ended_ = !cloud_->next(columns_);
      if (ended_) break;
      append_points(columns_, block);
      append_fields(columns_, fields_);
    }
    if (source_.shift_longitude) shift_longitude(block, source_.path);
    for (const Point& p : block) box_.add(p);
    points_ += block.size();
    if (block.empty() && !is_finished_) {
      is_finished_ = true;
      cloud_->finish();
      about_ = std::move(cloud_->facts().file);
      settle_crs(about_, source_.crs);
      if (source_.shift_longitude) about_.degrees = true;
      if (about_.degrees && points_ > 0) about_.warnings.push_back(warning_on_degrees(box_));
      if (points_ > 2 && box_.least == box_.greatest) about_.warnings.push_back(warning_on_equal(points_, box_.least));
    }
    return !block.empty();
  }
  std::uint64_t bytes_read() const override { return cloud_->bytes_read(); }

 private:
  PointSource source_;
  std::unique_ptr<Cloud> cloud_;
  CloudBlock columns_ = {};
  std::size_t points_ = 0;  // number of points read
  Box box_ = {};            // of these points
  bool ended_ = false, is_finished_ = false;
};

/// A file that is wholly in memory.
class WholeFile final : public PointBlocks {
 public:
  explicit WholeFile(const PointSource& source) {
    if (source.format != Format::ogr) size_ = Content::of_file(source.path, false).size();
    about_ = read_points(source);
    points_ = std::move(about_.points);
    about_.points = {};
  }

  bool next(std::vector<Point>& block) override {
    const std::size_t count = std::min(points_in_block, points_.size() - first_);
    const auto begin = points_.begin() + static_cast<std::ptrdiff_t>(first_);
    block.assign(begin, begin + static_cast<std::ptrdiff_t>(count));
    fields_.clear();
    for (const std::vector<double>& column : about_.fields)
      fields_.emplace_back(column.begin() + static_cast<std::ptrdiff_t>(first_),
                           column.begin() + static_cast<std::ptrdiff_t>(first_ + count));
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

}  // namespace

std::unique_ptr<PointBlocks> open_point_blocks(const PointSource& source) {
  const CloudFormat* const format = cloud_format(source.format);
  if (format == nullptr || !format->streams) return std::make_unique<WholeFile>(source);
  return std::make_unique<CloudBlocks>(source);
}

}  // namespace rbpa::app
