// What: how a program of ours ends without a result, and what it says on standard error: one line, without its name and
//       without anything that a terminal would obey.
// Law:  whatever is in a name or in a piece of input, a message is one line of text.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace rbpa::app {

/// The input is not what it should be (exit code 3).
class BadInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The command line asks for something that does not exist (exit code 2).
class WrongUsage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Something outside went wrong while running, such as a full disk (exit code 1).
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Nobody reads what is written any more (exit code 141). Nothing is said about it: `rbpa alpha --csv | head` is no failure.
class ClosedPipe : public std::runtime_error {
 public:
  ClosedPipe() : std::runtime_error("the reader of the output is gone") {}
};

/// Throws BadInput "WHERE: found FOUND, expected EXPECTED".
[[noreturn]] void bad_input(const std::string& where, const std::string& found, const std::string& expected);

/// "FILE:LINE", the way compilers name a place in a text.
std::string at_line(std::string_view file, std::size_t line);

/// The text printable() and clipped when long: a piece of input in a message, which a zero byte would cut off.
std::string shown(std::string_view text);
/// The same in single quotes.
std::string in_quotes(std::string_view text);

/// "1 column", "2 columns".
std::string counted(std::size_t count, std::string_view noun);

/// The text with everything that is no visible character written out: \n \r \t, and \x1b for other bytes. Those are
/// control characters, what is no UTF-8, other ends of lines, and marks that turn the direction of writing.
std::string printable(std::string_view text);

/// "PROGRAM: MESSAGE" on standard error, printable.
void say(std::string_view program, std::string_view message);

}  // namespace rbpa::app
