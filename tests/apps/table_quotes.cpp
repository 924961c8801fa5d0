// Texts in quotes by RFC 4180, and separators of fields: in any column, at once, by pieces and compressed.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "io/cloud/point_blocks.h"
#include "io/cloud/read_points.h"
#include "io/failure.h"
#include "io/text/fields.h"
#include "support/gzip.h"
#include "support/program.h"
#include "support/refusal_of.h"

using namespace apps_test;
using rbpa::Point;
using namespace rbpa::app;

namespace {

using Points = std::vector<Point>;

PointFile read(const std::string& text, PointSource source = {}, const std::string& name = "t.csv") {
  return points_in(text, name, source);
}

std::string refusal(const std::string& text, const PointSource& source = {}, const std::string& name = "t.csv") {
  return rbpa_test::refusal_of<BadInput>([&] { read(text, source, name); });
}

/// Returns the groups that `--group-by name` finds.
std::vector<std::string> keys(const std::string& text) {
  const PointFile file = read(text, {.where = Condition::of_groups({.keys = "name"}, "", names_of_columns())});
  std::vector<std::string> found;
  for (const double number : file.fields.at(0)) found.push_back(file.texts.at(0)->at(static_cast<std::size_t>(number)));
  return found;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

const Points three = {{4.88, 52.37}, {4.9, 52.37}, {4.9, 52.38}};

/// Three lines with a text in one of three columns, all in quotes or the text alone.
std::string table(const std::vector<std::string>& names, char separator, std::size_t column, bool header, bool all,
                  const std::string& end = "\n", const std::string& trailing = "") {
  const std::vector<std::vector<std::string>> numbers = {{"4.880", "52.370"}, {"4.900", "52.370"}, {"4.900", "52.380"}};
  std::string text;
  const auto add = [&](const std::string& name, const std::string& x, const std::string& y) {
    std::vector<std::string> fields = {x, y};
    fields.insert(fields.begin() + static_cast<std::ptrdiff_t>(column), name);
    for (std::size_t i = 0; i < 3; ++i) text += (i == 0 ? "" : std::string(1, separator)) + fields[i];
  };
  const auto number = [&](const std::string& field) { return all ? quoted(field) : field; };
  if (header) {
    add(number("name"), number("lon"), number("lat"));
    text += trailing + end;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    add(quoted(names[i]), number(numbers[i][0]), number(numbers[i][1]));
    text += trailing + end;
  }
  return text;
}

const std::vector<std::vector<std::string>> texts = {{"a", "b", "c"},
                                                     {"Amsterdam, NL", "Utrecht", "X, NL"},
                                                     {"a;b", ";", "c"},
                                                     {"a\tb", "\t", "c"},
                                                     {"New York", "Los Angeles", " c "},
                                                     {"6\" pipe", "\"", "\"\""},
                                                     {"first line\nsecond, line", "a\n1,1,b", "\n"},
                                                     {"# no comment", "//", "c"},
                                                     {"a\n# no comment\n\n\nb", "sep=,", "1;2;3"},
                                                     {"1,5", "2,5", "3"},
                                                     {"\"a\",\"b\"\n\"4.8\"\",5\"", "", "c"}};

}  // namespace

TEST_SUITE("quotes and separators") {
  TEST_CASE("texts in quotes hold separators, quotes and line breaks, in any column") {
    for (const std::vector<std::string>& names : texts)
      for (const char separator : {',', ';', '\t', ' '})
        for (const std::size_t column : {0U, 1U, 2U})
          for (const bool all : {false, true})
            for (const bool hint : {false, true}) {
              if (hint && separator == ' ') continue;
              const std::string before = hint ? std::string("sep=") + separator + "\n" : "";
              const std::string text = before + table(names, separator, column, true, all);
              CAPTURE(text);
              CHECK(read(text).points == three);
              CHECK(keys(text) == names);
              const std::string compressed_lines = before + table(names, separator, column, true, all, "\r\n");
              CHECK(read(compressed_lines).points == three);
              const std::string bare = before + table(names, separator, column, false, all);
              const std::vector<Column> columns = {{.number = column == 0 ? 2U : 1U},
                                                   {.number = column == 2 ? 2U : 3U}};
              CHECK(read(bare, {.columns = columns}).points == three);
            }
  }

  TEST_CASE("a separator at the end of lines, of the header, or of both, is ignored") {
    for (const std::string trailing : {"", ",", ",,", ";", "\t"}) {
      const char separator = trailing.empty() ? ',' : trailing[0];
      for (const bool all : {false, true}) {
        const std::string with = table(texts[1], separator, 0, true, all, "\n", trailing);
        const std::string without = table(texts[1], separator, 0, true, all);
        const auto lines = [](const std::string& text) { return text.substr(text.find('\n') + 1); };
        const auto header = [](const std::string& text) { return text.substr(0, text.find('\n') + 1); };
        for (const std::string& text : {with, header(with) + lines(without), header(without) + lines(with)}) {
          CAPTURE(text);
          CHECK(read(text).points == three);
        }
      }
    }
    CHECK(read("1 2 \n3 4 \n").points == Points{{1, 2}, {3, 4}});
    CHECK(read("x,y,name,\n1,2,a,\n3,4,b\n5,1,,\n").points == Points{{1, 2}, {3, 4}, {5, 1}});
    CHECK(read("x\ty\tname\n1\t2\t\n3\t4\tb\n").points == Points{{1, 2}, {3, 4}});
    CHECK(read("\tx\ty\n0\t1\t2\n1\t3\t4\n").points == Points{{1, 2}, {3, 4}});
    // Missing and extra fields do not change the separator.
    CHECK(refusal("x,y,name\n1,2\n") == "t.csv:2: found 2 columns ('1,2'), expected 3 as in line 1");
    CHECK(refusal("x,y,name\n1,2,a,b\n") == "t.csv:2: found 4 columns ('1,2,a,b'), expected 3 as in line 1");
    CHECK(refusal("x,y,name,\n1.5\n3,4,5,6\n") ==
          "t.csv:2: found 1 column ('1.5'), expected 4 as in line 1" + skipping_hint);
  }

  TEST_CASE("a comma in texts of the first lines does not decide the separator, in quotes or not") {
    for (const char separator : {';', '\t'}) {
      const std::string s(1, separator);
      const std::string lines = "Amsterdam, NL" + s + "4.880" + s + "52.370\nUtrecht, NL" + s + "4.900" + s +
                                "52.370\nX, NL" + s + "4.900" + s + "52.380\n";
      CHECK(read("name" + s + "lon" + s + "lat\n" + lines).points == three);
      CHECK(read("sep=" + s + "\nname" + s + "lon" + s + "lat\n" + lines).points == three);
      CHECK(read(lines, {.columns = parse_columns("2,3")}).points == three);
      CHECK(read(lines, {.columns = parse_columns("2,3")}, "t.tsv").points == three);
    }
    CHECK(read("Height (m, NAP);lon;lat\n1;4,880;52,370\n2;4,900;52,370\n3;4,9;52,38\n").points == three);
    CHECK(read("station name,lon,lat\nNew York,4.880,52.370\nRome,4.900,52.370\na b c,4.9,52.38\n").points == three);
    CHECK(read("\"sep=;\"\n4,88;52,37\n4,9;52,37\n4,9;52,38\n").points == three);
    CHECK(read("sep=\t\nlon\tlat\n4.88\t52.37\n4.9\t52.37\n4.9\t52.38\n").points == three);
  }

  TEST_CASE("a quote that does not end is refused by its line, or left out alone") {
    const std::string what = "found a text in quotes that does not end, expected a closing quote",
                      way = what + skipping_hint;
    CHECK(refusal("x,y,name\n1,2,\"a\n3,4,b\n5,6,c\n") == "t.csv:2: " + way);
    CHECK(refusal("x,y,name\n1,2,\"a\n3,4,\"b\"\n5,6,c\n") == "t.csv:2: " + way);
    CHECK(read("x,y,name\n1,2,\"a\n3,4,b\n5,6,c\n", {.skip_invalid = true}).points == Points{{3, 4}, {5, 6}});
    CHECK(read("x,y,name\n1,2,6\" pipe\n3,4,b\"\n").points == Points{{1, 2}, {3, 4}});  // no text in quotes
    // No text is longer than a mebibyte, in a file as in memory.
    const std::string far = "x,y,name\n1,2,\"" + std::string(std::size_t{3} << 20U, '\n') + "\"\n3,4,b\n";
    CHECK(refusal(far) == "t.csv:2: " + what);
    const Folder folder;
    const PointSource source{.path = folder.file("far.csv", far), .skip_invalid = true};
    std::vector<Point> block;
    const auto blocks = open_point_blocks(source);
    REQUIRE(blocks->next(block));
    CHECK(block == read(far, {.skip_invalid = true}).points);
  }

  TEST_CASE("lines after a text of several lines have their own numbers") {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
      const std::string text = "name,x,y" + end + "\"a" + end + end + "b\",1,2" + end + "c,3,z" + end;
      CHECK(refusal(text) == "t.csv:5: found 'z', expected a number" + skipping_hint);
      CHECK(refusal("name,x,y" + end + "\"a" + end + "b\",1,z" + end).starts_with("t.csv:2: found 'z'"));
    }
  }

  TEST_CASE("pieces of a file end anywhere: in texts, in CRLF, between quotes") {
    const Folder folder;
    const std::string record = "\"a \"\"b\"\",\r\n# c\r\n1,1,\"\"\",4.5,5.5\r\nd,1,2\r\n\"\",3,4\r";
    const std::string filler = "name,1,2\n";
    const std::size_t piece = std::size_t{1} << 20U;
    for (std::size_t shift = 0; shift <= record.size() + 2; ++shift) {
      // The piece ends `shift` bytes after the beginning of the record.
      std::string text = "name,x,y\n";
      while (text.size() + 2 * filler.size() < piece - shift) text += filler;
      text += std::string(piece - shift - text.size() - 4, 'n') + ",1,2";
      text.replace(text.size() - 4, 4, "");
      text.resize(piece - shift - 5);
      text += ",1,2\n" + record + record;
      REQUIRE(text.size() == piece - shift + 2 * record.size());
      for (int i = 0; i < 40000; ++i) text += filler;
      const PointSource source{.path = folder.file("p.csv", text),
                               .where = Condition("", names_of_columns(), {{.name = "x"}})};
      const PointFile whole = read_points(source);
      const auto blocks = open_point_blocks(source);
      Points points, block;
      while (blocks->next(block)) points.insert(points.end(), block.begin(), block.end());
      CAPTURE(shift);
      CHECK(points == whole.points);
      CHECK(std::count(points.begin(), points.end(), Point{4.5, 5.5}) == 2);
      CHECK(std::count(points.begin(), points.end(), Point{3, 4}) == 2);
      CHECK(std::count(points.begin(), points.end(), Point{1, 1}) == 0);
    }
  }

  TEST_CASE("pieces of a file end anywhere where lines end in CR alone") {
    const Folder folder;
    for (std::size_t shift = 0; shift < 12; ++shift) {
      std::string text = std::string(shift, '#') + "\r";
      for (std::size_t i = 0; text.size() < (std::size_t{3} << 20U); ++i)
        text += std::to_string(i) + ",7" + (i % 3 == 0 ? "\r\n" : "\r");
      const PointSource source{.path = folder.file("p.csv", text)};
      const PointFile whole = read_points(source);
      CHECK(whole.points.back().x == static_cast<double>(whole.points.size() - 1));
      for (const std::string& path : {source.path, folder.file("p.csv.gz", compressed(text))}) {
        const auto blocks = open_point_blocks({.path = path});
        Points points, block;
        while (blocks->next(block)) points.insert(points.end(), block.begin(), block.end());
        CHECK(points == whole.points);
      }
    }
  }

  TEST_CASE("groups and conditions see texts without quotes") {
    const Folder folder(
        "g.csv", "g,lon,lat\n\"6\"\" pipe\",4.880,52.370\n\"6\"\" pipe\",4.900,52.370\n\"6\"\" pipe\",4.9,52.38\n");
    REQUIRE(folder.rbpa("shape g.csv --group-by g --alpha inf -o g.geojson").code == 0);
    CHECK(contains(folder.content("g.geojson"), "\"group\":\"6\\\" pipe\""));
    CHECK(folder.rbpa("info g.csv --where \"g == '6\\\" pipe'\"").out.starts_with("points      3\n"));
    CHECK(folder.rbpa("info - < g.csv").out == folder.rbpa("info g.csv").out);
    // A header in quotes is recognized by its text.
    CHECK(keys("lon,lat,\"name\"\n1,2,\"a\"\n") == std::vector<std::string>{"a"});
    CHECK(read("\"the \"\"x\"\"\",b\n1,2\n", {.columns = std::vector<Column>{{.name = "the \"x\""}, {.name = "b"}}})
              .points == Points{{1, 2}});
  }
}
