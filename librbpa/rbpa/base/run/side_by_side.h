// What: runs a few different tasks in several threads.
#pragma once

#include <cstddef>
#include <exception>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/run/checkpoint_of_threads.h"
#include "rbpa/base/run/steps.h"

namespace rbpa {

/// Calls each task(step, go_on) once, in any order and thread; the tasks may use `threads` as well. Any thread may call
/// the go_on of the tasks, which calls the given one, one call at a time. Rethrows the first exception of a task; the
/// other tasks end with it at their next call of go_on, unless the given one is empty.
template <typename... Tasks>
void side_by_side(Threads& threads, const GoOn& go_on, const Tasks&... tasks) {
  CheckpointOfThreads checkpoint(go_on);
  const GoOn goes_on = [&] { return checkpoint.goes_on(); };
  for_each_index(threads, sizeof...(tasks), [&](std::size_t task) {
    try {
      Steps step(goes_on);
      std::size_t i = 0;
      ((i++ == task ? tasks(step, goes_on) : void()), ...);
    } catch (...) {
      checkpoint.fail(std::current_exception());
      throw;
    }
  });
}

}  // namespace rbpa
