#include "io/cloud/off.h"

#include <algorithm>
#include <utility>

#include "io/bytes/number.h"
#include "io/bytes/unpack_limit.h"
#include "io/cloud/colors.h"
#include "io/cloud/readers.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/text/vertex_lines.h"

namespace rbpa::app {
namespace {

/// Whether a word is OFF with the prefixes of a three-dimensional ASCII file, and which of them.
struct Keyword {
  explicit Keyword(std::string_view word) {
    for (const std::string_view prefix : {"ST", "C", "N"}) {
      if (word.substr(0, prefix.size()) != prefix) continue;
      word.remove_prefix(prefix.size());
      normals = normals || prefix == "N";
      colors = colors || prefix == "C";
    }
    known = word == "OFF";
  }
  bool known = false, normals = false, colors = false;
};

}  // namespace

OffHeader read_off_header(std::string_view text, std::size_t size, const std::string& name) {
  Lines lines(text);
  if (!lines.next_with_content()) bad_input(name, "no OFF header", "an ASCII .off file");
  std::string_view rest = lines.line();
  std::string_view after_word = rest;
  const std::string_view word = take_word(after_word);
  const Keyword keyword(word);
  if (keyword.known) {
    rest = trimmed(after_word);
    if (rest.substr(0, 6) == "BINARY") bad_input(at_line(name, lines.number()), "binary OFF", "ASCII OFF");
    if (rest.empty() || rest.front() == '#') rest = lines.next_with_content() ? lines.line() : std::string_view();
  } else if (parse_whole_number(word).fault != NumberFault::none) {
    bad_input(at_line(name, lines.number()), in_quotes(word), "OFF, COFF, NOFF or CNOFF");
  }
  const std::string_view counts = rest;
  const std::optional<std::size_t> vertices = parse_count(take_word(rest));
  if (!vertices)
    bad_input(at_line(name, lines.number()), in_quotes(counts), "the numbers of vertices, faces and edges");
  const OffHeader header{.normals = keyword.known && keyword.normals,
                         .colors = keyword.known && keyword.colors,
                         .vertices = *vertices,
                         .line = lines.number(),
                         .counts = rest,
                         .lines = lines};
  const std::size_t left = size - (text.size() - lines.rest().size());
  // The shortest vertex line is "0 0" and its end, but for the last.
  if (*vertices > (left + 1) / 4)
    bad_input(name, counted(left, "byte") + " of data", announced(header, *vertices, "vertex line"));
  return header;
}

double claimed_off_size(std::string_view first, const std::string& name) {
  const OffHeader header = read_off_header(first, unknown_size, name);
  std::string_view counts = header.counts;
  const std::size_t faces = parse_count(take_word(counts)).value_or(0);
  return end_of_lines(first, header.lines, static_cast<double>(header.vertices) + static_cast<double>(faces));
}

std::string announced(const OffHeader& header, std::size_t count, std::string_view noun) {
  return counted(count, noun) + " as line " + std::to_string(header.line) + " says";
}

namespace {

class OffCloud final : public Cloud {
 public:
  OffCloud(Content content, const CloudRequest& request)
      : content_(std::move(content)),
        header_(read_off_header(content_.ahead(), content_.ahead().size(), content_.name())),
        lines_(header_.lines),
        in_space_(request.in_space) {
    facts_.expected = header_.vertices;
    facts_.normals = in_space_ && header_.normals;
    if (in_space_ && header_.colors) facts_.colors = Channels::bytes;
  }

  bool next(CloudBlock& block) override {
    stop_if_interrupted();
    const std::size_t numbers = !in_space_ ? 2 : facts_.normals ? 6 : 3;
    block.count = std::min(points_at_once, header_.vertices - first_);
    for (std::size_t k = 0; k < numbers; ++k) block.column[k].resize(block.count);
    clear_colors(block);
    double* target[CloudBlock::color] = {};
    for (std::size_t k = 0; k < numbers; ++k) target[k] = block.column[k].data();
    const std::string& name = content_.name();
    for (std::size_t i = 0; i < block.count; ++i) {
      if (!lines_.next_with_content())
        bad_input(content_.name(), counted(first_ + i, "vertex line"),
                  announced(header_, header_.vertices, "vertex line"));
      std::string_view rest = lines_.line();
      for (std::size_t k = 0; k < numbers; ++k) target[k][i] = take_coordinate(rest, lines_, name);
      if (facts_.colors) colors_.take(rest.substr(0, rest.find('#')), lines_.number(), block);
      if (!in_space_ && !facts_.file.heights.differ()) take_height(rest);
    }
    first_ += block.count;
    if (block.count == 0 && facts_.colors) colors_.settle(header_.vertices > 0, facts_);
    return block.count > 0;
  }

 private:
  void take_height(std::string_view rest) {
    const ParsedNumber z = parse_whole_number(take_word(rest));
    if (z.fault == NumberFault::none) facts_.file.heights.take(z.value);
  }

  Content content_;
  OffHeader header_;
  Lines lines_;
  bool in_space_;
  TextColors colors_ = TextColors();
  std::size_t first_ = 0;
};

}  // namespace

std::unique_ptr<Cloud> open_off(Content content, const CloudRequest& request) {
  return std::make_unique<OffCloud>(std::move(content), request);
}

}  // namespace rbpa::app
