// SPDX-License-Identifier: Apache-2.0
#include "settings/setting.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>

#include "hapticut/core/units.hpp"

namespace hapticut::settings {
namespace {

using Kind = Setting::Kind;

std::optional<std::vector<double>> parse_numbers(std::string_view text) {
  std::vector<double> values;
  for (const std::string& part : split(text, ',')) {
    const std::optional<double> value = parse_number(part);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

/// The value in the text of a flag; nullopt when the text does not fit the kind of the setting.
std::optional<Value> parse_value(Kind kind, const std::string& text) {
  if (kind == Kind::text) return text;
  if (kind == Kind::boolean && text == "true") return true;
  if (kind == Kind::boolean && text == "false") return false;
  if (kind == Kind::number || kind == Kind::integer) {
    const std::optional<double> value = parse_number(text);
    if (value) return *value;
  }
  if (kind == Kind::numbers) {
    std::optional<std::vector<double>> values = parse_numbers(text);
    if (values) return std::move(*values);
  }
  return std::nullopt;
}

bool all_within(const Range& range, const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [&](double value) { return range.contains(value); });
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({substituted, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

ShownUnit shown_unit(std::string_view unit) {
  if (unit == "m") return {"mm", units::mm};
  if (unit == "rad") return {"deg", units::deg};
  if (unit == "rad/s") return {"rpm", units::rpm};
  if (unit == "N m") return {"Nmm", units::N_mm};
  if (unit == "N m/s") return {"Nmm_per_s", units::N_mm};
  return {unit_in_names(unit), 1};
}

namespace {

template <class Number, class Target>
Setting whole_number(std::string key, std::string flag, Target& target, double low, double high, std::string meaning) {
  const Range range = Range::between(low, high);
  return {std::move(key),
          std::move(flag),
          std::move(meaning),
          "a whole number from " + format_number(low) + " to " + format_number(high),
          Kind::integer,
          [&target, range](const Value& value) {
            const double given = std::get<double>(value);
            if (!range.contains(given) || given != std::floor(given)) return false;
            target = Number(given);
            return true;
          }};
}

}  // namespace

Setting integer(std::string key, std::string flag, std::size_t& target, double low, double high, std::string meaning) {
  return whole_number<std::size_t>(std::move(key), std::move(flag), target, low, high, std::move(meaning));
}

Setting integer(std::string key, std::string flag, std::optional<double>& target, double low, double high,
                std::string meaning) {
  return whole_number<double>(std::move(key), std::move(flag), target, low, high, std::move(meaning));
}

Setting integer(std::string key, std::string flag, std::optional<int>& target, double low, double high,
                std::string meaning) {
  return whole_number<int>(std::move(key), std::move(flag), target, low, high, std::move(meaning));
}

Setting numbers(std::string key, std::string flag, std::vector<double>& target, std::size_t count, Range range,
                std::string meaning) {
  const std::string each = range.limits();
  return {std::move(key),
          std::move(flag),
          std::move(meaning),
          std::to_string(count) + " numbers" + (each.empty() ? "" : ", each" + each),
          Kind::numbers,
          [&target, count, range](const Value& value) {
            const auto& given = std::get<std::vector<double>>(value);
            if (given.size() != count || !all_within(range, given)) return false;
            target = given;
            return true;
          }};
}

Setting vector(std::string key, std::string flag, std::optional<Vec3>& target, Range range, std::string meaning,
               double factor) {
  std::vector<double> unused;
  Setting setting = numbers(std::move(key), std::move(flag), unused, 3, range, std::move(meaning));
  setting.assign = [&target, range, factor](const Value& value) {
    std::vector<double> given = std::get<std::vector<double>>(value);
    for (double& one : given) one *= factor;
    if (given.size() != 3 || !all_within(range, given)) return false;
    target = Vec3(given[0], given[1], given[2]);
    return true;
  };
  return setting;
}

Setting text(std::string key, std::string flag, std::string& target, std::string meaning) {
  return {std::move(key),
          std::move(flag),
          std::move(meaning),
          "a text that is not empty",
          Kind::text,
          [&target](const Value& value) {
            target = std::get<std::string>(value);
            return !target.empty();
          }};
}

Setting path(std::string key, std::string flag, std::string& target, std::string meaning,
             std::vector<std::string> words) {
  Setting setting = text(std::move(key), std::move(flag), target, std::move(meaning));
  setting.files = [&target] {
    return target.empty() ? std::vector<std::filesystem::path>{} : std::vector<std::filesystem::path>{target};
  };
  setting.in_folder = [words = std::move(words)](const std::string& name, const std::filesystem::path& folder) {
    const bool is_file = !name.empty() && std::find(words.begin(), words.end(), name) == words.end();
    return is_file ? (folder / name).string() : name;
  };
  return setting;
}

std::vector<Setting> together(std::vector<std::vector<Setting>> lists) {
  std::vector<Setting> all;
  for (std::vector<Setting>& list : lists)
    all.insert(all.end(), std::make_move_iterator(list.begin()), std::make_move_iterator(list.end()));
  return all;
}

Setting boolean(std::string key, std::string flag, bool& target, std::string meaning) {
  return {std::move(key),
          std::move(flag),
          std::move(meaning),
          "true or false",
          Kind::boolean,
          [&target](const Value& value) {
            target = std::get<bool>(value);
            return true;
          }};
}

Setting boolean(std::string key, std::string flag, std::optional<bool>& target, std::string meaning) {
  bool unused = false;
  Setting setting = boolean(std::move(key), std::move(flag), unused, std::move(meaning));
  setting.assign = [&target](const Value& value) {
    target = std::get<bool>(value);
    return true;
  };
  return setting;
}

void apply_flag(const Setting& setting, const std::vector<std::string>& texts) {
  const auto refuse = [&](const std::string& text) {
    throw UsageError(setting.flag + " " + (text.empty() ? "''" : text) + ": must be " + setting.allowed + ".");
  };
  if (setting.kind == Kind::tables) {
    setting.clear();
    for (const std::string& text : texts)
      if (!setting.assign_short_form(text)) refuse(text);
    return;
  }
  if (texts.size() > 1 && setting.kind != Kind::boolean)
    throw UsageError(setting.flag + " is given " + std::to_string(texts.size()) + " times; give it once.");
  const std::string& text = texts.back();
  const std::optional<Value> value = parse_value(setting.kind, text);
  if (!value || !setting.assign(*value)) refuse(text);
}

std::string describe(const Value& value) {
  if (const auto* yes = std::get_if<bool>(&value)) return *yes ? "true" : "false";
  if (const auto* one = std::get_if<double>(&value)) return format_number(*one);
  if (const auto* words = std::get_if<std::string>(&value)) return '"' + *words + '"';
  return "[" + joined(std::get<std::vector<double>>(value), ", ", [](double one) { return format_number(one); }) + "]";
}

std::optional<std::string> nearest_name(std::string_view misspelled, const std::vector<std::string>& candidates) {
  const std::string_view word = misspelled.substr(std::min(misspelled.find_first_not_of('-'), misspelled.size()));
  const auto ends_with_it = [&](const std::string& name) {
    return name.ends_with(word) && name.size() > word.size() && name[name.size() - word.size() - 1] == '_';
  };
  // An abbreviation ("--feed", "--to", "--rpm") is matched to a longer name, not to another short one.
  const std::string begun = std::string(misspelled) + (word.size() > 2 ? "" : "_");
  const auto begins_with_it = [&](const std::string& name) { return name.starts_with(begun); };
  const bool is_begun = !word.empty() && std::any_of(candidates.begin(), candidates.end(), begins_with_it);
  const bool is_end = word.size() > 2 && std::any_of(candidates.begin(), candidates.end(), ends_with_it);
  std::optional<std::string> nearest;
  std::size_t min_distance = is_begun || is_end ? SIZE_MAX : std::max<std::size_t>(3, misspelled.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    if (is_begun ? !begins_with_it(candidate) : is_end && !ends_with_it(candidate)) continue;
    const std::size_t distance = edit_distance(misspelled, candidate);
    if (distance < min_distance) {
      min_distance = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string suggestion(std::string_view misspelled, const std::vector<std::string>& candidates) {
  const std::optional<std::string> nearest = nearest_name(misspelled, candidates);
  return nearest ? " Did you mean " + *nearest + "?" : "";
}

std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t at = text.find(separator);
    parts.emplace_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

}  // namespace hapticut::settings
