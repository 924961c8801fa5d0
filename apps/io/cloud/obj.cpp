#include "io/cloud/obj.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <utility>

#include "io/bytes/number.h"
#include "io/cloud/colors.h"
#include "io/failure.h"
#include "io/text/vertex_lines.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

std::string_view take_obj_line(Lines& lines, std::string& room) {
  std::string_view line = lines.line();
  if (!line.empty() && line.back() == '\\') {
    room.clear();
    while (!line.empty() && line.back() == '\\') {
      room += line.substr(0, line.size() - 1);
      room += ' ';
      line = lines.next() ? lines.line() : std::string_view();
    }
    room += line;
    line = room;
  }
  return line.substr(0, line.find('#'));
}

void require_end_of_vertex(std::string_view rest, const std::string& name, std::size_t line) {
  constexpr std::size_t most = 5;  // a weight; red, green, blue, opacity
  std::size_t numbers = 0;
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest))
    if (++numbers > most || parse_whole_number(word).fault == NumberFault::not_a_number)
      bad_input(at_line(name, line), in_quotes(word) + " after a vertex",
                "at most " + std::to_string(most) + " numbers, a weight and a color, and one vertex a line");
}

std::uint32_t take_obj_number(std::string_view word, std::string_view text, std::string_view noun, std::size_t before,
                              const std::string& name, std::size_t line) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto last = static_cast<std::int64_t>(before);
  if (error != std::errc() || end != text.data() + text.size() || number == 0 || number < -last ||
      number > std::int64_t{UINT32_MAX})
    bad_input(at_line(name, line), in_quotes(word),
              "a " + std::string(noun) + " number from 1" +
                  (before == 0 ? "" : ", or from -1 to -" + std::to_string(before)));
  return static_cast<std::uint32_t>(number > 0 ? number - 1 : last + number);
}

namespace {

/// Reads all points as one block, since the faces after the points assign the normals.
class ObjCloud final : public Cloud {
 public:
  ObjCloud(Content content, const CloudRequest& /*request*/)
      : content_(std::move(content)), lines_(content_.ahead()), name_(content_.name()) {
    facts_.colors = Channels::bytes;
  }

  bool next(CloudBlock& block) override {
    block = {};
    if (is_read_) return false;
    is_read_ = true;
    for_each_obj_line(lines_, [&](std::string_view word, std::string_view rest, std::size_t line) {
      if (word == "v") {
        const auto position = take_position(rest, lines_, name_);
        require_end_of_vertex(rest, name_, line);
        for (std::size_t k = 0; k < 3; ++k) block.column[k].push_back(position[k]);
        ++block.count;
        colors_.take(rest, line, block);
      }
      if (word == "vn") {
        normals_.push_back(take_point(rest));
        if (!trimmed(rest).empty())
          bad_input(at_line(name_, line), in_quotes(trimmed(rest)) + " after a normal", "one normal a line");
      }
      if (word == "f") take_face(rest, block.count, line);
    });
    if (block.count == 0) bad_input(name_, "no line 'v x y z'", "points");
    if (!normals_.empty()) settle_normals(block);
    colors_.settle(false, facts_);
    return true;
  }

 private:
  static constexpr std::uint32_t none = ~0U;

  /// A corner of a face with a normal.
  struct Corner {
    std::uint32_t vertex, normal;
    std::size_t line;
  };

  Point3 take_point(std::string_view& rest) {
    const auto [x, y, z] = take_position(rest, lines_, name_);
    return {x, y, z};
  }

  /// Reads the corners of a face: v and vn of v//vn or v/vt/vn.
  void take_face(std::string_view rest, std::size_t points, std::size_t line) {
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
      if (word.front() != '-' && std::isdigit(static_cast<unsigned char>(word.front())) == 0)
        bad_input(at_line(name_, line), in_quotes(word) + " in a face", "numbers of vertices, and one face a line");
      const std::size_t first = word.find('/'), second = word.find('/', std::min(first, word.size() - 1) + 1);
      if (second == std::string_view::npos) continue;
      corners_.push_back({take_obj_number(word, word.substr(0, first), "vertex", points, name_, line),
                          take_obj_number(word, word.substr(second + 1), "normal", normals_.size(), name_, line),
                          line});
    }
  }

  void require_known(const Corner& corner, std::uint32_t index, std::size_t count, const std::string& noun) const {
    if (index >= count)
      bad_input(at_line(name_, corner.line), in_quotes(std::to_string(std::uint64_t{index} + 1)),
                "a " + noun + " number from 1 to " + std::to_string(count));
  }

  /// Gives every vertex its normal, or no vertex a normal and a warning.
  void settle_normals(CloudBlock& block) {
    if (corners_.empty()) {
      if (normals_.size() == block.count)
        for (const Point3& normal : normals_) append(normal, block);
      else
        leave_out(counted(normals_.size(), "normal") + " for " + std::to_string(block.count) +
                  " vertices, and no face says which belongs to which");
      return;
    }
    std::vector<std::uint32_t> normal_of(block.count, none);
    for (const Corner& corner : corners_) {
      require_known(corner, corner.vertex, block.count, "vertex");
      require_known(corner, corner.normal, normals_.size(), "normal");
      std::uint32_t& normal = normal_of[corner.vertex];
      if (normal != none && normals_[normal] != normals_[corner.normal])
        return leave_out("vertex " + std::to_string(std::uint64_t{corner.vertex} + 1) +
                         " has different normals in the faces around it, line " + std::to_string(corner.line));
      normal = corner.normal;
    }
    const auto without = std::find(normal_of.begin(), normal_of.end(), none);
    if (without != normal_of.end())
      return leave_out("no face gives a normal to vertex " + std::to_string(without - normal_of.begin() + 1));
    for (const std::uint32_t normal : normal_of) append(normals_[normal], block);
  }

  void append(const Point3& normal, CloudBlock& block) {
    facts_.normals = true;
    const double part[] = {normal.x, normal.y, normal.z};
    for (std::size_t k = 0; k < 3; ++k) block.column[CloudBlock::normal + k].push_back(part[k]);
  }

  void leave_out(const std::string& reason) { facts_.file.warnings.push_back("normals are left out: " + reason); }

  Content content_;
  Lines lines_;
  const std::string& name_;
  std::vector<Point3> normals_ = {};  ///< in the order of their lines
  std::vector<Corner> corners_ = {};
  TextColors colors_ = TextColors();
  bool is_read_ = false;
};

}  // namespace

/// Reads the lines "v" of OBJ, with colors if they have six numbers or more, and "vn". A vertex has the normal that the
/// corners of faces give it. If faces name no normals, and there are equally many vertices and normals, they belong
/// together in their order. If neither gives every vertex a normal, there are none.
const CloudFormat obj_reader = {.open = open_as<ObjCloud>, .is_text = true};

}  // namespace rbpa::app
