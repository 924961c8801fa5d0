#include "support/laz_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <memory>

#include "support/las_file.h"

namespace apps_test {
namespace {

/// Counts of symbols, and where each begins in the range of 2^15.
struct Model {
  explicit Model(unsigned symbols) : counts(symbols, 1), starts(symbols), cycle(symbols) {
    update();
    left = cycle = (symbols + 6) >> 1U;
  }
  void update() {
    if ((total += cycle) > 32768) {
      total = 0;
      for (std::uint32_t& count : counts) total += count = (count + 1) >> 1U;
    }
    const std::uint32_t scale = 0x80000000U / total;
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < counts.size(); sum += counts[i++]) starts[i] = scale * sum >> 16U;
    cycle = std::min(5 * cycle >> 2U, static_cast<std::uint32_t>(counts.size() + 6) << 3U);
    left = cycle;
  }
  std::vector<std::uint32_t> counts, starts;
  std::uint32_t cycle, total = 0, left = 0;
};

struct BitModel {
  std::uint32_t zeros = 1, total = 2, zero = 4096, cycle = 4, left = 4;
};

class Encoder {
 public:
  void symbol(Model& model, unsigned symbol) {
    const bool is_last = symbol + 1 == model.counts.size();
    const std::uint32_t unit = length_ >> 15U, low = model.starts[symbol] * unit;
    narrow(low, is_last ? length_ - low : model.starts[symbol + 1] * unit - low);
    ++model.counts[symbol];
    if (--model.left == 0) model.update();
  }
  void bit(BitModel& model, unsigned bit) {
    const std::uint32_t low = model.zero * (length_ >> 13U);
    bit == 0 ? narrow(0, low) : narrow(low, length_ - low);
    if (bit == 0) ++model.zeros;
    if (--model.left != 0) return;
    if ((model.total += model.cycle) > 8192) {
      model.total = (model.total + 1) >> 1U;
      model.zeros = (model.zeros + 1) >> 1U;
      if (model.zeros == model.total) ++model.total;
    }
    model.zero = model.zeros * (0x80000000U / model.total) >> 18U;
    model.left = model.cycle = std::min(5 * model.cycle >> 2U, 64U);
  }
  void bits(unsigned bits, std::uint32_t value) {
    if (bits > 19) {
      this->bits(16, value & 0xFFFFU);
      value >>= 16U;
      bits -= 16;
    }
    const std::uint32_t unit = length_ >> bits;
    narrow(value * unit, unit);
  }
  void bits64(std::uint64_t value) {
    bits(32, static_cast<std::uint32_t>(value));
    bits(32, static_cast<std::uint32_t>(value >> 32U));
  }

  std::string done() {
    const bool one_more = length_ > 0x2000000U;
    const std::uint32_t before = base_;
    base_ += one_more ? 0x1000000U : 0x800000U;
    length_ = one_more ? 0x800000U : 0x8000U;
    if (base_ < before) carry();
    renormalize();
    return bytes_ + std::string(one_more ? 3 : 2, '\0');
  }

 private:
  void narrow(std::uint32_t low, std::uint32_t length) {
    const std::uint32_t before = base_;
    base_ += low;
    length_ = length;
    if (base_ < before) carry();
    if (length_ < 0x1000000U) renormalize();
  }
  void carry() {
    std::size_t at = bytes_.size() - 1;
    for (; bytes_[at] == '\xFF'; --at) bytes_[at] = '\0';
    ++bytes_[at];
  }
  void renormalize() {
    do {
      bytes_ += static_cast<char>(base_ >> 24U);
      base_ <<= 8U;
    } while ((length_ <<= 8U) < 0x1000000U);
  }

  std::string bytes_ = {};
  std::uint32_t base_ = 0, length_ = 0xFFFFFFFFU;
};

class Integers {
 public:
  explicit Integers(unsigned bits, unsigned contexts = 1) : bits_(bits), sizes_(contexts, Model(bits + 1)) {
    for (unsigned k = 1; k <= bits; ++k) digits_.emplace_back(1U << std::min(k, 8U));
  }
  void encode(Encoder& encoder, std::int32_t predicted, std::int32_t real, unsigned context = 0) {
    std::int64_t difference = std::int64_t{real} - predicted;
    const std::int64_t range = std::int64_t{1} << bits_;
    while (difference < -range / 2) difference += range;
    while (difference >= range / 2) difference -= range;
    k_ = 0;
    for (std::int64_t rest = difference <= 0 ? -difference : difference - 1; rest != 0; rest >>= 1U) ++k_;
    encoder.symbol(sizes_[context], k_);
    if (k_ == 0) return encoder.bit(bit_, static_cast<unsigned>(difference));
    if (k_ == 32) return;
    const auto number =
        static_cast<std::uint32_t>(difference < 0 ? difference + (std::int64_t{1} << k_) - 1 : difference - 1);
    if (k_ <= 8) return encoder.symbol(digits_[k_ - 1], number);
    encoder.symbol(digits_[k_ - 1], number >> (k_ - 8));
    encoder.bits(k_ - 8, number & ((1U << (k_ - 8)) - 1));
  }
  unsigned k() const { return k_; }

 private:
  unsigned bits_, k_ = 0;
  std::vector<Model> sizes_, digits_ = {};
  BitModel bit_ = {};
};

template <typename T>
T at(const char* record, std::size_t offset) {
  T value;
  std::memcpy(&value, record + offset, sizeof value);
  return value;
}
unsigned byte(const char* record, std::size_t offset) { return at<std::uint8_t>(record, offset); }

struct Models : std::map<unsigned, Model> {
  Model& get(unsigned context, unsigned symbols) { return try_emplace(context, symbols).first->second; }
};

/// An encoder of the items of a chunk after the first, with its layers, or in a stream of all items.
class Item {
 public:
  virtual ~Item() = default;
  /// Encodes the item at `now` to the layers; `channel` as in the decoder of LASzip.
  virtual void encode(const char* now, unsigned& channel) = 0;
  std::vector<std::shared_ptr<Encoder>> layers = {};

 protected:
  Encoder& layer(std::size_t i) { return *layers[i]; }
};

// --- point by point

class Bytes2 : public Item {
 public:
  Bytes2(const char* first, unsigned size) : last_(first, size), models_(size, Model(256)) {}
  void encode(const char* now, unsigned&) override {
    for (std::size_t i = 0; i < last_.size(); ++i)
      layer(0).symbol(models_[i], (byte(now, i) - byte(last_.data(), i)) & 255U);
    last_.assign(now, last_.size());
  }

 private:
  std::string last_;
  std::vector<Model> models_;
};

class Bytes1 : public Item {
 public:
  Bytes1(const char* first, unsigned size, bool colors) : last_(first, size), colors_(colors), integers_(8, size) {}
  void encode(const char* now, unsigned&) override {
    unsigned bits = 0;
    for (unsigned i = 0; i < last_.size(); ++i) bits |= unsigned{now[i] != last_[i]} << i;
    if (colors_) layer(0).symbol(used_, bits);
    for (unsigned i = 0; i < last_.size(); ++i)
      if (!colors_ || (bits >> i & 1U) != 0)
        integers_.encode(layer(0), static_cast<int>(byte(last_.data(), i)), static_cast<int>(byte(now, i)), i);
    last_.assign(now, last_.size());
  }

 private:
  std::string last_;
  bool colors_;
  Model used_ = Model(64);
  Integers integers_;
};

class Time1 : public Item {
 public:
  explicit Time1(const char* first) : last_(at<std::int64_t>(first, 0)) {}
  void encode(const char* now, unsigned&) override {
    const auto time = at<std::int64_t>(now, 0);
    const auto step = static_cast<std::int64_t>(static_cast<std::uint64_t>(time) - static_cast<std::uint64_t>(last_));
    const bool fits = step == static_cast<std::int32_t>(step);
    const auto short_step = static_cast<std::int32_t>(step);
    last_ = time;
    if (difference_ == 0) {
      layer(0).symbol(kinds_, step == 0 ? 0 : fits ? 1 : 2);
      if (step != 0 && fits) integers_.encode(layer(0), 0, difference_ = short_step, 0);
      if (!fits) layer(0).bits64(static_cast<std::uint64_t>(time));
      return;
    }
    if (step == 0) return layer(0).symbol(multiples_, 511);
    if (!fits) {
      layer(0).symbol(multiples_, 510);
      return layer(0).bits64(static_cast<std::uint64_t>(time));
    }
    const std::int64_t multiple = std::clamp<std::int64_t>(step / difference_, 0, 509);
    const auto symbol = static_cast<unsigned>(multiple);
    layer(0).symbol(multiples_, symbol);
    if (symbol == 1) {
      integers_.encode(layer(0), difference_, short_step, 1);
      difference_ = short_step;
      extremes_ = 0;
    } else if (symbol == 0) {
      integers_.encode(layer(0), difference_ / 4, short_step, 2);
      extreme(short_step);
    } else {
      integers_.encode(layer(0), static_cast<std::int32_t>(symbol * static_cast<std::uint32_t>(difference_)),
                       short_step,
                       symbol < 10   ? 3
                       : symbol < 50 ? 4
                                     : 5);
      if (symbol == 509) extreme(short_step);
    }
  }

 private:
  void extreme(std::int32_t step) {
    if (++extremes_ <= 3) return;
    difference_ = step;
    extremes_ = 0;
  }
  std::int64_t last_;
  std::int32_t difference_ = 0;
  int extremes_ = 0;
  Model kinds_ = Model(3), multiples_ = Model(512);
  Integers integers_ = Integers(32, 6);
};

class Wave13 : public Item {
 public:
  explicit Wave13(const char* first) : last_(first, 29) {}
  void encode(const char* now, unsigned&) override {
    Encoder& to = layer(0);
    to.symbol(index_, byte(now, 0));
    const auto before = at<std::uint64_t>(last_.data(), 1), offset = at<std::uint64_t>(now, 1);
    const auto size = at<std::uint32_t>(last_.data(), 9);
    const auto step = static_cast<std::int64_t>(offset - before);
    const unsigned kind = step == 0 ? 0 : offset == before + size ? 1 : step == static_cast<std::int32_t>(step) ? 2 : 3;
    to.symbol(kinds_[kind_], kind);
    kind_ = kind;
    if (kind == 2) {
      differences_.encode(to, difference_, static_cast<std::int32_t>(step));
      difference_ = static_cast<std::int32_t>(step);
    }
    if (kind == 3) to.bits64(offset);
    const auto next = [&](Integers& integers, std::size_t place, unsigned context) {
      integers.encode(to, at<std::int32_t>(last_.data(), place), at<std::int32_t>(now, place), context);
    };
    next(sizes_, 9, 0);
    next(places_, 13, 0);
    for (unsigned i = 0; i < 3; ++i) next(xyz_, 17 + 4 * i, i);
    last_.assign(now, 29);
  }

 private:
  std::string last_;
  Model index_ = Model(256);
  std::vector<Model> kinds_ = std::vector<Model>(4, Model(4));
  Integers differences_ = Integers(32), sizes_ = Integers(32), places_ = Integers(32), xyz_ = Integers(32, 3);
  std::int32_t difference_ = 0;
  unsigned kind_ = 0;
};

// --- layers

/// The median of the last five, as LASzip keeps them.
class Median {
 public:
  std::int32_t get() const { return v_[2]; }
  void add(std::int32_t v) {
    const bool was_high = high_;
    high_ = was_high ? v < v_[2] : !(v_[2] < v);
    v_.erase(was_high ? v_.end() - 1 : v_.begin());
    v_.insert(std::upper_bound(v_.begin(), v_.end(), v), v);
  }

 private:
  std::vector<std::int32_t> v_ = std::vector<std::int32_t>(5, 0);
  bool high_ = true;
};

unsigned return_context(unsigned n, unsigned r) {
  static constexpr unsigned char contexts[16][16] = {
      {0, 1, 2, 3, 4, 5, 3, 4, 4, 5, 5, 5, 5, 5, 5, 5}, {1, 0, 1, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3},
      {2, 1, 2, 4, 4, 4, 4, 4, 4, 4, 4, 3, 3, 3, 3, 3}, {3, 3, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4},
      {4, 3, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4}, {5, 3, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4},
      {3, 3, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4}, {4, 3, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4},
      {4, 3, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4}, {5, 3, 4, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4},
      {5, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4}, {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 4, 4, 4},
      {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 4, 4}, {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 4},
      {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5}, {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5}};
  return contexts[n][r];
}

class Point14 : public Item {
 public:
  Point14(const char* first, unsigned version) : version_(version), now_(byte(first, 15) >> 4U & 3U) {
    layers.resize(9);
    start(now_, first);
  }
  unsigned first_channel() const { return now_; }

  void encode(const char* now, unsigned& channel) override {
    Context* c = contexts_[now_].get();
    channel = version_ == 4 ? now_ : 0;
    const auto returns = [](const char* p) { return std::pair(byte(p, 14) & 15U, byte(p, 14) >> 4U); };
    const auto [last_r, last_n] = returns(c->last);
    unsigned context = last_r == 1 ? 1 : 0;
    context += last_r >= last_n ? 2 : 0;
    context += c->time_changed ? 4 : 0;
    const unsigned scanner = byte(now, 15) >> 4U & 3U;
    Context* next = c;
    if (scanner != now_ && contexts_[scanner]) next = contexts_[scanner].get();
    const char* last = next->last;  // of the channel of the point, if it has one
    const auto [r0, n0] = returns(last);
    const auto [r, n] = returns(now);
    const bool time_changed = std::memcmp(last + 22, now + 22, 8) != 0;
    const unsigned step = (r - r0) & 15U, how = step == 0 ? 0 : step == 1 ? 1 : step == 15 ? 2 : 3;
    const unsigned changed =
        (scanner != now_ ? 64U : 0U) | (at<std::uint16_t>(last, 20) != at<std::uint16_t>(now, 20) ? 32U : 0U) |
        (time_changed ? 16U : 0U) | (at<std::uint16_t>(last, 18) != at<std::uint16_t>(now, 18) ? 8U : 0U) |
        (n != n0 ? 4U : 0U) | how;
    layer(0).symbol(c->changed[context], changed);
    if (scanner != now_) {
      layer(0).symbol(c->channel, (scanner - now_ - 1) & 3U);
      if (!contexts_[scanner]) start(scanner, c->last);
      channel = now_ = scanner;
      c = contexts_[scanner].get();
    }
    if (n != n0) layer(0).symbol(c->counts.get(n0, 16), n);
    if (how == 3)
      time_changed ? layer(0).symbol(c->numbers.get(r0, 16), r) : layer(0).symbol(c->same_time, (step - 2) & 15U);
    const unsigned m = 2 * return_context(n, r) + (time_changed ? 1 : 0), single = n == 1 ? 1 : 0;
    const auto difference = [&](std::size_t offset) {
      return static_cast<std::int32_t>(at<std::uint32_t>(now, offset) - at<std::uint32_t>(c->last, offset));
    };
    const std::int32_t dx = difference(0), dy = difference(4);
    c->dx.encode(layer(0), c->x[m].get(), dx, single);
    c->x[m].add(dx);
    const unsigned kx = c->dx.k();
    c->dy.encode(layer(0), c->y[m].get(), dy, single + (kx < 20 ? kx & ~1U : 20));
    c->y[m].add(dy);
    const unsigned k = (kx + c->dy.k()) / 2, level = std::min(n > r ? n - r : r - n, 7U);
    c->z.encode(layer(1), c->last_z[level], at<std::int32_t>(now, 8), single + (k < 18 ? k & ~1U : 18));
    c->last_z[level] = at<std::int32_t>(now, 8);
    const unsigned kind = (r == 1 ? 2U : 0U) + (r >= n ? 1U : 0U), pair = 2 * kind + (time_changed ? 1 : 0);
    layer(2).symbol(c->classes.get((byte(c->last, 16) & 31U) * 2 + (kind == 3 ? 1 : 0), 256), byte(now, 16));
    const auto flags = [](const char* p) { return (byte(p, 15) & 15U) | (byte(p, 15) >> 2U & 48U); };
    layer(3).symbol(c->flags.get(flags(c->last), 64), flags(now));
    c->intensity.encode(layer(4), c->last_intensity[pair], at<std::uint16_t>(now, 12), kind);
    c->last_intensity[pair] = at<std::uint16_t>(now, 12);
    if ((changed & 8U) != 0)
      c->angle.encode(layer(5), at<std::int16_t>(c->last, 18), at<std::int16_t>(now, 18), time_changed ? 1 : 0);
    layer(6).symbol(c->user.get(byte(c->last, 17) / 4, 256), byte(now, 17));
    if ((changed & 32U) != 0) c->source.encode(layer(7), at<std::uint16_t>(c->last, 20), at<std::uint16_t>(now, 20));
    if (time_changed) encode_time(*c, at<std::int64_t>(now, 22));
    std::memcpy(c->last, now, 30);
    c->time_changed = time_changed;
  }

 private:
  struct Context {
    char last[30];
    bool time_changed = false;
    std::vector<Model> changed = std::vector<Model>(8, Model(128));
    Model channel = Model(3), same_time = Model(13), multiples = Model(515), kinds = Model(5);
    Models counts = {}, numbers = {}, classes = {}, flags = {}, user = {};
    Integers dx = Integers(32, 2), dy = Integers(32, 22), z = Integers(32, 20), intensity = Integers(16, 4),
             angle = Integers(16, 2), source = Integers(16), times = Integers(32, 9);
    std::array<Median, 12> x = {}, y = {};
    std::int32_t last_z[8];
    std::uint16_t last_intensity[8];
    std::int64_t last_time[4] = {};
    std::int32_t last_step[4] = {};
    int extremes[4] = {};
    unsigned here = 0, next = 0;
  };

  void start(unsigned channel, const char* from) {
    contexts_[channel] = std::make_unique<Context>();
    Context& c = *contexts_[channel];
    std::memcpy(c.last, from, 30);
    std::fill_n(c.last_z, 8, at<std::int32_t>(from, 8));
    std::fill_n(c.last_intensity, 8, at<std::uint16_t>(from, 12));
    c.last_time[0] = at<std::int64_t>(from, 22);
  }

  void encode_time(Context& c, std::int64_t time) {
    Encoder& to = layer(8);
    const auto step_from = [&](unsigned i) {
      return static_cast<std::int64_t>(static_cast<std::uint64_t>(time) - static_cast<std::uint64_t>(c.last_time[i]));
    };
    const auto fits = [](std::int64_t step) { return step == static_cast<std::int32_t>(step); };
    const std::int64_t step = step_from(c.here);
    const auto small = static_cast<std::int32_t>(step);
    const bool moves = c.last_step[c.here] != 0;
    if (!fits(step)) {
      for (unsigned i = 1; i < 4; ++i) {
        if (!fits(step_from((c.here + i) % 4))) continue;
        moves ? to.symbol(c.multiples, 511 + i) : to.symbol(c.kinds, 1 + i);
        c.here = (c.here + i) % 4;
        return encode_time(c, time);
      }
      moves ? to.symbol(c.multiples, 511) : to.symbol(c.kinds, 1);
      c.times.encode(to, static_cast<std::int32_t>(c.last_time[c.here] >> 32), static_cast<std::int32_t>(time >> 32),
                     8);
      to.bits(32, static_cast<std::uint32_t>(time));
      c.here = c.next = (c.next + 1) % 4;
      c.last_step[c.here] = 0;
      c.extremes[c.here] = 0;
    } else if (!moves) {
      to.symbol(c.kinds, 0);
      c.times.encode(to, 0, small, 0);
      c.last_step[c.here] = small;
      c.extremes[c.here] = 0;
    } else {
      const std::int64_t multiple = std::clamp<std::int64_t>(step / c.last_step[c.here], -10, 500);
      to.symbol(c.multiples, static_cast<unsigned>(multiple >= 0 ? multiple : 500 - multiple));
      const unsigned context = multiple == 1     ? 1
                               : multiple == 0   ? 7
                               : multiple == 500 ? 4
                               : multiple == -10 ? 6
                               : multiple < 0    ? 5
                               : multiple < 10   ? 2
                                                 : 3;
      c.times.encode(to,
                     static_cast<std::int32_t>(static_cast<std::uint32_t>(multiple) *
                                               static_cast<std::uint32_t>(c.last_step[c.here])),
                     small, context);
      if (multiple == 1) c.extremes[c.here] = 0;
      if ((multiple == 0 || multiple == 500 || multiple == -10) && ++c.extremes[c.here] > 3) {
        c.last_step[c.here] = small;
        c.extremes[c.here] = 0;
      }
    }
    c.last_time[c.here] = time;
  }

  unsigned version_, now_;
  std::array<std::unique_ptr<Context>, 4> contexts_;
};

/// Items whose models depend on the channel: colors (and infrared), and bytes.
class ChannelItem : public Item {
 public:
  ChannelItem(const char* first, const LazItemSpec& spec, unsigned channel) : spec_(spec), now_(channel) {
    layers.resize(spec.type == 11 ? 1 : spec.type == 12 ? 2 : spec.size);
    last_[channel].assign(first, spec.size);
  }
  void encode(const char* now, unsigned& channel) override {
    unsigned from = now_;
    if (channel != now_) {
      const bool is_new = last_[channel].empty();
      if (is_new) last_[channel] = last_[now_];
      if (is_new || spec_.version == 4) from = channel;
      now_ = channel;
    }
    std::string& last = last_[from];
    Models& models = models_[now_];
    if (spec_.type == 14) {
      for (unsigned i = 0; i < spec_.size; ++i)
        layer(i).symbol(models.get(i, 256), (byte(now, i) - byte(last.data(), i)) & 255U);
    } else {
      encode_color(now, last.data(), models);
      if (spec_.type == 12) {
        const unsigned bits = unsigned{now[6] != last[6]} | unsigned{now[7] != last[7]} << 1U;
        layer(1).symbol(models.get(10, 4), bits);
        for (unsigned i = 0; i < 2; ++i)
          if ((bits >> i & 1U) != 0)
            layer(1).symbol(models.get(11 + i, 256), (byte(now, 6 + i) - byte(last.data(), 6 + i)) & 255U);
      }
    }
    last.assign(now, spec_.size);
  }

 private:
  void encode_color(const char* now, const char* last, Models& models) {
    const auto low = [](const char* p, std::size_t channel) { return static_cast<int>(byte(p, 2 * channel)); };
    const auto high = [](const char* p, std::size_t channel) { return static_cast<int>(byte(p, 2 * channel + 1)); };
    unsigned bits = 0;
    for (unsigned i = 0; i < 6; ++i) bits |= unsigned{now[i] != last[i]} << i;
    if (std::memcmp(now, now + 2, 2) != 0 || std::memcmp(now, now + 4, 2) != 0) bits |= 64U;
    Encoder& to = layer(0);
    const auto put = [&](unsigned i, int value) { to.symbol(models.get(i, 256), static_cast<unsigned>(value) & 255U); };
    const auto clamped = [](int value) { return std::clamp(value, 0, 255); };
    to.symbol(models.get(9, 128), bits);
    if ((bits & 1U) != 0) put(0, low(now, 0) - low(last, 0));
    if ((bits & 2U) != 0) put(1, high(now, 0) - high(last, 0));
    if ((bits & 64U) == 0) return;
    int red = low(now, 0) - low(last, 0);
    if ((bits & 4U) != 0) put(2, low(now, 1) - clamped(red + low(last, 1)));
    if ((bits & 16U) != 0) put(4, low(now, 2) - clamped((red + low(now, 1) - low(last, 1)) / 2 + low(last, 2)));
    red = high(now, 0) - high(last, 0);
    if ((bits & 8U) != 0) put(3, high(now, 1) - clamped(red + high(last, 1)));
    if ((bits & 32U) != 0) put(5, high(now, 2) - clamped((red + high(now, 1) - high(last, 1)) / 2 + high(last, 2)));
  }

  LazItemSpec spec_;
  unsigned now_;
  std::array<std::string, 4> last_ = {};
  std::array<Models, 4> models_ = {};
};

std::unique_ptr<Item> item_of(const LazItemSpec& spec, const char* first, unsigned& channel) {
  switch (spec.type) {
    case 0:
      if (spec.version == 1) return std::make_unique<Bytes1>(first, spec.size, false);
      return std::make_unique<Bytes2>(first, spec.size);
    case 7:
      return std::make_unique<Time1>(first);
    case 8:
      return std::make_unique<Bytes1>(first, spec.size, true);
    case 9:
      return std::make_unique<Wave13>(first);
    case 10: {
      auto point = std::make_unique<Point14>(first, spec.version);
      channel = point->first_channel();
      return point;
    }
    default:
      return std::make_unique<ChannelItem>(first, spec, channel);
  }
}

/// The bytes of a record that the layers of an item have: offset and size.
std::vector<std::pair<std::size_t, std::size_t>> layers_of(const LazItemSpec& spec) {
  if (spec.type == 10) return {{0, 8}, {8, 4}, {16, 1}, {15, 1}, {12, 2}, {18, 2}, {17, 1}, {20, 2}, {22, 8}};
  if (spec.type == 11) return {{0, 6}};
  if (spec.type == 12) return {{0, 6}, {6, 2}};
  std::vector<std::pair<std::size_t, std::size_t>> layers;
  for (std::size_t i = 0; i < spec.size; ++i) layers.emplace_back(i, 1);
  return layers;
}

std::string chunk_of(const char* records, std::size_t count, std::size_t length, const LazOptions& options) {
  unsigned channel = 0;
  std::vector<std::unique_ptr<Item>> items;
  const bool layered = options.compressor == 3;
  const auto stream = std::make_shared<Encoder>();
  std::size_t offset = 0;
  for (const LazItemSpec& spec : options.items) {
    items.push_back(item_of(spec, records + offset, channel));
    if (!layered) items.back()->layers.resize(1);
    for (auto& layer : items.back()->layers) layer = layered ? std::make_shared<Encoder>() : stream;
    offset += spec.size;
  }
  for (std::size_t i = 1; i < count; ++i) {
    const char* at = records + i * length;
    for (std::size_t k = 0; k < items.size(); ++k) {
      items[k]->encode(at, channel);
      at += options.items[k].size;
    }
  }
  const std::string first(records, length);
  if (!layered) return first + stream->done();
  std::string sizes, layers;
  offset = 0;
  for (std::size_t k = 0; k < items.size(); ++k) {
    for (std::size_t l = 0; l < items[k]->layers.size(); ++l) {
      const auto [begin, size] = layers_of(options.items[k])[l];
      bool differs = l == 0 && k == 0;
      for (std::size_t i = 1; i < count && !differs; ++i)
        differs = std::memcmp(records + offset + begin, records + i * length + offset + begin, size) != 0;
      const std::string bytes = differs ? items[k]->layers[l]->done() : "";
      sizes += little(bytes.size(), 4);
      layers += bytes;
    }
    offset += options.items[k].size;
  }
  return first + little(count, 4) + sizes + layers;
}

}  // namespace

std::string laz_of(const std::string& las, const LazOptions& options) {
  const std::size_t begin = at<std::uint32_t>(las.data(), 96), length = at<std::uint16_t>(las.data(), 105);
  std::string record =
      little(options.compressor, 2) + little(0, 2) + little(3, 1) + little(4, 1) + little(3, 2) + little(0, 4);
  record += little(options.varies           ? 0xFFFFFFFFU
                   : options.chunks.empty() ? 50000
                                            : options.chunks.front(),
                   4) +
            std::string(16, '\xFF');
  record += little(options.items.size(), 2);
  for (const LazItemSpec& item : options.items)
    record += little(item.type, 2) + little(item.size, 2) + little(item.version, 2);
  const std::string user = "laszip encoded", vlr = little(0, 2) + user + std::string(16 - user.size(), '\0') +
                                                   little(22204, 2) + little(record.size(), 2) + std::string(32, '\0') +
                                                   record;
  std::string points, table;
  Encoder encoder;
  Integers numbers(32, 2);
  std::size_t first = begin;
  std::int32_t last_count = 0, last_size = 0;
  for (const std::size_t count : options.chunks) {
    const std::string chunk = chunk_of(las.data() + first, count, length, options);
    if (options.varies) numbers.encode(encoder, last_count, static_cast<std::int32_t>(count), 0);
    numbers.encode(encoder, last_size, static_cast<std::int32_t>(chunk.size()), 1);
    last_count = static_cast<std::int32_t>(count);
    last_size = static_cast<std::int32_t>(chunk.size());
    points += chunk;
    first += count * length;
  }
  table = little(0, 4) + little(options.chunks.size(), 4) + encoder.done();
  std::string head = las.substr(0, begin);
  head.insert(begin, vlr);
  head.replace(96, 4, little(begin + vlr.size(), 4));
  head.replace(100, 4, little(at<std::uint32_t>(las.data(), 100) + 1, 4));
  head[104] = static_cast<char>(static_cast<unsigned char>(head[104]) | 0x80U);
  if (options.compressor == 1) return head + points;
  const std::uint64_t start = head.size(), place = start + 8 + points.size();
  switch (options.table) {
    case LazOptions::Table::behind:
      return head + little(place, 8) + points + table;
    case LazOptions::Table::at_end:
      return head + little(~std::uint64_t{0}, 8) + points + table + little(place, 8);
    default:
      return head + little(start, 8) + points;
  }
}

}  // namespace apps_test
