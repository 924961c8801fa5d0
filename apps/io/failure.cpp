#include "io/failure.h"

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>

#include "io/utf8.h"

namespace rbpa::app {

void bad_input(const std::string& where, const std::string& found, const std::string& expected) {
  throw BadInput(where + ": found " + found + ", expected " + expected);
}

void bad_usage(const std::string& option, const std::string& found, const std::string& expected) {
  throw WrongUsage(option + ": found " + found + ", expected " + expected);
}

void refuse_given(std::initializer_list<std::pair<bool, const char*>> options, const std::string& why) {
  for (const auto& [is_given, option] : options)
    if (is_given) throw WrongUsage(std::string(option) + " " + why);
}

void refuse_to_open(const std::string& name, const std::string& expected) {
  const bool is_address = name.find("://") != std::string::npos;
  if (errno == ENOENT)
    bad_input(name, is_address ? "an address" : "no such file",
              expected + (is_address ? " (download it first: curl -LO " + name + ")" : ""));
  throw BadInput(name + ": cannot open: " + std::strerror(errno));
}

std::string at_line(std::string_view file, std::size_t line) { return std::string(file) + ":" + std::to_string(line); }

namespace {

constexpr std::size_t longest_piece = 60;

std::string_view clipped(std::string_view text) {
  if (text.size() <= longest_piece) return text;
  std::size_t end = longest_piece;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // do not cut a UTF-8 character
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

std::string listed(const std::vector<std::string>& words, std::string_view last) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i)
    list.append(i == 0 ? "" : i + 1 == words.size() ? last : ", ").append(words[i]);
  return list;
}

namespace {

bool is_visible(char32_t code) {
  static constexpr std::pair<char32_t, char32_t> hidden[] = {
      {0x00, 0x1F},     {0x7F, 0x9F},      // control characters
      {0x200B, 0x200F}, {0x202A, 0x202E},  // marks without width, embeddings and overrides of direction
      {0xFEFF, 0xFEFF},                    // the byte-order mark
      {0x2066, 0x2069},                    // isolates of direction
      {0x2028, 0x2029}};                   // ends of lines and paragraphs
  for (const auto& [first, last] : hidden)
    if (code >= first && code <= last) return false;
  return true;
}

void append_escaped(std::string& text, char c) {
  constexpr std::string_view digits = "0123456789abcdef";
  if (c == '\n' || c == '\r' || c == '\t') {
    text += '\\';
    text += c == '\n' ? 'n' : c == '\r' ? 'r' : 't';
    return;
  }
  text += "\\x";
  text += digits[static_cast<unsigned char>(c) >> 4U];
  text += digits[static_cast<unsigned char>(c) & 15U];
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto [code, size] = first_character(text);
    if (size > 0 && is_visible(code)) {
      result += text.substr(0, size);
      text.remove_prefix(size);
      continue;
    }
    // Escape only the stray byte: a character may follow it.
    for (std::size_t i = 0; i < (size == 0 ? 1 : size); ++i) append_escaped(result, text[i]);
    text.remove_prefix(size == 0 ? 1 : size);
  }
  return result;
}

void say(std::string_view program, std::string_view message) {
  // Write once, so that lines of several programs on one terminal do not mix.
  const std::string line = std::string(program) + ": " + printable(message) + "\n";
  std::fputs(line.c_str(), stderr);
}

}  // namespace rbpa::app
