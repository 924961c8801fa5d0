#include "io/bytes/lzf.h"

#include <lzf.h>

#include <limits>
#include <optional>

#include "io/bytes/available_memory.h"
#include "io/failure.h"

namespace rbpa::app {
namespace {

/// The greatest ratio of the format: three bytes stand for a copy of at most 264 bytes.
constexpr std::size_t most_for_each = 88;

/// Memory per decompressed byte: the byte itself, and two more for the points, as numbers of 4 bytes become 8.
constexpr double bytes_in_memory = 3;

}  // namespace

std::vector<char> decompress_lzf(std::string_view compressed, std::size_t size, const std::string& place) {
  constexpr std::size_t most = std::numeric_limits<unsigned>::max();
  if (size > most || compressed.size() > most || size > most_for_each * compressed.size())
    bad_input(place, counted(compressed.size(), "byte") + " of compressed data",
              std::to_string(size / most_for_each + (size % most_for_each > 0 ? 1 : 0)) + " or more for " +
                  counted(size, "byte") + " decompressed");
  const std::optional<double> there = available_memory();
  if (there && bytes_in_memory * static_cast<double>(size) > *there)
    bad_input(place, bytes_text(static_cast<double>(size)) + " decompressed",
              "at most a third of the " + bytes_text(*there) + " of available memory");
  std::vector<char> decompressed(size);
  if (size == 0) return decompressed;
  const unsigned count = lzf_decompress(compressed.data(), static_cast<unsigned>(compressed.size()),
                                        decompressed.data(), static_cast<unsigned>(size));
  if (count == 0) bad_input(place, "damaged compressed data", "data for " + counted(size, "byte"));
  if (count != size) bad_input(place, counted(count, "byte") + " decompressed", std::to_string(size));
  return decompressed;
}

}  // namespace rbpa::app
