// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/device_runs.hpp"
#include "support/refusal.hpp"

/// @file
/// A device in the contract suite: it is opened, moved by a hand, run, and observed at its motors.
namespace hapticut::test {

/// Motion of the hand and faults of the device in one tick.
struct ScriptedTick {
  Pose X_BS = {};
  Twist velocity = {};
  std::uint32_t buttons = 0;
  bool not_a_number = false;  ///< its sensors give a NaN position
  bool unplugged = false;
};

using DeviceScript = std::function<ScriptedTick(long tick)>;

/// Properties of a kind of device, from which the contract chooses its tests.
struct DeviceTraits {
  bool follows = true;      ///< it reads the poses and velocities of the script
  bool is_live = true;      ///< ... in the same tick, so that they may depend on its force
  bool has_buttons = true;  ///< those of the script
  bool has_cable = true;    ///< it can be unplugged
  bool has_motors = true;   ///< it renders forces
  bool is_makers = false;   ///< it uses its maker's library: opened only once, in real time only
  bool own_thread = false;  ///< its driver's thread runs the loop
  const char* name = "";    ///< name for `open_device`; empty: not found by name
};

/// One device, with access to its hand and to its motors. Only one may exist at a time, because the process has only
/// one stand-in.
class DeviceUnderTest {
 public:
  DeviceUnderTest() { commanded.reserve(kLongest); }
  virtual ~DeviceUnderTest() = default;
  DeviceUnderTest(const DeviceUnderTest&) = delete;
  DeviceUnderTest& operator=(const DeviceUnderTest&) = delete;

  /// Opens the device, with a clock that the test drives. `script` must be set.
  virtual std::unique_ptr<Device> open() = 0;

  /// Opens it as an application does, for a run by the wall clock without a script.
  virtual std::unique_ptr<Device> open_for_wall_clock() { return open(); }

  /// Runs it as fast as the callback allows, with the script.  @throws what `Device::run` throws
  virtual RunReport run(Device& device, const DeviceCallback& callback, RunOptions options = quick()) {
    options.simulated_time = true;
    return device.run(callback, options);
  }

  /// Every wrench that the motors got since the device was first opened.
  [[nodiscard]] virtual long commands() const { return long(commanded.size()); }
  [[nodiscard]] virtual Wrench command(long n) const { return commanded[std::size_t(n)]; }

  /// The wrench that the motors hold now.
  [[nodiscard]] virtual Wrench held() const { return commands() > 0 ? command(commands() - 1) : Wrench{}; }

  /// Expects that a run has left the maker's library in order.
  virtual void expect_left_in_order() const {}

  DeviceScript script = [](long) { return ScriptedTick{}; };

 protected:
  static constexpr std::size_t kLongest = 100000;  // ticks before recording would allocate
  std::vector<Wrench> commanded;                   // those of devices whose motors are recorded here
};

/// A simulated device that records the commands to its motors.
template <class Simulated>
class Watched : public Simulated {
 public:
  template <class... Arguments>
  explicit Watched(std::vector<Wrench>& commanded, Arguments&&... arguments)
      : Simulated(std::forward<Arguments>(arguments)...), commanded_(commanded) {}

 protected:
  Wrench write(const Wrench& wrench) noexcept override {
    commanded_.push_back(Simulated::write(wrench));
    return commanded_.back();
  }

 private:
  std::vector<Wrench>& commanded_;
};

/// A kind of device in the list of the contract.
struct NamedDevice {
  std::string name;
  DeviceTraits traits;
  std::function<std::unique_ptr<DeviceUnderTest>()> make;
};

inline void PrintTo(const NamedDevice& named, std::ostream* out) { *out << named.name; }

template <class Kind, class... Arguments>
NamedDevice named_device(std::string name, Arguments... arguments) {
  return {std::move(name), Kind::kTraits, [=] { return std::make_unique<Kind>(arguments...); }};
}

/// Base of the contract's tests, with the device of the parameter.
class DeviceContractTest : public testing::TestWithParam<NamedDevice> {
 protected:
  [[nodiscard]] static const DeviceTraits& traits() { return GetParam().traits; }

  void TearDown() override { tested.expect_left_in_order(); }

  /// Runs for some ticks without force, and returns the last reading.
  DeviceState rest(Device& device, long ticks = 20) {
    DeviceState last;
    const RunReport report = tested.run(device, [&, n = 0L](const DeviceState& state) mutable {
      last = state;
      return DeviceCommand{{}, ++n >= ticks};
    });
    EXPECT_EQ(report.ticks, std::uint64_t(ticks));
    EXPECT_EQ(report.fault, DeviceFault::none);
    return last;
  }

  /// The message of an action that is refused.
  template <class Work>
  static std::string refusal(const Work& work) {
    const std::string said = test::refusal([&] { work(); });
    EXPECT_NE(said, "") << "nothing was refused";
    return said;
  }

  /// Expects that the motors got no force from the n-th command on.
  void expect_no_force_since(long n) const {
    for (; n < tested.commands(); ++n) {
      ASSERT_TRUE(tested.command(n).force.isZero(0)) << n << " of " << tested.commands();
      ASSERT_TRUE(tested.command(n).torque.isZero(0)) << n << " of " << tested.commands();
    }
    expect_no_force_now();
  }
  void expect_no_force_now() const { EXPECT_TRUE(tested.held().force.isZero(0) && tested.held().torque.isZero(0)); }

 private:
  std::unique_ptr<DeviceUnderTest> made_ = GetParam().make();

 protected:
  DeviceUnderTest& tested = *made_;
};

}  // namespace hapticut::test
