// SPDX-License-Identifier: Apache-2.0
// Descriptions of structs and enumerations are complete: these tests find a member without a line and a value without a
// name.
#include "hapticut/core/description.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <variant>

#include "hapticut/analysis/faults.hpp"
#include "hapticut/build/molar.hpp"
#include "hapticut/build/volume_builders.hpp"
#include "hapticut/device/force_dimension.hpp"
#include "hapticut/device/open_haptics.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/device/simulated/mouse.hpp"
#include "hapticut/force/laws/contact_mechanics.hpp"
#include "hapticut/force/laws/damping_matrix.hpp"
#include "hapticut/force/laws/hertzian_burr.hpp"
#include "hapticut/force/laws/thesis.hpp"
#include "hapticut/force/laws/twist_drill.hpp"
#include "hapticut/import/volume/volume_filters.hpp"
#include "hapticut/import/volume/volumes.hpp"
#include "hapticut/io/vdb/vdb.hpp"
#include "hapticut/loop/device_tick.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "hapticut/loop/snapshot.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "support/refusal.hpp"

namespace hapticut::description_test {

/// Converts to the type of any member.
struct Anything {
  template <class T>
  operator T() const;  // NOLINT(google-explicit-constructor): intended
};

namespace {

// --- how many members a struct has ----------------------------------------------------------------------------------

template <class S, std::size_t... kIndices>
constexpr bool accepts(std::index_sequence<kIndices...>) {
  return requires { S{((void)kIndices, Anything{})...}; };
}

/// The number of members of a plain struct: the largest number of initialisers in braces.
template <class S, std::size_t kCount = 40>
constexpr std::size_t members_of() {
  if constexpr (kCount == 0 || accepts<S>(std::make_index_sequence<kCount>()))
    return kCount;
  else
    return members_of<S, kCount - 1>();
}

struct Ball {
  double radius = 1;
  std::string name;
};
static_assert(members_of<Ball>() == 2);

template <class S>
struct DescribedStruct : testing::Test {};

template <class... Structs, class... More>
auto together(testing::Types<Structs...>, std::tuple<More...>) -> testing::Types<Structs..., More...>;

/// Those of its alternatives that have a list of fields.
template <class... Structs>
auto described(std::variant<Structs...>) -> decltype(std::tuple_cat(
    std::declval<std::conditional_t<Described<Structs>, std::tuple<Structs>, std::tuple<>>>()...));

using OfVariants =
    decltype(std::tuple_cat(described(std::declval<ToolHead::Shape>()), described(std::declval<LoopCommand>())));
using Structs = decltype(together(
    testing::Types<Material, RayHandle, LHandle, Spindle, DryFriction, Gravity, Vibration, DeltaFilter, AxisMask,
                   OutputLimits, Effects, StepInput, Contact, SpindleState, EnergyLedger, StepResult, ContactProbe,
                   StageTimes, SimulationConfig, DeviceCapabilities, DeviceState, DeviceOutput, DeviceTick, TickEffort,
                   ToolSnapshot, LoopSnapshot, PoseGateOptions, ArmingOptions, PassivityOptions, ThermalOptions,
                   WatchdogOptions, GuardOptions, RealtimeOptions, RunOptions, RealtimeLoopOptions,
                   SimulationModelOptions, WorkspaceMapOptions, CouplingGains, CouplingEnergy, DeviceModel, HandModel,
                   PlantOptions, MockOptions, MouseOptions, OpenHapticsOptions, ForceDimensionOptions, MolarParameters,
                   StabilitySearch, BounceTest, PressTest, ThesisLaw::Constants, ContactMechanicsLaw::Constants,
                   HertzianBurrLaw::Constants, DampingMatrixLaw::Constants, TwistDrillLaw::Constants>{},
    std::declval<OfVariants>()));
TYPED_TEST_SUITE(DescribedStruct, Structs);

TYPED_TEST(DescribedStruct, HasALineForEachOfItsMembers) {
  EXPECT_EQ(kFieldsOf<TypeParam>, members_of<TypeParam>()) << "a member without a line in fields_of, or the reverse";
}

TYPED_TEST(DescribedStruct, ListsEachMemberOnceInOrder) {
  const TypeParam object{};
  const char* last = nullptr;
  std::set<std::string> names;
  for_each_field<TypeParam>([&](const auto& field) {
    const char* at = reinterpret_cast<const char*>(&(object.*field.member));
    EXPECT_TRUE(last == nullptr || at > last) << field.name << " is out of order, or has the wrong member";
    last = at;
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    EXPECT_GT(std::string(field.text).size(), 1U) << field.name;
    using T = typename std::remove_cvref_t<decltype(field)>::Type;
    const bool is_number = kIsNumber<T> || std::is_same_v<T, Vec3> || std::is_same_v<T, std::optional<double>>;
    EXPECT_EQ(is_number, *field.unit != '\0') << field.name << ": numbers and only numbers have a unit";
  });
}

TEST(EnergyLedger, CountsEachTermOnceInItsRole) {
  for_each_field<EnergyLedger>([&](const auto& field) {
    const std::string name = field.name;
    EnergyLedger one;
    one.*field.member = 1;
    const bool is_judged = name != "entered" && name != "turnover", is_spent = one.stored() + one.losses() != 0;
    EXPECT_EQ(one.stored() + one.losses(), is_spent ? 1 : 0) << name << " is both stored and lost";
    EXPECT_EQ(one.imbalance(), is_judged ? (is_spent ? -1 : 1) : 0) << name;
    EXPECT_EQ(is_spent, is_judged && !name.ends_with("work") && name != "credited") << name;
  });
  EXPECT_EQ(EnergyLedger{}.imbalance(), 0);
}

// --- which values an enumeration has --------------------------------------------------------------------------------

/// The compiler's text for a value: its name, if it has one.
template <auto kValue>
std::string name_by_compiler() {
  const std::string all = __PRETTY_FUNCTION__;
  const std::size_t begin = all.find("kValue = ") + 9;
  const std::string value = all.substr(begin, all.find_first_of(";]", begin) - begin);
  return value.find('(') != std::string::npos ? "" : value.substr(value.rfind(':') + 1);
}

template <class E, bool kBits, std::size_t... kIndices>
std::set<std::string> values_of(std::index_sequence<kIndices...>) {
  using Number = std::underlying_type_t<E>;
  std::set<std::string> names = {name_by_compiler<E(kBits ? Number(Number(1) << kIndices) : Number(kIndices))>()...};
  if (kBits) names.insert(name_by_compiler<E{}>());
  names.erase("");
  return names;
}

template <class E>
struct NamedEnumeration : testing::Test {};

using Enumerations =
    testing::Types<RemovalLaw, Quadrature, FlatRule, EdgeKind, HandleTorque, ContactTime, ProbedMotions, StepStatus,
                   DeviceFault, OutputChange, ArmingState, SafetyEvent, MoveKey, UnclaimedLabels, ValueType,
                   LabelInterpolation, VdbImport::Kind, InjectedFault>;
TYPED_TEST_SUITE(NamedEnumeration, Enumerations);

TYPED_TEST(NamedEnumeration, NamesEachOfItsValuesAsCppDoes) {
  constexpr bool kBits = std::is_same_v<TypeParam, StepStatus> || std::is_same_v<TypeParam, OutputChange>;
  std::set<std::string> expected = values_of<TypeParam, kBits>(std::make_index_sequence < kBits ? 32 : 64 > ());
  expected.erase("count");  // the number of values
  std::set<std::string> found;
  for (const auto& one : names_of(Of<TypeParam>{})) {
    found.insert(one.name);
    EXPECT_EQ(value_named<TypeParam>(one.name), one.value);
    EXPECT_STREQ(name_or_null(one.value), one.name);
  }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(name_or_null(TypeParam(77)), nullptr);
  EXPECT_FALSE(value_named<TypeParam>("no such name"));
}

// --- ranges and units -----------------------------------------------------------------------------------------------

std::string refusal(double value, const Range& range) {
  return test::refusal([&] { require_within(value, range, "x [m]"); });
}

TEST(RangeOfAField, IncludesItsEndsAsDescribed) {
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(1e-300, Range::positive()), "");
  EXPECT_EQ(refusal(0, Range::positive()), "x [m] = 0; must be a finite number > 0.");
  EXPECT_EQ(refusal(0, Range::not_negative()), "");
  EXPECT_EQ(refusal(-1, Range::not_negative()), "x [m] = -1; must be a finite number >= 0.");
  EXPECT_EQ(refusal(2, Range::between(-1, 2)), "");
  EXPECT_EQ(refusal(2.5, Range::between(-1, 2)), "x [m] = 2.5; must be between -1 and 2.");
  EXPECT_EQ(refusal(infinity, Range::limit()), "");
  EXPECT_EQ(refusal(0, Range::limit()), "x [m] = 0; must be > 0. Leave it at infinity for no limit.");
  EXPECT_EQ(refusal(0, {0, 20, true}), "x [m] = 0; must be > 0 and <= 20.");
  for (const Range& range : {Range::any(), Range::positive(), Range::not_negative(), Range::between(0, 1)}) {
    EXPECT_NE(refusal(infinity, range), "");
    EXPECT_NE(refusal(nan, range), "");
  }
  EXPECT_NE(refusal(nan, Range::limit()), "");
  EXPECT_EQ(range_of(&Spindle::droop).low, 0);
  EXPECT_TRUE(range_of(&Spindle::power_limit).allows_infinity);
}

TEST(RangeOfAField, ReadsAsASentence) {
  EXPECT_EQ(Range::positive().text(), "a number > 0");
  EXPECT_EQ(Range::between(0, 1e6).text(), "a number from 0 to 1e+06");
  EXPECT_EQ((Range{0, 20, true}).text(), "a number > 0 and <= 20");
  EXPECT_EQ((Range{0, 20, true}).short_text(), "> 0, <= 20");
  EXPECT_EQ(Range::any().text(), "a number");
  EXPECT_EQ(Range::not_negative().short_text(), ">= 0");
  EXPECT_EQ(Range::between(0, 1e6).short_text(), "0 ... 1e+06");
  EXPECT_EQ(Range::any().short_text(), "");
}

TEST(UnitInNames, IsAWord) {
  EXPECT_EQ(unit_in_names("1"), "");
  EXPECT_EQ(unit_in_names("N/m^4"), "N_per_m4");
  EXPECT_EQ(unit_in_names("N m"), "Nm");
  EXPECT_EQ(unit_in_names("rad/(s N m)"), "rad_per_sNm");
}

}  // namespace
}  // namespace hapticut::description_test
