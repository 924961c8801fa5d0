// Whatever is done to files of a scratch, the next run makes the same bytes, or names the damage in one line.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <vector>

#include "robustness/moments.h"
#include "stream/scratch_file.h"
#include "support/child.h"
#include "support/program.h"
#include "support/random.h"

using namespace apps_test;
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

/// Points in a square with holes, and their results.
class Place {
 public:
  /// Points in each of the two files; enough on a fast machine to kill a run in the middle.
  explicit Place(std::size_t points = 30'000) {
    rbpa_test::Random random(31);
    const auto side = static_cast<std::uint64_t>(100'000 * std::sqrt(static_cast<double>(points) / 30'000));
    for (const char* name : {"a.f64xy", "b.f64xy"}) {
      std::vector<double> values(2 * points);
      for (double& value : values) value = double(random.below(side)) / 100;
      folder_.file(name, {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)});
    }
    REQUIRE(ended({}) == Ending{0, 0});
    triangles_ = folder_.content("t.npy");
    polygons_ = folder_.content("p.wkt");
    forget();
  }

  const Folder& folder() const { return folder_; }
  std::string scratch(const std::string& name = "") const { return folder_.path("scratch" + name); }
  std::vector<std::string> command(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {RBPA_PROGRAM,
                                      "stream",
                                      folder_.path("a.f64xy"),
                                      folder_.path("b.f64xy"),
                                      "--alpha",
                                      "4.5",
                                      "--tile-size",
                                      "100",
                                      "-o",
                                      folder_.path("t.npy"),
                                      "-o",
                                      folder_.path("p.wkt"),
                                      "--threads",
                                      "2",
                                      "-q"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  /// Returns how a run ends; one that hangs is killed.
  Ending ended(const std::vector<std::string>& more) const {
    Child child(command(more), [this] {
      redirect(STDERR_FILENO, folder_.path("said"), O_WRONLY | O_CREAT | O_TRUNC);
      alarm(120);
    });
    return child.wait();
  }
  std::vector<std::string> with_scratch() const { return {"--scratch", scratch(), "--keep-tiles", "--resume"}; }
  Ending resumed() const { return ended(with_scratch()); }
  std::string said() const { return folder_.content("said"); }

  /// Checks the law: the same bytes, or one line and no output.
  void check(const Ending& ending) const {
    const std::string text = said();
    CAPTURE(text);
    REQUIRE(ending.by_itself());
    if (ending.code == 0) {
      CHECK(text.empty());
      CHECK(folder_.content("t.npy") == triangles_);
      CHECK(folder_.content("p.wkt") == polygons_);
    } else {
      CHECK((ending.code == 1 || ending.code == 3));
      CHECK(std::count(text.begin(), text.end(), '\n') == 1);
      CHECK(text.find(": found ") + text.find(": cannot ") != 2 * std::string::npos);
      CHECK(!folder_.has("t.npy"));
      CHECK(!folder_.has("p.wkt"));
    }
  }
  void forget() const {
    for (const char* name : {"t.npy", "p.wkt", "said"}) fs::remove(folder_.path(name));
    fs::remove_all(scratch());
  }
  /// Scratch folders of runs that were killed in different passes, and of one that has kept its tiles.
  std::vector<std::string> beginnings(std::size_t count) const {
    std::mt19937 random(32);
    std::vector<std::string> all;
    const auto keep = [&] {
      all.push_back(scratch(std::to_string(all.size())));
      fs::rename(scratch(), all.back());
      forget();
    };
    REQUIRE(resumed() == Ending{0, 0});
    keep();
    for (int tries = 0; tries < 50 && all.size() < count; ++tries) {
      Child child(command(with_scratch()));
      const bool waits_for_tiles = all.size() % 3 != 0;
      const std::string sign = scratch() + (waits_for_tiles ? "/progress.json" : "/manifest.json");
      while (!fs::exists(sign) && !child.has_ended()) usleep(200);
      usleep(static_cast<useconds_t>(random() % 20'000));
      if (!child.has_ended()) child.send(SIGKILL);
      if (!child.wait().by_itself() && fs::exists(scratch() + "/manifest.json")) keep();
      forget();
    }
    CHECK(all.size() > 1);
    return all;
  }
  void restore(const std::string& beginning) const {
    forget();
    fs::copy(beginning, scratch(), fs::copy_options::recursive);
  }

 private:
  Folder folder_;
  std::string triangles_, polygons_;
};

std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

void write(const std::string& path, const std::string& content) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
}

/// Damages a file in one way; kinds of which there are few are chosen more often.
std::string tamper(const std::string& folder, std::mt19937& random) {
  const std::vector<std::string> files = files_in(folder);
  std::vector<std::string> few;
  for (const std::string& file : files)
    if (!contains(file, "/tiles/")) few.push_back(file);
  const auto any = [&]() -> const std::string& {
    const std::vector<std::string>& of = random() % 3 > 0 && !few.empty() ? few : files;
    return of[random() % of.size()];
  };
  const std::string path = any();
  std::string content = read_file(path);
  const std::size_t at = content.empty() ? 0 : random() % content.size();
  switch (random() % 8) {
    case 0:
    case 1:
    case 2:
      if (!content.empty()) content[at] = char(content[at] ^ 1 << random() % 8);
      write(path, content);
      return "a bit of " + path;
    case 3:
      fs::resize_file(path, at);
      return "the end of " + path;
    case 4: {
      const std::string other = any(), of_other = read_file(other);
      write(path, of_other);
      write(other, content);
      return path + " and " + other;
    }
    case 5:
      write(path, content + content.substr(at));
      return "more of " + path;
    case 6:
      fs::remove(path);
      return "no " + path;
    default:
      fs::remove(path);
      if (random() % 2 == 0)
        mkfifo(path.c_str(), 0666);
      else
        fs::create_directory(path);
      return "something else instead of " + path;
  }
}

}  // namespace

TEST_CASE("a scratch that was tampered with gives the same bytes or one line") {
  const Place place(60'000);
  const bool nightly = robustness::moments() > 8;
  const std::vector<std::string> beginnings = place.beginnings(nightly ? 20 : 3);
  std::mt19937 random(33);
  int refused = 0;
  for (int round = 0; round < (nightly ? 400 : 10); ++round) {
    place.restore(beginnings[std::size_t(round) % beginnings.size()]);
    const std::string what = tamper(place.scratch(), random);
    CAPTURE(round);
    CAPTURE(what);
    const Ending ending = place.resumed();
    place.check(ending);
    if (ending.code != 0) ++refused;
  }
  CHECK(refused > 0);
}

TEST_CASE("damaged files of the scratch are bad input: named, with exit code 3") {
  const Place place(60'000);
  REQUIRE(place.resumed() == Ending{0, 0});
  fs::remove(place.folder().path("t.npy"));
  fs::remove(place.folder().path("p.wkt"));
  const std::string manifest = place.scratch() + "/manifest.json";
  write(manifest, read_file(manifest).insert(40, " "));
  CHECK(place.resumed() == Ending{3, 0});
  CHECK(contains(place.said(), "manifest.json: found a file that was truncated or changed, expected "));
  place.forget();

  // A run whose progress has triangles and polygons: later bytes in the files are not used when it is resumed.
  Child child(place.command(place.with_scratch()));
  const auto progress = [](const std::string& scratch) {
    const std::string text = rbpa::app::checked_content(scratch + "/progress.json");
    return text.empty() ? Json() : Json::parse(text);
  };
  const auto has_some = [&] {
    const Json now = progress(place.scratch());
    return !now.is_null() && now["rows"] > 0 && now["polygons"][0] > 0 && now["holes"][0] > 0;
  };
  while (!has_some() && !child.has_ended()) usleep(100);
  REQUIRE(!child.has_ended());
  child.send(SIGKILL);
  REQUIRE(!child.wait().by_itself());
  const std::string beginning = place.scratch("-begun");
  fs::rename(place.scratch(), beginning);
  const std::string generation = std::to_string(progress(beginning)["generation"].get<int>());
  const std::string partials = "/partials/" + std::string(6 - generation.size(), '0') + generation;
  REQUIRE(fs::exists(beginning + partials));
  for (const std::string& name : {std::string("/progress.json"), std::string("/triangles/000000"),
                                  std::string("/polygons"), std::string("/holes"), partials})
    for (const bool is_cut : {false, true}) {
      if (robustness::moments() <= 8 && is_cut != (name.size() % 2 == 0)) continue;  // by day one of the two
      CAPTURE(name);
      CAPTURE(is_cut);
      place.restore(beginning);
      const std::string path = place.scratch() + name;
      std::string content = read_file(path);
      REQUIRE(!content.empty());
      if (is_cut) {
        fs::resize_file(path, 0);
      } else {
        content[0] = char(content[0] ^ 2);
        write(path, content);
      }
      const Ending ending = place.resumed();
      CHECK(ending == Ending{3, 0});
      place.check(ending);
    }
}

TEST_CASE("a manifest that contradicts itself is refused, though its checksum is right") {
  const Place place(3'000);
  REQUIRE(place.resumed() == Ending{0, 0});
  fs::remove(place.folder().path("t.npy"));
  fs::remove(place.folder().path("p.wkt"));
  const std::string path = place.scratch() + "/manifest.json";
  const Json manifest = Json::parse(rbpa::app::checked_content(path));
  REQUIRE(manifest.at("tree").size() > 20);
  const auto first_tile = [](Json& json) -> Json& {
    for (Json& part : json["tree"])
      if (part[0] == 0) return part;
    return json["tree"][0];
  };
  const auto check = [&](const std::string& found, const std::function<void(Json&)>& change) {
    CAPTURE(found);
    Json json = manifest;
    change(json);
    rbpa::app::replace_checked(path, json.dump());
    const Ending ending = place.resumed();
    CHECK(ending == Ending{3, 0});
    place.check(ending);
    const std::string text = place.said();
    CAPTURE(text);
    CHECK(contains(text, "manifest.json: found no manifest of rbpa stream (" + found));
  };
  check("no tiles", [](Json& json) { json["tree"] = Json::array(); });
  check("a number of a part that is out of range or repeated", [](Json& json) { json["tree"][0][2] = 1'000'000; });
  check("a number of a part that is out of range or repeated", [](Json& json) { json["tree"][0][2] = 0; });
  check("a number of a part that is out of range or repeated",
        [](Json& json) { json["tree"][0][3] = json["tree"][0][2]; });
  check("a part of the plane without", [](Json& json) { json["tree"].push_back(json["tree"].back()); });
  check("a cut of an unknown kind", [](Json& json) { json["tree"][0][0] = 7; });
  check("a tile number that is too large or repeated", [&](Json& json) { first_tile(json)[2] = 1'000'000; });
  check("an unknown pass", [](Json& json) { json["pass"] = 9; });
  check("no workers", [](Json& json) { json["workers"] = 0; });
  check("more files", [](Json& json) { json["files_done"] = 3; });
  check("next_index above the number of points", [](Json& json) { json["next_index"] = 1'000'000; });
  check("files of other tiles", [](Json& json) { json["tiles"].erase(0); });
  check("tiles of more points", [](Json& json) { json["points"] = 5'999, json["next_index"] = 0; });
  check("tiles of fewer points", [](Json& json) { json["points"] = 6'001; });
  check("version 1, not ", [](Json& json) { json["version"] = 1; });
  check("[json.exception", [](Json& json) { json["tree"][0][1] = "x"; });
  check("[json.exception", [](Json& json) { json.erase("box"); });
  rbpa::app::replace_checked(path, manifest.dump());
  place.check(place.resumed());
}
