// What: turns the errors of libpng into a result of false and a message.
#pragma once

#include <png.h>

#include <array>
#include <csetjmp>
#include <cstdio>

namespace rbpa::app {

/// The base of a class that reads or writes PNG. libpng reports an error by longjmp(), which must not skip a
/// destructor; therefore steps and callbacks have no objects with destructors.
class PngErrors {
 public:
  const char* message() const { return message_.data(); }  ///< libpng's message about the last error

 protected:
  /// Calls step(). Returns false after an error of libpng. Requires: `png` was made with errors() and fail().
  template <typename Step>
  static bool attempt(png_struct* png, const Step& step) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    step();
    return true;
  }
  static void fail(png_struct* png, const char* message) {
    auto& self = *static_cast<PngErrors*>(png_get_error_ptr(png));
    std::snprintf(self.message_.data(), self.message_.size(), "%s", message);
    png_longjmp(png, 1);
  }
  PngErrors* errors() { return this; }  ///< the pointer that libpng passes to fail()

 private:
  std::array<char, 128> message_{};
};

}  // namespace rbpa::app
