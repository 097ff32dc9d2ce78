// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

#include "force_dimension/tests/force_dimension.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/device/simulated/mouse.hpp"
#include "hapticut/device/simulated/playback.hpp"
#include "open_haptics/tests/open_haptics.hpp"
#include "support/device_under_test.hpp"
#include "support/written_device.hpp"

/// The devices of the contract suite, with one factory each, and their list at the end. Your own device joins the
/// contract with a factory like these and a line in the list.
namespace hapticut::test {

/// A scripted tick as a reading.
inline void read_scripted_tick(const ScriptedTick& now, DeviceState& state) {
  state.X_BS = now.X_BS;
  state.velocity = now.velocity;
  state.buttons = now.buttons;
  if (now.not_a_number) state.X_BS.translation.x() = std::numeric_limits<double>::quiet_NaN();
  state.valid = !now.unplugged;
  state.fault = now.unplugged ? DeviceFault::disconnected : DeviceFault::none;
}

/// A mock that follows its script at any force.
struct RigidMock : DeviceUnderTest {
  static constexpr DeviceTraits kTraits{.has_buttons = false, .has_cable = false};
  explicit RigidMock(const char* model = "touch") { options.device = device_model(model); }

  std::unique_ptr<Device> open() override {
    options.path = [this](double time) {
      DeviceState state;
      read_scripted_tick(script(std::lround(time / GuardOptions{}.period)), state);
      return state.X_BS;
    };
    return std::make_unique<Watched<MockDevice>>(commanded, options);
  }

  MockOptions options;
};

/// A mock that is opened by name, and moved by hand and force.
struct HeldMock : DeviceUnderTest {
  static constexpr DeviceTraits kTraits{.follows = false,
                                        .has_buttons = false,
                                        .has_cable = false,
                                        .name = "mock:spiral,device=premium6dof,hand=nominal"};

  std::unique_ptr<Device> open() override {
    MockOptions options;
    options.path = scripted_path("spiral");
    options.device = device_model("premium6dof");
    options.hand = hand_model("nominal");
    options.rigid = false;
    return std::make_unique<Watched<MockDevice>>(commanded, options);
  }
};

/// A mouse whose pointer is moved a little in every tick.
struct Mouse : DeviceUnderTest {
  static constexpr DeviceTraits kTraits{.follows = false, .has_cable = false, .name = "mouse"};
  struct Moved : Watched<MouseDevice> {
    Moved(std::vector<Wrench>& commands, Mouse& hand) : Watched(commands), hand_(hand) {}
    void begin_run(const RunOptions& options) override {
      tick_ = 0;
      Watched::begin_run(options);
    }
    bool read(DeviceState& state) noexcept override {
      pointer_moved(tick_ % 1000 < 500 ? 1 : -1, 0.5);
      const std::uint32_t buttons = hand_.script(tick_++).buttons;
      for (int n = 0; n < 32; ++n) button(n, ((buttons >> unsigned(n)) & 1U) != 0);
      return Watched::read(state);
    }
    Mouse& hand_;
    long tick_ = 0;
  };

  std::unique_ptr<Device> open() override { return std::make_unique<Moved>(commanded, *this); }
};

/// A playback of the script, computed in advance.
struct Playback : DeviceUnderTest {
  static constexpr DeviceTraits kTraits{.is_live = false};
  static constexpr long kReadings = 10000;

  std::unique_ptr<Device> open() override {
    std::vector<DeviceState> readings(kReadings);
    for (long n = 0; n < kReadings; ++n) {
      DeviceState& state = readings[std::size_t(n)];
      read_scripted_tick(script(n), state);
      state.time = 1e-3 * double(n);
      state.sequence = std::uint64_t(n) + 1;
    }
    return std::make_unique<Watched<PlaybackDevice>>(commanded, std::move(readings), capabilities_of_it());
  }
  [[nodiscard]] virtual DeviceCapabilities capabilities_of_it() const { return capabilities(device_model("touch")); }
};

/// A playback of a recording without motors: the poses of a tool.
struct PlaybackOfPoses : Playback {
  static constexpr DeviceTraits kTraits{.is_live = false, .has_motors = false};
  [[nodiscard]] DeviceCapabilities capabilities_of_it() const override {
    DeviceCapabilities none;
    none.model = none.vendor = "none";
    return none;
  }
};

/// A custom device, in three functions.
struct OwnDevice : DeviceUnderTest {
  static constexpr DeviceTraits kTraits{.name = "written"};
  OwnDevice() {
    register_device_driver(
        {"written", "written", "", [](const std::string&) { return std::make_unique<WrittenDevice>(); }});
  }

  std::unique_ptr<Device> open() override {
    auto device = std::make_unique<WrittenDevice>();
    device->forces.reserve(kLongest);
    device->next = [this](DeviceState& state) {
      state.time -= 1e-3;  // time starts at zero
      read_scripted_tick(script(long(state.sequence) - 1), state);
      return true;
    };
    device->on_write = [this](const Vec3& force) { commanded.push_back({force, Vec3::Zero()}); };
    return device;
  }
};

/// A device of 3D Systems with the stand-in of OpenHaptics.
struct OpenHapticsStandIn : DeviceUnderTest {
  static constexpr DeviceTraits kTraits{.is_makers = true, .own_thread = true, .name = "openhaptics"};
  explicit OpenHapticsStandIn(hdsim_device (*kind)(const char*)) {
    hdsim_reset();
    const hdsim_device device = kind("Default Device");
    hdsim_add_device(&device);
    use_open_haptics();
  }
  ~OpenHapticsStandIn() override { hdsim_reset(); }

  std::unique_ptr<Device> open() override { return open_open_haptics(test::options_for()); }
  std::unique_ptr<Device> open_for_wall_clock() override {
    hdsim_use_thread(1);
    OpenHapticsOptions options;
    options.start_timeout = options.silence = 60;
    return open_open_haptics(options);
  }
  RunReport run(Device& device, const DeviceCallback& callback, RunOptions options) override {
    const OpenHapticsOutcome outcome = run_in_ticks(device, callback, options, [this](long tick) {
      const ScriptedTick now = script(tick);
      place(0, now.X_BS, now.velocity.linear);
      hdsim_set_buttons(0, int(now.buttons));
      hdsim_set_nan(0, now.not_a_number ? 1 : 0);
      hdsim_unplug(0, now.unplugged ? 1 : 0);
    });
    if (outcome.exception) std::rethrow_exception(outcome.exception);
    return outcome.report;
  }
  [[nodiscard]] long commands() const override { return hdsim_committed_count(0); }
  [[nodiscard]] Wrench command(long n) const override {
    Wrench w = committed(0, n);
    w.torque /= 1000;  // mN·m to N·m
    return w;
  }
  void expect_left_in_order() const override {
    const hdsim_counters c = hdsim_get_counters(0);
    EXPECT_NE(c.zero_force_before_stop, 0);
    EXPECT_NE(c.zero_force_before_disable, 0);
    EXPECT_EQ(c.force_output_enabled, 0);
    EXPECT_EQ(hdsim_is_running(), 0);
    EXPECT_EQ(hdsim_scheduled_callbacks(), 0);
    EXPECT_LE(c.callbacks_at_disable, 0);
    EXPECT_EQ(c.open_frames + c.ticks_without_frame + c.illegal_begins + c.illegal_ends, 0);
    EXPECT_EQ(c.sets_outside_frame + c.gets_outside_frame + c.torque_sets_on_3dof, 0);
  }
};

/// A device of Force Dimension with the stand-in of its library.
struct ForceDimensionStandIn : DeviceUnderTest, private ForceDimensionRuns {
  static constexpr DeviceTraits kTraits{.is_makers = true, .name = "forcedimension"};
  explicit ForceDimensionStandIn(int type) {
    dhdsim_reset();
    const dhdsim_device device = dhdsim_device_of(type, 1234);
    has_brakes_ = device.has_brakes != 0;
    dhdsim_add_device(&device);
    use_force_dimension();
  }
  ~ForceDimensionStandIn() override { dhdsim_reset(); }

  std::unique_ptr<Device> open() override { return open_force_dimension(options_for()); }
  std::unique_ptr<Device> open_for_wall_clock() override {
    dhdsim_use_real_time(1);
    return open_force_dimension();
  }
  RunReport run(Device& device, const DeviceCallback& callback, RunOptions options) override {
    return ForceDimensionRuns::run(device, callback, options, [this](long tick) {
      const ScriptedTick now = script(tick);
      place_omega(0, now.X_BS, now.velocity);
      dhdsim_set_buttons(0, now.buttons);
      dhdsim_set_nan(0, now.not_a_number ? 1 : 0);
      unplugged_ = unplugged_ || now.unplugged;
      if (now.unplugged) dhdsim_unplug(0);
    });
  }
  [[nodiscard]] long commands() const override { return dhdsim_committed_count(0); }
  [[nodiscard]] Wrench command(long n) const override { return rendered_wrench(0, n); }
  [[nodiscard]] Wrench held() const override { return rendered_wrench(0); }
  void expect_left_in_order() const override {
    const dhdsim_counters c = dhdsim_get_counters(0);
    EXPECT_EQ(c.expert_mode + c.expert_mode_violations + c.calls_after_close, 0);
    EXPECT_EQ(c.torques_on_passive_wrist + c.gripper_forces, 0);
    EXPECT_NE(c.off_before_close, 0);
    EXPECT_EQ(c.force_on, 0);
    if (c.enables > 0 && has_brakes_ && !unplugged_) expect_safe(0);
  }

 private:
  bool has_brakes_ = true, unplugged_ = false;
};

/// All devices.
inline std::vector<NamedDevice> devices_under_test() {
  return {named_device<RigidMock>("Mock"),
          named_device<RigidMock>("MockOfSixDegrees", "premium6dof"),
          named_device<HeldMock>("MockInAHand"),
          named_device<Mouse>("Mouse"),
          named_device<Playback>("Playback"),
          named_device<PlaybackOfPoses>("PlaybackOfPoses"),
          named_device<OwnDevice>("OwnDevice"),
          named_device<OpenHapticsStandIn>("Touch", hdsim_touch),
          named_device<OpenHapticsStandIn>("Premium", hdsim_premium6dof),
          named_device<ForceDimensionStandIn>("Omega", kOmega6),
          named_device<ForceDimensionStandIn>("Sigma", kSigma7),
          named_device<ForceDimensionStandIn>("Falcon", kFalcon)};
}

/// The devices that have all of these properties, or, with `wanted` false, the devices that have none of these
/// properties.
inline std::vector<NamedDevice> devices_that(const std::vector<bool DeviceTraits::*>& have, bool wanted = true) {
  std::vector<NamedDevice> all = devices_under_test();
  for (const auto has : have) std::erase_if(all, [&](const NamedDevice& named) { return named.traits.*has != wanted; });
  return all;
}

inline constexpr auto kNameOfDevice = [](const auto& named) { return named.param.name; };

}  // namespace hapticut::test
