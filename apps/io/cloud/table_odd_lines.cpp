#include "io/cloud/table_odd_lines.h"

#include <algorithm>
#include <cctype>
#include <deque>
#include <optional>
#include <vector>

#include "io/failure.h"
#include "io/text/columns.h"
#include "io/text/line_selection.h"

namespace rbpa::app {

void refuse_no_table(std::string_view bytes, const std::string& name) {
  struct Kind {
    std::string_view beginning;
    const char *found, *expected;
  };
  constexpr const char *sheet = "text (save the sheet as CSV)", *page = "a table (was the download refused?)",
                       *records = "a table (jq -r '.[] | [.lon, .lat] | @csv' makes one of records)",
                       *xml = "a table (ogr2ogr -f CSV -lco GEOMETRY=AS_XY makes one of KML and GPX)";
  constexpr Kind kinds[] = {{"PK\x03\x04", "a workbook, or another zip file", sheet},
                            {"\xD0\xCF\x11\xE0", "a workbook of Excel", sheet},
                            {"<!doctype html", "a web page", page},
                            {"<html", "a web page", page},
                            {"<?xml", "XML", xml},
                            {"<kml", "KML", xml},
                            {"<gpx", "GPX", xml},
                            {"[[", "JSON", "a table"},
                            {"[{", "JSON", records},
                            {"[\n", "JSON", records},
                            {"{", "JSON", "a table (--format geojson reads GeoJSON)"}};
  bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF"), bytes.size()));
  Fields words(bytes.substr(0, bytes.find('\n')), blanks);
  if (!words.at_end() && same_letters(words.take(), "ncols") && !words.at_end() && parse_count(words.take()))
    bad_input(name, "a grid of ESRI", "a table (gdal_translate -of XYZ makes one)");
  for (const Kind& kind : kinds)
    if (same_letters(bytes.substr(0, kind.beginning.size()), kind.beginning))
      bad_input(name, kind.found, kind.expected);
}

bool lacks_name_of_rows(const TableLines& lines, const SeparatorChoice& choice) {
  std::deque<std::string> room;
  const std::vector<std::string_view> names = split(lines.line(), choice.separator, room);
  std::string_view text = lines.rest();
  if (text.size() > separator_sample) text = text.substr(0, text.rfind('\n', separator_sample) + 1);
  TableLines rows(Content(text, lines.name()));
  rows.set_layout(choice.separator, 0);
  std::size_t count = 0, first = 0, texts = 0, seconds = 0;  // seconds: numbers in the second field
  bool any_decimal = choice.separator != ',';                // else the lines may have decimal commas
  for (; rows.next(); ++count) {
    Fields fields(rows.line(), choice.separator);
    const std::string_view name = fields.take();
    const std::optional<std::size_t> number = parse_count(name);
    if (count == 0) first = number.value_or(0);
    if (count_fields(rows.line(), choice.separator).all != names.size() + 1 || first > 1 ||
        (number ? *number != first + count : is_number(name)))
      return false;
    texts += number ? 0U : 1U;
    seconds += is_number(fields.take()) ? 1U : 0U;
    any_decimal = any_decimal || texts > 0 || rows.line().find('.') != std::string_view::npos;
  }
  constexpr std::string_view numbers = "id fid gid oid objectid nr no num number nummer lfd index punkt pt point";
  if (texts == 0 && seconds > 0 && is_word_of(names.front(), numbers)) return false;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (is_nearly_number(names[i]) && names[i] != std::to_string(i)) return false;
  return count > 0 && !choice.geometry && choice.fields.to_last_text > names.size() && (texts == 0 || texts == count) &&
         any_decimal && names.size() > 1;
}

std::string doubt_last_line(const TableLines& lines, char separator) {
  constexpr std::string_view totals =
      "sum total totals mean avg average median min minimum max maximum count std stdev stddev centroid summe "
      "gesamt gesamtergebnis mittel mittelwert durchschnitt anzahl schwerpunkt somme moyenne suma media totale totaal";
  const auto line_before = [](std::string_view& text) {
    text = text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
    const std::string_view line = text.substr(text.find_last_of('\n') + 1);
    text.remove_suffix(line.size());
    return line;
  };
  std::string_view rest = lines.rest();
  const std::string_view last = line_before(rest);
  if (!fields_of_data(last, separator)) return "";
  std::deque<std::string> room;
  const std::vector<std::string_view> fields = split(last, separator, room),
                                      first = split(lines.line(), separator, room),
                                      before = split(line_before(rest), separator, room);
  const auto is_total = [&](std::string_view field) {
    while (!field.empty() && std::ispunct(static_cast<unsigned char>(field.back())) != 0) field.remove_suffix(1);
    return is_word_of(field, totals) || is_word_of(field.substr(0, field.find(' ')), "total totale") ||
           is_word_of(field.substr(field.rfind(' ') + 1), "total gesamt totaal");
  };
  const auto is_text = [](std::string_view field) { return !is_missing(field) && !is_number(field); };
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const bool lacks_name =
        i == 0 && fields[i].empty() && !first.empty() && !before.empty() && is_text(first[i]) && is_text(before[i]);
    if (lacks_name || (is_text(fields[i]) && is_total(fields[i])))
      return "the last line, " + in_quotes(last) +
             ", is read as a point, and may be no point but a total of others (then delete it)";
  }
  return "";
}

void refuse_second_header(const TableLines& lines, char separator, const FieldCount& width, const std::string& header) {
  std::deque<std::string> room;
  std::vector<std::string_view> names = split(lines.line(), separator, room);
  if (header.empty() || lines.line() == header || names.size() < 2) return;
  const auto is_name = [](std::string_view f) { return !is_missing(f) && !is_nearly_number(f) && !is_geometry(f); };
  Lines behind(lines.rest());
  const std::optional<FieldCount> next =
      behind.next_with_content() ? fields_of_data(behind.line(), separator) : std::nullopt;
  const bool has_width = names.size() == width.all;
  if (!std::all_of(names.begin(), names.end(), is_name) ||
      !(has_width ? lines.line_before().empty() || find_coordinates(names)
                  : next && next->all == names.size() && find_coordinates(names)))
    return;
  std::sort(names.begin(), names.end());
  if (std::adjacent_find(names.begin(), names.end()) != names.end()) return;
  throw WholeRefusal(at_line(lines.name(), lines.number()) + ": found " + in_quotes(lines.line()) +
                     ", the header of another table, expected lines of the table with the header " + in_quotes(header) +
                     " (a file for each table)");
}

}  // namespace rbpa::app
