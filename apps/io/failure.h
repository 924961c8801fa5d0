// What: exceptions that end a program without a result, and messages on standard error: one line, without control
//       characters that a terminal would obey.
// Law:  a message is one line of text, whatever bytes are in a file name or in a piece of input.
#pragma once

#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rbpa::app {

/// Invalid input (exit code 3).
class BadInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An invalid command line (exit code 2).
class WrongUsage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An error of the environment, such as a full disk (exit code 1).
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The reader of the output has closed it (exit code 141). The program prints no message: `rbpa alpha --csv | head` is
/// not a failure.
class ClosedPipe : public std::runtime_error {
 public:
  ClosedPipe() : std::runtime_error("the reader of the output is gone") {}
};

/// Throws BadInput "WHERE: found FOUND, expected EXPECTED".
[[noreturn]] void bad_input(const std::string& where, const std::string& found, const std::string& expected);
/// Throws WrongUsage "OPTION: found FOUND, expected EXPECTED".
[[noreturn]] void bad_usage(const std::string& option, const std::string& found, const std::string& expected);

/// Throws WrongUsage "OPTION WHY" for the first option that is given; each of `options` has a flag and a name.
void refuse_given(std::initializer_list<std::pair<bool, const char*>> options, const std::string& why);

/// Throws BadInput after a call has failed to open the file `name`: "NAME: found no such file, expected EXPECTED", or
/// "NAME: cannot open: " with the reason in errno. The message for an address ("://") says to download it.
[[noreturn]] void refuse_to_open(const std::string& name, const std::string& expected);

/// Returns "FILE:LINE", as compilers name a place in a text.
std::string at_line(std::string_view file, std::size_t line);

/// Returns a piece of input for a message: printable(text); if it is longer than 60 bytes, its beginning and "...".
std::string shown(std::string_view text);
/// Returns shown(text) in single quotes.
std::string in_quotes(std::string_view text);

/// Returns a count with its noun: "1 column", "2 columns".
std::string counted(std::size_t count, std::string_view noun);

/// Returns the words with commas between them, and `last` before the last word: "a, b and c" if `last` is " and ".
std::string listed(const std::vector<std::string>& words, std::string_view last);

/// Returns the text with escapes in place of invisible characters: \n, \r, \t, and hexadecimal digits for any other
/// byte, as in \x1b. Invisible characters are control characters, bytes that are not UTF-8, line separators, marks
/// without width, and marks that change the direction of writing.
std::string printable(std::string_view text);

/// Writes "PROGRAM: MESSAGE", made printable, to standard error.
void say(std::string_view program, std::string_view message);

}  // namespace rbpa::app
