#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "drawings/drawn_front.h"
#include "drawings/figures.h"
#include "drawings/sheet.h"
#include "meshops/core/live.h"
#include "meshops/front/engine.h"
#include "rbpa/rbpa.h"

namespace figures {
namespace {

using meshops::Front;
using meshops::Site;
using Triangle = std::array<Site, 3>;

/// Policy that attaches the triangles of a list, each counter-clockwise, and freezes an edge at which none fits.
class GivenTriangles {
 public:
  explicit GivenTriangles(std::vector<Triangle> triangles) : left_(std::move(triangles)) {}

  std::optional<Triangle> seed(const Front&) {
    if (left_.empty()) return std::nullopt;
    return take(left_.begin());
  }
  std::optional<Site> propose(const Front& front, Halfedge h) {
    const Site a = front.from_site(h), b = front.to_site(h);
    for (auto t = left_.begin(); t != left_.end(); ++t)
      for (unsigned i = 0; i < 3; ++i)
        if ((*t)[i] == a && (*t)[(i + 1) % 3] == b) return take(t)[(i + 2) % 3];
    return std::nullopt;
  }

 private:
  Triangle take(std::vector<Triangle>::iterator at) {
    const Triangle taken = *at;
    left_.erase(at);
    return taken;
  }
  std::vector<Triangle> left_;
};

struct Events : meshops::CurveVisitor {
  std::vector<std::string> names;
  void curves_joined(const Front&, Halfedge) { names.emplace_back("curves_joined"); }
  void curve_split(const Front&, Halfedge, Halfedge) { names.emplace_back("curve_split"); }
  void curve_closed(const Front&) { names.emplace_back("curve_closed"); }
};

std::vector<Triangle> as_triangles(const std::vector<Corners>& faces) {
  std::vector<Triangle> triangles;
  for (const Corners& f : faces)
    triangles.push_back({static_cast<Site>(f[0]), static_cast<Site>(f[1]), static_cast<Site>(f[2])});
  return triangles;
}

/// Draws a front before and after some triangles, with the last event that they caused.
void event_row(Sheet& sheet, const std::vector<Place>& places, const std::vector<Corners>& faces,
               const std::vector<Corners>& more) {
  Mesh mesh;
  Front front(mesh, places.size());
  meshops::FrontVisitor silent;
  GivenTriangles first(as_triangles(faces));
  meshops::advance(front, first, silent);
  const DrawnMesh before = drawn_front(front, mesh, places);
  Marks fitting, attached;
  for (const Triangle& t : as_triangles(more))
    for (const Halfedge h : front.fit(t[0], t[1], t[2]).sides.side)
      if (h.is_valid()) fitting.add(mesh.edge_handle(h));
  front.next_level();
  Events events;
  GivenTriangles then(as_triangles(more));
  meshops::advance(front, then, events);
  for (std::size_t f = faces.size(); f < mesh.n_faces(); ++f) attached.add(Face(static_cast<int>(f)));
  const std::string times = more.size() > 1 ? std::to_string(more.size()) + " × " : "";
  sheet.row(counted(before, fitting), {times + "attach", "", events.names.empty() ? "" : events.names.back()},
            counted(drawn_front(front, mesh, places), attached));
}

std::string front_events() {
  Sheet sheet("Events of a front: a curve splits, two curves join, a curve closes");
  const Ring open = ring(7, 18, 342, 0.8, 1.7);
  event_row(sheet, open.places, open.faces, {{7, 0, 8}, {7, 8, 15}});
  event_row(sheet,
            {{0, 0.2}, {1.3, 0}, {1.3, 1.7}, {0.1, 1.5}, {2.3, 0.1}, {3.5, 0.4}, {3.5, 1.3}, {2.3, 1.8}, {4.3, 0.8}},
            {{0, 1, 3}, {1, 2, 3}, {4, 5, 7}, {5, 6, 7}, {5, 8, 6}}, {{1, 4, 2}, {4, 7, 2}});
  std::vector<Place> hole;
  for (int i = 0; i < 3; ++i) hole.push_back(polar(90 + 120 * i, 0.5));
  for (int i = 0; i < 3; ++i) hole.push_back(polar(150 + 120 * i, 1.7));
  event_row(sheet, hole, {{0, 3, 1}, {3, 4, 1}, {1, 4, 2}, {4, 5, 2}, {2, 5, 0}, {5, 3, 0}}, {{0, 1, 2}});
  return sheet.svg();
}

/// Returns a panel on which carried sites are marked, and those left behind are pale.
Panel transfer_panel(const DrawnMesh& drawn, const Front& front, const meshops::LevelTransfer& transfer) {
  Marks marks;
  const auto carried = [&](Vertex v) {
    return std::binary_search(transfer.carried.begin(), transfer.carried.end(), front.site(v));
  };
  meshops::for_each_vertex(drawn.mesh, [&](Vertex v) {
    if (carried(v))
      marks.add(v);
    else
      marks.pale_vertices.insert(v);
  });
  meshops::for_each_face(drawn.mesh, [&](Face f) { marks.pale_faces.insert(f); });
  Panel panel{drawn, marks, {}};
  panel.caption = {
      "carried " + std::to_string(transfer.carried.size()) + " · left behind " + std::to_string(transfer.left_behind),
      "reactivated " + std::to_string(transfer.reactivated) + " halfedges"};
  return panel;
}

std::string level_transfer() {
  // Seeds of a sunflower, at growing distances.
  std::vector<Place> places;
  std::vector<rbpa::Point> points;
  for (int i = 1; i <= 64; ++i) {
    places.push_back(polar(137.508 * i, 0.15 * std::pow(i, 0.7)));
    points.push_back({places.back().x, places.back().y});
  }
  Sheet sheet("Two levels: boundary and free points are carried to the next, the interior is left behind", 50, 300);
  Mesh mesh;
  Front front(mesh, places.size());
  meshops::FrontVisitor silent;
  std::vector<Triangle> done;
  int level = 0;
  for (const double alpha : {0.4, 0.47}) {
    std::vector<Triangle> triangles;
    for (const auto& t : rbpa::triangles(rbpa::rbpa(points, alpha)))
      triangles.push_back({static_cast<Site>(t[0]), static_cast<Site>(t[1]), static_cast<Site>(t[2])});
    std::vector<Triangle> fresh;
    std::set_difference(triangles.begin(), triangles.end(), done.begin(), done.end(), std::back_inserter(fresh));
    GivenTriangles policy(fresh);
    meshops::advance(front, policy, silent);
    done = triangles;
    const DrawnMesh drawn = drawn_front(front, mesh, places);
    Panel before = counted(drawn);
    before.heading = "level " + std::to_string(++level);
    sheet.row(before, {"next_level", ""}, transfer_panel(drawn, front, front.next_level()));
  }
  return sheet.svg();
}

/// Returns a panel with a mesh, a triangle that a policy proposes, and the answer of the front.
Panel proposed(const std::vector<Place>& places, const std::vector<Corners>& faces, const Triangle& triangle) {
  Mesh mesh;
  Front front(mesh, places.size());
  for (const Triangle& t : as_triangles(faces)) front.create(t[0], t[1], t[2]);
  Panel panel{drawn_front(front, mesh, places), {}};
  panel.extent = places;
  const auto refusal = front.create_blocker(triangle[0], triangle[1], triangle[2]);
  panel.heading = refusal ? "refused: " + std::string(meshops::name(refusal->kind)) : "taken";
  panel.more = [=, refused = refusal.has_value()](Canvas& canvas, const Frame& frame) {
    for (unsigned i = 0; i < 3; ++i) {
      const Place a = frame(places[triangle[i]]), b = frame(places[triangle[(i + 1) % 3]]);
      canvas.segment({a, b, {}}, {refused ? color::touched : color::curve, 2.5, true});
      canvas.dot(a, 4, refused ? color::touched : color::curve);
    }
  };
  return panel;
}

std::string front_refusals() {
  Sheet sheet("What a front takes of what is proposed, and what it refuses", 60, 250);
  std::vector<Place> wheel = {{0, 0}};
  std::vector<Corners> spokes;
  for (std::uint32_t i = 0; i < 6; ++i) {
    wheel.push_back(polar(30 + 60 * i, 1));
    spokes.push_back({0, 1 + i, 1 + (i + 1) % 6});
  }
  for (const Place p : {Place{2.3, 0.5}, Place{2.3, -0.5}}) wheel.push_back(p);
  sheet.row({proposed({{0, 0}, {2, 0}, {1, 1.5}, {2.6, 1.3}}, {{0, 1, 2}}, {0, 1, 3}),
             proposed(wheel, spokes, {0, 8, 7}),
             proposed({{0, 0}, {1.3, -0.5}, {1.3, 0.8}, {-1.2, 0.7}, {-1.3, -0.6}}, {{0, 1, 2}}, {0, 3, 4})});
  return sheet.svg();
}

}  // namespace

std::span<const Figure> front_figures() {
  static constexpr std::array figures = {Figure{"front_events", front_events}, Figure{"front_refusals", front_refusals},
                                         Figure{"level_transfer", level_transfer}};
  return figures;
}

}  // namespace figures
