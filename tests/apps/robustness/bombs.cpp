#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "robustness/moments.h"
#include "support/child.h"
#include "support/claiming_files.h"
#include "support/gzip.h"
#include "support/program.h"

using namespace apps_test;

namespace {

using Random = std::mt19937;

std::size_t below(std::size_t end, Random& random) {
  return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
}

/// Replaces a digit or a byte, mostly of the header.
std::string changed(std::string content, Random& random) {
  for (std::size_t changes = below(4, random); changes > 0; --changes) {
    char& c = content[below(std::min<std::size_t>(content.size(), 260), random)];
    const bool is_digit = c >= '0' && c <= '9';
    c = static_cast<char>(is_digit ? '0' + below(10, random) : below(256, random));
  }
  return content;
}

/// Runs a command on files followed by megabytes of filler, of which some or all may be claimed.
class Attack {
 public:
  Attack(std::vector<File> files, Child::Command before, Child::Command behind)
      : files_(std::move(files)), before_(std::move(before)), behind_(std::move(behind)) {}

  void run(Random& random) const {
    const std::vector<std::string> fillers = {std::string(1, '\0'), " ",    "\n", "0 ", "1 1 1\n",
                                              "3 0 1 2\n",          "\xFF", "x"};
    for (const File& file : files_) {
      const std::string content = changed(file.content, random), &filler = fillers[below(fillers.size(), random)];
      CAPTURE(file.name);
      CAPTURE(content);
      CAPTURE(filler);
      constexpr std::size_t mebibyte = std::size_t{1} << 20U;
      const Folder folder;
      Child::Command command = before_;
      command.push_back(folder.file(file.name + ".gz", bomb(content, filler, (1 + below(400, random)) * mebibyte)));
      command.insert(command.end(), behind_.begin(), behind_.end());
      folder.file("said", "");
      Child child(command, [&] {
        redirect(STDOUT_FILENO, "/dev/null", O_WRONLY);
        redirect(STDERR_FILENO, folder.path("said"), O_WRONLY | O_TRUNC);
        const rlimit both{256 * mebibyte, 256 * mebibyte};
        if (setrlimit(RLIMIT_AS, &both) != 0) _exit(125);
      });
      const Ending ending = child.wait();
      const std::string said = folder.content("said");
      CAPTURE(said);
      CHECK((ending == Ending{0, 0} || ending == Ending{3, 0}));
      if (ending.code == 3) CHECK(std::count(said.begin(), said.end(), '\n') == 1);
    }
  }

 private:
  std::vector<File> files_;
  Child::Command before_, behind_;
};

}  // namespace

TEST_SUITE("robustness") {
  TEST_CASE("a gzip file that decompresses to more than fits into memory ends the run with a message") {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    MESSAGE("SKIPPED: sanitizers take memory for themselves");
#else
    Random random(17);
    for (int moment = 0; moment < robustness::moments(); ++moment) {
      CAPTURE(moment);
      Attack(claiming_points(), {RBPA_PROGRAM, "info"}, {}).run(random);
      Attack(claiming_space(), {RBPA_PROGRAM, "surface"}, {"--radius", "1", "-o", "-", "--output-format", "off", "-q"})
          .run(random);
      Attack(claiming_meshes(), {MESHTOPO_PROGRAM}, {}).run(random);
    }
#endif
  }
}
