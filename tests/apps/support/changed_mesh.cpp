#include "support/changed_mesh.h"

#include <doctest/doctest.h>

#include "io/mesh/read_mesh.h"

namespace apps_test {
namespace {

std::string number(double x) {
  std::array<char, 32> text;
  return {text.data(),
          static_cast<std::size_t>(std::to_chars(text.data(), text.data() + text.size(), x).ptr - text.data())};
}

double determinant(const std::array<double, 3>& a, const std::array<double, 3>& b, const std::array<double, 3>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

}  // namespace

void Mesh::add_box(std::array<double, 3> low, std::array<double, 3> high) {
  const auto at = static_cast<std::uint32_t>(positions.size());
  for (const double z : {low[2], high[2]})
    for (const double y : {low[1], high[1]})
      for (const double x : {low[0], high[0]}) positions.push_back({x, y, z});
  for (const std::vector<std::uint32_t>& face :
       Faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    faces.emplace_back();
    for (const std::uint32_t v : face) faces.back().push_back(at + v);
  }
}

void Mesh::add_triangle(std::array<double, 3> a, std::array<double, 3> b, std::array<double, 3> c) {
  const auto at = static_cast<std::uint32_t>(positions.size());
  positions.insert(positions.end(), {a, b, c});
  faces.push_back({at, at + 1, at + 2});
}

void Mesh::shuffle(std::mt19937& random) {
  std::vector<std::uint32_t> order(positions.size()), place(positions.size());
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), random);
  Positions moved;
  for (const std::uint32_t p : order) {
    place[p] = static_cast<std::uint32_t>(moved.size());
    moved.push_back(positions[p]);
  }
  positions = std::move(moved);
  for (auto& face : faces) {
    for (std::uint32_t& v : face) v = place[v];
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(random() % face.size()), face.end());
  }
  std::shuffle(faces.begin(), faces.end(), random);
}

std::string Mesh::off() const {
  std::string text = "OFF\n" + std::to_string(positions.size()) + " " + std::to_string(faces.size()) + " 0\n";
  for (const auto& p : positions)
    for (std::size_t k = 0; k < 3; ++k) text += number(p[k]) + (k < 2 ? " " : "\n");
  for (const auto& face : faces) {
    text += std::to_string(face.size());
    for (const std::uint32_t v : face) text += " " + std::to_string(v);
    text += "\n";
  }
  return text;
}

std::multiset<Positions> places_of(const Folder& folder, const std::string& name) {
  const rbpa::app::MeshFile mesh = rbpa::app::read_mesh({folder.path(name), rbpa::app::Format::off});
  std::multiset<Positions> faces;
  for (std::size_t f = 0; f < mesh.soup.faces(); ++f) {
    Positions face;
    for (const std::uint32_t v : mesh.soup.face(f)) face.push_back(mesh.positions[v]);
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.insert(face);
  }
  return faces;
}

double six_volumes(const Folder& folder, const std::string& name) {
  double sum = 0;
  for (const Positions& face : places_of(folder, name))
    for (std::size_t i = 1; i + 1 < face.size(); ++i) sum += determinant(face[0], face[i], face[i + 1]);
  return sum;
}

nlohmann::json changed(const Folder& folder, const std::string& arguments) {
  CAPTURE(arguments);
  const Outcome outcome = folder.meshtopo(arguments + " --json");
  CHECK(outcome.err.empty());
  REQUIRE(outcome.code == 0);
  return nlohmann::json::parse(outcome.out);
}

}  // namespace apps_test
