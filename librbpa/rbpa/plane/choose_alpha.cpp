#include "rbpa/plane/choose_alpha.h"

#include "rbpa/plane/filtration.h"

namespace rbpa {

Covering covering_of(const AlphaChoice& choice) {
  Covering covering{.share = choice.cover};
  if (takes_components(choice.rule)) covering.max_components = choice.max_components;
  return covering;
}

ChosenAlpha choose_alpha(const AlphaChoice& choice, const Delaunay& delaunay, const GoOn& go_on) {
  if (choice.rule == AlphaRule::given) return {.alpha = choice.radius};
  if (choice.rule != AlphaRule::plateau) return {.alpha = smallest_covering(delaunay, covering_of(choice), go_on)};
  ChosenAlpha chosen{.plateaus = plateaus(delaunay, filtration(delaunay, go_on), go_on)};
  chosen.alpha = alpha_of_rank(choice, chosen.plateaus);
  return chosen;
}

}  // namespace rbpa
