#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/bytes/write_json.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "rbpa/base/error.h"
#include "rbpa/space/balls/measure_ball_frames.h"
#include "shared/run.h"
#include "shared/stats.h"
#include "space/balls_files.h"
#include "space/balls_request.h"

namespace rbpa::app {
namespace {

/// Reads, measures and writes some frames at a time.
class BallsRun : public Run {
 public:
  BallsRun(const BallsArguments& arguments, BallsRequest request)
      : Run(request.path, arguments.outputs, request.run),
        arguments_(arguments),
        request_(std::move(request)),
        facts_{.probe = request_.probe, .radii = request_.radii} {}

  void run();

 private:
  std::vector<MeasuredAtoms> read_some(AtomFrames& file);
  void measure(std::vector<MeasuredAtoms>& some);
  void begin_files();
  void write(const MeasuredAtoms& frame);
  void require_groups() const;

  const BallsArguments& arguments_;
  BallsRequest request_;
  BallFacts facts_;
  AtomFrame texts_ = {};  // every frame is read into it
  std::vector<BallRows> tables_ = {};
  std::atomic<std::size_t> done_ = 0;  // atoms
  double read_seconds_ = 0, measure_seconds_ = 0, write_seconds_ = 0;
};

/// Throws BadInput if the atoms have no names by which they could be grouped.
void BallsRun::require_groups() const {
  if (request_.groups != AtomGroups::residue && request_.groups != AtomGroups::chain) return;
  const bool is_chain = request_.groups == AtomGroups::chain;
  const auto has_none = [&](const AtomRow& row) {
    return row.chain == 0 && (is_chain || (row.resname == 0 && std::isnan(row.resseq)));
  };
  if (std::all_of(texts_.rows.begin(), texts_.rows.end(), has_none))
    bad_input(input(), std::string("no ") + (is_chain ? "chains" : "residues") + " for --group",
              is_chain ? "some (--group residue, or column:NAME)" : "some (--group column:NAME takes any column)");
}

/// Reads frames until there is work for all threads; returns none at the end.
std::vector<MeasuredAtoms> BallsRun::read_some(AtomFrames& file) {
  constexpr std::size_t enough_atoms = 200'000;
  const std::size_t enough_frames = std::size_t{4} * options().threads_or_all();
  std::vector<MeasuredAtoms> some;
  for (std::size_t atoms = 0; atoms < enough_atoms && some.size() < enough_frames && file.next(texts_);) {
    if (tables_.empty() && some.empty()) require_groups();
    std::vector<double> radii = request_.radii.of(texts_, file.name());
    atoms += radii.size();
    some.push_back({texts_.number, std::move(texts_.rows), texts_.counts, std::move(radii)});
  }
  read_seconds_ += lap();
  return some;
}

void BallsRun::measure(std::vector<MeasuredAtoms>& some) {
  std::vector<std::vector<Point3>> centers(some.size());
  std::vector<BallFrame> frames;
  for (std::size_t f = 0; f < some.size(); ++f) {
    for (const AtomRow& row : some[f].rows) centers[f].push_back(row.center);
    frames.push_back({centers[f], some[f].radii});
  }
  MeasureBallsOptions how{.probe = request_.probe,
                          .contacts = request_.contacts.has_value(),
                          .threads = options().threads,
                          .progress = [](const Progress&) { return !interrupted(); }};
  try {
    std::vector<BallMeasures> with_probe = measure_ball_frames(frames, how);
    for (std::size_t f = 0; f < some.size(); ++f) some[f].with_probe = std::move(with_probe[f]);
    how.probe = 0;
    how.contacts = false;
    const std::vector<BallMeasures> without =
        request_.probe > 0 ? measure_ball_frames(frames, how) : std::vector<BallMeasures>();
    for (std::size_t f = 0; f < some.size(); ++f) {
      const BallMeasures& of = without.empty() ? some[f].with_probe : without[f];
      some[f].volume = of.volume;
      some[f].area = of.area;
    }
  } catch (const InvalidInput& e) {
    throw BadInput(input() + ": " + e.what());
  }
  measure_seconds_ += lap();
}

void BallsRun::begin_files() {
  const auto begin = [&](const Target& target, bool of_contacts) {
    tables_.emplace_back(files().add(target.path), target.format, request_, texts_, facts_.are_atoms, of_contacts);
  };
  for (const Target& target : request_.targets) begin(target, false);
  if (request_.contacts) begin(*request_.contacts, true);
}

void BallsRun::write(const MeasuredAtoms& frame) {
  if (facts_.frames.empty()) {
    facts_.are_atoms = frame.rows.front().line > 0;
    begin_files();
  }
  for (BallRows& table : tables_) table.write(frame);
  facts_.frames.push_back({frame.number, frame.rows.size(), frame.buried(), frame.counts, frame.with_probe.volume,
                           frame.with_probe.area, frame.volume, frame.area});
  done_ += frame.rows.size();
}

void BallsRun::run() {
  std::vector<std::string> warnings;
  {
    ProgressLine line = options().line("atoms", read_from_terminal(request_.path));
    line.say([&](double seconds) {
      const auto done = static_cast<double>(done_);
      return short_number(done) + " atoms" +
             (seconds > 0 && done > 0 ? ", " + short_number(done / seconds) + "/s" : "");
    });
    AtomFrames file(request_.path, request_.format, request_.choice);
    for (std::vector<MeasuredAtoms> some = read_some(file); !some.empty(); some = read_some(file)) {
      measure(some);
      for (const MeasuredAtoms& frame : some) write(frame);
      write_seconds_ += lap();
    }
    for (BallRows& table : tables_) table.finish();
    warnings = file.warnings();
  }
  warning(warnings);
  write_seconds_ += lap();
  if (arguments_.json) add("-", [&](OutputFile& file) { write_json(file, json_of(facts_), 1); });
  if (arguments_.stats)
    add(*arguments_.stats, [&](OutputFile& file) {
      nlohmann::ordered_json report = json_of(facts_);
      report["threads"] = options().threads_or_all();
      report["seconds"] = {{"read", read_seconds_}, {"measure", measure_seconds_}, {"write", write_seconds_}};
      report["peak_bytes"] = peak_bytes();
      write_json(file, report, 2);
    });
  publish();
  std::vector<std::string> lines = text_of(facts_), paths;
  for (const Target& target : request_.targets) paths.push_back(target.path);
  if (request_.contacts) paths.push_back(request_.contacts->path);
  lines.back() += list_of(paths);
  for (const std::string& text : lines) summarize(text);
}

}  // namespace

void run_balls(const BallsArguments& arguments) { BallsRun(arguments, parse(arguments)).run(); }

}  // namespace rbpa::app
