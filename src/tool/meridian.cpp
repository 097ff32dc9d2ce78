// SPDX-License-Identifier: Apache-2.0
#include "tool/meridian.hpp"

#include <algorithm>
#include <string>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut::detail {
namespace {

using units::kPi;

constexpr double kRounding = 1e-9;  // [1] rounding error over the size: smaller differences count as equal
constexpr std::size_t kMaxEdges = 1000;

std::string in_mm(const Vec2& p) {
  return "(" + format_number(p.x() / units::mm) + ", " + format_number(p.y() / units::mm) + ") mm";
}

std::string name_of(std::size_t edge) { return "edge " + std::to_string(edge + 1) + " of the profile"; }

/// [0, 2 pi)
double wrapped(double angle) {
  const double remainder = std::fmod(angle, 2 * kPi);
  return remainder < 0 ? remainder + 2 * kPi : remainder;
}

MeridianEdge make_edge(const Vec2& from, const ProfileEdge& given, std::size_t index) {
  MeridianEdge e;
  e.from = from;
  e.to = {given.rho, given.z};
  e.kind = given.kind;
  const Vec2 chord = e.to - e.from;
  const double length = chord.norm();
  if (given.radius == 0) {
    e.start_tangent = e.end_tangent = chord / length;
    return e;
  }
  const double radius = std::abs(given.radius), half = length / 2;
  if (!(radius >= half * (1 - kRounding)))
    throw Error(name_of(index) + " from " + in_mm(e.from) + " to " + in_mm(e.to) + " has an arc radius of " +
                format_number(given.radius / units::mm) +
                " mm; must be at least half of the distance between its ends, " + format_number(half / units::mm) +
                " mm. Give a larger radius, or split the arc.");
  const double sense = given.radius > 0 ? 1 : -1;  // counter-clockwise for an arc that bulges outwards
  const double height = std::sqrt(std::max(0.0, radius * radius - half * half));
  e.curvature = sense / radius;
  e.center = (e.from + e.to) / 2 + sense * height * left_of(chord / length);
  const Vec2 to_start = e.from - e.center, to_end = e.to - e.center;
  e.start_angle = std::atan2(to_start.y(), to_start.x());
  e.sweep = sense * 2 * std::asin(std::min(1.0, half / radius));
  e.start_tangent = sense * left_of(to_start.normalized());
  e.end_tangent = sense * left_of(to_end.normalized());
  return e;
}

/// [rad] Angles of the extreme points of an edge's circle (right, top, left, bottom) that lie strictly on the edge.
std::vector<double> extreme_angles(const MeridianEdge& e) {
  std::vector<double> angles;
  if (e.straight()) return angles;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double sense = e.sweep > 0 ? 1 : -1;
    const double angle = wrapped(sense * (quarter * kPi / 2 - e.start_angle));
    if (angle > kRounding && angle < std::abs(e.sweep) - kRounding) angles.push_back(angle);
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

}  // namespace

double MeridianEdge::angle_of(const Vec2& p) const {
  const Vec2 v = p - center;
  return wrapped((sweep > 0 ? 1 : -1) * (std::atan2(v.y(), v.x()) - start_angle));
}

Vec2 MeridianEdge::at_angle(double angle) const {
  const double absolute = start_angle + (sweep > 0 ? angle : -angle);
  return center + radius() * Vec2(std::cos(absolute), std::sin(absolute));
}

bool MeridianCurve::in_charge(const Vec2& x, double reach) const {
  // Neighbours overlap by rounding, so that a point between them, or on the axis, has one of them.
  const double slack = kRounding * (edge.to - edge.from).norm() + reach;
  if (kind == Kind::corner) return edge.end_tangent.dot(x - point) >= -slack && next.dot(x - point) <= slack;
  if (kind == Kind::line) {
    const double along = edge.start_tangent.dot(x - point);
    return along >= low - slack && along <= high + slack;
  }
  const double distance = (x - edge.center).norm();
  if (distance < kRounding * edge.radius() + reach) return true;  // the centre lies in no direction
  const double angle = edge.angle_of(x), angular_slack = kRounding + std::asin(reach / distance);
  const auto within = [&](double a) { return a >= low - angular_slack && a <= high + angular_slack; };
  return within(angle) || within(angle - 2 * kPi);
}

MeridianSpring<double> MeridianCurve::spring(const Vec2& x) const {
  if (kind == Kind::line) {
    const Vec2 normal = left_of(edge.start_tangent);
    return {normal.dot(x - point), -normal.x(), -normal.y()};
  }
  const Vec2 v = x - (kind == Kind::corner ? point : edge.center);
  const double distance = v.norm();
  const Vec2 away = v / std::max(distance, 1e-300);
  if (kind == Kind::corner) return {distance, -away.x(), -away.y()};
  const double sign = edge.sweep > 0 ? 1 : -1;
  return {sign * (edge.radius() - distance), sign * away.x(), sign * away.y()};
}

Meridian::Meridian(const Profile& profile) {
  make_edges(profile);
  check_orientation();
  check_crossings();
  make_curves();
}

void Meridian::make_edges(const Profile& profile) {
  if (profile.edges.empty() || profile.edges.size() > kMaxEdges)
    throw Error("the profile has " + std::to_string(profile.edges.size()) + " edges; must be between 1 and " +
                std::to_string(kMaxEdges) + ". List the edges from the tip to the shank.");
  if (!std::isfinite(profile.tip))
    throw Error("Profile::tip"_name + " = " + format_number(profile.tip) + " m; must be finite.");
  bottom_ = top_ = profile.tip;
  for (std::size_t i = 0; i < profile.edges.size(); ++i) {
    const ProfileEdge& e = profile.edges[i];
    if (!std::isfinite(e.rho) || !std::isfinite(e.z) || !std::isfinite(e.radius))
      throw Error(name_of(i) + " has rho = " + format_number(e.rho) + " m, z = " + format_number(e.z) +
                  " m, radius = " + format_number(e.radius) +
                  " m; must be finite. Give radius = 0 for a straight edge.");
    if (e.rho < 0)
      throw Error(name_of(i) + " ends at rho = " + format_number(e.rho / units::mm) +
                  " mm, across the axis; must be >= 0. Draw one side of the axis only.");
    radius_ = std::max(radius_, e.rho);
    bottom_ = std::min(bottom_, e.z);
    top_ = std::max(top_, e.z);
  }
  size_ = std::max(radius_, top_ - bottom_);
  if (!(size_ > 0)) throw Error("the profile has no size: all its points are at " + in_mm({0, profile.tip}) + ".");

  bool cuts = false;
  Vec2 from(0, profile.tip);
  for (std::size_t i = 0; i < profile.edges.size(); ++i) {
    const ProfileEdge& given = profile.edges[i];
    if (!((Vec2(given.rho, given.z) - from).norm() > kRounding * size_))
      throw Error(name_of(i) + " begins and ends at " + in_mm(from) + "; its length must be > 0. Leave it out.");
    edges_.push_back(make_edge(from, given, i));
    from = edges_.back().to;
    cuts |= given.kind == EdgeKind::cutting;
  }
  if (from.x() > kRounding * size_)
    throw Error("the profile is not closed: it ends at " + in_mm(from) +
                ", and must end on the axis. Add a smooth edge to (0, " + format_number(from.y() / units::mm) +
                ") mm.");
  if (!cuts)
    throw Error("the profile has no cutting edge; at least one must cut. Set " + "ProfileEdge::kind"_name + ".");

  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const MeridianEdge& e = edges_[i];
    if (i + 1 < edges_.size() && !(e.to.x() > kRounding * size_))
      throw Error(name_of(i) + " ends on the axis at " + in_mm(e.to) +
                  ", but more edges follow; only the last may. Move the point off the axis, or end the profile there.");
    for (const double angle : extreme_angles(e)) {
      const Vec2 p = e.at_angle(angle);
      if (p.x() < -kRounding * size_)
        throw Error(name_of(i) + " crosses the axis: its arc reaches rho = " + format_number(p.x() / units::mm) +
                    " mm; must stay >= 0. Give a larger radius, or other ends.");
      radius_ = std::max(radius_, p.x());
      bottom_ = std::min(bottom_, p.y());
      top_ = std::max(top_, p.y());
    }
  }
  size_ = std::max(radius_, top_ - bottom_);
  if (!(radius_ > kRounding * size_)) throw Error("the profile lies on its axis; its largest rho must be > 0.");
}

void Meridian::check_orientation() const {
  const double tip = edges_.front().from.y(), end = edges_.back().to.y();
  if (!(end - tip > kRounding * size_))
    throw Error("the profile begins at z = " + format_number(tip / units::mm) +
                " mm and ends at z = " + format_number(end / units::mm) +
                " mm; the tip must be below the shank's side. List the edges from the "
                "tip to the shank.");
}

void Meridian::check_crossings() const {
  for (std::size_t i = 0; i < edges_.size(); ++i)
    for (std::size_t j = i + 1; j < edges_.size(); ++j) {
      const MeridianEdge &a = edges_[i], &b = edges_[j];
      if (j == i + 1 && a.end_tangent.dot(b.start_tangent) < -1 + kRounding)
        throw Error("the profile turns back on itself at " + in_mm(a.to) + ", from " + name_of(i) + " to " +
                    name_of(j) + ". Leave an angle between them.");
      for (const Vec2& p : crossings(a, b, kRounding * size_)) {
        if (j == i + 1 && (p - a.to).norm() < 1e-6 * size_) continue;
        throw Error("the profile crosses or touches itself at " + in_mm(p) + ", where " + name_of(i) + " meets " +
                    name_of(j) + ". Move one of them.");
      }
    }
}

/// Adds the corner between two edges of the same kind if it is hollow.
void Meridian::add_corner(const MeridianEdge& before, const Vec2& point, const Vec2& next) {
  if (cross(before.end_tangent, next) < -kRounding)
    curves_.push_back({MeridianCurve::Kind::corner, before, point, next, 0, 0});
}

/// Whether the whole body lies on the left of a straight edge's line. Then the edge may be extended: the extension lies
/// outside of the body.
bool Meridian::bounds_all(const MeridianEdge& edge) const {
  if (!edge.straight()) return false;
  const Vec2 normal = left_of(edge.start_tangent);
  const auto inside = [&](const Vec2& p) { return normal.dot(p - edge.from) >= -kRounding * size_; };
  return std::all_of(edges_.begin(), edges_.end(), [&](const MeridianEdge& e) {
    if (!inside(e.to) || !inside(e.from)) return false;
    if (e.straight() || e.curvature < 0) return true;
    const Vec2 outermost = e.center - e.radius() * normal;
    return e.angle_of(outermost) > std::abs(e.sweep) || inside(outermost);
  });
}

/// @param begins_before, goes_on  whether a line is also in charge before its start, or beyond its end
void Meridian::add_edge(const MeridianEdge& edge, bool begins_before, bool goes_on) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  MeridianCurve curve;
  curve.edge = edge;
  curve.point = edge.from;
  curve.kind = edge.straight() ? MeridianCurve::Kind::line : MeridianCurve::Kind::arc;
  curve.low = begins_before ? -kInfinity : 0;
  curve.high = goes_on ? kInfinity : edge.straight() ? (edge.to - edge.from).norm() : std::abs(edge.sweep);
  curves_.push_back(curve);
}

void Meridian::make_curves() {
  const auto mirrored = [](const Vec2& tangent) { return Vec2(tangent.x(), -tangent.y()); };
  const auto add_end = [&](const MeridianEdge& e, const Vec2& point, const Vec2& beyond) {
    MeridianEdge before = e;
    before.end_tangent = beyond;
    curves_.push_back({MeridianCurve::Kind::corner, before, point, -beyond, 0, 0});
  };
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const MeridianEdge& e = edges_[i];
    const bool first = i == 0, last = i + 1 == edges_.size(), cuts = e.kind == EdgeKind::cutting;
    // Where the kind changes, the end of the cutting edge decides, because the depth of the smooth edge grows faster.
    const bool ends_before = !first && edges_[i - 1].kind != e.kind, ends = !last && edges_[i + 1].kind != e.kind;
    // A cutting edge is extended only if the next edge bends away from its line, so that no part of the body is on it.
    const bool bounds = cuts && (ends_before || ends) && bounds_all(e);
    const bool begins_before = bounds && ends_before && cross(edges_[i - 1].end_tangent, e.start_tangent) > kRounding;
    const bool goes_on = bounds && ends && cross(e.end_tangent, edges_[i + 1].start_tangent) > kRounding;
    if (first) {  // a hollow tip: the corner with the other half of the meridian
      MeridianEdge other = e;
      other.end_tangent = mirrored(e.start_tangent);
      add_corner(other, e.from, e.start_tangent);
    } else if (!ends_before) {
      add_corner(edges_[i - 1], e.from, e.start_tangent);
    } else if (cuts && !begins_before) {
      add_end(e, e.from, -e.start_tangent);
    }
    add_edge(e, begins_before, goes_on);
    if (ends && cuts && !goes_on) add_end(e, e.to, e.end_tangent);
    if (last) add_corner(e, e.to, mirrored(e.end_tangent));
  }
}

std::vector<ProfileCorner<double>> Meridian::corners() const {
  std::vector<ProfileCorner<double>> corners;
  for (std::size_t i = 1; i < edges_.size(); ++i)
    if (edges_[i - 1].kind != edges_[i].kind) corners.push_back({edges_[i].from.x(), edges_[i].from.y()});
  return corners;
}

std::size_t Meridian::nearest(const Vec2& x) const {
  std::size_t best = kNone;
  double min_distance = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < curves_.size(); ++n) {
    if (!curves_[n].in_charge(x)) continue;
    const double distance = std::abs(curves_[n].depth(x));
    if (distance < min_distance) {
      min_distance = distance;
      best = n;
    }
  }
  return best;
}

double Meridian::volume() const {
  double sum = 0;  // Int rho^2 dz along the meridian; times pi, by Pappus
  for (const MeridianEdge& e : edges_) {
    if (e.straight()) {
      sum += (e.to.y() - e.from.y()) * (e.from.x() * e.from.x() + e.from.x() * e.to.x() + e.to.x() * e.to.x()) / 3;
      continue;
    }
    const auto integral = [&](double t) {
      const double c = e.center.x(), r = e.radius(), s = std::sin(t);
      return r * (c * c * s + c * r * (t + s * std::cos(t)) + r * r * (s - s * s * s / 3));
    };
    sum += integral(e.start_angle + e.sweep) - integral(e.start_angle);
  }
  return kPi * sum;
}

double Meridian::reach() const {
  double farthest = edges_.front().from.norm();
  for (const MeridianEdge& e : edges_) {
    farthest = std::max(farthest, e.to.norm());
    if (e.straight()) continue;
    const double distance = e.center.norm();
    const Vec2 outermost = distance > 0 ? Vec2(e.center / distance * (distance + e.radius())) : e.to;
    if (e.angle_of(outermost) <= std::abs(e.sweep)) farthest = std::max(farthest, outermost.norm());
  }
  return farthest;
}

double Meridian::cutting_radius() const {
  double radius = 0;
  for (const MeridianEdge& e : edges_) {
    if (e.kind == EdgeKind::smooth) continue;
    radius = std::max({radius, e.from.x(), e.to.x()});
    for (const double angle : extreme_angles(e)) radius = std::max(radius, e.at_angle(angle).x());
  }
  return radius;
}

std::vector<ProfilePiece<double>> Meridian::pieces() const {
  std::vector<ProfilePiece<double>> pieces;
  for (const MeridianEdge& e : edges_) {
    if (e.straight()) {
      pieces.push_back({e.from.x(), e.from.y(), e.to.x(), e.to.y(), 0, 0, 0, 1, 1});
      continue;
    }
    // Divided at the extreme points, so that each piece is monotone in z and in rho.
    std::vector<double> cuts = {0};
    for (const double angle : extreme_angles(e)) cuts.push_back(angle);
    cuts.push_back(std::abs(e.sweep));
    for (std::size_t n = 0; n + 1 < cuts.size(); ++n) {
      const Vec2 a = n == 0 ? e.from : e.at_angle(cuts[n]);
      const Vec2 b = n + 2 == cuts.size() ? e.to : e.at_angle(cuts[n + 1]);
      const double side = e.at_angle((cuts[n] + cuts[n + 1]) / 2).x() >= e.center.x() ? 1 : -1;
      pieces.push_back(
          {a.x(), a.y(), b.x(), b.y(), e.center.x(), e.center.y(), e.radius(), e.sweep > 0 ? 1.0 : -1.0, side});
    }
  }
  return pieces;
}

}  // namespace hapticut::detail
