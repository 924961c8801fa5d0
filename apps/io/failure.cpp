#include "io/failure.h"

#include "io/message.h"

namespace rbpa::app {

void bad_input(const std::string& where, const std::string& found, const std::string& expected) {
  throw BadInput(where + ": found " + found + ", expected " + expected);
}

std::string at_line(std::string_view file, std::size_t line) { return std::string(file) + ":" + std::to_string(line); }

namespace {

constexpr std::size_t longest_piece = 60;

std::string_view clipped(std::string_view text) {
  if (text.size() <= longest_piece) return text;
  std::size_t end = longest_piece;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // not inside a UTF-8 character
  return text.substr(0, end);
}

}  // namespace

std::string shown(std::string_view text) {
  return printable(clipped(text)) + (text.size() > longest_piece ? "..." : "");
}

std::string in_quotes(std::string_view text) {
  std::string result = "'";
  result += shown(text);
  return result += "'";
}

std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace rbpa::app
