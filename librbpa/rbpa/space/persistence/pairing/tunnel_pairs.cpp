#include "rbpa/space/persistence/pairing/tunnel_pairs.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "rbpa/space/solid/solid.h"

namespace rbpa::space {

struct Tunnels::Boundary {
  std::array<ColumnEntry, 3> entries;  ///< entries of the column, ascending; 0 is no entry
  std::span<const ColumnEntry> span() const {
    return std::span(entries).subspan(
        static_cast<std::size_t>(std::count(entries.begin(), entries.end(), ColumnEntry{0})));
  }
};

Tunnels::Tunnels(const SolidFiltration& filtration, std::span<const std::uint32_t> order,
                 const std::vector<bool>& joins, const std::vector<bool>& makes_void, Steps& step)
    : filtration_(filtration),
      rank_(order.size()),
      joins_(joins),
      owner_(order.size(), Solid::none),
      kept_(order.size(), Solid::none) {
  for (std::uint32_t i = 0; i < order.size(); ++i) rank_[order[i]] = i + 1;
  for (std::uint32_t triangle = 0; triangle < filtration.triangles.size(); ++triangle) {
    step(makes_void[triangle] ? 1 : 8);
    if (!makes_void[triangle]) reduce(triangle);
  }
}

std::vector<std::uint32_t> Tunnels::cycle(std::uint32_t edge) const {
  std::vector<std::uint32_t> edges;
  const auto add = [&](std::span<const ColumnEntry> column) {
    for (const ColumnEntry entry : column) edges.push_back(edge_of(entry));
  };
  if (kept_[edge] != Solid::none)
    add(columns_[kept_[edge]]);
  else
    add(boundary_of(owner_[edge]).span());
  return edges;
}

bool Tunnels::is_boundary(std::span<const std::uint32_t> edges, std::uint32_t triangle) {
  std::vector<ColumnEntry> entries;
  for (const std::uint32_t edge : edges)
    if (!joins_[edge]) entries.push_back(column_entry(rank_[edge], edge));
  std::sort(entries.begin(), entries.end());
  column_.assign({});
  for (const ColumnEntry& entry : entries) column_.add({&entry, 1});
  for (ColumnEntry pivot; (pivot = column_.pivot()) != 0;) {
    const std::uint32_t edge = edge_of(pivot);
    if (owner_[edge] == Solid::none || is_triangle_before(triangle, owner_[edge])) return false;
    add_column_of(edge);
  }
  return true;
}

Tunnels::Boundary Tunnels::boundary_of(std::uint32_t triangle) const {
  Boundary boundary{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t edge = filtration_.edges_of[triangle][k];
    boundary.entries[k] = joins_[edge] ? 0 : column_entry(rank_[edge], edge);
  }
  std::sort(boundary.entries.begin(), boundary.entries.end());
  return boundary;
}

bool Tunnels::is_triangle_before(std::uint32_t a, std::uint32_t b) const {
  const double of_a = filtration_.triangle_alpha[a], of_b = filtration_.triangle_alpha[b];
  return of_a != of_b ? of_a < of_b : a < b;
}

void Tunnels::reduce(std::uint32_t triangle) {
  const Boundary boundary = boundary_of(triangle);
  ColumnEntry pivot = boundary.entries.back();
  if (pivot == 0) return;
  if (owner_[edge_of(pivot)] == Solid::none) {
    owner_[edge_of(pivot)] = triangle;
    return;
  }
  column_.assign(boundary.span());
  bool is_sum = false;
  for (; pivot != 0; pivot = column_.pivot()) {
    const std::uint32_t edge = edge_of(pivot), owner = owner_[edge];
    if (owner == Solid::none) return keep(edge, triangle, is_sum ? column_.ascending() : std::vector<ColumnEntry>());
    if (is_triangle_before(triangle, owner)) {
      // The current column is stored at this edge, and the reduction continues with the column that was stored.
      const std::vector<ColumnEntry> others = released(edge);
      std::vector<ColumnEntry> mine = column_.ascending();
      if (others.empty())
        column_.assign(boundary_of(owner).span());
      else
        column_.assign(others);
      column_.add(mine);
      keep(edge, triangle, is_sum ? std::move(mine) : std::vector<ColumnEntry>());
      triangle = owner;
    } else {
      add_column_of(edge);
    }
    is_sum = true;
  }
}

void Tunnels::add_column_of(std::uint32_t edge) {
  if (kept_[edge] == Solid::none)
    column_.add(boundary_of(owner_[edge]).span());
  else
    column_.add(columns_[kept_[edge]]);
}

/// Stores the reduced column of a triangle at its pivot, `edge`. An empty `column` stands for the triangle's boundary.
void Tunnels::keep(std::uint32_t edge, std::uint32_t triangle, std::vector<ColumnEntry> column) {
  owner_[edge] = triangle;
  if (column.empty()) return;
  if (free_.empty()) {
    free_.push_back(static_cast<std::uint32_t>(columns_.size()));
    columns_.emplace_back();
  }
  kept_[edge] = free_.back();
  free_.pop_back();
  columns_[kept_[edge]] = std::move(column);
}

/// Removes the column stored at an edge, and returns the column; empty if none is stored.
std::vector<ColumnEntry> Tunnels::released(std::uint32_t edge) {
  const std::uint32_t at = std::exchange(kept_[edge], Solid::none);
  if (at == Solid::none) return {};
  free_.push_back(at);
  return std::exchange(columns_[at], {});
}

}  // namespace rbpa::space
