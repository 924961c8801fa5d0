// README.md and the pages of docs show under a command what the command prints.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.h"

using namespace apps_test;

namespace {

const std::filesystem::path root = std::filesystem::path(RBPA_README).parent_path();

struct Shown {
  std::string program, arguments;
  std::string output;
};

/// The commands of the blocks ```console, which begin with "$ "; lines with "# " and empty ones before them are not
/// output.
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

/// README.md and the pages in all folders of docs, sorted.
std::vector<std::filesystem::path> pages() {
  std::vector<std::filesystem::path> found = {RBPA_README};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "docs"))
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

TEST_SUITE("readme") {
  TEST_CASE("the output of each command is that of a run, page by page in a folder of its own") {
    std::size_t count = 0;
    for (const std::filesystem::path& page : pages()) {
      CAPTURE(page.string());
      const Folder folder;
      std::filesystem::create_directory(folder.path("tests"));
      std::filesystem::create_directory_symlink(RBPA_TEST_DATA, folder.path("tests/data"));
      for (const Shown& command : commands_in(read_file(page.string()))) {
        ++count;
        CAPTURE(command.program);
        CAPTURE(command.arguments);
        const Outcome outcome = command.program == "rbpa"       ? folder.rbpa(command.arguments)
                                : command.program == "meshtopo" ? folder.meshtopo(command.arguments)
                                                                : folder.run(command.program, command.arguments);
        CHECK(outcome.code == 0);
        std::string output = outcome.out + outcome.err;
        for (std::size_t at; (at = output.find(folder.path(""))) != std::string::npos;)
          output.replace(at, folder.path("").size(), "/data/");
        CHECK(output == command.output);
      }
    }
    CHECK(count >= 25);
  }

  TEST_CASE("README begins with plateau; the page about alpha has plateau first, then auto") {
    const auto at = [](const std::string& page, const std::string& words) {
      const std::size_t place = page.find(words);
      CHECK_MESSAGE(place != std::string::npos, words);
      return place;
    };
    const std::string readme = read_file(RBPA_README);
    CHECK(at(readme, "$ rbpa shape") == at(readme, "$ rbpa shape tests/data/mol_2xhe_xy.xy --alpha plateau"));
    const std::string page = read_file((root / "docs/how_to/choose_alpha.md").string());
    CHECK(at(page, "**Which alpha to choose.** `plateau` first.") < at(page, "| you want | type |"));
    CHECK(at(page, "| `--alpha plateau`; ") < at(page, "| `--alpha auto`"));
  }
}
