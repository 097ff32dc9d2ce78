// SPDX-License-Identifier: Apache-2.0
#include "hapticut/build/molar.hpp"

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "build/implicit_shapes.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut {
namespace {

using implicit::join;
using implicit::RoundCone;
using units::mm;

/// A cusp of the average tooth [mm]. The ball of the lobe touches the crown's wall on the sides `side_x`, `side_y`. For
/// a side of 0, `wall_x` or `wall_y` is the centre of the ball.
struct CuspShape {
  double tip_x, tip_y, tip_below_top, tip_radius;
  int side_x, side_y;
  double wall_x, wall_y, ball_height, ball_radius;
};
constexpr CuspShape kMesiobuccal = {2.55, 2.75, 0.55, 1.25, +1, +1, 5.50, 5.25, 2.7, 2.90};
constexpr CuspShape kDistobuccal = {-1.45, 2.95, 0.70, 1.20, 0, +1, -1.20, 5.20, 2.7, 2.80};
constexpr CuspShape kDistal = {-3.95, 1.15, 1.30, 1.05, -1, 0, -5.55, 0.75, 3.1, 2.45};
constexpr CuspShape kMesiolingual = {2.65, -3.05, 0.00, 1.05, +1, -1, 5.55, -5.25, 3.2, 2.95};
constexpr CuspShape kDistolingual = {-2.15, -3.05, 0.25, 1.05, -1, -1, -5.25, -5.15, 3.2, 2.90};
constexpr CuspShape kDistobuccalOfFour = {-2.45, 2.65, 0.70, 1.20, -1, +1, -5.55, 5.10, 2.8, 2.90};

constexpr double kLobeBlend = 0.5 * mm;    // seam between cusps: the width of the grooves
constexpr double kTrunkBlend = 1.0 * mm;   // seam between crown, root trunk and roots
constexpr double kStrandBlend = 0.8 * mm;  // seam between the two strands of a root
constexpr double kRidgeBlend = 0.5 * mm;   // seam of a ridge of a cusp
constexpr double kMarginBlend = 0.8 * mm;  // seam of a marginal ridge
constexpr double kPulpBlend = 0.3 * mm;    // seams of the pulp
constexpr double kTaper = 3.5 * mm;        // height over which the enamel of the walls reaches its full thickness
constexpr double kFissureFade = 1.5 * mm;  // height over which a fissure reaches its full depth
constexpr double kWedgeSlope = 1.5397;     // largest slope of (1 - x^2)^2 for 0 <= x <= 1: 16 sqrt(3)/18
constexpr double kMinDentin = 0.5 * mm;    // minimum thickness of any tissue between pulp and outer surface

/// 0 below `from`, 1 above `to`, smooth in between.
double smooth_step(double value, double from, double to) {
  const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// A cusp, and the depth under the surface at which its dentin horn begins.
struct Cusp {
  RoundCone lobe;
  Vec3 tip;           ///< centre of the small ball
  double horn_depth;  ///< [m]
};

/// A curved rod of varying thickness: half of a root, or a root canal.
class Strand {
 public:
  /// A quadratic Bezier curve with the radius running along with it, as a chain of round cones.
  Strand(const Vec3& from, double from_radius, const Vec3& control, double control_radius, const Vec3& to,
         double to_radius) {
    const auto blend = [](double t, const auto& a, const auto& b, const auto& c) {
      return ((1 - t) * (1 - t) * a + 2 * t * (1 - t) * b + t * t * c);
    };
    const double n = double(pieces_.size());
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const double t0 = double(i) / n, t1 = double(i + 1) / n;
      pieces_[i] = RoundCone(Vec3(blend(t0, from, control, to)), blend(t0, from_radius, control_radius, to_radius),
                             Vec3(blend(t1, from, control, to)), blend(t1, from_radius, control_radius, to_radius));
    }
  }

  [[nodiscard]] double operator()(const Vec3& p) const {
    double d = pieces_[0](p);
    for (std::size_t i = 1; i < pieces_.size(); ++i) d = std::min(d, pieces_[i](p));
    return d;
  }

 private:
  std::array<RoundCone, 4> pieces_;
};

/// A segment of a fissure, seen from above.
struct FissureSegment {
  Eigen::Vector2d from, to;
};

class Molar {
 public:
  explicit Molar(const MolarParameters& parameters);

  [[nodiscard]] Box box() const;
  [[nodiscard]] double distance(const Vec3& p) const;
  [[nodiscard]] MaterialId material(const Vec3& p) const;

 private:
  void add_cusp(const CuspShape& shape);
  void add_root(double side, double length);
  void add_fissures();
  [[nodiscard]] double crown(const Vec3& p) const;
  [[nodiscard]] double roots(const Vec3& p) const;
  [[nodiscard]] double smooth_surface(const Vec3& p) const;
  [[nodiscard]] double fissure_distance(const Vec3& p) const;
  [[nodiscard]] double enamel_thickness(const Vec3& p) const;
  [[nodiscard]] double pulp(const Vec3& p) const;
  [[nodiscard]] double surface_height(double x, double y) const;

  MolarParameters size_;
  Vec3 scale_;  ///< [1] size of this tooth over the average one, along x, y and z of the crown
  std::vector<Cusp> cusps_;
  std::vector<RoundCone> cusp_ridges_;
  std::vector<RoundCone> marginal_ridges_;
  std::vector<Strand> strands_;
  std::vector<Strand> canals_;
  std::vector<RoundCone> horns_;
  std::vector<FissureSegment> fissures_;
  Vec3 body_center_ = Vec3::Zero();  ///< centre of the block between the cusps
  Vec3 body_half_ = Vec3::Zero();
  double crown_bottom_ = 0;  ///< [m] height of the lowest point of the crown's parts
  double roots_top_ = 0;     ///< [m] height of the highest point of the strands
  double fissures_end_ = 0;  ///< [m] lower end of the fissures
  Vec3 lesion_center_ = Vec3::Zero();
};

Molar::Molar(const MolarParameters& parameters) : size_(parameters) {
  scale_ = Vec3(size_.crown_mesiodistal / (11.1 * mm), size_.crown_buccolingual / (10.5 * mm),
                size_.crown_height / (7.5 * mm));
  add_cusp(kMesiobuccal);
  add_cusp(kMesiolingual);
  add_cusp(kDistolingual);
  if (size_.distal_cusp) {
    add_cusp(kDistobuccal);
    add_cusp(kDistal);
  } else {
    add_cusp(kDistobuccalOfFour);
  }
  const auto at = [&](double x, double y, double z) { return Vec3(Vec3(x, y, z).cwiseProduct(scale_) * mm); };
  const double width = (scale_.x() + scale_.y()) / 2 * mm;
  marginal_ridges_.emplace_back(at(4.1, 1.5, 4.4), 1.0 * width, at(4.1, -1.8, 4.5),
                                1.0 * width);  // mesial marginal ridge
  marginal_ridges_.emplace_back(at(-3.9, 0.4, 4.1), 1.0 * width, at(-3.8, -1.8, 4.25),
                                1.0 * width);  // distal marginal ridge
  const double body_top = size_.crown_height - size_.fossa_depth;
  const double body_bottom = 0.8 * mm;
  crown_bottom_ = std::min(crown_bottom_, body_bottom);
  body_half_ = Vec3(4.95 * scale_.x() * mm, 4.35 * scale_.y() * mm, (body_top - body_bottom) / 2);
  body_center_ = at(0.35, -0.15, 0) + Vec3(0, 0, (body_top + body_bottom) / 2);
  add_root(+1, size_.mesial_root_length);
  add_root(-1, size_.distal_root_length);
  for (const Cusp& cusp : cusps_) {
    const Vec3 from(0.45 * cusp.tip.x(), 0.35 * cusp.tip.y(), size_.chamber_roof - 0.6 * mm);
    const Vec3 to(0.62 * cusp.tip.x(), 0.5 * cusp.tip.y(), size_.chamber_roof + size_.horn_height - 0.2 * mm);
    horns_.emplace_back(from, 0.6 * mm, to, 0.2 * mm);
  }
  // Directly under the summit of a cusp the dentin begins at the depth of this place.
  for (Cusp& cusp : cusps_) {
    const double summit = surface_height(cusp.tip.x(), cusp.tip.y());
    cusp.horn_depth = -smooth_surface({cusp.tip.x(), cusp.tip.y(), summit - size_.enamel_at_cusps});
  }
  add_fissures();
  lesion_center_ = Vec3(0, 0, surface_height(0, 0) - size_.caries_depth / 2);
}

void Molar::add_cusp(const CuspShape& shape) {
  const double width = (scale_.x() + scale_.y()) / 2 * mm;
  const double ball_radius = shape.ball_radius * width;
  const Vec3 ball(shape.wall_x * scale_.x() * mm - shape.side_x * ball_radius,
                  shape.wall_y * scale_.y() * mm - shape.side_y * ball_radius, shape.ball_height * scale_.z() * mm);
  const double tip_radius = shape.tip_radius * width;
  const Vec3 tip(shape.tip_x * scale_.x() * mm, shape.tip_y * scale_.y() * mm,
                 size_.crown_height - shape.tip_below_top * scale_.z() * mm - tip_radius);
  const RoundCone lobe(ball, ball_radius, tip, tip_radius);
  cusps_.push_back({lobe, tip, 0});
  crown_bottom_ = std::min(crown_bottom_, ball.z() - ball_radius);

  // Four ridges run down from a cusp; the outer ridge is the wall.
  const double fossa = size_.crown_height - size_.fossa_depth;
  const double crest_radius = 0.6 * tip_radius;
  const Vec3 crest = tip + Vec3(0, 0, tip_radius - crest_radius - 0.22 * mm);  // low enough not to change the tip
  const Eigen::Vector2d outwards = tip.head<2>().normalized();
  const Vec3 along(shape.side_y == 0 ? -outwards.y() : 1.0, shape.side_y == 0 ? outwards.x() : 0.0, 0);
  const Vec3 fall(0, 0, 0.95 * mm * scale_.z());
  cusp_ridges_.emplace_back(crest, crest_radius, crest + 1.35 * width * along - fall, 0.7 * crest_radius);
  cusp_ridges_.emplace_back(crest, crest_radius, crest - 1.35 * width * along - fall, 0.7 * crest_radius);
  const double inner_radius = 0.8 * width;
  cusp_ridges_.emplace_back(crest, crest_radius, Vec3(0.36 * tip.x(), 0.25 * tip.y(), fossa + 0.1 * mm - inner_radius),
                            inner_radius);
}

void Molar::add_root(double side, double length) {
  const bool mesial = side > 0;
  const double depth = length / (14 * mm);  // [1] over the average mesial root
  const double neck_x = size_.cervix_mesiodistal / (9 * mm);
  const double neck_y = size_.cervix_buccolingual / (9 * mm);
  const double width = (neck_x + neck_y) / 2 * mm;
  const double top_radius = 2.05 * width;
  const double end_radius = 0.75 * width;
  for (const double cheek : {+1.0, -1.0}) {
    const auto at = [&](double x, double y, double z) {
      return Vec3(side * x * neck_x * mm, cheek * y * neck_y * mm, z);
    };
    // Mesial root: broad, bent to the distal side. Distal root: rounder, straight, pointing away.
    const Vec3 top = at(2.35, mesial ? 2.15 : 1.85, -1.2 * mm);
    const Vec3 bend = at(mesial ? 3.6 : 2.9, mesial ? 1.5 : 0.85, -7.5 * mm * depth);
    const Vec3 end = at(mesial ? 2.1 : 3.5, mesial ? 0.7 : 0.35, -length + end_radius);
    roots_top_ = std::max(roots_top_, top.z() + top_radius);
    strands_.emplace_back(top, top_radius, bend, (mesial ? 1.35 : 1.45) * width, end, end_radius);

    const double inward = mesial ? 0.8 : 0.3;
    const double orifice_y = (mesial ? 0.32 : 0.14) * size_.chamber_buccolingual;
    const Vec3 orifice(side * (size_.chamber_mesiodistal / 2 - size_.canal_radius - 0.1 * mm), cheek * orifice_y,
                       size_.chamber_roof - size_.chamber_height + 0.3 * mm);
    const Vec3 apex(end.x(), end.y() * inward, -length + size_.apical_dentin + size_.canal_radius_at_apex);
    canals_.emplace_back(orifice, size_.canal_radius, Vec3(bend.x(), bend.y() * inward, bend.z()),
                         (size_.canal_radius + size_.canal_radius_at_apex) / 2, apex, size_.canal_radius_at_apex);
  }
}

void Molar::add_fissures() {
  const auto add = [&](const std::vector<Eigen::Vector2d>& points) {
    const Eigen::Vector2d scale = scale_.head<2>() * mm;
    for (std::size_t i = 1; i < points.size(); ++i)
      fissures_.push_back({points[i - 1].cwiseProduct(scale), points[i].cwiseProduct(scale)});
  };
  fissures_end_ = 3.4 * mm * scale_.z();
  add({{3.3, -0.2}, {1.6, -0.1}, {0.4, 0.15}, {-0.7, -0.2}, {-1.9, 0.0}, {-3.2, -0.5}});  // central
  add({{-0.7, -0.2}, {0.15, -2.0}, {0.3, -5.4}});                                         // lingual
  if (size_.distal_cusp) {
    add({{0.4, 0.15}, {0.65, 2.0}, {0.7, 5.4}});    // mesiobuccal
    add({{-1.9, 0.0}, {-2.75, 1.7}, {-3.9, 4.6}});  // distobuccal
  } else {
    add({{0.4, 0.15}, {0.2, 2.0}, {0.1, 5.4}});  // buccal
  }
}

Box Molar::box() const {
  const double margin = 0.3 * mm;  // rounded seams protrude less than this
  const Vec3 reach(size_.crown_mesiodistal / 2 + margin, size_.crown_buccolingual / 2 + margin, 0);
  const double root = std::max(size_.mesial_root_length, size_.distal_root_length) + margin;
  return {-reach - Vec3(0, 0, root), reach + Vec3(0, 0, size_.crown_height + margin)};
}

double Molar::crown(const Vec3& p) const {
  double d = implicit::rounded_box(p, body_center_, body_half_, 1.7 * mm);
  for (const Cusp& cusp : cusps_) d = join(d, cusp.lobe(p), kLobeBlend);
  for (const RoundCone& ridge : cusp_ridges_) d = join(d, ridge(p), kRidgeBlend);
  for (const RoundCone& ridge : marginal_ridges_) d = join(d, ridge(p), kMarginBlend);
  return d;
}

double Molar::roots(const Vec3& p) const {
  const double mesial = join(strands_[0](p), strands_[1](p), kStrandBlend);
  const double distal = join(strands_[2](p), strands_[3](p), kStrandBlend);
  return std::min(mesial, distal);
}

/// The tooth before the fissures are pressed in.
double Molar::smooth_surface(const Vec3& p) const {
  const double depth = size_.furcation_depth;
  double d = implicit::rounded_box(
      p, Vec3::Zero(), {size_.cervix_mesiodistal / 2, size_.cervix_buccolingual / 2, depth}, std::min(2.9 * mm, depth));
  // Parts beyond a plane at a distance larger than the width of the seam do not change any bit of the value.
  if (crown_bottom_ - p.z() < d + kTrunkBlend) d = join(d, crown(p), kTrunkBlend);
  if (p.z() - roots_top_ < d + kTrunkBlend) d = join(d, roots(p), kTrunkBlend);
  return d;
}

double Molar::fissure_distance(const Vec3& p) const {
  const Eigen::Vector2d q = p.head<2>();
  double min_square = std::numeric_limits<double>::max();
  for (const FissureSegment& s : fissures_) {
    const Eigen::Vector2d along = s.to - s.from;
    const double t = std::clamp((q - s.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    min_square = std::min(min_square, (q - s.from - t * along).squaredNorm());
  }
  return std::max(std::sqrt(min_square), fissures_end_ - p.z());
}

double Molar::distance(const Vec3& p) const {
  const double surface = smooth_surface(p);
  const double half_width = size_.fissure_half_width;
  if (size_.fissure_depth == 0 || half_width - (fissures_end_ - p.z()) <= surface) return surface;  // too far below
  // A fissure is the set within half_width of its line where the depth is less than a smooth wedge that fades out down
  // the walls. The sides of the wedge are steeper than the surface; the divisor keeps the result a bound of the
  // distance.
  const double aside = fissure_distance(p);
  const double across = std::max(1 - aside * aside / (half_width * half_width), 0.0);
  const double fading = std::clamp((p.z() - fissures_end_) / kFissureFade, 0.0, 1.0);
  const double wedge = size_.fissure_depth * across * across * fading;
  const double steepness = 1 + size_.fissure_depth * (kWedgeSlope / half_width + 1 / kFissureFade);
  return std::max(surface, std::min(half_width - aside, (surface + wedge) / steepness));
}

double Molar::enamel_thickness(const Vec3& p) const {
  const double rise = std::max(p.x() / (size_.cervix_mesiodistal / 2), 0.0);
  const double height = p.z() - size_.cervical_curvature * std::min(rise * rise, 1.0);
  if (height <= 0) return 0;
  const double from_middle = std::hypot(p.x() / (size_.crown_mesiodistal / 2), p.y() / (size_.crown_buccolingual / 2));
  double thickness =
      size_.enamel_in_fossa + (size_.enamel_on_walls - size_.enamel_in_fossa) * smooth_step(from_middle, 0.45, 0.75);
  for (const Cusp& cusp : cusps_) {
    const double aside = (p - cusp.tip).head<2>().norm();
    thickness += (cusp.horn_depth - thickness) * (1 - smooth_step(aside, 0.5 * mm, 2.2 * mm));
  }
  return thickness * std::sin(units::kPi / 2 * std::min(height / kTaper, 1.0));
}

double Molar::pulp(const Vec3& p) const {
  // The chamber is a rounded cushion, wider on the mesial side.
  const Vec3 half = Vec3(size_.chamber_mesiodistal, size_.chamber_buccolingual, size_.chamber_height) / 2;
  const double x = p.x() / half.x();
  const double y = p.y() / (half.y() * (0.86 + 0.14 * std::clamp(x, -1.0, 1.0)));
  const double z = (p.z() - size_.chamber_roof + half.z()) / half.z();
  double d = (std::pow(x * x * x * x + y * y * y * y + z * z * z * z, 0.25) - 1) * half.z();
  if (size_.horn_height > 0)
    for (const RoundCone& horn : horns_) d = join(d, horn(p), kPulpBlend);
  for (const Strand& canal : canals_) d = join(d, canal(p), kPulpBlend);
  return d;
}

MaterialId Molar::material(const Vec3& p) const {
  const double depth = -smooth_surface(p);
  if (depth > kMinDentin && pulp(p) < 0) return kMolarPulp;
  if (size_.caries_depth > 0) {
    const Vec3 half = Vec3(size_.caries_width, size_.caries_width, size_.caries_depth) / 2;
    if ((p - lesion_center_).cwiseQuotient(half).norm() < 1) return kMolarCaries;
  }
  const double thickness = enamel_thickness(p);
  return thickness > 0 && depth < thickness ? kMolarEnamel : kMolarDentin;
}

/// [m] Height of the chewing surface, without fissures, above a point of the junction's plane.
double Molar::surface_height(double x, double y) const {
  double z = size_.crown_height + mm;
  for (int i = 0; i < 200; ++i) {
    const double gap = smooth_surface({x, y, z});
    if (gap < 1e-9) break;
    z -= gap;
  }
  return z;
}

}  // namespace

void validate(const MolarParameters& p) {
  require_fields_within(p, "MolarParameters::");
  const auto at_most = [](double value, double high, const char* field) {
    require_between(value, 0, high, {Name(std::string("MolarParameters::") + field), " [m]"});
  };
  at_most(p.cervix_mesiodistal, p.crown_mesiodistal, "cervix_mesiodistal");
  at_most(p.cervix_buccolingual, p.crown_buccolingual, "cervix_buccolingual");
  at_most(p.canal_radius_at_apex, p.canal_radius, "canal_radius_at_apex");
}

BodyDescription describe_molar(const MolarParameters& parameters) {
  validate(parameters);
  const auto molar = std::make_shared<const Molar>(parameters);
  return {molar->box(), [molar](const Vec3& p) { return molar->distance(p); },
          [molar](const Vec3& p) { return molar->material(p); }};
}

Workpiece build_molar(double voxel_size, const MolarParameters& parameters) {
  MaterialTable materials({presets::enamel(), presets::dentin(), presets::pulp()});
  if (parameters.caries_depth > 0) materials.add(presets::caries());
  return build_body(describe_molar(parameters), voxel_size, std::move(materials));
}

}  // namespace hapticut
