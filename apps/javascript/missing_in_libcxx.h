// What: parts of C++20 that the library uses, and that the standard library of Emscripten 3.1.6 (libc++ 13) lacks. The
//       build includes this header before each source.
#pragma once

#include <version>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 14000
#include <atomic>
#include <bit>
#include <charconv>
#include <memory>
#include <type_traits>

/// Writes `value` as text to `at`. Returns the length of the text, or −1 if the text is longer than `room` bytes.
/// Implemented in common.js.
extern "C" __attribute__((import_module("rbpa"), import_name("text"))) int rbpa_text(double value, char* at, int room);

namespace std {

template <typename To, typename From>
requires(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> && is_trivially_copyable_v<From>) constexpr To
    bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

template <typename T>
requires is_unbounded_array_v<T> unique_ptr<T> make_unique_for_overwrite(size_t size) {
  return unique_ptr<T>(new remove_extent_t<T>[size]);
}

/// An atomic_ref for a single thread: plain loads and stores.
template <typename T>
class atomic_ref {
 public:
  explicit atomic_ref(T& value) : value_(value) {}
  T load(memory_order) const { return value_; }
  void store(T value, memory_order) { value_ = value; }
  bool compare_exchange_strong(T& expected, T wanted, memory_order) {
    const bool is_expected = value_ == expected;
    (is_expected ? value_ : expected) = is_expected ? wanted : value_;
    return is_expected;
  }

 private:
  T& value_;
};

/// Writes the shortest text that reads back to `value`, as JavaScript formats it.
inline to_chars_result to_chars(char* first, char* last, double value) {
  const int length = rbpa_text(value, first, static_cast<int>(last - first));
  return length < 0 ? to_chars_result{last, errc::value_too_large} : to_chars_result{first + length, errc()};
}

}  // namespace std
#endif
