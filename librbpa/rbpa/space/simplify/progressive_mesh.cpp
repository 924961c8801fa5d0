#include "rbpa/space/simplify/progressive_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/core/live_range.h"
#include "meshops/stellar/collapse.h"
#include "meshops/stellar/split_vertex.h"
#include "meshops/stellar/undo.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/soup_defects.h"
#include "rbpa/base/error.h"
#include "rbpa/space/simplify/distance/distance_of_mesh.h"

namespace rbpa {
namespace {

using meshops::Connectivity;
using meshops::Face;
using meshops::Halfedge;
using meshops::Vertex;

// The bytes begin with the name and numbers of 4 bytes: the version, whether survivors move, the numbers of vertices
// and triangles of the coarse mesh, the number of splits, and the number of triangles of the full mesh. Then follow for
// each vertex its number and place, and for each triangle its number and corners, which count the vertices before. Then
// follow for each split: the halfedges at the vertex that is split, the numbers of the new vertex and triangles, the
// first sides of these triangles, and the places of the new vertex and, if survivors move, of the other one.
constexpr std::string_view magic = "rbpaprog";
constexpr std::uint32_t version = 1, most_faces = 1U << 29U;
constexpr std::uint64_t size_of_head = 32, size_of_vertex = 28, size_of_triangle = 16, size_of_split = 21,
                        size_of_place = 24;

using space::index_of;

auto bits_of(const Point3& p) { return std::bit_cast<std::array<std::uint64_t, 3>>(p); }

class NumbersOut {
 public:
  void add(std::uint64_t number, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) bytes.push_back(static_cast<std::byte>(number >> 8 * i & 0xffU));
  }
  void add(std::uint32_t number) { add(number, 4); }
  void add(const Point3& p) {
    for (const std::uint64_t coordinate : bits_of(p)) add(coordinate, 8);
  }
  std::vector<std::byte> bytes = {};
};

template <typename... Parts>
void require_bytes(bool holds, const Parts&... parts) {
  if (holds) return;
  std::ostringstream text;
  text << "progressive mesh: ";
  (text << ... << parts);
  throw InvalidInput(text.str());
}

/// Reads numbers from bytes. Requires: enough bytes are left.
class NumbersIn {
 public:
  explicit NumbersIn(std::span<const std::byte> bytes) : bytes_(bytes) {}
  std::uint64_t next(std::size_t size) {
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < size; ++i) number |= static_cast<std::uint64_t>(bytes_[next_++]) << 8 * i;
    return number;
  }
  std::uint32_t next() { return static_cast<std::uint32_t>(next(4)); }
  Point3 place_of(std::uint32_t vertex) {
    std::array<double, 3> x{};
    for (double& coordinate : x) coordinate = std::bit_cast<double>(next(8));
    const Point3 place{x[0], x[1], x[2]};
    require_bytes(is_finite(place), "found coordinates of vertex ", vertex, " that are not finite, expected numbers");
    return place;
  }

 private:
  std::span<const std::byte> bytes_;
  std::size_t next_ = 0;
};

/// Numbers below a limit, each of which may be added once.
class Numbering {
 public:
  Numbering(const char* what, std::size_t limit) : what_(what), is_taken_(limit, false) {}
  void add(std::uint32_t number) {
    require_bytes(number < is_taken_.size(), "found ", what_, " ", number, " of ", is_taken_.size());
    require_bytes(!is_taken_[number], "found ", what_, " ", number, " twice, expected each number once");
    is_taken_[number] = true;
    all.push_back(number);
  }
  std::vector<std::uint32_t> all = {};

 private:
  const char* what_;
  std::vector<bool> is_taken_;
};

/// Returns how many sides after the first side of its triangle a halfedge is.
std::uint32_t side_of(const Connectivity& mesh, Halfedge h) {
  const Halfedge first = mesh.halfedge_handle(mesh.face_handle(h));
  return h == first ? 0 : h == mesh.next_halfedge_handle(first) ? 1 : 2;
}

/// Makes `h` the side of its triangle that is `side` sides after the first side.
void set_side(Connectivity& mesh, Halfedge h, std::uint32_t side) {
  for (; side % 3 != 0; ++side) h = mesh.next_halfedge_handle(h);
  mesh.set_halfedge_handle(mesh.face_handle(h), h);
}

/// Returns the number by which bytes name a halfedge: by the side of a triangle that it is on or opposite to.
std::uint32_t code_of(const Connectivity& mesh, const std::optional<Halfedge>& h,
                      const std::vector<std::uint32_t>& place_of_face) {
  if (!h) return no_index;
  const bool is_across = mesh.is_boundary(*h);
  const Halfedge side = is_across ? mesh.opposite_halfedge_handle(*h) : *h;
  return (place_of_face[index_of(mesh.face_handle(side))] * 3 + side_of(mesh, side)) * 2 + (is_across ? 1 : 0);
}

std::optional<Halfedge> halfedge_of(const Connectivity& mesh, std::uint32_t code) {
  if (code == no_index) return std::nullopt;
  require_bytes(code / 6 < mesh.n_faces(), "found a side of triangle ", code / 6, " of ", mesh.n_faces());
  Halfedge h = mesh.halfedge_handle(Face(static_cast<int>(code / 6)));
  for (std::uint32_t i = code / 2 % 3; i > 0; --i) h = mesh.next_halfedge_handle(h);
  return code % 2 == 0 ? h : mesh.opposite_halfedge_handle(h);
}

/// Splits a vertex as the bytes say. Returns the halfedge whose collapse undoes the split.
Halfedge split_as_read(Connectivity& mesh, NumbersIn& in, Numbering& vertices, Numbering& faces) {
  const std::uint32_t code = in.next();
  const std::optional<Halfedge> left = halfedge_of(mesh, code), right = halfedge_of(mesh, in.next());
  const auto require = [&, i = vertices.all.size()](const std::optional<meshops::Blocker>& blocker) {
    if (blocker) require_bytes(false, "vertex ", i, " would break the mesh: ", meshops::describe(*blocker));
  };
  require_bytes(left != right,
                "found a split between equal halfedges, expected different ones (write the bytes again)");
  require(meshops::split_vertex_blocker(mesh, left, right));
  const meshops::SplitVertexEffect effect = meshops::split_vertex(mesh, left, right);
  const Halfedge along = effect.halfedge, across = mesh.opposite_halfedge_handle(along);
  require(meshops::collapse_blocker(mesh, along));
  vertices.add(in.next());
  faces.add(in.next());
  const std::uint32_t second = in.next();
  const auto sides = static_cast<std::uint32_t>(in.next(1));
  require_bytes((second == no_index) == effect.added.at_boundary && sides < (second == no_index ? 3 : 9),
                "found another number of triangles or sides at vertex ", vertices.all.back(), " than its split makes");
  set_side(mesh, left ? along : across, sides % 3);
  if (second == no_index) return along;
  faces.add(second);
  set_side(mesh, across, sides / 3);
  return along;
}

/// Returns the numbers from 0 to count − 1.
std::vector<std::uint32_t> numbers_up_to(std::size_t count) {
  std::vector<std::uint32_t> all(count);
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

}  // namespace

ProgressiveMesh::ProgressiveMesh(Connectivity mesh, std::vector<Point3> places, const DecimationOptions& options,
                                 const QuadricOptions& quadrics)
    : mesh_(std::move(mesh)),
      places_(std::move(places)),
      vertex_number_(numbers_up_to(mesh_.n_vertices())),
      face_number_(numbers_up_to(mesh_.n_faces())) {
  meshops::request_status(mesh_);
  const auto require_none_deleted = [&](auto elements) {
    for (const auto element : elements)
      meshops::require(!mesh_.status(element).deleted(), "ProgressiveMesh: element ", element.idx(),
                       " is marked deleted, expected none (call garbage_collection() before)");
  };
  require_none_deleted(mesh_.all_vertices());
  require_none_deleted(mesh_.all_faces());
  std::vector<RecordedCollapse> record;
  counts_ = decimate(mesh_, places_, options, quadrics, &record);
  faces_ = counts_.left;
  done_ = record.size();
  for (const auto& [effect, before, after] : record) {
    moves_ = moves_ || bits_of(before) != bits_of(after);
    steps_.push_back({effect, before});
  }
}

void ProgressiveMesh::go_to(std::size_t faces) {
  const auto pass = [&](Step& step) { std::swap(places_[index_of(step.effect.survivor)], step.other); };
  while (faces_ > faces && done_ < steps_.size()) {
    Step& step = steps_[done_++];
    step.effect = meshops::collapse(mesh_, step.effect.halfedge);
    pass(step);
    faces_ -= step.effect.removed.faces().size();
  }
  while (done_ > 0 && faces_ + steps_[done_ - 1].effect.removed.faces().size() <= faces) {
    Step& step = steps_[--done_];
    meshops::undo(mesh_, step.effect);
    pass(step);
    faces_ += step.effect.removed.faces().size();
  }
}

std::vector<Triangle> ProgressiveMesh::triangles() const {
  const meshops::PolygonSoup soup = meshops::soup_of(mesh_, vertex_number_);
  std::vector<std::pair<std::uint32_t, Triangle>> numbered;
  for (const Face f : meshops::live_faces(mesh_)) {
    const auto corners = soup.face(numbered.size());
    numbered.push_back({face_number_[index_of(f)], {corners[0], corners[1], corners[2]}});
  }
  std::sort(numbered.begin(), numbered.end());
  std::vector<Triangle> all;
  for (const auto& [number, triangle] : numbered) all.push_back(triangle);
  return all;
}

std::vector<Point3> ProgressiveMesh::positions() const {
  std::vector<Point3> all(places_.size());
  for (std::size_t v = 0; v < all.size(); ++v) all[vertex_number_[v]] = places_[v];
  return all;
}

std::vector<std::byte> ProgressiveMesh::write() const {
  meshops::require(most() < most_faces, "ProgressiveMesh: found ", static_cast<long long>(most()),
                   " triangles, expected fewer than 2^29, to write them");
  ProgressiveMesh copy = *this;
  copy.go_to(0);
  const Connectivity& mesh = copy.mesh_;
  NumbersOut out;
  for (const char c : magic) out.add(static_cast<std::uint64_t>(c), 1);
  for (const std::size_t number :
       {std::size_t{version}, std::size_t{moves_}, mesh.n_vertices() - steps_.size(), least(), steps_.size(), most()})
    out.add(static_cast<std::uint32_t>(number));
  std::vector<std::uint32_t> place_of_vertex(mesh.n_vertices()), place_of_face(mesh.n_faces());
  std::uint32_t vertices = 0, faces = 0;
  for (const Vertex v : meshops::live_vertices(mesh)) {
    place_of_vertex[index_of(v)] = vertices++;
    out.add(vertex_number_[index_of(v)]);
    out.add(copy.places_[index_of(v)]);
  }
  const meshops::PolygonSoup soup = meshops::soup_of(mesh, place_of_vertex);
  for (const Face f : meshops::live_faces(mesh)) {
    out.add(face_number_[index_of(f)]);
    for (const std::uint32_t corner : soup.face(faces)) out.add(corner);
    place_of_face[index_of(f)] = faces++;
  }
  while (copy.done_ > 0) {
    const auto& [removed, survivor, left, right, along, named] = copy.steps_[copy.done_ - 1].effect;
    meshops::require(left != right, "ProgressiveMesh: two edges join vertex ", survivor.idx(),
                     " and another one, expected one, to write them");
    out.add(code_of(mesh, left, place_of_face));
    out.add(code_of(mesh, right, place_of_face));
    copy.go_to(copy.faces_ + removed.faces().size());
    out.add(vertex_number_[index_of(removed.vertex)]);
    std::uint32_t sides = 0;
    for (const Face f : removed.faces()) {
      const bool is_left = mesh.face_handle(along) == f, is_second = f != removed.face[0];
      out.add(face_number_[index_of(f)]);
      place_of_face[index_of(f)] = faces++;
      sides += (is_second ? 3 : 1) * side_of(mesh, is_left ? along : mesh.opposite_halfedge_handle(along));
    }
    if (removed.at_boundary) out.add(no_index);
    out.add(sides, 1);
    out.add(copy.places_[index_of(removed.vertex)]);
    if (moves_) out.add(copy.places_[index_of(survivor)]);
  }
  return std::move(out.bytes);
}

ProgressiveMesh ProgressiveMesh::read(std::span<const std::byte> bytes) {
  NumbersIn in(bytes);
  require_bytes(bytes.size() >= size_of_head, "found ", bytes.size(), " bytes, expected at least ", size_of_head);
  for (const char c : magic)
    require_bytes(in.next(1) == static_cast<std::uint64_t>(c), "found another beginning, expected ", magic,
                  ", with which a progressive mesh begins");
  std::array<std::uint32_t, 6> head{};
  for (std::uint32_t& number : head) number = in.next();
  const auto& [found, move, vertices, least, splits, most] = head;
  require_bytes(found == version, "found version ", found, ", expected ", version);
  require_bytes(move <= 1, "found ", move, " for whether vertices move, expected 0 or 1");
  const std::uint64_t size = size_of_head + size_of_vertex * vertices + size_of_triangle * least +
                             (size_of_split + size_of_place * (1 + move)) * splits;
  require_bytes(bytes.size() == size, "found ", bytes.size(), " bytes, expected ", size, " by the numbers in the head");
  require_bytes(most < most_faces && most <= least + 2 * std::uint64_t{splits}, "found ", most, " triangles after ",
                splits, " splits of a mesh of ", least);
  ProgressiveMesh result;
  Connectivity& mesh = result.mesh_;
  std::vector<Point3>& places = result.places_;
  Numbering of_vertices("vertex", std::size_t{vertices} + splits), of_faces("triangle", most);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    of_vertices.add(in.next());
    places.push_back(in.place_of(of_vertices.all.back()));
  }
  meshops::PolygonSoup soup;
  soup.points = vertices;
  for (std::uint32_t f = 0; f < least; ++f) {
    of_faces.add(in.next());
    Triangle corners{};
    for (std::uint32_t& corner : corners) corner = in.next();
    soup.add_face(corners);
  }
  for (const meshops::SoupDefect& defect : meshops::find_defects(soup))
    require_bytes(false, "the coarse mesh has a defect, expected none: ", meshops::describe(defect));
  meshops::build_mesh(mesh, soup);
  meshops::request_status(mesh);
  for (std::uint32_t i = 0; i < splits; ++i) {
    const Halfedge along = split_as_read(mesh, in, of_vertices, of_faces);
    const Vertex survivor = mesh.to_vertex_handle(along);
    Step& step = result.steps_.emplace_back();
    step.effect.halfedge = along;
    step.other = places[index_of(survivor)];
    places.push_back(in.place_of(of_vertices.all.back()));
    if (move == 1) places[index_of(survivor)] = in.place_of(of_vertices.all[index_of(survivor)]);
  }
  require_bytes(mesh.n_faces() == most, "found ", mesh.n_faces(), " triangles after all splits, expected ", most);
  std::reverse(result.steps_.begin(), result.steps_.end());
  result.moves_ = move == 1;
  result.counts_ = {.given = most, .left = least, .collapses = splits};
  result.faces_ = most;
  result.vertex_number_ = std::move(of_vertices.all);
  result.face_number_ = std::move(of_faces.all);
  return result;
}

}  // namespace rbpa
