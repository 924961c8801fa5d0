#include "meshops/topology/shortest_loops.h"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

#include "meshops/core/disjoint_sets.h"
#include "meshops/core/live.h"

namespace meshops {
namespace {

using Bits = std::vector<std::uint64_t>;

std::size_t number_of(Vertex v) { return static_cast<std::size_t>(v.idx()); }
std::size_t number_of(Edge e) { return static_cast<std::size_t>(e.idx()); }

/// Two spanning forests: a forest of the vertices, by union–find; a forest of the faces and the outside, breadth-first
/// across all other edges. An edge in neither closes a cycle of faces, which crosses every bounding loop an even number
/// of times.
class DualCycles {
 public:
  DualCycles(const Connectivity& mesh, const GoOn& go_on)
      : mesh_(mesh),
        step_(go_on),
        is_used_(mesh.n_edges(), false),
        reached_by_(mesh.n_faces() + 1),
        depth_(mesh.n_faces() + 1, none) {}

  HomologySignature operator()() {
    grow_over_vertices();
    grow_over_faces();
    std::vector<Edge> left;
    for_each_edge(mesh_, [&](Edge e) {
      if (!is_used_[number_of(e)]) left.push_back(e);
    });
    HomologySignature result{.loops = left.size(), .words = (left.size() + 63) / 64, .edges = {}};
    result.edges.assign(result.words * mesh_.n_edges(), 0);
    for (std::size_t i = 0; i < left.size(); ++i) {
      const auto flip = [&](Edge e) {
        step_();
        result.edges[number_of(e) * result.words + i / 64] ^= std::uint64_t{1} << i % 64;
      };
      flip(left[i]);
      std::array<std::size_t, 2> at = {node(left[i], 0), node(left[i], 1)};
      while (at[0] != at[1]) {
        std::size_t& lower = depth_[at[0]] >= depth_[at[1]] ? at[0] : at[1];
        const Edge crossed = mesh_.edge_handle(reached_by_[lower]);
        flip(crossed);
        lower = node(crossed, node(crossed, 0) == lower ? 1 : 0);
      }
    }
    return result;
  }

 private:
  static constexpr std::size_t none = ~std::size_t{0};

  /// Returns the face on a side of an edge. The number of faces stands for the outside.
  std::size_t node(Edge e, unsigned side) const {
    const Face f = mesh_.face_handle(mesh_.halfedge_handle(e, side));
    return f.is_valid() ? static_cast<std::size_t>(f.idx()) : mesh_.n_faces();
  }

  void grow_over_vertices() {
    DisjointSets joined(mesh_.n_vertices());
    for_each_edge(mesh_, [&](Edge e) {
      step_();
      const Halfedge h = mesh_.halfedge_handle(e, 0);
      if (joined.join(static_cast<std::uint32_t>(mesh_.from_vertex_handle(h).idx()),
                      static_cast<std::uint32_t>(mesh_.to_vertex_handle(h).idx())))
        is_used_[number_of(e)] = true;
    });
  }

  void grow_over_faces() {
    std::vector<std::size_t> queue;
    const auto reach = [&](Halfedge by, std::size_t from, std::size_t to) {
      if (depth_[to] != none || is_used_[number_of(mesh_.edge_handle(by))]) return;
      is_used_[number_of(mesh_.edge_handle(by))] = true;
      depth_[to] = depth_[from] + 1;
      reached_by_[to] = by;
      queue.push_back(to);
    };
    const std::size_t outside = mesh_.n_faces();
    depth_[outside] = 0;
    for_each_edge(mesh_, [&](Edge e) {
      step_();
      for (const unsigned side : {0U, 1U})
        if (node(e, side) == outside && node(e, 1 - side) != outside)
          reach(mesh_.halfedge_handle(e, 1 - side), outside, node(e, 1 - side));
    });
    std::size_t next = 0;
    const auto grow = [&] {
      for (; next < queue.size(); ++next)
        for (const Halfedge h : mesh_.fh_range(Face(static_cast<int>(queue[next])))) {
          step_();
          const Face across = mesh_.face_handle(mesh_.opposite_halfedge_handle(h));
          if (across.is_valid()) reach(h, queue[next], static_cast<std::size_t>(across.idx()));
        }
    };
    grow();
    for_each_face(mesh_, [&](Face f) {
      if (depth_[static_cast<std::size_t>(f.idx())] != none) return;
      depth_[static_cast<std::size_t>(f.idx())] = 0;
      queue.push_back(static_cast<std::size_t>(f.idx()));
      grow();
    });
  }

  const Connectivity& mesh_;
  Steps step_;
  std::vector<bool> is_used_;         // for each edge, whether it is in one of the forests
  std::vector<Halfedge> reached_by_;  // for each face: a halfedge of the edge across which it was reached
  std::vector<std::size_t> depth_;
};

/// Independent rows over Z/2. Each row has a leading bit that is not set in later rows.
class Z2Span {
 public:
  /// Adds the row unless it is a sum of rows added before. Returns: whether it was added.
  bool add(Bits row, Steps& step) {
    const auto lead = reduce(row, rows_.size(), step);
    if (lead) rows_.emplace_back(*lead, std::move(row));
    return lead.has_value();
  }
  /// Returns whether the row is a sum of the first `count` rows.
  bool contains(Bits row, std::size_t count, Steps& step) const { return !reduce(row, count, step); }

 private:
  /// Adds each of the first `count` rows to `row` if its leading bit is set in `row`. Returns the first bit left.
  std::optional<std::size_t> reduce(Bits& row, std::size_t count, Steps& step) const {
    step(1 + count * row.size() / 64);
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [lead, known] = rows_[i];
      if ((row[lead / 64] >> lead % 64 & 1) == 0) continue;
      for (std::size_t w = 0; w < row.size(); ++w) row[w] ^= known[w];
    }
    for (std::size_t w = 0; w < row.size(); ++w)
      if (row[w] != 0) return 64 * w + static_cast<std::size_t>(std::countr_zero(row[w]));
    return std::nullopt;
  }

  std::vector<std::pair<std::size_t, Bits>> rows_;
};

/// Loop from a root along a shortest path, across an edge, and back along a shortest path.
struct Candidate {
  double length;
  std::uint32_t root;
  Edge edge;
  Bits bits;
  Loop loop;

  bool is_before(const Candidate& other) const {
    return std::tuple(length, root, edge) < std::tuple(other.length, other.root, other.edge);
  }
};

/// The shortest known loops, in ascending order. Each is independent of the loops before it.
struct Basis {
  std::vector<Candidate> loops;
  Z2Span span;  // the span of `loops`, in their order

  /// Returns whether the candidate is a sum of loops that are before it, so that it is of no use.
  bool spans(const Candidate& candidate, Steps& step) const {
    const auto behind = std::upper_bound(loops.begin(), loops.end(), candidate,
                                         [](const Candidate& a, const Candidate& b) { return a.is_before(b); });
    return span.contains(candidate.bits, static_cast<std::size_t>(behind - loops.begin()), step);
  }
  /// Adds candidates, and removes loops that become a sum of loops before them. Requires: `more` ascends; not checked.
  void add(std::vector<Candidate> more, Steps& step) {
    if (more.empty()) return;
    std::vector<Candidate> all;
    std::merge(std::make_move_iterator(loops.begin()), std::make_move_iterator(loops.end()),
               std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()), std::back_inserter(all),
               [](const Candidate& a, const Candidate& b) { return a.is_before(b); });
    loops.clear();
    span = {};
    for (Candidate& candidate : all)
      if (span.add(candidate.bits, step)) loops.push_back(std::move(candidate));
  }
};

/// Search for shortest paths from one root after another, as far as a loop may be shorter than the known loops.
class LoopSearch {
 public:
  LoopSearch(const Connectivity& mesh, std::span<const double> lengths, const GoOn& go_on)
      : mesh_(mesh),
        lengths_(lengths),
        step_(go_on),
        signature_(homology_signature(mesh, go_on)),
        distance_(mesh.n_vertices(), infinity),
        reached_by_(mesh.n_vertices()),
        bits_(mesh.n_vertices() * signature_.words) {}

  std::size_t loops() const { return signature_.loops; }

  /// Adds to `known` the shortest independent loops through the root that are shorter than `limit`.
  void add_from(Vertex root, double limit, Basis& known) {
    grow(root, limit);
    std::vector<Candidate> candidates;
    for (const Vertex v : settled_)
      for (const Halfedge h : mesh_.voh_range(v)) {
        step_();
        // Each edge is taken once, from the start of its first halfedge.
        const Edge e = mesh_.edge_handle(h);
        if (mesh_.halfedge_handle(e, 0) != h || !is_settled(mesh_.to_vertex_handle(h)) || is_in_tree(h)) continue;
        const double length =
            distance_[number_of(v)] + lengths_[number_of(e)] + distance_[number_of(mesh_.to_vertex_handle(h))];
        if (!(length < limit)) continue;
        Bits bits = bits_across(h);
        if (std::any_of(bits.begin(), bits.end(), [](std::uint64_t word) { return word != 0; }))
          candidates.push_back({length, static_cast<std::uint32_t>(root.idx()), e, std::move(bits), {}});
      }
    std::sort(candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
      step_();
      return a.is_before(b);
    });
    // Most loops are homologous to a shorter loop from the same root, or are sums of known loops.
    std::set<Bits> seen;
    Z2Span found;
    std::vector<Candidate> chosen;
    for (Candidate& candidate : candidates)
      if (seen.insert(candidate.bits).second && !known.spans(candidate, step_) && found.add(candidate.bits, step_)) {
        candidate.loop = loop_of(mesh_.halfedge_handle(candidate.edge, 0));
        chosen.push_back(std::move(candidate));
      }
    known.add(std::move(chosen), step_);
    forget();
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  std::span<std::uint64_t> bits_of(Vertex v) {
    return std::span(bits_).subspan(number_of(v) * signature_.words, signature_.words);
  }
  bool is_settled(Vertex v) const { return is_settled_[number_of(v)]; }
  bool is_in_tree(Halfedge h) const {
    return reached_by_[number_of(mesh_.to_vertex_handle(h))] == h ||
           reached_by_[number_of(mesh_.from_vertex_handle(h))] == mesh_.opposite_halfedge_handle(h);
  }

  /// Runs Dijkstra's algorithm up to half of the limit: no end of an edge that closes a loop below the limit is farther
  /// (docs/reference/operators.md, section 8). The reach is slightly greater, because sums are rounded.
  void grow(Vertex root, double limit) {
    using Entry = std::pair<double, Vertex>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const double reach = limit * (0.5 + 1e-9);
    const auto offer = [&](Vertex v, double distance, Halfedge by) {
      if (!(distance < distance_[number_of(v)]) || distance > reach) return;
      if (distance_[number_of(v)] == infinity) touched_.push_back(v);
      distance_[number_of(v)] = distance;
      reached_by_[number_of(v)] = by;
      queue.emplace(distance, v);
    };
    offer(root, 0, Halfedge());
    while (!queue.empty()) {
      const auto [distance, v] = queue.top();
      queue.pop();
      step_();
      if (is_settled(v)) continue;
      is_settled_[number_of(v)] = true;
      settled_.push_back(v);
      const Halfedge by = reached_by_[number_of(v)];
      const std::span<std::uint64_t> bits = bits_of(v);
      std::fill(bits.begin(), bits.end(), 0);
      if (by.is_valid()) {
        const auto before = bits_of(mesh_.from_vertex_handle(by));
        const auto edge = signature_.of(mesh_.edge_handle(by));
        for (std::size_t w = 0; w < bits.size(); ++w) bits[w] = before[w] ^ edge[w];
      }
      for (const Halfedge h : mesh_.voh_range(v)) {
        step_();
        offer(mesh_.to_vertex_handle(h), distance + lengths_[number_of(mesh_.edge_handle(h))], h);
      }
    }
  }

  Bits bits_across(Halfedge h) {
    const auto a = bits_of(mesh_.from_vertex_handle(h)), b = bits_of(mesh_.to_vertex_handle(h));
    const auto edge = signature_.of(mesh_.edge_handle(h));
    Bits bits(signature_.words);
    for (std::size_t w = 0; w < bits.size(); ++w) bits[w] = a[w] ^ b[w] ^ edge[w];
    return bits;
  }

  /// Returns the loop that crosses the edge and runs to and from the root, without the common part of both paths.
  Loop loop_of(Halfedge closing) const {
    const auto to_root = [&](Vertex v) {
      std::vector<Halfedge> way;
      for (Halfedge h = reached_by_[number_of(v)]; h.is_valid();
           h = reached_by_[number_of(mesh_.from_vertex_handle(h))])
        way.push_back(h);
      return way;
    };
    std::vector<Halfedge> back = to_root(mesh_.to_vertex_handle(closing)),
                          out = to_root(mesh_.from_vertex_handle(closing));
    while (!back.empty() && !out.empty() && back.back() == out.back()) {
      back.pop_back();
      out.pop_back();
    }
    Loop loop = {closing};
    for (const Halfedge h : back) loop.push_back(mesh_.opposite_halfedge_handle(h));
    loop.insert(loop.end(), out.rbegin(), out.rend());
    return loop;
  }

  void forget() {
    for (const Vertex v : touched_) {
      distance_[number_of(v)] = infinity;
      reached_by_[number_of(v)] = Halfedge();
      is_settled_[number_of(v)] = false;
    }
    touched_.clear();
    settled_.clear();
  }

  const Connectivity& mesh_;
  std::span<const double> lengths_;
  Steps step_;
  HomologySignature signature_;
  std::vector<double> distance_;
  std::vector<Halfedge> reached_by_;
  Bits bits_;  // for each vertex, the bits of the path from the root to it
  std::vector<bool> is_settled_ = std::vector<bool>(distance_.size(), false);
  std::vector<Vertex> touched_, settled_;
};

/// Returns the ends of the edges, each once, ascending.
std::vector<Vertex> ends_of(const Connectivity& mesh, const std::vector<Edge>& edges) {
  std::vector<Vertex> ends;
  for (const Edge e : edges)
    for (const unsigned side : {0U, 1U}) ends.push_back(mesh.to_vertex_handle(mesh.halfedge_handle(e, side)));
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

}  // namespace

HomologySignature homology_signature(const Connectivity& mesh, const GoOn& go_on) { return DualCycles(mesh, go_on)(); }

std::vector<Loop> shortest_homology_basis(const Connectivity& mesh, std::span<const double> lengths,
                                          const GoOn& go_on) {
  return shortest_homology_loops(mesh, lengths, std::numeric_limits<double>::infinity(), go_on);
}

std::vector<Loop> shortest_homology_loops(const Connectivity& mesh, std::span<const double> lengths, double below,
                                          const GoOn& go_on) {
  const Homology known = homology(mesh, lengths, go_on);
  LoopSearch search(mesh, lengths, go_on);
  DisjointSets component(mesh.n_vertices());
  const auto number = [](Vertex v) { return static_cast<std::uint32_t>(v.idx()); };
  for_each_edge(mesh, [&](Edge e) {
    const Halfedge h = mesh.halfedge_handle(e, 0);
    component.join(number(mesh.from_vertex_handle(h)), number(mesh.to_vertex_handle(h)));
  });

  // The search from the first root of a component finds a basis of all loops of the component. The search from each
  // later root may replace loops by shorter ones; loops that are not shorter than all known loops are of no use. With a
  // finite limit, the known loops need not be a basis, and then do not bound the length of others.
  std::vector<Basis> best(mesh.n_vertices());  // for the least vertex of each component
  for (const Vertex root : ends_of(mesh, known.cut_graph)) {
    Basis& basis = best[component.find(number(root))];
    const bool is_basis = below == std::numeric_limits<double>::infinity() && !basis.loops.empty();
    search.add_from(root, is_basis ? basis.loops.back().length : below, basis);
  }
  std::vector<Candidate> all;
  for (Basis& basis : best)
    all.insert(all.end(), std::make_move_iterator(basis.loops.begin()), std::make_move_iterator(basis.loops.end()));
  std::sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.is_before(b); });
  std::vector<Loop> loops;
  for (Candidate& candidate : all) loops.push_back(std::move(candidate.loop));
  return loops;
}

}  // namespace meshops
