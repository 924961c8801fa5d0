#include "walk/model_operators.h"

#include <algorithm>

namespace meshops::test::by_definition {
namespace {

bool is_triangle(const Model& model, int f) { return model.faces[static_cast<std::size_t>(f)].size() == 3; }

int start(const Model& model, int h) { return model.from[static_cast<std::size_t>(h)]; }

/// Returns whether the faces at a vertex are all triangles.
bool has_triangles_only(const Model& model, int v) {
  const auto out = model.leaving(v);
  return std::all_of(out.begin(), out.end(),
                     [&](int h) { return model.is_boundary(h) || is_triangle(model, model.face_of(h)); });
}

void move_fan(Model& model, const std::vector<int>& fan, int v) {
  for (const int h : fan) model.from[static_cast<std::size_t>(h)] = v;
}

/// Returns the fan at the start of a side that contains the side.
std::vector<int> fan_of(const Model& model, int h) {
  for (const auto& fan : model.fans(start(model, h)))
    if (std::find(fan.begin(), fan.end(), h) != fan.end()) return fan;
  return {};
}

}  // namespace

std::string glue(Model& model, int first, int second) {
  if (!model.has_side(first) || !model.has_side(second)) return "no such side";
  if (first / 2 == second / 2) return "one edge";
  if (!model.is_boundary(first) || !model.is_boundary(second)) return "not on the boundary";
  const int a0 = start(model, first), b0 = model.to(first), a1 = model.to(second), b1 = start(model, second);
  model.replace(second ^ 1, first);
  model.erase_edge(second);
  model.rename_vertex(std::max(a0, a1), std::min(a0, a1));
  // An end may have another name now.
  const int b0_now = b0 == std::max(a0, a1) ? std::min(a0, a1) : b0;
  const int b1_now = b1 == std::max(a0, a1) ? std::min(a0, a1) : b1;
  model.rename_vertex(std::max(b0_now, b1_now), std::min(b0_now, b1_now));
  return "";
}

std::string unglue(Model& model, int h, Names names) {
  if (!model.has_side(h)) return "no such side";
  if (model.is_boundary(h) || model.is_boundary(h ^ 1)) return "on the boundary";
  const int a = start(model, h), b = model.to(h);
  const bool parts_a = model.is_on_boundary(a), parts_b = model.is_on_boundary(b);
  const int second = names.side(), inner = second ^ 1;
  model.add_edge(inner, a, b);
  model.replace(h, inner);
  for (const auto& [parts, out] : {std::pair(parts_a, inner), std::pair(parts_b, second)}) {
    if (!parts) continue;
    const int v = names.vertex();
    model.add_vertex(v);
    move_fan(model, fan_of(model, out), v);
  }
  return "";
}

std::string destroy_triangle(Model& model, int f) {
  if (!model.has_face(f)) return "no such face";
  if (!is_triangle(model, f)) return "not three sides";
  const Cycle sides = model.faces[static_cast<std::size_t>(f)];
  for (const int h : sides)
    if (!model.is_boundary(h ^ 1)) return "a side is glued";
  model.set_face(f, {});
  for (const int h : sides) model.has_vertex[static_cast<std::size_t>(start(model, h))] = 0;
  for (const int h : sides) model.erase_edge(h);
  return "";
}

std::string remove_triangle(Model& model, int f, const Model* left) {
  if (!model.has_face(f)) return "no such face";
  if (!is_triangle(model, f)) return "not three sides";
  const Cycle sides = model.faces[static_cast<std::size_t>(f)];
  std::vector<int> corners;
  for (const int h : sides) corners.push_back(start(model, h));
  model.set_face(f, {});
  for (const int h : sides)
    if (model.is_boundary(h ^ 1)) model.erase_edge(h);
  Names names(model);
  for (const int v : corners) {
    bool is_kept = false;
    const auto fans = model.fans(v);
    for (const auto& fan : fans) {
      int name = is_kept ? names.vertex() : v;
      if (left) name = left->from[static_cast<std::size_t>(fan.front())];
      is_kept = is_kept || name == v;
      model.add_vertex(name);
      move_fan(model, fan, name);
    }
    if (!is_kept && !fans.empty()) return "a vertex of the rest has lost its name";
    if (!is_kept) model.has_vertex[static_cast<std::size_t>(v)] = 0;
  }
  return "";
}

std::string close_curve(Model& model, int h, Names names) {
  if (!model.has_side(h)) return "no such side";
  if (!model.is_boundary(h)) return "not on the boundary";
  model.set_face(names.face(), model.curve(h));
  return "";
}

std::string open_curve(Model& model, int f) {
  if (!model.has_face(f)) return "no such face";
  model.set_face(f, {});
  return "";
}

std::string zip_curves(Model& model, int first, int second) {
  if (!model.has_side(first) || !model.has_side(second)) return "no such side";
  if (!model.is_boundary(first) || !model.is_boundary(second)) return "not on the boundary";
  const Cycle one = model.curve(first), other = model.curve(second);
  if (std::find(one.begin(), one.end(), second) != one.end()) return "one curve";
  if (one.size() != other.size()) return "of different length";
  for (std::size_t i = 0; i < one.size(); ++i) glue(model, one[i], other[(other.size() - i) % other.size()]);
  return "";
}

std::string split_edge(Model& model, int h, Names names) {
  if (!model.has_side(h)) return "no such side";
  const int o = h ^ 1, left = model.face_of(h), right = model.face_of(o);
  if ((left >= 0 && !is_triangle(model, left)) || (right >= 0 && !is_triangle(model, right))) return "not a triangle";
  const int b = model.to(h), v = names.vertex(), vb = names.side();
  model.add_vertex(v);
  model.add_edge(vb, v, b);
  model.from[static_cast<std::size_t>(o)] = v;
  if (left >= 0) {
    const Cycle sides = model.cycle(left, h);  // h, b→c, c→a
    const int vc = names.side();
    model.add_edge(vc, v, start(model, sides[2]));
    model.set_face(left, {h, vc, sides[2]});
    model.set_face(names.face(), {vb, sides[1], vc ^ 1});
  }
  if (right >= 0) {
    const Cycle sides = model.cycle(right, o);  // o, a→d, d→b
    const int vd = names.side();
    model.add_edge(vd, v, start(model, sides[2]));
    model.set_face(right, {o, sides[1], vd ^ 1});
    model.set_face(names.face(), {vb ^ 1, vd, sides[2]});
  }
  return "";
}

std::string split_face(Model& model, int f, int named, Names names) {
  if (!model.has_face(f)) return "no such face";
  if (!is_triangle(model, f)) return "not a triangle";
  const Cycle sides = model.cycle(f, named);  // w→c, c→d, d→w
  const int v = names.vertex(), vw = names.side(), vc = names.side(), vd = names.side();
  model.add_vertex(v);
  model.add_edge(vw, v, start(model, sides[0]));
  model.add_edge(vc, v, start(model, sides[1]));
  model.add_edge(vd, v, start(model, sides[2]));
  model.set_face(f, {vc, sides[1], vd ^ 1});
  model.set_face(names.face(), {vw, sides[0], vc ^ 1});
  model.set_face(names.face(), {vw ^ 1, vd, sides[2]});
  return "";
}

std::string split_vertex(Model& model, int left, int right, const std::vector<int>& run, Names names) {
  const int w = start(model, left >= 0 ? left : right), v = names.vertex();
  model.add_vertex(v);
  move_fan(model, run, v);
  const int h = names.side();
  model.add_edge(h, v, w);
  if (left >= 0) {
    const int vc = names.side();
    model.add_edge(vc, v, model.to(left));
    model.replace(left, vc);
    model.set_face(names.face(), {h, left, vc ^ 1});
  }
  if (right >= 0) {
    const int vd = names.side();
    model.add_edge(vd, v, model.to(right));
    model.replace(right ^ 1, vd ^ 1);
    model.set_face(names.face(), {h ^ 1, vd, right ^ 1});
  }
  return "";
}

std::string flip(Model& model, int edge, bool back) {
  if (edge < 0 || static_cast<std::size_t>(edge) >= model.from.size() / 2) return "no such edge";
  const int h = 2 * edge, o = h + 1;
  if (!model.has_side(h)) return "no such edge";
  const int left = model.face_of(h), right = model.face_of(o);
  if (left < 0 || right < 0) return "on the boundary";
  if (!is_triangle(model, left) || !is_triangle(model, right)) return "not a triangle";
  const Cycle l = model.cycle(left, h), r = model.cycle(right, o);
  const int c = start(model, l[2]), d = start(model, r[2]);
  // Each face gives the other one the side at one end of the edge: if counter-clockwise, the side after it.
  model.set_face(left, back ? Cycle{h, r[2], l[1]} : Cycle{h, l[2], r[1]});
  model.set_face(right, back ? Cycle{o, l[2], r[1]} : Cycle{o, r[2], l[1]});
  model.add_edge(h, back ? c : d, back ? d : c);
  return "";
}

std::string collapse(Model& model, int h) {
  if (!model.has_side(h)) return "no such side";
  const int o = h ^ 1, left = model.face_of(h), right = model.face_of(o);
  if ((left >= 0 && !is_triangle(model, left)) || (right >= 0 && !is_triangle(model, right))) return "not a triangle";
  const int v = start(model, h), w = model.to(h);
  const Cycle l = left >= 0 ? model.cycle(left, h) : Cycle();    // v→w, w→c, c→v
  const Cycle r = right >= 0 ? model.cycle(right, o) : Cycle();  // w→v, v→d, d→w
  if (left >= 0) model.set_face(left, {});
  if (right >= 0) model.set_face(right, {});
  model.erase_edge(h);
  if (left >= 0 && right >= 0 && l[2] == (r[1] ^ 1)) {
    // Both faces have the same apex. The edge from v to it is removed. Of the two edges from w to it, the one on the
    // right of h stays.
    model.erase_edge(l[2]);
    model.replace(l[1] ^ 1, r[2]);
    if (l[1] != (r[2] ^ 1)) model.erase_edge(l[1]);
  } else {
    if (left >= 0) {
      model.replace(l[2] ^ 1, l[1]);
      model.erase_edge(l[2]);
    }
    if (right >= 0) {
      model.replace(r[1] ^ 1, r[2]);
      model.erase_edge(r[1]);
    }
  }
  model.rename_vertex(v, w);
  return "";
}

std::string weld_edge(Model& model, int h) {
  if (!model.has_side(h)) return "no such side";
  const int v = start(model, h);
  const std::size_t degree = model.leaving(v).size();
  if (model.is_on_boundary(v)) {
    if (!model.is_boundary(h) && !model.is_boundary(h ^ 1)) return "not along the boundary";
    if (degree != 3) return "not three edges";
  } else if (degree != 4) {
    return "not four edges";
  }
  return has_triangles_only(model, v) ? collapse(model, h) : "not a triangle";
}

std::string weld_face(Model& model, int v, int named) {
  if (v < 0 || static_cast<std::size_t>(v) >= model.has_vertex.size() || !model.has_vertex[static_cast<std::size_t>(v)])
    return "no such vertex";
  if (model.is_on_boundary(v)) return "on the boundary";
  if (model.leaving(v).size() != 3) return "not three edges";
  return has_triangles_only(model, v) ? collapse(model, named) : "not a triangle";
}

std::string insert_diagonal(Model& model, int from, int to, int named, Names names) {
  if (!model.has_side(from) || !model.has_side(to)) return "no such side";
  const int f = model.face_of(from);
  if (f < 0 || model.face_of(to) != f) return "not of one face";
  const Cycle sides = model.cycle(f, from);
  const auto middle = std::find(sides.begin(), sides.end(), to);
  Cycle first(sides.begin(), middle), second(middle, sides.end());
  const int diagonal = names.side();
  model.add_edge(diagonal, start(model, from), start(model, to));
  first.push_back(diagonal ^ 1);
  second.push_back(diagonal);
  const bool keeps_first = std::find(first.begin(), first.end(), named) != first.end();
  model.set_face(f, keeps_first ? first : second);
  model.set_face(names.face(), keeps_first ? second : first);
  return "";
}

std::string remove_diagonal(Model& model, int h) {
  if (!model.has_side(h)) return "no such side";
  const int gone = model.face_of(h), stays = model.face_of(h ^ 1);
  if (gone < 0 || stays < 0) return "on the boundary";
  if (gone == stays) return "one face on both sides";
  const Cycle one = model.cycle(gone, h), other = model.cycle(stays, h ^ 1);
  Cycle sides(other.begin() + 1, other.end());
  sides.insert(sides.end(), one.begin() + 1, one.end());
  model.set_face(gone, {});
  model.set_face(stays, sides);
  model.erase_edge(h);
  return "";
}

}  // namespace meshops::test::by_definition
