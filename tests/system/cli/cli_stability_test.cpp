// SPDX-License-Identifier: Apache-2.0
// `hapticut stability`, run like a user does.
#include "support/program.hpp"

namespace hapticut::cli_stability_test {
namespace {

using test::ProgramOutcome;
using test::read_json;
using Stability = test::Program;

TEST_F(Stability, ReproducesTheTableAndFindsNoRuleBroken) {
  const ProgramOutcome outcome = run("stability --device touch --json " + path("s.json"));
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const nlohmann::json report = read_json(folder / "s.json");
  EXPECT_TRUE(report["complaints"].empty());
  ASSERT_EQ(report["wall"].size(), 15U);
  for (const nlohmann::json& row : report["wall"]) EXPECT_LT(std::abs(row["relative_error"].get<double>()), 0.05);
  EXPECT_NEAR(report["wall"][0]["k_max"].get<double>(), 2 * 0.2 / 1e-3, 8) << "2 b/T";
  ASSERT_EQ(report["contact"].size(), 3U);
  for (const nlohmann::json& row : report["contact"]) {
    EXPECT_GT(row["k_max"].get<double>(), 10 * row["k_max_direct"].get<double>());
    EXPECT_LE(row["restitution"].get<double>(), 1);
    for (const char* field : {"generated_energy_J", "buzz_um", "buzz_N", "k_max_N_per_m", "delay_ticks"})
      EXPECT_TRUE(row.contains(field)) << field;
  }
  ASSERT_EQ(report["faults"].size(), 3U * 16);
  for (const nlohmann::json& row : report["faults"]) EXPECT_TRUE(row["rules_obeyed"]) << row;
}

TEST_F(Stability, ComplainsOfNoDevice) {
  const ProgramOutcome outcome = run("stability --json " + path("s.json"));
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  const nlohmann::json report = read_json(folder / "s.json");
  EXPECT_TRUE(report["complaints"].empty()) << report["complaints"];
  EXPECT_EQ(report["contact"].size(), 4U * 3);
}

TEST_F(Stability, RefusesADeviceThatDoesNotExist) {
  const ProgramOutcome outcome = run("stability --device falcon");
  EXPECT_NE(outcome.code, 0);
  EXPECT_NE(outcome.errors.find("one of all, touch"), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace hapticut::cli_stability_test
