// SPDX-License-Identifier: Apache-2.0
// Symmetries of the step with any head, and its energy balance for anything that a hand may do.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/cut_scene.hpp"

namespace hapticut {
namespace {

using namespace test;
using units::mm;

// Positions in single precision differ in their last bits from one frame to another, and a voxel then counts one step
// earlier or later: where the spring does not vanish at the rim, or where cutting starts, that is one of hundreds.
constexpr double kOneVoxel = 5e-3;

CutScene arbitrary_scene() {
  const ToolHead head = *arbitrary_head();
  RC_PRE(head.bounding_box().max.x() > 0.3 * mm);
  return arbitrary_cut_scene(head);
}

RC_GTEST_PROP(Step, ARotatedSceneGivesTheRotatedWrench, ()) {
  CutScene scene = arbitrary_scene();
  const CutOutcome straight = run(scene, 10);
  scene.frame.X_WV = {*arbitrary_rotation(), *arbitrary_vector(5 * mm)};
  RC_ASSERT(difference(straight, run(scene, 10)) < kOneVoxel);
}

RC_GTEST_PROP(Step, AMirroredSceneGivesTheMirroredWrench, ()) {
  CutScene scene = arbitrary_scene();
  const CutOutcome straight = run(scene, 10);
  scene.mirrored = true;
  RC_ASSERT(difference(straight, mirrored_back(run(scene, 10))) < kOneVoxel);
}

RC_GTEST_PROP(Step, TheGridsOriginDoesNotMatter, ()) {
  CutScene scene = arbitrary_scene();
  const CutOutcome before = run(scene, 10);
  for (int& i : scene.shift) i = *rc::gen::inRange(-1000, 1000);
  RC_ASSERT(difference(before, run(scene, 10)) < kOneVoxel);
}

// Anything that a hand may do, with anything that a material may be: the ledger closes and nothing is gained.
RC_GTEST_PROP(Step, TheLedgerClosesAndNoLossIsNegativeInAnyCut, ()) {
  CutScene scene = arbitrary_conservative_scene();
  make_arbitrary(scene.soft);
  make_arbitrary(scene.hard);
  const CutOutcome outcome = run(scene);
  const EnergyLedger& e = outcome.energy;
  const double work = std::abs(e.hand_work) + std::abs(e.motor_work);
  RC_PRE(work > 0);
  RC_CLASSIFY(outcome.removed_volume > 0, "cuts");
  RC_LOG() << "closure " << e.closure() << " hand " << e.hand_work << " motor " << e.motor_work << " elastic "
           << e.elastic << " cutting " << e.cutting << " released " << e.released << " damping " << e.damping
           << " rubbing " << e.rubbing << " credited " << e.credited << " kind " << scene.head.shape().index() << " R "
           << scene.head.largest_radius();
  // A touch too light to fill the first voxel is booked to a few hundredths of that voxel's k_v l^5.
  RC_ASSERT(std::abs(e.imbalance()) < 0.005 * work + 3e-2 * 1e13 * std::pow(kSceneVoxel, 5));
  for (const double term : {e.elastic, e.cutting, e.released, e.damping, e.rubbing, e.credited})
    RC_ASSERT(term >= -1e-6 * work);
  RC_ASSERT(outcome.removed_volume >= 0);
}

}  // namespace
}  // namespace hapticut
