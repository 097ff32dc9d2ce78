// SPDX-License-Identifier: Apache-2.0
#include "build/repeated_faces.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// A triangle with the smallest corner first, and the others in rising order.
struct SortedTriangle {
  Corners corners;
  bool turned;  // sorting has turned it
  std::uint32_t index;
};

/// All triangles with the same three corners.
struct Group {
  Corners corners;
  std::vector<std::uint32_t> ahead, turned;  // indices of the triangles, by their orientation

  [[nodiscard]] std::size_t size() const { return ahead.size() + turned.size(); }
  [[nodiscard]] bool is_two_sided() const { return !ahead.empty() && ahead.size() == turned.size(); }
};

std::vector<Group> groups_of(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> places = places_of(mesh.vertices);
  std::vector<SortedTriangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    Corners c = {places[mesh.triangles[t][0]], places[mesh.triangles[t][1]], places[mesh.triangles[t][2]]};
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;  // without area
    std::rotate(c.begin(), std::ranges::min_element(c), c.end());
    const bool turned = c[1] > c[2];
    if (turned) std::swap(c[1], c[2]);
    triangles.push_back({c, turned, t});
  }
  std::ranges::sort(triangles, {}, [](const SortedTriangle& t) { return std::pair(t.corners, t.index); });
  std::vector<Group> groups;
  for (const SortedTriangle& t : triangles) {
    if (groups.empty() || groups.back().corners != t.corners) groups.push_back({t.corners, {}, {}});
    (t.turned ? groups.back().turned : groups.back().ahead).push_back(t.index);
  }
  return groups;
}

std::array<std::uint64_t, 3> sides_of(const Group& group) {
  const auto side = [](std::uint32_t a, std::uint32_t b) {
    return std::uint64_t(std::min(a, b)) << 32U | std::max(a, b);
  };
  const Corners& c = group.corners;
  return {side(c[0], c[1]), side(c[1], c[2]), side(c[2], c[0])};
}

/// The groups of one kind that are connected by sides.
using Sheet = std::vector<std::size_t>;

std::vector<Sheet> sheets_of(const std::vector<Group>& groups, const std::vector<std::size_t>& members) {
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> at_side;
  for (const std::size_t n : members)
    for (const std::uint64_t side : sides_of(groups[n])) at_side[side].push_back(n);
  std::vector<Sheet> sheets;
  std::vector<bool> seen(groups.size(), false);
  for (const std::size_t first : members) {
    if (seen[first]) continue;
    seen[first] = true;
    Sheet sheet = {first};
    for (std::size_t n = 0; n < sheet.size(); ++n)
      for (const std::uint64_t side : sides_of(groups[sheet[n]]))
        for (const std::size_t next : at_side[side])
          if (!seen[next]) {
            seen[next] = true;
            sheet.push_back(next);
          }
    sheets.push_back(std::move(sheet));
  }
  return sheets;
}

/// The sides of a sheet: how the rest of the mesh and the sheet meet there.
struct Border {
  std::size_t odd_without = 0;  // sides with an odd number of triangles if no copy is kept
  std::size_t odd_with_one = 0;
  std::size_t odd_with_all = 0;
  bool closed = true;  // one copy of the sheet alone
  bool free = true;    // no other triangle touches a side
};

/// Whether all faces of a sheet lie in a plane across an axis.
bool is_flat(const TriangleMesh& mesh, const std::vector<Group>& groups, const Sheet& sheet) {
  constexpr double kFlat = 1e-6;  // [lengths of the sheet]
  Vec3 low = mesh.vertices[groups[sheet.front()].corners[0]], high = low;
  for (const std::size_t n : sheet)
    for (const std::uint32_t v : groups[n].corners) {
      low = low.cwiseMin(mesh.vertices[v]);
      high = high.cwiseMax(mesh.vertices[v]);
    }
  return (high - low).minCoeff() <= kFlat * (high - low).maxCoeff();
}

class Repetitions {
 public:
  explicit Repetitions(const std::vector<Group>& groups) : groups_(groups) {
    for (const Group& group : groups)
      for (const std::uint64_t side : sides_of(group)) triangles_at_[side] += group.size();
  }

  [[nodiscard]] Border border_of(const Sheet& sheet) const {
    std::unordered_map<std::uint64_t, std::pair<std::size_t, std::size_t>> sides;  // one copy, all copies
    for (const std::size_t n : sheet)
      for (const std::uint64_t side : sides_of(groups_[n])) {
        ++sides[side].first;
        sides[side].second += groups_[n].size();
      }
    Border border;
    for (const auto& [side, count] : sides) {
      const std::size_t rest = triangles_at_.at(side) - count.second;
      border.odd_without += rest % 2;
      border.odd_with_one += (rest + count.first) % 2;
      border.odd_with_all += (rest + count.second) % 2;
      border.closed &= count.first % 2 == 0;
      border.free &= rest == 0;
    }
    return border;
  }

 private:
  const std::vector<Group>& groups_;
  std::unordered_map<std::uint64_t, std::size_t> triangles_at_;  // each side
};

}  // namespace

std::vector<std::uint32_t> places_of(const std::vector<Vec3>& vertices) {
  const auto position = [&](std::uint32_t v) {
    return std::array<double, 3>{vertices[v].x() + 0.0, vertices[v].y() + 0.0, vertices[v].z() + 0.0};  // -0 is 0
  };
  std::vector<std::uint32_t> order(vertices.size()), places(vertices.size());
  for (std::uint32_t v = 0; v < order.size(); ++v) order[v] = v;
  std::ranges::sort(order, {}, position);
  for (std::size_t n = 0; n < order.size(); ++n)
    places[order[n]] = n > 0 && position(order[n]) == position(order[n - 1]) ? places[order[n - 1]] : order[n];
  return places;
}

TriangleMesh without_repeated_faces(TriangleMesh mesh) {
  std::vector<Group> groups = groups_of(mesh);
  if (groups.size() == mesh.triangles.size()) return mesh;
  std::vector<bool> kept(mesh.triangles.size(), false);
  std::vector<std::size_t> two_sided, same_way;
  for (std::size_t n = 0; n < groups.size(); ++n) {
    Group& group = groups[n];
    if (group.is_two_sided()) {
      two_sided.push_back(n);
      continue;
    }
    // Triangles that face each other cancel; the others remain.
    const std::size_t pairs = std::min(group.ahead.size(), group.turned.size());
    group.ahead.erase(group.ahead.begin(), group.ahead.begin() + std::ptrdiff_t(pairs));
    group.turned.erase(group.turned.begin(), group.turned.begin() + std::ptrdiff_t(pairs));
    if (group.size() > 1) same_way.push_back(n);
    for (const auto* indices : {&group.ahead, &group.turned})
      for (const std::uint32_t t : *indices) kept[t] = true;
  }

  const Repetitions repetitions(groups);
  for (const Sheet& sheet : sheets_of(groups, same_way)) {
    const Border border = repetitions.border_of(sheet);
    if (!border.free && border.odd_with_all < border.odd_with_one) continue;  // the others need all copies
    for (const std::size_t n : sheet)
      for (const auto* indices : {&groups[n].ahead, &groups[n].turned})
        for (std::size_t copy = 1; copy < indices->size(); ++copy) kept[(*indices)[copy]] = false;
  }

  const std::vector<Sheet> sheets = sheets_of(groups, two_sided);
  const auto is_alone = [&] { return two_sided.size() == groups.size(); };
  for (const Sheet& sheet : sheets) {
    const Border border = repetitions.border_of(sheet);
    const bool stands_alone = border.free && !border.closed && !is_alone();
    if (stands_alone && !is_flat(mesh, groups, sheet))
      throw Error(
          format_number(double(sheet.size())) +
          " faces of the surface are there twice, once turned (two-sided), and enclose nothing by themselves, so "
          "they may be a body with a hole or a wall; delete one of each two, or both.");
    const bool keeps_one = border.closed || (border.free && !stands_alone) || border.odd_with_one < border.odd_without;
    for (const std::size_t n : sheet) kept[groups[n].ahead.front()] = keeps_one;
  }

  std::vector<Corners> triangles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (kept[t]) triangles.push_back(mesh.triangles[t]);
  mesh.triangles = std::move(triangles);
  return mesh;
}

}  // namespace hapticut
