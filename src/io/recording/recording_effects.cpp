// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "hapticut/core/errors.hpp"
#include "io/recording/recording_settings.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

std::string with_unit(const std::string& name, const char* unit) {
  const std::string end = unit_in_names(unit);
  return end.empty() ? name : name + "_" + end;
}

/// Visits the numbers of one field: `visit(name, value)`. `name` is a function, so the text is built only on demand.
template <class Value, class Visit>
void visit_numbers(const char* prefix, const char* field, const char* unit, Value& value, const Visit& visit) {
  const auto name = [=](const char* axis) { return with_unit(std::string(prefix) + field + axis, unit); };
  constexpr const char* kAxes[] = {"_x", "_y", "_z"};
  if constexpr (std::is_arithmetic_v<std::remove_const_t<Value>>)
    visit([&] { return name(""); }, value);
  else
    for (std::size_t axis = 0; axis < 3; ++axis) visit([&] { return name(kAxes[axis]); }, value[axis]);
}

/// Visits the numbers of an effect that is always present.
template <class Group, class Visit>
void visit_group(const char* prefix, Group& group, const Visit& visit) {
  for_each_field<std::remove_const_t<Group>>(
      [&](const auto& field) { visit_numbers(prefix, field.name, field.unit, group.*field.member, visit); });
}

/// Visits the numbers of an optional effect: first whether it is present, then its numbers or their defaults.
template <class Maybe, class Visit>
requires std::is_same_v<std::remove_const_t<Maybe>, std::optional<typename Maybe::value_type>>
void visit_group(const char* prefix, Maybe& group, const Visit& visit) {
  bool is_there = group.has_value();
  auto value = group.value_or(typename Maybe::value_type{});
  const std::string_view name = prefix;
  visit([&] { return std::string(name.substr(0, name.size() - 1)); }, is_there);
  visit_group(prefix, value, visit);
  if constexpr (!std::is_const_v<Maybe>) group = is_there ? std::optional(value) : std::nullopt;
}

/// Visits the numbers of all effects in order.
template <class AnyEffects, class Visit>
void visit_effects(AnyEffects& effects, const Visit& visit) {
  visit_group("gravity_", effects.gravity, visit);
  visit_group("vibration_", effects.vibration, visit);
  visit_group("teeth_", effects.teeth, visit);
  visit_group("delta_filter_", effects.delta_filter, visit);
  visit_group("", effects.enabled, visit);
  visit_group("", effects.limits, visit);
}
static_assert(kFieldsOf<Effects> == 6, "a new effect needs a line above");

}  // namespace

EffectNumbers pack(const Effects& effects) noexcept {
  EffectNumbers numbers{};
  std::size_t n = 0;
  visit_effects(effects, [&](const auto&, const auto& value) { numbers[n++] = double(value); });
  HAPTICUT_ASSERT(n == kEffectNumbers);
  return numbers;
}

Effects unpack(const std::string& names, std::span<const double> numbers) {
  const std::vector<std::string> given = items_of(names);
  if (given.size() != numbers.size())
    throw Error("the number of columns of its 'effects/values' differs from the number of names.");
  std::size_t used = 0;
  Effects effects;
  visit_effects(effects, [&](const auto& name, auto& value) {
    const auto found = std::find(given.begin(), given.end(), name());
    if (found == given.end()) return;  // a newer number keeps its default
    const double number = numbers[std::size_t(found - given.begin())];
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, bool>)
      value = number != 0;
    else
      value = number;
    ++used;
  });
  if (used != given.size())
    throw Error("its effects have a number that this version of hapticut does not know; use a newer version.");
  return effects;
}

std::string effect_names() {
  std::string names;
  const Effects none;
  visit_effects(none, [&](const auto& name, const auto&) { append_item(names, name()); });
  return names;
}

}  // namespace hapticut
