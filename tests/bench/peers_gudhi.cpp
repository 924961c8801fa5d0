#include <CGAL/Epick_d.h>
#include <gudhi/Alpha_complex.h>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

#include <limits>
#include <vector>

#include "bench/peers.h"

namespace rbpa_bench {

PersistenceRun persistence_by_gudhi(std::span<const rbpa::Point3> points) {
  using Kernel = CGAL::Epick_d<CGAL::Dimension_tag<3>>;
  using Tree = Gudhi::Simplex_tree<>;
  std::vector<Kernel::Point_d> own;
  own.reserve(points.size());
  for (const rbpa::Point3& p : points) own.emplace_back(p.x, p.y, p.z);
  PersistenceRun run;
  const Stopwatch watch;
  Gudhi::alpha_complex::Alpha_complex<Kernel> alpha_complex(own);
  Tree tree;
  alpha_complex.create_complex(tree, std::numeric_limits<double>::infinity(), /*exact=*/false);
  run.complex = watch.run(0);
  Gudhi::persistent_cohomology::Persistent_cohomology<Tree, Gudhi::persistent_cohomology::Field_Zp> cohomology(tree);
  cohomology.init_coefficients(2);
  cohomology.compute_persistent_cohomology(0);
  run.all = watch.run(0);
  for (const auto& [birth, death, field] : cohomology.get_persistent_pairs()) {
    const double from = tree.filtration(birth);
    const double to = death == tree.null_simplex() ? std::numeric_limits<double>::infinity() : tree.filtration(death);
    const int dimension = tree.dimension(birth);
    if (dimension < 3 && to > from * (1 + 1e-9)) ++run.pairs[static_cast<std::size_t>(dimension)];
  }
  return run;
}

}  // namespace rbpa_bench
