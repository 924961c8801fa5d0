#include "io/polygon/json_id.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "io/number.h"

namespace rbpa::app {
namespace {

/// Receives the events of a JSON parser up to the member "id" of the outermost object.
struct JsonId {
  std::string text = {};

  bool null() { return true; }
  bool boolean(bool /*value*/) { return true; }
  bool number_integer(std::int64_t value) { return take(std::to_string(value)); }
  bool number_unsigned(std::uint64_t value) { return take(std::to_string(value)); }
  bool number_float(double value, const std::string& /*text*/) { return take(text_of(value)); }
  bool string(const std::string& value) { return take('"' + value + '"'); }
  bool binary(const std::vector<std::uint8_t>& /*value*/) { return true; }
  bool start_object(std::size_t /*size*/) { return open(); }
  bool end_object() { return close(); }
  bool start_array(std::size_t /*size*/) { return open(); }
  bool end_array() { return close(); }
  bool key(const std::string& key) {
    is_next_ = depth_ == 1 && key == "id";
    return true;
  }
  bool parse_error(std::size_t /*position*/, const std::string& /*token*/, const std::exception& /*error*/) {
    return false;
  }

 private:
  bool take(const std::string& value) {
    if (is_next_ && depth_ == 1) text = value;
    return !is_next_ || depth_ > 1;
  }
  bool open() {
    ++depth_;
    return true;
  }
  bool close() { return --depth_ > 0; }

  std::size_t depth_ = 0;
  bool is_next_ = false;
};

}  // namespace

std::string json_id(const char* begin, const char* end) {
  constexpr std::ptrdiff_t most = std::ptrdiff_t{1} << 20U;
  const char* last = begin + std::min(end - begin, most);
  JsonId id;
  nlohmann::json::sax_parse(JsonPosition(begin), JsonPosition(last), &id, nlohmann::json::input_format_t::json, false);
  return id.text;
}

}  // namespace rbpa::app
