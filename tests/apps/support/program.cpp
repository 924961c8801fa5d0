#include "support/program.h"

#include <doctest/doctest.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace apps_test {

Folder::Folder() {
  std::string name = (std::filesystem::temp_directory_path() / "rbpa-test-XXXXXX").string();
  REQUIRE(mkdtemp(name.data()) != nullptr);
  path_ = name;
}

Folder::Folder(std::initializer_list<std::pair<std::string, std::string>> files) : Folder() {
  for (const auto& [name, content] : files) file(name, content);
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::permissions(path_, std::filesystem::perms::owner_all, ignored);
  std::filesystem::remove_all(path_, ignored);
}

std::string Folder::file(const std::string& name, const std::string& content) const {
  std::ofstream(path_ / name, std::ios::binary) << content;
  return path(name);
}

std::string Folder::content(const std::string& name) const { return read_file(path(name)); }

std::vector<std::string> Folder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

Outcome Folder::run(const std::string& program, const std::string& arguments) const {
  const Folder streams;
  const std::string command = "cd '" + path_.string() + "' && '" + program + "' " + arguments + " >'" +
                              streams.path("out") + "' 2>'" + streams.path("err") + "'";
  const int status = std::system(command.c_str());
  REQUIRE(WIFEXITED(status));
  return {WEXITSTATUS(status), streams.content("out"), streams.content("err")};
}

Outcome Folder::run(const std::string& program, const std::string& arguments, int code) const {
  const Outcome outcome = run(program, arguments);
  CAPTURE(arguments);
  CAPTURE(outcome.err);
  REQUIRE(outcome.code == code);
  return outcome;
}

static void refuses(const Folder& folder, const std::string& program, const std::string& arguments, int code,
                    const std::string& line) {
  CAPTURE(arguments);
  const std::vector<std::string> before = folder.names();
  const Outcome outcome = folder.run(program, arguments);
  CHECK(outcome.code == code);
  CHECK(outcome.err == line + "\n");
  CHECK(outcome.out == "");
  CHECK(folder.names() == before);
}

void refuses(const Folder& folder, const std::string& arguments, int code, const std::string& message) {
  refuses(folder, RBPA_PROGRAM, arguments, code, "rbpa: " + message);
}

void meshtopo_refuses(const Folder& folder, const std::string& arguments, int code, const std::string& message) {
  refuses(folder, MESHTOPO_PROGRAM, arguments, code, "meshtopo: " + message);
}

static void has_part(const Outcome& outcome, const std::string& part) {
  CAPTURE(outcome.err);
  CHECK(contains(outcome.err, part));
}

void says(const Folder& folder, const std::string& arguments, int code, const std::string& part) {
  CAPTURE(arguments);
  has_part(folder.rbpa(arguments, code), part);
}

void meshtopo_says(const Folder& folder, const std::string& arguments, int code, const std::string& part) {
  CAPTURE(arguments);
  has_part(folder.meshtopo(arguments, code), part);
}

std::string read_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace apps_test
