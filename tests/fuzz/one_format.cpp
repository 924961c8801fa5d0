// Keeps libFuzzer at one format: with the environment variable RBPA_FUZZ_FORMAT=ENDING each mutated input names this
// ending (format_of_input.h). Without it libFuzzer may change the ending as it changes any other byte, and most inputs
// name no format. RBPA_FUZZ_FORMAT=list prints the endings that the target reads, one for each row of the table of
// io/formats.h.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>
#include <string_view>

#include "fuzz/format_of_input.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed);
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);

namespace {

using namespace rbpa::app;

const std::string& kept_ending() {
  static const std::string ending = [] {
    const char* value = std::getenv("RBPA_FUZZ_FORMAT");
    return std::string(value ? value : "");
  }();
  return ending;
}

std::string_view first_word(std::string_view words) { return words.substr(0, words.find(' ')); }

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  if (kept_ending() != "list") return 0;
  for (const FormatRow& row : format_table)
    if (row.is_for(RBPA_FUZZ_USE) && row.format != Format::ogr)
      std::cout << first_word(row.endings.empty() ? row.aliases : row.endings) << '\n';
  if (RBPA_FUZZ_USE == Use::points) std::cout << "gzip\ncondition\n";
  std::exit(0);
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  const std::string head = kept_ending() + "\n";
  if (head.size() == 1 || most <= head.size() + 1) return LLVMFuzzerMutate(data, size, most);
  const auto divided = fuzz::divided({reinterpret_cast<const char*>(data), size});
  std::string bytes = divided ? divided->bytes : std::string(reinterpret_cast<const char*>(data), size);
  const std::size_t room = most - head.size() - 1;
  bytes.resize(std::min(bytes.size(), room));
  const std::size_t length = bytes.size();
  bytes.resize(room);
  bytes.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(bytes.data()), length, room));
  data[0] = static_cast<std::uint8_t>(seed % 8 == 0 ? seed >> 8U : divided ? divided->options : 0U);
  std::memcpy(data + 1, head.data(), head.size());
  std::memcpy(data + 1 + head.size(), bytes.data(), bytes.size());
  return 1 + head.size() + bytes.size();
}
