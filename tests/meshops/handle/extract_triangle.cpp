#include "meshops/handle/extract_triangle.h"

#include <doctest/doctest.h>

#include "meshops/core/live.h"
#include "meshops/handle/destroy.h"
#include "meshops/handle/insert_triangle.h"
#include "support/check_sound.h"
#include "support/corpus.h"
#include "support/laws.h"

using namespace meshops;
using namespace meshops::test;

TEST_SUITE("extract_triangle") {
  TEST_CASE("extract_triangle leaves the same mesh as remove_triangle, for every triangle of every mesh") {
    std::size_t passages = 0;
    for (const Specimen& specimen : corpus()) {
      CAPTURE(specimen.name);
      TestMesh given;
      specimen.build(given);
      for (int f = 0; f<static_cast<int>(given.n_faces()); f += given.n_faces()> 100 ? 37 : 1) {
        if (!is_live(given, Face(f))) continue;
        TestMesh removed = given, extracted = given;
        remove_triangle(removed, Face(f));
        const TriangleRim rim = rim_of(extracted, Face(f));
        std::array<Vertex, 3> second;
        for (unsigned i = 0; i < 3; ++i)
          if (rim.is_passage[i]) {
            second[i] = extracted.new_vertex();
            ++passages;
          }
        extract_triangle(extracted, rim, second);
        // remove_triangle() also marks the corners without faces as deleted.
        for (const Vertex v : rim.corner)
          if (extracted.is_isolated(v)) extracted.status(v).set_deleted(true);
        check_sound(extracted);
        CHECK(count_topology(extracted) == count_topology(removed));
        CHECK(isomorphism_class(extracted) == isomorphism_class(removed));
      }
    }
    CHECK(passages > 10);
  }
}
