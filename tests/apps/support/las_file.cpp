#include "support/las_file.h"

#include <cstring>

namespace apps_test {
namespace {

std::string padded(const std::string& text, std::size_t size) { return text + std::string(size - text.size(), '\0'); }

std::string bytes_of(const LasRecord& record, bool extended) {
  return little(0, 2) + padded(record.user, 16) + little(record.number, 2) +
         little(record.data.size(), extended ? 8 : 2) + padded("made by a test", 32) + record.data;
}

std::string wave_packet() { return little(1, 1) + std::string(28, '\x7F'); }

std::string bytes_of(const LasPoint& p, const LasFile& file) {
  std::string bytes = little(static_cast<std::uint32_t>(p.x), 4) + little(static_cast<std::uint32_t>(p.y), 4) +
                      little(static_cast<std::uint32_t>(p.z), 4) + little(p.intensity, 2);
  if (file.format < 6) {
    bytes += little(p.return_number | p.number_of_returns << 3U | p.scan_direction << 6U | p.edge << 7U, 1);
    bytes += little(file.minor == 0 ? p.classification
                                    : p.classification | p.synthetic << 5U | p.key_point << 6U | p.withheld << 7U,
                    1);
    bytes += little(static_cast<std::uint8_t>(p.scan_angle), 1) + little(p.user_data, 1) + little(p.source, 2);
  } else {
    bytes += little(p.return_number | p.number_of_returns << 4U, 1);
    bytes += little(p.synthetic | p.key_point << 1U | p.withheld << 2U | p.overlap << 3U | p.channel << 4U |
                        p.scan_direction << 6U | p.edge << 7U,
                    1);
    bytes += little(p.classification, 1) + little(p.user_data, 1) +
             little(static_cast<std::uint16_t>(p.scan_angle), 2) + little(p.source, 2);
  }
  const std::string time = little(p.time), color = little(p.red, 2) + little(p.green, 2) + little(p.blue, 2);
  const std::string infrared = little(p.infrared, 2);
  switch (file.format) {
    case 1:
    case 6:
      bytes += time;
      break;
    case 2:
      bytes += color;
      break;
    case 3:
    case 7:
      bytes += time + color;
      break;
    case 4:
    case 9:
      bytes += time + wave_packet();
      break;
    case 5:
      bytes += time + color + wave_packet();
      break;
    case 8:
      bytes += time + color + infrared;
      break;
    case 10:
      bytes += time + color + infrared + wave_packet();
      break;
    default:
      break;
  }
  return bytes + std::string(file.extra_bytes, '\x55');
}

}  // namespace

std::string little(std::uint64_t value, unsigned bytes) {
  std::string text;
  for (unsigned i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xFFU);
  return text;
}

std::string little(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return little(bits, 8);
}

std::string bytes_of(const LasFile& file) {
  const std::size_t header_size = file.minor < 3 ? 227 : file.minor == 3 ? 235 : 375;
  std::string records, points, extended;
  for (const LasRecord& record : file.records) records += bytes_of(record, false);
  for (const LasPoint& p : file.points) points += bytes_of(p, file);
  for (const LasRecord& record : file.extended) extended += bytes_of(record, true);
  const std::string signature = file.minor == 0 ? "\xDD\xCC" : "";
  const std::size_t begin = header_size + records.size() + (file.signature_counts ? 0 : signature.size());
  const std::size_t length = bytes_of(LasPoint{}, file).size();

  std::string header = "LASF" + little(0, 4) + std::string(16, '\0');  // source, encoding, project
  header += little(1, 1) + little(file.minor, 1) + padded("a system", 32) + padded("a test", 32) + little(326, 2);
  header += little(2026, 2) + little(header_size, 2) + little(begin, 4) + little(file.records.size(), 4);
  header += little(file.format, 1) + little(length, 2);
  const bool legacy = file.minor < 4 || file.format < 6;
  header += little(legacy ? file.points.size() : 0, 4) + std::string(20, '\0');
  for (const double scale : file.scale) header += little(scale);
  for (const double offset : file.offset) header += little(offset);
  header += std::string(48, '\0');                      // the box
  if (file.minor >= 3) header += std::string(8, '\0');  // wave packets
  if (file.minor >= 4) {
    header += little(file.extended.empty() ? 0 : begin + points.size(), 8) + little(file.extended.size(), 4);
    header += little(file.points.size(), 8) + std::string(120, '\0');
  }
  return header + records + signature + points + extended;
}

}  // namespace apps_test
