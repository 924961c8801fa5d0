// LAZ: files of other programs, and files that the encoder of support/laz_file.h compresses, have the records that they
// were made of; and files that lie are refused.
#include <doctest/doctest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/cloud/las_fields.h"
#include "io/cloud/las_header.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/laz/laz_records.h"
#include "rbpa/base/error.h"
#include "support/data_folder.h"
#include "support/las_file.h"
#include "support/laz_file.h"
#include "support/program.h"

using namespace apps_test;
using namespace rbpa::app;
using Table = LazOptions::Table;

namespace {

/// Calls take() with the records of a file, compressed or not, some at a time; `wanted` as for ChunkDecoder. Returns
/// why records are left out.
template <typename Take>
std::string for_records(const Content& content, const Take& take, std::vector<bool> wanted = {},
                        bool skip_invalid = false, unsigned threads = 0) {
  Content bytes = content.again();
  LasHeader header = read_las_header(bytes.ahead(65536), content.size(), content.name());
  const std::string_view first = bytes.ahead(header.begin + 2);
  header = read_las_header(first, content.size(), content.name());
  const std::size_t count = header.count.room();
  if (!header.is_compressed) {
    take(bytes.ahead(header.begin + count * header.length).substr(header.begin, count * header.length));
    return "";
  }
  if (wanted.empty()) wanted.assign(header.length, true);
  LazRecords records(content, header.begin,
                     read_laz_format(laszip_record(first, header), header.length, content.name()), count,
                     {.wanted = wanted, .skip_invalid = skip_invalid, .threads = threads});
  for (std::string_view some; !(some = records.ahead()).empty(); records.skip(some.size())) take(some);
  return records.fault();
}

std::string records_of(const Content& content, std::vector<bool> wanted = {}, bool skip_invalid = false) {
  std::string all;
  for_records(
      content, [&](std::string_view some) { all += some; }, std::move(wanted), skip_invalid);
  return all;
}
std::string records_of(const std::string& bytes, std::vector<bool> wanted = {}, bool skip_invalid = false) {
  return records_of(Content(bytes, "p.laz"), std::move(wanted), skip_invalid);
}

std::string refusal(const std::string& bytes) {
  try {
    const std::string all = records_of(bytes);
    return "none, but " + std::to_string(all.size()) + " bytes";
  } catch (const BadInput& error) {
    return error.what();
  }
}

/// The records of a file that some threads decode, and why it is refused or records are left out.
std::string outcome(const std::string& bytes, bool skip_invalid, unsigned threads) {
  std::string all, why;
  try {
    why = for_records(
        Content(bytes, "p.laz"), [&](std::string_view some) { all += some; }, {}, skip_invalid, threads);
  } catch (const BadInput& error) {
    return error.what();  // the records before are returned or not
  }
  return why + all;
}

/// The records of format `format` with `extra` bytes, like those of a scan; `wild`: all fields are random.
LasFile scan(unsigned format, std::size_t count, unsigned extra, bool wild, unsigned scanner_channels = 4) {
  std::mt19937 random(format + static_cast<unsigned>(count) + extra + (wild ? 1 : 0));
  const auto below = [&](std::uint32_t n) { return static_cast<unsigned>(random() % n); };
  const bool is_new = format >= 6;
  LasFile file{.minor = is_new ? 4U : 3U, .format = format, .extra_bytes = extra};
  LasPoint p{.x = 1000, .y = -5000, .z = 300, .time = 2.5e8};
  for (std::size_t i = 0; i < count; ++i) {
    if (wild) {
      p.x = static_cast<std::int32_t>(random());
      p.y = static_cast<std::int32_t>(random());
      p.z = static_cast<std::int32_t>(random());
    } else {
      p.x += 30 + static_cast<int>(below(5));
      p.y += static_cast<int>(below(200)) - 100;
      p.z = static_cast<std::int32_t>(300 + below(40));
    }
    p.intensity = wild ? below(65536) : below(300);
    p.number_of_returns = wild ? below(is_new ? 16 : 8) : 1 + below(3);
    p.return_number = wild ? below(is_new ? 16 : 8) : 1 + below(p.number_of_returns);
    p.scan_direction = below(2);
    p.edge = below(20) == 0;
    p.classification = below(is_new ? (wild ? 256 : 7) : 32);
    p.key_point = below(2);
    p.overlap = below(2);
    p.channel = below(5) == 0 ? below(scanner_channels) : p.channel;
    p.scan_angle =
        wild ? static_cast<int>(below(is_new ? 65536 : 256)) - (is_new ? 32768 : 128) : static_cast<int>(i % 50);
    p.user_data = below(wild ? 256 : 3);
    p.source = wild ? below(65536) : static_cast<unsigned>(i / 1000);
    if (below(3) != 0)
      p.time +=
          below(4) == 0 ? 100.0 * below(20) : 1e-5 * (below(9) == 0 ? below(7000) : 3) - (below(9) == 0 ? 1e-3 : 0);
    if (wild && below(4) == 0) p.time = static_cast<double>(random()) * 1e-3 - 1e6;
    p.red = wild ? below(65536) : below(256) * 257;
    p.green = below(3) == 0 ? p.red : below(65536);
    p.blue = below(2) == 0 ? p.green : below(65536);
    p.infrared = below(65536);
    file.points.push_back(p);
  }
  return file;
}

/// A file whose extra bytes and waves differ from point to point.
std::string las_of(const LasFile& file) {
  std::string bytes = bytes_of(file);
  const bool has_waves = file.format == 4 || file.format == 5 || file.format > 8;
  const std::size_t varied = file.extra_bytes + (has_waves ? 29 : 0);
  const std::size_t length = static_cast<std::uint8_t>(bytes[105]), all = file.points.size() * length;
  std::mt19937 random(3);
  for (std::size_t i = 0; i < file.points.size(); ++i)
    for (std::size_t k = 0; k < varied; ++k)
      if (random() % 3 != 0)
        bytes[bytes.size() - all + (i + 1) * length - 1 - k] =
            static_cast<char>(random() % 4 == 0 ? random() : i * k / 3);
  return bytes;
}

std::vector<LazItemSpec> layered_items(unsigned format, unsigned extra, unsigned version) {
  std::vector<LazItemSpec> items = {{10, 30, version}};
  if (format == 7) items.push_back({11, 6, version});
  if (format == 8) items.push_back({12, 8, version});
  if (extra > 0) items.push_back({14, extra, version});
  return items;
}

std::uint64_t hash_of(const std::string& bytes) {  // FNV-1a
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return hash;
}

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_SUITE("laz") {
  TEST_CASE("files of other programs have the records of their uncompressed twins") {
    struct Twin {
      std::string name;
      std::size_t size;    ///< of the records of the twin, in bytes
      std::uint64_t hash;  ///< of these records
    };
    for (const Twin& twin :
         {Twin{"extrabytes.laz", 64965, 0x2779802FD6672310}, Twin{"no-points-1.3.laz", 0, 0xCBF29CE484222325},
          Twin{"point-color-time.las.laz", 36210, 0x0360CEED3D71A2C2},
          Twin{"point-color.las.laz", 27690, 0x26383F83EF8721F5},
          Twin{"point-time-1.4.las.laz", 29820, 0x1732189C0D3744DF},
          Twin{"point-time.las.laz", 29820, 0x1732189C0D3744DF},
          Twin{"point-version-1-point-wise.laz", 235620, 0x3814F979B0C89B62},
          Twin{"point10-1.0.laz", 20, 0x31CDB7A69539FB6A}, Twin{"point10.las.laz", 21300, 0xE4A447F17ABA6024}}) {
      CAPTURE(twin.name);
      const std::string path = std::string(RBPA_TEST_DATA) + "/laz/" + twin.name;
      const std::string records = records_of(content_of(path));
      CHECK(records.size() == twin.size);
      CHECK(hash_of(records) == twin.hash);
      CHECK(records_of(Content::of_file(path, false)) == records);
    }
  }

  TEST_CASE("further LAZ files have the records of their uncompressed twins") {
    if (!rbpa_test::has_further_data()) return;
    std::size_t twins = 0;
    const std::filesystem::path folder = rbpa_test::further_data() / "laz";
    if (!std::filesystem::is_directory(folder)) return;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() != ".laz") continue;
      std::filesystem::path twin = entry.path();
      twin.replace_extension("");
      if (twin.extension() != ".las") twin += ".las";
      if (!std::filesystem::exists(twin)) continue;
      CAPTURE(entry.path());
      CHECK(records_of(content_of(entry.path())) == records_of(content_of(twin)));
      ++twins;
    }
    CHECK(twins > 0);
  }

  TEST_CASE("further points of COPC are those that laz-perf 0.0.7 of npm decodes") {
    const std::filesystem::path path = rbpa_test::further_data() / "laz" / "lone-star.copc.laz";
    if (!rbpa_test::has_further_data() || !std::filesystem::exists(path)) return;
    const std::string records = records_of(content_of(path));
    CHECK(records.size() == 518'862 * 30);
    CHECK(hash_of(records) == 0x2FB37E33B11FE2FA);
  }

  TEST_CASE("layers of formats 6 to 8 are decoded, in both versions, for all channels and every field") {
    for (const unsigned format : {6U, 7U, 8U})
      for (const unsigned version : {3U, 4U})
        for (const unsigned extra : {0U, 3U})
          for (const bool wild : {false, true})
            for (const unsigned channels : {1U, 4U}) {
              CAPTURE(format);
              CAPTURE(version);
              CAPTURE(extra);
              CAPTURE(wild);
              CAPTURE(channels);
              const std::string las = las_of(scan(format, 3000, extra, wild, channels));
              const std::string laz = laz_of(las, {.compressor = 3,
                                                   .items = layered_items(format, extra, version),
                                                   .chunks = {1, 1200, 1799},
                                                   .varies = true});
              CHECK(records_of(laz) == records_of(las));
            }
  }

  TEST_CASE("of layers only those of wanted bytes are decoded, and these are right") {
    const std::string las = las_of(scan(8, 2000, 2, false));
    const std::string laz = laz_of(las, {.compressor = 3, .items = layered_items(8, 2, 4), .chunks = {1000, 1000}});
    const std::string all = records_of(las);
    constexpr std::size_t length = 40;
    for (std::size_t k = 0; k < length; ++k) {
      CAPTURE(k);
      std::vector<bool> wanted(length);
      for (std::size_t i = 0; i < 8; ++i) wanted[i] = true;
      wanted[k] = true;
      const std::string some = records_of(laz, wanted);
      bool equal = some.size() == all.size();
      for (std::size_t i = 0; equal && i < all.size(); ++i) equal = !wanted[i % length] || some[i] == all[i];
      CHECK(equal);
    }
  }

  TEST_CASE("items of version 1, waves and extra bytes are decoded point by point") {
    for (const bool wild : {false, true}) {
      CAPTURE(wild);
      const auto same = [&](unsigned format, unsigned extra, std::vector<LazItemSpec> items) {
        CAPTURE(format);
        const std::string las = las_of(scan(format, 5000, extra, wild));
        CHECK(records_of(laz_of(las, {.items = std::move(items), .chunks = {2500, 2500}})) == records_of(las));
      };
      same(0, 4, {{0, 20, 2}, {0, 4, 1}});
      same(1, 0, {{0, 20, 2}, {7, 8, 1}});
      same(3, 0, {{0, 20, 2}, {7, 8, 1}, {8, 6, 1}});
      same(5, 0, {{0, 20, 2}, {7, 8, 1}, {8, 6, 1}, {9, 29, 1}});
    }
  }

  TEST_CASE("chunks are found by tables of every kind, and without") {
    const std::string las = las_of(scan(0, 1000, 0, false)), records = records_of(las);
    const std::vector<LazItemSpec> items = {{0, 20, 2}};
    for (const Table table : {Table::behind, Table::at_end, Table::none}) {
      CHECK(records_of(laz_of(las, {.items = items, .chunks = {300, 300, 300, 100}, .table = table})) == records);
      CHECK(records_of(laz_of(las, {.items = items, .chunks = {1000}, .table = table})) == records);
    }
    CHECK(records_of(laz_of(las, {.items = items, .chunks = {1, 500, 2, 497}, .varies = true})) == records);
    CHECK(records_of(laz_of(las, {.compressor = 1, .items = items, .chunks = {1000}})) == records);
    CHECK(refusal(laz_of(las, {.items = items, .chunks = {500, 500}, .varies = true, .table = Table::none})) ==
          "p.laz: byte 329: found chunks of various sizes without a table, expected one behind them");
    const std::string layered = las_of(scan(6, 1000, 0, false));
    for (const Table table : {Table::behind, Table::none})
      CHECK(records_of(laz_of(layered, {.compressor = 3,
                                        .items = layered_items(6, 0, 3),
                                        .chunks = {1, 500, 499},
                                        .varies = true,
                                        .table = table})) == records_of(layered));
  }

  TEST_CASE("chunks that are larger than a piece, and windows, are decoded piece by piece") {
    const std::string las = las_of(scan(0, 500'000, 0, false)), records = records_of(las);
    for (const unsigned compressor : {1U, 2U}) {
      const std::string laz = laz_of(las, {.compressor = compressor, .items = {{0, 20, 2}}, .chunks = {500'000}});
      const Folder folder;
      CHECK(records_of(laz) == records);
      CHECK(records_of(Content::of_file(folder.file("p.laz", laz), false)) == records);
    }
  }

  TEST_CASE("how ten million points are decoded, in memory for some chunks only" * doctest::skip()) {
    const Folder folder;
    constexpr std::size_t times = 100, length = 40;
    std::string records;
    {
      std::string las = las_of(scan(8, 100'000, 2, false));
      records = records_of(las);
      REQUIRE(records.size() == 100'000 * length);
      for (std::size_t i = 1; i < times; ++i) las += records;
      las.replace(247, 8, little(times * 100'000, 8));
      std::vector<std::size_t> chunks;
      for (std::size_t i = 0; i < times; ++i) chunks.insert(chunks.end(), {1, 30'000, 69'999});
      folder.file("p.laz",
                  laz_of(las, {.compressor = 3, .items = layered_items(8, 2, 3), .chunks = chunks, .varies = true}));
    }
    const auto resident = [] {
      std::ifstream file("/proc/self/statm");
      std::size_t all = 0, pages = 0;
      file >> all >> pages;
      return pages * 4096;
    };
    const std::size_t before = resident();
    std::size_t most = before, done = 0;
    bool equal = true;
    for_records(Content::of_file(folder.path("p.laz"), true), [&](std::string_view some) {
      for (std::size_t size = 0; !some.empty(); some.remove_prefix(size), done += size) {
        const std::size_t at = done % records.size();
        size = std::min(some.size(), records.size() - at);
        equal = equal && some.substr(0, size) == std::string_view(records).substr(at, size);
      }
      most = std::max(most, resident());
    });
    CHECK(equal);
    CHECK(done == times * records.size());
    CHECK(most - before < std::size_t{64} << 20U);
  }

  TEST_CASE("points, fields and colors are those of LAS") {
    const std::string las = las_of(scan(7, 5000, 0, false));
    const std::string laz = laz_of(las, {.compressor = 3, .items = layered_items(7, 0, 3), .chunks = {3000, 2000}});
    for (const bool in_space : {false, true})
      for (const std::string where : {"", "classification == 2 or gps_time > 2.5e8 and red < 9999", "z > 3.2"}) {
        CAPTURE(where);
        const auto blocks = [&](const std::string& bytes) {
          CloudRequest request{.in_space = in_space};
          if (!where.empty()) request.where = Condition(where, names_of_las_fields());
          const auto cloud = las_reader.open(Content(bytes, "p"), request);
          std::vector<std::vector<double>> columns(12);
          for (CloudBlock block; cloud->next(block);) {
            for (std::size_t k = 0; k < 9; ++k)
              columns[k].insert(columns[k].end(), block.column[k].begin(), block.column[k].end());
            for (const auto i : block.index) columns[9].push_back(static_cast<double>(i));
          }
          cloud->finish();
          return columns;
        };
        CHECK(blocks(laz) == blocks(las));
      }
  }

  TEST_CASE("a file that is cut off anywhere is refused, and its whole points are read with --skip-invalid") {
    const std::string las = las_of(scan(6, 300, 1, false)), records = records_of(las);
    for (const bool layered : {false, true}) {
      LazOptions options{.compressor = layered ? 3U : 2U, .items = {{0, 31, 2}}, .chunks = {100, 100, 100}};
      if (layered) options.items = layered_items(6, 1, 3);
      const std::string laz = laz_of(las, options);
      REQUIRE(records_of(laz) == records);
      const std::size_t begin = laz.find(records.substr(0, 31));
      std::uint64_t place = 0;  // of the table
      std::memcpy(&place, &laz[begin - 8], sizeof place);
      for (std::size_t size = begin; size < laz.size(); size += layered ? 61 : 17) {
        CAPTURE(size);
        CHECK(refusal(laz.substr(0, size)).starts_with("p.laz: byte "));
        CHECK(refusal(laz.substr(0, size)).ends_with("(--skip-invalid reads the points before)"));
        const std::string some = records_of(laz.substr(0, size), {}, true);
        CHECK(some == records.substr(0, some.size()));
        if (size >= place) CHECK(some == records);
      }
    }
  }

  TEST_CASE("damaged bytes are refused in one sentence or give other points, within bounds") {
    std::mt19937 random(11);
    const std::string las = las_of(scan(7, 400, 2, false));
    for (const bool layered : {false, true}) {
      LazOptions options{.compressor = layered ? 3U : 2U, .items = {{0, 38, 2}}, .chunks = {200, 200}};
      if (layered) options.items = layered_items(7, 2, 3);
      const std::string laz = laz_of(las, options);
      for (int i = 0; i < 3000; ++i) {
        std::string damaged = laz;
        for (unsigned k = 0; k <= random() % 3; ++k)
          damaged[227 + random() % (damaged.size() - 227)] = static_cast<char>(random());
        try {
          records_of(damaged);
        } catch (const BadInput& error) {
          CHECK(std::string(error.what()).starts_with("p.laz: "));
        }
      }
    }
  }

  TEST_CASE("any number of threads gives the records and the refusal of one thread, also of damaged files") {
    std::mt19937 random(12);
    const std::string las = las_of(scan(7, 1000, 2, false));
    const std::vector<std::size_t> chunks = {150, 150, 150, 150, 150, 150, 100};
    std::size_t refused = 0, cut = 0;
    for (const unsigned compressor : {1U, 2U, 3U}) {
      LazOptions options{.compressor = compressor, .items = {{0, 38, 2}}, .chunks = chunks};
      if (compressor == 1) options.chunks = {1000};
      if (compressor == 3) options.items = layered_items(7, 2, 3);
      for (const Table table : {Table::behind, Table::none}) {
        options.table = table;
        const std::string laz = laz_of(las, options);
        for (int i = 0; i < 100; ++i) {
          std::string damaged = laz;
          if (i % 4 == 1) damaged.resize(400 + random() % (laz.size() - 400));
          for (unsigned k = 0; i % 4 > 1 && k < 3; ++k)
            damaged[400 + random() % (laz.size() - 400)] = static_cast<char>(random());
          for (const bool skip_invalid : {false, true}) {
            const std::string expected = outcome(damaged, skip_invalid, 1);
            refused += !skip_invalid && expected.starts_with("p.laz: ") ? 1U : 0U;
            cut += skip_invalid && expected.starts_with("p.laz: ") ? 1U : 0U;
            for (const unsigned threads : {2U, 5U}) CHECK(outcome(damaged, skip_invalid, threads) == expected);
          }
        }
      }
    }
    CHECK(refused > 100);
    CHECK(cut > 100);

    LazOptions options{.compressor = 3, .items = layered_items(7, 2, 3), .chunks = chunks};
    std::string laz = laz_of(las, options);
    const std::string records = records_of(las);
    const std::size_t at = laz.find(records.substr(450 * 38, 38)) + 38;  // behind the first record of a chunk
    laz[at] = static_cast<char>(151);
    for (const unsigned threads : {1U, 2U, 5U}) {
      const std::string why = "p.laz: byte " + std::to_string(at) + ": found a chunk of 151 points";
      CHECK(outcome(laz, false, threads) == why + ", expected 150 (--skip-invalid reads the points before)");
      CHECK(outcome(laz, true, threads) == why + records.substr(0, 450 * 38));
    }
  }

  TEST_CASE("an interruption ends the decoding by any number of threads") {
    const std::string las = las_of(scan(0, 1000, 0, false));
    const std::string laz = laz_of(las, {.items = {{0, 20, 2}}, .chunks = std::vector<std::size_t>(10, 100)});
    for (const unsigned threads : {1U, 2U, 5U}) {
      bool go_on = true;
      const Interruption interruption([&] { return go_on; });
      const auto cloud = las_reader.open(Content(laz, "p"), {.threads = threads});
      CloudBlock block;
      CHECK(cloud->next(block));
      go_on = false;
      CHECK_THROWS_AS(cloud->next(block), rbpa::Cancelled);
    }
  }

  TEST_CASE("headers, records of LASzip and tables that lie are refused with the byte") {
    const std::string las = las_of(scan(0, 1000, 0, false));
    const std::string laz = laz_of(las, {.items = {{0, 20, 2}}, .chunks = {500, 500}});
    const std::size_t record = 227 + 8 + 54, begin = 227 + 8 + 54 + 40;
    const auto with = [&](std::size_t at, const std::string& bytes) {
      std::string changed = laz;
      return changed.replace(at, bytes.size(), bytes);
    };
    const std::string of_laszip = "p.laz: the record of LASzip: found ";
    CHECK(refusal(with(record, little(4, 2))) == of_laszip + "compressor 4 with coder 0, expected 1, 2 or 3 with 0");
    CHECK(refusal(with(record + 2, little(1, 2))) ==
          of_laszip + "compressor 2 with coder 1, expected 1, 2 or 3 with 0");
    CHECK(refusal(with(record + 32, little(2, 2))) ==
          of_laszip + "40 bytes, expected 34, and 6 for each item of a point");
    CHECK(refusal(with(record + 34, little(5, 2))) ==
          of_laszip + "an item of type 5, version 2 and 20 bytes, expected one that compressor 2 writes here");
    CHECK(refusal(with(record + 36, little(21, 2))) ==
          of_laszip + "items of 21 bytes, expected 20, as a point record has");
    CHECK(contains(refusal(with(record + 38, little(3, 2))), "version 3"));
    CHECK(refusal(with(record - 54 + 2, "x")) == of_laszip + "0 bytes, expected 34, and 6 for each item of a point");
    CHECK(!contains(refusal(with(107, little(1001, 4))), "3 chunks"));
    CHECK(contains(refusal(with(107, little(1001, 4))), "expected "));
    CHECK(refusal(with(107, little(1'000'000'000, 4))).starts_with("p.laz: byte 329: found 1000000000 points in "));
    CHECK(refusal(with(begin, little(laz.size() + 1, 8))).starts_with("p.laz: byte 329: found byte "));
    CHECK(refusal(with(begin, little(5, 8))) ==
          "p.laz: byte 329: found byte 5 as the place of a table of chunks, expected a table of version 0 behind the "
          "points (--skip-invalid reads the points before)");
  }

  TEST_CASE("every verb reads .laz by its ending and by its content") {
    const Folder folder;
    const std::string las = las_of(scan(6, 2000, 0, false));
    folder.file("p.las", las);
    const std::string laz = laz_of(las, {.compressor = 3, .items = layered_items(6, 0, 3), .chunks = {1000, 1000}});
    for (const std::string name : {"p.laz", "q.copc.laz", "laz.las"}) folder.file(name, laz);
    const std::string arguments = " --alpha 3 -o - --output-format wkt";
    const std::string outline = folder.rbpa("shape p.las" + arguments).out;
    REQUIRE_FALSE(outline.empty());
    for (const std::string name : {"p.laz", "q.copc.laz", "laz.las", "- <p.laz"}) {
      CAPTURE(name);
      CHECK(folder.rbpa("shape " + name + arguments).out == outline);
    }
    CHECK(folder.rbpa("stream p.laz --alpha 3 -o o.wkt").code == 0);
    CHECK(folder.rbpa("shape p.las --alpha 3 -o e.wkt").code == 0);
    CHECK(folder.content("o.wkt") == folder.content("e.wkt"));
    folder.file("cut.laz", laz.substr(0, laz.size() / 2));
    CHECK(folder.rbpa("info cut.laz").code == 3);
    CHECK(folder.rbpa("info cut.laz --skip-invalid").out.starts_with("points      "));
  }
}
