#include "io/text/cif_tokens.h"

#include <algorithm>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/text/lines.h"

namespace rbpa::app {
namespace {

using Kind = CifTokens::Kind;

bool ends_line(char c) { return c == '\n' || c == '\r'; }
bool is_white(char c) { return is_blank(c) || c == '\n'; }

Kind kind_of(std::string_view word) {
  const auto begins = [&](std::string_view keyword) { return same_letters(word.substr(0, keyword.size()), keyword); };
  if (word.front() == '_') return Kind::name;
  if (same_letters(word, "loop_")) return Kind::loop;
  if (begins("data_") || begins("save_") || same_letters(word, "global_") || same_letters(word, "stop_"))
    return Kind::block;
  return word == "?" || word == "." ? Kind::no_value : Kind::value;
}

}  // namespace

CifTokens::CifTokens(std::string_view text, const std::string& name)
    : begin_(text.data()), at_(begin_), end_(begin_ + text.size()), name_(name) {
  next();
}

void CifTokens::next() {
  if (++tokens_ % 65536 == 0) stop_if_interrupted();
  pass_blanks();
  token_line_ = line_;
  text_ = {};
  kind_ = Kind::end;
  if (at_ == end_) return;
  if (*at_ == ';' && (at_ == begin_ || ends_line(at_[-1]))) return take_lines();
  if (*at_ == '\'' || *at_ == '"') return take_quoted();
  const char* const first = at_;
  at_ = std::find_if(at_, end_, is_white);
  text_ = {first, static_cast<std::size_t>(at_ - first)};
  kind_ = kind_of(text_);
  if (kind_ == Kind::no_value) text_ = {};
}

/// Skips blanks, and comments, which may begin only where a token may.
void CifTokens::pass_blanks() {
  for (; at_ != end_; ++at_) {
    if (*at_ == '#') at_ = std::find_if(at_, end_, ends_line);
    if (at_ == end_ || !is_white(*at_)) return;
    const bool is_half = *at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n';
    if (ends_line(*at_) && !is_half && ++line_ % 65536 == 0) stop_if_interrupted();
  }
}

/// Takes a quoted value. A quote ends the value only if a blank follows: 'O5'' is O5'.
void CifTokens::take_quoted() {
  const char quote = *at_;
  const char* const first = ++at_;
  for (; at_ != end_ && !ends_line(*at_); ++at_) {
    if (*at_ != quote || (at_ + 1 != end_ && !is_white(at_[1]))) continue;
    text_ = {first, static_cast<std::size_t>(at_++ - first)};
    kind_ = Kind::value;
    return;
  }
  bad_input(at_line(name_, line_), in_quotes({first - 1, static_cast<std::size_t>(at_ - first + 1)}),
            "a value whose quotes end in its line");
}

/// Takes a multi-line value, up to a line that begins with a semicolon.
void CifTokens::take_lines() {
  const char* const first = ++at_;
  for (; at_ != end_; ++at_) {
    if (!ends_line(*at_)) continue;
    const bool is_half = *at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n';
    if (!is_half && ++line_ % 65536 == 0) stop_if_interrupted();
    if (is_half || at_ + 1 == end_ || at_[1] != ';') continue;
    text_ = trimmed({first, static_cast<std::size_t>(at_ - first)});
    kind_ = Kind::value;
    at_ += 2;
    return;
  }
  bad_input(at_line(name_, token_line_), "a text of lines that does not end", "a later line that begins with ';'");
}

}  // namespace rbpa::app
