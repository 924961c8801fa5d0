#include "meshops/front/waiting_edges.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "meshops/core/live.h"
#include "support/random.h"

using meshops::Halfedge;
using meshops::detail::WaitingEdges;

TEST_SUITE_BEGIN("front");

namespace {

/// Halfedges that are deferred, in the order of their last deferral, with its revision.
using Model = std::vector<std::pair<Halfedge, std::size_t>>;

void forget(Model& model, Halfedge h) {
  std::erase_if(model, [h](const auto& entry) { return entry.first == h; });
}

}  // namespace

TEST_CASE("a halfedge waits for the revision of its last deferral, in the order of last deferrals") {
  meshops::Connectivity mesh;
  meshops::request_status(mesh);
  std::vector<Halfedge> boundary;
  for (int t = 0; t < 2; ++t) {
    const meshops::Vertex a = mesh.add_vertex(), b = mesh.add_vertex(), c = mesh.add_vertex();
    mesh.add_face(a, b, c);
  }
  for (int i = 0; i < static_cast<int>(mesh.n_halfedges()); ++i)
    if (mesh.is_boundary(Halfedge(i))) boundary.emplace_back(i);
  REQUIRE(boundary.size() == 6);

  rbpa_test::Random random(17);
  for (int trial = 0; trial < 2000; ++trial) {
    CAPTURE(trial);
    WaitingEdges waiting(mesh);
    Model model;
    std::size_t revision = 0;
    for (int step = 0; step < 30; ++step) {
      const Halfedge h = boundary[random.below(boundary.size())];
      switch (random.below(6)) {
        case 0:
          waiting.queue(h);
          forget(model, h);
          break;
        case 1:
          ++revision;
          break;
        case 2: {
          const bool woken = waiting.wake_deferred(revision);
          CHECK(woken == std::any_of(model.begin(), model.end(), [&](const auto& e) { return e.second != revision; }));
          std::erase_if(model, [&](const auto& entry) { return entry.second != revision; });
          break;
        }
        case 3: {
          const Halfedge first = waiting.next_deferred();
          REQUIRE(first == (model.empty() ? Halfedge() : model.front().first));
          if (!first.is_valid()) break;
          waiting.release(first);
          model.erase(model.begin());
          break;
        }
        default:
          waiting.defer(h, revision);
          forget(model, h);
          model.emplace_back(h, revision);
      }
      for (const Halfedge b : boundary) {
        const bool is_in_model = std::any_of(model.begin(), model.end(), [b](const auto& e) { return e.first == b; });
        CHECK(waiting.is_deferred(b) == is_in_model);
      }
    }
  }
}

TEST_CASE("a queue that is set anew begins with its first halfedge") {
  meshops::Connectivity mesh;
  const meshops::Vertex a = mesh.add_vertex(), b = mesh.add_vertex(), c = mesh.add_vertex();
  mesh.add_face(a, b, c);
  const Halfedge first = mesh.find_halfedge(b, a), second = mesh.find_halfedge(c, b);
  WaitingEdges waiting(mesh);
  waiting.queue(first);
  CHECK(waiting.next() == first);
  waiting.release(first);
  waiting.queue_all({second});
  CHECK(waiting.next() == second);
}
