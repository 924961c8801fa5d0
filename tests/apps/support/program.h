// The programs as a user runs them, in a folder of its own.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "support/text.h"

namespace apps_test {

using rbpa_test::contains;
using rbpa_test::count_of;
using rbpa_test::split;

struct Outcome {
  int code;  ///< exit code
  std::string out;
  std::string err;
};

/// A fresh folder, empty or with some files, removed at the end.
class Folder {
 public:
  Folder();
  Folder(const std::string& name, const std::string& content) : Folder() { file(name, content); }
  /// From names and contents.
  Folder(std::initializer_list<std::pair<std::string, std::string>> files);
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string path(const std::string& name) const { return (path_ / name).string(); }
  /// Writes a file and returns its path.
  std::string file(const std::string& name, const std::string& content) const;
  std::string content(const std::string& name) const;
  bool has(const std::string& name) const { return std::filesystem::exists(path_ / name); }
  std::vector<std::string> names() const;  ///< of its files, sorted

  /// Run `rbpa ARGUMENTS` or `meshtopo ARGUMENTS` in this folder through the shell.
  Outcome rbpa(const std::string& arguments) const { return run(RBPA_PROGRAM, arguments); }
  Outcome meshtopo(const std::string& arguments) const { return run(MESHTOPO_PROGRAM, arguments); }
  /// Runs any program in this folder through the shell.
  Outcome run(const std::string& program, const std::string& arguments) const;

  /// Run a program so, and require that it ends with this code.
  Outcome rbpa(const std::string& arguments, int code) const { return run(RBPA_PROGRAM, arguments, code); }
  Outcome meshtopo(const std::string& arguments, int code) const { return run(MESHTOPO_PROGRAM, arguments, code); }
  Outcome run(const std::string& program, const std::string& arguments, int code) const;

 private:
  std::filesystem::path path_;
};

/// Check that `rbpa ARGUMENTS` or `meshtopo ARGUMENTS` ends with this code, that its only output is this line on
/// standard error, behind the name of the program, and that the folder has the same files as before.
void refuses(const Folder& folder, const std::string& arguments, int code, const std::string& message);
void meshtopo_refuses(const Folder& folder, const std::string& arguments, int code, const std::string& message);
/// Check that a program ends with this code, and that its messages have this part.
void says(const Folder& folder, const std::string& arguments, int code, const std::string& part);
void meshtopo_says(const Folder& folder, const std::string& arguments, int code, const std::string& part);

std::string read_file(const std::string& path);

/// Three points that form a triangle, for runs in which the points do not matter.
inline constexpr const char* corner = "0 0\n1 0\n0 1\n";

/// The end of a message about a line of a table that is no point: after another way to mend it, and alone.
inline const std::string skipping_way = "--skip-invalid leaves out lines that are not points)",
                         skipping_hint = " (" + skipping_way;

}  // namespace apps_test
