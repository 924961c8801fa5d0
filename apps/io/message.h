// What: what a program of ours says on standard error: one line at a time, without anything a terminal would obey.
// Law:  whatever is in a name or in a piece of input, a message is one line of text.
#pragma once

#include <string>
#include <string_view>

namespace rbpa::app {

/// The text with everything that is no visible character written out: \n \r \t, and \x1b for other bytes. Those are
/// control characters, what is no UTF-8, other ends of lines, and marks that turn the direction of writing.
std::string printable(std::string_view text);

/// "PROGRAM: MESSAGE" on standard error, printable.
void say(std::string_view program, std::string_view message);

}  // namespace rbpa::app
