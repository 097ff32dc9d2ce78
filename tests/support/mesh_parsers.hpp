// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "import/mesh/mesh_formats.hpp"
#include "support/mesh_measures.hpp"
#include "support/refusal.hpp"

/// @file
/// Calls the readers of mesh formats with texts.
namespace hapticut::test {

using Parser = Polygons (*)(std::string_view);

inline std::vector<NamedMesh> meshes_in(Parser parse, const std::string& text) { return to_meshes(parse(text), 1); }

inline TriangleMesh only_mesh_in(Parser parse, const std::string& text) {
  const std::vector<NamedMesh> meshes = meshes_in(parse, text);
  EXPECT_EQ(meshes.size(), 1U);
  return meshes.empty() ? TriangleMesh{} : meshes[0].mesh;
}

inline std::string error_of(Parser parse, const std::string& text) {
  return refusal([&] { return meshes_in(parse, text); });
}

/// A text, and a part of the expected message.
struct BadText {
  std::string text;
  const char* said;
};

inline void expect_all_refused(Parser parse, const std::vector<BadText>& texts) {
  for (const BadText& bad : texts) {
    SCOPED_TRACE(bad.text);
    expect_part(error_of(parse, bad.text), bad.said);
  }
}

inline void expect_unit_cube(const TriangleMesh& mesh) {
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_TRUE(test::is_closed(mesh));
  EXPECT_DOUBLE_EQ(test::signed_volume(mesh), 1);
}

inline std::string replaced(const std::string& text, const std::string& from, const std::string& to) {
  std::string result;
  std::size_t at = 0;
  for (std::size_t found = text.find(from); found != std::string::npos; found = text.find(from, at)) {
    result.append(text, at, found - at);
    result += to;
    at = found + from.size();
  }
  return result.append(text, at);
}

}  // namespace hapticut::test
