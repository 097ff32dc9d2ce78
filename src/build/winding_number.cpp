// SPDX-License-Identifier: Apache-2.0
#include "build/winding_number.hpp"

#include <algorithm>
#include <cmath>

#include "core/interruption.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {
namespace {

constexpr std::uint32_t kLeafTriangles = 8;
constexpr double kFarDistance = 2;  // [radii] beyond this distance a group of triangles is replaced by its expansion
constexpr int kStackDepth = 64;     // twice the depth of a balanced tree over 2^32 triangles

Vec3 centroid(const WindingNumber::Triangle& t) { return (t[0] + t[1] + t[2]) / 3; }
Vec3 area_vector(const WindingNumber::Triangle& t) { return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]); }

/// [sr] signed solid angle of a triangle (Van Oosterom and Strackee 1983), positive when q sees its back.
double solid_angle(const WindingNumber::Triangle& t, const Vec3& q) {
  const Vec3 a = t[0] - q, b = t[1] - q, c = t[2] - q;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double numerator = a.dot(b.cross(c));
  const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return 2 * std::atan2(numerator, denominator);
}

}  // namespace

WindingNumber::WindingNumber(const TriangleMesh& mesh) {
  triangles_.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    triangles_.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  if (triangles_.empty()) return;
  Vec3 middle = Vec3::Zero();
  for (const Triangle& t : triangles_) middle += centroid(t) / double(triangles_.size());
  double volume = 0;  // volume of the cones from the middle, so that holes have little effect
  for (const Triangle& t : triangles_) volume += (centroid(t) - middle).dot(area_vector(t));
  turned_ = volume < 0;
  if (turned_)
    for (Triangle& t : triangles_) std::swap(t[1], t[2]);
  nodes_.reserve(triangles_.size());
  build(0, std::uint32_t(triangles_.size()));
}

void WindingNumber::build(std::uint32_t first, std::uint32_t count) {
  look_for_interruption();
  const std::size_t index = nodes_.size();
  nodes_.emplace_back();
  Node node;
  const auto begin = triangles_.begin() + first, end = begin + count;
  node.min = node.max = (*begin)[0];
  node.dipole = node.center = Vec3::Zero();
  double area = 0;
  for (auto t = begin; t != end; ++t) {
    for (const Vec3& v : *t) {
      node.min = node.min.cwiseMin(v);
      node.max = node.max.cwiseMax(v);
    }
    const Vec3 vector = area_vector(*t);
    node.dipole += vector;
    node.center += vector.norm() * centroid(*t);
    area += vector.norm();
  }
  node.center = area > 0 ? Vec3(node.center / area) : Vec3((node.min + node.max) / 2);
  node.quadrupole = Mat3::Zero();
  node.radius = 0;
  for (auto t = begin; t != end; ++t) {
    const Mat3 moment = (centroid(*t) - node.center) * area_vector(*t).transpose();
    node.quadrupole += (moment + moment.transpose()) / 2;
    for (const Vec3& v : *t) node.radius = std::max(node.radius, (v - node.center).norm());
  }
  node.first = first;
  node.count = count <= kLeafTriangles ? count : 0;
  node.second_child = 0;
  if (node.count == 0) {
    Eigen::Index axis = 0;
    (node.max - node.min).maxCoeff(&axis);
    const auto half = begin + count / 2;
    std::nth_element(begin, half, end, [axis](const Triangle& a, const Triangle& b) {
      return a[0][axis] + a[1][axis] + a[2][axis] < b[0][axis] + b[1][axis] + b[2][axis];
    });
    build(first, count / 2);
    node.second_child = std::uint32_t(nodes_.size());
    build(first + count / 2, count - count / 2);
  }
  nodes_[index] = node;
}

template <class Descends>
void WindingNumber::descend(const Descends& descends) const {
  if (nodes_.empty()) return;
  std::array<std::uint32_t, kStackDepth> stack;
  int depth = 0;
  stack[0] = 0;
  while (depth >= 0) {
    const std::uint32_t index = stack[std::size_t(depth--)];
    if (!descends(nodes_[index])) continue;
    stack[std::size_t(++depth)] = nodes_[index].second_child;
    stack[std::size_t(++depth)] = index + 1;
  }
}

double WindingNumber::at(const Vec3& point) const {
  double sum = 0;  // [sr]
  descend([&](const Node& node) {
    const Vec3 r = node.center - point;
    const double square = r.squaredNorm();
    if (square > kFarDistance * kFarDistance * node.radius * node.radius) {
      const double inverse_cube = 1 / (square * std::sqrt(square));
      sum += inverse_cube * (node.dipole.dot(r) + node.quadrupole.trace() - 3 * r.dot(node.quadrupole * r) / square);
      return false;
    }
    for (std::uint32_t n = 0; n < node.count; ++n) sum += solid_angle(triangles_[node.first + n], point);
    return node.count == 0;
  });
  return sum / (4 * units::kPi);
}

void WindingNumber::append_touching(const Vec3& min, const Vec3& max, std::vector<const Triangle*>& found) const {
  const auto apart = [&](const Vec3& a_min, const Vec3& a_max) {
    return (a_min.array() > max.array()).any() || (a_max.array() < min.array()).any();
  };
  descend([&](const Node& node) {
    if (apart(node.min, node.max)) return false;
    for (std::uint32_t n = 0; n < node.count; ++n) {
      const Triangle& t = triangles_[node.first + n];
      if (!apart(t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2]))) found.push_back(&t);
    }
    return node.count == 0;
  });
}

}  // namespace hapticut
