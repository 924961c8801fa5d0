#include "bench/stream_arguments.h"

#include <cstdio>
#include <filesystem>
#include <string_view>

#include "bench/arguments.h"

namespace rbpa_bench {
namespace {

/// Parses a count such as "1000"; K, M or G at the end stand for thousands, millions and billions.
bool read_count(std::string_view text, std::uint64_t& count) {
  std::uint64_t unit = 1;
  if (text.ends_with('K')) unit = 1000;
  if (text.ends_with('M')) unit = 1'000'000;
  if (text.ends_with('G')) unit = 1'000'000'000;
  if (unit > 1) text.remove_suffix(1);
  if (!read_number(text, count) || count == 0 || count > 1'000'000'000'000 / unit) return false;
  count *= unit;
  return true;
}

bool read_one_of(std::string_view text, std::initializer_list<std::string_view> words, std::string& into) {
  into = text;
  return std::find(words.begin(), words.end(), text) != words.end();
}

bool take(std::string_view given, StreamArguments& into) {
  if (const auto text = behind(given, "--points=")) return read_count(*text, into.points);
  if (const auto text = behind(given, "--in-memory=")) return read_count(*text, into.in_memory);
  if (const auto text = behind(given, "--alpha=")) return read_number(*text, into.alpha) && into.alpha > 0;
  if (const auto text = behind(given, "--threads=")) return read_number(*text, into.threads) && into.threads > 0;
  if (const auto text = behind(given, "--files=")) return read_number(*text, into.files) && into.files > 0;
  if (const auto text = behind(given, "--seed=")) return read_number(*text, into.seed);
  if (const auto text = behind(given, "--input=")) return read_one_of(*text, {"f64xy", "npy"}, into.input);
  if (const auto text = behind(given, "--target=")) return read_one_of(*text, {"geojson", "wkt", "npy"}, into.target);
  if (const auto text = behind(given, "--ground=")) {
    into.ground = *text == "uniform" ? Ground::uniform : Ground::jittered;
    return *text == "uniform" || *text == "jittered";
  }
  for (const auto& [name, value] : {std::pair{"--memory=", &into.memory},
                                    {"--scratch=", &into.scratch},
                                    {"--trace=", &into.trace},
                                    {"--program=", &into.program}})
    if (const auto text = behind(given, name)) {
      *value = *text;
      return !text->empty();
    }
  if (given == "--keep") return into.keep = true;
  return false;
}

}  // namespace

std::optional<StreamArguments> parse_stream(int argc, char** argv) {
  StreamArguments arguments;
  arguments.program = (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "rbpa").string();
  for (int i = 1; i < argc; ++i) {
    if (take(argv[i], arguments)) continue;
    std::fprintf(stderr,
                 "%s: found '%s'\n"
                 "usage: %s [OPTIONS]\n"
                 "  --points=N         10M; K, M and G are thousands, millions and billions\n"
                 "  --in-memory=N      20M; largest number of points for the run in memory, 170 bytes each\n"
                 "  --memory=SIZE      1G; memory of rbpa stream\n"
                 "  --alpha=SPACINGS   2\n"
                 "  --threads=N        2\n"
                 "  --files=N          8; number of files of the input\n"
                 "  --input=FORMAT     f64xy, or npy\n"
                 "  --ground=KIND      jittered, or uniform\n"
                 "  --seed=N           1\n"
                 "  --target=FORMAT    geojson; or wkt, or npy for all triangles\n"
                 "  --scratch=DIR      .; folder for input, tiles and output\n"
                 "  --trace=FILE.csv   memory and disk over time\n"
                 "  --program=PATH     rbpa, beside this program\n"
                 "  --keep             keep the input in the scratch folder for another run\n",
                 argv[0], argv[i], argv[0]);
    return std::nullopt;
  }
  return arguments;
}

}  // namespace rbpa_bench
