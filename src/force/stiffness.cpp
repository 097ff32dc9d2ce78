// SPDX-License-Identifier: Apache-2.0
#include "hapticut/force/stiffness.hpp"

#include <algorithm>
#include <cmath>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {
namespace {

constexpr int kSections = 200;  // planes through the head, in each direction
constexpr int kSection = 200;   // points across one of them

// A flat solid that advances by dd into the head adds a slice of thickness dd to what is immersed, so with N the normal
// of its face, `dF/dd = k_v Int w |n . N| dA` over the section of the head by that face.

/// The integral over the section normal to the axis at height z.  [m^3]
double axial_section(const ToolHead& head, double z, double radius) {
  double sum = 0;
  const double step = radius / kSection;
  for (int i = 0; i < kSection; ++i) {
    const double rho = (i + 0.5) * step;
    const auto [depth, direction] = head.spring_at({rho, 0, z});
    if (depth > 0) sum += depth * std::abs(direction.z()) * 2 * units::kPi * rho * step;
  }
  return sum;
}

/// The integral over the section parallel to the axis, at distance c from it.  [m^3]
double lateral_section(const ToolHead& head, double c, const HeadBox& box) {
  double sum = 0;
  const double dy = (box.max.y() - box.min.y()) / kSection;
  const double dz = (box.max.z() - box.min.z()) / kSection;
  for (int i = 0; i < kSection; ++i)
    for (int k = 0; k < kSection; ++k) {
      const auto [depth, direction] = head.spring_at({c, box.min.y() + (i + 0.5) * dy, box.min.z() + (k + 0.5) * dz});
      if (depth > 0) sum += depth * std::abs(direction.x());
    }
  return sum * dy * dz;
}

}  // namespace

double stiffness_for_accuracy(const ToolHead& head, const Material& material, double spindle_speed, double feed_speed) {
  require_positive(std::abs(spindle_speed), "spindle speed [rad/s]");
  require_positive(feed_speed, "feed speed [m/s]");
  require_positive(material.cutting_ratio, "Material::cutting_ratio [1]");
  const double radius = head.largest_radius();
  return 200 * material.specific_cutting_energy * feed_speed /
         (material.cutting_ratio * std::abs(spindle_speed) * radius * radius * radius);
}

double largest_contact_stiffness(const ToolHead& head) {
  const HeadBox box = head.bounding_box();
  double largest = 0;
  for (int i = 0; i < kSections; ++i) {
    const double share = (i + 0.5) / kSections;
    const double z = box.min.z() + share * (box.max.z() - box.min.z());
    largest = std::max(largest, axial_section(head, z, box.max.x()));
    largest = std::max(largest, lateral_section(head, share * box.max.x(), box));
  }
  return largest;
}

double stiffness_for_device(const ToolHead& head, double device_stiffness) {
  require_positive(device_stiffness, "device stiffness [N/m]");
  return device_stiffness / largest_contact_stiffness(head);
}

}  // namespace hapticut
