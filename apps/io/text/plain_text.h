// What: the normal form of text for all readers: without a byte-order mark, and with lines that end in LF.
// Law:  a byte-order mark of UTF-8, and CR or CRLF in place of LF, do not change the text. Bytes that are not text
//       remain unchanged. Lines keep their numbers.
// Cost: one search for CR; a copy if a line ends in CR alone.
#pragma once

#include <string>
#include <string_view>

#include "io/formats.h"

namespace rbpa::app {

/// Return `bytes` in the normal form; with `format`, only the part that is text in a file of that format is changed. If
/// a line ends in CR alone, the result is in `room`. Throw BadInput that names `name` for UTF-16 and UTF-32; Cancelled.
std::string_view plain_text(std::string_view bytes, const std::string& name, std::string& room);
std::string_view plain_text(std::string_view bytes, const std::string& name, Format format, std::string& room);

/// Returns the text after any byte-order marks of UTF-8.
std::string_view without_mark(std::string_view text);

/// Returns the normal form of `text`, a later piece of a text, which begins at the beginning of a line and ends as
/// size_of_lines() says. If a line ends in CR alone, the result is in `room`. Throws Cancelled.
std::string_view with_line_feeds(std::string_view text, std::string& room);

/// Returns the size in bytes of the whole lines at the front of `text`; 0 if no line certainly ends in `text`: a CR at
/// its end may be followed by LF.
std::size_t size_of_lines(std::string_view text);

}  // namespace rbpa::app
