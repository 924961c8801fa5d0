// What: the text of a file as all readers of text take it: without the mark of its encoding, and with lines that end in
//       LF.
// Law:  bytes, or the same behind the mark of UTF-8, or with CR or CRLF at the end of any line, are one text. What is
//       no text stays as it is. Lines keep their numbers.
// Cost: one search for CR; where a line ends in CR alone, a copy.
#pragma once

#include <string>
#include <string_view>

#include "io/formats.h"

namespace rbpa::app {

/// The text that `bytes` are, or as far as they are text in a file of that format; in `room` where it is not among
/// them. Throws BadInput where it is UTF-16 or UTF-32.
std::string_view plain_text(std::string_view bytes, const std::string& name, std::string& room);
std::string_view plain_text(std::string_view bytes, const std::string& name, Format format, std::string& room);

/// Returns the text behind the mark of UTF-8, however often that stands there.
std::string_view without_mark(std::string_view text);

/// Likewise for a piece of a text that begins with a line, as size_of_lines() cuts it, behind others.
std::string_view with_line_feeds(std::string_view text, std::string& room);

/// Returns how many bytes of `text` are whole lines: 0 where none ends in it for certain.
std::size_t size_of_lines(std::string_view text);

}  // namespace rbpa::app
