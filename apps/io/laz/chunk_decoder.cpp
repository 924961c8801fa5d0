#include "io/laz/chunk_decoder.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "io/failure.h"
#include "io/laz/item_models.h"

namespace rbpa::app {

LazFormat read_laz_format(std::string_view data, std::size_t length, const std::string& name) {
  constexpr std::size_t head = 34, entry = 6;
  const std::string where = name + ": the record of LASzip";
  const auto number = [&](std::size_t at) { return load_little<std::uint16_t>(&data[at]); };
  if (data.size() < head || data.size() < head + entry * number(32))
    bad_input(where, counted(data.size(), "byte"), "34, and 6 for each item of a point");
  const unsigned compressor = number(0), coder = number(2);
  if (compressor < 1 || compressor > 3 || coder != 0)
    bad_input(where, "compressor " + std::to_string(compressor) + " with coder " + std::to_string(coder),
              "1, 2 or 3 with 0");
  LazFormat format{
      .compressor = compressor, .has_chunks = compressor > 1, .is_layered = compressor == 3, .length = length};
  const auto chunk_size = load_little<std::uint32_t>(&data[12]);
  if (format.has_chunks && chunk_size > 0) format.chunk_size = chunk_size;
  std::size_t sum = 0;
  for (std::size_t at = head; at < head + entry * number(32); at += entry) {
    const unsigned type = number(at), size = number(at + 2), version = number(at + 4);
    const ItemKind* kind = format.is_layered ? find_layered_item(type, version) : find_pointwise_item(type, version);
    constexpr unsigned most = 8192;  // extra bytes: 341 fields of 24 bytes, as many as a file can describe
    const bool fits = kind != nullptr && size > 0 && size <= most && (kind->size == 0 || kind->size == size) &&
                      (!format.is_layered || (type == point14) == (at == head));
    if (!fits)
      bad_input(where,
                "an item of type " + std::to_string(type) + ", version " + std::to_string(version) + " and " +
                    counted(size, "byte"),
                "one that compressor " + std::to_string(compressor) + " writes here");
    format.items.push_back({kind, size, version});
    format.layers += kind->layers.empty() ? size : std::size_t(*std::ranges::max_element(kind->layers) - 'a' + 1);
    sum += size;
  }
  if (sum != length || sum == 0)
    bad_input(where, "items of " + counted(sum, "byte"), std::to_string(length) + ", as a point record has");
  return format;
}

LazChunk layered_chunk(const LazFormat& format, std::string_view head) {
  LazChunk chunk{load_little<std::uint32_t>(&head[format.length]), format.head()};
  for (std::size_t at = format.length + 4; at < format.head(); at += 4)
    chunk.size += load_little<std::uint32_t>(&head[at]);
  return chunk;
}

void ChunkDecoder::begin(std::string_view bytes, std::size_t points) {
  const std::size_t head = format_.head();
  const LazChunk chunk =
      format_.is_layered && head <= bytes.size() ? layered_chunk(format_, bytes) : LazChunk{points, head};
  if (chunk.size > bytes.size())
    throw BadStream{bytes.data() + bytes.size(), "the end of a chunk of " + counted(bytes.size(), "byte"),
                    std::to_string(chunk.size) + " at least"};
  if (chunk.points != points)
    throw BadStream{bytes.data() + format_.length, "a chunk of " + counted(chunk.points, "point"),
                    std::to_string(points)};
  first_ = bytes.data();
  items_.clear();
  state_ = {};
  std::size_t offset = 0, size_at = format_.length + 4, layer_at = head;
  for (const LazItem& item : format_.items) {
    ItemStart start{first_ + offset, item.size, item.version, {}, state_};
    std::vector<bool> layers;  // whether each layer of the item is wanted
    for (std::size_t i = 0; i < item.size && format_.is_layered; ++i) {
      const std::size_t layer = item.kind->layers.empty() ? i : std::size_t(item.kind->layers[i] - 'a');
      layers.resize(std::max(layers.size(), layer + 1));
      if (wanted_[offset + i]) layers[layer] = true;
    }
    for (const bool is_wanted : layers) {
      const auto size = load_little<std::uint32_t>(&bytes[size_at]);
      start.streams.push_back(bytes.substr(layer_at, is_wanted ? size : 0));
      size_at += 4;
      layer_at += size;
    }
    items_.push_back(item.kind->make(start));
    offset += item.size;
  }
  if (!format_.is_layered) state_.stream.emplace(bytes.substr(head));
}

void ChunkDecoder::next(char* to) {
  if (first_ != nullptr) {
    std::memcpy(to, std::exchange(first_, nullptr), format_.length);
    return;
  }
  for (std::size_t i = 0; i < items_.size(); ++i) {
    items_[i]->next(to, state_);
    to += format_.items[i].size;
  }
}

}  // namespace rbpa::app
