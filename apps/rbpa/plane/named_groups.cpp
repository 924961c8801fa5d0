#include "plane/named_groups.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "io/bytes/same_file.h"
#include "io/cloud/cloud.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/utf8.h"
#include "io/values_at.h"
#include "io/words.h"
#include "shared/arguments.h"

namespace rbpa::app {
namespace {

constexpr double no_radius = std::numeric_limits<double>::quiet_NaN(), no_height = no_radius;

/// The names of groups by one column, or by files, and the number of the name of each point.
struct Key {
  std::uint32_t number_of(std::string_view name) {
    const auto [place, is_new] = numbers.try_emplace(as_utf8(name), static_cast<std::uint32_t>(names.size()));
    if (is_new) names.push_back(place->first);
    return place->second;
  }
  /// Appends the numbers of the points of a file, whose names are in column `k` of its fields.
  void add(const PointFile& file, std::size_t k);
  /// Sorts the names, by their values if all are numbers, else by their bytes. Sets are_numbers.
  void sort();
  /// Replaces each number i of a name by label[i].
  void renumber(const std::vector<std::uint32_t>& label) {
    for (std::uint32_t& of : labels)
      if (of != no_group) of = label[of];
  }

  std::vector<std::string> names = {};
  std::vector<std::uint32_t> labels = {};
  bool are_texts = false, are_numbers = false;
  std::unordered_map<std::string, std::uint32_t> numbers = {};
};

/// Returns whether the text is a number of JSON (RFC 8259); "007" and "+1" are not.
bool is_json_number(std::string_view text) {
  const auto pass = [&](std::string_view any_of) {
    if (text.empty() || any_of.find(text.front()) == std::string_view::npos) return false;
    text.remove_prefix(1);
    return true;
  };
  constexpr std::string_view digits = "0123456789";
  const auto pass_digits = [&] {
    if (!pass(digits)) return false;
    while (pass(digits)) continue;
    return true;
  };
  pass("-");
  if (!pass("0") && !pass_digits()) return false;
  if (pass(".") && !pass_digits()) return false;
  if (pass("eE")) {
    pass("+-");
    if (!pass_digits()) return false;
  }
  return text.empty();
}

/// Returns the value of each name, or nothing unless all names are numbers of JSON with different values of magnitude
/// below 2^53. From 2^53 on two whole numbers may round to one double.
std::optional<std::vector<double>> values_of(const std::vector<std::string>& names) {
  constexpr double greatest = 9007199254740992.0;  // 2^53
  std::vector<double> values;
  for (const std::string& name : names) {
    const ParsedNumber number = parse_whole_number(name);
    if (!is_json_number(name) || number.fault != NumberFault::none || std::abs(number.value) >= greatest)
      return std::nullopt;
    values.push_back(number.value);
  }
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return std::nullopt;
  return values;
}

void Key::add(const PointFile& file, std::size_t k) {
  if (file.points.empty()) return;
  if (file.texts.size() > k && file.texts[k]) {
    are_texts = are_texts || (file.keys_are_texts.size() > k && file.keys_are_texts[k]);
    constexpr std::uint32_t not_yet = no_group - 1;
    std::vector<std::uint32_t> label(file.texts[k]->size(), not_yet);
    for (const double key : file.fields[k]) {
      std::uint32_t& number = label[static_cast<std::size_t>(key)];
      const std::string& text = (*file.texts[k])[static_cast<std::size_t>(key)];
      if (number == not_yet) number = text.empty() ? no_group : number_of(text);
      labels.push_back(number);
    }
    return;
  }
  std::unordered_map<std::uint64_t, std::uint32_t> label;  // number of the name, by the bits of the key
  for (const double key : file.fields[k]) {
    if (std::isnan(key)) {
      labels.push_back(no_group);
      continue;
    }
    const double value = key + 0.0;  // -0 becomes 0
    const auto [place, is_new] = label.try_emplace(std::bit_cast<std::uint64_t>(value), 0);
    if (is_new) place->second = number_of(text_of(value));
    labels.push_back(place->second);
  }
}

void Key::sort() {
  const std::optional<std::vector<double>> values = are_texts ? std::nullopt : values_of(names);
  are_numbers = values.has_value();
  std::vector<std::uint32_t> order(names.size()), label(names.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return values ? (*values)[i] < (*values)[j] : names[i] < names[j];
  });
  std::vector<std::string> sorted;
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    label[order[k]] = k;
    sorted.push_back(std::move(names[order[k]]));
  }
  names = std::move(sorted);
  renumber(label);
}

/// Returns groups by several sorted keys, in the order of the first, then of the second and so on. A name is a line of
/// CSV. Appends the values of each group to `columns`, one for each key.
Key joined(const std::vector<Key>& keys, std::vector<PointColumn>& columns) {
  Key all;
  std::map<std::vector<std::uint32_t>, std::uint32_t> numbers;  // of the groups, by those of their names
  std::vector<std::uint32_t> of(keys.size());
  for (std::size_t i = 0; i < keys.front().labels.size(); ++i) {
    for (std::size_t k = 0; k < keys.size(); ++k) of[k] = keys[k].labels[i];
    const bool is_in_one = std::count(of.begin(), of.end(), no_group) == 0;
    const auto next = static_cast<std::uint32_t>(numbers.size());
    all.labels.push_back(is_in_one ? numbers.try_emplace(of, next).first->second : no_group);
  }
  std::vector<std::uint32_t> label(numbers.size());
  for (const auto& [names, number] : numbers) {
    label[number] = static_cast<std::uint32_t>(all.names.size());
    std::string& line = all.names.emplace_back();
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const std::string& name = keys[k].names[names[k]];
      (line += k == 0 ? "" : ",") += csv_text(name);
      keys[k].are_numbers ? columns[k].append(parse_whole_number(name).value)
                          : columns[k].append(columns[k].number_of(name));
    }
  }
  all.renumber(label);
  return all;
}

/// Appends the points of one file after another, and records the group of each point.
class Gatherer {
 public:
  explicit Gatherer(const GroupSources& sources) : sources_(sources), keys_(1) {
    if (!sources.by_file) keys_.resize(sources.files.front().where->columns() - (sources.radius ? 1 : 0));
  }

  void add(PointFile file, const std::string& path) {
    agree(file, path);
    const std::size_t count = file.points.size();
    if (sources_.by_file)  // a file without points is a group too
      keys_[0].labels.resize(keys_[0].labels.size() + count, keys_[0].number_of(path));
    for (std::size_t k = 0; k < keys_.size() && !sources_.by_file; ++k) keys_[k].add(file, k);
    if (sources_.radius) {
      if (file.fields.empty())
        radii_.resize(radii_.size() + count, no_radius);
      else
        radii_.insert(radii_.end(), file.fields.back().begin(), file.fields.back().end());
    }
    PointFile& all = result_.file;
    append_columns(all.kept, std::move(file.kept), !std::exchange(any_columns_, true));
    if (!file.z.empty() || !all.z.empty()) {
      all.z.resize(all.points.size(), no_height);
      all.z.insert(all.z.end(), file.z.begin(), file.z.end());
      all.z.resize(all.points.size() + count, no_height);
    }
    for (std::uint32_t i = 0; i < count; ++i)
      all.index.push_back(static_cast<std::uint32_t>(all.all_points) + renumbered(i, file.index));
    all.all_points += std::max(file.all_points, count);
    all.heights.take(file.heights);
    all.degrees = all.degrees || file.degrees;
    if (all.points.empty())
      all.points = std::move(file.points);
    else
      all.points.insert(all.points.end(), file.points.begin(), file.points.end());
  }

  NamedGroups finish() {
    settle_names();
    result_.file.index = unless_identity(std::move(result_.file.index));
    if (sources_.radius) settle_radii();
    return std::move(result_);
  }

 private:
  /// Throws BadInput if the coordinate system of the file differs from that of the earlier files.
  void agree(const PointFile& file, const std::string& path) {
    if (std::exchange(any_, true))
      require_same_crs(file.crs, input_name(path), result_.file.crs, input_name(sources_.files.front().path));
    result_.file.crs = file.crs;
  }

  void settle_names() {
    if (!sources_.by_file)
      for (Key& key : keys_) key.sort();
    if (keys_.size() > 1) {
      for (std::size_t k = 0; k < keys_.size(); ++k)
        result_.keys.push_back({.name = sources_.files.front().where->column(k).name,
                                .type = keys_[k].are_numbers ? Scalar::float64 : Scalar::int32,
                                .is_text = !keys_[k].are_numbers});
      keys_ = {joined(keys_, result_.keys)};
    }
    result_.are_numbers = keys_.front().are_numbers;
    result_.names = std::move(keys_.front().names);
    result_.groups = groups_of(keys_.front().labels, result_.names.size());
  }

  /// Sets the radius of each group, or its problem if the points of the group do not have one radius above 0.
  void settle_radii() {
    const std::string column = "column " + in_quotes(*sources_.radius);
    for (std::size_t g = 0; g < result_.groups.size(); ++g) {
      const std::span<const std::uint32_t> members = result_.groups[g];
      double radius = members.empty() ? std::numeric_limits<double>::infinity() : radii_[members.front()];
      std::string problem;
      for (const std::uint32_t i : members) {
        if (!(radii_[i] > 0))
          problem = column + " has no radius above 0 for point " + std::to_string(renumbered(i, result_.file.index));
        else if (radii_[i] != radius)
          problem = column + " has the radii " + text_of(radius) + " and " + text_of(radii_[i]) + ", expected one";
        if (!problem.empty()) break;
      }
      result_.radii.push_back(problem.empty() ? radius : no_radius);
      result_.radius_problems.push_back(std::move(problem));
    }
  }

  const GroupSources& sources_;
  NamedGroups result_ = {};
  std::vector<Key> keys_;
  std::vector<double> radii_ = {};
  bool any_ = false, any_columns_ = false;
};

}  // namespace

GroupSources parse_group_sources(const PointArguments& arguments, const GroupArguments& groups,
                                 const std::optional<std::string>& radius) {
  GroupSources sources{.files = {}, .by_file = groups.group_by_file, .radius = radius};
  PointArguments one = arguments;
  for (const std::string& path : groups.inputs) {
    one.points = path;
    sources.files.push_back(parse_source(one, {.keys = groups.group_by, .radius = radius}));
  }
  if (std::count(groups.inputs.begin(), groups.inputs.end(), "-") > 1)
    bad_usage("POINTS", "-, standard input, twice", "once");
  return sources;
}

void require_different(const std::vector<std::string>& outputs, const GroupSources& sources) {
  for (const PointSource& file : sources.files) require_different(outputs, file.path, "points");
}

NamedGroups groups_in(const GroupSources& sources, std::vector<PointFile> files) {
  Gatherer gatherer(sources);
  for (std::size_t i = 0; i < files.size(); ++i) gatherer.add(std::move(files[i]), sources.files[i].path);
  return gatherer.finish();
}

std::vector<Attribute> key_attributes(const NamedGroups& named, std::vector<std::string> taken) {
  // "fid" and "geom" are columns of each layer of a GeoPackage.
  for (const char* name :
       {"group", "points", "alpha", "area", "perimeter", "polygons", "problem", "geometry", "fid", "geom"})
    taken.emplace_back(name);
  return attributes_of(named.keys, std::move(taken));
}

std::vector<std::string> warnings_on(std::size_t left_out) {
  if (left_out == 0) return {};
  return {counted(left_out, "point") + " without a group"};
}

NamedGroups read_groups(const Run& run, const GroupSources& sources) {
  Gatherer gatherer(sources);
  for (const PointSource& source : sources.files) {
    stop_if_interrupted();
    gatherer.add(run.read_points(source), source.path);
  }
  NamedGroups named = gatherer.finish();
  std::vector<std::string> warnings;
  settle_columns(named.file.kept, warnings);
  run.warning(warnings);
  run.warning(warnings_on(named.file.points.size() - named.groups.members.size()));
  return named;
}

}  // namespace rbpa::app
