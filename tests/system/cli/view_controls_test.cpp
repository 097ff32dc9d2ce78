// SPDX-License-Identifier: Apache-2.0
// The panels of a page: effect of each control on the model in a loop, and its value afterwards.
#include "page/session/view_controls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string_view>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/simulation/thesis_mode.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "hapticut/workpiece/preset_constants.hpp"
#include "page/session/watched_model.hpp"
#include "support/refusal.hpp"
#include "support/scripted_loop.hpp"

namespace hapticut::view_controls_test {
namespace {

using apps::Change;
using apps::ViewControls;
using units::mm;
using units::rpm;

/// A model as in a loop, and the controls of a page that change it as in a session.
struct Panel {
  test::scripted_loop::ScriptedLoop scripted{3000, true};
  apps::WatchedModel watched{scripted.model, scripted.simulation, *scripted.device, 1e-3};
  ViewControls controls{scripted.simulation.tool(), scripted.simulation.workpiece().materials(),
                        scripted.simulation.config(), true};

  [[nodiscard]] const view::Control& control(const std::string& name) const {
    for (const view::Control& one : controls.all())
      if (one.panel + "/" + one.label == name) return one;
    throw Error("there is no control " + name);
  }
  Change set(const std::string& name, double value) { return controls.set({control(name).id, value}); }
  void tell(LoopCommand command) {
    watched.check(command);
    EXPECT_TRUE(watched.apply(command));
  }
  void turn(const std::string& name, double value) {
    const Change change = set(name, value);
    if (change == Change::removal) tell(commands::SetRemoval{controls.removal()});
    if (change == Change::spindle) tell(commands::SetSpindleSpeed{controls.spindle_speed()});
    if (change == Change::effects) tell(commands::SetEffects{controls.effects()});
    if (change == Change::materials) tell(scripted.model.prepare_materials(controls.materials()));
    if (change == Change::tool) tell(scripted.model.prepare_tool(controls.tool()));
  }
  [[nodiscard]] const Tool& tool() const { return scripted.simulation.tool(); }
  [[nodiscard]] const Effects& effects() const { return scripted.simulation.config().effects; }
  [[nodiscard]] const Material& material() const { return scripted.simulation.workpiece().materials()[MaterialId(1)]; }
};

/// The value of the control of the head for a head of the list; 0 is the scene's own.
double head_named(std::string_view name) {
  const auto found = std::ranges::find(head_shapes(), name, &HeadShape::name);
  return double(found - head_shapes().begin()) + 1;
}

/// A value set by a control, and the resulting value of the model in the unit of the control.
struct Turned {
  double value;
  std::function<double(const Panel&)> has;
  std::map<std::string, double> before = {};  ///< that must stand so for it to be seen
};

double length(const Panel& p) {
  return (p.tool().head().bounding_box().max.z() - p.tool().head().bounding_box().min.z()) / mm;
}
const LHandle& bent(const Panel& p) { return std::get<LHandle>(p.tool().handle()); }

const std::map<std::string, Turned>& turned() {
  using P = const Panel&;
  const std::map<std::string, double> shaking = {{"vibration/Vibration", 1}}, filtering = {{"additional/Filter", 1}},
                                      bending = {{"tool/Handle", 1}},
                                      cylinder = {{"tool/Head", head_named("cylinder")}};
  static const std::map<std::string, Turned> all = {
      {"application/Haptics", {0, [](P p) { return p.effects().enabled.force[1]; }}},
      {"application/Cutting", {0, [](P p) { return p.scripted.simulation.config().removal != RemovalLaw::none; }}},
      {"application/Removal",
       {1, [](P p) { return p.scripted.simulation.config().removal == RemovalLaw::elastic_release; }}},
      {"application/Spindle", {0, [](P p) { return p.scripted.model.spindle_speed(); }}},
      {"tool/Speed", {12345, [](P p) { return p.scripted.model.spindle_speed() / rpm; }}},
      {"tool/Head",
       {head_named("twist_drill"),
        [](P p) {
          return p.tool().cutter().lips == lips_of({CutterKind::twist_drill}) ? head_named("twist_drill") : 0;
        }}},
      {"tool/Diameter", {2.5, [](P p) { return 2 * p.tool().head().max_radius() / mm; }, cylinder}},
      {"tool/Length", {4.5, length, cylinder}},
      {"tool/Cone angle",
       {20,
        [](P p) { return std::atan(p.tool().head().max_radius() / (length(p) * mm)) / units::deg; },
        {{"tool/Head", head_named("cone")}}}},
      {"tool/Power limit", {12, [](P p) { return p.tool().spindle().power_limit; }}},
      {"tool/Handle", {1, [](P p) { return p.tool().handle().index() == 1; }}},
      {"tool/Handle length", {77, [](P p) { return std::get<RayHandle>(p.tool().handle()).length / mm; }}},
      {"tool/Neck", {9, [](P p) { return bent(p).neck / mm; }, bending}},
      {"tool/Bend", {-30, [](P p) { return bent(p).bend / units::deg; }, bending}},
      {"additional/Gravity", {1, [](P p) { return p.effects().gravity.has_value(); }}},
      {"additional/Mass", {0.3, [](P p) { return p.effects().gravity->mass; }, {{"additional/Gravity", 1}}}},
      {"additional/Filter", {1, [](P p) { return p.effects().delta_filter.has_value(); }}},
      {"additional/Filter passes", {2, [](P p) { return p.effects().delta_filter->delta; }, filtering}},
      {"additional/Filter step", {0.002, [](P p) { return p.effects().delta_filter->epsilon; }, filtering}},
      {"vibration/Vibration", {1, [](P p) { return p.effects().vibration.has_value(); }}},
      {"vibration/Frequency", {99, [](P p) { return p.effects().vibration->frequency; }, shaking}},
      {"vibration/Amplitude", {0.25, [](P p) { return p.effects().vibration->amplitude; }, shaking}},
      {"vibration/Growth", {0.125, [](P p) { return p.effects().vibration->amplitude_per_watt; }, shaking}},
      {"vibration/Largest", {4, [](P p) { return p.effects().vibration->max_amplitude; }, shaking}},
      {"outputs/force x", {0, [](P p) { return p.effects().enabled.force[0]; }}},
      {"outputs/force y", {0, [](P p) { return p.effects().enabled.force[1]; }}},
      {"outputs/force z", {0, [](P p) { return p.effects().enabled.force[2]; }}},
      {"outputs/torque x", {0, [](P p) { return p.effects().enabled.torque[0]; }}},
      {"outputs/torque y", {0, [](P p) { return p.effects().enabled.torque[1]; }}},
      {"outputs/torque z", {0, [](P p) { return p.effects().enabled.torque[2]; }}},
      {"material/plain stiffness", {1.5, [](P p) { return p.material().relative_stiffness; }}},
      {"material/plain damping", {7, [](P p) { return p.material().damping; }}},
      {"material/plain cutting energy", {3, [](P p) { return p.material().specific_cutting_energy * 1e-9; }}},
      {"material/plain cutting ratio", {2, [](P p) { return p.material().cutting_ratio; }}},
      {"material/plain static friction", {0.9, [](P p) { return p.material().static_friction; }}},
      {"material/plain dynamic friction", {0.05, [](P p) { return p.material().dynamic_friction; }}},
  };
  return all;
}

/// Controls that do not affect the model.
const std::map<std::string, Change> kBeside = {
    {"application/Record", Change::record},
    {"application/Reset", Change::reset},
    {"application/Restart", Change::restart},
    {"additional/Sound of the drill", Change::haptics},
    {"additional/Volume", Change::haptics},
    {"application/Remove loose pieces", Change::loose_pieces},
    {"heat/Heat", Change::heat},
    {"heat/Water", Change::heat},
    {"heat/Irrigation", Change::heat},
};

TEST(ViewControls, EachIsOneOfThoseThatAreTestedHere) {
  std::set<std::string> names;
  std::set<std::uint16_t> ids;
  const Panel panel;
  for (const view::Control& one : panel.controls.all()) {
    const std::string name = one.panel + "/" + one.label;
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_TRUE(ids.insert(one.id).second) << name;
    EXPECT_TRUE(turned().contains(name) || kBeside.contains(name)) << name;
    EXPECT_TRUE(one.value >= one.min && one.value <= one.max) << name;
    if (one.kind == view::Control::Kind::choice) {
      EXPECT_EQ(double(std::ranges::count(one.choices, '|')), one.max) << name;
    }
  }
  EXPECT_EQ(names.size(), turned().size() + kBeside.size());
}

TEST(ViewControls, ChangeTheQuantityOfTheModelThatTheyName) {
  for (const auto& [name, to] : turned()) {
    Panel panel;
    for (const auto& [other, value] : to.before) panel.turn(other, value);
    panel.turn(name, to.value);
    EXPECT_NEAR(to.has(panel), to.value, 1e-9 * std::abs(to.value)) << name;
    panel.controls.show(panel.watched.settings());
    EXPECT_NEAR(panel.control(name).value, to.value, 1e-9 * std::abs(to.value)) << name;
  }
  for (const auto& [name, change] : kBeside) {
    Panel panel;
    EXPECT_EQ(panel.set(name, 1), change) << name;
  }
}

TEST(ViewControls, RefuseValuesOutOfTheirRange) {
  Panel panel;
  const std::vector<view::Control> before(panel.controls.all().begin(), panel.controls.all().end());
  for (const view::Control& one : before) {
    std::vector<double> wrong = {std::nextafter(one.min, -1e9), std::nextafter(one.max, 1e9), std::nan(""),
                                 std::numeric_limits<double>::infinity()};
    if (one.kind != view::Control::Kind::number) wrong.push_back(0.5);
    for (const double value : wrong) EXPECT_EQ(panel.controls.set({one.id, value}), Change::none) << one.label << value;
  }
  EXPECT_EQ(panel.controls.set({9999, 1}), Change::none);
  for (std::size_t n = 0; n < before.size(); ++n) EXPECT_EQ(panel.controls.all()[n].value, before[n].value);
}

TEST(ViewControls, GiveEachHeadOfTheListItsShape) {
  Panel panel;
  std::set<std::string> shapes;  // shapes that the page draws
  for (double head = 0; head <= panel.control("tool/Head").max; ++head) {
    panel.turn("tool/Head", head);
    const view::Message drawn = view::encode(panel.tool());
    shapes.emplace(drawn.begin(), drawn.end());
  }
  // The scene's own and a round head are spheres, and a cylinder is flat.
  EXPECT_EQ(shapes.size(), 1 + head_shapes().size() - 3);
}

TEST(ViewControls, AreTakenBackWhenSizesDoNotFit) {
  Panel panel;
  panel.turn("tool/Diameter", 8);
  panel.turn("tool/Length", 4);
  // A round end needs a length of at least half the diameter.
  ASSERT_EQ(panel.set("tool/Head", head_named("round_end_tapered")), Change::tool);
  EXPECT_THROW((void)panel.controls.tool(), Error);
  panel.controls.revert();
  EXPECT_EQ(panel.control("tool/Head").value, 0);
  EXPECT_NO_THROW((void)panel.controls.tool());
}

TEST(ViewControls, KeepTheirValuesAfterAButtonFailed) {
  Panel panel;
  panel.turn("tool/Diameter", 2);
  ASSERT_EQ(panel.set("application/Reset", 1), Change::reset);
  panel.controls.revert();
  EXPECT_EQ(panel.control("tool/Diameter").value, 2);
}

TEST(ViewControls, ShowTheStateOfTheModel) {
  Panel panel;
  // The command is requested but not executed, as with a full queue.
  (void)panel.set("tool/Speed", 1000);
  (void)panel.set("application/Cutting", 0);
  (void)panel.set("additional/Gravity", 1);
  (void)panel.set("outputs/force x", 0);
  panel.controls.show(panel.watched.settings());
  EXPECT_NEAR(panel.control("tool/Speed").value * rpm, 3000, 1e-9);
  EXPECT_EQ(panel.control("application/Cutting").value, 1);
  EXPECT_EQ(panel.control("additional/Gravity").value, 0);
  EXPECT_EQ(panel.control("outputs/force x").value, 1);
  // The model executes a command that did not come from a control.
  panel.tell(commands::SetSpindleSpeed{0});
  panel.tell(commands::SetRemoval{RemovalLaw::none});
  panel.tell(commands::SetForceMask{AxisMask{{true, false, true}, {}}});
  panel.controls.show(panel.watched.settings());
  EXPECT_EQ(panel.control("application/Spindle").value, 0);
  EXPECT_NEAR(panel.control("tool/Speed").value * rpm, 3000, 1e-9);  // the value for the next start
  EXPECT_EQ(panel.control("application/Cutting").value, 0);
  EXPECT_EQ(panel.control("outputs/force y").value, 0);
  EXPECT_EQ(panel.control("outputs/force z").value, 1);
  EXPECT_EQ(panel.controls.removal(), RemovalLaw::none);
}

TEST(ViewControls, ShowTheStaticFrictionThatADynamicOneBringsAlong) {
  Panel panel;
  panel.turn("material/plain dynamic friction", 1.5);
  EXPECT_EQ(panel.material().static_friction, 1.5);
  EXPECT_EQ(panel.control("material/plain static friction").value, 1.5);
}

TEST(ViewControls, RefuseAStaticFrictionBelowTheDynamicOne) {
  Panel panel;
  panel.turn("material/plain dynamic friction", 0.5);
  test::expect_refused([&] { return panel.set("material/plain static friction", 0.4); },
                       "the static friction must be at least the dynamic friction, 0.5; lower the dynamic friction");
  EXPECT_EQ(panel.set("material/plain static friction", 0.6), Change::materials);
}

TEST(ViewControls, TellTheKnownRangeWithinTheirOwn) {
  const Tool tool(SphereHead{1 * mm}, RayHandle{100 * mm}, Spindle{3000 * units::rad_per_s});
  Material mine = presets::dentin();
  mine.name = "mine";
  const ViewControls controls(
      tool, MaterialTable({presets::enamel(), presets::dentin(CutterKind::coarse_diamond), mine}), {}, false);
  std::map<std::string, view::Control> at;
  for (const view::Control& one : controls.all()) at[one.label] = one;
  for (const auto& [label, one] : at)
    EXPECT_TRUE(one.source.empty() || (one.min <= one.low && one.high <= one.max)) << label;
  const PresetConstant &energy = *find_constant("carbide_bur", "specific_cutting_energy"),
                       &share = *find_constant("enamel", "share");
  const view::Control& enamel = at["enamel cutting energy"];
  EXPECT_NEAR(enamel.low, 1e-9 * energy.low * share.low, 1e-12);
  EXPECT_NEAR(enamel.typical, enamel.value, 1e-12);
  EXPECT_NEAR(enamel.high, 1e-9 * energy.high * share.high, 1e-12);
  test::expect_part(enamel.source, std::string(energy.source));
  test::expect_part(enamel.source, std::string(share.source));
  EXPECT_NEAR(at["dentin cutting energy"].high, 1e-9 * find_constant("coarse_diamond", "specific_cutting_energy")->high,
              1e-9);
  EXPECT_EQ(at["enamel static friction"].low, find_constant("solid", "static_friction")->low);
  EXPECT_EQ(at["mine cutting energy"].source, "") << "no preset";
  EXPECT_EQ(at["Diameter"].source, "");
}

TEST(ViewControls, TellWhatIsBesideTheStep) {
  const Tool tool(SphereHead{1 * mm}, RayHandle{100 * mm}, Spindle{3000 * units::rad_per_s});
  ViewControls controls(tool, MaterialTable({test::plain_material()}), {}, true, {true, 0, true});
  const auto turn = [&](const std::string& label, double value) {
    for (const view::Control& one : controls.all())
      if (one.label == label) (void)controls.set({one.id, value});
  };
  const auto idle = [&](const std::string& label) {
    return std::ranges::find(controls.all(), label, &view::Control::label)->idle;
  };
  EXPECT_TRUE(controls.beside().heat);
  EXPECT_TRUE(controls.beside().loose_pieces);
  EXPECT_EQ(controls.beside().irrigation, 0);
  EXPECT_EQ(idle("Irrigation"), "the water is off");
  turn("Water", 1);
  EXPECT_EQ(controls.beside().irrigation, 3000) << "a spray";
  EXPECT_EQ(idle("Irrigation"), "");
  controls.show_heat(false);
  EXPECT_FALSE(controls.beside().heat);
  EXPECT_EQ(idle("Water"), "the heat is off");
  EXPECT_EQ(idle("Remove loose pieces"), "");
  controls.show_recording(true);
  EXPECT_EQ(idle("Remove loose pieces"), "loose pieces stay in a recording");
}

// Proves: what acts when.
TEST(ViewControls, SayWhyTheyDoNothing) {
  Panel panel;
  const auto idle = [&](const std::string& name) { return panel.control(name).idle; };
  EXPECT_EQ(idle("material/plain stiffness"), "");
  EXPECT_EQ(idle("material/plain static friction"), "only while the spindle stands");
  EXPECT_EQ(idle("material/plain cutting energy"), "");
  panel.turn("application/Spindle", 0);
  EXPECT_EQ(idle("material/plain static friction"), "");
  EXPECT_EQ(idle("material/plain cutting energy"), "only while the spindle turns");
  EXPECT_EQ(idle("tool/Speed"), "the spindle is off");
  panel.turn("material/plain damping", 1);
  EXPECT_EQ(idle("material/plain damping"), "at 5 mm/s less than 1 % of the force");
  panel.turn("material/plain damping", 100);
  EXPECT_EQ(idle("material/plain damping"), "");
  EXPECT_EQ(idle("tool/Diameter"), "choose a head first");
  panel.turn("tool/Head", head_named("sphere"));
  EXPECT_EQ(idle("tool/Diameter"), "");
  EXPECT_EQ(idle("tool/Cone angle"), "this head has no angle");
  EXPECT_EQ(idle("vibration/Amplitude"), "vibration is off");
  panel.turn("vibration/Vibration", 1);
  EXPECT_EQ(idle("vibration/Amplitude"), "");
  panel.turn("material/plain damping", 10);
  EXPECT_EQ(idle("material/plain damping"), "");
  panel.turn("application/Spindle", 1);
  EXPECT_EQ(idle("material/plain damping"), "at 5 mm/s less than 1 % of the force") << "a cut hides it";
  panel.turn("material/plain damping", 100);
  EXPECT_EQ(idle("material/plain damping"), "");
  panel.turn("application/Haptics", 0);
  for (const char* name : {"additional/Gravity", "additional/Mass", "vibration/Amplitude", "outputs/force x"})
    EXPECT_EQ(idle(name), "haptics is off") << name;
  EXPECT_EQ(idle("additional/Volume"), "");
}

TEST(ViewControls, SayWhatTheLawOfTheThesisDoesNotUse) {
  const Tool tool(SphereHead{1 * mm}, RayHandle{100 * mm}, Spindle{3000 * units::rad_per_s});
  const ViewControls controls(tool, MaterialTable({test::plain_material()}), thesis_mode(), false);
  const std::map<std::string, std::string> expected = {{"plain stiffness", ""},
                                                       {"plain damping", "at 5 mm/s less than 1 % of the force"},
                                                       {"plain cutting energy", "not in the law of the thesis"},
                                                       {"plain cutting ratio", "not in the law of the thesis"},
                                                       {"plain static friction", "only while the spindle stands"},
                                                       {"Removal", "the law of the thesis removes by power"}};
  for (const view::Control& one : controls.all())
    if (expected.contains(one.label)) {
      EXPECT_EQ(one.idle, expected.at(one.label)) << one.label;
    }
}

TEST(ViewControls, LeaveWhatASceneHasBeyondTheirRange) {
  Material hard = test::plain_material();
  hard.damping = 5000;
  const Tool tool(SphereHead{1 * mm}, RayHandle{400 * mm}, Spindle{3000 * units::rad_per_s});
  ViewControls controls(tool, MaterialTable({hard}), {}, false);
  for (const view::Control& one : controls.all())
    (void)(one.label == "Power limit" && controls.set({one.id, 2}) == Change::tool);
  EXPECT_EQ(controls.materials()[MaterialId(1)].damping, 5000);
  EXPECT_EQ(std::get<RayHandle>(controls.tool().handle()).length, 400 * mm);
}

}  // namespace
}  // namespace hapticut::view_controls_test
