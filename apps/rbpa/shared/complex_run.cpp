#include "shared/complex_run.h"

#include <limits>

#include "io/bytes/available_memory.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "rbpa/plane/collinear.h"
#include "rbpa/rbpa.h"
#include "shared/arguments.h"

namespace rbpa::app {

ComplexRequest parse_request(const ComplexArguments& arguments, ChosenFor chosen_for) {
  return {.options = parse_run(arguments.run),
          .source = parse_source(arguments),
          .alpha = parse_alpha(arguments.radius, chosen_for),
          .method = parse_method(arguments.method),
          .width = parse_width(arguments.width)};
}

namespace {

/// Prints a warning, unless quiet, if the run takes more memory than is available.
void caution_about_memory(const Run& run, double bytes_a_point, std::size_t points) {
  const double wanted = bytes_a_point * static_cast<double>(points);
  const std::optional<double> there = available_memory();
  if (!there || wanted <= *there) return;
  run.warning(counted(points, "point") + (points == 1 ? " takes about " : " take about ") + bytes_text(wanted) +
              " of memory here, more than the " + bytes_text(*there) +
              " available (rbpa stream makes the same within the limit of its --memory)");
}

}  // namespace

ComplexRun::ComplexRun(const ComplexRequest& wanted, const OutputArguments& arguments)
    : Run(wanted.source.path, arguments.outputs, wanted.options), request(wanted) {
  const AlphaChoice& choice = request.alpha;
  file = read_points(request.source);
  if (request.check) request.check(file);
  stats.points = points().size();
  stats.read_seconds = lap();
  caution_about_memory(*this, request.bytes_a_point, points().size());
  stats.alpha = choose_alpha(choice, points(), options());
  if (choice.rule != AlphaRule::given) stats.choose_seconds = lap();
  // Take infinity if the rule finds no radius: the points have no triangle at any radius then.
  alpha = stats.alpha.value_or(std::numeric_limits<double>::infinity());
}

void ComplexRun::finish() {
  stats.alpha_rule = name_of(request.alpha);
  stats.threads = threads_used(points().size(), options().threads);
  stats.method = request.method.name();
  add_stats([&](OutputFile& report) { write_stats(report, stats); });
  publish();
}

std::string ComplexRun::why_empty(std::size_t distinct) const {
  return why_no_triangle(distinct, are_collinear(points(), until_interrupted()), alpha);
}

void ComplexRun::summarize(std::size_t duplicates, const std::string& made, const std::string& targets) const {
  Run::summarize(text_of_points(points().size(), duplicates) + ", " + made + alpha_text(request.alpha, stats.alpha) +
                 targets);
}

}  // namespace rbpa::app
