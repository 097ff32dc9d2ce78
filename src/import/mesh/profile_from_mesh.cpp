// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Eigenvalues>
#include <array>
#include <map>
#include <string>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/import/mesh/profile_from_mesh.hpp"
#include "import/mesh/meridian_fit.hpp"

namespace hapticut {
namespace {

using detail::Vec2;
constexpr int kCuts = 8;            // half-planes in which the mesh is cut
constexpr double kCutAngle = 2.4;   // [rad] from one to the next: no two cut a regular prism in the same way
constexpr double kFit = 1e-3;       // [1] allowed distance of lines and arcs from the vertices, over the largest radius
constexpr double kBall = 1e-3;      // [1] eigenvalue over the mean square radius; below it a ball, and every axis fits
constexpr double kOnAxis = 1e-6;    // [1] distance that counts as on the axis, over the largest radius
constexpr double kFirstCut = 0.61;  // [rad] an angle at which meshes rarely have vertices

struct Triangle {
  Vec3 center, normal;
  double area;
};

std::vector<Triangle> triangles_of(const TriangleMesh& mesh) {
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : mesh.triangles) {
    if (std::max({a, b, c}) >= mesh.vertices.size())
      throw Error("a triangle of the mesh names vertex " + std::to_string(std::max({a, b, c})) + "; there are only " +
                  std::to_string(mesh.vertices.size()) + ".");
    const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
    const Vec3 cross = (q - p).cross(r - p);
    const double twice = cross.norm();
    if (!std::isfinite(twice)) throw Error("the mesh has a vertex that is not finite.");
    if (twice > 0) triangles.push_back({(p + q + r) / 3, cross / twice, twice / 2});
  }
  if (triangles.empty()) throw Error("the mesh has no triangle; a head needs a closed surface.");
  return triangles;
}

struct Axis {
  Vec3 point, direction;
};

/// The axis of the rotation x -> a x (x - p) that moves the surface along itself: normal . (a x x + b) = 0 for every
/// facet, b = -a x p (Pottmann and Wallner, Computational Line Geometry).
Axis find_axis(const std::vector<Triangle>& triangles, const Vec3& towards_shank) {
  double area = 0;
  Vec3 middle = Vec3::Zero();
  for (const Triangle& t : triangles) {
    area += t.area;
    middle += t.area * t.center;
  }
  middle /= area;
  Mat3 aa = Mat3::Zero(), ab = Mat3::Zero(), bb = Mat3::Zero();
  double square = 0;
  for (const Triangle& t : triangles) {
    const Vec3 x = t.center - middle, moment = x.cross(t.normal);
    aa += t.area / area * moment * moment.transpose();
    ab += t.area / area * moment * t.normal.transpose();
    bb += t.area / area * t.normal * t.normal.transpose();
    square += t.area / area * x.squaredNorm();
  }
  const Mat3 inverse = bb.completeOrthogonalDecomposition().pseudoInverse();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(aa - ab * inverse * ab.transpose());
  Vec3 a = solver.eigenvalues()[1] > kBall * square ? Vec3(solver.eigenvectors().col(0)) : towards_shank;
  if (a.dot(towards_shank) < 0) a = -a;
  const Vec3 b = -inverse * ab.transpose() * a;
  return {middle + a.cross(b), a};
}

/// A mesh in the frame of its axis; vertices at the same place are merged.
struct WeldedMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

WeldedMesh weld(const TriangleMesh& mesh, const Pose& X_TM) {
  const auto less = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::map<Vec3, std::uint32_t, decltype(less)> places(less);
  WeldedMesh welded;
  for (const auto& triangle : mesh.triangles) {
    std::array<std::uint32_t, 3> ids = {};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [place, added] = places.try_emplace(mesh.vertices[triangle[k]], std::uint32_t(places.size()));
      if (added) welded.vertices.push_back(X_TM * place->first);
      ids[k] = place->second;
    }
    if (ids[0] != ids[1] && ids[1] != ids[2] && ids[2] != ids[0]) welded.triangles.push_back(ids);
  }
  return welded;
}

/// Where the half-plane at an angle about the axis cuts the mesh, from the lower end on the axis to the upper one.
class Cut {
 public:
  /// @param axis  [m] points nearer to the axis count as on the axis
  Cut(const WeldedMesh& mesh, double angle, double axis)
      : across_(-std::sin(angle), std::cos(angle)), outwards_(std::cos(angle), std::sin(angle)), axis_(axis) {
    for (const auto& triangle : mesh.triangles) add(mesh, triangle);
    if (ends_.size() != 2)
      throw Error("the axis of the mesh passes through its surface " + std::to_string(ends_.size()) +
                  " times; must be twice. Give one closed body without cavities.");
    walk();
  }

  [[nodiscard]] const std::vector<Vec2>& points() const { return points_; }

 private:
  using Key = std::pair<std::uint32_t, std::uint32_t>;  // the edge of the mesh that is cut

  void add(const WeldedMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
    std::vector<std::pair<Key, Vec2>> hits;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t i = std::min(triangle[k], triangle[(k + 1) % 3]),
                          j = std::max(triangle[k], triangle[(k + 1) % 3]);
      const Vec3 &p = mesh.vertices[i], &q = mesh.vertices[j];
      const double side_p = across_.dot(p.head<2>()), side_q = across_.dot(q.head<2>());
      if ((side_p > 0) == (side_q > 0)) continue;
      const Vec3 x = p + side_p / (side_p - side_q) * (q - p);
      hits.push_back({{i, j}, {outwards_.dot(x.head<2>()), x.z()}});
    }
    if (hits.size() != 2) return;
    const auto& [key_a, a] = hits[0];
    const auto& [key_b, b] = hits[1];
    const bool a_inside = a.x() <= axis_, b_inside = b.x() <= axis_;
    if (a_inside && b_inside) return;
    if (!a_inside && !b_inside) {
      link(key_a, a, key_b);
      link(key_b, b, key_a);
      return;
    }
    const Vec2 on_axis(0, a.y() + a.x() / (a.x() - b.x()) * (b.y() - a.y()));
    const Key& outer = a_inside ? key_b : key_a;
    nodes_[outer].place = a_inside ? b : a;
    ends_.emplace_back(on_axis, outer);
  }

  void link(const Key& from, const Vec2& place, const Key& to) {
    nodes_[from].place = place;
    nodes_[from].next.push_back(to);
  }

  void walk() {
    if (ends_[0].first.y() > ends_[1].first.y()) std::swap(ends_[0], ends_[1]);
    points_.push_back(ends_[0].first);
    Key before, now = ends_[0].second;
    for (std::size_t count = 0; count <= nodes_.size(); ++count) {
      const Node& node = nodes_[now];
      points_.push_back(node.place);
      if (now == ends_[1].second) break;
      const auto next = std::find_if(node.next.begin(), node.next.end(), [&](const Key& k) { return k != before; });
      if (next == node.next.end() || node.next.size() > 2)
        throw Error(
            "the mesh is open or has edges of more than two triangles; a head needs a closed surface. Close its holes "
            "first.");
      before = now;
      now = *next;
    }
    points_.push_back(ends_[1].first);
    if (points_.size() != nodes_.size() + 2)
      throw Error("the mesh has several shells; a head is one closed body. Keep only the outer shell.");
  }

  struct Node {
    Vec2 place;
    std::vector<Key> next;
  };

  Vec2 across_, outwards_;
  double axis_;
  std::map<Key, Node> nodes_;
  std::vector<std::pair<Vec2, Key>> ends_;
  std::vector<Vec2> points_;
};

/// Position [m] along a polyline of the point nearest to x, and its distance [m].
std::pair<double, double> project(const std::vector<Vec2>& line, const Vec2& x) {
  double best = 0, min_distance = std::numeric_limits<double>::infinity(), length = 0;
  for (std::size_t n = 0; n + 1 < line.size(); ++n) {
    const Vec2 along = line[n + 1] - line[n];
    const double size = along.norm();
    if (!(size > 0)) continue;
    const double s = std::clamp(along.dot(x - line[n]) / size, 0.0, size);
    const double distance = (x - line[n] - s / size * along).norm();
    if (distance < min_distance) {
      min_distance = distance;
      best = length + s;
    }
    length += size;
  }
  return {best, min_distance};
}

/// The vertices as points of the meridian, in its order; the vertices of a ring are merged.
std::vector<Vec2> meridian_points(const WeldedMesh& mesh, const std::vector<Vec2>& cut, double ring) {
  std::vector<std::pair<double, Vec2>> along;
  for (const Vec3& v : mesh.vertices) {
    const Vec2 x(v.head<2>().norm(), v.z());
    along.emplace_back(project(cut, x).first, x);
  }
  std::stable_sort(along.begin(), along.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Vec2> points = {cut.front()};
  for (std::size_t n = 0; n < along.size();) {
    Vec2 sum = Vec2::Zero();
    std::size_t end = n;
    for (; end < along.size() && (along[end].second - along[n].second).norm() < ring; ++end) sum += along[end].second;
    points.emplace_back(sum / double(end - n));
    n = end;
  }
  points.push_back(cut.back());
  // If the ends are vertices, the ends of the cut are redundant.
  const auto on_axis = [&](const Vec2& p) { return p.x() < ring; };
  if (points.size() > 3 && on_axis(points[1])) points.erase(points.begin());
  if (points.size() > 3 && on_axis(points[points.size() - 2])) points.pop_back();
  points.front().x() = points.back().x() = 0;
  return points;
}

/// [m] Largest distance between the first cut and all other cuts and vertices.
double spread_of(const std::vector<Cut>& cuts, const WeldedMesh& mesh) {
  const std::vector<Vec2>& first = cuts.front().points();
  double spread = 0;
  for (const Cut& cut : cuts)
    for (const Vec2& x : cut.points()) spread = std::max(spread, project(first, x).second);
  for (const Vec3& v : mesh.vertices) spread = std::max(spread, project(first, {v.head<2>().norm(), v.z()}).second);
  return spread;
}

void require_round(double deviation, double radius, double tolerance) {
  if (deviation > tolerance * radius)
    throw Error("the mesh is not a body of revolution: it is up to " + format_number(deviation / units::mm) +
                " mm off, " + format_number(100 * deviation / radius, 100 * tolerance) +
                " % of its radius; must be at most " + format_number(100 * tolerance, 100 * deviation / radius) +
                " %. Give it more facets, or raise the tolerance.");
}

double deviation_of(const Profile& profile, const WeldedMesh& mesh, const std::vector<Cut>& cuts) {
  ProfileTable outline;
  try {
    outline.exact_pieces = detail::Meridian(profile).pieces();
  } catch (const Error& error) {
    throw Error("the meridian of the mesh is not a valid profile: " + error.sentence());
  }
  const ProfileSprings<double> springs(outline);
  double deviation = 0;
  const auto compare = [&](const Vec2& x) { deviation = std::max(deviation, std::abs(springs.margin(x.x(), x.y()))); };
  for (const Vec3& v : mesh.vertices) compare({v.head<2>().norm(), v.z()});
  for (const Cut& cut : cuts)
    for (std::size_t n = 1; n < cut.points().size(); ++n) compare((cut.points()[n - 1] + cut.points()[n]) / 2);
  return deviation;
}

}  // namespace

RecognizedProfile profile_from_mesh(const TriangleMesh& mesh, const Vec3& towards_shank, double tolerance) {
  require_between(tolerance, 1e-4, 0.1, "profile_from_mesh tolerance [1]");
  if (!(towards_shank.norm() > 0) || !towards_shank.allFinite())
    throw Error("profile_from_mesh towards_shank has no direction; must be a finite vector that is not zero.");
  const Axis axis = find_axis(triangles_of(mesh), towards_shank.normalized());
  const Vec3 side = axis.direction.unitOrthogonal();
  Pose X_MT;
  X_MT.rotation.col(0) = side;
  X_MT.rotation.col(1) = axis.direction.cross(side);
  X_MT.rotation.col(2) = axis.direction;
  X_MT.translation = axis.point;
  WeldedMesh welded = weld(mesh, X_MT.inverse());

  double radius = 0;
  for (const Vec3& v : welded.vertices) radius = std::max(radius, v.head<2>().norm());
  std::vector<Cut> cuts;
  cuts.reserve(kCuts);
  for (int n = 0; n < kCuts; ++n) cuts.emplace_back(welded, kFirstCut + n * kCutAngle, kOnAxis * radius);
  const double tip = cuts.front().points().front().y();

  require_round(spread_of(cuts, welded), radius, tolerance);

  RecognizedProfile found;
  const std::vector<Vec2> points = meridian_points(welded, cuts.front().points(), 1e-4 * radius);
  found.profile = {points.front().y(), detail::fit_lines_and_arcs(points, kFit * radius)};
  ProfileEdge& last = found.profile.edges.back();
  const double before = found.profile.edges.size() > 1 ? found.profile.edges[found.profile.edges.size() - 2].z : tip;
  if (last.radius == 0 && std::abs(last.z - before) < kFit * radius) last.kind = EdgeKind::smooth;

  found.deviation = deviation_of(found.profile, welded, cuts);
  require_round(found.deviation, radius, tolerance);

  const double shift = found.profile.tip;
  found.profile.tip = 0;
  for (ProfileEdge& e : found.profile.edges) e.z -= shift;
  X_MT.translation += shift * axis.direction;
  found.X_MT = X_MT;
  return found;
}

}  // namespace hapticut
