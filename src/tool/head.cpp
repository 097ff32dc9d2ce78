// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/head.hpp"

#include <string>
#include <type_traits>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {
namespace {

using units::kPi;

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;  // clang 14 does not deduce aggregates by itself

double base_radius(const ConeHead& cone) { return cone.height * std::tan(cone.half_angle); }

void validate(const SphereHead& head) { require_fields_within(head, "SphereHead::"); }

void validate(const ConeHead& head) {
  require_fields_within(head, "ConeHead::");
  if (!(head.half_angle < kPi / 2))
    throw Error("ConeHead::half_angle = " + format_number(head.half_angle) +
                " rad; must be less than pi/2. Give half of the opening angle, in radians.");
}

void validate(const FlatHead& head) { require_fields_within(head, "FlatHead::"); }

void validate(const ProfileHead& /*checked when it was made*/) {}

}  // namespace

ToolHead::ToolHead(Shape shape) : shape_(std::move(shape)) {
  std::visit([](const auto& head) { validate(head); }, shape_);
}

HeadBox ToolHead::bounding_box() const {
  const auto around_axis = [](double radius, double low, double high) {
    return HeadBox{Vec3(-radius, -radius, low), Vec3(radius, radius, high)};
  };
  return std::visit(
      Overloaded{[&](const SphereHead& h) { return around_axis(h.radius, -h.radius, h.radius); },
                 [&](const ConeHead& h) { return around_axis(base_radius(h), 0, h.height); },
                 [&](const FlatHead& h) { return around_axis(h.radius, 0, h.height); },
                 [&](const ProfileHead& h) { return around_axis(h.table().radius, h.table().bottom, h.table().top); }},
      shape_);
}

double ToolHead::reach() const {
  return std::visit(Overloaded{[](const SphereHead& h) { return h.radius; },
                               [](const ConeHead& h) { return std::hypot(base_radius(h), h.height); },
                               [](const FlatHead& h) { return std::hypot(h.radius, h.height); },
                               [](const ProfileHead& h) { return h.reach(); }},
                    shape_);
}

double ToolHead::volume() const {
  return std::visit(Overloaded{[](const SphereHead& h) { return 4 * kPi / 3 * h.radius * h.radius * h.radius; },
                               [](const ConeHead& h) { return kPi / 3 * base_radius(h) * base_radius(h) * h.height; },
                               [](const FlatHead& h) { return kPi * h.radius * h.radius * h.height; },
                               [](const ProfileHead& h) { return h.volume(); }},
                    shape_);
}

Profile ToolHead::profile() const {
  constexpr EdgeKind kCutting = EdgeKind::cutting, kSmooth = EdgeKind::smooth;
  const auto flat = [&](const FlatHead& h) {
    const EdgeKind bottom = h.rule == FlatRule::side_only ? kSmooth : kCutting;
    const EdgeKind side = h.rule == FlatRule::bottom_only ? kSmooth : kCutting;
    return Profile{0, {{h.radius, 0, 0, bottom}, {h.radius, h.height, 0, side}, {0, h.height, 0, kSmooth}}};
  };
  return std::visit(
      Overloaded{[](const SphereHead& h) {
                   return Profile{-h.radius, {{0, h.radius, h.radius, kCutting}}};
                 },
                 [](const ConeHead& h) {
                   return Profile{0, {{base_radius(h), h.height, 0, kCutting}, {0, h.height, 0, kSmooth}}};
                 },
                 flat, [](const ProfileHead& h) { return h.profile(); }},
      shape_);
}

std::string ToolHead::description() const {
  const auto in_mm = [](double length) { return format_number(length / units::mm) + " mm"; };
  return std::visit(Overloaded{[&](const SphereHead& h) { return "a sphere of radius " + in_mm(h.radius); },
                               [&](const ConeHead& h) {
                                 return "a cone of half angle " + format_number(h.half_angle / units::deg) +
                                        " deg and height " + in_mm(h.height);
                               },
                               [&](const FlatHead& h) {
                                 return "a flat head of radius " + in_mm(h.radius) + " and height " + in_mm(h.height);
                               },
                               [&](const ProfileHead& h) {
                                 return "a profile of radius " + in_mm(h.table().radius) + " and height " +
                                        in_mm(double(h.table().top) - double(h.table().bottom));
                               }},
                    shape_);
}

double ToolHead::largest_radius() const { return bounding_box().max.x(); }

Spring ToolHead::spring_at(const Vec3& p_TQ) const {
  const double rho = std::hypot(p_TQ.x(), p_TQ.y());
  const MeridianSpring<double> s =
      visit_springs<double>([&](const auto& springs) { return springs.spring(rho, p_TQ.z()); });
  const double scale = rho > 0 ? s.n_radial / rho : 0.0;
  return {s.depth, Vec3(scale * p_TQ.x(), scale * p_TQ.y(), s.n_axial)};
}

}  // namespace hapticut
