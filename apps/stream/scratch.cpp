#include "stream/scratch.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <random>
#include <system_error>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "stream/scratch_file.h"

namespace rbpa::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* lock_name = "/lock";
constexpr const char* parts[] = {"tiles", "triangles", "partials", "runs", "group"};
constexpr const char* files[] = {
    "manifest.json", "manifest.json.new", "progress.json", "progress.json.new", "polygons", "holes",
    "groups",        "group.f64xy"};
constexpr const char* created_name = "created";  // marks a folder that rbpa made, and removes with its files
constexpr std::string_view beginning = ".rbpa-stream-";
constexpr const char* dead_name = ".dead-";
constexpr const char* unmarked_name = ".rbpa-new";  // suffix of a folder that has no mark yet, or no longer

std::string numbered(const std::string& folder, const char* part, std::uint64_t number) {
  return folder + "/" + part + "/" + file_number(number);
}

enum class Lock { ours, busy, gone };

/// Returns whether the file that is open as `descriptor` is still the file at `path`.
bool is_same_file(int descriptor, const std::string& path) {
  struct stat open_one {
  }, named{};
  return fstat(descriptor, &open_one) == 0 && lstat(path.c_str(), &named) == 0 && open_one.st_dev == named.st_dev &&
         open_one.st_ino == named.st_ino;
}

/// Locks the file at `path`. Sets `descriptor` to the open file if this process has the lock (Lock::ours), otherwise to
/// −1. Throws Failure if the file cannot be opened for another reason than that it is missing.
Lock lock_file(const std::string& path, int flags, int& descriptor) {
  descriptor = open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW | flags, 0666);
  if (descriptor < 0 && errno == ENOENT) return Lock::gone;
  if (descriptor < 0) throw Failure(path + ": cannot create: " + std::strerror(errno));
  const bool is_busy = flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (!is_busy && is_same_file(descriptor, path)) return Lock::ours;
  close(std::exchange(descriptor, -1));
  return is_busy ? Lock::busy : Lock::gone;
}

/// Returns ".rbpa-stream-PROCESS-RANDOM". The number of the process alone is not enough: processes in two containers
/// can have the same number.
std::string new_name() {
  char random[16];
  std::snprintf(random, sizeof random, "-%08x", std::random_device()());
  return std::string(beginning) + std::to_string(getpid()) + random;
}

/// Renames a folder unless the new name exists. Returns 0, or the number of the error.
int rename_to_new(const std::string& from, const std::string& to) {
  if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != ENOSYS && errno != EINVAL) return errno;
  // This file system cannot rename and refuse an existing name in one step: check first. An empty folder that appears
  // after the check is replaced.
  if (access(to.c_str(), F_OK) == 0) return EEXIST;
  return std::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

/// Returns whether the process may exist whose number is in the name of the folder.
bool is_alive(const fs::path& folder) {
  const std::string number = folder.filename().string().substr(beginning.size());
  const long id = std::strtol(number.c_str(), nullptr, 10);
  return id <= 0 || kill(static_cast<pid_t>(id), 0) == 0 || errno != ESRCH;
}

/// Removes the folders of dead runs in the folder `beside`.
/// No run loses its folder to another run that starts at the same time. A process uses a folder only after it has
/// locked the file in the folder, and then checked that the locked file is still at its path (Lock::ours). A process
/// removes a folder only after the same lock and check, and renames the folder first, while the file is locked. If the
/// owner of the folder locks first, the other process finds the lock held and stops. If the other process locks first,
/// the owner finds the lock held, or no folder, or another file at the path, and makes a new folder. An empty folder
/// without a lock may be removed at any time; the owner then makes a new folder.
void clear_dead(const std::string& beside) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator at(beside, error), end; !error && at != end; at.increment(error)) {
    std::error_code none;
    if (at->path().filename().string().starts_with(beginning) && at->is_directory(none)) found.push_back(at->path());
  }
  for (const fs::path& folder : found) {
    const std::string lock = folder.string() + lock_name;
    if (folder.filename().string().find(dead_name) != std::string::npos) {  // no run uses the folder
      fs::remove_all(folder, error);
      continue;
    }
    if (access(lock.c_str(), F_OK) != 0) {  // a run is about to make the lock, or was killed before that
      if (is_alive(folder)) continue;
      fs::remove(folder / created_name, error);
      fs::remove(folder, error);
      continue;
    }
    int descriptor = -1;
    try {
      if (lock_file(lock, 0, descriptor) != Lock::ours) continue;
    } catch (const Failure&) {
      continue;  // the folder belongs to another user
    }
    const fs::path dead = folder.string() + dead_name + std::to_string(getpid());
    fs::rename(folder, dead, error);
    if (!error) fs::remove_all(dead, error);
    close(descriptor);
  }
}

/// Returns the folder of the first target whose path names a folder and is no device or pipe; else the current folder.
std::string folder_of(const StreamRequest& request) {
  for (const StreamTarget& target : request.targets) {
    std::error_code error;
    const bool is_other = fs::exists(target.path, error) && !fs::is_regular_file(target.path, error);
    const std::size_t slash = target.path.rfind('/');
    if (target.path == "-" || is_other || slash == std::string::npos) continue;
    return target.path.substr(0, slash + 1);
  }
  return ".";
}

}  // namespace

Scratch::Scratch(const StreamRequest& request)
    : is_asked_for_(request.scratch.has_value()), reserve_(std::make_unique<char[]>(std::size_t{1} << 18U)) {
  std::string beside;
  if (is_asked_for_) {
    folder_ = *request.scratch;
    while (folder_.size() > 1 && folder_.back() == '/') folder_.pop_back();
  } else {
    beside = folder_of(request);
    clear_dead(beside);
  }
  constexpr int often = 1000;
  for (int i = 0; i < often; ++i) {
    if (!is_asked_for_) folder_ = beside + "/" + new_name();
    try {
      if (make(request)) return;
    } catch (...) {  // the destructor of an object is not called when its constructor throws
      if (is_new_) remove_own();
      if (lock_ >= 0) close(lock_);
      throw;
    }
  }
  throw Failure(folder_ + ": another process removed the folder each time it was made (--scratch DIR names another)");
}

bool Scratch::make(const StreamRequest& request) {
  std::error_code error;
  is_new_ = is_asked_for_ ? make_marked() : fs::create_directory(folder_, error);
  if (error || !fs::is_directory(folder_))
    throw Failure(folder_ + ": cannot make the folder: " + (error ? error.message() : "there is a file of this name"));
  has_run_ = fs::exists(manifest());
  if (!is_new_ && !has_run_) {
    // Allow files of these names: a run that was killed at its beginning may have left some of them.
    const auto is_other = [](const fs::directory_entry& entry) {
      const std::string name = entry.path().filename().string();
      return name != lock_name + 1 && name != created_name &&
             std::find(std::begin(parts), std::end(parts), name) == std::end(parts) &&
             std::find(std::begin(files), std::end(files), name) == std::end(files);
    };
    const fs::directory_iterator entries(folder_);
    if (std::any_of(begin(entries), end(entries), is_other))
      bad_usage("--scratch", "files of another program in " + folder_, "an empty folder or a new name");
  }
  if (has_run_ && !request.resume)
    bad_usage("--scratch", "a run in " + folder_, "--resume to continue it, or another folder");
  const Lock lock = lock_file(folder_ + lock_name, O_CREAT, lock_);
  if (lock == Lock::gone || (lock == Lock::busy && !is_asked_for_)) return false;
  if (lock == Lock::busy)
    throw Failure(folder_ + ": another run is using the folder (wait for it, or name another with --scratch)");
  if (!has_run_) {
    clear_leftovers();
    return true;
  }
  for (const char* part : parts) fs::create_directory(folder_ + "/" + part, error);
  if (error) throw Failure(folder_ + ": cannot make a folder in it: " + error.message());
  return true;
}

Scratch::~Scratch() {
  if (!folder_.empty()) remove_own();
  if (lock_ >= 0) close(lock_);
}

void Scratch::remove_own() noexcept {
  if (is_asked_for_) return;
  reserve_.reset();
  std::error_code error;
  try {
    fs::remove_all(folder_, error);
  } catch (...) {  // NOLINT(bugprone-empty-catch): the next run with this target removes the folder
  }
}

std::string Scratch::tile(std::uint32_t number) const { return numbered(folder_, "tiles", number) + ".tile"; }
std::string Scratch::rows(std::size_t bucket) const { return numbered(folder_, "triangles", bucket); }
std::string Scratch::partials(std::uint64_t generation) const { return numbered(folder_, "partials", generation); }
std::string Scratch::sorted_run(std::size_t number) const { return numbered(folder_, "runs", number); }

void Scratch::clear(bool keep_tiles) {
  std::error_code error;
  const std::string created = folder_ + "/" + created_name;
  // Remove the manifest before the files that it lists: the process may be killed between both.
  for (const char* file : files)
    if (!keep_tiles || std::string_view(file) != "manifest.json") fs::remove(folder_ + "/" + file, error);
  for (const char* part : parts)
    if (!keep_tiles || std::string_view(part) != "tiles") fs::remove_all(folder_ + "/" + part, error);
  fs::remove(folder_ + lock_name, error);
  if (keep_tiles || !fs::exists(created)) return;
  // Rename the folder before its mark is removed: a folder without a mark counts as the user's. Keep a folder with
  // other files.
  const auto is_other = [](const fs::directory_entry& entry) { return entry.path().filename() != created_name; };
  const fs::directory_iterator entries(folder_, error);
  if (error || std::any_of(begin(entries), end(entries), is_other)) {
    fs::remove(created, error);
    return;
  }
  const std::string unmarked = folder_ + unmarked_name;
  fs::rename(folder_, unmarked, error);
  if (error) return;
  fs::remove(unmarked + "/" + created_name, error);
  fs::remove(unmarked, error);
}

void Scratch::clear_leftovers() const {
  std::error_code error;
  for (const char* file : files) fs::remove(folder_ + "/" + file, error);
  for (const char* part : parts) {
    fs::remove_all(folder_ + "/" + part, error);
    fs::create_directory(folder_ + "/" + part, error);
    if (error) throw Failure(folder_ + ": cannot make a folder in it: " + error.message());
  }
}

/// Makes a folder under another name, marks it, and renames it. Returns false if the name exists. Takes over an
/// unmarked folder of a killed run.
bool Scratch::make_marked() const {
  std::error_code error;
  const std::string unmarked = folder_ + unmarked_name;
  if (fs::exists(fs::symlink_status(folder_, error))) {
    fs::remove(unmarked + "/" + created_name, error);
    fs::remove(unmarked, error);
    return false;
  }
  fs::create_directory(unmarked, error);
  if (error) throw Failure(folder_ + ": cannot make the folder: " + error.message());
  const int created =
      open((unmarked + "/" + created_name).c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW, 0666);
  if (created >= 0) close(created);
  const int reason = rename_to_new(unmarked, folder_);
  if (reason != 0 && !fs::is_directory(folder_, error))
    throw Failure(folder_ + ": cannot make the folder: " + std::strerror(reason));
  return reason == 0;
}

void Scratch::clear_rows() const {
  std::error_code error;
  for (const char* part : {"triangles", "partials", "runs"}) {
    fs::remove_all(folder_ + "/" + part, error);
    fs::create_directory(folder_ + "/" + part, error);
  }
  fs::remove(polygons(), error);
  fs::remove(holes(), error);
}

}  // namespace rbpa::app
