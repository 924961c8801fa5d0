// What: encoders of items whose parts have layers of their own.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "support/laz_encoder.h"
#include "support/laz_file.h"

namespace apps_test::laz {

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

inline unsigned return_context(unsigned n, unsigned r) {
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

}  // namespace apps_test::laz
