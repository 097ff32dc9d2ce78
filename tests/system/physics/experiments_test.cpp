// SPDX-License-Identifier: Apache-2.0
// Each experiment of `hapticut validate` is a test.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "experiments/checks.hpp"
#include "experiments/measurements.hpp"
#include "experiments/report.hpp"
#include "support/places.hpp"

namespace hapticut::experiments {
void PrintTo(const Experiment& experiment, std::ostream* out) { *out << experiment.name; }
}  // namespace hapticut::experiments

namespace hapticut::experiments_test {
namespace {

using experiments::all_experiments;
using experiments::Check;

class Experiment : public testing::TestWithParam<experiments::Experiment> {};

TEST_P(Experiment, IsWithinItsTolerances) {
  const std::vector<Check> checks = GetParam().run();
  for (const Check& check : checks)
    EXPECT_TRUE(check.pass()) << check.id << ": expected " << check.expected << ", computed " << check.computed << " "
                              << check.unit << ", off by " << check.relative_error() << ", tolerance "
                              << check.tolerance.share << ", " << check.tolerance.reason;
  std::set<std::string> ids;
  for (const Check& check : checks) EXPECT_TRUE(ids.insert(check.id).second) << check.id << " appears twice";
}

INSTANTIATE_TEST_SUITE_P(All, Experiment, testing::ValuesIn(all_experiments()), [](const auto& e) {
  std::string name = e.param.name;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
});

// Both models compute the same case: the thesis's model shows the defect, the default model does not.
TEST(DefectExperiments, HaveACheckOfBothModels) {
  for (const experiments::Experiment& experiment : experiments::defect_experiments()) {
    const std::string number = experiment.name.substr(std::string("defect ").size());
    std::set<std::string> models;
    for (const Check& check : experiment.run())
      for (const char* model : {"thesis", "cured"})
        if (check.id.starts_with(number + " " + model)) models.insert(model);
    EXPECT_EQ(models.size(), 2U) << experiment.name;
  }
}

TEST(ValidationReport, HasARowForEachFormWithItsWorstCase) {
  const std::vector<Check> checks = {{"C1 near", "ball", "N", 1, 1.01, {0.1, "rounding"}},
                                     {"C1 far", "ball", "N", 1, 1.05, {0.1, "voxels"}},
                                     {"plain", "cone", "N", 1, 1, {0.1, "voxels"}}};
  EXPECT_EQ(experiments::rows_of("balls", checks),
            "| balls | C1 | ball | near; **far** | 5 % | 10 % | voxels |  |\n"
            "| balls |  | cone | plain | 0 % | 10 % | voxels |  |\n");
}

TEST(Check, OfANumberThatIsNoneDoesNotPass) {
  Check check{"x", "", "", 1, std::nan(""), {0.1, ""}};
  EXPECT_FALSE(check.pass());
  check.computed = 1.05;
  EXPECT_TRUE(check.pass());
  check.computed = 1.2;
  EXPECT_FALSE(check.pass());
  check.at_least = true;
  EXPECT_TRUE(check.pass());
}

}  // namespace
}  // namespace hapticut::experiments_test
