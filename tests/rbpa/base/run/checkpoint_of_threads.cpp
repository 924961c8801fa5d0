#include "rbpa/base/run/checkpoint_of_threads.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <thread>

#include "rbpa/base/error.h"
#include "rbpa/base/run/side_by_side.h"

TEST_SUITE_BEGIN("run");

TEST_CASE("a checkpoint of several threads asks no more once the answer was false, or an exception") {
  int calls = 0;
  const rbpa::GoOn twice = [&] { return ++calls < 3; };
  rbpa::CheckpointOfThreads checkpoint(twice);
  CHECK(checkpoint.goes_on());
  CHECK_NOTHROW(checkpoint());
  CHECK(!checkpoint.goes_on());
  CHECK_THROWS_AS(checkpoint(), rbpa::Cancelled);
  CHECK(calls == 3);

  const rbpa::GoOn failing = [&]() -> bool { throw std::runtime_error(std::to_string(++calls)); };
  rbpa::CheckpointOfThreads other(failing);
  CHECK_THROWS_AS(other(), std::runtime_error);
  CHECK_THROWS_WITH(other.goes_on(), "4");
  CHECK_THROWS_WITH(other(), "4");
  CHECK(calls == 4);

  const rbpa::GoOn none;
  CHECK(rbpa::CheckpointOfThreads(none).goes_on());
}

TEST_CASE("tasks side by side end with the first exception, of a task or of the callback, which is not called again") {
  for (const unsigned count : {1u, 2u}) {
    CAPTURE(count);
    rbpa::Threads threads(count);
    std::atomic<std::size_t> begun = 0;
    const auto meet = [&] {  // waits until each thread has a task, but not for threads that never come
      ++begun;
      const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
      while (begun < threads.count() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    };
    for (int round = 0; round < 50; ++round) {
      begun = 0;
      std::atomic<int> calls = 0;
      const rbpa::GoOn failing = [&]() -> bool { return ++calls < 50 ? true : throw std::domain_error("callback"); };
      const auto ask = [&](rbpa::Steps&, const rbpa::GoOn& go_on) {
        meet();
        while (true) rbpa::stop_if_cancelled(go_on);
      };
      CHECK_THROWS_WITH(rbpa::side_by_side(threads, failing, ask, ask, ask), "callback");
      CHECK(calls == 50);
    }
    begun = 0;
    std::atomic<int> in_vain = 0;
    const rbpa::GoOn always = [] { return true; };
    const auto fail = [&](rbpa::Steps&, const rbpa::GoOn&) {
      meet();
      throw std::domain_error("task");
    };
    const auto wait = [&](rbpa::Steps&, const rbpa::GoOn& go_on) {
      meet();
      for (int i = 0; i < 10'000'000; ++i) rbpa::stop_if_cancelled(go_on);
      ++in_vain;
    };
    CHECK_THROWS_WITH(rbpa::side_by_side(threads, always, fail, wait), "task");
    CHECK(in_vain == 0);
  }
}

TEST_SUITE_END();
