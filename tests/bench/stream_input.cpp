#include "bench/stream_input.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "bench/stopwatch.h"
#include "io/bytes/npy.h"
#include "io/cloud/point_blocks.h"

namespace rbpa_bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t points_at_once = std::size_t{1} << 16U;

/// Open file.
class File {
 public:
  File(const std::string& path, int flags) : path_(path), descriptor_(open(path.c_str(), flags | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) fail();
  }
  ~File() { close(descriptor_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  void write(const void* data, std::size_t size) {
    for (const char* at = static_cast<const char*>(data); size > 0;) {
      const ssize_t count = ::write(descriptor_, at, size);
      if (count < 0 && errno != EINTR) fail();
      if (count <= 0) continue;
      at += count;
      size -= static_cast<std::size_t>(count);
    }
  }
  void to_disk() {
    if (fsync(descriptor_) != 0) fail();
  }
  int descriptor() const { return descriptor_; }
  std::size_t size() const {
    struct stat status {};
    if (fstat(descriptor_, &status) != 0) fail();
    return static_cast<std::size_t>(status.st_size);
  }

 private:
  [[noreturn]] void fail() const { throw std::runtime_error(path_ + ": " + std::strerror(errno)); }
  std::string path_;
  int descriptor_;
};

/// Returns the bytes of a file that are in the system's cache.
double cached_bytes(const File& file) {
  const std::size_t size = file.size();
  if (size == 0) return 0;
  void* const at = mmap(nullptr, size, PROT_READ, MAP_SHARED, file.descriptor(), 0);
  if (at == MAP_FAILED) return 0;
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  std::vector<unsigned char> is_there((size + page - 1) / page);
  double pages = 0;
  if (mincore(at, size, is_there.data()) == 0)
    pages = static_cast<double>(
        std::count_if(is_there.begin(), is_there.end(), [](unsigned char there) { return (there & 1U) != 0; }));
  munmap(at, size);
  return pages * static_cast<double>(page);
}

std::string text_of(const Wanted& wanted) {
  return std::string(wanted.ground == Ground::uniform ? "uniform" : "jittered") + " " + std::to_string(wanted.points) +
         " seed " + std::to_string(wanted.seed) + " " + wanted.format + " " + std::to_string(wanted.files) + "\n";
}

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

PointFiles write_files(const Wanted& wanted, const std::string& folder) {
  fs::create_directories(folder);
  PointFiles made;
  for (std::size_t i = 0; i < wanted.files; ++i) {
    std::string number = std::to_string(i);
    number.insert(0, 4 - std::min<std::size_t>(number.size(), 4), '0');
    made.paths.push_back(folder + "/" + number + "." + wanted.format);
  }
  // The list is written last and marks the files as complete.
  const std::string list = folder + "/content.txt";
  if (content_of(list) != text_of(wanted)) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    LidarPoints points(wanted.ground, wanted.points, wanted.seed);
    std::vector<rbpa::Point> block;
    for (std::size_t i = 0; i < wanted.files; ++i) {
      const auto begin = [&](std::size_t file) {
        return wanted.points / wanted.files * file + std::min<std::uint64_t>(file, wanted.points % wanted.files);
      };
      std::uint64_t left = begin(i + 1) - begin(i);
      File file(made.paths[i], O_WRONLY | O_CREAT | O_TRUNC);
      if (wanted.format == "npy") {
        const std::string header = rbpa::app::npy_header("<f8", left, ", 2");
        file.write(header.data(), header.size());
      }
      for (; left > 0; left -= block.size()) {
        if (!points.next(block, std::min<std::uint64_t>(left, points_at_once)))
          throw std::logic_error("too few points");
        file.write(block.data(), block.size() * sizeof(rbpa::Point));
      }
      file.to_disk();
    }
    std::ofstream(list) << text_of(wanted);
  }
  for (const std::string& path : made.paths) made.bytes += static_cast<double>(fs::file_size(path));
  return made;
}

double forget(const PointFiles& files) {
  double cached = 0;
  for (const std::string& path : files.paths) {
    const File file(path, O_RDONLY);
    posix_fadvise(file.descriptor(), 0, 0, POSIX_FADV_DONTNEED);
    cached += cached_bytes(file);
  }
  return files.bytes > 0 ? std::min(cached / files.bytes, 1.0) : 0;
}

double seconds_to_read(const PointFiles& files) {
  const Stopwatch watch;
  for (const std::string& path : files.paths) {
    const auto format = path.ends_with(".npy") ? rbpa::app::Format::npy : rbpa::app::Format::raw;
    const std::unique_ptr<rbpa::app::PointBlocks> blocks =
        rbpa::app::open_point_blocks({.path = path, .format = format});
    for (std::vector<rbpa::Point> block; blocks->next(block);) {
    }
  }
  return watch.seconds();
}

double seconds_to_write(const std::string& path, double bytes) {
  // The bytes differ, because a disk may compress equal ones.
  std::vector<std::uint64_t> block(std::size_t{1} << 17U);
  std::uint64_t number = 1;
  for (std::uint64_t& word : block) word = number = number * 0x5851f42d4c957f2dU + 0x14057b7ef767814fU;
  const Stopwatch watch;
  {
    File file(path, O_WRONLY | O_CREAT | O_TRUNC);
    const auto all = static_cast<std::uint64_t>(bytes);
    for (std::uint64_t done = 0; done < all;) {
      const std::uint64_t some = std::min<std::uint64_t>(all - done, block.size() * sizeof block[0]);
      ++block[0];
      file.write(block.data(), some);
      done += some;
    }
    file.to_disk();
  }
  const double seconds = watch.seconds();
  fs::remove(path);
  return seconds;
}

}  // namespace rbpa_bench
