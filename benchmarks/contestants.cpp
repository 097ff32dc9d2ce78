// SPDX-License-Identifier: Apache-2.0
#include "contestants.hpp"

#include <openvdb/openvdb.h>

#include <cstdint>
#include <optional>
#include <stdexcept>

namespace hapticut::bench {
namespace {

/// Indices of the voxels with centres that may lie inside a ball, limited to the block.
struct Range {
  int lo[3], hi[3];
};
Range voxels_around(const Vec3& center, double radius, double h) {
  const double size[3] = {kBlockX, kBlockY, kBlockZ};
  Range range{};
  for (int axis = 0; axis < 3; ++axis) {
    const int count = int(std::lround(size[axis] / h));
    range.lo[axis] = std::max(0, int(std::ceil((center[axis] - radius) / h - 0.5)));
    range.hi[axis] = std::min(count - 1, int(std::floor((center[axis] + radius) / h - 0.5)));
  }
  return range;
}

/// The part of the block that the path can touch, so that dense arrays and voxelised leaves stay small.
Range reachable(const Workload& w) {
  Range all = voxels_around(w.center(0), w.radius, w.voxel_size);
  for (int t = 0; t < w.ticks(); ++t) {
    const Range r = voxels_around(w.center(t), w.radius, w.voxel_size);
    for (int axis = 0; axis < 3; ++axis) {
      all.lo[axis] = std::min(all.lo[axis], r.lo[axis]);
      all.hi[axis] = std::max(all.hi[axis], r.hi[axis]);
    }
  }
  return all;
}

/// Adds the force of a voxel inside the ball.
/// @param x  [mm] of the voxel from the ball's centre, as z and the distance r
/// @return whether the ball removes the voxel
bool press(const Workload& w, double radius, double x, double z, double r, TickResult& out) {
  const double f = (radius - r) / r;
  out.force_x -= f * x;
  out.force_z -= f * z;
  ++out.contact;
  const bool removes = w.removes() && r < 0.5 * radius;
  if (removes) ++out.removed;
  return removes;
}

/// Base of both OpenVDB contestants: a boolean grid with leaves along the whole path of the ball.
class VdbContestant : public Contestant {
 public:
  explicit VdbContestant(const Workload& w)
      : w_(w), grid_(openvdb::BoolGrid::create(false)), accessor_(grid_->getAccessor()) {
    const openvdb::Coord last(int(std::lround(kBlockX / w.voxel_size)) - 1,
                              int(std::lround(kBlockY / w.voxel_size)) - 1,
                              int(std::lround(kBlockZ / w.voxel_size)) - 1);
    grid_->sparseFill(openvdb::CoordBBox(openvdb::Coord(0), last), true, true);
    const Range range = reachable(w);
    for (int i = range.lo[0] & ~7; i <= range.hi[0]; i += 8)
      for (int j = range.lo[1] & ~7; j <= range.hi[1]; j += 8)
        for (int k = range.lo[2] & ~7; k <= range.hi[2]; k += 8) grid_->tree().touchLeaf(openvdb::Coord(i, j, k));
  }

 protected:
  Workload w_;
  openvdb::BoolGrid::Ptr grid_;
  openvdb::BoolGrid::Accessor accessor_;
};

class VdbAccessor final : public VdbContestant {
 public:
  using VdbContestant::VdbContestant;
  TickResult tick(const Vec3& center) override {
    TickResult out;
    const double h = w_.voxel_size * 1e3, radius = w_.radius * 1e3;
    const Vec3 c = center * 1e3;
    const Range range = voxels_around(center, w_.radius, w_.voxel_size);
    for (int i = range.lo[0]; i <= range.hi[0]; ++i)
      for (int j = range.lo[1]; j <= range.hi[1]; ++j)
        for (int k = range.lo[2]; k <= range.hi[2]; ++k) {
          const double x = (i + 0.5) * h - c.x(), y = (j + 0.5) * h - c.y(), z = (k + 0.5) * h - c.z();
          const double r = std::sqrt(x * x + y * y + z * z);
          if (r >= radius) continue;
          const openvdb::Coord ijk(i, j, k);
          if (!accessor_.isValueOn(ijk)) continue;
          if (press(w_, radius, x, z, r, out)) accessor_.setValueOff(ijk, false);
        }
    return out;
  }
};

class VdbLeaf final : public VdbContestant {
 public:
  using VdbContestant::VdbContestant;
  TickResult tick(const Vec3& center) override {
    TickResult out;
    const double h = w_.voxel_size * 1e3, radius = w_.radius * 1e3;
    const Vec3 c = center * 1e3;
    const Range range = voxels_around(center, w_.radius, w_.voxel_size);
    for (int i = range.lo[0] & ~7; i <= range.hi[0]; i += 8)
      for (int j = range.lo[1] & ~7; j <= range.hi[1]; j += 8)
        for (int k = range.lo[2] & ~7; k <= range.hi[2]; k += 8) {
          auto* leaf = accessor_.probeLeaf(openvdb::Coord(i, j, k));
          if (leaf == nullptr) continue;
          for (auto it = leaf->beginValueOn(); it; ++it) {
            const openvdb::Coord at = it.getCoord();
            const double x = (at.x() + 0.5) * h - c.x(), y = (at.y() + 0.5) * h - c.y(), z = (at.z() + 0.5) * h - c.z();
            const double r = std::sqrt(x * x + y * y + z * z);
            if (r >= radius) continue;
            if (press(w_, radius, x, z, r, out)) it.setValueOff();
          }
        }
    return out;
  }
};

/// Base of both dense contestants: 1.0 in solid voxels, rows along x.
class DenseContestant : public Contestant {
 public:
  explicit DenseContestant(const Workload& w) : w_(w), region_(reachable(w)) {
    for (int axis = 0; axis < 3; ++axis) dims_[axis] = region_.hi[axis] - region_.lo[axis] + 1;
    solid_.assign(std::size_t(dims_[0]) * std::size_t(dims_[1]) * std::size_t(dims_[2]), 1.0F);
  }

 protected:
  float* row(int j, int k) {
    return &solid_[(std::size_t(k - region_.lo[2]) * std::size_t(dims_[1]) + std::size_t(j - region_.lo[1])) *
                   std::size_t(dims_[0])];
  }
  Workload w_;
  Range region_;
  int dims_[3] = {};
  std::vector<float> solid_;
};

class Dense final : public DenseContestant {
 public:
  using DenseContestant::DenseContestant;
  TickResult tick(const Vec3& center) override {
    TickResult out;
    const double h = w_.voxel_size * 1e3, radius = w_.radius * 1e3;
    const Vec3 c = center * 1e3;
    const Range range = voxels_around(center, w_.radius, w_.voxel_size);
    for (int k = range.lo[2]; k <= range.hi[2]; ++k)
      for (int j = range.lo[1]; j <= range.hi[1]; ++j) {
        float* solid = row(j, k) - region_.lo[0];
        for (int i = range.lo[0]; i <= range.hi[0]; ++i) {
          const double x = (i + 0.5) * h - c.x(), y = (j + 0.5) * h - c.y(), z = (k + 0.5) * h - c.z();
          const double r2 = x * x + y * y + z * z;
          if (r2 >= radius * radius || solid[i] == 0) continue;
          if (press(w_, radius, x, z, std::sqrt(r2), out)) solid[i] = 0;
        }
      }
    return out;
  }
};

class DenseSimd final : public DenseContestant {
 public:
  using DenseContestant::DenseContestant;
  TickResult tick(const Vec3& center) override {
    const auto h = float(w_.voxel_size * 1e3), radius = float(w_.radius * 1e3);
    const Eigen::Vector3f c = (center * 1e3).cast<float>();
    const Range range = voxels_around(center, w_.radius, w_.voxel_size);
    const float inner = w_.removes() ? 0.25F * radius * radius : -1.0F;
    double force_x = 0, force_z = 0;
    float contact = 0, removed = 0;
    long contacts = 0, removals = 0;
    for (int k = range.lo[2]; k <= range.hi[2]; ++k) {
      const auto z = float((k + 0.5) * w_.voxel_size * 1e3 - center.z() * 1e3);
      for (int j = range.lo[1]; j <= range.hi[1]; ++j) {
        const auto y = float((j + 0.5) * w_.voxel_size * 1e3 - center.y() * 1e3);
        const float rest = radius * radius - y * y - z * z;
        if (rest <= 0) continue;
        const float half = std::sqrt(rest);
        const int first = std::max(range.lo[0], int(std::ceil((c.x() - half) / h - 0.5F)));
        const int last = std::min(range.hi[0], int(std::floor((c.x() + half) / h - 0.5F)));
        float* solid = row(j, k) - region_.lo[0];
        const auto x0 = float(0.5 * w_.voxel_size * 1e3 - center.x() * 1e3);
        float fx = 0, fs = 0;
        contact = removed = 0;
        const bool touches_inner = y * y + z * z < inner;
        for (int i = first; i <= last; ++i) {
          const float x = float(i) * h + x0;
          const float r2 = x * x + y * y + z * z;
          const float r = std::sqrt(r2);
          const float in = r < radius ? solid[i] : 0.0F;
          const float f = in * (radius - r) / r;
          fx += f * x;
          fs += f;
          contact += in;
        }
        if (touches_inner) {
          for (int i = first; i <= last; ++i) {
            const float x = float(i) * h + x0;
            const bool removes = x * x + y * y + z * z < inner;
            removed += removes ? solid[i] : 0.0F;
            solid[i] = removes ? 0.0F : solid[i];
          }
        }
        force_x -= double(fx);
        force_z -= double(fs * z);
        contacts += long(contact);
        removals += long(removed);
      }
    }
    return {force_z, force_x, contacts, removals};
  }
};

/// A proxy of the ball that the voxels stop, on a spring to the ball, and voxels that vanish when it touches them: the
/// rule of CHAI3D's example 28-voxel-basic (version 3.3), which removes one voxel a turn whatever the force is. The
/// proxy advances in steps of a voxel, looks at all voxels around it, and slides along the first that it meets, up to
/// twice.
class Proxy final : public DenseContestant {
 public:
  /// @param removals  voxels that a tick removes at most: those where the proxy was stopped
  Proxy(const Workload& w, int removals) : DenseContestant(w), removals_(removals) {}

  TickResult tick(const Vec3& center) override {
    constexpr int kStops = 3;
    TickResult out;
    const Vec3 goal_of_ball = center;
    if (!placed_) proxy_ = center, placed_ = true;
    Vec3 goal = goal_of_ball;
    for (int stop = 0; stop < kStops && goal != proxy_; ++stop) {
      const std::optional<Stop> met = first_stop(proxy_, goal);
      if (!met) {
        proxy_ = goal;
        break;
      }
      ++out.contact;
      proxy_ = met->at;
      const Vec3 rest = goal_of_ball - proxy_;
      goal = proxy_ + rest - rest.dot(met->normal) * met->normal;
      if (w_.removes() && out.removed < removals_) {
        *met->voxel = 0;
        ++out.removed;
      }
    }
    const Vec3 force = 1e3 * (proxy_ - goal_of_ball);
    out.force_x = force.x(), out.force_z = force.z();
    return out;
  }

 private:
  struct Stop {
    Vec3 at, normal;
    float* voxel;
  };

  /// Where the proxy first meets a voxel, as a ball of 0.7 voxels.
  std::optional<Stop> first_stop(const Vec3& from, const Vec3& to) {
    const double h = w_.voxel_size, reach = w_.radius + 0.9 * h, radius = w_.radius + 0.7 * h;
    const double length = (to - from).norm();
    const Vec3 along = (to - from) / length;
    std::optional<Stop> nearest;
    double nearest_way = length;
    for (double way = std::min(h, length); !nearest; way = std::min(way + h, length)) {
      const Vec3 at = from + way * along;
      const Range range = voxels_around(at, reach, h);
      for (int k = std::max(range.lo[2], region_.lo[2]); k <= std::min(range.hi[2], region_.hi[2]); ++k)
        for (int j = std::max(range.lo[1], region_.lo[1]); j <= std::min(range.hi[1], region_.hi[1]); ++j) {
          float* solid = row(j, k) - region_.lo[0];
          for (int i = std::max(range.lo[0], region_.lo[0]); i <= std::min(range.hi[0], region_.hi[0]); ++i) {
            if (solid[i] == 0) continue;
            const Vec3 voxel = h * Vec3(i + 0.5, j + 0.5, k + 0.5);
            if ((voxel - at).squaredNorm() >= reach * reach) continue;
            const Vec3 away = from - voxel;
            const double half = away.dot(along), root = half * half - away.squaredNorm() + radius * radius;
            if (half >= 0 || root < 0) continue;  // it moves away, or passes by
            const double met = std::max(0.0, -half - std::sqrt(root));
            if (met > nearest_way) continue;
            nearest_way = met;
            const Vec3 stopped = from + met * along;
            nearest = Stop{stopped, (stopped - voxel).normalized(), &solid[i]};
          }
        }
      if (way >= length) break;
    }
    return nearest;
  }

  const int removals_;
  Vec3 proxy_;
  bool placed_ = false;
};

}  // namespace

const std::vector<std::string>& contestant_names() {
  static const std::vector<std::string> names = {"vdb_accessor", "vdb_leaf",  "dense",
                                                 "dense_simd",   "proxy_one", "proxy_three"};
  return names;
}

std::unique_ptr<Contestant> make_contestant(const std::string& name, const Workload& workload) {
  if (name == "vdb_accessor") return std::make_unique<VdbAccessor>(workload);
  if (name == "vdb_leaf") return std::make_unique<VdbLeaf>(workload);
  if (name == "dense") return std::make_unique<Dense>(workload);
  if (name == "dense_simd") return std::make_unique<DenseSimd>(workload);
  if (name == "proxy_one") return std::make_unique<Proxy>(workload, 1);
  if (name == "proxy_three") return std::make_unique<Proxy>(workload, 3);
  throw std::invalid_argument("no contestant '" + name + "'");
}

}  // namespace hapticut::bench
