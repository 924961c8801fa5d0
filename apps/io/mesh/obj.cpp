// What: reads points and meshes of Wavefront OBJ files.
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <utility>

#include "io/cloud/colors.h"
#include "io/failure.h"
#include "io/mesh/read_mesh.h"
#include "io/number.h"
#include "io/text/vertex_lines.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {
namespace {

/// Reads the lines of a file, and numbers in them. Members throw BadInput that names the line.
class ObjLines {
 public:
  ObjLines(std::string_view text, const std::string& name) : lines_(text), name_(name) {}

  /// Calls visit(word, rest, line) for each line with content: its first word, the rest, and its number, which is that
  /// of the first line if several are joined.
  template <typename Visit>
  void for_each(const Visit& visit) {
    std::string room;
    while (lines_.next_with_content()) {
      const std::size_t line = lines_.number();
      std::string_view rest = take_line(room);
      const std::string_view word = take_word(rest);
      visit(word, rest, line);
    }
  }

  std::array<double, 3> take_three(std::string_view& rest) const { return take_position(rest, lines_, name_); }

  /// Takes the coordinates of a vertex from `rest`. Throws BadInput unless what follows is nothing, a weight, a color
  /// or both; two vertices in one line are refused.
  std::array<double, 3> take_vertex(std::string_view& rest, std::size_t line) const {
    constexpr std::size_t most = 5;  // a weight; red, green, blue, opacity
    const std::array<double, 3> position = take_three(rest);
    std::string_view behind = rest;
    std::size_t numbers = 0;
    for (std::string_view word = take_word(behind); !word.empty(); word = take_word(behind))
      if (++numbers > most || parse_whole_number(word).fault == NumberFault::not_a_number)
        refuse(line, in_quotes(word) + " after a vertex",
               "at most " + std::to_string(most) + " numbers after z, a weight and a color (one vertex a line)");
    return position;
  }

  /// Returns the index, from 0, for which `text`, a part of the corner `word`, stands. Positive numbers count from 1;
  /// negative ones count back: −1 is the last of the `before` items before line `line`. Messages call an item `noun`.
  /// The item of a positive number may follow later in the file.
  std::uint32_t index_of(std::string_view word, std::string_view text, std::string_view noun, std::size_t before,
                         std::size_t line) const {
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const auto last = static_cast<std::int64_t>(before);
    if (error != std::errc() || end != text.data() + text.size() || number == 0 || number < -last ||
        number > std::int64_t{UINT32_MAX})
      refuse(line, in_quotes(word),
             "a " + std::string(noun) + " number from 1" +
                 (before == 0 ? "" : ", or from -1 to -" + std::to_string(before)));
    return static_cast<std::uint32_t>(number > 0 ? number - 1 : last + number);
  }

  /// Throws BadInput if `index` is not below `count`, the number of all items in the file.
  void require_known(std::uint32_t index, std::size_t count, const std::string& noun, std::size_t line) const {
    if (index >= count)
      refuse(line, in_quotes(std::to_string(std::uint64_t{index} + 1)),
             "a " + noun + " number from 1 to " + std::to_string(count));
  }

  [[noreturn]] void refuse(std::size_t line, const std::string& found, const std::string& expected) const {
    bad_input(at_line(name_, line), found, expected);
  }
  [[noreturn]] void refuse_without_vertices(const std::string& expected) const {
    bad_input(name_, "no line 'v x y z'", expected);
  }

 private:
  /// Returns the current line without a comment at its end; if other lines continue it, they are joined in `room`.
  std::string_view take_line(std::string& room) {
    std::string_view line = lines_.line();
    if (!line.empty() && line.back() == '\\') {
      room.clear();
      while (!line.empty() && line.back() == '\\') {
        room += line.substr(0, line.size() - 1);
        room += ' ';
        line = lines_.next() ? lines_.line() : std::string_view();
      }
      room += line;
      line = room;
    }
    return line.substr(0, line.find('#'));
  }

  Lines lines_;
  const std::string& name_;
};

/// Reads all points as one block, as faces, which follow the points, assign the normals.
class ObjCloud final : public Cloud {
 public:
  ObjCloud(Content content, const CloudRequest& /*request*/)
      : content_(std::move(content)), lines_(content_.ahead(), content_.name()) {
    facts_.colors = Channels::bytes;
  }

  bool next(CloudBlock& block) override {
    block = {};
    if (is_read_) return false;
    is_read_ = true;
    lines_.for_each([&](std::string_view word, std::string_view rest, std::size_t line) {
      if (word == "v") {
        const auto position = lines_.take_vertex(rest, line);
        for (std::size_t k = 0; k < 3; ++k) block.column[k].push_back(position[k]);
        ++block.count;
        colors_.take(rest, line, block);
      }
      if (word == "vn") {
        const auto [x, y, z] = lines_.take_three(rest);
        normals_.push_back({x, y, z});
        if (!trimmed(rest).empty())
          lines_.refuse(line, in_quotes(trimmed(rest)) + " after a normal", "one normal a line");
      }
      if (word == "f") take_face(rest, block.count, line);
    });
    if (block.count == 0) lines_.refuse_without_vertices("points");
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

  /// Appends those corners of a face to corners_ that have a normal: v and vn of v//vn or v/vt/vn.
  void take_face(std::string_view rest, std::size_t points, std::size_t line) {
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
      if (word.front() != '-' && std::isdigit(static_cast<unsigned char>(word.front())) == 0)
        lines_.refuse(line, in_quotes(word) + " in a face", "numbers of vertices, and one face a line");
      const std::size_t first = word.find('/'), second = word.find('/', std::min(first, word.size() - 1) + 1);
      if (second == std::string_view::npos) continue;
      corners_.push_back({lines_.index_of(word, word.substr(0, first), "vertex", points, line),
                          lines_.index_of(word, word.substr(second + 1), "normal", normals_.size(), line), line});
    }
  }

  /// Appends the normal of every vertex to the block; none, with a warning, if a vertex has no normal or different
  /// ones.
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
      lines_.require_known(corner.vertex, block.count, "vertex", corner.line);
      lines_.require_known(corner.normal, normals_.size(), "normal", corner.line);
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
  ObjLines lines_;
  std::vector<Point3> normals_ = {};  ///< normals of the lines "vn", in their order
  std::vector<Corner> corners_ = {};
  TextColors colors_ = TextColors();
  bool is_read_ = false;
};

/// Takes the next corner if it is an unsigned number and nothing else, as nearly all are; otherwise returns false and
/// takes nothing.
bool take_plain_corner(std::string_view& rest, std::vector<std::uint32_t>& corners) {
  const char* const last = rest.data() + rest.size();
  const char* const first = std::find_if_not(rest.data(), last, is_blank);
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(first, last, number);
  if (error != std::errc() || number == 0 || (end != last && !is_blank(*end))) return false;
  corners.push_back(number - 1);
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  return true;
}

}  // namespace

/// Reads the lines "v" of OBJ, with colors if they have six numbers or more, and "vn". A vertex has the normal that
/// corners of faces assign to it. If faces name no normals, and there are as many normals as vertices, vertex i has
/// normal i. If neither assigns a normal to every vertex, the points have none.
const CloudFormat obj_reader = {.open = open_as<ObjCloud>, .is_text = true};

MeshFile read_obj_mesh(std::string_view text, const std::string& name) {
  ObjLines lines(text, name);
  MeshFile mesh;
  std::vector<std::uint32_t> corners;
  const auto note = [&](const char* what) {
    if (std::find(mesh.unused.begin(), mesh.unused.end(), what) == mesh.unused.end()) mesh.unused.emplace_back(what);
  };
  lines.for_each([&](std::string_view word, std::string_view rest, std::size_t line) {
    if (word == "v") {
      mesh.positions.push_back(lines.take_vertex(rest, line));
      mesh.point_lines.push_back(line);
      take_word(rest);  // a weight, or red
      if (!trimmed(rest).empty()) note("vertex colors");
    }
    if (word == "vn") note("vertex normals");
    if (word == "vt") note("texture coordinates");
    if (word == "usemtl") note("materials");
    if (word != "f") return;
    corners.clear();
    while (take_plain_corner(rest, corners)) continue;
    for (std::string_view corner = take_word(rest); !corner.empty(); corner = take_word(rest))
      corners.push_back(
          lines.index_of(corner, corner.substr(0, corner.find('/')), "vertex", mesh.positions.size(), line));
    if (corners.empty()) lines.refuse(line, "a face without corners", "vertex numbers after 'f'");
    mesh.soup.add_face(corners);
    mesh.face_lines.push_back(line);
  });
  if (mesh.positions.empty()) lines.refuse_without_vertices("the vertices of a mesh");
  for (std::size_t f = 0; f < mesh.soup.faces(); ++f)
    for (const std::uint32_t corner : mesh.soup.face(f))
      lines.require_known(corner, mesh.positions.size(), "vertex", mesh.face_lines[f]);
  return mesh;
}

}  // namespace rbpa::app
