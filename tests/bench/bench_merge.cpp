// Measures the bytes that machines exchange when tiles are merged two by two, by level of the tree: on generated
// ground, and by a model of three numbers that is calibrated on another piece of ground. Prints the tables of
// docs/scale.md, section 3, as Markdown, and the data of its figure as CSV.
//   bench_merge [--across=10] [--side=128] [--alpha=2] [--seed=1] [--calibrate=24] [--predict=1000] [FILE.csv]
//     --across N     N × N tiles are computed and merged
//     --calibrate N  N × N tiles of another seed give the model its numbers
//     --predict N    the model's prediction for N × N
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <string>

#include "bench/arguments.h"
#include "bench/machine.h"
#include "bench/merge_run.h"

namespace rbpa_bench {
namespace {

struct MergeArguments {
  std::int64_t across = 10, side = 128, calibrate = 24, predict = 1000;
  double alpha = 2;
  std::uint64_t seed = 1;
  std::string file = {};
};

/// Model of the bytes of a Partial: a number for each part, for each spacing of its border inside the ground, and for
/// each spacing of its border at the end of the ground. A border counts by the share of squares in the block that have
/// a point, because no border runs through water.
struct Model {
  static constexpr std::size_t size = 3;
  std::array<double, size> of = {};
  double share = 1;  ///< share of the whole ground

  static std::array<double, size> features(const MergePlan& plan, const TileBlock& block, double share) {
    return {1, share * plan.inner_border(block), share * plan.outer_border(block)};
  }
  double bytes(const MergePlan& plan, const TileBlock& block, double of_block) const {
    const auto values = features(plan, block, of_block);
    double sum = 0;
    if (block.tiles() == plan.all().tiles()) return sum;
    for (std::size_t i = 0; i < size; ++i) sum += of[i] * values[i];
    return sum;
  }
};

double square(std::int64_t side) { return static_cast<double>(side) * static_cast<double>(side); }

double share_of(const MergePlan& plan, const MergedPart& part) {
  return part.points / (part.block.tiles() * square(plan.side));
}

/// Fits the model by least squares of its relative error, as a share of the mean of the level, so that each level has
/// the same weight. At the root no border is open.
Model fitted(const MergePlan& plan, const MergeRun& run) {
  constexpr std::size_t n = Model::size;
  struct Sum {
    double parts = 0, bytes = 0;
  };
  std::map<std::size_t, Sum> at;
  for (const MergedPart& part : run.parts) {
    ++at[part.depth].parts;
    at[part.depth].bytes += part.bytes;
  }
  double a[n][n + 1] = {};
  for (const MergedPart& part : run.parts) {
    if (part.depth == 0) continue;
    const auto x = Model::features(plan, part.block, share_of(plan, part));
    const Sum& sum = at[part.depth];
    const double weight = sum.parts / (sum.bytes * sum.bytes);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) a[i][j] += weight * x[i] * x[j];
      a[i][n] += weight * x[i] * part.bytes;
    }
  }
  for (std::size_t i = 0; i < n; ++i)  // positive definite: no pivot search is needed
    for (std::size_t j = 0; j < n; ++j) {
      if (j == i) continue;
      const double times = a[j][i] / a[i][i];
      for (std::size_t k = i; k <= n; ++k) a[j][k] -= times * a[i][k];
    }
  Model model;
  model.share = run.points / (plan.all().tiles() * square(plan.side));
  for (std::size_t i = 0; i < n; ++i) model.of[i] = a[i][n] / a[i][i];
  return model;
}

/// The data sent upward from a level.
struct Level {
  double parts = 0, tiles = 0, measured = 0, modelled = 0, largest = 0;
};
using Levels = std::map<std::size_t, Level>;

Levels levels_of(const MergePlan& plan, const MergeRun& run, const Model& model) {
  Levels levels;
  for (const MergedPart& part : run.parts) {
    Level& level = levels[part.depth];
    ++level.parts;
    level.tiles += part.block.tiles();
    level.measured += part.bytes;
    level.modelled += model.bytes(plan, part.block, share_of(plan, part));
    level.largest = std::max(level.largest, part.bytes);
  }
  return levels;
}

void predict(const MergePlan& plan, const Model& model, const TileBlock& block, std::size_t depth, Levels& levels) {
  const double bytes = model.bytes(plan, block, model.share);
  Level& level = levels[depth];
  ++level.parts;
  level.tiles += block.tiles();
  level.modelled += bytes;
  level.largest = std::max(level.largest, bytes);
  if (block.tiles() == 1) return;
  const auto [first, second] = halves_of(block);
  predict(plan, model, first, depth + 1, levels);
  predict(plan, model, second, depth + 1, levels);
}

class MergeBench {
 public:
  explicit MergeBench(const MergeArguments& arguments) : arguments_(arguments) {}

  void run() {
    std::printf("%s; %s; %s; %s `%s`; one thread.\n\n", today().c_str(), processor().c_str(), memory().c_str(),
                compiler().c_str(), compiler_flags().c_str());
    std::fflush(stdout);
    calibrate();
    measure();
    foretell();
  }

 private:
  MergePlan plan(std::int64_t across, std::uint64_t seed) const {
    return {across, arguments_.side, arguments_.alpha, seed};
  }

  void calibrate() {
    const MergePlan other = plan(arguments_.calibrate, arguments_.seed + 1);
    model_ = fitted(other, run_merges(other));
    std::printf(
        "Bytes of a Partial, by %.0f tiles of other ground: %.0f, and %.1f a spacing of its border inside, %.1f a "
        "spacing of "
        "that at the end of the ground, where %.0f %% of it has points.\n\n",
        square(arguments_.calibrate), model_.of[0], model_.of[1], model_.of[2], 100 * model_.share);
    std::fflush(stdout);
  }

  void measure() const {
    const MergePlan real = plan(arguments_.across, arguments_.seed);
    const MergeRun run = run_merges(real);
    const Levels levels = levels_of(real, run, model_);
    std::printf(
        "%.0f tiles of about %.0f points, α = %g: %.0f points, %.0f triangles; %.0f bytes of polygons and holes to "
        "storage. Processor: %.0f ns a point in tiles, %.2f in merges with their bytes.\n\n",
        square(arguments_.across), square(arguments_.side), arguments_.alpha, run.points, run.triangles,
        run.taken_bytes, 1e9 * run.tile_seconds / run.points, 1e9 * run.merge_seconds / run.points);
    std::printf(
        "| level | parts | tiles of each | bytes, measured | by the model | model / measured | the largest |\n"
        "|--:|--:|--:|--:|--:|--:|--:|\n");
    double measured = 0, modelled = 0;
    for (const auto& [depth, level] : levels) {
      if (depth == 0) continue;  // at the root no border is open
      std::printf("| %zu | %.0f | %.4g | %.0f | %.0f | %.2f | %.0f |\n", depth, level.parts, level.tiles / level.parts,
                  level.measured, level.modelled, level.modelled / level.measured, level.largest);
      measured += level.measured;
      modelled += level.modelled;
    }
    std::printf("| all | | | %.0f | %.0f | %.2f | |\n\n%.3f bytes a point.\n\n", measured, modelled,
                modelled / measured, measured / run.points);
    std::fflush(stdout);
    if (!arguments_.file.empty()) write(levels);
  }

  void foretell() const {
    const MergePlan large = plan(arguments_.predict, arguments_.seed);
    Levels levels;
    predict(large, model_, large.all(), 0, levels);
    std::printf(
        "%.0f tiles, by the model:\n\n| level | parts | tiles of each | bytes | the largest |\n"
        "|--:|--:|--:|--:|--:|\n",
        square(arguments_.predict));
    double all = 0;
    for (const auto& [depth, level] : levels) {
      if (depth == 0) continue;
      std::printf("| %zu | %.0f | %.4g | %.3g | %.3g |\n", depth, level.parts, level.tiles / level.parts,
                  level.modelled, level.largest);
      all += level.modelled;
    }
    std::printf("| all | | | %.3g | |\n", all);
  }

  /// Writes, for draw_figures, the mean Partial by its number of tiles.
  void write(const Levels& levels) const {
    std::ofstream file(arguments_.file);
    file << "# " << today() << "; " << square(arguments_.across) << " tiles of " << square(arguments_.side)
         << " points; the model is from " << square(arguments_.calibrate) << " tiles of other ground\n"
         << "# bytes of a Partial against the number of its tiles, mean by level of the tree of merges\n"
         << "tiles,measured,model\n";
    for (auto at = levels.rbegin(); at != levels.rend(); ++at) {
      if (at->first == 0) continue;
      const Level& level = at->second;
      const auto below = std::next(at);
      // The two lowest levels of an uneven tree can both have single tiles.
      if (below != levels.rend() && below->second.tiles / below->second.parts <= level.tiles / level.parts) continue;
      file << level.tiles / level.parts << ',' << level.measured / level.parts << ',' << level.modelled / level.parts
           << '\n';
    }
    if (!file.flush()) throw std::runtime_error(arguments_.file + ": cannot be written");
  }

  const MergeArguments& arguments_;
  Model model_ = {};
};

std::optional<MergeArguments> parse_merge(int argc, char** argv) {
  MergeArguments arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string_view given = argv[i];
    const auto count = [&](std::string_view name, std::int64_t least, std::int64_t most, std::int64_t& into) {
      const auto text = behind(given, name);
      return text && read_number(*text, into) && into >= least && into <= most;
    };
    if (count("--across=", 1, 4096, arguments.across) || count("--side=", 16, 4096, arguments.side) ||
        count("--calibrate=", 3, 4096, arguments.calibrate) || count("--predict=", 1, 4096, arguments.predict))
      continue;
    if (const auto text = behind(given, "--alpha=");
        text && read_number(*text, arguments.alpha) && arguments.alpha > 0 && arguments.alpha < 1e6)
      continue;
    if (const auto text = behind(given, "--seed="); text && read_number(*text, arguments.seed)) continue;
    if (!given.starts_with("-") && !given.empty()) {
      arguments.file = given;
      continue;
    }
    std::fprintf(stderr,
                 "%s: found '%s'\nusage: %s [--across=10] [--side=128] [--alpha=2] [--seed=1] [--calibrate=24] "
                 "[--predict=1000] [FILE.csv]\n",
                 argv[0], argv[i], argv[0]);
    return std::nullopt;
  }
  return arguments;
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  const auto arguments = rbpa_bench::parse_merge(argc, argv);
  if (!arguments) return 2;
  std::printf("`bench_merge");
  for (int i = 1; i < argc; ++i) std::printf(" %s", argv[i]);
  std::printf("`, ");
  try {
    rbpa_bench::MergeBench(*arguments).run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_merge: %s\n", error.what());
    return 1;
  }
  return 0;
}
