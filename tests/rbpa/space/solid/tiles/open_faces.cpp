// Faces that wait at corners, compared with a map of them, on the vector unit that all programs have.
#include <doctest/doctest.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

#include "rbpa/space/solid/tiles/open_faces-inl.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::space::HWY_NAMESPACE::OpenFace;
using rbpa::space::HWY_NAMESPACE::OpenFaces;

TEST_SUITE_BEGIN("space");

TEST_CASE("a face waits until the same face comes from the other side, however many wait at a corner") {
  Random random(3197);
  constexpr std::uint32_t nobody = 0, corners = 3;
  OpenFaces faces;
  std::size_t closed = 0, popped = 0, most = 0;
  for (int round = 0; round < 30; ++round) {
    faces.clear(corners);
    // For each corner, by the other two, ascending: the face as it was added.
    std::vector<std::map<std::pair<std::uint32_t, std::uint32_t>, OpenFace>> waiting(corners);
    const std::uint32_t others = 3 + static_cast<std::uint32_t>(random.below(9));
    for (int step = 0; step < 2000; ++step) {
      const auto v = static_cast<std::uint32_t>(random.below(corners));
      auto& here = waiting[v];
      most = std::max(most, here.size());
      const auto pick = [&] { return 100 + static_cast<std::uint32_t>(random.below(others)) * 6000; };
      const OpenFace face = {pick(), pick(), 4 + static_cast<std::uint32_t>(random.below(1u << 30))};
      if (face.first == face.second) continue;
      const auto key = std::minmax(face.first, face.second);
      const auto found = here.find(key);
      const auto add = [&](auto close_or_add) {
        const std::uint32_t other = close_or_add(face);
        if (found == here.end()) {
          CHECK(other == nobody);
          here.emplace(key, face);
        } else {
          CHECK(other == found->second.face);
          here.erase(found);
          ++closed;
        }
      };
      switch (random.below(6)) {
        case 0: {
          OpenFaces::AtCorner at(faces, v);
          CHECK(at.empty() == here.empty());
          if (here.empty()) break;
          const OpenFace one = at.pop();
          const auto expected = here.find(std::minmax(one.first, one.second));
          REQUIRE(expected != here.end());
          CHECK(one.first == expected->second.first);
          CHECK(one.second == expected->second.second);
          CHECK(one.face == expected->second.face);
          here.erase(expected);
          ++popped;
          break;
        }
        case 1:
        case 2: {
          OpenFaces::AtCorner at(faces, v);
          add([&](const OpenFace& f) { return at.close_or_add(f, nobody); });
          break;
        }
        default:
          add([&](const OpenFace& f) { return faces.close_or_add(v, f, nobody); });
      }
      CHECK(faces.empty(v) == here.empty());
    }
  }
  CHECK(closed > 1000);
  CHECK(popped > 1000);
  CHECK(most > 20);  // more than fit into a line
}

TEST_CASE("faces for which there was no room move to the line when others are closed") {
  OpenFaces faces;
  faces.clear(1);
  constexpr std::uint32_t count = 18, in_line = 15, nobody = 0;
  for (std::uint32_t i = 0; i < count; ++i) CHECK(faces.close_or_add(0, {1000 + i, 7, 8 * i + 4}, nobody) == nobody);
  for (std::uint32_t i = 0; i < in_line; ++i)
    CHECK(faces.close_or_add(0, {7, 1000 + i, 8 * i + 5}, nobody) == 8 * i + 4);
  for (std::uint32_t left = count - in_line; left > 0; --left) {
    REQUIRE(!faces.empty(0));
    OpenFaces::AtCorner at(faces, 0);
    CHECK(at.pop().first >= 1000 + in_line);
  }
  CHECK(faces.empty(0));
}

TEST_SUITE_END();
