// SPDX-License-Identifier: Apache-2.0
// The laws that a user can choose are the laws that the tests cover.
#include "settings/force_settings.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "support/laws.hpp"

namespace hapticut::force_settings_test {
namespace {

using Law = settings::ForceSettings::Law;

/// A law with all constants set to 1.
std::shared_ptr<const ForceLaw> law_named(const std::string& name) {
  settings::ForceSettings chosen;
  for (const settings::Setting& setting : settings::law_settings_of(chosen)) {
    const bool is_the_law = setting.key == "force.law", is_its = setting.meaning.starts_with("law " + name + ":");
    const settings::Value value = is_the_law ? settings::Value(name) : settings::Value(1.0);
    EXPECT_TRUE((!is_the_law && !is_its) || setting.assign(value)) << setting.key;
  }
  return settings::make_law(chosen);
}

TEST(LawSettings, NameNoLawThatTheTestsOfLawsLeaveOut) {
  std::set<std::type_index> walked;
  for (const test::NamedLaw& named : test::all_laws()) walked.insert(test::type_of(*named.law));
  for (const Named<Law>& one : names_of(Of<Law>{}))
    EXPECT_TRUE(walked.contains(test::type_of(*law_named(one.name)))) << one.name << " is not in all_laws()";
}

}  // namespace
}  // namespace hapticut::force_settings_test
