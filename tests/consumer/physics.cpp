// SPDX-License-Identifier: Apache-2.0
// An outside program with custom voxels, in one file without libraries: presses a sphere into its block, with and
// without rotation, and calls every non-trivial part of the headers of hapticut::physics.
#include <bitset>
#include <cmath>
#include <cstdio>
#include <hapticut/closed_forms.hpp>
#include <hapticut/physics.hpp>
#include <stdexcept>
#include <string>

namespace {

using namespace hapticut;
using namespace hapticut::units;

constexpr double kRadius = 1 * mm, kDepth = 0.5 * mm, kVoxel = 0.05 * mm;  // [m]
constexpr double kStiffness = 1e12;                                        // [N/m^4]
// Error of the voxels: their edge is a tenth of the depth, and the sums use the midpoint rule.
constexpr double kTolerance = 0.01;  // [1]

void require(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(what);
}

bool is_near(double value, double expected, double tolerance) {
  return std::abs(value - expected) <= tolerance * std::abs(expected);
}

Material bone() {
  Material material;
  material.name = "bone";
  material.static_friction = 0.4;
  return material;
}

/// A wall of blocks below z = 0, full of one material. The centre of voxel (i, j, k) is at (i + 1/2, j + 1/2, k + 1/2)
/// edges, so the surface of the wall is a face of voxels.
struct Wall {
  static constexpr int kBlocks = 3;  // on each side of the axis, and three downwards
  Pose X_WV = Pose::from_translation(Vec3::Constant(kVoxel / 2));

  template <class Visit>
  void for_each_block(Visit&& visit) const {
    for (int i = -kBlocks; i < kBlocks; ++i)
      for (int j = -kBlocks; j < kBlocks; ++j)
        for (int k = -kBlocks; k < 0; ++k) {
          BlockView block;
          block.origin = {i * kBlockEdge, j * kBlockEdge, k * kBlockEdge};
          block.uniform_material = 1;
          visit(block);
        }
  }
};

struct Contact {
  Resultant resultant;
  LawEnergies energies;
  double removed = 0;  // [voxels]
  int samples = 0;
};

Contact press(const ToolHead& head, const ForceLaw& law, const Pose& X_WT, double spin) {
  const Wall wall;
  const GridInHead grid(X_WT.inverse() * wall.X_WV, kVoxel);
  const ContactMaterials materials = contact_materials(MaterialTable({bone()}), kStiffness);
  HeadMotion motion = {};
  motion.velocity = motion.angular_velocity = Eigen::Vector3f::Zero();
  motion.felt_velocity = motion.felt_angular_velocity = Eigen::Vector3f::Zero();
  motion.spin = float(spin);
  motion.duration = 1e-3F;
  motion.voxel_size = float(kVoxel);
  motion.removal = RemovalLaw::constant_energy;
  motion.head_radius = float(head.max_radius());
  Contact contact;
  ContactBlock samples;
  wall.for_each_block([&](const BlockView& block) {
    const bool touched = head.visit_springs<float>([&](const auto& springs) {
      if (!may_touch(springs, grid, block.origin, float(kVoxel))) return false;
      sample_contact(springs, block, grid, Quadrature::sub_voxel, samples);
      return samples.samples > 0;
    });
    if (!touched) return;
    contact.energies += law.evaluate(motion, materials, samples).energies;
    sum_resultant(samples, contact.resultant);
    std::array<float, kBlockVoxels> fill;
    ByMaterial<double> removed = {};
    (void)find_changes(samples, block, fill.data(), removed);
    contact.removed += removed[1];
    contact.samples += samples.samples;
  });
  return contact;
}

/// C1: a ball that does not rotate is pressed into a half space.
double standing_force(const Tool& tool) {
  const Contact contact = press(tool.head(), FoundationLaw(), Pose::from_translation(Vec3(0, 0, kRadius - kDepth)), 0);
  const double force = contact.resultant.wrench_T.force.z();
  require(contact.samples > 500, "there are too few samples");
  require(is_near(force, closed_forms::cap_force(kStiffness, kRadius, kDepth), kTolerance), "C1 does not hold");
  require(contact.removed == 0, "a head that does not rotate removed voxels");
  require(is_near(contact.energies.elastic, closed_forms::cap_energy(kStiffness, kRadius, kDepth), kTolerance),
          "C3 does not hold");
  return force;
}

/// Cutting consumes the energy of the removed volume.
void require_cut_pays(const Tool& tool) {
  const Contact contact =
      press(tool.head(), FoundationLaw(), Pose::from_translation(Vec3(0, 0, kRadius - kDepth)), tool.spindle().speed);
  const double cost = bone().specific_cutting_energy * contact.removed * kVoxel * kVoxel * kVoxel;
  require(contact.removed > 0 && is_near(contact.energies.cutting, cost, 1e-4), "wrong cutting energy");
}

/// A contact that is dragged beyond the limit of its anchor slides with the dynamic friction.
void require_friction(double normal) {
  const DryFriction friction{bone().static_friction, bone().dynamic_friction, 1000};
  validate(friction);
  LimitSurface anchor;
  const SpreadFriction contact = SpreadFriction::at_point(Vec3(0, 0, normal), friction);
  Vec3 force = Vec3::Zero();
  for (int step = 0; step < 100; ++step)
    force = anchor.move(contact, {Vec3(0.01 * mm, 0, 0), Vec3::Zero()}, dry_friction_fraction(0, kRadius)).wrench.force;
  require(anchor.sliding() && is_near(-force.x(), friction.dynamic_friction * normal, 1e-9), "friction is not mu_d N");
}

/// Heads, handles, spindle and effects work with the headers alone.
void require_words(const Tool& tool) {
  for (const ToolHead& head : {ToolHead(SphereHead{kRadius}), ToolHead(ConeHead{30 * deg, 2 * mm}),
                               ToolHead(FlatHead{kRadius, 2 * mm, FlatRule::both})}) {
    require(head.volume() > 0 && head.reach() >= head.max_radius() && !head.profile().edges.empty() &&
                !head.description().empty() && head.spring_at(Vec3(0, 0, 0.1 * mm)).depth > 0,
            "a head lacks its volume, profile, description or springs");
  }
  require(is_near(tool.X_HT().translation.z(), -20 * mm, 1e-12), "the head is not at the end of its handle");
  require(thesis_handle_torque(LHandle{0.1, 0.02}, Vec3::UnitZ(), 1, 1).allFinite(), "no torque at the handle");
  require(is_near(max_contact_stiffness(tool.head()), closed_forms::max_cap_stiffness(1, kRadius), 0.01) &&
              stiffness_for_device(tool.head(), 1000) > 0 &&
              stiffness_for_accuracy(tool.head(), bone(), 4000 * units::rad_per_s, 1e-3) > 0,
          "C2 does not hold");
  SpindleMotor motor(tool.spindle());
  motor.advance(1e-3, 1e-3);
  require(motor.speed() > 0, "the spindle does not start");
  DeepContact deep;
  require(deep.move(Vec3::Zero(), -Vec3::UnitZ() * mm, 0.1, Vec3::UnitZ(), kRadius).force.isZero(),
          "a free ball was tethered");
  Gravity gravity;
  gravity.mass = 0.1;
  validate(gravity);
  validate(Vibration{}, 1000);
  validate(DeltaFilter{});
  const Wrench weight = masked(AxisMask{}, gravity_wrench(gravity, Mat3::Identity()));
  require(filtered(DeltaFilter{}, Vec3::Zero(), weight.force).norm() > 0, "there is no weight");
  VibrationPhase phase;
  require(phase.advance(Vibration{}, true, 1, 1e-3) != 0, "nothing vibrates");
  try {
    (void)ToolHead(SphereHead{-1});
    require(false, "a radius of -1 m was accepted");
  } catch (const Error& error) {
    require(std::string(error.what()).find("SphereHead::radius [m] = -1") != std::string::npos, error.what());
  }
}

/// The other laws compile and give a force.
void require_laws(const Tool& tool) {
  const HertzianBurrLaw burr(1e9);
  const ContactMechanicsLaw half_space(1e9);
  const DampingMatrixLaw damping({});
  const TwistDrillLaw drill({});
  const ThesisLaw thesis({});
  for (const ForceLaw* law : {static_cast<const ForceLaw*>(&burr), static_cast<const ForceLaw*>(&half_space),
                              static_cast<const ForceLaw*>(&damping), static_cast<const ForceLaw*>(&thesis)})
    law->require_head(tool.head());
  drill.require_head(ToolHead(ConeHead{59 * deg, 2 * mm}));
  const Contact contact = press(tool.head(), thesis, Pose::from_translation(Vec3(0, 0, kRadius - kDepth)), 0);
  require(contact.resultant.wrench_T.force.z() > 0, "the law of the thesis gives no force");
}

}  // namespace

int main() try {
  const Tool tool(SphereHead{kRadius}, RayHandle{20 * mm}, Spindle{40000 * rpm});
  const double force = standing_force(tool);
  require_cut_pays(tool);
  require_friction(force);
  require_words(tool);
  require_laws(tool);
  std::printf("%.4f N, C1: %.4f N\n", force, closed_forms::cap_force(kStiffness, kRadius, kDepth));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
