// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>
#include <utility>

#include "page/session/view_session.hpp"
#include "system/cli/small_scene.hpp"
#include "unit/view/view_client.hpp"

/// @file
/// A session of `hapticut view` without a browser.
namespace hapticut::test {

/// A session with running frames, and a page that sends commands.
struct Desk {
  explicit Desk(apps::ViewScene scene = small_scene("block")) : session{std::move(scene), server, nullptr} {
    session.begin(true);
  }
  /// Waits until the model has executed the commands and the force is on (without it the spindle stands), plus one
  /// tick.
  void frames() {
    const auto is_on = [&] { return session.device().is_running() && session.device().arming() == ArmingState::on; };
    ASSERT_TRUE(view_test::soon([&] { return session.frame(0.016), session.is_settled() && is_on(); }));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  void turn(const std::string& label, double value) {
    const apps::ViewControls controls(small_scene("").tool, small_scene("").workpiece.materials(), {}, true);
    for (const view::Control& control : controls.all())
      if (control.label == label) return session.apply(view::SetControl{control.id, value});
    ADD_FAILURE() << "there is no control " << label;
  }
  /// Moves the tip of the head to a point, and runs frames until the hand is there.
  void lead(const Vec3& tip, bool pressed) {
    const Pose X_WT = Pose::from_translation(tip - Vec3(0, 0, session.tool().head().bounding_box().min.z()));
    session.apply(view::LookAt{});
    session.apply(view::MoveHand{X_WT * session.tool().X_HT().inverse(), pressed});
    ASSERT_TRUE(view_test::soon([&] {
      session.frame(0.016);
      return (session.latest().device.X_BS.translation - X_WT.translation).norm() < 1e-6;
    }));
    frames();
  }
  /// Ends the run, so the model can be inspected.
  const Simulation& model() {
    frames();
    session.apply(view::WriterLeft{});
    return session.simulation();
  }
  view::ViewServer server{{}};
  apps::ViewSession session;
};

}  // namespace hapticut::test
