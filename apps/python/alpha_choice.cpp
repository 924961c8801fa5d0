#include "rbpa/base/alpha_choice.h"

#include <optional>
#include <string>

#include "python/module.h"
#include "rbpa/plane/choose_alpha.h"

namespace rbpa::python {
namespace {

/// Returns the rule that `text` names, with the options `cover` and `components`; nothing if it names no rule.
std::optional<AlphaChoice> alpha_rule(const std::string& text, double cover, std::size_t components) {
  std::optional<AlphaChoice> choice = parse_alpha_rule(text);
  if (!choice) return std::nullopt;
  choice->cover = cover;
  choice->max_components = components;
  return choice;
}

std::optional<double> choose_alpha_of(const Doubles& points, const AlphaChoice& choice, unsigned threads,
                                      const py::object& progress) {
  const auto input = points_of(points);
  return watched(input.size(), progress, [&](Watch& watch) {
    const Delaunay delaunay(input, {.threads = threads, .progress = watch.progress()});
    return choose_alpha(choice, delaunay, watch.until_stopped()).alpha;
  });
}

}  // namespace

void bind_alpha_choice(py::module_& module) {
  using py::arg;
  module.attr("EXPECTED_ALPHA") = std::string(expected_alpha);
  py::class_<AlphaChoice>(module, "AlphaChoice", "A radius, or the rule that chooses it.")
      .def(py::init([](double radius) { return AlphaChoice{.radius = radius}; }), arg("radius"))
      .def_readonly("radius", &AlphaChoice::radius)
      .def_property_readonly("is_given", [](const AlphaChoice& choice) { return choice.rule == AlphaRule::given; })
      .def_property_readonly("is_plateau", [](const AlphaChoice& choice) { return choice.rule == AlphaRule::plateau; })
      .def_property_readonly("takes_cover", [](const AlphaChoice& choice) { return takes_cover(choice.rule); })
      .def_property_readonly("takes_components",
                             [](const AlphaChoice& choice) { return takes_components(choice.rule); });
  module.def("alpha_rule", &alpha_rule, arg("text"), arg("cover"), arg("components"));
  module.def("choose_alpha", &choose_alpha_of, as_is("points"), arg("choice"), arg("threads"), arg("progress"));
}

}  // namespace rbpa::python
