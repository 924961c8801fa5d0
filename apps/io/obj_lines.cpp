#include "io/obj_lines.h"

#include <charconv>

#include "io/failure.h"

namespace rbpa::app {

std::string_view take_obj_line(Lines& lines, std::string& room) {
  std::string_view line = lines.line();
  if (!line.empty() && line.back() == '\\') {
    room.clear();
    while (!line.empty() && line.back() == '\\') {
      room += line.substr(0, line.size() - 1);
      room += ' ';
      line = lines.next() ? lines.line() : std::string_view();
    }
    room += line;
    line = room;
  }
  return line.substr(0, line.find('#'));
}

std::uint32_t take_obj_number(std::string_view word, std::string_view text, std::string_view noun, std::size_t before,
                              const std::string& name, std::size_t line) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto last = static_cast<std::int64_t>(before);
  if (error != std::errc() || end != text.data() + text.size() || number == 0 || number < -last ||
      number > std::int64_t{UINT32_MAX})
    bad_input(at_line(name, line), in_quotes(word),
              "a " + std::string(noun) + " number from 1" +
                  (before == 0 ? "" : ", or from -1 to -" + std::to_string(before)));
  return static_cast<std::uint32_t>(number > 0 ? number - 1 : last + number);
}

}  // namespace rbpa::app
