#include "io/failure.h"

#include "io/message.h"

namespace rbpa::app {

void bad_input(const std::string& where, const std::string& found, const std::string& expected) {
  throw BadInput(where + ": found " + found + ", expected " + expected);
}

std::string at_line(std::string_view file, std::size_t line) { return std::string(file) + ":" + std::to_string(line); }

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 60;
  const bool clipped = text.size() > longest;
  if (clipped) {
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // not inside a UTF-8 character
    text = text.substr(0, end);
  }
  std::string result = "'";
  result += printable(text);
  return result += clipped ? "...'" : "'";
}

std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace rbpa::app
