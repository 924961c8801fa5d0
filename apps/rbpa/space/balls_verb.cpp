#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/bytes/write_json.h"
#include "io/cloud/atoms.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "rbpa/base/error.h"
#include "rbpa/space/balls/measure_ball_frames.h"
#include "shared/point_arguments.h"
#include "shared/run.h"
#include "shared/stats.h"
#include "shared/verbs.h"
#include "space/balls_files.h"
#include "space/balls_voids.h"
#include "space/solid_report.h"

namespace rbpa::app {
namespace {

struct BallsRequest {
  BallRadii radii;
  Format format = Format::text;
  AtomChoice choice = {};
  double probe = 0;
  std::optional<UnitCell> box = std::nullopt;  ///< the cell of --box, without edges for auto
  AtomGroups groups = AtomGroups::none;
  std::vector<Target> targets = {};
  Format voids = Format::csv, pockets = Format::csv;
  RunOptions run = {};
};

/// Parses --group; stores the name of a column of groups in choice.group. Throws WrongUsage that names the text.
AtomGroups parse_groups(const std::string& text, AtomChoice& choice) {
  constexpr std::string_view column = "column:";
  if (text == "residue") return AtomGroups::residue;
  if (text == "chain") return AtomGroups::chain;
  if (!text.starts_with(column) || text.size() == column.size())
    bad_usage("--group", in_quotes(text), "residue, chain or column:NAME");
  choice.group = text.substr(column.size());
  return AtomGroups::column;
}

/// Parses the arguments, and reads the file of --radii. Throws WrongUsage that names the option; BadInput, Failure.
BallsRequest parse(const BallsArguments& arguments) {
  BallsRequest request{.radii = parse_ball_radii(arguments)};
  request.format = parse_format(Use::space, arguments.atoms, arguments.format, "ATOMS");
  request.probe = parse_real("--probe", arguments.probe, {}, "a length, at least 0");
  request.run = parse_run(arguments.run);
  request.choice = {.waters = arguments.waters,
                    .ligands = !arguments.no_ligands,
                    .hydrogens = !arguments.no_hydrogens,
                    .alternates = arguments.alternates,
                    .where = arguments.where,
                    .threads = request.run.threads};
  request.choice.radius = request.radii.column();
  if (arguments.models) request.choice.frames = parse_frames("--models", *arguments.models);
  if (arguments.box) {
    const bool may_have_lattice = request.format == Format::text || request.format == Format::by_content;
    request.box = *arguments.box == "auto" && may_have_lattice ? UnitCell() : parse_box(*arguments.box, request.format);
    refuse_given({{arguments.pockets.has_value(), "--pockets"}},
                 "cannot be combined with --box, which has no outside to open to (--voids has what percolates; without "
                 "--box, molecules that are whole have pockets)");
  }
  if (arguments.pores && !arguments.box) throw WrongUsage("--pores requires --box");
  if (arguments.group) request.groups = parse_groups(*arguments.group, request.choice);
  if (arguments.interfaces && !arguments.group) throw WrongUsage("--interfaces requires --group (chain, for example)");
  for (const auto& [option, path] :
       {std::pair("--contacts", &arguments.contacts), {"--interfaces", &arguments.interfaces}})
    if (*path) target_of(option, **path, Use::rows);
  const auto has_no_surface = [](Format format) { return format != Format::obj; };
  if (arguments.voids)
    request.voids =
        target_of("--voids", *arguments.voids, Use::lined, arguments.box ? +has_no_surface : nullptr).format;
  if (arguments.pockets) request.pockets = target_of("--pockets", *arguments.pockets, Use::lined).format;
  const Reports reports = {arguments.contacts, arguments.interfaces, arguments.voids, arguments.pockets,
                           json_report(arguments.json)};
  // Write only the summary if no file is requested.
  if (!arguments.outputs.empty() || arguments.output_format || arguments.run.stats || !given(reports).empty())
    request.targets = parse_targets(Use::rows, arguments, arguments.atoms, reports);
  return request;
}

/// Reads, measures and writes several frames at a time.
class BallsRun : public Run {
 public:
  BallsRun(const BallsArguments& arguments, BallsRequest request)
      : Run(arguments.atoms, arguments.outputs, request.run), arguments_(arguments), request_(std::move(request)) {}

  void run();

 private:
  /// Returns whether any output shows the sizes without the probe.
  bool is_reported() const { return !options().quiet || arguments_.json || arguments_.run.stats; }
  std::vector<std::string> process();
  RepeatingCell cell(const std::string& name) const;
  std::vector<MeasuredAtoms> read_some(AtomFrames& file);
  void measure(std::vector<MeasuredAtoms>& some);
  void begin_tables(const AtomFrame& first);
  void require_groups(const AtomFrame& first) const;
  void warn_of_parted_residues(const AtomFrame& first) const;

  const BallsArguments& arguments_;
  BallsRequest request_;
  AtomFrame texts_ = {};  // every frame is read into this object
  bool are_atoms_ = true;
  bool has_frames_ = false;  // whether rows have the number of their frame
  std::vector<BallRows> tables_ = {};
  std::vector<BallVoidRows> voids_ = {};     // files of voids and of pockets
  std::array<std::size_t, 4> void_count_{};  // by the number of directions in which they percolate
  std::size_t pocket_count_ = 0, interface_count_ = 0, most_groups_ = 0;
  std::vector<BallTotals> frames_ = {};
  std::atomic<std::size_t> done_ = 0;  // number of finished atoms
  double read_seconds_ = 0, measure_seconds_ = 0, write_seconds_ = 0;
};

/// Throws BadInput if atoms have no chains or residues by which --group could group them.
void BallsRun::require_groups(const AtomFrame& first) const {
  const bool is_chain = request_.groups == AtomGroups::chain;
  if (!is_chain && request_.groups != AtomGroups::residue) return;
  const auto has_none = [&](const AtomRow& row) {
    return row.chain == 0 && (is_chain || (row.resname == 0 && std::isnan(row.resseq)));
  };
  if (std::all_of(first.rows.begin(), first.rows.end(), has_none))
    bad_input(input(), std::string("no ") + (is_chain ? "chains" : "residues") + " for --group",
              is_chain ? "some (--group residue, or column:NAME)" : "some (--group column:NAME takes any column)");
}

/// Prints a warning if atoms of one residue are in several places of the file: its number may stand for several.
void BallsRun::warn_of_parted_residues(const AtomFrame& first) const {
  if (request_.groups != AtomGroups::residue) return;
  using Named = std::pair<Residue, std::uint32_t>;
  std::set<Named> seen, parted;
  std::optional<Named> last;
  for (const AtomRow& row : first.rows) {
    const Named now(residue_of(row), row.resname);
    if (now == last) continue;
    if (!seen.insert(now).second) parted.insert(now);
    last = now;
  }
  if (!parted.empty())
    warning(counted(parted.size(), "residue") + (parted.size() == 1 ? " has" : " have") +
            " atoms in several places of the file and one row each: do numbers of residues repeat? (chains tell copies "
            "apart)");
}

void BallsRun::begin_tables(const AtomFrame& first) {
  require_groups(first);
  warn_of_parted_residues(first);
  are_atoms_ = first.rows.front().line > 0;
  has_frames_ = request_.choice.frames.may_have_several();
  const auto begin = [&](const std::string& path, BallRows::Of of) {
    tables_.emplace_back(files().add(path), of, request_.groups, request_.choice.group.value_or(""), has_frames_,
                         texts_, are_atoms_, request_.box.has_value());
  };
  for (const Target& target : request_.targets) begin(target.path, BallRows::Of::atoms);
  if (arguments_.contacts) begin(*arguments_.contacts, BallRows::Of::contacts);
  if (arguments_.interfaces) begin(*arguments_.interfaces, BallRows::Of::interfaces);
  if (arguments_.voids)
    voids_.emplace_back(files().add(*arguments_.voids), request_.voids, has_frames_, request_.box.has_value(), false);
  if (arguments_.pockets)
    voids_.emplace_back(files().add(*arguments_.pockets), request_.pockets, has_frames_, false, true);
}

/// Returns the cell of --box, for auto that of the current frame of the file. Throws BadInput if it has none.
RepeatingCell BallsRun::cell(const std::string& name) const {
  const UnitCell& cell = request_.box->edges ? *request_.box : texts_.cell;
  if (!cell.edges)
    bad_input(name, (cell.fault.empty() ? "no cell" : cell.fault) + " in frame " + std::to_string(texts_.number),
              "a cell for --box auto (--box LX,LY,LZ gives one)");
  return {*cell.edges, cell.repeats};
}

/// Reads frames until there is work for all threads. Returns no frame at the end.
std::vector<MeasuredAtoms> BallsRun::read_some(AtomFrames& file) {
  constexpr std::size_t enough_atoms = 200'000;
  const std::size_t enough_frames = std::size_t{4} * options().threads_or_all();
  std::vector<MeasuredAtoms> some;
  for (std::size_t atoms = 0; atoms < enough_atoms && some.size() < enough_frames && file.next(texts_);) {
    if (frames_.empty() && some.empty()) begin_tables(texts_);
    MeasuredAtoms& frame = some.emplace_back();
    frame.number = texts_.number;
    frame.counts = texts_.counts;
    frame.radii = request_.radii.of(texts_, file.name());
    if (request_.box) frame.cell = cell(file.name());
    if (request_.box && !request_.box->edges && frames_.empty() && some.size() == 1)
      if (const std::string text = warning_of_symmetry(texts_.cell); !text.empty()) warning(text);
    frame.rows = std::move(texts_.rows);
    frame.kept = frame.rows.size();
    atoms += frame.kept;
  }
  read_seconds_ += lap();
  return some;
}

void BallsRun::measure(std::vector<MeasuredAtoms>& some) {
  std::vector<std::vector<Point3>> centers(some.size());
  std::vector<BallFrame> frames;
  for (std::size_t f = 0; f < some.size(); ++f) {
    centers[f].reserve(some[f].rows.size());
    for (const AtomRow& row : some[f].rows) centers[f].push_back(row.center);
    frames.push_back({centers[f], some[f].radii, some[f].cell});
  }
  if (request_.box && request_.box->edges && frames_.empty())
    warning(warnings_of_range(centers.front(), *request_.box->edges, are_atoms_ ? "atoms" : "points"));
  const OnProgress watch = [](const Progress&) { return !interrupted(); };
  const auto measured = [&](double probe, bool contacts) {
    return measure_ball_frames(frames,
                               {.probe = probe, .contacts = contacts, .threads = options().threads, .progress = watch});
  };
  try {
    std::vector<PeriodicBallMeasures> with = measured(request_.probe, arguments_.contacts.has_value());
    std::vector<PeriodicBallMeasures> without;
    if (request_.probe > 0 && is_reported()) without = measured(0, false);
    for (std::size_t f = 0; f < some.size(); ++f) {
      const BallMeasures& bare = without.empty() ? with[f] : without[f];
      some[f].volume_without_probe = bare.volume;
      some[f].area_without_probe = bare.area;
      some[f].volume = with[f].volume;
      some[f].area = with[f].area;
      some[f].buried = static_cast<std::size_t>(std::count(with[f].areas.begin(), with[f].areas.end(), 0.0));
      if (some[f].cell) some[f].cell_volume = some[f].cell->volume();
      some[f].balls = std::move(with[f]);
      if (arguments_.interfaces) {
        const std::vector<std::uint32_t> groups = tables_.back().groups_of(some[f].rows);
        some[f].interfaces = ball_interfaces(
            frames[f], groups, {.probe = request_.probe, .threads = options().threads, .progress = watch});
        interface_count_ += some[f].interfaces.all.size();
        most_groups_ = std::max(most_groups_, std::size_t{*std::max_element(groups.begin(), groups.end())} + 1);
      }
      if (!voids_.empty())
        find_voids(some[f], centers[f], request_.probe, arguments_.pockets.has_value(), options().threads);
      if (arguments_.pores)
        some[f].pores =
            pore_sizes(centers[f], some[f].radii, *some[f].cell, {.threads = options().threads, .progress = watch});
    }
  } catch (const InvalidInput& e) {
    throw BadInput(input() + ": " + e.what());
  }
  measure_seconds_ += lap();
}

/// Measures all frames, and writes their rows. Returns the warnings about the input.
std::vector<std::string> BallsRun::process() {
  ProgressLine line = options().line("atoms", read_from_terminal(arguments_.atoms));
  line.say([&](double seconds) {
    const auto done = static_cast<double>(done_);
    return short_number(done) + " atoms" + (seconds > 0 && done > 0 ? ", " + short_number(done / seconds) + "/s" : "");
  });
  AtomFrames file(arguments_.atoms, request_.format, request_.choice);
  for (std::vector<MeasuredAtoms> some = read_some(file); !some.empty(); some = read_some(file)) {
    measure(some);
    for (const MeasuredAtoms& frame : some) {
      for (BallRows& table : tables_) table.write(frame);
      for (BallVoidRows& table : voids_) table.write(frame);
      for (const BallVoid& hollow : frame.voids.voids) ++void_count_[hollow.dimension];
      pocket_count_ += frame.voids.pockets.size();
      frames_.push_back(frame);
      done_ += frame.kept;
    }
    write_seconds_ += lap();
  }
  for (BallRows& table : tables_) table.finish();
  for (BallVoidRows& table : voids_) table.finish();
  write_seconds_ += lap();
  return file.warnings();
}

void BallsRun::run() {
  warning(process());
  const nlohmann::ordered_json report = json_of(request_.probe, request_.radii, frames_);
  if (arguments_.json) add("-", [&](OutputFile& output) { write_json(output, report, 1); });
  add_stats([&](OutputFile& output) {
    write_stats(output, report, options().threads_or_all(),
                {{"read", read_seconds_}, {"measure", measure_seconds_}, {"write", write_seconds_}});
  });
  publish();
  std::vector<std::string> lines = text_of(request_.probe, request_.radii, frames_, are_atoms_ ? "atom" : "point");
  if (!voids_.empty())
    lines.push_back("with the probe: " + (request_.box ? text_of_voids(void_count_) : counted(void_count_[0], "void")) +
                    (arguments_.pockets ? ", " + counted(pocket_count_, "pocket") : "") +
                    (frames_.size() == 1 ? "" : " in all frames"));
  if (arguments_.pores && frames_.size() == 1) {
    const PoreSizes& pores = *frames_[0].pores;
    lines.push_back("without the probe: a ball of radius " + rounded(pores.included, 6) + " fits in, one of " +
                    rounded(pores.passing, 6) + " passes, with " + rounded(pores.on_the_way, 6) +
                    " on its way; along the edges " + rounded(pores.along[0], 6) + ", " + rounded(pores.along[1], 6) +
                    ", " + rounded(pores.along[2], 6));
  }
  if (arguments_.interfaces && interface_count_ == 0)
    lines.emplace_back(most_groups_ == 1 ? "0 interfaces (one group)" : "0 interfaces (no two groups meet)");
  std::vector<std::string> paths =
      given({arguments_.contacts, arguments_.interfaces, arguments_.voids, arguments_.pockets});
  for (auto target = request_.targets.rbegin(); target != request_.targets.rend(); ++target)
    paths.insert(paths.begin(), target->path);
  lines.back() += list_of(paths);
  for (const std::string& text : lines) summarize(text);
}

}  // namespace

void run_balls(const BallsArguments& arguments) { BallsRun(arguments, parse(arguments)).run(); }

}  // namespace rbpa::app
