// Prints a table of every format read and written, each next to the same bytes read by fread() or written by fwrite(),
// as in docs/reference/file_formats.md. Files lie in the folder for temporary files; files that are read are in the
// system's cache.
//   bench_io [--runs=N] [--points=N]      5 runs of each in turn, on 1,000,000 points
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/machine.h"
#include "bench/timings.h"
#include "io/bytes/number.h"
#include "io/bytes/output_file.h"
#include "io/cloud/read_points.h"
#include "io/formats.h"
#include "io/mesh/read_mesh.h"
#include "io/mesh/write_triangles.h"
#include "rbpa/rbpa.h"

namespace rbpa_bench {
namespace {

namespace fs = std::filesystem;
using rbpa::Point;
using rbpa::app::OutputFile;
using rbpa::app::Triangle;
using rbpa::app::Use;

/// Temporary folder, removed at the end.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("bench_io-" + std::to_string(getpid()))) {
    fs::create_directory(path_);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

Stream open(const std::string& path, const char* mode) {
  Stream stream(std::fopen(path.c_str(), mode), std::fclose);
  if (!stream) throw std::runtime_error(path + ": cannot be opened");
  std::setvbuf(stream.get(), nullptr, _IONBF, 0);
  return stream;
}

constexpr std::size_t block_size = std::size_t{1} << 20U;

/// Reads all of a file through one block.
void read_plainly(const std::string& path) {
  std::vector<char> block(block_size);
  const Stream stream = open(path, "rb");
  while (std::fread(block.data(), 1, block.size(), stream.get()) == block.size()) continue;
}

/// Writes as many bytes as `like` has, from one block; they are on the disk when it returns.
void write_plainly(const std::string& path, const std::string& like) {
  const std::vector<char> block(block_size, '1');
  const Stream stream = open(path, "wb");
  for (std::size_t left = fs::file_size(like); left > 0;) {
    const std::size_t size = std::min(left, block.size());
    if (std::fwrite(block.data(), 1, size, stream.get()) != size)
      throw std::runtime_error(path + ": cannot be written");
    left -= size;
  }
  if (fsync(fileno(stream.get())) != 0) throw std::runtime_error(path + ": cannot be written");
}

/// Milliseconds of the processor, including the system's work, and of the clock, which includes waiting for the disk
/// and for other processes.
struct Times {
  Timings processor, clock;

  void add(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    const double used = used_milliseconds();
    work();
    processor.of.push_back(used_milliseconds() - used);
    clock.of.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }

 private:
  static double used_milliseconds() {
    timespec used{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
    return 1e3 * static_cast<double>(used.tv_sec) + 1e-6 * static_cast<double>(used.tv_nsec);
  }
};

struct Row {
  std::string name;
  std::string file;  ///< the file read or written
  std::size_t items;
  std::function<void()> ours, plain;
  Times of_ours = {}, of_plain = {};
};

class Table {
 public:
  explicit Table(std::size_t count) {
    std::mt19937_64 random(1);
    const auto coordinate = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53 * 1000; };
    for (std::size_t i = 0; i < count; ++i) {
      const double x = coordinate();
      points_.push_back({x, coordinate()});
      short_points_.push_back({std::round(x * 1e6) / 1e6, std::round(points_.back().y * 1e6) / 1e6});
    }
    triangles_ = rbpa::triangles(rbpa::rbpa(points_, std::numeric_limits<double>::infinity()));
    add_rows();
  }

  void run(int runs) {
    for (int i = 0; i < runs; ++i)
      for (Row& row : rows_) {
        row.of_plain.add(row.plain);
        row.of_ours.add(row.ours);
      }
  }

  void print() const {
    std::printf("| | MB | ms | MB/s | ns a point or triangle | ms, clock | plain, ms | plain, ms, clock |\n");
    std::printf("|---|--:|--:|--:|--:|--:|--:|--:|\n");
    for (const Row& row : rows_) {
      const double bytes = static_cast<double>(fs::file_size(row.file)), ms = row.of_ours.processor.median();
      std::printf("| %s | %.1f | %s | %.0f | %.1f | %.1f | %s | %.1f |\n", row.name.c_str(), bytes / 1e6,
                  row.of_ours.processor.text(1).c_str(), bytes / 1e3 / ms, 1e6 * ms / static_cast<double>(row.items),
                  row.of_ours.clock.median(), row.of_plain.processor.text(1).c_str(), row.of_plain.clock.median());
    }
  }

 private:
  void add_rows() {
    const std::string xy = table("p.xy", points_, " "), csv = table("p.csv", points_, ","),
                      short_xy = table("short.xy", short_points_, " ");
    add_read_points("read .xy, 17 digits", xy);
    add_read_points("read .csv, 17 digits", csv);
    add_read_points("read .xy, 6 places", short_xy);
    add_read_points("read .f64xy", raw("p.f64xy"));
    add_read_points("read .csv, columns by their header", headed("headed.csv"));
    add_read_points("read .xy.gz, 6 places", compressed("short.xy.gz", short_xy));
    add_read_points("read .las, 1.2, format 1", las("p.las"));
    add_read_points("read .geojson, a MultiPoint", geojson("p.geojson"));
    add_read_points("read .wkt, a MULTIPOINT", wkt("p.wkt"));
    for (const std::string format : {"off", "obj", "ply", "npy"}) {
      write(format, "m", triangles_);
      write(format, "v", {});
    }
    for (const std::string format : {"off", "ply"})
      add_read_points("read the points of a mesh ." + format, folder_.file("m." + format));
    for (const std::string format : {"off", "obj", "ply"}) add_read_mesh(format);
    for (const std::string format : {"off", "obj", "ply"}) {
      add_write("write ." + format + ", points alone", format, "v", {}, points_.size());
      add_write("write ." + format, format, "m", triangles_, triangles_.size());
    }
    add_write("write .npy", "npy", "m", triangles_, triangles_.size());
    write("vtu", "m", triangles_);
    add_write("write .vtu", "vtu", "m", triangles_, triangles_.size());
  }

  std::string table(const std::string& name, const std::vector<Point>& points, std::string_view separator) {
    OutputFile file(folder_.file(name));
    for (const Point& p : points) {
      file.write_number(p.x);
      file.write(separator);
      file.write_number(p.y);
      file.write("\n");
    }
    file.finish();
    file.publish();
    return folder_.file(name);
  }
  std::string raw(const std::string& name) {
    OutputFile file(folder_.file(name));
    for (const Point& p : points_) file.write_binary(std::span<const double>({{p.x, p.y}}));
    file.finish();
    file.publish();
    return folder_.file(name);
  }
  std::string bytes(const std::string& name, std::string_view content) {
    OutputFile file(folder_.file(name));
    file.write(content);
    file.finish();
    file.publish();
    return folder_.file(name);
  }
  /// Writes a file as exports do: a number of the point, a name, then longitude and latitude in degrees.
  std::string headed(const std::string& name) {
    std::string content = "id,name,lon,lat\n";
    for (std::size_t i = 0; i < short_points_.size(); ++i)
      content +=
          std::to_string(i) + ",tree," + text(short_points_[i].x / 10) + ',' + text(short_points_[i].y / 20) + '\n';
    return bytes(name, content);
  }
  std::string compressed(const std::string& name, const std::string& path) {
    const std::size_t size = fs::file_size(path);
    std::string content(size, '\0');
    if (std::fread(content.data(), 1, size, open(path, "rb").get()) != size) throw std::runtime_error(path);
    const gzFile file = gzopen(folder_.file(name).c_str(), "wb");
    gzwrite(file, content.data(), static_cast<unsigned>(size));
    if (gzclose(file) != Z_OK) throw std::runtime_error(name + ": cannot be compressed");
    return folder_.file(name);
  }
  /// Writes LAS version 1.2, records of 28 bytes, coordinates in thousandths.
  std::string las(const std::string& name) {
    constexpr std::size_t header_size = 227, record_size = 28;
    std::string content(header_size + record_size * points_.size(), '\0');
    const auto put = [&](std::size_t at, auto value) { std::memcpy(content.data() + at, &value, sizeof value); };
    content.replace(0, 4, "LASF");
    put(24, std::uint16_t{0x0201});
    put(94, static_cast<std::uint16_t>(header_size));
    put(96, static_cast<std::uint32_t>(header_size));
    put(104, std::uint8_t{1});
    put(105, static_cast<std::uint16_t>(record_size));
    put(107, static_cast<std::uint32_t>(points_.size()));
    for (const std::size_t at : {131U, 139U, 147U}) put(at, 0.001);
    for (const std::size_t at : {179U, 195U, 211U}) put(at, 1000.0);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      put(header_size + record_size * i, static_cast<std::int32_t>(1000 * points_[i].x));
      put(header_size + record_size * i + 4, static_cast<std::int32_t>(1000 * points_[i].y));
    }
    return bytes(name, content);
  }
  std::string geojson(const std::string& name) {
    std::string content = R"({"type": "MultiPoint", "coordinates": [)";
    for (const Point& p : short_points_)
      content += (&p == short_points_.data() ? "[" : ", [") + text(p.x) + ", " + text(p.y) + ']';
    return bytes(name, content + "]}\n");
  }
  std::string wkt(const std::string& name) {
    std::string content = "MULTIPOINT (";
    for (const Point& p : short_points_)
      content += (&p == short_points_.data() ? "(" : ", (") + text(p.x) + ' ' + text(p.y) + ')';
    return bytes(name, content + ")\n");
  }
  static std::string text(double value) {
    char digits[rbpa::app::number_room];
    return {digits, rbpa::app::put_number(digits, value)};
  }
  void write(const std::string& format, const std::string& name, std::span<const Triangle> triangles) {
    OutputFile file(folder_.file(name + "." + format));
    rbpa::app::write_triangles(file, *rbpa::app::find_format(Use::triangles, format), {points_, triangles});
    file.finish();
    file.publish();
  }

  void add_read_points(const std::string& name, const std::string& path) {
    const auto read = [path, this] {
      const auto format = rbpa::app::find_format(Use::points, rbpa::app::input_ending(path));
      if (rbpa::app::read_points({path, *format}).points.size() != points_.size())
        throw std::runtime_error(path + ": other points");
    };
    rows_.push_back({name, path, points_.size(), read, [path] { read_plainly(path); }});
  }
  void add_read_mesh(const std::string& format) {
    const std::string path = folder_.file("m." + format);
    const auto read = [path, format, this] {
      if (rbpa::app::read_mesh({path, *rbpa::app::find_format(Use::mesh, format)}).soup.faces() != triangles_.size())
        throw std::runtime_error(path + ": other faces");
    };
    rows_.push_back({"read the mesh ." + format, path, triangles_.size(), read, [path] { read_plainly(path); }});
  }
  void add_write(const std::string& row, const std::string& format, const std::string& name,
                 std::span<const Triangle> triangles, std::size_t items) {
    const std::string path = folder_.file(name + "." + format), other = folder_.file("plain");
    rows_.push_back({row, path, items, [=, this] { write(format, name, triangles); },
                     [=] {
                       fs::remove(other);  // so that both begin with a new file
                       write_plainly(other, path);
                     }});
  }

  Folder folder_ = {};
  std::vector<Point> points_ = {}, short_points_ = {};
  std::vector<Triangle> triangles_ = {};
  std::vector<Row> rows_ = {};
};

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  const auto arguments = parse(argc, argv);
  if (!arguments) return 2;
  try {
    Table table(arguments->points);
    std::printf("%s; one thread, %d runs of each in turn. Times of\nthe processor: median (min–max).\n\n",
                machine_and_build().c_str(), arguments->runs);
    table.run(arguments->runs);
    table.print();
  } catch (const std::exception& error) {
    std::cerr << "bench_io: " << error.what() << '\n';
    return 1;
  }
}
