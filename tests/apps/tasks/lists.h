// What: the lists of `rbpa stream --tasks` and their lines, run in this process.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "support/program.h"

namespace tasks_test {

/// Cuts "p.f64xy" of the folder for t.npy, p.geojson, p.wkt and s.json, into its folder "tasks".
void cut(const apps_test::Folder& folder, double alpha, std::uint64_t tile_size);

/// The lines of each list, in the order of the lists.
std::vector<std::vector<std::string>> lists_in(const std::string& tasks);

/// The words of a line as a POSIX shell has them.
std::vector<std::string> words_of(const std::string& line);

/// Does what the program would do, the first word of the line.
void run_line(const std::string& line);

/// The files of level 1, and what the last line writes.
std::vector<std::string> partials_of_tiles(const std::string& tasks);

/// `rbpa merge PARTIALS -o OUT ... --stats FILE`.
void merge(const std::vector<std::string>& partials, const std::vector<std::string>& outputs,
           const std::optional<std::string>& stats = std::nullopt);

}  // namespace tasks_test
