// What: visits every mesh of the corpus, whose name is shown with a failure.
#pragma once

#include <doctest/doctest.h>

#include "support/corpus.h"

namespace meshops::test {

/// Calls `visit(specimen, mesh)` for each of them, built.
template <typename Visit>
void on_corpus(const Visit& visit) {
  for (const Specimen& specimen : corpus()) {
    CAPTURE(specimen.name);
    TestMesh mesh = built(specimen);
    visit(specimen, mesh);
  }
}

}  // namespace meshops::test
