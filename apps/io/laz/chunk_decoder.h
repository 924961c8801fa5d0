// What: reads how the points of a LAZ file are compressed, and decodes chunks of points to records of LAS.
// Law:  a chunk is decoded without the bytes of other chunks.
// Source: M. Isenburg, LASzip: lossless compression of LiDAR data, PE&RS 79(2), 2013; the record "laszip encoded".
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/laz/items.h"

namespace rbpa::app {

struct LazItem {
  const ItemKind* kind;
  std::size_t size;  ///< in bytes
  unsigned version;
};

struct LazFormat {
  unsigned compressor = 0;  ///< version of LASzip's compressor: 1, 2 or 3
  bool has_chunks = false, is_layered = false;
  std::uint32_t chunk_size = varying;  ///< number of points in each chunk but the last
  std::size_t length = 0;              ///< size of a record, in bytes
  std::size_t layers = 0;              ///< number of layers of all items
  std::vector<LazItem> items = {};

  /// Returns the number of bytes before the layers or the stream of a chunk.
  std::size_t head() const { return length + (is_layered ? 4 + 4 * layers : 0); }

  static constexpr std::uint32_t varying = 0xFFFFFFFF;
};

/// Reads the data of the record "laszip encoded" of a file with point records of `length` bytes. Throws BadInput that
/// names the file `name`.
LazFormat read_laz_format(std::string_view data, std::size_t length, const std::string& name);

struct LazChunk {
  std::size_t points;
  std::uint64_t size;  ///< in bytes
};

/// Returns the number of points and the size of the layered chunk that begins with `head`, which holds the first
/// record, the number of points, and the sizes of the layers.
LazChunk layered_chunk(const LazFormat& format, std::string_view head);

class ChunkDecoder {
 public:
  /// Makes a decoder. In a layered chunk it decodes only layers that have a byte k of a record with wanted[k]; the
  /// bytes of other layers stay as in the first record. `format` and `wanted` must outlive the decoder.
  ChunkDecoder(const LazFormat& format, const std::vector<bool>& wanted) : format_(format), wanted_(wanted) {}

  /// Begins a chunk. Its bytes must outlive the decoding. Throws BadStream.
  void begin(std::string_view bytes, std::size_t points);
  /// Decodes the next record to `to`. Throws BadStream.
  void next(char* to);

  /// Returns the byte after the decoded bytes. Requires: the format is not layered.
  const char* at() const { return state_.stream->at(); }
  /// Continues with `bytes`, a copy of the bytes from at() on. Requires: as at().
  void move_to(std::string_view bytes) { state_.stream->move_to(bytes); }

 private:
  const LazFormat& format_;
  const std::vector<bool>& wanted_;
  ChunkState state_ = {};
  std::vector<std::unique_ptr<ItemDecoder>> items_ = {};
  const char* first_ = nullptr;  // the first record, until it is copied
};

}  // namespace rbpa::app
