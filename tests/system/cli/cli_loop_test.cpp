// SPDX-License-Identifier: Apache-2.0
// hapticut loop, run like a user does.
#include <gtest/gtest.h>

#include <memory>

#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "reports/loop_report.hpp"
#include "support/program.hpp"

namespace hapticut::cli_loop_test {
namespace {

using namespace test;

const std::string kCoarse = "--workpiece block --size_mm 24,24,8 --material cortical_bone --voxel_mm 0.3 ";

class Loop : public Program {
 protected:
  nlohmann::json loop(const std::string& arguments) {
    const nlohmann::json of_run = report("loop " + arguments);
    EXPECT_EQ(read_bytes(folder / "stderr"), "") << arguments;
    return of_run;
  }
};

TEST_F(Loop, CarriesTheCaseStudyOfTheThesisAtItsRate) {
  const std::string scene = test::source_path("examples/thesis/case_6_5.toml").string();
  const nlohmann::json report = loop("mock:press,hand=nominal --seconds 4 --simulated_time true --settings " + scene);
  EXPECT_EQ(report["rate_Hz"], 2000);
  EXPECT_GT(report["removed_volume_mm3"], 0.5);
  EXPECT_LT(report["compute_us"]["p50"], 500) << "a tick; 180 on an idle machine, so that a busy one passes";
}

TEST_F(Loop, CutsWithAMockDeviceAndReportsEveryField) {
  const nlohmann::json report = loop("mock:spiral --seconds 4 --simulated-time " + kCoarse);
  for (const char* pointer :
       {"/device/model", "/rate_Hz", "/missed_ticks", "/end", "/wake_up_us/p99", "/compute_us/p999",
        "/compute_us/buckets", "/deadline_misses", "/safety_events/engaged", "/safety_log/0/event", "/graphics/frames",
        "/force_N/max_applied", "/max_per_tick/newton_steps", "/status_seen", "/workpiece/dims/2", "/build/version",
        "/warnings"})
    EXPECT_TRUE(report.contains(nlohmann::json::json_pointer(pointer))) << pointer;
  EXPECT_EQ(report["ticks"], 4001);
  EXPECT_EQ(report["steps"], 4001);
  EXPECT_GT(report["removed_volume_mm3"], 1);
  EXPECT_LE(report["force_N"]["max_applied"], report["device"]["peak_force_N"]);
  EXPECT_EQ(report["safety_events"]["engaged"], 1);
  EXPECT_GT(report["graphics"]["blocks"], 10);
  std::uint64_t counted = 0;
  for (const auto& bucket : report["compute_us"]["buckets"]) counted += bucket[1].get<std::uint64_t>();
  EXPECT_EQ(counted + report["compute_us"]["longer_than_2_ms"].get<std::uint64_t>(), report["compute_us"]["count"]);
}

TEST_F(Loop, RunsInRealTimeAndReportsHowLateItWokeUp) {
  const nlohmann::json report = loop("mock:circle --seconds 0.5 " + kCoarse);
  EXPECT_EQ(report["wake_up_us"]["count"].get<std::uint64_t>() >= report["ticks"].get<std::uint64_t>(), true);
  EXPECT_GT(report["ticks"], 0);
  EXPECT_GT(report["wake_up_us"]["max"], 0);
}

TEST_F(Loop, DrivesADeviceWhereTheProgramWasBuiltWithItsSdk) {
  struct Made {
    const char *driver, *device, *sdk;
    double peak_force;
  };
  for (const Made& made : {Made{"open_haptics", "openhaptics", "3D Systems OpenHaptics", 3.3},
                           Made{"force_dimension", "forcedimension:omega.6", "the Force Dimension SDK", 12}}) {
    SCOPED_TRACE(made.device);
    const std::string loop = "loop " + std::string(made.device) + " ";
    const ProgramOutcome outcome =
        run_program(folder, loop + "--seconds 0.3 --json " + path("loop.json") + " " + kCoarse,
                    std::string(test::kProgramWith) + made.driver);
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    const nlohmann::json report = read_json(folder / "loop.json");
    EXPECT_EQ(report["device"]["peak_force_N"], made.peak_force);
    EXPECT_GT(report["ticks"], 0);
    EXPECT_EQ(report["safety_events"]["armed"], 1);
    EXPECT_EQ(report["coupling"], "virtual");
    expect_refused(loop, {std::string("install ") + made.sdk});
  }
}

TEST_F(Loop, CutsHardBoneBehindItsCouplingByDefault) {
  const auto is_too_soft = [&](const std::string& more) {
    const nlohmann::json report = loop("mock:spiral,hand=nominal --seconds 5 --simulated-time" + more);
    return report["warnings"].dump().find("too soft") != std::string::npos;
  };
  EXPECT_FALSE(is_too_soft(""));
  EXPECT_TRUE(is_too_soft(" --reference-stiffness 1e13"));
}

TEST_F(Loop, ReportsTheStatusOfItsStepsAndTheLastArming) {
  const std::string press = "mock:press,hand=nominal --seconds 3 --simulated-time " + kCoarse;
  const auto expect_of = [&](const std::string& more, const std::string& bit, const std::string& warning) {
    const nlohmann::json report = loop(press + more);
    EXPECT_NE(report["status_seen"].dump().find('"' + bit + '"'), std::string::npos) << report["status_seen"];
    EXPECT_NE(report["warnings"].dump().find(warning), std::string::npos) << report["warnings"];
    const std::string out = read_bytes(folder / "stdout");
    EXPECT_NE(out.find(bit + " in one or more steps\n"), std::string::npos) << out;
    EXPECT_NE(out.find("  " + report["arming"].get<std::string>() + " at the end\n"), std::string::npos) << out;
  };
  expect_of("--spindle_rpm 0", "spindle_stands", "set --spindle_rpm.");
  expect_of("--motor electric --torque_limit_Nmm 0.001", "spindle_stalled", "the load stalled the spindle");
}

TEST_F(Loop, SaysThatTheToolWasInTheMaterialFromTheStart) {
  const auto was_inside = [&](const std::string& more) {
    const nlohmann::json report = loop("mock:rest --seconds 1 --simulated-time " + kCoarse + more);
    return report["warnings"].dump().find("in the material from the start") != std::string::npos;
  };
  EXPECT_TRUE(was_inside("--origin_mm 12,12,6"));
  EXPECT_FALSE(was_inside("--origin_mm 0,0,100"));
}

TEST_F(Loop, SaysThatRemovalIsOffInsteadOfACureForAStall) {
  const nlohmann::json report = loop(
      "mock:press,hand=nominal --seconds 3 --simulated-time --removal none "
      "--motor electric --torque_limit_Nmm 0.001 " +
      kCoarse);
  EXPECT_NE(report["status_seen"].dump().find("spindle_stalled"), std::string::npos) << report["status_seen"];
  const std::string warnings = report["warnings"].dump();
  EXPECT_NE(warnings.find("removal is off (--removal is none), so nothing was removed."), std::string::npos);
  EXPECT_EQ(warnings.find("stalled"), std::string::npos) << warnings;
}

/// A report of a run in which nothing happened.
class LoopWarnings : public testing::Test {
 protected:
  const std::unique_ptr<Device> device = open_device("mock:rest");
  const Simulation simulation{
      build_block({Vec3(-2e-3, -2e-3, -2e-3), Vec3(2e-3, 2e-3, 0)}, 2e-4, presets::cortical_bone()),
      Tool(SphereHead{1e-3}, RayHandle{2e-2}, Spindle{3000 * units::rad_per_s})};
  apps::LoopReport report{apps::summarize("block", simulation.workpiece()), *device, simulation, true, {}, {}, 0};

  void expect_only(const std::string& part) {
    ASSERT_EQ(apps::warnings_of(report).size(), 1U) << part;
    EXPECT_NE(apps::warnings_of(report).front().find(part), std::string::npos) << apps::warnings_of(report).front();
  }
};

TEST_F(LoopWarnings, SayThatTheToolWaitedAtTheEnd) {
  EXPECT_TRUE(apps::warnings_of(report).empty());
  report.seen.last.tool.status_seen = StepStatus::tool_waits;
  EXPECT_TRUE(apps::warnings_of(report).empty()) << "the hand is free again";
  report.seen.last.tool.status = StepStatus::tool_waits;
  expect_only("at the end the hand was inside material");
}

TEST_F(LoopWarnings, SayThatTheToolNeverTouched) {
  report.seen.last.tool.steps = 1000;
  expect_only("the tool never touched the workpiece; move --origin_mm");
  report.seen.last.tool.touched.insert(1);
  EXPECT_TRUE(apps::warnings_of(report).empty());
}

TEST_F(LoopWarnings, SayThatManyTicksTookLongerThanTheirPeriod) {
  report.run.period = 1e-3;
  report.run.ticks = 1000;
  for (int n = 0; n < 1000; ++n) report.run.compute.add(n < 990 ? 0.5e-3 : 1.5e-3);
  EXPECT_TRUE(apps::warnings_of(report).empty()) << "one of a hundred";
  report.run.compute.add(2e-3);
  expect_only("11 of 1000 ticks took longer than their period");
}

TEST_F(LoopWarnings, BlameTheDiskForItsSpeedOnlyWhenTheRecordingCameToItsEnd) {
  report.steps_lost = 7;
  expect_only("too slow: 7 steps");
  report.recording_failure = "No space left on device.";
  EXPECT_EQ(apps::warnings_of(report).front(),
            "the recording failed early: 7 steps are missing in the recording. The reason: No space left on device.");
}

#ifdef HAPTICUT_HAS_IO
// Like Ctrl-C: the signal arrives while the loop runs, because its recording has steps.
TEST_F(Loop, ReportsAndClosesItsRecordingWhenASignalEndsIt) {
  const std::string program = test::kProgram, recording = path("a.h5");
  for (const bool has_an_end : {false, true}) {
    const std::string script = program + " loop mock:spiral --simulated-time --seconds " + (has_an_end ? "1e6" : "0") +
                               " --record " + recording + " --json " + path("loop.json") + " " + kCoarse +
                               " & p=$!; while ! " + program + " replay " + recording +
                               " >/dev/null 2>&1 && kill -0 $p; do sleep 0.05; done; kill -TERM $p; wait $p";
    std::ofstream(folder / "run.sh") << script;
    const ProgramOutcome outcome = run_program(folder, path("run.sh"), "sh");
    EXPECT_EQ(outcome.code, has_an_end ? 1 : 0) << outcome.errors;
    EXPECT_EQ(outcome.errors.find("ended by signal 15") != std::string::npos, has_an_end) << outcome.errors;
    EXPECT_GT(read_json(folder / "loop.json")["ticks"], 0);
    EXPECT_NE(outcome.out.find("stopped"), std::string::npos) << outcome.out;
    const ProgramOutcome replayed = run("replay " + recording);
    EXPECT_EQ(replayed.code, 0) << replayed.errors;
    EXPECT_EQ(replayed.out.find("has no end"), std::string::npos) << replayed.out;
    std::filesystem::remove(recording);
  }
}
#endif

TEST_F(Loop, RefusesWhatItCannotDo) {
  EXPECT_EQ(run("loop").code, 2);
  expect_refused("loop falcon --seconds 1", {"mock:PATH"});
  std::ofstream(folder / "file") << "no folder";
  expect_refused("loop mock:spiral --seconds 1 --record " + path("file/folder.h5"), {"file/folder.h5"});
}

TEST_F(Loop, PressesTheSameAtEveryRate) {
  for (const int rate : {250, 500, 1000, 2000, 4000}) {
    const nlohmann::json report = loop("mock:press,hand=nominal --seconds 3 --simulated-time --spindle_rpm 0 --rate " +
                                       std::to_string(rate) + " " + kCoarse);
    EXPECT_EQ(report["rate_Hz"], rate);
    EXPECT_EQ(report["ticks"], 3 * rate + 1);
    EXPECT_NEAR(report["force_N"]["applied_at_end"].get<double>(), 0.942, 0.01) << rate;
    EXPECT_NEAR(report["force_N"]["max_applied"].get<double>(), 1.02, 0.05) << rate << ": where it meets the bone";
    EXPECT_EQ(report["safety_events"]["engaged"], 1) << rate;
  }
}

TEST_F(Loop, RunsInRealTimeAtEveryRate) {
  for (const char* rate : {"250", "2000", "4000"}) {
    const nlohmann::json report = loop("mock:rest --seconds 0.1 --rate " + std::string(rate) + " " + kCoarse);
    EXPECT_EQ(report["rate_Hz"], std::stod(rate));
  }
}

// The hand presses with one spring, at every scale, on a wall that is stiff compared with the device's coupling, so the
// force is the same.
TEST_F(Loop, RendersAnEqualForceAtEveryScale) {
  // The tolerance covers the compliance of the bone and the device's friction of 0.13 N.
  constexpr double kHand = 300, kTouch = 700, kBelow = 5e-3;  // [N/m], [N/m] that it renders, [m] of the set point
  const double expected = kBelow * kHand * kTouch / (kHand + kTouch);
  for (const char* scale : {"1", "2", "4"}) {
    const nlohmann::json report = loop("mock:press,hand=nominal --seconds 3 --simulated-time --spindle_rpm 0 --scale " +
                                       std::string(scale) + " " + kCoarse);
    EXPECT_NEAR(report["force_N"]["applied_at_end"].get<double>(), expected, 0.15) << scale;
  }
  for (const char* scale : {"0.001", "1e6", "0", "-1"}) {
    const ProgramOutcome refused = run("loop mock:rest --seconds 0.1 --scale " + std::string(scale));
    EXPECT_NE(refused.code, 0) << scale;
    EXPECT_NE(refused.errors.find("scale"), std::string::npos) << refused.errors;
    EXPECT_EQ(refused.errors.find("CouplingGains"), std::string::npos) << refused.errors;
  }
}

TEST_F(Loop, HasACouplingWhereTheDeviceNeedsOne) {
  const std::string arguments = "mock:press,hand=nominal --seconds 3 --simulated-time " + kCoarse;
  EXPECT_EQ(loop(arguments)["coupling"], "virtual");
  const nlohmann::json direct = loop(arguments + "--coupling none");
  EXPECT_EQ(direct["coupling"], "none");
  EXPECT_LT(direct["force_N"]["max_applied"], 2) << "the contact is as soft as the device renders";
  expect_refused("loop " + arguments + "--coupling none --reference_stiffness 1e14",
                 {"renders 700 N/m", "--coupling virtual"});
}

TEST_F(Loop, PressedWithAFlatBurCutsInEveryPreset) {
  for (const std::string_view material : preset_names()) {
    const nlohmann::json report = loop(
        "mock:press,hand=nominal --seconds 3 --simulated-time --head flat --radius_mm 1 --height_mm 4 --workpiece "
        "block --size_mm 24,24,8 --voxel_mm 0.2 --material " +
        std::string(material));
    ASSERT_FALSE(report.is_null()) << material;
    EXPECT_GT(report["removed_volume_mm3"].get<double>(), 1e-3) << material;
  }
}

// A hand that presses with some 1.5 N, as a Touch can for long.
TEST_F(Loop, InThesisModeCutsWithTheHeadsOfTheThesis) {
  for (const char* head :
       {"sphere --radius_mm 1", "cone --half_angle_deg 45 --height_mm 1", "flat --radius_mm 1 --height_mm 1"})
    for (const char* handle : {"ray --handle_length_mm 100", "L --handle_length_mm 100 --handle_neck_mm 20"}) {
      const auto cut = [&](const char* rpm) {
        const nlohmann::json report = loop(
            "mock:press,hand=nominal --seconds 3 --simulated-time --thesis_mode --workpiece block --size_mm "
            "12,12,4 --material dentin --voxel_mm 0.1 --head " +
            std::string(head) + " --handle " + handle + " --spindle_rpm " + rpm);
        return report["removed_volume_mm3"].get<double>();
      };
      EXPECT_EQ(cut("0"), 0) << head << ", " << handle;
      EXPECT_GT(cut("300000"), 0.05) << head << ", " << handle;
    }
}

#ifdef HAPTICUT_HAS_IO
TEST_F(Loop, KeepsTheRecordingThatItPlays) {
  (void)loop("mock:rest --seconds 0.1 --simulated-time --record " + path("a.h5") + " " + kCoarse);
  const std::string before = read_bytes(folder / "a.h5");
  for (const char* output : {"--record", "--json"})
    expect_refused("loop replay:" + path("a.h5") + " --simulated-time " + output + " " + path("a.h5") + " " + kCoarse,
                   {std::string(output) + " would overwrite", "the file of DEVICE"});
  EXPECT_EQ(read_bytes(folder / "a.h5"), before);
}

TEST_F(Loop, RecordsARunThatReplaysAndPlaysBackWithTheSameResult) {
  const nlohmann::json first =
      loop("mock:spiral,hand=nominal --seconds 4 --simulated-time --record " + path("a.h5") + " " + kCoarse);
  ASSERT_EQ(first["steps_lost_by_recorder"], 0);
  EXPECT_EQ(run("replay " + path("a.h5")).code, 0);
  const nlohmann::json again =
      loop("replay:" + path("a.h5") + " --simulated-time --record " + path("b.h5") + " " + kCoarse);
  EXPECT_EQ(again["removed_volume_mm3"], first["removed_volume_mm3"]);
  EXPECT_EQ(run("export " + path("a.h5") + " " + path("a.csv")).code, 0);
  EXPECT_EQ(run("export " + path("b.h5") + " " + path("b.csv")).code, 0);
  EXPECT_EQ(read_bytes(folder / "a.csv"), read_bytes(folder / "b.csv"));
  EXPECT_GT(read_bytes(folder / "a.csv").size(), 1000000U);
}
#endif

}  // namespace
}  // namespace hapticut::cli_loop_test
