// What README.md and docs/which_alpha.md, tasks.md, fill.md, surface.md, cavities.md, persistence_in_space.md and lidar_footprint.md show under a command is what the command prints.
#include <doctest/doctest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.h"

using namespace apps_test;

namespace {

struct Shown {
  std::string program, arguments;
  std::string output;
};

/// The commands of the blocks ```console, which begin with "$ "; lines with "# " and empty ones before them are not output.
std::vector<Shown> commands_in(const std::string& page) {
  std::vector<Shown> commands;
  std::istringstream lines(page);
  bool inside = false;
  std::string empty;  // lines that belong to the output if more of it follows
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) inside = line == "```console";
    if (!inside || line.starts_with("```") || line.starts_with("# ") || line.starts_with("$ ")) empty.clear();
    if (!inside || line.starts_with("```") || line.starts_with("# ")) continue;
    if (line.empty()) {
      empty += "\n";
    } else if (line.starts_with("$ ")) {
      const std::size_t blank = line.find(' ', 2);
      commands.push_back({line.substr(2, blank - 2), line.substr(blank + 1), ""});
    } else {
      REQUIRE(!commands.empty());
      commands.back().output += empty + line + "\n";
      empty.clear();
    }
  }
  return commands;
}

}  // namespace

TEST_SUITE("readme") {
  TEST_CASE("the output of each command is that of a run") {
    const Folder folder;
    std::filesystem::create_directory(folder.path("tests"));
    std::filesystem::create_directory_symlink(RBPA_TEST_DATA, folder.path("tests/data"));
    const std::vector<Shown> of_readme = commands_in(read_file(RBPA_README));
    const std::filesystem::path root = std::filesystem::path(RBPA_README).parent_path();
    std::vector<Shown> commands;
    const std::pair<const char*, std::size_t> pages[] = {
        {"docs/which_alpha.md", 2},   {"docs/fill.md", 5},           {"docs/surface.md", 11},
        {"docs/scan_to_print.md", 4}, {"docs/cavities.md", 5},       {"docs/persistence_in_space.md", 1},
        {"docs/meshtopo.md", 1},      {"docs/lidar_footprint.md", 4}};
    for (const auto& page : pages) {
      CAPTURE(page.first);
      const std::vector<Shown> of_page = commands_in(read_file((root / page.first).string()));
      CHECK(of_page.size() == page.second);
      commands.insert(commands.end(), of_page.begin(), of_page.end());
    }
    CHECK(of_readme.size() >= 8);
    commands.insert(commands.end(), of_readme.begin(), of_readme.end());
    for (const Shown& command : commands) {
      CAPTURE(command.arguments);
      const Outcome outcome =
          command.program == "rbpa" ? folder.rbpa(command.arguments) : folder.meshtopo(command.arguments);
      CHECK((command.program == "rbpa" || command.program == "meshtopo"));
      CHECK(outcome.code == 0);
      CHECK(outcome.out + outcome.err == command.output);
      CHECK(!command.output.empty());
    }
  }

  TEST_CASE("which alpha to choose is said before the examples, plateau first; --cover comes later, with its warning") {
    const std::string readme = read_file(RBPA_README);
    const auto at = [](const std::string& page, const std::string& words) {
      const std::size_t place = page.find(words);
      CHECK_MESSAGE(place != std::string::npos, words);
      return place;
    };
    const std::string choose = "**Which alpha to choose:** `plateau` first.";
    CHECK(at(readme, choose) < at(readme, "```console"));
    CHECK(at(readme, "$ rbpa shape") == at(readme, "$ rbpa shape tests/data/mol_2xhe_xy.xy --alpha plateau"));
    // What the comment says of the example with --cover is what both examples print.
    const std::size_t cover = at(readme, "$ rbpa shape tests/data/mol_2xhe_xy.xy --alpha auto --cover 0.99");
    CHECK(at(readme, "12 parts and 29\n# pinholes, where plateau has 1 part and none.") < cover);
    CHECK(readme.find("12 polygons with 29 holes", cover) != std::string::npos);
    CHECK(at(readme, "1 polygon with 0 holes, area 3819.51, alpha plateau") < cover);
    const std::filesystem::path root = std::filesystem::path(RBPA_README).parent_path();
    const std::string page = read_file((root / "docs/which_alpha.md").string());
    CHECK(at(page, "**Which alpha to choose.** `plateau` first.") < at(page, "| you want | type |"));
    CHECK(at(page, "| `--alpha plateau`; ") < at(page, "| `--alpha auto`"));
  }

  TEST_CASE("so it is with tasks, which make runs") {
    const Folder folder;
    std::filesystem::create_directory(folder.path("tests"));
    std::filesystem::create_directory_symlink(RBPA_TEST_DATA, folder.path("tests/data"));
    const std::filesystem::path root = std::filesystem::path(RBPA_README).parent_path();
    const std::vector<Shown> commands = commands_in(read_file((root / "docs/tasks.md").string()));
    REQUIRE(commands.size() == 2);
    for (const Shown& command : commands) {
      CAPTURE(command.arguments);
      const Outcome outcome =
          command.program == "rbpa" ? folder.rbpa(command.arguments) : folder.run(command.program, command.arguments);
      CHECK(outcome.code == 0);
      std::string output = outcome.out + outcome.err;
      for (std::size_t at; (at = output.find(folder.path(""))) != std::string::npos;)
        output.replace(at, folder.path("").size(), "/data/");
      CHECK(output == command.output);
    }
  }
}
