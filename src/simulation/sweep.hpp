// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/spatial.hpp"
#include "hapticut/simulation/config.hpp"
#include "simulation/contact_stages.hpp"

/// How a step is divided into sub-steps.
namespace hapticut {

/// An equal piece of the tool's motion during a step, seen where the contact is evaluated: at its middle or its end.
struct SubStep {
  double duration;     // [s]
  double end;          // [1] share of the step that is over
  double weight;       // [1] share of its force in the force of the step
  Pose X_WH;           // pose of the handle
  Pose X_WT;           // pose of the head
  Twist path_T;        // velocity of To along the path, in T
  HeadPlacement head;  // placement of the head, for the stages that see voxels

  [[nodiscard]] Vec3 p_HoTo_W() const noexcept { return X_WT.translation - X_WH.translation; }

  /// A wrench about To, in T, as one about Ho, in W.
  [[nodiscard]] Wrench at_handle(const Wrench& wrench_T) const noexcept {
    return transport(Wrench{X_WT.rotation * wrench_T.force, X_WT.rotation * wrench_T.torque}, p_HoTo_W());
  }
};

/// How a step is divided. Each sub-step but the first moves the head by half a voxel, and the first by the rest. A path
/// that is slightly longer and needs one more sub-step thus has nearly the same force, which an implicit coupling
/// needs. Each may be divided once more into equal slices, which follow a crushed layer.
struct Sweep {
  int sub_steps = 1;
  double rest = 0;  // [1] share of the step's duration, each sub-step but the first
  int slices = 1;   // equal pieces of each sub-step

  [[nodiscard]] int count() const noexcept { return sub_steps * slices; }
  /// [1] Duration, end, and weight of the force of a slice of a sub-step. At the end of sub-steps, the force of the
  /// last slice is that of the sub-step, as without slices.
  [[nodiscard]] double duration(int index) const noexcept { return whole(index / slices) / slices; }
  [[nodiscard]] double end(int index) const noexcept {
    const int later_sub_steps = sub_steps - 1 - index / slices, later_slices = slices - 1 - index % slices;
    return 1 - later_sub_steps * rest - later_slices * duration(index);
  }
  [[nodiscard]] double weight(int index, ContactTime time) const noexcept {
    if (time == ContactTime::middle) return duration(index);
    return index % slices == slices - 1 ? whole(index / slices) : 0.0;
  }

 private:
  [[nodiscard]] double whole(int sub_step) const noexcept { return sub_step > 0 ? rest : 1 - (sub_steps - 1) * rest; }
};

/// The motion of the handle in a step, with constant twist.
struct HandlePath {
  Pose from;    // X_WH at its beginning
  Twist twist;  // velocity of Ho along it, in W
  Twist felt;   // velocity of Ho as the device measures it, in W
  double dt;    // [s]
  Sweep sweep;
};

}  // namespace hapticut
