#include "io/laz/laz_records.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/laz/item_models.h"

namespace rbpa::app {
namespace {

constexpr std::size_t piece_bytes = std::size_t{8} << 20U;  // most bytes of a piece, compressed and decompressed
constexpr std::size_t all_bytes = 4 * piece_bytes;          // limit for the pieces that are decoded or wait
constexpr std::size_t window_points = 16384;                // points in a piece of a chunk whose size is not known
constexpr std::size_t most_growth = 8;  // most bytes of a compressed record for each byte of the record

std::string byte_of(const Content& content, std::uint64_t at) {
  return content.name() + ": byte " + std::to_string(at);
}

/// Throws BadInput for a file that promises more than 500 times its size, the limit of gzip files (input_bytes.h).
void require_ratio(const Content& content, std::size_t begin, std::size_t length, std::size_t points) {
  constexpr std::size_t always = std::size_t{64} << 20U, greatest_ratio = 500;
  const std::size_t size = content.size() - std::min(begin, content.size());
  if (content.is_compressed() || points <= always / length || points / greatest_ratio <= size / length) return;
  bad_input(byte_of(content, begin), counted(points, "point") + " in " + counted(size, "byte"),
            "points of at most 500 times as many bytes (laszip decompresses the file)");
}

/// Returns the number of 8 bytes at `at`.
std::uint64_t word_at(const Content& content, std::uint64_t at) {
  Content words = content.again();
  words.skip(at);
  const std::string_view bytes = words.ahead(8);
  if (bytes.size() < 8) bad_input(byte_of(content, at), "the end of the file", "the place of the table of chunks");
  return load_little<std::uint64_t>(bytes.data());
}

/// Returns the chunks of a file whose points begin at `begin`, with the place of the table of chunks; nothing if the
/// compressor was interrupted before it wrote a table. Together the chunks have `points` points and fit into the file.
/// Throws BadInput if the table is wrong.
std::optional<std::vector<LazChunk>> read_chunk_table(const Content& content, std::size_t begin,
                                                      const LazFormat& format, std::size_t points) {
  constexpr auto at_end = static_cast<std::uint64_t>(-1);  // the compressor could not go back in its output
  std::uint64_t place = word_at(content, begin);
  if (place == at_end && !content.is_compressed()) place = word_at(content, content.size() - 8);
  if (place == at_end || place == begin) return std::nullopt;
  const std::uint64_t version_and_count = place < begin + 8 || place > content.size() ? 1 : word_at(content, place);
  const std::string where = byte_of(content, place), all = counted(points, "point");
  if (version_and_count % (std::uint64_t{1} << 32U) != 0)
    bad_input(byte_of(content, begin), "byte " + std::to_string(place) + " as the place of a table of chunks",
              "a table of version 0 behind the points");
  const std::size_t count = version_and_count >> 32U, room = place - begin - 8;
  const bool varies = format.chunk_size == LazFormat::varying;
  Content table = content.again();
  table.skip(place + 8);
  constexpr std::size_t most_for_number = 8;  // bytes
  const std::string_view bytes = table.ahead(4 + 2 * most_for_number * std::min(count, room / format.length));
  std::vector<LazChunk> chunks;
  std::size_t left = points, left_bytes = room;
  if (count > 0) try {
      ArithmeticDecoder decoder(bytes);
      IntegerDecoder<32> numbers(2);
      for (LazChunk last{0, 0}; chunks.size() < count; chunks.push_back(last)) {
        last.points = varies ? numbers.decode(decoder, static_cast<std::uint32_t>(last.points), 0)
                             : std::min<std::size_t>(format.chunk_size, left);
        last.size = numbers.decode(decoder, static_cast<std::uint32_t>(last.size), 1);
        const bool is_empty = last.points == 0 && varies;  // some compressors write empty chunks
        if ((!is_empty && (last.points == 0 || last.size < format.length)) || last.points > left ||
            last.size > left_bytes)
          bad_input(where,
                    "a chunk of " + counted(last.points, "point") + " in " + counted(last.size, "byte") + " after " +
                        counted(chunks.size(), "chunk"),
                    "chunks of " + all + " in " + counted(room, "byte"));
        left -= last.points;
        left_bytes -= last.size;
      }
    } catch (const BadStream& fault) {
      bad_input(where, fault.found + " after " + counted(chunks.size(), "chunk"), counted(count, "chunk"));
    }
  if (left > 0) bad_input(where, counted(count, "chunk") + " without " + std::to_string(left) + " of the points", all);
  return chunks;
}

const std::string way_out = " (--skip-invalid reads the points before)";

}  // namespace

LazRecords::LazRecords(const Content& content, std::size_t begin, LazFormat format, std::size_t points,
                       LazChoice choice)
    : content_(content.again()), format_(std::move(format)), choice_(std::move(choice)), left_(points), place_(begin) {
  require_ratio(content, begin, format_.length, points);
  if (format_.has_chunks && points > 0) {
    try {
      table_ = read_chunk_table(content, begin, format_, points);
    } catch (const BadInput& e) {
      if (!choice_.skip_invalid) throw BadInput(e.what() + way_out);  // else read on without the table
    }
    place_ += 8;
    if (is_windowed() && format_.chunk_size == LazFormat::varying)
      bad_input(byte_of(content, begin), "chunks of various sizes without a table", "one behind them");
  }
  if (choice_.nodes) choose_chunks();
  content_.skip(place_);
  std::size_t greatest = table_ ? 1 : piece_bytes;  // bytes of a piece
  if (table_)
    for (const LazChunk& chunk : *table_) greatest = std::max(greatest, std::min(piece_bytes, bytes_of(chunk)));
  const std::size_t threads = choice_.threads > 0 ? choice_.threads : std::max(std::thread::hardware_concurrency(), 1U),
                    pieces = table_ ? table_->size() : left_ / window_points,
                    most = std::clamp<std::size_t>(std::min(all_bytes / greatest, pieces), 1, 2 * threads);
  pieces_.emplace(
      std::min(threads, most) - 1, most, [this](Piece& piece) { return make(piece); },
      [this](Piece& piece) { decode(piece); });
}

void LazRecords::choose_chunks() {
  if (!table_) bad_input(byte_of(content_, place_), "no table of chunks", "one behind the points, as COPC has");
  is_wanted_.resize(table_->size());
  left_ = 0;
  std::uint64_t place = place_;
  std::size_t k = 0;  // chunk
  for (const LazNode& node : *choice_.nodes) {
    while (k < table_->size() && place < node.begin) place += (*table_)[k++].size;
    if (k == table_->size() || place != node.begin || (*table_)[k].size != node.size ||
        (*table_)[k].points != node.points || is_wanted_[k])
      bad_input(byte_of(content_, node.entry),
                "a node of " + counted(node.points, "point") + " in " + counted(node.size, "byte") + " from byte " +
                    std::to_string(node.begin) + " on",
                "a chunk of the table, once (without --bounds and --resolution the hierarchy is not read)");
    is_wanted_[k] = true;
    left_ += node.points;
  }
}

std::string_view LazRecords::ahead() {
  while (skipped_ == piece_.records.size()) {
    if (!piece_.fault.empty() || !pieces_->next(piece_)) return {};
    skipped_ = 0;
  }
  return {piece_.records.data() + skipped_, piece_.records.size() - skipped_};
}

bool LazRecords::make(Piece& piece) {
  if (ended_ || (chunk_left_ == 0 && left_ == 0)) return false;
  stop_if_interrupted();
  try {
    if (chunk_left_ == 0) begin_chunk();
    piece.first = first_ - chunk_left_;
    const bool is_sized = chunk_.size > 0;
    if (is_sized && bytes_of(chunk_) <= piece_bytes) {
      piece.place = place_;
      piece.compressed.assign(window_.begin(), window_.end());  // as the view ends with the next chunk
      piece.points = std::exchange(chunk_left_, 0);
    } else {
      const std::size_t count =
          std::min({chunk_left_, piece_bytes / format_.length, is_sized ? chunk_left_ : window_points});
      if (!is_sized) window_ = content_.ahead((count + 1) * format_.length * most_growth);
      if (!is_sized && decoder_) decoder_->move_to(window_);
      if (!decoder_) decoder_.emplace(format_, choice_.wanted).begin(window_, chunk_.points);
      decode(*decoder_, count, piece);
      chunk_left_ -= count;
    }
    const std::size_t size = !is_sized          ? static_cast<std::size_t>(decoder_->at() - window_.data())
                             : chunk_left_ == 0 ? chunk_.size
                                                : 0;
    content_.skip(size);
    place_ += size;
    if (chunk_left_ == 0) decoder_.reset();
  } catch (const BadStream& fault) {
    ended_ = true;
    end_at(fault, window_, place_, piece);
  }
  piece.bytes_read = content_.bytes_read();
  return true;
}

void LazRecords::begin_chunk() {
  if (table_) {
    const auto is_wanted = [&](std::size_t k) {
      return (*table_)[k].points > 0 && (is_wanted_.empty() || is_wanted_[k]);
    };
    for (; !is_wanted(next_chunk_); ++next_chunk_) {
      content_.skip((*table_)[next_chunk_].size);
      place_ += (*table_)[next_chunk_].size;
      first_ += (*table_)[next_chunk_].points;
    }
    chunk_ = (*table_)[next_chunk_++];
  } else if (format_.is_layered) {
    chunk_ = layered_chunk(format_, require_ahead(format_.head()));
    if (chunk_.points == 0 || chunk_.points > left_)
      throw BadStream{window_.data() + format_.length, "a chunk of " + counted(chunk_.points, "point"),
                      "from 1 to " + std::to_string(left_) + " of them"};
  } else {
    chunk_ = {std::min<std::size_t>(left_, format_.chunk_size), 0};
  }
  require_ahead(chunk_.size);
  chunk_left_ = chunk_.points;
  left_ -= chunk_.points;
  first_ += chunk_.points;
}

std::string_view LazRecords::require_ahead(std::uint64_t size) {
  window_ = content_.ahead(size);
  if (window_.size() < size)
    throw BadStream{window_.data() + window_.size(), "the end of the file", "more compressed points"};
  return window_ = window_.substr(0, size);
}

void LazRecords::decode(Piece& piece) const {
  if (piece.compressed.empty()) return;
  const std::string_view bytes(piece.compressed.data(), piece.compressed.size());
  try {
    ChunkDecoder decoder(format_, choice_.wanted);
    decoder.begin(bytes, piece.points);
    decode(decoder, piece.points, piece);
  } catch (const BadStream& fault) {
    end_at(fault, bytes, piece.place, piece);
  }
}

void LazRecords::decode(ChunkDecoder& decoder, std::size_t points, Piece& piece) const {
  const std::size_t length = format_.length;
  piece.records.resize(points * length);
  std::size_t done = 0;
  try {
    for (; done < points; ++done) decoder.next(piece.records.data() + done * length);
  } catch (const BadStream&) {
    piece.records.resize(done * length);
    throw;
  }
}

void LazRecords::end_at(const BadStream& fault, std::string_view bytes, std::uint64_t place, Piece& piece) const {
  const std::string where = byte_of(content_, place + static_cast<std::uint64_t>(fault.at - bytes.data()));
  if (!choice_.skip_invalid) bad_input(where, fault.found, fault.expected + way_out);
  piece.fault = where + ": found " + fault.found;
}

}  // namespace rbpa::app
