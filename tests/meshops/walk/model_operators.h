// What: the operators on a model, each by its definition as a change of cycles of sides.
// Law:  a function returns why it has no meaning for its arguments, with the model untouched; otherwise it returns "",
//       and the model is the result of the definition, manifold or not.
#pragma once

#include <string>
#include <vector>

#include "walk/model.h"

namespace meshops::test {

/// Names of new elements, in the order of use: given ones first, then unused numbers.
class Names {
 public:
  explicit Names(const Model& model, std::vector<int> vertices = {}, std::vector<int> sides = {},
                 std::vector<int> faces = {})
      : vertices_(std::move(vertices)),
        sides_(std::move(sides)),
        faces_(std::move(faces)),
        fresh_vertex_(static_cast<int>(model.has_vertex.size()) + 1000),
        fresh_side_(static_cast<int>(model.from.size()) + 1000),
        fresh_face_(static_cast<int>(model.faces.size()) + 1000) {}

  /// Returns the name of the first vertex when none are given.
  static int fresh_vertex(const Model& model) { return static_cast<int>(model.has_vertex.size()) + 1001; }

  int vertex() { return next(vertices_, fresh_vertex_, 1); }
  int side() { return next(sides_, fresh_side_, 2); }
  int face() { return next(faces_, fresh_face_, 1); }

 private:
  static int next(std::vector<int>& given, int& fresh, int step) {
    if (given.empty()) return fresh += step;
    const int name = given.front();
    given.erase(given.begin());
    return name;
  }
  std::vector<int> vertices_, sides_, faces_;
  int fresh_vertex_, fresh_side_, fresh_face_;
};

namespace by_definition {

// Handle operators ----------------------------------------------------------------------------------------------------

std::string glue(Model& model, int first, int second);
/// `names` are, in this order, the second side; a vertex for the start of h if that is on the boundary; one for its end
/// if that is on the boundary.
std::string unglue(Model& model, int h, Names names);
std::string destroy_triangle(Model& model, int f);
/// `left` has the starts of the remaining sides, which are one vertex in each fan.
std::string remove_triangle(Model& model, int f, const Model* left);
std::string close_curve(Model& model, int h, Names names);
std::string open_curve(Model& model, int f);
std::string zip_curves(Model& model, int first, int second);

// Stellar operators. Names: the vertex; for each new edge, the side that leaves it; the faces, as in StarElements.

std::string split_edge(Model& model, int h, Names names);
/// `named` is the side to which the face refers.
std::string split_face(Model& model, int f, int named, Names names);
/// `run` are the sides between left and right; -1 for a side that is left out.
std::string split_vertex(Model& model, int left, int right, const std::vector<int>& run, Names names);
/// Counter-clockwise, or clockwise.
std::string flip(Model& model, int edge, bool back = false);
std::string collapse(Model& model, int h);
std::string weld_edge(Model& model, int h);
/// `named` is the side to which the vertex refers.
std::string weld_face(Model& model, int v, int named);
/// `named` is the side to which the face refers. Names: the side of the diagonal from the start of `from`; the face.
std::string insert_diagonal(Model& model, int from, int to, int named, Names names);
std::string remove_diagonal(Model& model, int h);

}  // namespace by_definition
}  // namespace meshops::test
