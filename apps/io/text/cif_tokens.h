// What:   splits a text in CIF into tokens.
// Law:    the case of names and keywords does not matter; a quoted value ends at its closing quote.
// Source: https://www.iucr.org/resources/cif/spec/version1.1/cifsyntax
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace rbpa::app {

class CifTokens {
 public:
  enum class Kind : std::uint8_t {
    end,
    name,  ///< _atom_site.id
    loop,
    block,    ///< data_NAME, save_NAME, or another keyword that ends the loop before
    value,    ///< without its quotes
    no_value  ///< ? or .
  };

  /// Goes to the first token. `name` stands for the text in messages; both must outlive this object. Throws as next().
  CifTokens(std::string_view text, const std::string& name);

  /// Goes to the next token. Throws BadInput for quotes and multi-line texts without an end; Cancelled.
  void next();

  Kind kind() const { return kind_; }
  bool is_value() const { return kind_ == Kind::value || kind_ == Kind::no_value; }
  std::string_view text() const { return text_; }   ///< empty for no_value
  std::size_t line() const { return token_line_; }  ///< line where the token begins, from 1

 private:
  void pass_blanks();
  void take_quoted();
  void take_lines();

  const char* begin_;
  const char* at_;
  const char* end_;
  const std::string& name_;
  Kind kind_ = Kind::end;
  std::string_view text_ = {};
  std::size_t line_ = 1, token_line_ = 1, tokens_ = 0;
};

}  // namespace rbpa::app
