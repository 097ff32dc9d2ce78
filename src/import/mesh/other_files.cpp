// SPDX-License-Identifier: Apache-2.0
#include "import/mesh/other_files.hpp"

#include <algorithm>

#include "import/mesh/stl_layout.hpp"
#include "io/file_errors.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

constexpr std::string_view kConvert = "save the mesh as STL, PLY, OBJ, OFF or glTF";
constexpr std::string_view kNoMesh = "name a mesh";

struct Kind {
  std::string_view begin;  // start of the file
  std::string_view name;
  std::string_view cure;
};

constexpr Kind kKinds[] = {
    {"# vtk DataFile", "a VTK file", kConvert},  {"Kaydara FBX Binary", "an FBX file", kConvert},
    {"<VTKFile", "a VTK file", kConvert},        {"ISO-10303-21", "a STEP file", kConvert},
    {"%PDF-", "a PDF document", kNoMesh},        {"\x89PNG", "a PNG picture", kNoMesh},
    {"\xff\xd8\xff", "a JPEG picture", kNoMesh}, {"NRRD", "an NRRD volume", "rename it to end in .nrrd"},
    {"\x89HDF", "an HDF5 file", kNoMesh},
};

std::string renamed(std::string_view name, std::string_view extension) {
  return "it is " + std::string(name) + "; rename it to end in " + std::string(extension) + ".";
}

/// Whether the number of triangles that the file announces explains its size.
bool is_binary_stl(std::string_view head, std::uintmax_t size) {
  std::uint32_t triangles = 0;
  if (head.size() < kStlHeader) return false;
  for (std::size_t n = 0; n < 4; ++n)
    triangles |= std::uint32_t(static_cast<unsigned char>(head[kStlHeader - 4 + n])) << (8 * n);
  return triangles > 0 && size == kStlHeader + std::uintmax_t(triangles) * kStlTriangle;
}

}  // namespace

std::string kind_unlike_extension(std::string_view head, std::uintmax_t size, const MeshFormat& own) {
  const std::string_view extension = own.extension;
  if (const std::string archive = archive_instead(head); !archive.empty())
    return own.is_archive ? "" : archive + "; unpack it, and name the mesh in it.";
  for (const Kind& kind : kKinds)
    if (head.starts_with(kind.begin)) return "it is " + std::string(kind.name) + "; " + std::string(kind.cure) + ".";
  if (extension != ".stl" && is_binary_stl(head, size)) return renamed("an STL file", ".stl");
  if (head.starts_with("glTF")) return extension == ".glb" ? "" : renamed("a binary glTF file", ".glb");
  TextLines lines(head.substr(std::min(leading_comments(head).size(), head.size())));
  const std::string_view word = lines.word_of_any_line();
  const std::string lower = lower_case(word);
  if (lower.starts_with("<?xml") || lower.starts_with("<collada"))
    return "it is an XML file; " + std::string(kConvert) + ".";
  if (word.starts_with('{') && head.find("\"asset\"") != std::string_view::npos)
    return extension == ".gltf" ? "" : renamed("a glTF file", ".gltf");
  for (const MeshFormat& format : kMeshFormats)
    if (!word.empty() && std::ranges::find(format.first_words, word) != format.first_words.end())
      return extension == format.extension ? "" : renamed(format.name, format.extension);
  if (extension == ".stl" && !head.empty() && std::ranges::none_of(head, [](char c) {
        return static_cast<unsigned char>(c) < ' ' && std::string_view("\t\r\n\f\v").find(c) == std::string_view::npos;
      }))
    return "it is not an STL file: it is a text that begins with " + in_quotes(word) +
           ", and an STL text begins with 'solid'; get the file itself.";
  return "";
}

}  // namespace hapticut
