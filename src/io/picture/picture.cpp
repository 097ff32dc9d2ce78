// SPDX-License-Identifier: Apache-2.0
#include "hapticut/io/picture/picture.hpp"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "io/atomic_file.hpp"
#include "io/picture/blank_picture.hpp"

namespace hapticut {
namespace {

constexpr int kSupersampling = 2;  // samples per pixel along each axis
constexpr double kMargin = 0.06;   // fraction of the picture that stays free on each side of the meshes
constexpr double kAmbient = 0.24;  // light from everywhere
constexpr double kKey = 0.74;      // from the upper left
constexpr double kFill = 0.16;     // from the lower right
constexpr double kShine = 0.12;    // highlight

using Rgb = Eigen::Vector3f;  // linear light, 0 ... 1

float to_linear(std::uint8_t value) { return std::pow(float(value) / 255, 2.2F); }
std::uint8_t to_srgb(float value) {
  return std::uint8_t(std::lround(255 * std::pow(std::clamp(value, 0.0F, 1.0F), 1 / 2.2F)));
}
Rgb to_linear(const Color& color) { return {to_linear(color.red), to_linear(color.green), to_linear(color.blue)}; }

struct Image {
  int width, height;
  std::vector<Rgb> colors;
  std::vector<float> depths;  // [m] along the view

  [[nodiscard]] std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }
};

/// Orthographic camera. The rows of `axes` point right, down and into the scene.
struct Camera {
  Mat3 axes;
  double scale;  // [samples/m]
  Vec3 offset;   // [samples] added to right and down

  [[nodiscard]] Vec3 project(const Vec3& p) const {
    const Vec3 c = axes * p;
    return {scale * c.x() + offset.x(), scale * c.y() + offset.y(), c.z()};
  }
};

Camera framing(const std::vector<ColoredMesh>& meshes, const PictureOptions& options) {
  const Vec3 into = options.view_direction.normalized();
  const Vec3 right = into.cross(options.up).normalized();
  Camera camera;
  camera.axes << right.transpose(), into.cross(right).transpose(), into.transpose();
  Vec3 min = Vec3::Constant(std::numeric_limits<double>::infinity()), max = -min;
  for (const ColoredMesh& mesh : meshes)
    for (const Vec3& v : mesh.mesh.vertices) {
      min = min.cwiseMin(camera.axes * v);
      max = max.cwiseMax(camera.axes * v);
    }
  const double width = kSupersampling * options.width, height = kSupersampling * options.height;
  const double free = 1 - 2 * kMargin;
  camera.scale =
      free * std::min(width / std::max(max.x() - min.x(), 1e-12), height / std::max(max.y() - min.y(), 1e-12));
  camera.offset = Vec3(width, height, 0) / 2 - camera.scale * (min + max) / 2;
  return camera;
}

std::vector<Vec3> vertex_normals(const TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
  for (const auto& t : mesh.triangles) {
    const Vec3 area = (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    for (const std::uint32_t v : t) normals[v] += area;
  }
  for (Vec3& n : normals) n = n.norm() > 0 ? Vec3(n.normalized()) : Vec3(0, 0, 1);
  return normals;
}

/// @param normal  in camera axes (right, down, into)
Rgb shade(const Rgb& color, Vec3 normal) {
  if (normal.z() > 0) normal = -normal;  // the back of an open surface gets the light of its front
  static const Vec3 kKeyLight = Vec3(-0.55, -0.65, -0.75).normalized();
  static const Vec3 kFillLight = Vec3(0.7, 0.3, -0.6).normalized();
  static const Vec3 kHalfway = (kKeyLight + Vec3(0, 0, -1)).normalized();
  const double light =
      kAmbient + kKey * std::max(0.0, normal.dot(kKeyLight)) + kFill * std::max(0.0, normal.dot(kFillLight));
  const double shine = kShine * std::pow(std::max(0.0, normal.dot(kHalfway)), 40);
  return float(light) * color + Rgb::Constant(float(shine));
}

void draw(const ColoredMesh& colored_mesh, const Camera& camera, Image& image) {
  const TriangleMesh& mesh = colored_mesh.mesh;
  const std::vector<Vec3> normals = vertex_normals(mesh);
  std::vector<Vec3> projected;
  projected.reserve(mesh.vertices.size());
  for (const Vec3& v : mesh.vertices) projected.push_back(camera.project(v));
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = projected[t[0]], &b = projected[t[1]], &c = projected[t[2]];
    const double area = (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
    if (area == 0) continue;
    std::array<Vec3, 3> n;
    std::array<Rgb, 3> color;
    for (std::size_t k = 0; k < 3; ++k) {
      n[k] = camera.axes * normals[t[k]];
      color[k] = to_linear(colored_mesh.colors[t[k]]);
    }
    const int x0 = std::max(0, int(std::ceil(std::min({a.x(), b.x(), c.x()}) - 0.5)));
    const int x1 = std::min(image.width - 1, int(std::floor(std::max({a.x(), b.x(), c.x()}) - 0.5)));
    const int y0 = std::max(0, int(std::ceil(std::min({a.y(), b.y(), c.y()}) - 0.5)));
    const int y1 = std::min(image.height - 1, int(std::floor(std::max({a.y(), b.y(), c.y()}) - 0.5)));
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const double px = x + 0.5, py = y + 0.5;
        const double u = ((b.x() - px) * (c.y() - py) - (c.x() - px) * (b.y() - py)) / area;
        const double v = ((c.x() - px) * (a.y() - py) - (a.x() - px) * (c.y() - py)) / area;
        const double w = 1 - u - v;
        if (u < 0 || v < 0 || w < 0) continue;
        const float depth = float(u * a.z() + v * b.z() + w * c.z());
        const std::size_t at = image.at(x, y);
        if (depth >= image.depths[at]) continue;
        image.depths[at] = depth;
        const Vec3 normal = u * n[0] + v * n[1] + w * n[2];
        image.colors[at] = shade(float(u) * color[0] + float(v) * color[1] + float(w) * color[2],
                                 normal.norm() > 0 ? Vec3(normal.normalized()) : Vec3(0, 0, -1));
      }
  }
}

/// Digits and letters of the scale bar, 5 x 7 points; each row is 5 bits, the leftmost point the highest bit.
constexpr std::array<std::pair<char, std::array<std::uint8_t, 7>>, 7> kGlyphs = {{
    {'0', {0b01110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01110}},
    {'1', {0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110}},
    {'2', {0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111}},
    {'5', {0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110}},
    {'m', {0b00000, 0b00000, 0b11010, 0b10101, 0b10101, 0b10101, 0b10101}},
    {'.', {0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b01100, 0b01100}},
    {' ', {0, 0, 0, 0, 0, 0, 0}},
}};

void fill_rectangle(Image& image, int x, int y, int width, int height, const Rgb& color) {
  for (int j = std::max(0, y); j < std::min(image.height, y + height); ++j)
    for (int i = std::max(0, x); i < std::min(image.width, x + width); ++i) image.colors[image.at(i, j)] = color;
}

void draw_scale_bar(double samples_per_m, Image& image) {
  // The longest length of 1, 2 or 5 x 10^n millimetres that fits into a fifth of the width.
  const double max_length = image.width / 5.0 / (samples_per_m * units::mm);
  const double decade = std::pow(10, std::floor(std::log10(max_length)));
  const double length = max_length / decade >= 5 ? 5 * decade : max_length / decade >= 2 ? 2 * decade : decade;
  const int point = std::max(1, image.height / 450);
  const Rgb ink = to_linear(Color{70, 74, 82});
  const int bar = int(std::lround(length * units::mm * samples_per_m));
  const int left = image.width / 40, bottom = image.height - image.height / 30;
  fill_rectangle(image, left, bottom - 3 * point, bar, 3 * point, ink);
  int x = left;
  for (const char letter : format_number(length) + " mm") {
    for (const auto& [name, rows] : kGlyphs)
      for (int row = 0; name == letter && row < 7; ++row)
        for (int column = 0; column < 5; ++column)
          if ((rows[std::size_t(row)] >> (4 - column) & 1) != 0)
            fill_rectangle(image, x + 2 * column * point, bottom - (20 - 2 * row) * point, 2 * point, 2 * point, ink);
    x += 12 * point;
  }
}

std::vector<std::uint8_t> averaged(const Image& image, int width, int height) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(std::size_t(width) * std::size_t(height) * 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      Rgb sum = Rgb::Zero();
      for (int n = 0; n < kSupersampling * kSupersampling; ++n)
        sum += image.colors[image.at(x * kSupersampling + n % kSupersampling, y * kSupersampling + n / kSupersampling)]
                   .cwiseMin(1.0F);
      for (int k = 0; k < 3; ++k) bytes.push_back(to_srgb(sum[k] / (kSupersampling * kSupersampling)));
    }
  return bytes;
}

void require_size(const PictureOptions& options) {
  require_between(options.width, 16, 8192, "PictureOptions::width [pixels]");
  require_between(options.height, 16, 8192, "PictureOptions::height [pixels]");
}

void validate(const std::vector<ColoredMesh>& meshes, const PictureOptions& options) {
  require_size(options);
  if (!is_finite(options.view_direction) || !is_finite(options.up) ||
      !(options.view_direction.normalized().cross(options.up.normalized()).norm() > 1e-6))
    throw Error("PictureOptions::view_direction"_name + " must be finite, not zero and not parallel to " +
                "PictureOptions::up"_name + ".");
  std::size_t triangles = 0;
  for (const ColoredMesh& mesh : meshes) {
    triangles += mesh.mesh.triangles.size();
    if (mesh.colors.size() != mesh.mesh.vertices.size())
      throw Error("a mesh of the picture has " + std::to_string(mesh.mesh.vertices.size()) + " vertices but " +
                  std::to_string(mesh.colors.size()) + " colours; give one colour per vertex.");
    for (const Vec3& v : mesh.mesh.vertices)
      if (!is_finite(v)) throw Error("a mesh of the picture has a vertex that is not finite; repair the mesh.");
    for (const auto& t : mesh.mesh.triangles)
      if (std::max({t[0], t[1], t[2]}) >= mesh.mesh.vertices.size())
        throw Error("a triangle of the picture names a vertex that its mesh does not have.");
  }
  if (triangles == 0) throw Error("there is no triangle to show in the picture.");
}

/// @param pixels  red, green and blue of each pixel, row by row
void write_png(const std::vector<std::uint8_t>& pixels, const PictureOptions& options,
               const std::filesystem::path& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = png_uint_32(options.width);
  png.height = png_uint_32(options.height);
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  std::string bytes;
  bool done = png_image_write_get_memory_size(png, size, 0, pixels.data(), 0, nullptr) != 0;
  if (done) {
    bytes.resize(size);
    done = png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels.data(), 0, nullptr) != 0;
  }
  if (!done) throw Error("cannot write '" + path.string() + "': libpng says " + png.message + ".");
  write_atomically(path, std::string_view(bytes).substr(0, size));
}

}  // namespace

Color material_color(std::string_view name) {
  static const std::pair<const char*, Color> kKnown[] = {
      {"enamel", {238, 234, 222}},     {"dentin", {226, 196, 138}},   {"pulp", {199, 84, 80}},
      {"caries", {112, 82, 58}},       {"decay", {112, 82, 58}},      {"amalgam", {142, 148, 156}},
      {"trabecular", {216, 178, 142}}, {"cortical", {233, 221, 194}}, {"bone", {233, 221, 194}},
      {"clay", {176, 128, 100}},
  };
  for (const auto& [part, color] : kKnown)
    if (name.find(part) != std::string_view::npos) return color;
  static const Color kPalette[] = {{120, 156, 196}, {214, 150, 104}, {134, 176, 126}, {176, 142, 188}, {206, 186, 110}};
  std::size_t sum = 0;  // a name has the same colour in every picture
  for (const char c : name) sum = 31 * sum + static_cast<unsigned char>(c);
  return kPalette[sum % std::size(kPalette)];
}

ColoredMesh colored(const WorkpieceSurface& surface, const MaterialTable& materials) {
  ColoredMesh mesh{surface.mesh, {}};
  std::vector<Color> by_id = {Color{}};
  for (const Material& material : materials.all()) by_id.push_back(material_color(material.name));
  mesh.colors.reserve(surface.materials.size());
  for (const MaterialId id : surface.materials) {
    (void)materials[id];  // throws when it is not in the table
    mesh.colors.push_back(by_id[id]);
  }
  return mesh;
}

void write_picture(const std::vector<ColoredMesh>& meshes, const PictureOptions& options,
                   const std::filesystem::path& path) {
  validate(meshes, options);
  Image image{kSupersampling * options.width, kSupersampling * options.height, {}, {}};
  const std::size_t samples = std::size_t(image.width) * std::size_t(image.height);
  image.colors.assign(samples, to_linear(options.background));
  image.depths.assign(samples, std::numeric_limits<float>::infinity());
  const Camera camera = framing(meshes, options);
  for (const ColoredMesh& mesh : meshes) draw(mesh, camera, image);
  if (options.scale_bar) draw_scale_bar(camera.scale, image);
  write_png(averaged(image, options.width, options.height), options, path);
}

void write_blank_picture(const PictureOptions& options, const std::filesystem::path& path) {
  require_size(options);
  std::vector<std::uint8_t> pixels;
  const Color& color = options.background;
  for (std::int64_t n = 0; n < std::int64_t(options.width) * options.height; ++n)
    pixels.insert(pixels.end(), {color.red, color.green, color.blue});
  write_png(pixels, options, path);
}

}  // namespace hapticut
