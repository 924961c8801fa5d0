// What: tells the thread sanitizer what it cannot see: that a library which was not built with it has put one piece of
//       work before another.
#pragma once

#if defined(__SANITIZE_THREAD__)
#define RBPA_THREAD_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define RBPA_THREAD_SANITIZER 1
#endif
#endif

#ifdef RBPA_THREAD_SANITIZER
extern "C" void __tsan_acquire(void* address);
extern "C" void __tsan_release(void* address);
#endif

namespace rbpa {

/// What any thread did before it signals is before what any thread does after it has waited. Costs nothing without the
/// sanitizer, and orders nothing: it only reports an order that there is.
class Handover {
 public:
#ifdef RBPA_THREAD_SANITIZER
  void signal() { __tsan_release(this); }
  void wait() { __tsan_acquire(this); }

 private:
  char place_ = 0;
#else
  void signal() {}
  void wait() {}
#endif
};

}  // namespace rbpa
