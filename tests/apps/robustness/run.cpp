#include "robustness/run.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <random>

namespace robustness {

using apps_test::Child;
using apps_test::Ending;
using apps_test::Folder;

std::vector<Run> runs_into_files() {
  return {{"mesh",
           RBPA_PROGRAM,
           {"mesh", "%p.f64xy", "--alpha", "inf", "-o", "%a.off", "-o", "%b.png", "--stats", "%stats.json", "-q"},
           "p.f64xy",
           {"a.off", "b.png", "stats.json"}},
          {"mesh --complex full",
           RBPA_PROGRAM,
           {"mesh", "%p.f64xy", "--alpha", "600", "--complex", "full", "-o", "%a.obj", "-o", "%b.npy", "-q"},
           "p.f64xy",
           {"a.obj", "b.npy", "b.edges.npy", "b.points.npy"}},
          {"mesh --method hrbpa",
           RBPA_PROGRAM,
           {"mesh", "%p.xy", "--alpha", "auto", "--method", "hrbpa", "--levels", "%levels.json", "-o", "%a.ply", "-q"},
           "p.xy",
           {"levels.json", "a.ply"}},
          {"shape",
           RBPA_PROGRAM,
           {"shape", "%p.xy", "--alpha", "0.02", "-o", "%a.geojson", "-o", "%b.svg", "--stats", "%stats.json", "-q"},
           "p.xy",
           {"a.geojson", "b.svg", "stats.json"}},
          {"stream",
           RBPA_PROGRAM,
           {"stream", "%p.f64xy", "--alpha", "0.02", "--tile-size", "2000", "-o", "%a.npy", "-o", "%b.geojson",
            "--stats", "%stats.json", "-q"},
           "p.f64xy",
           {"a.npy", "b.geojson", "stats.json"}},
          {"alpha",
           RBPA_PROGRAM,
           {"alpha", "%p.f64xy", "--json", "--persistence", "-o", "%a.svg", "--stats", "%stats.json", "-q"},
           "p.f64xy",
           {"a.svg", "stats.json"}},
          {"report",
           RBPA_PROGRAM,
           {"report", "%p.f64xy", "-o", "%a.html", "--stats", "%stats.json", "-q"},
           "p.f64xy",
           {"a.html", "stats.json"}},
          {"info", RBPA_PROGRAM, {"info", "%p.xy", "--stats", "%stats.json"}, "p.xy", {"stats.json"}},
          {"meshtopo", MESHTOPO_PROGRAM, {"%m.off", "--json", "-o", "%r.json"}, "m.off", {"r.json"}},
          {"meshtopo --repair",
           MESHTOPO_PROGRAM,
           {"%m.obj", "--repair", "-o", "%a.ply", "--generators", "%l.obj", "--json"},
           "m.obj",
           {"a.ply", "l.obj"}}};
}

std::vector<Run> runs_to_standard_output() {
  return {
      {"mesh",
       RBPA_PROGRAM,
       {"mesh", "%p.f64xy", "--alpha", "inf", "-o", "-", "--output-format", "obj", "-o", "%a.off", "-q"},
       "p.f64xy",
       {"a.off"}},
      {"shape",
       RBPA_PROGRAM,
       {"shape", "%p.xy", "--alpha", "0.02", "-o", "-", "--output-format", "svg", "--stats", "%stats.json", "-q"},
       "p.xy",
       {"stats.json"}},
      {"stream",
       RBPA_PROGRAM,
       {"stream", "%p.f64xy", "--alpha", "0.02", "-o", "-", "--output-format", "wkt", "-o", "%a.npy", "-q"},
       "p.f64xy",
       {"a.npy"}},
      {"alpha",
       RBPA_PROGRAM,
       {"alpha", "%p.f64xy", "--csv", "--stats", "%stats.json", "-q"},
       "p.f64xy",
       {"stats.json"}},
      {"report", RBPA_PROGRAM, {"report", "%p.xy", "-o", "-", "--stats", "%stats.json", "-q"}, "p.xy", {"stats.json"}},
      {"info", RBPA_PROGRAM, {"info", "%p.xy", "--json", "--stats", "%stats.json"}, "p.xy", {"stats.json"}},
      {"meshtopo", MESHTOPO_PROGRAM, {"%m.off", "--json", "--generators", "%l.json"}, "m.off", {"l.json"}},
      {"meshtopo --repair",
       MESHTOPO_PROGRAM,
       {"%m.obj", "--repair", "-o", "-", "--output-format", "off", "-q", "--generators", "%l.obj"},
       "m.obj",
       {"l.obj"}}};
}

void make_inputs(const Folder& folder) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<double> numbers(30000);
  for (double& number : numbers) number = coordinate(random);
  folder.file("p.f64xy", {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)});
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); i += 2)
    text += std::to_string(numbers[i]) + " " + std::to_string(numbers[i + 1]) + "\n";
  folder.file("p.xy", text);

  // A torus of squares, a few of which are missing.
  constexpr int rows = 120, columns = 120;
  std::string off, obj, faces_off;
  int faces = 0;
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < columns; ++k) {
      const double a = 2 * M_PI * i / rows, b = 2 * M_PI * k / columns, r = 3 + std::cos(b);
      const std::string place = std::to_string(r * std::cos(a)) + " " + std::to_string(r * std::sin(a)) + " " +
                                std::to_string(std::sin(b)) + "\n";
      off += place;
      obj.append("v ").append(place);
    }
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < columns; ++k) {
      if ((i * 37 + k * 11) % 5003 == 0) continue;
      const int corners[] = {i * columns + k, (i + 1) % rows * columns + k,
                             (i + 1) % rows * columns + (k + 1) % columns, i * columns + (k + 1) % columns};
      faces_off += "4";
      obj += "f";
      for (const int corner : corners) {
        faces_off.append(" ").append(std::to_string(corner));
        obj.append(" ").append(std::to_string(corner + 1));
      }
      faces_off += "\n";
      obj += "\n";
      ++faces;
    }
  folder.file("m.off",
              "OFF\n" + std::to_string(rows * columns) + " " + std::to_string(faces) + " 0\n" + off + faces_off);
  folder.file("m.obj", obj);
}

Child::Command command_of(const Run& run, const Folder& folder) {
  Child::Command command = {run.program};
  for (const std::string& word : run.arguments)
    command.push_back(word.starts_with('%') ? folder.path(word.substr(1)) : word);
  return command;
}

const Reference& reference_of(const Run& run, Input input) {
  static std::map<std::pair<std::vector<std::string>, Input>, Reference> known;
  Reference& reference = known[{run.arguments, input}];
  if (reference.seconds > 0) return reference;
  const Folder folder;
  make_inputs(folder);
  if (input == Input::half) shorten(folder.path(run.input));
  const auto start = std::chrono::steady_clock::now();
  Child child(command_of(run, folder),
              [&] { apps_test::redirect(STDOUT_FILENO, folder.path("printed"), O_WRONLY | O_CREAT); });
  reference.is_done = child.wait() == Ending{0, 0};
  if (input == Input::whole) REQUIRE(reference.is_done);
  reference.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  for (const std::string& name : run.outputs) reference.outputs[name] = folder.content(name);
  reference.printed = folder.content("printed");
  return reference;
}

void shorten(const std::string& path) { std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2); }

}  // namespace robustness
