// What: the items of a point record: runs of bytes that LASzip compresses separately.
// How:  pointwise, one stream has all items of the first point, then those of the next point, and so on. In layers,
//       each field, or group of fields, has a stream of its own for all points of a chunk, and only requested ones are
//       decoded.
// Source: M. Isenburg, LASzip: lossless compression of LiDAR data, PE&RS 79(2), 2013; LASzip 3 for layers.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "io/laz/arithmetic_decoder.h"

namespace rbpa::app {

/// The state that the items of a chunk share.
struct ChunkState {
  std::optional<ArithmeticDecoder> stream = std::nullopt;  ///< has all items; absent in layers
  unsigned channel = 0;  ///< the scanner channel of the point, which selects models of layers
};

/// A decoder of an item of the records of a chunk.
class ItemDecoder {
 public:
  ItemDecoder() = default;
  virtual ~ItemDecoder() = default;
  ItemDecoder(const ItemDecoder&) = delete;
  ItemDecoder& operator=(const ItemDecoder&) = delete;

  /// Decodes the item of the next record to `to`. Throws BadStream.
  virtual void next(char* to, ChunkState& chunk) = 0;
};

/// The arguments of a decoder.
struct ItemStart {
  const char* first;  ///< the item of the first record of the chunk, which is not compressed
  std::size_t size;   ///< in bytes
  unsigned version;
  std::vector<std::string_view> streams;  ///< one for each layer; if it is empty, its fields keep their values
  ChunkState& chunk;
};

struct ItemKind {
  unsigned type, least_version, greatest_version;  ///< LASzip's numbers
  std::size_t size;                                ///< in bytes; 0: any
  std::string_view layers;  ///< character k is the layer of byte k, 'a', 'b', …; empty: each byte is a layer
  std::unique_ptr<ItemDecoder> (*make)(const ItemStart& start);
};

template <typename Item>
std::unique_ptr<ItemDecoder> make_item(const ItemStart& start) {
  return std::make_unique<Item>(start);
}

constexpr unsigned point14 = 10;  ///< the type of the first item in layers

/// Return the kind of the items with a type and a version; null if there is no such kind.
const ItemKind* find_pointwise_item(unsigned type, unsigned version);
const ItemKind* find_layered_item(unsigned type, unsigned version);

}  // namespace rbpa::app
