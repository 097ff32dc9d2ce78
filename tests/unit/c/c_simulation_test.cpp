// SPDX-License-Identifier: Apache-2.0
// A simulation through the C interface gives the same results as in C++.
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

#include "hapticut/settings/scene.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "support/temporary_folder.hpp"
#include "unit/c/scenes.hpp"

namespace hapticut::c_simulation_test {
namespace {

using namespace c_test;

Simulation in_cpp(bool for_coupling = false) {
  settings::Scene scene = settings::from_toml(kScene);
  if (for_coupling) scene.config.contact_time = ContactTime::end;
  return Simulation(std::move(scene.workpiece), scene.tool, scene.config);
}

Pose pose_of(const hapticut_step_input& input) {
  return Pose::from_translation(Vec3(input.X_WH.position[0], input.X_WH.position[1], input.X_WH.position[2]));
}
Twist twist_of(const hapticut_step_input& input) { return {Vec3(0, 0, input.linear_velocity[2]), Vec3::Zero()}; }

/// The error of a scene in which a part of kScene is replaced.
std::string complaint(const std::string& part, const std::string& in_its_place) {
  std::string text = kScene;
  text.replace(text.find(part), part.size(), in_its_place);
  hapticut_simulation simulation = 17;
  EXPECT_EQ(hapticut_simulation_from_toml(text.c_str(), nullptr, &simulation), HAPTICUT_ERROR_REFUSED);
  EXPECT_EQ(simulation, 17U) << "the output is unchanged";
  return hapticut_last_error();
}

TEST(CInterface, GivesEveryStepBitByBitAsCppDoes) {
  Simulation expected = in_cpp();
  const Owned simulation(simulation_of());
  auto result = sized<hapticut_step_result>();
  double removed = 0;
  for (int n = 1; n <= 400; ++n) {
    const hapticut_step_input input = above(2e-6 * n);
    ASSERT_EQ(hapticut_step(simulation.get(), &input, &result), HAPTICUT_OK) << hapticut_last_error();
    const StepResult& same = expected.step(pose_of(input), twist_of(input), input.dt);
    ASSERT_EQ(Vec3(result.force[0], result.force[1], result.force[2]), same.force);
    ASSERT_EQ(Vec3(result.torque[0], result.torque[1], result.torque[2]), same.torque);
    ASSERT_EQ(result.removed_volume, same.removed_volume);
    ASSERT_EQ(result.removed_voxels, same.removed_voxels.size());
    ASSERT_EQ(result.status, std::uint32_t(same.status));
    ASSERT_EQ(result.spindle_torque, same.spindle.torque);
    ASSERT_EQ(result.contact_voxels, std::uint32_t(same.contact.voxels));
    ASSERT_EQ(std::memcmp(&result.X_WH, &input.X_WH, sizeof input.X_WH), 0);
    removed += result.removed_volume;
  }
  EXPECT_GT(removed, 0);
  auto info = sized<hapticut_material_info>();
  ASSERT_EQ(hapticut_material(simulation.get(), 1, &info), HAPTICUT_OK);
  EXPECT_STREQ(info.name, "cortical_bone");
  EXPECT_EQ(info.removed_volume, expected.totals().removed_volume[1]);
  auto ledger = sized<hapticut_energy_ledger>();
  ASSERT_EQ(hapticut_energy(simulation.get(), &ledger), HAPTICUT_OK);
  EXPECT_EQ(ledger.cutting, expected.last_result().energy.cutting);
  EXPECT_EQ(ledger.imbalance, expected.last_result().energy.imbalance());

  const hapticut_step_input input = above(1e-3);
  auto probe = sized<hapticut_probe_result>();
  ASSERT_EQ(hapticut_probe(simulation.get(), &input, &probe), HAPTICUT_OK);
  const ContactProbe same = expected.probe(pose_of(input), twist_of(input), input.dt);
  EXPECT_EQ(probe.force[2], same.wrench.force.z());
  EXPECT_GT(probe.stiffness[14], 0) << "along z";
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 6; ++column)
      EXPECT_EQ(probe.stiffness[6 * row + column], same.stiffness(row, column));
  int touches = -1;
  ASSERT_EQ(hapticut_touches(simulation.get(), &input.X_WH, &touches), HAPTICUT_OK);
  EXPECT_EQ(touches, 1);
}

TEST(CInterface, MeasuresDistancesAsCppDoes) {
  const Simulation expected = in_cpp();
  const Owned simulation(simulation_of());
  const hapticut_step_input input = above(-1.3e-3);
  double distance = -1;
  for (const std::uint32_t material : {0U, 1U}) {
    ASSERT_EQ(hapticut_distance_to(simulation.get(), material, &input.X_WH, 0, &distance), HAPTICUT_OK);
    EXPECT_EQ(distance, expected.distance_to(MaterialId(material), pose_of(input)));
  }
  EXPECT_NEAR(distance, 1.3e-3, 0.2 * 0.2e-3);
  distance = -1;
  EXPECT_EQ(hapticut_distance_to(simulation.get(), 1, &input.X_WH, 1e-3, &distance), HAPTICUT_NOTHING);
  EXPECT_EQ(distance, -1) << "the output is unchanged";
  const double origin[3] = {1e-3, 2e-3, 9e-3}, down[3] = {0, 0.1, -2}, zero[3] = {0, 0, 0};
  auto hit = sized<hapticut_ray_hit>();
  ASSERT_EQ(hapticut_first_hit(simulation.get(), origin, down, 0, 0, &hit), HAPTICUT_OK);
  const std::optional<RayHit> same = expected.workpiece().first_hit(Vec3(origin), Vec3(down));
  EXPECT_EQ(hit.distance, same->distance);
  EXPECT_EQ(hit.material, 1U);
  EXPECT_EQ(Vec3(hit.point_W), same->point_W);
  EXPECT_EQ(Vec3(hit.normal_W), same->normal_W);
  EXPECT_EQ(hapticut_first_hit(simulation.get(), origin, down, 1e-3, 1, &hit), HAPTICUT_NOTHING);

  const auto refuses = [](int code, const std::string& words) {
    EXPECT_EQ(code, HAPTICUT_ERROR_ARGUMENT);
    EXPECT_NE(std::string(hapticut_last_error()).find(words), std::string::npos) << hapticut_last_error();
  };
  hapticut_pose mirrored = input.X_WH;
  mirrored.rotation[0] = -1;
  refuses(hapticut_distance_to(simulation.get(), 1, &mirrored, 0, &distance), "X_WH is not a rigid transform");
  refuses(hapticut_distance_to(simulation.get(), 2, &input.X_WH, 0, &distance), "material = 2");
  refuses(hapticut_distance_to(simulation.get(), 1, &input.X_WH, -1, &distance), "max_distance = -1");
  refuses(hapticut_distance_to(simulation.get(), 1, nullptr, 0, &distance), "X_WH");
  refuses(hapticut_first_hit(simulation.get(), origin, zero, 0, 0, &hit), "is not a ray");
  refuses(hapticut_first_hit(simulation.get(), origin, down, 0, 300, &hit), "material = 300");
  refuses(hapticut_first_hit(simulation.get(), origin, nullptr, 0, 0, &hit), "direction_W");
}

TEST(CInterface, TellsOnceThatAMaterialIsTouchedForTheFirstTime) {
  const Owned simulation(simulation_of());
  auto result = sized<hapticut_step_result>();
  int events = 0;
  for (int n = -50; n <= 50; ++n) {
    const hapticut_step_input input = above(2e-6 * n);
    ASSERT_EQ(hapticut_step(simulation.get(), &input, &result), HAPTICUT_OK) << hapticut_last_error();
    events += HAPTICUT_HAS_MATERIAL(result.first_touched, 1);
    if (result.contact_voxels > 0) {
      EXPECT_EQ(events, 1) << n;
    }
  }
  EXPECT_EQ(events, 1);
  EXPECT_EQ(HAPTICUT_HAS_MATERIAL(result.first_touched, 255), 0);
}

TEST(CInterface, CouplesAHandAsCppDoes) {
  Simulation expected = in_cpp(true);
  CouplingGains gains;
  gains.stiffness = 500;
  VirtualCoupling expected_coupling(expected, gains);
  const Owned simulation(simulation_of(kScene, 1));
  auto given = sized<hapticut_coupling_gains>();
  given.stiffness = 500;
  Owned coupling;
  ASSERT_EQ(hapticut_coupling_open(simulation.get(), &given, coupling.to()), HAPTICUT_OK) << hapticut_last_error();
  auto result = sized<hapticut_step_result>();
  for (int n = -10; n <= 300; ++n) {
    const hapticut_step_input input = above(10e-6 * n);
    ASSERT_EQ(hapticut_coupling_step(coupling.get(), &input, &result), HAPTICUT_OK) << hapticut_last_error();
    const CoupledResult& same = expected_coupling.step(pose_of(input), twist_of(input), input.dt);
    ASSERT_EQ(Vec3(result.force[0], result.force[1], result.force[2]), same.hand.force);
    ASSERT_EQ(result.X_WH.position[2], same.X_WH.translation.z());
  }
  EXPECT_GT(result.force[2], 0.05);
  ASSERT_EQ(hapticut_set_tool(simulation.get(), kOtherTool.c_str()), HAPTICUT_OK) << hapticut_last_error();
  const hapticut_step_input input = above(0);
  EXPECT_EQ(hapticut_coupling_step(coupling.get(), &input, &result), HAPTICUT_ERROR_REFUSED)
      << "the coupling was made for the old tool";
}

TEST(CInterface, SeparatesToolAndHandAfterAnExchangeOrARelease) {
  const std::uint32_t waits = std::uint32_t(StepStatus::tool_waits);
  const auto expect_nothing = [&](const hapticut_step_result& result) {
    EXPECT_EQ(result.status, waits);
    EXPECT_EQ(result.force[2], 0);
    EXPECT_EQ(result.removed_volume, 0);
  };
  const hapticut_step_input deep = above(1e-3), free = above(-1e-3);
  auto result = sized<hapticut_step_result>();
  for (const int cause : {0, 1, 2, 3}) {
    const Owned simulation(simulation_of(kScene, 1, 1000));
    Owned snapshot, coupling;
    ASSERT_EQ(hapticut_snapshot_take(simulation.get(), snapshot.to()), HAPTICUT_OK);
    ASSERT_EQ(hapticut_set_undo_mark(simulation.get()), HAPTICUT_OK);
    ASSERT_EQ(hapticut_coupling_open(simulation.get(), nullptr, coupling.to()), HAPTICUT_OK);
    for (int n = -25; n <= 300; ++n) {
      const hapticut_step_input input = above(4e-6 * n);
      ASSERT_EQ(hapticut_coupling_step(coupling.get(), &input, &result), HAPTICUT_OK);
    }
    ASSERT_GT(result.force[2], 0.05);
    if (cause == 0) {
      ASSERT_EQ(hapticut_undo(simulation.get()), HAPTICUT_OK);
    }
    if (cause == 1) {
      ASSERT_EQ(hapticut_snapshot_restore(simulation.get(), snapshot.get()), HAPTICUT_OK);
    }
    if (cause == 2) {
      ASSERT_EQ(hapticut_coupling_reset(coupling.get()), HAPTICUT_OK);
    }
    if (cause == 3) {
      ASSERT_EQ(hapticut_set_tool(simulation.get(), kOtherTool.c_str()), HAPTICUT_OK);
      ASSERT_EQ(coupling.release(), HAPTICUT_OK);
      ASSERT_EQ(hapticut_coupling_open(simulation.get(), nullptr, coupling.to()), HAPTICUT_OK);
    }
    for (int n = 0; n < 3; ++n) {
      ASSERT_EQ(hapticut_coupling_step(coupling.get(), &deep, &result), HAPTICUT_OK);
      expect_nothing(result);
    }
    for (int n = 0; n < 2; ++n) ASSERT_EQ(hapticut_coupling_step(coupling.get(), &free, &result), HAPTICUT_OK);
    EXPECT_EQ(result.status, 0U);
  }
  const Owned direct(simulation_of());
  cut(direct.get(), 400);
  ASSERT_EQ(hapticut_set_tool(direct.get(), kOtherTool.c_str()), HAPTICUT_OK);
  const hapticut_step_input deeper = above(1.4e-3);  // the smaller ball is free in the hole of the larger one
  ASSERT_EQ(hapticut_step(direct.get(), &deeper, &result), HAPTICUT_OK);
  expect_nothing(result);
}

TEST(CInterface, NeedsASimulationThatIsMadeForACoupling) {
  const Owned simulation(simulation_of());
  hapticut_coupling coupling = 0;
  EXPECT_EQ(hapticut_coupling_open(simulation.get(), nullptr, &coupling), HAPTICUT_ERROR_REFUSED);
  EXPECT_NE(std::string(hapticut_last_error()).find("Make it with hapticut_simulation_options.for_coupling = 1"),
            std::string::npos)
      << hapticut_last_error();
}

TEST(CInterface, SaysLineKeyAndCureOfAWrongScene) {
  EXPECT_EQ(complaint("radius_mm = 1", "radius_mm = -1"),
            "scene:9: tool.radius_mm: must be a number > 0 and <= 300, not -1.");
  const std::string unknown = complaint("radius_mm = 1", "radius_m = 1");
  EXPECT_NE(unknown.find("scene:9: "), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("radius_mm"), std::string::npos) << "the nearest key: " << unknown;
  EXPECT_NE(complaint("[tool]", "[tool").find("scene:7: "), std::string::npos);
  EXPECT_NE(complaint("cortical_bone", "cortical_b\xc3\xb6ne").find("cortical_b\xc3\xb6ne"), std::string::npos);
  EXPECT_NE(complaint("\"block\"", "\"no_such_file.stl\"").find("no_such_file.stl"), std::string::npos);
  hapticut_simulation simulation = 0;
  EXPECT_EQ(hapticut_simulation_from_file("no_such_scene.toml", nullptr, &simulation), HAPTICUT_ERROR_REFUSED);
  EXPECT_NE(std::string(hapticut_last_error()).find("no_such_scene.toml"), std::string::npos);
}

TEST(CInterface, SaysWhatIsWrongInNamesOfCAndKeysOfTheScene) {
  const Owned simulation(simulation_of(kScene, 1));
  const auto refused = [](int code) {
    EXPECT_EQ(code, HAPTICUT_ERROR_REFUSED);
    return std::string(hapticut_last_error());
  };
  auto gains = sized<hapticut_coupling_gains>();
  gains.mass = -1;
  auto loop_options = sized<hapticut_loop_options>();
  loop_options.scale = 1e9;
  auto sound_options = sized<hapticut_sound_options>();
  sound_options.half_power = -1;
  const Owned device(device_of());
  hapticut_handle none = 0;
  const std::pair<std::string, const char*> said[] = {
      {complaint("radius_mm = 1\n", ""), "a sphere needs it. Set tool.radius_mm."},
      {complaint("radius_mm = 1\n", "radius_mm = 1\nheight_mm = 2\n"), "or choose tool.head cone"},
      {complaint("handle_length_mm = 20\n", ""), "Set tool.handle_length_mm."},
      {complaint("head = \"sphere\"\n", ""), "Set tool.head to sphere, cone"},
      {complaint("\"block\"\nsize_mm = [6, 6, 3]\nvoxel_mm = 0.2\nmaterial = \"cortical_bone\"",
                 "\"slab\"\nsize_mm = [6, 6, 3]\nvoxel_mm = 0.2"),
       "a slab needs at least one layer. Set workpiece.layers."},
      {refused(hapticut_coupling_open(simulation.get(), &gains, &none)), "hapticut_coupling_gains.mass [kg] = -1"},
      {refused(hapticut_set_spindle_speed(simulation.get(), 4e6)), "Write 40000 * HAPTICUT_RPM"},
      {refused(hapticut_device_open("openhaptics", &none)), "-DHAPTICUT_WITH_OPENHAPTICS=ON."},
      {refused(hapticut_sound_open(&sound_options, &none)), "hapticut_sound_options.half_power [W] = -1"},
      {refused(hapticut_loop_start(simulation.get(), device.get(), &loop_options, &none)),
       "hapticut_loop_options.scale"},
  };
  for (const auto& [sentence, cure] : said) {
    EXPECT_NE(sentence.find(cure), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find("::"), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find("--"), std::string::npos) << sentence;
  }
  EXPECT_NE(complaint("\"block\"", "\"no--head::file.stl\"").find("no--head::file.stl"), std::string::npos);
  for (const std::string begin : {"A", "--a", "x A"})  // absurdly long names
    EXPECT_TRUE(complaint("\"sphere\"", '"' + begin + std::string(1'000'000, 'A') + '"').starts_with("scene:8: "));
}

TEST(CInterface, TellsWhatTheSceneHas) {
  const Owned simulation(simulation_of(kScene + "\n[path]\nkind = \"line\"\npoint = \"head\"\nfrom_mm = [0, 3, 4]\n"
                                                "to_mm = [6, 3, 4]\nfeed_mm_per_s = 3\n"));
  auto info = sized<hapticut_scene_info>();
  ASSERT_EQ(hapticut_scene(simulation.get(), &info), HAPTICUT_OK);
  EXPECT_EQ(info.materials, 1U);
  EXPECT_NEAR(info.voxel_size, 0.2e-3, 1e-12);
  EXPECT_NEAR(info.box_min[2], 0, 1e-9);
  EXPECT_NEAR(info.box_max[2], 3e-3, 1e-9);
  EXPECT_NEAR(info.X_HT.position[2], -20e-3, 1e-12);
  EXPECT_NEAR(info.head_max[0], 1e-3, 1e-9);
  EXPECT_EQ(info.spindle_speed, 40000 * HAPTICUT_RPM) << "spindle_rpm of the scene";
  EXPECT_EQ(info.rate, 1000);
  EXPECT_NEAR(info.path_duration, 2, 1e-9);
  hapticut_pose X_WH;
  ASSERT_EQ(hapticut_path_pose(simulation.get(), 1, &X_WH), HAPTICUT_OK);
  EXPECT_NEAR(X_WH.position[0], 3e-3, 1e-9);
  EXPECT_NEAR(X_WH.position[2], 24e-3, 1e-9);
  const Owned without(simulation_of());
  EXPECT_EQ(hapticut_path_pose(without.get(), 1, &X_WH), HAPTICUT_NOTHING);
  auto material = sized<hapticut_material_info>();
  EXPECT_EQ(hapticut_material(without.get(), 0, &material), HAPTICUT_ERROR_ARGUMENT);
  EXPECT_EQ(hapticut_material(without.get(), 2, &material), HAPTICUT_ERROR_ARGUMENT);
}

TEST(CInterface, UndoesAndRedoes) {
  const Owned simulation(simulation_of(kScene, 0, 4096));
  const double whole = volume_of(simulation.get());
  Owned snapshot;
  ASSERT_EQ(hapticut_snapshot_take(simulation.get(), snapshot.to()), HAPTICUT_OK);
  EXPECT_EQ(hapticut_undo(simulation.get()), HAPTICUT_NOTHING);
  ASSERT_EQ(hapticut_set_undo_mark(simulation.get()), HAPTICUT_OK);
  cut(simulation.get(), 400);
  const double less = volume_of(simulation.get());
  EXPECT_LT(less, whole);
  ASSERT_EQ(hapticut_undo(simulation.get()), HAPTICUT_OK);
  EXPECT_EQ(volume_of(simulation.get()), whole);
  ASSERT_EQ(hapticut_redo(simulation.get()), HAPTICUT_OK);
  EXPECT_EQ(volume_of(simulation.get()), less);
  EXPECT_EQ(hapticut_redo(simulation.get()), HAPTICUT_NOTHING);
  ASSERT_EQ(hapticut_snapshot_restore(simulation.get(), snapshot.get()), HAPTICUT_OK);
  EXPECT_EQ(volume_of(simulation.get()), whole);

  const Owned other(simulation_of());
  EXPECT_EQ(hapticut_snapshot_restore(other.get(), snapshot.get()), HAPTICUT_ERROR_REFUSED);
  EXPECT_EQ(hapticut_set_undo_mark(other.get()), HAPTICUT_ERROR_REFUSED) << "it has no memory for undo";
  EXPECT_NE(std::string(hapticut_last_error()).find("undo_blocks"), std::string::npos);
}

TEST(CInterface, SavesAWorkpieceThatASceneReads) {
  const test::TemporaryFolder folder;
  const std::string path = (folder / "cut.vdb").string();
  const Owned simulation(simulation_of());
  cut(simulation.get(), 200);
  ASSERT_EQ(hapticut_save_workpiece(simulation.get(), path.c_str()), HAPTICUT_OK) << hapticut_last_error();
  EXPECT_EQ(hapticut_save_workpiece(simulation.get(), "cut.stl"), HAPTICUT_ERROR_ARGUMENT);
  EXPECT_EQ(hapticut_save_workpiece(simulation.get(), "/no/such/folder/cut.vdb"), HAPTICUT_ERROR_REFUSED);
  const std::string file = (folder / "scene.toml").string();
  std::ofstream(file) << "[workpiece]\nsource = \"" << path << "\"\n" << kOtherTool;
  Owned again;
  ASSERT_EQ(hapticut_simulation_from_file(file.c_str(), nullptr, again.to()), HAPTICUT_OK) << hapticut_last_error();
  EXPECT_EQ(volume_of(again.get()), volume_of(simulation.get()));
}

TEST(CInterface, ReportsItsVersionAndTheNamesOfStatusBits) {
  EXPECT_EQ(hapticut_abi_version(), std::uint32_t(HAPTICUT_ABI_VERSION));
  EXPECT_EQ(std::string(hapticut_version()).find("0."), 0U) << hapticut_version();
  char text[64];
  ASSERT_EQ(hapticut_status_text(0, text, sizeof text), HAPTICUT_OK);
  EXPECT_STREQ(text, "ok");
  ASSERT_EQ(hapticut_status_text(1U << 4 | 1U << 8, text, sizeof text), HAPTICUT_OK);
  EXPECT_STREQ(text, "blocks_low | power_limited");
  ASSERT_EQ(hapticut_status_text(1U << 4 | 1U << 8, text, 7), HAPTICUT_OK);
  EXPECT_STREQ(text, "blocks");
  EXPECT_EQ(hapticut_status_text(0, text, 0), HAPTICUT_ERROR_ARGUMENT);

  // An invalid pose is no error, but a status bit.
  const Owned simulation(simulation_of());
  auto input = above(0);
  input.X_WH.rotation[0] = 2;
  auto result = sized<hapticut_step_result>();
  ASSERT_EQ(hapticut_step(simulation.get(), &input, &result), HAPTICUT_OK);
  ASSERT_EQ(hapticut_status_text(result.status, text, sizeof text), HAPTICUT_OK);
  EXPECT_STREQ(text, "pose_rejected");
  EXPECT_EQ(hapticut_set_spindle_speed(simulation.get(), 1e300), HAPTICUT_ERROR_REFUSED);
  EXPECT_EQ(hapticut_set_tool(simulation.get(), "[tool]\nradius_mm = -1\n"), HAPTICUT_ERROR_REFUSED);
  EXPECT_STREQ(hapticut_last_error(), "tool:2: tool.radius_mm: must be a number > 0 and <= 300, not -1.");
  EXPECT_EQ(hapticut_set_tool(simulation.get(), (kOtherTool + "cutter = \"coarse_diamond\"\n").c_str()),
            HAPTICUT_ERROR_REFUSED);
  EXPECT_STREQ(
      hapticut_last_error(),
      "tool.cutter = coarse_diamond; but the materials of this scene have the constants of carbide_bur, so the "
      "forces would be wrong. Keep the cutter, or make another scene.");
}

}  // namespace
}  // namespace hapticut::c_simulation_test
