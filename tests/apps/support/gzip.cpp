#include "support/gzip.h"

#include <zlib.h>

#include <map>
#include <stdexcept>

namespace apps_test {

namespace {

std::string compressed_at(int level, const std::string& content) {
  z_stream state{};
  constexpr int widest_window = 15, gzip_only = 16, memory = 8;
  if (deflateInit2(&state, level, Z_DEFLATED, widest_window + gzip_only, memory, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("zlib");
  std::string bytes(deflateBound(&state, content.size()), '\0');
  state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));  // which zlib only reads
  state.avail_in = static_cast<uInt>(content.size());
  state.next_out = reinterpret_cast<Bytef*>(bytes.data());
  state.avail_out = static_cast<uInt>(bytes.size());
  const int code = deflate(&state, Z_FINISH);
  bytes.resize(state.total_out);
  deflateEnd(&state);
  if (code != Z_STREAM_END) throw std::runtime_error("zlib");
  return bytes;
}

}  // namespace

std::string compressed(const std::string& content) { return compressed_at(Z_BEST_SPEED, content); }

std::string bomb(const std::string& content, const std::string& filler, std::size_t size) {
  constexpr std::size_t member_size = std::size_t{16} << 20U;
  static std::map<std::string, std::string> members;  // a gzip file may have several
  std::string& member = members[filler];
  if (member.empty()) {
    std::string much;
    while (much.size() < member_size) much += filler;
    member = compressed_at(Z_BEST_COMPRESSION, much);
  }
  std::string bytes = compressed(content);
  for (std::size_t done = 0; done < size; done += member_size) bytes += member;
  return bytes;
}

}  // namespace apps_test
