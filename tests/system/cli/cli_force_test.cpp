// SPDX-License-Identifier: Apache-2.0
// Force laws, friction, handle torque and effects on the command line: each setting takes effect, and a wrong one is
// named.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>

#include "support/program.hpp"
#include "support/test_data.hpp"

namespace hapticut::cli_force_test {
namespace {

const std::string kDown = "--path line --from_mm 3,3,3.1 --to_mm 3,3,2.6 --feed_mm_per_s 5 ";
constexpr double kDigits = 1e-5;  // relative precision of a file with six digits
const std::string kStanding = "--head sphere --radius_mm 1 --spindle_rpm 0 ";

class ForceSettings : public test::Program {
 protected:
  /// Maximum force of a ball, cone or flat head pressed into bone.
  double pressed(const std::string& settings, const std::string& head = test::kSpinningBall) {
    return drill(test::kBlock + head + kDown + settings)["force_N"]["max"];
  }
  std::map<std::string, std::vector<double>> steps(const std::string& settings, const std::string& head,
                                                   const std::string& way = kDown) {
    return Program::steps(test::kBlock + head + way + settings);
  }
  void expect_failure(const std::string& settings, const std::vector<std::string>& words) {
    expect_refused("drill " + test::kBlock + test::kSpinningBall + kDown + settings, words);
  }
};
using EffectsSettings = ForceSettings;

TEST_F(ForceSettings, EveryLawIsChosenAndTakesItsConstants) {
  EXPECT_EQ(pressed("--law foundation"), pressed(""));
  // The force is proportional to the constant.
  struct Constant {
    std::string flag, once, twice;
    double ratio = 2;
    std::string head = test::kSpinningBall;
  };
  for (const Constant& c :
       std::vector<Constant>{{"contact_mechanics --effective_modulus_Pa ", "2e6", "4e6"},
                             {"hertzian_burr --burr_stiffness_Pa ", "2e6", "4e6"},
                             {"damping_matrix --resistance_Ns_per_m3 ", "2e8", "4e8"},
                             {"twist_drill --chip_energy_J_per_m3 ", "2e8", "4e8", 2,
                              "--head twist_drill --diameter_mm 2 --length_mm 5 --spindle_rpm 3000 "},
                             {"thesis --thesis_voxel_mm ", "0.1", "0.2", 4}})  // k_i = k_v l0^2
    EXPECT_NEAR(pressed("--removal none --law " + c.flag + c.twice, c.head) /
                    pressed("--removal none --law " + c.flag + c.once, c.head),
                c.ratio, 1e-6)
        << c.flag;
  EXPECT_GT(pressed("--law thesis --thesis_damping_Ns_per_m 1e-3 --removal none"),
            pressed("--law thesis --removal none"));
  EXPECT_GT(pressed("--law thesis --thesis_cutting_force_N 100"), pressed("--law thesis --thesis_cutting_force_N 0"));
  EXPECT_GT(pressed("--law thesis --thesis_cutting_rpm 1e6"), pressed("--law thesis --thesis_cutting_rpm 1e3"));
}

TEST_F(ForceSettings, TheThesissSpinTorqueTakesItsConstants) {
  const auto torque = [&](const std::string& settings) {
    const auto columns = steps("--law thesis --removal none " + settings, test::kSpinningBall);
    return -columns.at("torque_z_Nmm").back();
  };
  const double base = torque("--thesis_spin_torque 0.1");
  EXPECT_NEAR(torque("--thesis_spin_torque 0.2") / base, 2, 1e-3);
  EXPECT_NEAR(torque("--thesis_spin_torque 0.1 --thesis_spin_exponent 0.5") / base,
              std::sqrt(30000 * std::acos(-1.0) / 30), 0.1);
}

TEST_F(ForceSettings, FrictionOfTheStandingSpindleIsThatGiven) {
  const std::string drag = "--path line --from_mm 1.5,3,2.7 --to_mm 4.5,3,2.7 --feed_mm_per_s 20 ";
  const auto ratio = [&](const std::string& settings) {
    // The foundation is soft, so a depth of 0.3 mm gives a force that a hand can apply.
    const auto columns = steps("--reference_stiffness 1e13 " + settings, kStanding, drag);
    return -columns.at("force_x_N").back() / columns.at("force_z_N").back();
  };
  EXPECT_NEAR(ratio(""), 0.3, 0.02) << "that of the material";
  EXPECT_NEAR(ratio("--static_friction 0.6"), 0.6, 0.03);
  EXPECT_NEAR(ratio("--static_friction 0.6 --dynamic_friction 0.2"), 0.2, 0.02);
  EXPECT_NEAR(ratio("--dynamic_friction 0.5"), 0.5, 0.03);
}

TEST_F(ForceSettings, DeepContactMayBeSwitchedOff) {
  const std::string deep = "--path line --from_mm 3,3,3.1 --to_mm 3,3,1.2 --feed_mm_per_s 20 --removal none ";
  const double on = steps("", kStanding, deep).at("force_z_N").back();
  const double off = steps("--deep_contact=false", kStanding, deep).at("force_z_N").back();
  EXPECT_EQ(steps("--deep_contact false", kStanding, deep).at("force_z_N").back(), off);
  EXPECT_GT(on, 2 * off);
}

TEST_F(ForceSettings, TheTorqueAtTheHandMayBeThatOfTheThesis) {
  const std::string handle = test::kSpinningBall + "--handle ray --handle_length_mm 100 ";
  const std::string side = "--path line --from_mm -2,3,2.5 --to_mm 3,3,2.5 --feed_mm_per_s 20 ";
  const auto full = steps("", handle, side), ray = steps("--handle_torque thesis", handle, side);
  EXPECT_GT(std::abs(full.at("torque_y_Nmm").back()), 0.1);
  EXPECT_NEAR(ray.at("torque_y_Nmm").back(), 0, 1e-9);
  const std::string bent = test::kSpinningBall + "--handle L --handle_length_mm 50 --handle_neck_mm 10 ";
  const auto one = steps("--handle_torque thesis", bent, side),
             two = steps("--handle_torque thesis --handle_torque_scale 2", bent, side);
  EXPECT_NEAR(two.at("torque_y_Nmm").back() / one.at("torque_y_Nmm").back(), 2, kDigits);
  expect_failure("--handle_torque_scale 2",
                 {"--handle_torque_scale = 2; must be left out, because the full wrench has none",
                  "choose --handle_torque thesis"});
}

TEST_F(ForceSettings, AHeadWithoutAFormulaAndConstantsOfAnotherLawAreRefused) {
  expect_failure("--law twist_drill", {"was given a sphere of radius 1 mm", "no point angle", "a cone, a flat head"});
  expect_failure("--law contact_mechanics", {"--effective_modulus_Pa is missing", "Set --effective_modulus_Pa"});
  expect_failure("--law thesis --effective_modulus_Pa 1e6",
                 {"--effective_modulus_Pa = 1e+06", "the thesis has none", "choose --law contact_mechanics"});
  expect_failure("--burr_stiffness_Pa 1e6",
                 {"--burr_stiffness_Pa = 1e+06; must be left out, because the foundation law has none",
                  "choose --law hertzian_burr"});
  expect_failure("--static_friction 0.2 --dynamic_friction 0.3",
                 {"--dynamic_friction = 0.3; must be at most --static_friction = 0.2"});
}

// The flag is the library's thesis_mode: law, handle torque, quadrature, filter.
TEST_F(ForceSettings, ThesisModeIsAllOfItsPartsTogether) {
  const std::string bent = test::kSpinningBall + "--handle L --handle_length_mm 50 --handle_neck_mm 10 ";
  const auto mode = steps("--thesis_mode true", bent);
  EXPECT_EQ(steps("--thesis_mode", bent), mode);
  const auto parts = steps("--law thesis --handle_torque thesis --quadrature voxel_center --thesis_filter", bent);
  ASSERT_EQ(mode.size(), parts.size());
  for (const auto& [name, column] : parts) EXPECT_EQ(mode.at(name), column) << name;
  EXPECT_NE(mode.at("force_z_N"), steps("", bent).at("force_z_N"));
  const auto cured = steps("--thesis_mode --law foundation", bent);
  EXPECT_EQ(cured.at("force_z_N"), steps("--handle_torque thesis --thesis_filter", bent).at("force_z_N"));
  expect_failure("--law thesis --removal elastic_release", {"--removal = elastic_release; only the foundation"});
  // Other settings override the thesis mode. The mode vibrates at rates of 1112 Hz and above.
  const auto exact = steps("--thesis_mode --handle_torque full_wrench", bent);
  EXPECT_EQ(exact.at("force_z_N"), mode.at("force_z_N"));
  EXPECT_NE(exact.at("torque_z_Nmm"), mode.at("torque_z_Nmm"));
  const auto shaken = steps("--thesis_mode --rate 2000", bent), still = steps("--thesis_mode --rate 1100", bent);
  EXPECT_EQ(steps("--thesis_mode --rate 2000 --vibration_Hz 500 --vibration_N 0.3", bent), shaken);
  EXPECT_NE(steps("--thesis_mode --rate 2000 --vibration_N 0", bent), shaken);
  EXPECT_FALSE(still.empty());
}

TEST_F(ForceSettings, ComparesTheModelsOnTheCaseStudy) {
  const std::filesystem::path scene = test::source_path("examples/thesis/case_6_5.toml");
  const nlohmann::json of_thesis = drill("--settings " + scene.string());
  const nlohmann::json cured = drill("--settings " + scene.string() + " --thesis_mode false");
  EXPECT_GT(cured["removed_volume_mm3"]["total"], 0.1);
  EXPECT_NE(of_thesis["force_N"]["mean"], cured["force_N"]["mean"]);

  const std::string text = test::read_bytes(scene);
  std::ofstream(folder / "damped.toml") << std::regex_replace(text, std::regex("(damping_s_per_m) = 10"), "$1 = 300");
  const double most = of_thesis["force_N"]["max"];
  EXPECT_GT(drill("--settings " + (folder / "damped.toml").string())["force_N"]["max"], 1.1 * most);
}

TEST_F(EffectsSettings, ArriveInTheForceThatTheHandFeels) {
  const auto columns = steps("--mass_kg 0.1 --center_of_mass_mm 0,0,-50 --tool_axis 1,0,0 --point head", kStanding,
                             "--path line --from_mm 3,3,9 --to_mm 4,3,9 --feed_mm_per_s 20 ");
  EXPECT_NEAR(columns.at("force_z_N").back(), -0.980665, 1e-9);
  // The handle's z axis is along x of the world: the weight acts at a distance of 50 mm.
  EXPECT_NEAR(std::abs(columns.at("torque_y_Nmm").back()), 0.980665 * 50, 50 * kDigits);
  const auto up = steps("--mass_kg 0.1 --gravity_m_per_s2 0,2,0", kStanding,
                        "--path line --from_mm 3,3,9 --to_mm 4,3,9 --feed_mm_per_s 20 ");
  EXPECT_NEAR(up.at("force_y_N").back(), 0.2, 1e-9);
}

TEST_F(EffectsSettings, VibrationShakesWhileItCuts) {
  const auto still = steps("", test::kBall);
  const auto max_of = [&](const std::string& settings) {
    const auto shaken = steps("--vibration_Hz 150 --vibration_N " + settings, test::kBall);
    double max_change = 0;
    for (std::size_t i = 0; i < still.at("force_z_N").size(); ++i)
      max_change = std::max(max_change, std::abs(shaken.at("force_z_N")[i] - still.at("force_z_N")[i]));
    return max_change;
  };
  const double given = max_of("0.4");
  EXPECT_GT(given, 0.38);
  EXPECT_LE(given, 0.4 + kDigits);
  EXPECT_NEAR(max_of("0 --vibration_N_per_W 1e9 --vibration_max_N 0.1"), 0.1, 0.01);
  expect_failure("--vibration_Hz 500", {"--vibration_Hz = 500", "below 450", "--rate = 1000"});
  EXPECT_EQ(run("drill " + test::kBlock + test::kBall + kDown + "--rate 2000 --vibration_Hz 500").code, 0);
  expect_failure("--vibration_Hz 100 --vibration_N 1 --vibration_max_N 0.5",
                 {"--vibration_N = 1", "--vibration_max_N = 0.5"});
  expect_failure(
      "--vibration_N 1",
      {"--vibration_N = 1; must be left out, because a tool without --vibration_Hz has none", "set --vibration_Hz"});
}

TEST_F(EffectsSettings, FilterAxesAndLimitsShapeTheOutput) {
  const auto plain = steps("", test::kBall);
  const auto axes = steps("--force_axes 1,1,0 --torque_axes 0,0,0", test::kBall);
  for (const double force : axes.at("force_z_N")) EXPECT_EQ(force, 0);
  for (const double torque : axes.at("torque_z_Nmm")) EXPECT_EQ(torque, 0);

  const auto limited = steps("--max_force_N 0.5 --max_torque_Nmm 0.01", test::kBall);
  EXPECT_GT(*std::max_element(plain.at("force_z_N").begin(), plain.at("force_z_N").end()), 0.6);
  for (const double force : limited.at("force_z_N")) EXPECT_LE(force, 0.5 + 1e-9);
  for (const double torque : limited.at("torque_z_Nmm")) EXPECT_LE(std::abs(torque), 0.01 + 1e-9);

  const auto slow = steps("--force_growth_N_per_s 10 --torque_growth_Nmm_per_s 0.1", test::kBall);
  for (std::size_t i = 1; i < slow.at("force_z_N").size(); ++i) {
    EXPECT_LE(slow.at("force_z_N")[i] - slow.at("force_z_N")[i - 1], 0.01 + 1e-6);
    EXPECT_LE(std::abs(slow.at("torque_z_Nmm")[i]) - std::abs(slow.at("torque_z_Nmm")[i - 1]), 1e-4 + 1e-8);
  }
  const auto ramp = steps("--ramp_s 100", test::kBall);
  EXPECT_LT(ramp.at("force_z_N").back(), 0.01 * plain.at("force_z_N").back());

  const auto lagging = steps("--thesis_filter --filter_delta_N 0.01 --filter_epsilon_N 0.002", test::kBall);
  EXPECT_LT(*std::max_element(lagging.at("force_z_N").begin(), lagging.at("force_z_N").end()),
            *std::max_element(plain.at("force_z_N").begin(), plain.at("force_z_N").end()));
  expect_failure("--thesis_filter --filter_delta_N 0.01 --filter_epsilon_N 0.02",
                 {"--filter_epsilon_N = 0.02", "--filter_delta_N = 0.01"});
  expect_failure("--filter_delta_N 1", {"--filter_delta_N = 1; must be left out", "set --thesis_filter"});
}

TEST_F(ForceSettings, ArriveBehindTheCouplingToo) {
  const std::string press = "loop mock:press --simulated_time --seconds 2 --coupling virtual --removal none ";
  const auto pressed = [&](const std::string& law) {
    return report(press + law)["force_N"]["applied_at_end"].get<double>();
  };
  EXPECT_GT(pressed("--law hertzian_burr --burr_stiffness_Pa 1e7"),
            1.5 * pressed("--law hertzian_burr --burr_stiffness_Pa 1e5"));
  EXPECT_EQ(run(press + "--law hertzian_burr").code, 1) << "a constant is missing";
}

#ifdef HAPTICUT_HAS_IO
TEST_F(ForceSettings, ARecordingOfAnotherLawReplaysWithThatLaw) {
  (void)drill(test::kBlock + test::kSpinningBall + kDown + "--law hertzian_burr --burr_stiffness_Pa 3e6 --record " +
              path("r.h5"));
  EXPECT_NE(run("replay " + path("r.h5")).errors.find("another law than FoundationLaw"), std::string::npos);
  EXPECT_EQ(run("replay " + path("r.h5") + " --law hertzian_burr --burr_stiffness_Pa 3e6").code, 0);
  EXPECT_EQ(run("replay " + path("r.h5") + " --law hertzian_burr --burr_stiffness_Pa 2e6").code, 1);
}
#endif

}  // namespace
}  // namespace hapticut::cli_force_test
