#include "rbpa/base/run/checkpoint_of_threads.h"

#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

#include "rbpa/base/error.h"

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
  CHECK(!other.goes_on());
  CHECK(calls == 4);

  const rbpa::GoOn none;
  CHECK(rbpa::CheckpointOfThreads(none).goes_on());
}

TEST_SUITE_END();
