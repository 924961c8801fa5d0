#include "rbpa/plane/partial.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"
#include "rbpa/plane/partial/rings.h"
#include "rbpa/plane/partial/state.h"

namespace rbpa {

Partial::Partial() : state_(std::make_unique<PartialState>()) {}
Partial::Partial(PartialState&& state) : state_(std::make_unique<PartialState>(std::move(state))) {}
Partial::Partial(const Partial& other) : state_(std::make_unique<PartialState>(other.state())) {}
Partial::Partial(Partial&& other) noexcept = default;
Partial& Partial::operator=(const Partial& other) { return *this = Partial(other); }
Partial& Partial::operator=(Partial&& other) noexcept = default;
Partial::~Partial() = default;

double Partial::alpha() const { return state_->alpha; }
PartialCounts Partial::counts() const { return state_->counts; }
bool Partial::is_whole() const { return state_->cover.is_whole(); }

RimSize Partial::rim() const {
  RimSize size{.triangles = state_->shared.size(),
               .components = state_->open.size(),
               .chains = state_->chains.size(),
               .polygons = state_->polygons.size() + state_->held.size()};
  for (const Chain& chain : state_->chains) size.corners += chain.path.size();
  for (const OpenComponent& component : state_->open)
    for (const CornerRing& ring : component.rings) size.corners += ring.size();
  return size;
}

bool comes_before(const CornerPolygon& a, const CornerPolygon& b) {
  return std::pair(a.shell[0].at, a.shell[1].at) < std::pair(b.shell[0].at, b.shell[1].at);
}

std::vector<CornerPolygon> take_settled(Partial& partial) {
  std::vector<CornerPolygon> settled = std::exchange(partial.state().polygons, {});
  std::sort(settled.begin(), settled.end(), comes_before);
  return settled;
}

std::vector<TakenHoles> take_holes(Partial& partial, std::size_t min_corners) {
  PartialState& state = partial.state();
  std::vector<TakenHoles> taken;
  std::uint32_t next = 0;
  for (const SharedTriangle& triangle : state.shared) {
    if (triangle.component != next) continue;  // components are numbered by their first triangle
    std::vector<CornerRing> holes = holes_out_of(state.open[next++], triangle.corners, min_corners);
    if (!holes.empty()) taken.push_back({.component = triangle.corners, .holes = std::move(holes)});
  }
  return taken;
}

WholeComplex finish(Partial&& partial) {
  const PartialState& state = partial.state();
  if (const std::optional<Point> place = state.cover.missing())
    throw InvalidInput("the regions do not cover the plane: none contains the area with the lower left corner (" +
                       text(place->x) + ", " + text(place->y) + ")");
  if (!state.shared.empty()) {
    const SharedTriangle& triangle = state.shared[0];
    const auto& [a, b, c] = triangle.corners;
    throw InvalidInput("triangle " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) +
                       " was found in the regions of " + std::to_string(triangle.owned) +
                       " of its corners, expected all 3: halos were not complete, or points differ");
  }
  return {.counts = state.counts, .polygons = take_settled(partial)};
}

}  // namespace rbpa
