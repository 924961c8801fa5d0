// What: the exports that every WebAssembly module has: memory for inputs; arrays and an error message as outputs.
// Law:  one call runs at a time. The results of a call are valid until the next call or rbpa_clear().
#pragma once

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#define RBPA_EXPORT extern "C" __attribute__((used, visibility("default")))

namespace rbpa::javascript {

/// The arrays of the last call, in the order in which JavaScript reads them.
class Results {
 public:
  void clear() { arrays_.clear(); }
  /// Appends an array. Requires: Item has no padding, as JavaScript reads all bytes as numbers.
  template <typename Item>
  void add(std::vector<Item> items) {
    const auto kept = std::make_shared<std::vector<Item>>(std::move(items));
    arrays_.push_back({kept, kept->data(), kept->size() * sizeof(Item)});
  }
  std::size_t bytes(std::size_t i) const { return i < arrays_.size() ? arrays_[i].bytes : 0; }
  const void* begin(std::size_t i) const { return i < arrays_.size() ? arrays_[i].begin : nullptr; }

 private:
  struct Array {
    std::shared_ptr<void> owner;
    const void* begin;
    std::size_t bytes;
  };
  std::vector<Array> arrays_;
};

inline Results results;
inline std::string message;

/// Calls work(). Returns true if it throws no exception; otherwise clears the results, sets `message` to the text of
/// the exception, and returns false.
template <typename Work>
bool completes(const Work& work) {
  results.clear();
  message.clear();
  try {
    work();
    return true;
  } catch (const std::bad_alloc&) {
    message = "out of memory: WebAssembly has at most 4 GiB";
  } catch (const std::exception& e) {
    message = e.what();
  }
  results.clear();
  return false;
}

}  // namespace rbpa::javascript

RBPA_EXPORT void* rbpa_allocate(std::size_t bytes) { return std::malloc(bytes); }
RBPA_EXPORT void rbpa_release(void* memory) { std::free(memory); }
RBPA_EXPORT const char* rbpa_message() { return rbpa::javascript::message.c_str(); }
RBPA_EXPORT const void* rbpa_result(std::size_t i) { return rbpa::javascript::results.begin(i); }
RBPA_EXPORT std::size_t rbpa_bytes(std::size_t i) { return rbpa::javascript::results.bytes(i); }
RBPA_EXPORT void rbpa_clear() { rbpa::javascript::results.clear(); }
