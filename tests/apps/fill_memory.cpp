// `rbpa fill` under a limit of memory: a too large filling is refused before the first triangle.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/resource.h>

#include <string>

#include "support/child.h"
#include "support/program.h"

using namespace apps_test;

// The shadow memory of a sanitizer exceeds any limit.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {

constexpr rlim_t limit = rlim_t{400} << 20U;

/// Fills a unit square in a limited address space.
Ending fill_limited(const Folder& folder, const std::string& options) {
  folder.file("square.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n");
  folder.file("sizes", "0.5 0.5 1e-9\n");
  const std::string command =
      RBPA_PROGRAM " fill " + folder.path("square.wkt") + " " + options + " -o " + folder.path("out.off");
  Child child({"/bin/sh", "-c", "exec " + command}, [&] {
    const rlimit both{limit, limit};
    setrlimit(RLIMIT_AS, &both);
    redirect(2, folder.path("err"), O_WRONLY | O_CREAT | O_TRUNC);
  });
  return child.wait();
}

}  // namespace

TEST_CASE(
    "a filling for which memory does not suffice is refused before it starts, with the estimate and the memory "
    "available") {
  const Folder folder;
  // About 2.3 million triangles; and small sizes because of a single point.
  for (const std::string& options :
       {std::string("--size 0.001"), "--size 1 --size-at " + folder.path("sizes") + " --grade 0.001"}) {
    CAPTURE(options);
    CHECK(fill_limited(folder, options) == Ending{.code = 3});
    const std::string said = folder.content("err");
    CHECK(contains(said, "square.wkt: found"));
    CHECK(contains(said, "triangles would be made"));
    CHECK(contains(said, "expected"));
    CHECK_FALSE(folder.has("out.off"));
  }
}

TEST_CASE("a filling for which memory suffices is made under the same limit") {
  const Folder folder;
  CHECK(fill_limited(folder, "--size 0.05") == Ending{.code = 0});
  CHECK(folder.has("out.off"));
}

#endif
