// SPDX-License-Identifier: Apache-2.0
// Every builder refuses a request for 10^12 voxels before it allocates anything.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <vector>

#include "hapticut/build/mesh_builder.hpp"
#include "hapticut/build/molar.hpp"
#include "hapticut/build/volume_builders.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/memory_growth.hpp"
#include "support/meshes.hpp"
#include "support/named_material.hpp"
#include "support/refusal.hpp"
#include "support/volumes.hpp"

namespace hapticut::too_many_voxels_test {
namespace {

using test::named;
using units::mm;

constexpr double kEdge = 10 * mm;
constexpr double kVoxel = kEdge / 1e4;  // 10^12 voxels in a cube

template <class Value>
Volume<Value> small_volume() {
  auto volume = test::volume_of<Value>({10, 10, 10}, Vec3::Constant(kEdge / 10));
  volume.values.assign(volume.size(), Value(1));
  return volume;
}

struct Request {
  const char* name;
  std::function<Workpiece()> build;
};

void PrintTo(const Request& request, std::ostream* out) { *out << request.name; }

std::vector<Request> requests() {
  const Box box = {Vec3::Zero(), Vec3::Constant(kEdge)};
  const double infinity = std::numeric_limits<double>::infinity();
  const VolumeBuildOptions tiny{.voxel_size = kVoxel};
  const Material clay = named("clay");
  return {
      {"Block", [=] { return build_block(box, kVoxel, clay); }},
      {"LayeredSlab",
       [=] {
         return build_layered_slab(box, kVoxel, {{clay, kEdge}});
       }},
      {"Sphere", [=] { return build_sphere(Vec3::Zero(), kEdge / 2, kVoxel, clay); }},
      {"Body",
       [=] {
         return build_body(
             {box, [](const Vec3& p) { return p.x() - 5 * mm; }, [](const Vec3&) { return MaterialId(1); }}, kVoxel,
             MaterialTable({clay}));
       }},
      {"Molar", [=] { return build_molar(kVoxel); }},
      {"Labels",
       [=] {
         return build_from_labels(small_volume<std::uint16_t>(), {{{1}, clay}}, tiny);
       }},
      {"Grey",
       [=] {
         return build_from_grey(small_volume<float>(), {{0.5, infinity, clay}}, tiny);
       }},
      {"Grade",
       [=] {
         return build_from_grey(small_volume<float>(), Grade{0, 2, named("soft"), named("hard")}, tiny);
       }},
      {"Mesh",
       [=] {
         return build_from_mesh(test::cube_mesh(Vec3::Zero(), kEdge, 2), clay, {kVoxel, 4});
       }},
  };
}

class TooManyVoxels : public testing::TestWithParam<Request> {};

TEST_P(TooManyVoxels, AreRefusedWithTheirNumberBeforeAnythingIsAllocated) {
  const test::MemoryGrowth growth;
  test::expect_refused([] { (void)GetParam().build(); }, {"e+1", "larger voxel size"});
  EXPECT_LT(growth.bytes(), 50e6);
}

INSTANTIATE_TEST_SUITE_P(Builders, TooManyVoxels, testing::ValuesIn(requests()),
                         [](const auto& request) { return std::string(request.param.name); });

}  // namespace
}  // namespace hapticut::too_many_voxels_test
