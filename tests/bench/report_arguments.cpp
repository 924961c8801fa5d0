#include "bench/report_arguments.h"

#include <cstdio>
#include <string_view>

#include "bench/arguments.h"

namespace rbpa_bench {
namespace {

bool read_peer(std::string_view text, std::vector<ReportArguments::Peer>& peers) {
  const std::size_t sign = text.find('=');
  if (sign == std::string_view::npos || sign == 0 || sign + 1 == text.size()) return false;
  peers.push_back({std::string(text.substr(0, sign)), std::string(text.substr(sign + 1))});
  return true;
}

bool take(std::string_view given, ReportArguments& into) {
  constexpr std::size_t fewest = 100;  // a tenth of these still makes triangles
  if (const auto text = behind(given, "--points=")) return read_number(*text, into.points) && into.points >= fewest;
  if (const auto text = behind(given, "--trap-points="))
    return read_number(*text, into.trap_points) && (into.trap_points == 0 || into.trap_points >= fewest);
  if (const auto text = behind(given, "--runs=")) return read_number(*text, into.runs) && into.runs > 0;
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
        "  --trap-points=N       100000; 0 for no traps\n"
        "  --runs=N              5\n"
        "  --threads=1,2         threads of rbpa, 0 for all; others are compared with the first\n"
        "  --large               also measure sixteen times the points\n"
        "  --check               compare sets of triangles, not only their numbers\n"
        "  --peer NAME=COMMAND   COMMAND IN OUT reads float64 pairs, writes uint32 triples (tests/bench/peer.h)\n",
        argv[0], given.c_str(), argv[0]);
    return std::nullopt;
  }
  return arguments;
}

}  // namespace rbpa_bench
