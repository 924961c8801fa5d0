#include "io/text/plain_text.h"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/text/lines.h"

namespace rbpa::app {
namespace {

using namespace std::string_view_literals;

/// Returns the name of UTF-16 or UTF-32 with its byte order if the bytes begin with the mark of that encoding, or with
/// two characters of UTF-16 that have one zero byte each. Returns "" otherwise.
std::string_view other_encoding(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE\0\0"sv)) return "UTF-32LE";
  if (bytes.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32BE";
  if (bytes.starts_with("\xFF\xFE")) return "UTF-16LE";
  if (bytes.starts_with("\xFE\xFF")) return "UTF-16BE";
  if (bytes.size() < 4) return {};
  const auto is_zero = [&](std::size_t i) { return bytes[i] == '\0'; };
  const bool little = !is_zero(0) && is_zero(1) && !is_zero(2) && is_zero(3);
  const bool big = is_zero(0) && !is_zero(1) && is_zero(2) && !is_zero(3);
  return little ? "UTF-16LE" : big ? "UTF-16BE" : std::string_view();
}

/// Returns the first CR that ends a line alone; null if there is none. A CR at the end of the text may be half of a
/// CRLF, and counts as a blank.
const char* lone_return(const char* at, const char* end) {
  constexpr std::ptrdiff_t at_once = std::ptrdiff_t{16} << 20U;  // bytes of a step; a signal is noticed after it
  for (std::size_t steps = 0; at < end; ++steps) {
    if (steps % 65536 == 0) stop_if_interrupted();
    const std::ptrdiff_t some = std::min(end - at, at_once);
    const auto* const found = static_cast<const char*>(std::memchr(at, '\r', static_cast<std::size_t>(some)));
    if (found == nullptr) {
      at += some;
      steps |= 65535U;
      continue;
    }
    if (found + 1 == end) return nullptr;
    if (found[1] != '\n') return found;
    at = found + 2;
  }
  return nullptr;
}

/// Returns `bytes` with LF in place of each CR that ends a line alone among the first `size` bytes. `room` then holds
/// the result.
std::string_view with_line_feeds(std::string_view bytes, std::size_t size, std::string& room) {
  const char* const found = lone_return(bytes.data(), bytes.data() + size);
  if (found == nullptr) return bytes;
  room.assign(bytes);
  for (auto i = static_cast<std::size_t>(found - bytes.data()); i < size; ++i) {
    if (i % (std::size_t{1} << 24U) == 0) stop_if_interrupted();
    if (room[i] == '\r' && (i + 1 == size || room[i + 1] != '\n')) room[i] = '\n';
  }
  return room;
}

/// Returns the offset after the first line that begins with `word`, and sets `line` to that line. If there is none,
/// returns the size of the text, and `line` is its last line.
std::size_t end_of_line_with(std::string_view text, std::string_view word, std::string_view& line) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    line = text.substr(at, end - at);
    const bool is_pair = text.substr(end, 2) == "\r\n";
    at = std::min(end + (is_pair ? 2 : 1), text.size());
    if (line.starts_with(word)) return at;
  }
  return text.size();
}

/// Returns the size of the header, whose last line begins with `word`, and sets `line` to that line. Binary data may
/// follow: if the first line ends in CR alone, an LF after the header belongs to the data.
std::size_t end_of_header(std::string_view bytes, std::string_view word, std::string_view& line) {
  const std::size_t end = end_of_line_with(bytes, word, line);
  const std::string_view first_end = bytes.substr(std::min(bytes.find_first_of("\r\n"), bytes.size()), 2);
  const bool alone = first_end.starts_with('\r') && first_end != "\r\n";
  return alone && bytes[end - 1] == '\n' ? end - 1 : end;
}

bool begins_with_solid(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return same_letters(text.substr(0, 5), "solid");
}

/// Returns how many bytes at the front of `bytes`, a file without its byte-order mark, are text: all, or only the
/// header of a binary PLY or PCD, or none of a binary STL.
std::size_t text_size(std::string_view bytes, Format format) {
  std::string_view line;
  if (format == Format::ply && bytes.starts_with("ply")) {
    const std::size_t header = end_of_header(bytes, "end_header", line);
    end_of_line_with(bytes.substr(0, header), "format", line);
    return line.find("ascii") != std::string_view::npos ? bytes.size() : header;
  }
  if (format == Format::pcd) {
    const std::size_t header = end_of_header(bytes, "DATA", line);
    return line.find("binary") == std::string_view::npos ? bytes.size() : header;
  }
  if (format == Format::stl && (!begins_with_solid(bytes) || bytes.find('\0') != std::string_view::npos)) return 0;
  return format == Format::ply ? 0 : bytes.size();
}

constexpr bool may_be_text(Format format) {
  constexpr Format texts[] = {Format::off, Format::ply,     Format::obj, Format::stl, Format::pcd,
                              Format::pdb, Format::cif,     Format::pqr, Format::gro, Format::dump,
                              Format::wkt, Format::geojson, Format::poly};
  return is_table(format) || std::find(std::begin(texts), std::end(texts), format) != std::end(texts);
}

/// Returns whether `bytes`, which look like UTF-16 or UTF-32, are text in it. A binary STL file may begin with any
/// bytes: in STL they are text only if they spell "soli" in UTF-16.
bool is_in_other_encoding(std::string_view bytes, Format format) {
  return format != Format::stl || bytes.substr(0, 16).find("s\0o\0l\0i"sv) != std::string_view::npos;
}

}  // namespace

std::string_view without_mark(std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  while (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return text;
}

std::string_view plain_text(std::string_view bytes, const std::string& name, Format format, std::string& room) {
  if (!may_be_text(format)) return bytes;
  if (const std::string_view other = other_encoding(bytes); !other.empty() && is_in_other_encoding(bytes, format))
    bad_input(name, "text in " + std::string(other),
              "UTF-8 (iconv -f " + std::string(other) + " -t UTF-8 " + name + " > FILE makes it)");
  const std::string_view text = without_mark(bytes);
  const std::size_t size = text_size(text, format);
  if (size == 0) return bytes;
  return with_line_feeds(text, size, room);
}

std::string_view plain_text(std::string_view bytes, const std::string& name, std::string& room) {
  return plain_text(bytes, name, Format::text, room);
}

std::string_view with_line_feeds(std::string_view text, std::string& room) {
  return with_line_feeds(text, text.size(), room);
}

std::size_t size_of_lines(std::string_view text) {
  std::size_t last = text.find_last_of("\r\n");
  if (last + 1 == text.size() && last != std::string_view::npos && text[last] == '\r')
    last = text.substr(0, last).find_last_of("\r\n");  // LF may follow
  return last == std::string_view::npos ? 0 : last + 1;
}

}  // namespace rbpa::app
