// Tables in text: a line is read and counted independently of the lines around it.
#include <doctest/doctest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

#include "io/cloud/read_points.h"
#include "io/failure.h"
#include "io/number.h"

using rbpa::Point;
using Columns = std::vector<rbpa::app::Column>;

namespace {

struct Table {
  std::string text = {};
  std::size_t lines = 0;
  std::vector<Point> points = {};
};

/// Lines of every kind that a table may have, with x and y in two of `width` columns.
class Tables {
 public:
  Tables(std::uint64_t seed, char separator, std::size_t width, std::size_t x, std::size_t y)
      : random_(seed), separator_(separator), width_(width), x_(x), y_(y) {}

  void add_line(Table& table) {
    if (below(8) == 0) {
      static constexpr const char* none[] = {"", "# 1 2", "  ", " \t# x", "\r"};
      table.text += none[below(5)];
    } else {
      const Point p = {number(), number()};
      table.points.push_back(p);
      add_blanks(table.text);
      for (std::size_t i = 0; i < width_; ++i) {
        if (i > 0) add_separator(table);
        add_field(table.text, i == x_ ? text_of(p.x) : i == y_ ? text_of(p.y) : other());
      }
      if (table.points.size() > 1) add_blanks(table.text);
      if (separator_ == ' ' && below(10) == 0) table.text += " # 7 \"8\"";
      if (below(5) == 0) table.text += '\r';
    }
    end_line(table);
  }
  void end_line(Table& table) {
    table.text += '\n';
    ++table.lines;
  }

 private:
  std::uint64_t below(std::uint64_t n) { return random_() % n; }

  double number() {
    const double value = (static_cast<double>(random_() >> 11U) * 0x1p-53 - 0.5) * 100;
    return below(4) == 0 ? static_cast<double>(static_cast<int>(value)) : value;
  }
  std::string text_of(double value) {
    std::string text = rbpa::app::text_of(value);
    if (value > 0 && below(10) == 0) text.insert(0, 1, '+');
    return text;
  }
  std::string other() {
    static constexpr const char* fields[] = {"7", "word", "1e", "-", "0x1F", "a'b", "1.5.2", "x\\y"};
    return fields[below(8)];
  }
  void add_field(std::string& text, const std::string& field) {
    const bool quoted = separator_ != ' ' && below(10) == 0;
    if (quoted) text += '"';
    text += field;
    if (quoted) text += '"';
  }
  void add_blanks(std::string& text) {
    if (below(6) == 0) text += below(2) == 0 ? " " : "\t ";
  }
  void add_separator(Table& table) {
    std::string& text = table.text;
    if (table.points.size() == 1) {
      text += separator_;  // the first line decides the separator: it contains no other
    } else if (separator_ == ' ') {
      text += below(4) == 0 ? "\t" : below(4) == 0 ? "   " : " ";
    } else {
      if (below(6) == 0) text += ' ';
      text += separator_;
      if (below(6) == 0) text += "  ";
    }
  }

  std::mt19937_64 random_;
  char separator_;
  std::size_t width_, x_, y_;
};

Columns columns(std::size_t x, std::size_t y) { return {{.number = x + 1}, {.number = y + 1}}; }

/// Calls check(tables, columns) for tables of every shape.
template <typename Check>
void for_each_shape(const Check& check) {
  for (const char separator : {' ', ',', ';', '\t'})
    for (const auto& shape : {std::array<std::size_t, 3>{2, 0, 1}, {2, 1, 0}, {3, 0, 1}, {4, 3, 1}, {3, 2, 0}})
      for (std::uint64_t seed = 0; seed < 20; ++seed) {
        CAPTURE(separator);
        CAPTURE(shape[0]);
        CAPTURE(seed);
        check(Tables(seed, separator, shape[0], shape[1], shape[2]), columns(shape[1], shape[2]));
      }
}

}  // namespace

TEST_SUITE("text tables") {
  TEST_CASE("every line of a table is a point, whatever the lines around it") {
    for_each_shape([](Tables tables, const Columns& columns) {
      Table table;
      for (int i = 0; i < 100; ++i) tables.add_line(table);
      CHECK(rbpa::app::points_in(table.text, "t", {.columns = columns}).points == table.points);
      while (!table.text.empty() && table.text.back() == '\n') table.text.pop_back();  // no end of the last line
      CHECK(rbpa::app::points_in(table.text, "t", {.columns = columns}).points == table.points);
    });
  }

  TEST_CASE("a bad line is named by its number, whatever the lines before it") {
    for_each_shape([](Tables tables, const Columns& columns) {
      Table table;
      while (table.points.size() < 50) tables.add_line(table);
      const std::string place = "t:" + std::to_string(table.lines + 1) + ": found ";
      table.text += "'a'";
      tables.end_line(table);
      for (int i = 0; i < 20; ++i) tables.add_line(table);
      std::string message;
      try {
        rbpa::app::points_in(table.text, "t", {.columns = columns});
      } catch (const rbpa::app::BadInput& error) {
        message = error.what();
      }
      CAPTURE(message);
      CHECK(message.substr(0, place.size()) == place);
    });
  }
}
