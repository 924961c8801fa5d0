#include "io/blocks/array_blocks.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "io/blocks/byte_blocks.h"
#include "io/claim.h"
#include "io/failure.h"
#include "io/las/las_header.h"
#include "io/las/las_projection.h"
#include "io/las/las_record_reader.h"
#include "io/points/binary_points.h"
#include "io/points/npy_points.h"

namespace rbpa::app {
namespace {

std::size_t size_of_content(const ByteBlocks& bytes) { return bytes.is_packed() ? unknown_size : bytes.file_size(); }

void require_content(const ByteBlocks& bytes) {
  if (bytes.file_size() == 0) bad_input(bytes.name(), "an empty file", "points");
}

[[noreturn]] void too_short(const ByteBlocks& bytes, std::uint64_t found, std::uint64_t expected) {
  bad_input(bytes.name(), std::to_string(found) + " of the points", std::to_string(expected) + " as the header says");
}

class RawBlocks final : public PointBlocks {
 public:
  explicit RawBlocks(const PointSource& source) : bytes_(source.path, is_packed_name(source.path)) {
    require_content(bytes_);
    if (!bytes_.is_packed() && bytes_.file_size() % row != 0) refuse_size(bytes_.file_size());
  }

  bool next(std::vector<Point>& block) override {
    buffer_.resize(points_in_block * row);
    const std::size_t size = bytes_.read(buffer_.data(), buffer_.size());
    if (size % row != 0) refuse_size(first_ * row + size);
    const std::size_t count = size / row;
    block = load_points(
        {count, buffer_.data(), buffer_.data() + 8, row, Scalar::float64, Scalar::float64, std::endian::little, first_},
        bytes_.name());
    first_ += count;
    return count > 0;
  }
  std::uint64_t bytes_read() const override { return bytes_.bytes_read(); }

 private:
  static constexpr std::size_t row = 16;

  /// Numbers may begin like a gzip file.
  static bool is_packed_name(const std::string& path) { return path.ends_with(".gz") || path.ends_with(".GZ"); }
  [[noreturn]] void refuse_size(std::uint64_t size) const {
    bad_input(bytes_.name(), counted(size, "byte"), "a multiple of 16 (pairs of float64)");
  }

  ByteBlocks bytes_;
  std::vector<char> buffer_;
  std::size_t first_ = 0;
};

class NpyBlocks final : public PointBlocks {
 public:
  explicit NpyBlocks(const PointSource& source) : bytes_(source.path, true) {
    require_content(bytes_);
    constexpr std::size_t most_header = std::size_t{1} << 20U;
    {
      ByteBlocks beginning(source.path, true);
      array_ = read_npy_layout(first_bytes(beginning, most_header), size_of_content(bytes_), bytes_.name());
    }
    bytes_.skip(array_.data);
    if (!array_.columns_first) return;
    second_.emplace(source.path, true);
    second_->skip(array_.data + std::uint64_t{array_.rows} * array_.item());
  }

  bool next(std::vector<Point>& block) override {
    const std::size_t count = std::min(points_in_block, array_.rows - first_);
    const std::size_t row = second_ ? array_.item() : array_.row();
    read(bytes_, x_, count * row, row);
    if (second_) read(*second_, y_, count * row, row);
    const char* y = second_ ? y_.data() : x_.data() + array_.item();
    block = load_points({count, x_.data(), y, row, array_.type, array_.type, array_.order, first_}, bytes_.name());
    first_ += count;
    return count > 0;
  }
  std::uint64_t bytes_read() const override {
    return second_ ? (bytes_.bytes_read() + second_->bytes_read()) / 2 : bytes_.bytes_read();
  }

 private:
  void read(ByteBlocks& bytes, std::vector<char>& buffer, std::size_t size, std::size_t row) const {
    buffer.resize(size + 1);  // somewhere to point at
    const std::size_t found = bytes.read(buffer.data(), size);
    if (found < size) too_short(bytes, first_ + found / row, array_.rows);
  }

  ByteBlocks bytes_;
  std::optional<ByteBlocks> second_ = std::nullopt;  // of y, where all x come first
  NpyLayout array_ = {};
  std::vector<char> x_, y_;
  std::size_t first_ = 0;
};

/// Everything of the file but its points, with a header that says where the records behind them are now.
struct LasFrame {
  std::string bytes;
  LasHeader header;
};

LasFrame las_frame(const PointSource& source, std::size_t size) {
  constexpr std::size_t most_header = 65536, signature = 2;
  ByteBlocks bytes(source.path, true);
  LasFrame frame{first_bytes(bytes, most_header), {}};
  frame.header = read_las_header(frame.bytes, size, bytes.name());
  const std::size_t begin = frame.header.begin + signature;
  if (frame.bytes.size() < begin) frame.bytes += first_bytes(bytes, begin - frame.bytes.size());
  frame.header = read_las_header(frame.bytes, size, bytes.name());
  return frame;
}

/// What the file says of its system of coordinates, also behind its points.
LasCrs system_of(LasFrame frame, const PointSource& source, bool packed, std::size_t size) {
  LasHeader& header = frame.header;
  frame.bytes.resize(std::min(frame.bytes.size(), header.begin));
  const bool has_more =
      !packed && header.extended_records > 0 && header.extended_begin < size && header.extended_begin > header.begin;
  if (has_more) {
    ByteBlocks bytes(source.path, false);
    bytes.skip(header.extended_begin);
    constexpr std::size_t most = std::size_t{16} << 20U;
    // las_crs() looks behind the first point, which is not there.
    frame.bytes += '\0';
    const std::size_t before = frame.bytes.size();
    frame.bytes += first_bytes(bytes, std::min(size - header.extended_begin, most));
    header.extended_begin = before;
    return las_crs(frame.bytes, header);
  }
  header.extended_records = 0;
  return las_crs(frame.bytes, header);
}

class LasBlocks final : public PointBlocks {
 public:
  explicit LasBlocks(const PointSource& source) : bytes_(source.path, true) {
    require_content(bytes_);
    LasFrame frame = las_frame(source, size_of_content(bytes_));
    header_ = frame.header;
    skip_invalid_ = source.skip_invalid;
    if (bytes_.is_packed()) {
      count_ = header_.count.sought(skip_invalid_);
    } else {
      settle(header_.count);
    }
    reader_.emplace(header_, source.where, bytes_.name());
    const LasCrs system = system_of(std::move(frame), source, bytes_.is_packed(), bytes_.file_size());
    about_.crs = system.crs;
    if (!system.remark.empty()) about_.remarks.push_back(system.remark);
    bytes_.skip(header_.begin);
  }

  bool next(std::vector<Point>& block) override {
    block.clear();
    while (block.empty() && first_ < count_) {
      const std::size_t count = std::min(points_in_block, count_ - first_);
      buffer_.resize(count * header_.length);
      const std::size_t whole = bytes_.read(buffer_.data(), buffer_.size()) / header_.length;
      reader_->take(buffer_.data(), whole, block);
      first_ += whole;
      if (whole < count) settle(header_.count.with_room(first_));
    }
    if (block.empty() && !ended_) end();
    return !block.empty();
  }
  std::uint64_t bytes_read() const override { return bytes_.bytes_read(); }

 private:
  void settle(const LasCount& count) {
    count_ = count.settle(skip_invalid_, bytes_.name(), about_.remarks);
    is_settled_ = true;
  }

  void end() {
    ended_ = true;
    if (!is_settled_) {
      // How many records there are is known when the file is unpacked.
      std::size_t found = first_;
      buffer_.resize(header_.length);
      while (found < header_.count.room() && bytes_.read(buffer_.data(), header_.length) == header_.length) ++found;
      settle(header_.count.with_room(found));
    }
    reader_->tell(about_.remarks);
  }

  ByteBlocks bytes_;
  bool skip_invalid_ = false, is_settled_ = false, ended_ = false;
  LasHeader header_ = {};
  std::optional<LasRecordReader> reader_ = std::nullopt;
  std::vector<char> buffer_;
  std::size_t first_ = 0, count_ = 0;
};

}  // namespace

std::unique_ptr<PointBlocks> open_raw_blocks(const PointSource& source) { return std::make_unique<RawBlocks>(source); }
std::unique_ptr<PointBlocks> open_npy_blocks(const PointSource& source) { return std::make_unique<NpyBlocks>(source); }
std::unique_ptr<PointBlocks> open_las_blocks(const PointSource& source) { return std::make_unique<LasBlocks>(source); }

}  // namespace rbpa::app
