// SPDX-License-Identifier: Apache-2.0
#include <zlib.h>

#include <bit>
#include <locale>
#include <memory>
#include <ostream>
#include <sstream>
#include <vector>

#include "hapticut/core/units.hpp"
#include "hapticut/import/volume/volumes.hpp"
#include "import/volume/density_file.hpp"
#include "io/atomic_file.hpp"

namespace hapticut {
namespace {

static_assert(std::endian::native == std::endian::little, "the header below says that the values are little-endian");

/// The header of values in gzip format. Numbers are in the classic locale, with all digits.
template <class Value>
std::string header_of(const Volume<Value>& volume, const char* type) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  const auto vector = [&](const Vec3& v) { text << '(' << v.x() << ',' << v.y() << ',' << v.z() << ')'; };
  text << "NRRD0004\ntype: " << type << "\ndimension: 3\nspace: left-posterior-superior\nsizes: " << volume.dims[0]
       << ' ' << volume.dims[1] << ' ' << volume.dims[2] << "\nspace directions:";
  for (int axis = 0; axis < 3; ++axis) {
    text << ' ';
    vector(volume.X_WG.rotation.col(axis) * (volume.spacing[axis] / units::mm));
  }
  text << "\nkinds: domain domain domain\nspace units: \"mm\" \"mm\" \"mm\"\nendian: little\nencoding: gzip\nspace "
          "origin: ";
  vector(volume.X_WG.translation / units::mm);
  text << "\n\n";
  return text.str();
}

/// Writes bytes in gzip format.
void write_gzip(std::ostream& stream, const void* data, std::size_t size) {
  constexpr int kFast = 3;  // twice as fast as the default, a few per cent larger
  z_stream zip{};
  if (deflateInit2(&zip, kFast, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK) throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&zip, deflateEnd);
  constexpr std::size_t kPiece = std::size_t(1) << 20U;
  std::vector<Bytef> out(kPiece);
  const auto* in = static_cast<const Bytef*>(data);
  for (bool last = false; !last;) {
    const std::size_t give = std::min(kPiece, size);
    zip.next_in = const_cast<Bytef*>(in);  // zlib does not modify it
    zip.avail_in = uInt(give);
    in += give;
    size -= give;
    last = size == 0;
    do {
      zip.next_out = out.data();
      zip.avail_out = uInt(out.size());
      (void)deflate(&zip, last ? Z_FINISH : Z_NO_FLUSH);
      stream.write(reinterpret_cast<const char*>(out.data()), std::streamsize(out.size() - zip.avail_out));
    } while (zip.avail_out == 0);
  }
}

template <class Value>
void write(const std::filesystem::path& path, const Volume<Value>& volume, const char* type) {
  require_valid(volume);
  write_atomically(path, [&](std::ostream& stream) {
    stream << header_of(volume, type);
    write_gzip(stream, volume.values.data(), volume.values.size() * sizeof(Value));
  });
}

/// An empty volume that covers all voxels of a workpiece.
template <class Value>
Volume<Value> volume_around(const Workpiece& workpiece) {
  const IndexBox box = workpiece.bounds();
  if (box.empty()) throw Error("the workpiece is empty; there is nothing to write as a volume.");
  if (box.voxels() > kMaxVolumeSamples)
    throw Error("the workpiece spans " + format_number(double(box.voxels())) + " voxels; at most " +
                format_number(double(kMaxVolumeSamples)) + " fit a dense volume. Save it as .vdb instead.");
  Volume<Value> volume;
  for (int axis = 0; axis < 3; ++axis) volume.dims[axis] = box.max[axis] - box.min[axis] + 1;
  volume.spacing.setConstant(workpiece.voxel_size());
  volume.X_WG = {workpiece.frame().X_WV.rotation, workpiece.frame().center(box.min)};
  volume.values.resize(volume.size());
  return volume;
}

/// Calls `set(value of the volume, block, index in the block)` for every voxel that is not empty.
template <class Value, class Set>
void copy_voxels(const Workpiece& workpiece, Volume<Value>& volume, const Set& set) {
  const IndexBox box = workpiece.bounds();
  workpiece.for_each_block([&](const BlockView& block) {
    for (int n = 0; n < kBlockVoxels; ++n) {
      if (!block.is_solid(n)) continue;
      const VoxelIndex at = voxel_at(block.origin, n);
      const int i = at[0] - box.min[0], j = at[1] - box.min[1], k = at[2] - box.min[2];
      if (i < 0 || j < 0 || k < 0 || i >= volume.dims[0] || j >= volume.dims[1] || k >= volume.dims[2]) continue;
      set(volume.at(i, j, k), block, n);
    }
  });
}

}  // namespace

void write_nrrd(const GreyVolume& volume, const std::filesystem::path& path) { write(path, volume, "float"); }

void write_nrrd(const LabelVolume& volume, const std::filesystem::path& path) { write(path, volume, "uint16"); }

void write_nrrd(const Workpiece& workpiece, const std::filesystem::path& path) {
  auto materials = volume_around<std::uint16_t>(workpiece);
  copy_voxels(workpiece, materials,
              [](std::uint16_t& value, const BlockView& block, int n) { value = block.material_of(n); });
  auto fills = volume_around<float>(workpiece);
  copy_voxels(workpiece, fills, [](float& value, const BlockView& block, int n) {
    value = block.fill != nullptr ? block.fill[n] : 1.0F;
  });
  write_nrrd(fills, density_file(path));
  write_nrrd(materials, path);
}

}  // namespace hapticut
