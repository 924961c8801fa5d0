#include "tasks/write_lists.h"

#include <algorithm>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

#include "io/failure.h"
#include "io/interrupt.h"
#include "stream/compute_tile.h"
#include "stream/scratch_file.h"
#include "tasks/run_facts.h"

namespace rbpa::app {
namespace {

namespace fs = std::filesystem;

std::string absolute(const std::string& path) { return fs::absolute(path).lexically_normal().string(); }

/// "2-000012.partial": what the task with this number on a level writes.
std::string partial_name(std::size_t level, std::uint64_t number) {
  return std::to_string(level) + "-" + file_number(number) + ".partial";
}

/// A file that is written some at a time, and is there when it is whole.
class ListFile {
 public:
  ListFile(std::string folder, std::string name) : path_(std::move(folder) + "/" + name), name_(std::move(name)) {
    ScratchFile(path_ + ".new", ScratchFile::Mode::write);
  }
  void line(const std::string& text) {
    waiting_ += text;
    waiting_ += '\n';
    constexpr std::size_t enough = 1U << 20U;
    if (waiting_.size() >= enough) flush();
  }
  std::string finish() {
    flush();
    rename_scratch(path_ + ".new", path_);
    return name_;
  }

 private:
  void flush() {
    ScratchFile(path_ + ".new", ScratchFile::Mode::append).write(waiting_);
    waiting_.clear();
  }

  std::string path_, name_, waiting_ = {};
};

/// The text with another in the place of each such character.
std::string replaced(const std::string& text, char wanted, std::string_view by) {
  std::string result;
  for (const char c : text) {
    if (c == wanted)
      result += by;
    else
      result += c;
  }
  return result;
}

/// A line of a recipe: what the shell is to see.
std::string recipe(const std::string& command) { return replaced(command, '$', "$$"); }

/// The same on the right of an assignment, where a # begins a comment.
std::string assigned(const std::string& command) { return replaced(recipe(command), '#', "$(hash)"); }

class Lists {
 public:
  Lists(const StreamRequest& request, const TaskOptions& options, const Scratch& scratch, const Manifest& manifest)
      : request_(request),
        options_(options),
        scratch_(scratch),
        manifest_(manifest),
        folder_(absolute(scratch.folder())),
        program_(shell_word(options.program)),
        makefile_(scratch.folder(), "Makefile") {}

  TaskLists write() {
    begin_makefile();
    std::vector<std::string> partials = write_tiles();
    while (partials.size() > options_.fan_in) partials = write_merges(partials);
    write_targets(partials);
    makefile_.line("endif");
    makefile_.finish();
    replace_content(scratch_.folder() + "/slurm.sh", slurm());
    return std::move(lists_);
  }

 private:
  std::string word_of_partial(const std::string& name) const { return shell_word(folder_ + "/partials/" + name); }
  std::string list_name(const char* what) const {
    return std::to_string(lists_.levels.size() + 1) + "-" + what + ".txt";
  }

  void begin_makefile() {
    makefile_.line("# The tasks of a run of rbpa stream. When make was interrupted, the same goes on.");
    makefile_.line("ifndef RBPA_TASKS");
    makefile_.line("all:");
    makefile_.line("\t+@cd " + recipe(shell_word(folder_)) +
                   " && $(MAKE) --no-print-directory -f Makefile RBPA_TASKS=1");
    makefile_.line(".PHONY: all");
    makefile_.line("else");
    makefile_.line("all: done");
    std::string test;
    for (const std::string& path : targets()) test += "test -e " + shell_word(absolute(path)) + " && ";
    if (!test.empty()) {
      makefile_.line("hash := \\#");
      makefile_.line("are_there != " + assigned(test) + "echo yes");
      makefile_.line("ifneq ($(are_there),yes)");
      makefile_.line("done: write_again");
      makefile_.line("endif");
    }
    makefile_.line("write_again:");
    makefile_.line(".PHONY: all write_again");
  }

  void task(ListFile& list, const std::string& makes, const std::string& of, const std::string& command) {
    stop_if_interrupted();
    list.line(command);
    makefile_.line(makes + ":" + of);
    const std::string stamp = makes == "done" ? " && : > done" : "";
    makefile_.line('\t' + recipe(command) + stamp);
    ++lists_.tasks;
  }

  std::vector<std::string> write_tiles() {
    ListFile list(scratch_.folder(), list_name("tiles"));
    std::vector<std::string> partials;
    const std::string how = " --threads " + std::to_string(options_.threads) + " -q";
    for (const std::uint32_t tile : manifest_.tree.order()) {
      const std::string path = scratch_.tile(tile).substr(scratch_.folder().size() + 1), name = partial_name(1, tile);
      std::string command = program_ + " tile " + shell_word(folder_ + "/" + path) + " -o " + word_of_partial(name);
      if (request_.wants(StreamFormat::npy))
        command += " -o " + shell_word(folder_ + "/triangles/" + fs::path(path).stem().string() + ".npy");
      for (const StreamTarget& target : request_.targets)
        if (target.format == StreamFormat::ply)
          command += " -o " + shell_word(tile_mesh_path(absolute(target.path), tile));
      task(list, "partials/" + name, " " + path, command + how);
      partials.push_back(name);
    }
    lists_.levels.push_back(list.finish());
    return partials;
  }

  /// Neighbours together, and as many in one as in the other.
  std::vector<std::string> write_merges(const std::vector<std::string>& partials) {
    ListFile list(scratch_.folder(), list_name("merges"));
    const std::size_t level = lists_.levels.size() + 1;
    const std::size_t count = (partials.size() + options_.fan_in - 1) / options_.fan_in;
    std::vector<std::string> merged;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t first = i * partials.size() / count, last = (i + 1) * partials.size() / count;
      const std::string name = partial_name(level, i);
      const auto [of, words] = inputs(std::span(partials).subspan(first, last - first));
      task(list, "partials/" + name, of, program_ + " merge" + words + " -o " + word_of_partial(name) + " -q");
      merged.push_back(name);
    }
    lists_.levels.push_back(list.finish());
    return merged;
  }

  void write_targets(const std::vector<std::string>& partials) {
    ListFile list(scratch_.folder(), list_name("targets"));
    const auto [of, words] = inputs(partials);
    std::string command = program_ + " merge" + words;
    for (const StreamTarget& target : request_.targets) {
      if (target.format == StreamFormat::ply) continue;
      command += " -o " + shell_word(absolute(target.path));
    }
    if (request_.stats) command += " --stats " + shell_word(absolute(*request_.stats));
    if (targets().empty())
      command += " -o " + word_of_partial("whole.partial");  // meshes of tiles were all
    else
      command += " --memory " + std::to_string(request_.memory);
    if (request_.quiet) command += " -q";
    task(list, "done", of, command);
    lists_.levels.push_back(list.finish());
  }

  /// Of a rule, and of a command.
  std::pair<std::string, std::string> inputs(std::span<const std::string> partials) const {
    std::pair<std::string, std::string> both;
    for (const std::string& name : partials) {
      both.first += " partials/" + name;
      both.second += ' ';
      both.second += word_of_partial(name);
    }
    return both;
  }

  /// What the last task writes.
  std::vector<std::string> targets() const {
    std::vector<std::string> paths;
    for (const StreamTarget& target : request_.targets)
      if (target.format != StreamFormat::ply) paths.push_back(target.path);
    if (request_.stats) paths.push_back(*request_.stats);
    return paths;
  }

  std::string slurm() const {
    std::string names;
    for (const std::string& name : lists_.levels) names += " " + name;
    return "#!/bin/sh\n"
           "# Gives the tasks to Slurm: an array for each list, which waits for the one before. Words behind are for "
           "sbatch:\n"
           "#   sh slurm.sh --partition=short --mem=2G\n"
           "cd " +
           shell_word(folder_) +
           " || exit\n"
           "most=1000  # of an array; more lines are shared among them (MaxArraySize of `scontrol show config`)\n"
           "before=\n"
           "for list in" +
           names +
           "; do\n"
           "  lines=$(wc -l < $list)\n"
           "  count=$((lines < most ? lines : most))\n"
           "  before=$(sbatch --parsable --kill-on-invalid-dep=yes --job-name=rbpa-$list --array=1-$count "
           "${before:+--dependency=afterok:$before} \"$@\" \\\n"
           "    --wrap=\"awk -v k=\\$SLURM_ARRAY_TASK_ID 'NR % $count == k % $count' $list | sh -e\") || exit\n"
           "  before=${before%%;*}\n"
           "  echo \"$list: job $before, $lines tasks\"\n"
           "done\n";
  }

  const StreamRequest& request_;
  const TaskOptions& options_;
  const Scratch& scratch_;
  const Manifest& manifest_;
  std::string folder_, program_;
  ListFile makefile_;
  TaskLists lists_ = {};
};

}  // namespace

std::string shell_word(const std::string& text) {
  const auto is_plain = [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
           std::string_view("_@%+=:,./-").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return text;
  std::string word = replaced(text, '\'', "'\\''");
  word.insert(word.begin(), '\'');
  word += '\'';
  return word;
}

void require_lines(const StreamRequest& request, const TaskOptions& options) {
  std::vector<std::string> names = {options.program, absolute(request.scratch.value_or("."))};
  for (const StreamTarget& target : request.targets) names.push_back(absolute(target.path));
  if (request.stats) names.push_back(absolute(*request.stats));
  for (const std::string& name : names)
    if (name.find('\n') != std::string::npos)
      throw WrongUsage("--tasks: found a newline in the name " + in_quotes(name) +
                       ", expected none: a command is a line");
}

TaskLists write_lists(const StreamRequest& request, const TaskOptions& options, const Scratch& scratch,
                      const Manifest& manifest) {
  save(facts_of(manifest), scratch.folder() + "/run.json");
  return Lists(request, options, scratch, manifest).write();
}

std::string how_to_run(const std::string& folder) {
  const std::string makefile = shell_word(folder + "/Makefile"), lists = shell_word(folder) + "/[1-9]-*.txt";
  return "make -j$(nproc) -f " + makefile + "\n" + "for list in " + lists +
         "; do xargs -d '\\n' -n 1 -P $(nproc) sh -c < \"$list\" || break; done\n" + "for list in " + lists +
         "; do parallel --halt now,fail=1 < \"$list\" || break; done\n" + "sh " + shell_word(folder + "/slurm.sh") +
         "\n";
}

}  // namespace rbpa::app
