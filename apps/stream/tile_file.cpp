#include "stream/tile_file.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "stream/scratch_file.h"

namespace rbpa::app {
namespace {

constexpr std::string_view magic = "RBPATILE";
constexpr std::uint32_t file_version = 1;

/// The first bytes of a file, in the layout of a little-endian machine.
struct Header {
  char magic[8];
  std::uint32_t version;
  std::uint32_t checksum;  // checksum of the members below
  double box[4];
  double alpha;
  std::uint64_t points, owned, bytes, blocks;
  std::uint32_t of_blocks, nothing;
};
static_assert(sizeof(Header) == 96);

std::string bytes_of(const Region& box, double alpha, const TileSummary& summary) {
  Header header{{},
                file_version,
                0,
                {box.x0, box.y0, box.x1, box.y1},
                alpha,
                summary.points,
                summary.owned,
                summary.bytes,
                summary.blocks,
                summary.checksum,
                0};
  std::copy(magic.begin(), magic.end(), header.magic);
  const char* bytes = reinterpret_cast<const char*>(&header);
  header.checksum = checksum_of({bytes + 16, sizeof header - 16});
  return {bytes, sizeof header};
}

/// The size and the checksum of a block, which precede the block in the file.
struct BlockFrame {
  std::uint32_t size, checksum;
};

}  // namespace

TileWriter::TileWriter(std::string path, const Region& box, double alpha)
    : path_(std::move(path)), box_(box), alpha_(alpha) {}

void TileWriter::resume(const TileSummary& summary) {
  summary_ = summary;
  begun_ = summary.blocks > 0;
  if (!begun_) return;
  const std::uint64_t size = sizeof(Header) + summary.bytes;
  if (access(path_.c_str(), F_OK) != 0) throw Damaged(path_ + ": found no file, expected the file of a tile");
  ScratchFile file(path_, ScratchFile::Mode::update);
  if (file.size() < size)
    throw Damaged(path_ + ": found " + std::to_string(file.size()) + " bytes, expected at least " +
                  std::to_string(size));
  file.cut(size);
}

void TileWriter::flush() {
  if (begun_ && waiting_.size() == 0) return;
  std::string bytes;
  if (!begun_) bytes.assign(sizeof(Header), '\0');  // write zeros, which finish() replaces by the header
  for (std::size_t first = 0; first < waiting_.size(); first += most_in_packed_block) {
    const std::size_t count = std::min(most_in_packed_block, waiting_.size() - first);
    const std::size_t at = bytes.size();
    bytes.resize(at + sizeof(BlockFrame));
    pack_block(std::span(waiting_.points).subspan(first, count), std::span(waiting_.indices).subspan(first, count),
               hint_, bytes);
    const std::string_view block = std::string_view(bytes).substr(at + sizeof(BlockFrame));
    const BlockFrame frame{static_cast<std::uint32_t>(block.size()), checksum_of(block)};
    std::memcpy(bytes.data() + at, &frame, sizeof frame);
    summary_.checksum = checksum_of({reinterpret_cast<const char*>(&frame), sizeof frame}, summary_.checksum);
    summary_.bytes += sizeof(BlockFrame) + frame.size;
    ++summary_.blocks;
  }
  summary_.points += waiting_.size();
  waiting_ = {};
  ScratchFile(path_, begun_ ? ScratchFile::Mode::append : ScratchFile::Mode::write).write(bytes);
  begun_ = true;
}

TileSummary TileWriter::finish() {
  flush();
  ScratchFile(path_, ScratchFile::Mode::update).write(bytes_of(box_, alpha_, summary_));
  return summary_;
}

TileReader::TileReader(const std::string& path, const Region& box, double alpha) : path_(path) {
  if (access(path.c_str(), F_OK) != 0) throw Damaged(path + ": found no file, expected the file of a tile");
  file_ = std::make_unique<ScratchFile>(path, ScratchFile::Mode::read);
  Header header{};
  char* bytes = reinterpret_cast<char*>(&header);
  read(bytes, sizeof header);
  summary_ = {header.points, header.owned, header.bytes, header.blocks, header.of_blocks};
  if (bytes_of(box, alpha, summary_) != std::string_view(bytes, sizeof header)) damaged();
}

TileReader::~TileReader() = default;

bool TileReader::next(IndexedPoints& points) {
  if (blocks_ == summary_.blocks) {
    const bool is_whole = file_->size() == sizeof(Header) + summary_.bytes;
    if (!is_whole || points_ != summary_.points || checksum_ != summary_.checksum) damaged();
    return false;
  }
  BlockFrame frame{};
  read(reinterpret_cast<char*>(&frame), sizeof frame);
  constexpr std::uint32_t most = 3 * 11 + 2 + 3 * 8 * (most_in_packed_block + 1);
  if (frame.size > most) damaged();
  buffer_.resize(frame.size);
  read(buffer_.data(), buffer_.size());
  const std::size_t before = points.size();
  if (checksum_of(buffer_) != frame.checksum || !unpack_block(buffer_, points)) damaged();
  checksum_ = checksum_of({reinterpret_cast<const char*>(&frame), sizeof frame}, checksum_);
  points_ += points.size() - before;
  ++blocks_;
  return true;
}

void TileReader::read(char* to, std::size_t size) {
  if (file_->read(to, size) < size) damaged();
}

void TileReader::damaged() const {
  throw Damaged(path_ + ": found a file that was truncated or changed, expected an unchanged one");
}

IndexedPoints read_tile(TileReader& reader) {
  IndexedPoints points;
  points.points.reserve(reader.summary().points);
  points.indices.reserve(reader.summary().points);
  while (reader.next(points)) stop_if_interrupted();
  return points;
}

}  // namespace rbpa::app
