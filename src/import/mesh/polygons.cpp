// SPDX-License-Identifier: Apache-2.0
#include "import/mesh/polygons.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <unordered_map>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

using Place = std::array<double, 3>;

struct HashOfPlace {
  std::size_t operator()(const Place& place) const {
    std::uint64_t hash = 0;
    for (const double coordinate : place) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x9e3779b97f4a7c15ULL;
      hash ^= hash >> 32U;
    }
    return std::size_t(hash);
  }
};

/// Turns the objects of a file into meshes, one after the other.
class Welder {
 public:
  Welder(const std::vector<Vec3>& vertices, double unit)
      : vertices_(vertices), unit_(unit), welded_(vertices.size()), object_of_(vertices.size(), 0) {}

  TriangleMesh mesh_of(const PolygonObject& object) {
    ++object_;
    index_.clear();
    TriangleMesh mesh;
    std::size_t begin = 0;
    for (const std::size_t end : object.ends) {
      // Polygons become fans. The triangles of a non-convex polygon overlap with opposite signs, so volumes and winding
      // numbers stay correct.
      std::array<std::uint32_t, 3> triangle{};
      for (std::size_t n = begin; n < end; ++n) {
        const std::uint32_t v = weld(object.corners[n], mesh);
        triangle[std::min<std::size_t>(n - begin, 2)] = v;
        if (n - begin < 2) continue;
        if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
          mesh.triangles.push_back(triangle);
        triangle[1] = v;
      }
      begin = end;
    }
    return mesh;
  }

 private:
  std::uint32_t weld(std::uint32_t v, TriangleMesh& mesh) {
    if (object_of_[v] == object_) return welded_[v];
    const Vec3& p = vertices_[v];
    if (!is_finite(p))
      throw Error("vertex " + std::to_string(v + 1) +
                  " of a face has a coordinate that is not a finite number; repair the mesh.");
    const Place place = {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};  // -0 is 0
    const auto [entry, is_new] = index_.try_emplace(place, std::uint32_t(mesh.vertices.size()));
    if (is_new) mesh.vertices.emplace_back(unit_ * p);
    object_of_[v] = object_;
    return welded_[v] = entry->second;
  }

  const std::vector<Vec3>& vertices_;
  double unit_;
  std::vector<std::uint32_t> welded_;     // index in the mesh of object `object_of_`
  std::vector<std::uint32_t> object_of_;  // last object that used a vertex
  std::uint32_t object_ = 0;
  std::unordered_map<Place, std::uint32_t, HashOfPlace> index_;
};

}  // namespace

void turn_to_patient_axes(Polygons& polygons, std::string_view header) {
  constexpr std::string_view kKey = "SPACE=";
  constexpr std::size_t kAxes = 3;
  const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
  for (std::size_t at = header.find(kKey); at != std::string_view::npos; at = header.find(kKey, at + 1)) {
    if (at > 0 && is_letter(header[at - 1])) continue;  // part of another word
    std::string_view space = header.substr(at + kKey.size());
    space = space.substr(0, std::size_t(std::ranges::find_if_not(space, is_letter) - space.begin()));
    if (space.size() != kAxes || space.find_first_not_of("LRPASI") != std::string_view::npos || space == "LPS")
      continue;
    if (space != "RAS")
      throw Error("its header names the space " + std::string(space) +
                  "; supported are LPS and RAS, so save it in one of these.");
    for (Vec3& vertex : polygons.vertices) vertex = Vec3(-vertex.x(), -vertex.y(), vertex.z());
    return;
  }
}

std::vector<NamedMesh> to_meshes(const Polygons& polygons, double unit) {
  Welder welder(polygons.vertices, unit);
  std::vector<NamedMesh> meshes;
  for (const PolygonObject& object : polygons.objects) {
    TriangleMesh mesh = welder.mesh_of(object);
    if (!mesh.triangles.empty()) meshes.push_back({object.name, std::move(mesh)});
  }
  if (meshes.size() > 1)
    for (std::size_t n = 0; n < meshes.size(); ++n)
      if (meshes[n].name.empty()) meshes[n].name = "object " + std::to_string(n + 1);
  return meshes;
}

}  // namespace hapticut
