// What: runs work in several threads.
// Law:  the result depends on how work is divided, never on the number or the speed of threads.
// Note: with RBPA_SERIAL there is one thread, and oneTBB is not needed.
// Why:  only threads.cpp includes oneTBB, whose headers take longer to compile than most callers of this class.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace rbpa {

/// A group of threads that share work, the calling thread included.
class Threads {
 public:
  /// Allows `count` threads, but not more than there are processors; with 0, one for each processor.
  explicit Threads(unsigned count = 1);
  Threads(Threads&&) noexcept;
  ~Threads();

  std::size_t count() const { return count_; }

  /// A reference to a function or lambda, valid as long as the referenced object.
  template <typename Signature>
  class Call;
  template <typename Result, typename... Arguments>
  class Call<Result(Arguments...)> {
   public:
    template <typename Function>
    // NOLINTNEXTLINE(google-explicit-constructor, bugprone-forwarding-reference-overload): a lambda is passed, no Call
    Call(Function&& function) requires(!std::is_same_v<std::remove_cvref_t<Function>, Call>)
        : function_(&function), call_([](const void* f, Arguments... arguments) -> Result {
            using Called = std::remove_reference_t<Function>;
            return (*static_cast<Called*>(const_cast<void*>(f)))(arguments...);
          }) {}
    Result operator()(Arguments... arguments) const { return call_(function_, arguments...); }

   private:
    const void* function_;
    Result (*call_)(const void*, Arguments...);
  };

  /// Calls visit(i) for each i below `number`, in any order and thread. Rethrows an exception of a call.
  void share(std::size_t number, Call<void(std::size_t)> visit);
  /// Calls work(i, workspace), join(i, workspace) and finish(i, workspace) as in_order() does (in_order.h), on
  /// workspaces that make() returns.
  void share_in_order(std::size_t number, Call<std::shared_ptr<void>()> make, Call<void(std::size_t, void*)> work,
                      Call<void(std::size_t, void*)> join, Call<void(std::size_t, void*)> finish);

 private:
  struct Arena;
  unsigned count_;
  std::unique_ptr<Arena> arena_;  // null until several threads are first needed
};

/// Calls visit(i) for each i below `count`, in any order and thread. Rethrows an exception of a call.
template <typename Visit>
void for_each_index(Threads& threads, std::size_t count, Visit visit) {
  if (threads.count() > 1 && count > 1) return threads.share(count, visit);
  for (std::size_t i = 0; i < count; ++i) visit(i);
}

/// Splits 0 … size − 1 into ranges of `part` ≥ 1 numbers (the last may be shorter). Calls visit(first, last) for each,
/// `last` excluded, in any order and thread. Rethrows an exception of a call.
template <typename Visit>
void for_each_part(Threads& threads, std::size_t size, std::size_t part, Visit visit) {
  for_each_index(threads, (size + part - 1) / part,
                 [&](std::size_t i) { visit(i * part, std::min(i * part + part, size)); });
}

}  // namespace rbpa
