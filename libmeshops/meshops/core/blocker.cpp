#include "meshops/core/blocker.h"

#include <array>

namespace meshops {
namespace {

/// Texts on a kind: its name, and the predicate that describe() puts after the element; # stands for the count.
struct Text {
  std::string_view name, predicate;
};

constexpr std::array<Text, 26> texts = {{
    {"no status", "the mesh needs status to mark what is deleted (request_status() requests every kind)"},
    {"none given", "both halfedges are left out"},
    {"missing", "does not exist or is deleted"},
    {"on boundary", "is on the boundary"},
    {"not on boundary", "is not on the boundary"},
    {"isolated", "is isolated"},
    {"wrong degree", "does not have # edges"},
    {"not triangle", "is not a triangle"},
    {"several fans", "has several fans (separate_fans() gives each a vertex)"},
    {"corner repeated", "is a corner of the face twice"},
    {"face on both sides", "lies on both sides of an edge"},
    {"same edge", "is the edge of both halfedges"},
    {"same curve", "is on the boundary curve of the other halfedge"},
    {"curve length", "is on a curve of # edges, and the other halfedge on one of another number"},
    {"curve too short", "is on a curve of two edges (glue() closes it)"},
    {"other face", "is not a side of the face of the other halfedge"},
    {"other vertex", "leaves another vertex than the other halfedge"},
    {"corners adjacent", "starts at a neighbor of the other corner: a face of two sides would be left"},
    {"named twice", "is named twice"},
    {"pinch", "is an inner edge between two boundary vertices, which would become a pinch"},
    {"loop edge", "would become a loop, with one vertex at both ends"},
    {"double edge", "would be joined to the same vertex by two edges"},
    {"double triangle", "would have the same corners as another triangle"},
    {"equal halves", "would be cut into two triangles with the same corners"},
    {"only edge left", "cannot be removed: nothing but an edge would be left of its component"},
    {"no triangulation", "has no triangulation: every one has an edge that is not allowed"},
}};

}  // namespace

std::string_view name(BlockerKind kind) { return texts[static_cast<std::size_t>(kind)].name; }

std::string describe(const Blocker& blocker) {
  std::string text(texts[static_cast<std::size_t>(blocker.kind)].predicate);
  if (blocker.kind <= BlockerKind::none_given) return text;
  if (const auto at = text.find('#'); at != std::string::npos) text.replace(at, 1, std::to_string(blocker.count));
  return std::string(name(blocker.element)) + ' ' + std::to_string(blocker.index) + ' ' + text;
}

}  // namespace meshops
