// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "hapticut/simulation/step.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/tool/tool.hpp"
#include "hapticut/workpiece/material.hpp"

/// @file
/// What a hand meets: each cutter in each material, pushed with a constant force, behind the default coupling and with
/// the motor of a usual handpiece.
namespace hapticut::experiments {

/// A usual tool of a kind of cutter: a ball of 1 mm radius, and a twist drill of 2 mm. Dental burs turn at 300000 rpm
/// on a turbine, otological ones at 80000 rpm, drills at 1500 rpm.
/// @param radius  [m]
/// @param speed   [rad/s]; 0: the usual one
/// @param motor   of the spindle; none: the usual one
[[nodiscard]] Tool usual_tool(CutterKind kind, double radius = 1e-3, AngularSpeed speed = {},
                              std::optional<MotorKind> motor = {});

/// A tool pushed along its axis, engaged over its whole section.
struct PushedCut {
  double rate = 0;                     ///< [m^3/s] volume removed
  double speed = 0;                    ///< [m/s] of the tool
  double force = 0;                    ///< [N] mean on the hand
  double power = 0;                    ///< [W] that the cut takes: specific energy times rate
  double time = 0;                     ///< [s] that counts
  double load_to_cut = 0;              ///< [N] Contact::load_to_cut
  StepStatus status = StepStatus::ok;  ///< bits of that time
};

/// @param load     [N] that the hand keeps
/// @param longest  [s] after which it ends, also if the tool has moved too little to be in a steady state
[[nodiscard]] PushedCut push(const Tool& tool, const Material& material, double load, double longest = 0.6);

/// The rates of all pairs under some loads, in Markdown.
[[nodiscard]] std::string pairs_report();

}  // namespace hapticut::experiments
