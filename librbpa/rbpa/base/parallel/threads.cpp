#include "rbpa/base/parallel/threads.h"

// Under the thread sanitizer, threads of the standard library share the work. oneTBB is not instrumented: the sanitizer
// does not see how oneTBB orders pieces of work, and would report false races.
#if defined(__SANITIZE_THREAD__)
#define RBPA_PLAIN_THREADS 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define RBPA_PLAIN_THREADS 1
#endif
#endif

#ifndef RBPA_SERIAL
#include <tbb/info.h>
#ifndef RBPA_PLAIN_THREADS
#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <mutex>
#include <vector>
#else
#include "rbpa/base/join_in_order.h"
#endif
#endif

namespace rbpa {

#ifdef RBPA_SERIAL
struct Threads::Arena {};

Threads::Threads(unsigned) : count_(1) {}
void Threads::share(std::size_t, Call<void(std::size_t)>) {}
void Threads::share_in_order(std::size_t, Call<std::shared_ptr<void>()>, Call<void(std::size_t, void*)>,
                             Call<void(std::size_t, void*)>, Call<void(std::size_t, void*)>) {}
#else
Threads::Threads(unsigned count) {
  const auto processors = static_cast<unsigned>(tbb::info::default_concurrency());
  count_ = count == 0 ? processors : std::min(count, processors);
}
#endif

#if defined(RBPA_PLAIN_THREADS) && !defined(RBPA_SERIAL)
struct Threads::Arena {};

void Threads::share(std::size_t number, Call<void(std::size_t)> visit) {
  SharedWork shared(number);
  shared.run(count_, [&] {
    for (std::size_t i = shared.take(); i < number; i = shared.take()) visit(i);
  });
}

void Threads::share_in_order(std::size_t number, Call<std::shared_ptr<void>()> make,
                             Call<void(std::size_t, void*)> work, Call<void(std::size_t, void*)> join,
                             Call<void(std::size_t, void*)> finish) {
  SharedWork shared(number);
  shared.run(count_, [&] {
    const std::shared_ptr<void> workspace = make();
    for (std::size_t i = shared.take(); i < number; i = shared.take()) {
      work(i, workspace.get());
      if (!shared.wait_for_turn(i)) return;
      join(i, workspace.get());
      shared.pass_on();
      finish(i, workspace.get());
    }
  });
}
#elif !defined(RBPA_SERIAL)
struct Threads::Arena : tbb::task_arena {
  using tbb::task_arena::task_arena;
};

void Threads::share(std::size_t number, Call<void(std::size_t)> visit) {
  if (!arena_) arena_ = std::make_unique<Arena>(static_cast<int>(count_));
  arena_->execute([&] { tbb::parallel_for(std::size_t{0}, number, [&](std::size_t i) { visit(i); }); });
}

void Threads::share_in_order(std::size_t number, Call<std::shared_ptr<void>()> make,
                             Call<void(std::size_t, void*)> work, Call<void(std::size_t, void*)> join,
                             Call<void(std::size_t, void*)> finish) {
  struct Item {
    std::shared_ptr<void> workspace;
    std::size_t number = 0;
  };
  std::vector<std::unique_ptr<Item> > items;
  std::vector<Item*> idle;
  std::mutex mutex;
  std::size_t next = 0;
  const auto take = [&](tbb::flow_control& control) -> Item* {
    if (next == number) {
      control.stop();
      return nullptr;
    }
    const std::lock_guard lock(mutex);
    if (idle.empty()) idle.push_back(items.emplace_back(std::make_unique<Item>(Item{make()})).get());
    Item* const item = idle.back();
    idle.pop_back();
    item->number = next++;
    return item;
  };
  const auto do_work = [&](Item* item) {
    work(item->number, item->workspace.get());
    return item;
  };
  const auto do_join = [&](Item* item) {
    join(item->number, item->workspace.get());
    return item;
  };
  const auto do_finish = [&](Item* item) {
    finish(item->number, item->workspace.get());
    const std::lock_guard lock(mutex);
    idle.push_back(item);
  };
  using tbb::filter_mode;
  if (!arena_) arena_ = std::make_unique<Arena>(static_cast<int>(count_));
  arena_->execute([&] {
    tbb::parallel_pipeline(3 * std::size_t{count_},
                           tbb::make_filter<void, Item*>(filter_mode::serial_in_order, take) &
                               tbb::make_filter<Item*, Item*>(filter_mode::parallel, do_work) &
                               tbb::make_filter<Item*, Item*>(filter_mode::serial_in_order, do_join) &
                               tbb::make_filter<Item*, void>(filter_mode::parallel, do_finish));
  });
}
#endif

Threads::Threads(Threads&&) noexcept = default;
Threads::~Threads() = default;

}  // namespace rbpa
