#include "bench/report_arguments.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <string_view>
#include <system_error>

namespace rbpa_bench {
namespace {

template <typename Number>
bool read(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

/// The text behind `name` in an argument that begins with it.
std::optional<std::string_view> behind(std::string_view given, std::string_view name) {
  if (!given.starts_with(name)) return std::nullopt;
  return given.substr(name.size());
}

bool read_threads(std::string_view list, std::vector<unsigned>& threads) {
  threads.clear();
  for (bool more = true; more;) {
    const std::size_t comma = std::min(list.find(','), list.size());
    more = comma < list.size();
    if (!read(list.substr(0, comma), threads.emplace_back())) return false;
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  return true;
}

bool read_peer(std::string_view text, std::vector<ReportArguments::Peer>& peers) {
  const std::size_t sign = text.find('=');
  if (sign == std::string_view::npos || sign == 0 || sign + 1 == text.size()) return false;
  peers.push_back({std::string(text.substr(0, sign)), std::string(text.substr(sign + 1))});
  return true;
}

bool take(std::string_view given, ReportArguments& into) {
  constexpr std::size_t fewest = 100;  // a tenth of them still make triangles
  if (const auto text = behind(given, "--points=")) return read(*text, into.points) && into.points >= fewest;
  if (const auto text = behind(given, "--trap-points="))
    return read(*text, into.trap_points) && (into.trap_points == 0 || into.trap_points >= fewest);
  if (const auto text = behind(given, "--runs=")) return read(*text, into.runs) && into.runs > 0;
  if (const auto text = behind(given, "--threads=")) return read_threads(*text, into.threads);
  if (const auto text = behind(given, "--peer=")) return read_peer(*text, into.peers);
  if (given == "--check") return into.check = true;
  if (given == "--large") return into.large = true;
  return false;
}

}  // namespace

std::optional<ReportArguments> parse_report(int argc, char** argv) {
  ReportArguments arguments;
  for (int i = 1; i < argc; ++i) {
    std::string given = argv[i];
    if (given == "--peer" && i + 1 < argc) given += std::string("=") + argv[++i];
    if (take(given, arguments)) continue;
    std::fprintf(
        stderr,
        "%s: found '%s'\n"
        "usage: %s [OPTIONS]\n"
        "  --points=N            1000000\n"
        "  --trap-points=N       10000; 0 for no traps\n"
        "  --runs=N              5\n"
        "  --threads=1,2         of rbpa, 0 for all; the first is what others are compared with; 1\n"
        "  --large               sixteen times as many points as well\n"
        "  --check               compare sets of triangles, not only their numbers\n"
        "  --peer NAME=COMMAND   COMMAND IN OUT reads float64 pairs, writes uint32 triples (tests/bench/peer.h)\n",
        argv[0], given.c_str(), argv[0]);
    return std::nullopt;
  }
  return arguments;
}

}  // namespace rbpa_bench
