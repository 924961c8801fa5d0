// Triangles come out in lexicographic order, also if few of them fit into memory.
#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "io/failure.h"
#include "stream/scratch_file.h"
#include "stream/triangle_rows.h"
#include "support/program.h"
#include "support/random.h"

using namespace rbpa::app;

namespace {

/// Returns rows with indices below `points`; a tenth of them begin with the same index.
void check(std::uint64_t points, std::uint64_t file_bytes) {
  CAPTURE(points);
  CAPTURE(file_bytes);
  rbpa_test::Random random(2);
  std::vector<TriangleRow> rows;
  for (int i = 0; i < 30'000; ++i) {
    TriangleRow row = {i % 10 == 0 ? 5 : random.below(points - 2), random.below(points), random.below(points)};
    std::rotate(row.begin(), std::min_element(row.begin(), row.end()), row.end());
    rows.push_back(row);
  }
  const apps_test::Folder folder;
  StreamRequest request;
  request.scratch = folder.path("s");
  const Scratch scratch(request);
  RowsState state;
  {
    TriangleRows files(scratch, points, file_bytes);
    files.add(std::span(rows).first(11'111));
    state = files.flush();
    files.add(rows);  // and killed
    files.flush();
  }
  TriangleRows files(scratch, points, file_bytes);
  files.resume(state);
  files.add(std::span(rows).subspan(11'111));
  CHECK(files.flush().total() == rows.size());
  CHECK(files.are_short() == (points <= 0xffffffffU));

  std::sort(rows.begin(), rows.end());
  std::string expected;
  for (const TriangleRow& row : rows)
    for (const std::uint64_t index : row)
      expected.append(reinterpret_cast<const char*>(&index), files.are_short() ? 4 : 8);
  for (const std::uint64_t memory : {1000U, 100'000U, 100'000'000U}) {
    std::string found;
    files.sorted(memory, [&](std::string_view bytes) { found += bytes; });
    CHECK(found == expected);
  }

  std::string bytes = folder.content("s/triangles/000000");
  bytes[bytes.size() / 2] = char(bytes[bytes.size() / 2] ^ 2);
  replace_content(scratch.rows(0), bytes);
  CHECK_THROWS_AS(files.sorted(100'000, [](std::string_view) {}), BadInput);
}

}  // namespace

TEST_CASE("rows of four and of eight bytes are sorted, in one file and in many, after any stop") {
  check(1000, 1'000'000);
  check(100'000, 300'000);
  check(5'000'000'000, 100'000'000'000);
}
