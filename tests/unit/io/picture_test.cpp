// SPDX-License-Identifier: Apache-2.0
#include "hapticut/io/picture/picture.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <limits>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/meshes.hpp"
#include "support/no_disk_space.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::picture_test {
namespace {

using test::TemporaryFolder;
using units::mm;

struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;

  [[nodiscard]] Color at(int x, int y) const {
    const std::size_t n = 3 * (std::size_t(y) * std::size_t(width) + std::size_t(x));
    return {bytes[n], bytes[n + 1], bytes[n + 2]};
  }
  [[nodiscard]] int brightness(int x, int y) const { return at(x, y).red + at(x, y).green + at(x, y).blue; }
};

Pixels read_png(const std::filesystem::path& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_file(&png, path.c_str()), 0) << png.message;
  png.format = PNG_FORMAT_RGB;
  Pixels pixels{int(png.width), int(png.height), std::vector<std::uint8_t>(PNG_IMAGE_SIZE(png))};
  EXPECT_NE(png_image_finish_read(&png, nullptr, pixels.bytes.data(), 0, nullptr), 0) << png.message;
  return pixels;
}

ColoredMesh ball(const Vec3& center, double radius, const Color& color) {
  ColoredMesh mesh{test::ball_mesh(center, radius, 32), {}};
  mesh.colors.assign(mesh.mesh.vertices.size(), color);
  return mesh;
}

PictureOptions small_picture() {
  PictureOptions options;
  options.width = 160;
  options.height = 120;
  options.view_direction = {0, 1, 0};
  options.scale_bar = false;
  return options;
}

TEST(Picture, ShowsABallRoundFramedAndLitFromTheUpperLeft) {
  const TemporaryFolder folder;
  write_picture({ball(Vec3(5, 6, 7) * mm, 2 * mm, {200, 200, 200})}, small_picture(), folder / "ball.png");
  const Pixels pixels = read_png(folder / "ball.png");
  ASSERT_EQ(pixels.width, 160);
  ASSERT_EQ(pixels.height, 120);
  const Color background = PictureOptions{}.background;
  int left = 160, right = -1, top = 120, bottom = -1;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 160; ++x)
      if (!(pixels.at(x, y) == background)) {
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
      }
  EXPECT_NEAR(right - left, bottom - top, 1);
  EXPECT_NEAR(left + right, 159, 1);  // centred
  EXPECT_NEAR(top + bottom, 119, 1);
  EXPECT_GT(bottom - top, 95);
  EXPECT_GT(pixels.brightness(60, 40), pixels.brightness(100, 80) + 60);
}

TEST(Picture, ANearerSurfaceHidesAFartherOne) {
  const TemporaryFolder folder;
  const ColoredMesh red = ball(Vec3(0, 5, 0) * mm, 2 * mm, {220, 30, 30});
  const ColoredMesh blue = ball(Vec3(0, -5, 0) * mm, 1 * mm, {30, 30, 220});
  for (const auto& meshes : {std::vector{red, blue}, {blue, red}}) {
    write_picture(meshes, small_picture(), folder / "two.png");
    const Pixels pixels = read_png(folder / "two.png");
    EXPECT_GT(pixels.at(80, 60).blue, pixels.at(80, 60).red);
    EXPECT_GT(pixels.at(80, 20).red, pixels.at(80, 20).blue);
  }
}

TEST(Picture, UpIsUpAndRightIsRight) {
  const TemporaryFolder folder;
  // Seen along +y with z up, +x is to the right.
  write_picture({ball(Vec3(0, 0, 0), 1 * mm, {200, 200, 200}), ball(Vec3(4, 0, 0) * mm, 1 * mm, {220, 30, 30}),
                 ball(Vec3(0, 0, 4) * mm, 1 * mm, {30, 30, 220})},
                small_picture(), folder / "three.png");
  const Pixels pixels = read_png(folder / "three.png");
  const double scale = 0.88 * 120 / 6;  // pixels per mm; the meshes reach from -1 to 5 mm
  const auto at = [&](double x, double z) { return pixels.at(int(80 + (x - 2) * scale), int(60 - (z - 2) * scale)); };
  EXPECT_GT(at(4, 0).red, 2 * at(4, 0).blue);
  EXPECT_GT(at(0, 4).blue, 2 * at(0, 4).red);
}

TEST(Picture, ASurfaceTakesTheColorsOfItsMaterials) {
  Material enamel, dentin;
  enamel.name = "enamel";
  dentin.name = "dentin";
  const Workpiece slab =
      build_layered_slab({Vec3::Zero(), Vec3(2, 2, 2) * mm}, 0.1 * mm, {{enamel, 1 * mm}, {dentin, 1 * mm}});
  const ColoredMesh mesh = colored(extract_surface(slab), slab.materials());
  ASSERT_EQ(mesh.colors.size(), mesh.mesh.vertices.size());
  for (std::size_t n = 0; n < mesh.colors.size(); ++n) {
    const double z = mesh.mesh.vertices[n].z();
    if (std::abs(z - 1 * mm) < 0.06 * mm) continue;  // within half a voxel of the interface both are right
    EXPECT_EQ(mesh.colors[n], material_color(z > 1 * mm ? "enamel" : "dentin"));
  }
  EXPECT_NE(material_color("enamel"), material_color("dentin"));
  EXPECT_EQ(material_color("something else"), material_color("something else"));
}

TEST(Picture, TheScaleBarIsDrawnInTheCorner) {
  const TemporaryFolder folder;
  PictureOptions options = small_picture();
  options.scale_bar = true;
  write_picture({ball(Vec3::Zero(), 2 * mm, {200, 200, 200})}, options, folder / "bar.png");
  const Pixels pixels = read_png(folder / "bar.png");
  int dark = 0;
  for (int x = 0; x < 40; ++x) dark += pixels.brightness(x, 115) < 400 ? 1 : 0;
  // The bar is 1 mm long; the 4 mm of the ball fill 88 % of 120 pixels.
  EXPECT_NEAR(dark, 0.88 * 120 / 4, 2);
}

TEST(Picture, InvalidPicturesAndPathsAreRefused) {
  const TemporaryFolder folder;
  const ColoredMesh good = ball(Vec3::Zero(), 1 * mm, {200, 200, 200});
  const auto refuses = [&](const std::vector<ColoredMesh>& meshes, const PictureOptions& options) {
    EXPECT_THROW(write_picture(meshes, options, folder / "no.png"), Error);
  };
  refuses({}, small_picture());
  ColoredMesh bad = good;
  bad.colors.pop_back();
  refuses({bad}, small_picture());
  bad = good;
  bad.mesh.vertices[0].x() = std::numeric_limits<double>::quiet_NaN();
  refuses({bad}, small_picture());
  bad = good;
  bad.mesh.triangles[0][0] = 1'000'000;
  refuses({bad}, small_picture());
  PictureOptions options = small_picture();
  options.up = options.view_direction;
  refuses({good}, options);
  options = small_picture();
  options.width = 0;
  refuses({good}, options);
  {
    const test::NoDiskSpace no_space;
    refuses({good}, small_picture());
  }
  EXPECT_EQ(folder.file_count(), 0U);
}

}  // namespace
}  // namespace hapticut::picture_test
