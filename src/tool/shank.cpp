// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/shank.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "hapticut/core/errors.hpp"
#include "tool/meridian.hpp"

namespace hapticut {
namespace {

using detail::crossings;
using detail::Meridian;
using detail::MeridianEdge;
using detail::Vec2;

constexpr double kOnAnEdge = 1e-9;  // [1] distance that counts as on an edge, over the size

using detail::in_mm;

/// The meridian of a body without cutting edges. Meridian requires a cutting edge, so that all its edges are marked.
Meridian meridian_of(Profile profile) {
  for (ProfileEdge& edge : profile.edges) edge.kind = EdgeKind::cutting;
  return Meridian(profile);
}

/// The last point at which the meridian of a body leaves that of a head.
struct Leaving {
  std::size_t edge, body_edge;
  Vec2 point;
};

std::optional<Leaving> last_crossing(const Meridian& head, const Meridian& body) {
  std::optional<Leaving> last;
  const double tolerance = kOnAnEdge * head.size();
  for (std::size_t b = 0; b < body.edges().size(); ++b)
    for (std::size_t h = 0; h < head.edges().size(); ++h)
      for (const Vec2& p : crossings(head.edges()[h], body.edges()[b], tolerance))
        if (p.x() > tolerance && (!last || b > last->body_edge || p.y() > last->point.y())) last = Leaving{h, b, p};
  return last;
}

}  // namespace

Shank standard_shank(ShankKind kind, double neck_diameter) {
  require_positive(neck_diameter, "standard_shank neck_diameter [m]");
  using units::mm;
  const double diameter = kind == ShankKind::friction_grip ? 1.6 * mm : 2.35 * mm;
  const double length = kind == ShankKind::friction_grip ? 19 * mm : kind == ShankKind::latch ? 22 * mm : 44.5 * mm;
  return {neck_diameter, 2 * mm, 4 * mm, diameter, length};
}

ToolHead with_body(const ToolHead& head, const Profile& body) {
  const Profile shape = head.profile();
  const Meridian own(shape), around = meridian_of(body);
  const std::optional<Leaving> leaving = last_crossing(own, around);
  if (!leaving)
    throw Error("with_body: the body, from z = " + in_mm(around.bottom()) + " to " + in_mm(around.top()) +
                ", does not leave " + head.description() +
                ". Begin the body on the axis inside the head, and make it narrower there.");
  Profile all = {shape.tip, {}};
  for (std::size_t n = 0; n <= leaving->edge; ++n) all.edges.push_back(shape.edges[n]);
  // Keep the part of the last edge before the crossing, if it has any length.
  all.edges.pop_back();
  const Vec2 start = own.edges()[leaving->edge].from;
  const ProfileEdge& crossed = shape.edges[leaving->edge];
  if ((leaving->point - start).norm() > kOnAnEdge * own.size())
    all.edges.push_back({leaving->point.x(), leaving->point.y(), crossed.radius, crossed.kind});
  const auto add = [&](const Vec2& to, double radius) {
    const Vec2 from(all.edges.back().rho, all.edges.back().z);
    if ((to - from).norm() > kOnAnEdge * around.size()) all.edges.push_back({to.x(), to.y(), radius, EdgeKind::smooth});
  };
  for (std::size_t n = leaving->body_edge; n < body.edges.size(); ++n)
    add({body.edges[n].rho, body.edges[n].z}, body.edges[n].radius);
  return ProfileHead(all);
}

ToolHead on_shank(const ToolHead& head, const Shank& shank) {
  require_fields_within(shank, "Shank::");
  const Meridian own(head.profile());
  const double neck = shank.neck_diameter / 2, wide = shank.diameter / 2;
  // The neck begins inside the head: half of its radius below the point where it leaves the head, but at least halfway
  // between that point and the crossing below.
  MeridianEdge upright;
  upright.from = {neck, own.bottom() - own.size()}, upright.to = {neck, own.top() + own.size()};
  upright.start_tangent = upright.end_tangent = {0, 1};
  std::vector<double> heights = {own.bottom()};
  for (const MeridianEdge& edge : own.edges())
    for (const Vec2& p : crossings(edge, upright, kOnAnEdge * own.size())) heights.push_back(p.y());
  std::sort(heights.begin(), heights.end());
  const double leaves = heights.back();
  const auto last_in =
      std::find_if(heights.rbegin(), heights.rend(), [&](double z) { return z < leaves - 2 * kOnAnEdge * own.size(); });
  const double above = own.top() + shank.neck_length, end = own.bottom() + shank.length;
  if (last_in == heights.rend() || !(neck < own.radius() * (1 - kOnAnEdge)))
    throw Error("Shank::neck_diameter"_name + " = " + in_mm(shank.neck_diameter) +
                "; must be less than the diameter of the head, " + head.description() + ".");
  if (neck != wide && !(shank.taper_length > 0))
    throw Error("Shank::taper_length"_name + " = 0; must be > 0 between a neck of " + in_mm(shank.neck_diameter) +
                " and a shank of " + in_mm(shank.diameter) + ".");
  if (!(end > above + shank.taper_length))
    throw Error("Shank::length"_name + " = " + in_mm(shank.length) + "; must be more than head, neck and taper, " +
                in_mm(above + shank.taper_length - own.bottom()) + ".");
  const double begins = std::max(leaves - neck / 2, (leaves + *last_in) / 2);
  Profile body = {begins, {{neck, begins}}};
  if (above > leaves && neck != wide) body.edges.push_back({neck, above});
  if (neck != wide) body.edges.push_back({wide, above + shank.taper_length});
  body.edges.push_back({wide, end});
  body.edges.push_back({0, end});
  return with_body(head, body);
}

}  // namespace hapticut
