#include "support/soups.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace meshops::test {
namespace {

using FaceCorners = std::vector<std::uint32_t>;

FaceCorners corners_of(const PolygonSoup& soup, std::size_t f) {
  const auto face = soup.face(f);
  return {face.begin(), face.end()};
}

std::uint32_t below(std::mt19937& random, std::size_t bound) { return static_cast<std::uint32_t>(random() % bound); }

/// Rotates a face to another first corner.
void turn(FaceCorners& face, std::mt19937& random) {
  if (!face.empty()) std::rotate(face.begin(), face.begin() + below(random, face.size()), face.end());
}

bool same_cycle(const FaceCorners& a, FaceCorners b) {
  for (int direction = 0; direction < 2; ++direction) {
    for (std::size_t turn = 0; turn < b.size(); ++turn) {
      if (a == b) return true;
      std::rotate(b.begin(), b.begin() + 1, b.end());
    }
    std::reverse(b.begin(), b.end());
  }
  return false;
}

struct Side {
  std::size_t face, corner;  // corner of the face, at the lower end of the edge if the side ascends
  bool ascending;
  std::size_t low_corner(const PolygonSoup& soup) const { return ascending ? corner : next(soup); }
  std::size_t high_corner(const PolygonSoup& soup) const { return ascending ? next(soup) : corner; }
  std::size_t next(const PolygonSoup& soup) const { return (corner + 1) % soup.face(face).size(); }
};
using Ends = std::pair<std::uint32_t, std::uint32_t>;
using Edges = std::map<Ends, std::vector<Side>>;

struct Faults {
  std::vector<SoupDefect> defects;
  std::vector<std::size_t> good;  // faces
};

Faults faults_of(const PolygonSoup& soup) {
  std::vector<SoupDefect> lists[3];
  Faults faults;
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    const FaceCorners face = corners_of(soup, f);
    const bool outside = std::any_of(face.begin(), face.end(), [&](std::uint32_t c) { return c >= soup.points; });
    const std::set<std::uint32_t> distinct(face.begin(), face.end());
    const auto repeated = std::find_if(faults.good.begin(), faults.good.end(),
                                       [&](std::size_t g) { return same_cycle(face, corners_of(soup, g)); });
    if (outside)
      lists[0].push_back({SoupDefectKind::corner_out_of_range, face, {f}});
    else if (face.size() < 3 || distinct.size() < face.size())
      lists[1].push_back({SoupDefectKind::degenerate_face, face, {f}});
    else if (repeated != faults.good.end())
      lists[2].push_back({SoupDefectKind::duplicate_face, face, {*repeated, f}});
    else
      faults.good.push_back(f);
  }
  for (const auto& list : lists) faults.defects.insert(faults.defects.end(), list.begin(), list.end());
  return faults;
}

Edges edges_of(const PolygonSoup& soup, const std::vector<std::size_t>& faces) {
  Edges edges;
  for (const std::size_t f : faces) {
    const FaceCorners face = corners_of(soup, f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::uint32_t from = face[i], to = face[(i + 1) % face.size()];
      edges[{std::min(from, to), std::max(from, to)}].push_back({f, i, from < to});
    }
  }
  return edges;
}

/// Returns the class of each element under links, as its least member.
template <typename Element>
std::map<Element, Element> classes(const std::vector<Element>& elements,
                                   const std::vector<std::pair<Element, Element>>& links) {
  std::map<Element, Element> least;
  for (const Element& e : elements) least[e] = e;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [a, b] : links) {
      const Element low = std::min(least[a], least[b]);
      changed = changed || least[a] != low || least[b] != low;
      least[a] = least[b] = low;
    }
  }
  return least;
}

using Corner = std::pair<std::size_t, std::size_t>;  // face, index

std::map<Corner, Corner> fans_of(const PolygonSoup& soup, const std::vector<std::size_t>& faces, const Edges& edges,
                                 bool through_all_edges) {
  std::vector<Corner> corners;
  for (const std::size_t f : faces)
    for (std::size_t i = 0; i < soup.face(f).size(); ++i) corners.push_back({f, i});
  std::vector<std::pair<Corner, Corner>> links;
  for (const auto& [ends, sides] : edges) {
    if (sides.size() != 2 && !through_all_edges) continue;
    for (const Side& s : sides) {
      links.push_back({{s.face, s.low_corner(soup)}, {sides[0].face, sides[0].low_corner(soup)}});
      links.push_back({{s.face, s.high_corner(soup)}, {sides[0].face, sides[0].high_corner(soup)}});
    }
  }
  return classes(corners, links);
}

std::map<std::size_t, std::size_t> pieces_of(const std::vector<std::size_t>& faces, const Edges& edges) {
  std::vector<std::pair<std::size_t, std::size_t>> links;
  for (const auto& [ends, sides] : edges)
    if (sides.size() == 2) links.push_back({sides[0].face, sides[1].face});
  return classes(faces, links);
}

/// Returns the first faces of the pieces in which no choice of directions agrees.
std::set<std::size_t> not_orientable(const std::vector<std::size_t>& faces, const Edges& edges) {
  // Two sheets, one for each direction: a piece is orientable unless its sheets are connected.
  using Sheet = std::pair<std::size_t, bool>;
  std::vector<Sheet> sheets;
  for (const std::size_t f : faces) {
    sheets.push_back({f, false});
    sheets.push_back({f, true});
  }
  std::vector<std::pair<Sheet, Sheet>> links;
  for (const auto& [ends, sides] : edges)
    if (sides.size() == 2)
      for (const bool sheet : {false, true})
        links.push_back({{sides[0].face, sheet}, {sides[1].face, sheet != (sides[0].ascending == sides[1].ascending)}});
  auto sheet_of = classes(sheets, links);
  std::set<std::size_t> firsts;
  for (const std::size_t f : faces)
    if (sheet_of[{f, false}] == sheet_of[{f, true}]) firsts.insert(sheet_of[{f, false}].first);
  return firsts;
}

std::size_t rank(std::vector<std::vector<bool>> rows) {
  std::size_t rank = 0;
  for (std::size_t column = 0; !rows.empty() && column < rows[0].size(); ++column) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                                    [&](const auto& row) { return row[column]; });
    if (pivot == rows.end()) continue;
    std::swap(*pivot, rows[rank]);
    for (std::size_t r = rank + 1; r < rows.size(); ++r)
      if (rows[r][column])
        for (std::size_t c = 0; c < rows[r].size(); ++c) rows[r][c] = rows[r][c] != rows[rank][c];
    ++rank;
  }
  return rank;
}

std::size_t rank_of_boundary(const std::vector<std::vector<std::size_t>>& cells, std::size_t below) {
  std::vector<std::vector<bool>> rows;
  for (const auto& boundary : cells) {
    std::vector<bool> row(below, false);
    for (const std::size_t b : boundary) row[b] = !row[b];
    rows.push_back(std::move(row));
  }
  return rank(std::move(rows));
}

}  // namespace

PolygonSoup soup(std::size_t points, std::initializer_list<std::initializer_list<std::uint32_t>> faces) {
  PolygonSoup made;
  made.points = points;
  for (const auto& face : faces) made.add_face(std::vector<std::uint32_t>(face));
  return made;
}

PolygonSoup grid_soup(std::uint32_t columns, std::uint32_t rows, bool wrap_x, bool wrap_y, bool flip) {
  PolygonSoup made;
  const std::uint32_t nx = wrap_x ? columns : columns + 1, ny = wrap_y ? rows : rows + 1;
  made.points = std::size_t{nx} * ny;
  const auto at = [&](std::uint32_t x, std::uint32_t y) {
    if (flip && x == nx) return ((rows - y) % ny) * nx;
    return (y % ny) * nx + x % nx;
  };
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      made.add_face(FaceCorners{at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      made.add_face(FaceCorners{at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  return made;
}

PolygonSoup moebius_band() { return soup(5, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}}); }

PolygonSoup projective_plane() {
  return soup(
      6,
      {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}, {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}});
}

PolygonSoup klein_bottle() { return grid_soup(5, 4, true, true, true); }

PolygonSoup beside(const PolygonSoup& a, const PolygonSoup& b) {
  PolygonSoup both = a;
  both.points += b.points;
  for (std::size_t f = 0; f < b.faces(); ++f) {
    FaceCorners face = corners_of(b, f);
    for (std::uint32_t& corner : face) corner += static_cast<std::uint32_t>(a.points);
    both.add_face(face);
  }
  return both;
}

PolygonSoup random_soup(std::mt19937& random) {
  PolygonSoup made;
  made.points = random() % 9;
  const std::size_t faces = random() % 13;
  const unsigned wild = below(random, 4);  // share of lists that are not faces
  for (std::size_t f = 0; f < faces; ++f) {
    FaceCorners face;
    if (f > 0 && random() % 8 < wild) {
      face = corners_of(made, random() % f);
      turn(face, random);
      if (random() % 2) std::reverse(face.begin(), face.end());
    } else {
      const std::size_t size = random() % 8 < wild ? random() % 6 : 3 + random() % 4 / 3;
      const std::size_t range = made.points + (random() % 32 < wild ? 2 : 0);
      for (int attempt = 0; range > 0 && face.size() < size && attempt < 50; ++attempt) {
        const auto corner = below(random, range);
        if (random() % 16 < wild || std::find(face.begin(), face.end(), corner) == face.end()) face.push_back(corner);
      }
    }
    made.add_face(face);
  }
  return made;
}

PolygonSoup broken_surface(std::mt19937& random) {
  const PolygonSoup whole[] = {grid_soup(4, 3, false, false),
                               grid_soup(5, 2, true, false),
                               grid_soup(4, 3, true, true),
                               grid_soup(4, 3, true, false, true),
                               grid_soup(4, 3, true, true, true),
                               projective_plane(),
                               moebius_band(),
                               soup(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})};
  PolygonSoup surface = whole[random() % std::size(whole)];
  if (random() % 2) surface = beside(surface, whole[random() % std::size(whole)]);
  for (std::size_t merges = random() % 4; merges > 0; --merges) {
    const std::uint32_t from = below(random, surface.points), to = below(random, surface.points);
    std::replace(surface.corners.begin(), surface.corners.end(), from, to);
  }
  const unsigned reversed = below(random, 3), left_out = below(random, 3);
  PolygonSoup made;
  made.points = surface.points;
  for (std::size_t f = 0; f < surface.faces(); ++f) {
    if (random() % 8 < left_out) continue;
    FaceCorners face = corners_of(surface, f);
    if (random() % 8 < reversed) std::reverse(face.begin(), face.end());
    made.add_face(face);
  }
  return made;
}

Shuffled shuffled(const PolygonSoup& soup, std::mt19937& random, bool faces_too) {
  Shuffled result;
  result.point_to.resize(soup.points);
  std::iota(result.point_to.begin(), result.point_to.end(), 0U);
  std::shuffle(result.point_to.begin(), result.point_to.end(), random);
  std::vector<std::size_t> order(soup.faces());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (faces_too) std::shuffle(order.begin(), order.end(), random);
  result.soup.points = soup.points;
  result.face_to.resize(soup.faces());
  for (const std::size_t f : order) {
    FaceCorners face = corners_of(soup, f);
    for (std::uint32_t& corner : face)
      if (corner < soup.points) corner = result.point_to[corner];
    turn(face, random);
    result.face_to[f] = result.soup.faces();
    result.soup.add_face(face);
  }
  return result;
}

std::string text(const PolygonSoup& soup) {
  std::string all = std::to_string(soup.points) + " points:";
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    if (f > 0) all += " |";
    for (const std::uint32_t corner : soup.face(f)) all += ' ' + std::to_string(corner);
  }
  return all;
}

std::vector<SoupDefect> defects_by_brute_force(const PolygonSoup& soup) {
  auto [defects, faces] = faults_of(soup);
  const Edges edges = edges_of(soup, faces);
  const auto faces_at = [](const std::vector<Side>& sides) {
    std::vector<std::size_t> at;
    for (const Side& s : sides) at.push_back(s.face);
    return at;
  };
  for (const auto& [ends, sides] : edges)
    if (sides.size() > 2)
      defects.push_back({SoupDefectKind::non_manifold_edge, {ends.first, ends.second}, faces_at(sides)});
  for (const auto& [ends, sides] : edges)
    if (sides.size() == 2 && sides[0].ascending == sides[1].ascending)
      defects.push_back({SoupDefectKind::inconsistent_orientation, {ends.first, ends.second}, faces_at(sides)});
  for (const std::size_t first : not_orientable(faces, edges))
    defects.push_back({SoupDefectKind::not_orientable, {}, {first}});
  std::map<std::uint32_t, std::set<std::size_t>> fans_at;  // the first faces of the fans
  for (const auto& [corner, fan] : fans_of(soup, faces, edges, true))
    fans_at[soup.face(corner.first)[corner.second]].insert(fan.first);
  for (const auto& [point, firsts] : fans_at)
    if (firsts.size() > 1) defects.push_back({SoupDefectKind::pinch, {point}, {firsts.begin(), firsts.end()}});
  return defects;
}

BettiNumbers betti_by_brute_force(const Cells& cells) {
  const auto r1 = static_cast<long>(rank_of_boundary(cells.edges, cells.vertices));
  const auto r2 = static_cast<long>(rank_of_boundary(cells.faces, cells.edges.size()));
  return {static_cast<long>(cells.vertices) - r1, static_cast<long>(cells.edges.size()) - r1 - r2,
          static_cast<long>(cells.faces.size()) - r2};
}

TopologyReport report_by_brute_force(const PolygonSoup& soup) {
  const std::vector<std::size_t> faces = faults_of(soup).good;
  const Edges edges = edges_of(soup, faces);
  TopologyReport total;

  // The whole complex as a space.
  Cells space;
  space.vertices = soup.points;
  std::map<Ends, std::size_t> number;
  for (const auto& [ends, sides] : edges) {
    number[ends] = space.edges.size();
    space.edges.push_back({ends.first, ends.second});
  }
  std::set<std::uint32_t> used;
  for (const std::size_t f : faces) {
    const FaceCorners face = corners_of(soup, f);
    used.insert(face.begin(), face.end());
    space.faces.emplace_back();
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::uint32_t from = face[i], to = face[(i + 1) % face.size()];
      space.faces.back().push_back(number[{std::min(from, to), std::max(from, to)}]);
    }
  }
  total.vertices = soup.points;
  total.edges = edges.size();
  total.faces = faces.size();
  total.isolated = soup.points - used.size();
  total.betti = betti_by_brute_force(space);
  total.components = static_cast<std::size_t>(total.betti[0]);
  for (const SoupDefect& defect : defects_by_brute_force(soup))
    if (defect.kind == SoupDefectKind::pinch) ++total.pinches;

  // Each piece is a space of its own: vertices are fans, and sides are edges, of which two at one edge are one.
  const auto piece_of = pieces_of(faces, edges);
  const auto fan_of = fans_of(soup, faces, edges, false);
  const auto flat = not_orientable(faces, edges);
  std::set<std::size_t> firsts;
  for (const auto& [face, piece] : piece_of) firsts.insert(piece);
  total.genus = 0;
  for (const std::size_t first : firsts) {
    Cells cells;
    std::map<Corner, std::size_t> vertex;
    for (const auto& [corner, fan] : fan_of)
      if (piece_of.at(corner.first) == first) vertex.try_emplace(fan, vertex.size());
    cells.vertices = vertex.size();
    std::map<std::size_t, std::vector<std::size_t>> sides_of_face;
    std::vector<std::size_t> open;
    std::vector<std::pair<std::size_t, std::size_t>> links;
    const auto add_edge = [&](const Side& s) {
      const std::size_t a = vertex.at(fan_of.at({s.face, s.low_corner(soup)})),
                        b = vertex.at(fan_of.at({s.face, s.high_corner(soup)}));
      cells.edges.push_back({a, b});
    };
    for (const auto& [ends, sides] : edges) {
      if (sides.size() == 2 && piece_of.at(sides[0].face) == first) {
        for (const Side& s : sides) sides_of_face[s.face].push_back(cells.edges.size());
        add_edge(sides[0]);
      }
      if (sides.size() == 2) continue;
      for (const Side& s : sides) {
        if (piece_of.at(s.face) != first) continue;
        sides_of_face[s.face].push_back(cells.edges.size());
        add_edge(s);
        open.push_back(cells.edges.back()[0]);
        open.push_back(cells.edges.back()[1]);
        links.push_back({open.end()[-2], open.end()[-1]});
      }
    }
    for (const auto& [face, list] : sides_of_face) cells.faces.push_back(list);
    std::set<std::size_t> curves;
    for (const auto& [v, curve] : classes(open, links)) curves.insert(curve);
    ComponentReport piece;
    piece.vertices = cells.vertices;
    piece.edges = cells.edges.size();
    piece.faces = cells.faces.size();
    piece.boundary_curves = curves.size();
    piece.orientable = !flat.contains(first);
    piece.first_face = first;
    // The law of ComponentReport: the numbers that it computes from the counts agree with the matrices.
    if (piece.betti() != betti_by_brute_force(cells)) piece.faces = 0;
    total.boundary_curves += piece.boundary_curves;
    if (piece.orientable && total.genus)
      *total.genus += *piece.genus();
    else
      total.genus.reset();
    total.per_component.push_back(piece);
  }
  for (const auto& [ends, sides] : edges)
    if (sides.size() > 2) total.genus.reset();
  total.solid_components = total.per_component.size();
  return total;
}

}  // namespace meshops::test
