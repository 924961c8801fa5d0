#include <algorithm>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/obj_lines.h"
#include "io/space/readers.h"
#include "io/space/text_colors.h"
#include "io/vertex_lines.h"

namespace rbpa::app {
namespace {

class ObjSpace {
 public:
  ObjSpace(std::string_view text, const std::string& name) : lines_(text), name_(name) {}

  SpacePoints read() {
    for (std::size_t step = 0; lines_.next_with_content(); ++step) {
      if (step % 16384 == 0) stop_if_interrupted();
      line_ = lines_.number();
      std::string_view rest = take_obj_line(lines_, joined_);
      const std::string_view word = take_word(rest);
      if (word == "v") {
        file_.points.push_back(take_point(rest));
        colors_.take(rest, line_);
      }
      if (word == "vn") normals_.push_back(take_point(rest));
      if (word == "f") take_face(rest);
    }
    if (file_.points.empty()) bad_input(name_, "no line 'v x y z'", "points");
    if (!normals_.empty()) settle_normals();
    colors_.settle(false, file_);
    return std::move(file_);
  }

 private:
  static constexpr std::uint32_t none = ~0U;

  /// A corner of a face that names a normal.
  struct Corner {
    std::uint32_t vertex, normal;
    std::size_t line;
  };

  Point3 take_point(std::string_view& rest) {
    const auto [x, y, z] = take_position(rest, lines_, name_);
    return {x, y, z};
  }

  /// Of a corner v//vn or v/vt/vn both count.
  void take_face(std::string_view rest) {
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
      const std::size_t first = word.find('/'), second = word.find('/', std::min(first, word.size() - 1) + 1);
      if (second == std::string_view::npos) continue;
      corners_.push_back({take_obj_number(word, word.substr(0, first), "vertex", file_.points.size(), name_, line_),
                          take_obj_number(word, word.substr(second + 1), "normal", normals_.size(), name_, line_),
                          line_});
    }
  }

  void require_known(const Corner& corner, std::uint32_t index, std::size_t count, const std::string& noun) const {
    if (index >= count)
      bad_input(at_line(name_, corner.line), in_quotes(std::to_string(std::uint64_t{index} + 1)),
                "a " + noun + " number from 1 to " + std::to_string(count));
  }

  /// Gives each vertex its normal, or none to all.
  void settle_normals() {
    if (corners_.empty()) {
      if (normals_.size() == file_.points.size()) {
        file_.normals = std::move(normals_);
      } else {
        leave_out(counted(normals_.size(), "normal") + " for " + std::to_string(file_.points.size()) +
                  " vertices, and no face says which is whose");
      }
      return;
    }
    std::vector<std::uint32_t> normal_of(file_.points.size(), none);
    for (const Corner& corner : corners_) {
      require_known(corner, corner.vertex, file_.points.size(), "vertex");
      require_known(corner, corner.normal, normals_.size(), "normal");
      std::uint32_t& normal = normal_of[corner.vertex];
      if (normal != none && normals_[normal] != normals_[corner.normal])
        return leave_out("vertex " + std::to_string(std::uint64_t{corner.vertex} + 1) +
                         " has several in the faces around it, line " + std::to_string(corner.line));
      normal = corner.normal;
    }
    const auto without = std::find(normal_of.begin(), normal_of.end(), none);
    if (without != normal_of.end())
      return leave_out("no face gives vertex " + std::to_string(without - normal_of.begin() + 1) + " one");
    for (const std::uint32_t normal : normal_of) file_.normals.push_back(normals_[normal]);
  }

  void leave_out(const std::string& reason) { file_.remarks.push_back("normals are left out: " + reason); }

  Lines lines_;
  const std::string& name_;
  std::size_t line_ = 0;  ///< the first of those that are continued
  std::string joined_ = {};
  std::vector<Point3> normals_ = {};  ///< in the order of their lines
  std::vector<Corner> corners_ = {};
  TextColors colors_ = {};
  SpacePoints file_ = {};
};

}  // namespace

SpacePoints read_obj_space(std::string_view text, const std::string& name) { return ObjSpace(text, name).read(); }

}  // namespace rbpa::app
