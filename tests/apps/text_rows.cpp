// A reader of a format that no program writes, as docs/how_to/add_a_file_format.md has it: rows of numbers in a text.
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "io/cloud/element_cloud.h"
#include "io/failure.h"
#include "io/number.h"
#include "io/text/lines.h"

using namespace rbpa::app;

namespace {

// "STA 2", then lines x y z quality.
std::unique_ptr<Cloud> open_sta(Content content, const CloudRequest& request) {
  Lines lines(content.ahead());
  std::string_view rest = lines.next_with_content() ? lines.line() : std::string_view();
  const std::string_view word = take_word(rest);
  const std::optional<std::size_t> count = parse_count(take_word(rest));
  if (word != "STA" || !count)
    bad_input(at_line(content.name(), lines.number()), in_quotes(lines.line()), "STA and the number of points");
  PlyElement point{.name = "point", .noun = "point", .count = *count, .line = lines.number()};
  for (const char* field : {"x", "y", "z", "quality"}) point.properties.push_back({field, Scalar::float64});
  PointLayout layout;
  for (std::size_t k = 0; k < (request.in_space ? 3 : 2); ++k) layout.columns.emplace_back(k, k);
  if (!request.in_space) layout.height = 2;
  PlyHeader header{.elements = {std::move(point)}, .lines = lines.number(), .data = lines.rest()};
  return open_elements(std::move(content), std::move(header), std::move(layout), request);
}
const CloudFormat sta_reader = {.open = open_sta, .fields = names_of_properties, .skips_invalid = true};

}  // namespace

TEST_SUITE("text rows") {
  TEST_CASE("the reader of the page on file formats reads points, fields and heights, and refuses what it should") {
    const auto read = [](const std::string& text, const CloudRequest& request) {
      const auto cloud = sta_reader.open(Content(text, "p"), request);
      std::vector<double> numbers;
      for (CloudBlock block; cloud->next(block);)
        for (std::size_t i = 0; i < block.count; ++i)
          for (std::size_t k = 0; k < (request.in_space ? 3 : 2); ++k) numbers.push_back(block.column[k][i]);
      cloud->finish();
      return std::pair(numbers, cloud->facts().file.heights.differ());
    };
    const std::string two = "STA 2\n1 2 3 .5\n4 5 6 .75\n";
    CHECK(read(two, {}) == std::pair(std::vector<double>{1, 2, 4, 5}, true));
    CHECK(read(two, {.in_space = true}) == std::pair(std::vector<double>{1, 2, 3, 4, 5, 6}, false));
    const Condition good("quality > 0.6", sta_reader.fields());
    CHECK(read(two, {.where = good}).first == std::vector<double>{4, 5});
    for (const auto& [text, message] :
         {std::pair<std::string, std::string>{"STB 2\n", "p:1: found 'STB 2', expected STA and the number of points"},
          {"STA 3\n1 2 3 .5\n", "p: found 9 bytes of data, expected 3 points as line 1 says"},
          {"STA 1\n1 2 3 .5\n4 5 6 .75\n",
           "p:3: found '4 5 6 .75', expected the end of the file after 1 point as line 1 says"},
          {"STA 1\n1 2 x .5\n", ""}})
      CHECK_THROWS_WITH_AS(read(text, {.in_space = true}),
                           message.empty() ? "p:2: found 'x', expected a number" : message.c_str(), BadInput);
  }
}
