#include "report/blob.h"

#include <bit>

#include "io/interrupt.h"

namespace rbpa::app {
namespace {

/// Bytes encoded at a time: a multiple of three, so that the encoded pieces together are the base64 of all bytes.
constexpr std::size_t piece = std::size_t{3} << 14U;

}  // namespace

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = i; j < i + 3; ++j)
      group = group << 8U | (j < bytes.size() ? static_cast<std::uint8_t>(bytes[j]) : 0U);
    for (unsigned j = 0; j < 4; ++j) text += i + j > bytes.size() ? '=' : digits[group >> (18U - 6U * j) & 63U];
  }
  return text;
}

Blob::Blob(OutputFile& file, std::string_view name) : file_(file) {
  file_.write("<script type=\"application/base64\" id=\"data-");
  file_.write(name);
  file_.write("\">");
}

void Blob::put(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  for (unsigned byte = 0; byte < 8; ++byte) put_byte(static_cast<std::uint8_t>(bits >> 8U * byte));
}

void Blob::put_whole(std::uint64_t value) {
  for (; value >= 128; value >>= 7U) put_byte(static_cast<std::uint8_t>(value | 128U));
  put_byte(static_cast<std::uint8_t>(value));
}

void Blob::end() {
  flush();
  file_.write("</script>\n");
}

void Blob::put_byte(std::uint8_t byte) {
  bytes_ += static_cast<char>(byte);
  if (bytes_.size() == piece) flush();
}

void Blob::flush() {
  stop_if_interrupted();
  file_.write("\n");
  file_.write(base64(bytes_));
  bytes_.clear();
}

}  // namespace rbpa::app
