#include <algorithm>
#include <charconv>
#include <cstdint>

#include "io/cloud/obj.h"
#include "io/failure.h"
#include "io/mesh/read_mesh.h"
#include "io/text/vertex_lines.h"

namespace rbpa::app {
namespace {

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name) : lines_(text), name_(name) {}

  MeshFile read() {
    for_each_obj_line(lines_, [&](std::string_view word, std::string_view rest, std::size_t line) {
      if (word == "v") {
        mesh_.positions.push_back(take_position(rest, lines_, name_));
        require_end_of_vertex(rest, name_, line);
        mesh_.point_lines.push_back(line);
      } else if (word == "f") {
        read_face(rest, line);
      }
    });
    if (mesh_.positions.empty()) bad_input(name_, "no line 'v x y z'", "the vertices of a mesh");
    check_later_corners();
    return std::move(mesh_);
  }

 private:
  void read_face(std::string_view rest, std::size_t line) {
    corners_.clear();
    while (take_plain_corner(rest)) continue;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest))
      corners_.push_back(
          take_obj_number(word, word.substr(0, word.find('/')), "vertex", mesh_.positions.size(), name_, line));
    if (corners_.empty()) bad_input(at_line(name_, line), "a face without corners", "vertex numbers after 'f'");
    mesh_.soup.add_face(corners_);
    mesh_.face_lines.push_back(line);
  }

  /// Takes a corner that is an unsigned number and nothing else, as nearly all are; returns false for others.
  bool take_plain_corner(std::string_view& rest) {
    const char* const last = rest.data() + rest.size();
    const char* const first = std::find_if_not(rest.data(), last, is_blank);
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(first, last, number);
    if (error != std::errc() || number == 0 || (end != last && !is_blank(*end))) return false;
    corners_.push_back(number - 1);
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    return true;
  }

  /// Checks corners that name vertices which come after the face.
  void check_later_corners() const {
    for (std::size_t f = 0; f < mesh_.soup.faces(); ++f)
      for (const std::uint32_t corner : mesh_.soup.face(f))
        if (corner >= mesh_.positions.size())
          bad_input(at_line(name_, mesh_.face_lines[f]), in_quotes(std::to_string(std::uint64_t{corner} + 1)),
                    "a vertex number from 1 to " + std::to_string(mesh_.positions.size()));
  }

  Lines lines_;
  const std::string& name_;
  std::vector<std::uint32_t> corners_ = {};
  MeshFile mesh_ = {};
};

}  // namespace

MeshFile read_obj_mesh(std::string_view text, const std::string& name) { return ObjReader(text, name).read(); }

}  // namespace rbpa::app
