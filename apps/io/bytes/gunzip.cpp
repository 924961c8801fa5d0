#include "io/bytes/gunzip.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>

#include "io/failure.h"
#include "io/interrupt.h"

namespace rbpa::app {
namespace {

/// zlib's state, freed at the end.
class Inflation {
 public:
  Inflation() {
    constexpr int widest_window = 15, gzip_only = 16;
    if (inflateInit2(&state_, widest_window + gzip_only) != Z_OK) throw std::bad_alloc();
  }
  ~Inflation() { inflateEnd(&state_); }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;

  z_stream& state() { return state_; }

 private:
  z_stream state_{};
};

std::string reason(int code, const z_stream& state) {
  if (code == Z_BUF_ERROR) return "the end of the file inside compressed data";
  return state.msg == nullptr ? "damaged gzip data" : "damaged gzip data (" + std::string(state.msg) + ")";
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1F\x8B\x08"); }

void gunzip(std::string_view bytes, const std::string& name, const std::function<char*(std::size_t size)>& room,
            const std::function<void(std::size_t size)>& written) {
  constexpr std::size_t at_once = std::size_t{1} << 20U;  // so that a signal is noticed between two of them
  Inflation inflation;
  z_stream& state = inflation.state();
  while (!bytes.empty()) {
    int code = Z_OK;
    while (code != Z_STREAM_END) {
      stop_if_interrupted();
      const std::size_t given = std::min<std::size_t>(bytes.size(), at_once);
      state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));  // which zlib only reads
      state.avail_in = static_cast<uInt>(given);
      state.next_out = reinterpret_cast<Bytef*>(room(at_once));
      state.avail_out = static_cast<uInt>(at_once);
      code = inflate(&state, Z_NO_FLUSH);
      if (code != Z_OK && code != Z_STREAM_END) bad_input(name, reason(code, state), "a whole gzip file");
      bytes.remove_prefix(given - state.avail_in);
      written(at_once - state.avail_out);
    }
    inflateReset(&state);
    if (!bytes.empty() && !is_gzip(bytes))
      bad_input(name, counted(bytes.size(), "byte") + " behind the compressed data", "the end of the file");
  }
}

}  // namespace rbpa::app
