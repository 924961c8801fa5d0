#include "support/laz_file.h"

#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>

#include "support/las_file.h"
#include "support/laz_layer_items.h"
#include "support/laz_stream_items.h"

namespace apps_test {
namespace {

using namespace laz;

std::unique_ptr<Item> item_of(const LazItemSpec& spec, const char* first, unsigned& channel) {
  switch (spec.type) {
    case 0:
      if (spec.version == 1) return std::make_unique<Bytes1>(first, spec.size, false);
      return std::make_unique<Bytes2>(first, spec.size);
    case 7:
      return std::make_unique<Time1>(first);
    case 8:
      return std::make_unique<Bytes1>(first, spec.size, true);
    case 9:
      return std::make_unique<Wave13>(first);
    case 10: {
      auto point = std::make_unique<Point14>(first, spec.version);
      channel = point->first_channel();
      return point;
    }
    default:
      return std::make_unique<ChannelItem>(first, spec, channel);
  }
}

/// The bytes of a record that the layers of an item have: offset and size.
std::vector<std::pair<std::size_t, std::size_t>> layers_of(const LazItemSpec& spec) {
  if (spec.type == 10) return {{0, 8}, {8, 4}, {16, 1}, {15, 1}, {12, 2}, {18, 2}, {17, 1}, {20, 2}, {22, 8}};
  if (spec.type == 11) return {{0, 6}};
  if (spec.type == 12) return {{0, 6}, {6, 2}};
  std::vector<std::pair<std::size_t, std::size_t>> layers;
  for (std::size_t i = 0; i < spec.size; ++i) layers.emplace_back(i, 1);
  return layers;
}

std::string chunk_of(const char* records, std::size_t count, std::size_t length, const LazOptions& options) {
  unsigned channel = 0;
  std::vector<std::unique_ptr<Item>> items;
  const bool layered = options.compressor == 3;
  const auto stream = std::make_shared<Encoder>();
  std::size_t offset = 0;
  for (const LazItemSpec& spec : options.items) {
    items.push_back(item_of(spec, records + offset, channel));
    if (!layered) items.back()->layers.resize(1);
    for (auto& layer : items.back()->layers) layer = layered ? std::make_shared<Encoder>() : stream;
    offset += spec.size;
  }
  for (std::size_t i = 1; i < count; ++i) {
    const char* at = records + i * length;
    for (std::size_t k = 0; k < items.size(); ++k) {
      items[k]->encode(at, channel);
      at += options.items[k].size;
    }
  }
  const std::string first(records, length);
  if (!layered) return first + stream->done();
  std::string sizes, layers;
  offset = 0;
  for (std::size_t k = 0; k < items.size(); ++k) {
    for (std::size_t l = 0; l < items[k]->layers.size(); ++l) {
      const auto [begin, size] = layers_of(options.items[k])[l];
      bool differs = l == 0 && k == 0;
      for (std::size_t i = 1; i < count && !differs; ++i)
        differs = std::memcmp(records + offset + begin, records + i * length + offset + begin, size) != 0;
      const std::string bytes = differs ? items[k]->layers[l]->done() : "";
      sizes += little(bytes.size(), 4);
      layers += bytes;
    }
    offset += options.items[k].size;
  }
  return first + little(count, 4) + sizes + layers;
}

}  // namespace

std::string laz_of(const std::string& las, const LazOptions& options) {
  const std::size_t begin = at<std::uint32_t>(las.data(), 96), length = at<std::uint16_t>(las.data(), 105);
  std::string record =
      little(options.compressor, 2) + little(0, 2) + little(3, 1) + little(4, 1) + little(3, 2) + little(0, 4);
  record += little(options.varies           ? 0xFFFFFFFFU
                   : options.chunks.empty() ? 50000
                                            : options.chunks.front(),
                   4) +
            std::string(16, '\xFF');
  record += little(options.items.size(), 2);
  for (const LazItemSpec& item : options.items)
    record += little(item.type, 2) + little(item.size, 2) + little(item.version, 2);
  const std::string user = "laszip encoded", vlr = little(0, 2) + user + std::string(16 - user.size(), '\0') +
                                                   little(22204, 2) + little(record.size(), 2) + std::string(32, '\0') +
                                                   record;
  std::string points, table;
  Encoder encoder;
  Integers numbers(32, 2);
  std::size_t first = begin;
  std::int32_t last_count = 0, last_size = 0;
  for (const std::size_t count : options.chunks) {
    const std::string chunk = chunk_of(las.data() + first, count, length, options);
    if (options.varies) numbers.encode(encoder, last_count, static_cast<std::int32_t>(count), 0);
    numbers.encode(encoder, last_size, static_cast<std::int32_t>(chunk.size()), 1);
    last_count = static_cast<std::int32_t>(count);
    last_size = static_cast<std::int32_t>(chunk.size());
    points += chunk;
    first += count * length;
  }
  table = little(0, 4) + little(options.chunks.size(), 4) + encoder.done();
  std::string head = las.substr(0, begin);
  head.insert(begin, vlr);
  head.replace(96, 4, little(begin + vlr.size(), 4));
  head.replace(100, 4, little(at<std::uint32_t>(las.data(), 100) + 1, 4));
  head[104] = static_cast<char>(static_cast<unsigned char>(head[104]) | 0x80U);
  if (options.compressor == 1) return head + points;
  const std::uint64_t start = head.size(), place = start + 8 + points.size();
  switch (options.table) {
    case LazOptions::Table::behind:
      return head + little(place, 8) + points + table;
    case LazOptions::Table::at_end:
      return head + little(~std::uint64_t{0}, 8) + points + table + little(place, 8);
    default:
      return head + little(start, 8) + points;
  }
}

}  // namespace apps_test
