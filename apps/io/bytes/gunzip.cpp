#include "io/bytes/gunzip.h"

#include <algorithm>
#include <new>

#include "io/failure.h"

namespace rbpa::app {
namespace {

std::string reason(int code, const z_stream& state) {
  if (code == Z_BUF_ERROR) return "the end of the file inside compressed data";
  return state.msg == nullptr ? "damaged gzip data" : "damaged gzip data (" + std::string(state.msg) + ")";
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1F\x8B\x08"); }

Gunzip::Gunzip(const std::string& name) : name_(name) {
  constexpr int widest_window = 15, gzip_only = 16;
  if (inflateInit2(&state_, widest_window + gzip_only) != Z_OK) throw std::bad_alloc();
}

std::size_t Gunzip::inflate(std::string_view& compressed, char* to, std::size_t size) {
  if (between_members_) inflateReset(&state_);
  constexpr std::size_t at_once = std::size_t{1} << 20U;  // bytes of a step; a signal is noticed after it
  const std::size_t given = std::min(compressed.size(), at_once);
  state_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(compressed.data()));  // zlib only reads the bytes
  state_.avail_in = static_cast<uInt>(given);
  state_.next_out = reinterpret_cast<Bytef*>(to);
  state_.avail_out = static_cast<uInt>(size);
  const int code = ::inflate(&state_, Z_NO_FLUSH);
  if (code != Z_OK && code != Z_STREAM_END) bad_input(name_, reason(code, state_), "a whole gzip file (copy it again)");
  compressed.remove_prefix(given - state_.avail_in);
  between_members_ = code == Z_STREAM_END;
  return size - state_.avail_out;
}

}  // namespace rbpa::app
