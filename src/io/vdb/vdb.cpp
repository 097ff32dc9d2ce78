// SPDX-License-Identifier: Apache-2.0
#include "hapticut/io/vdb/vdb.hpp"

#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <sys/mman.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <sstream>

#include "core/lack_of_memory.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/workpiece/openvdb.hpp"
#include "io/atomic_file.hpp"
#include "io/file_errors.hpp"
#include "io/text_lines.hpp"
#include "io/vdb/vdb_bytes.hpp"
#include "io/vdb/vdb_check.hpp"
#include "workpiece/grids.hpp"
#include "workpiece/state.hpp"

namespace hapticut {
namespace {

constexpr double kUnit = 1e-3;  // [m] the world unit of the files: OpenVDB refuses voxels below 14 um in metres
constexpr int kFormat = 2;      // increased when another version could misread a file; 1 was never released
constexpr char kFormatKey[] = "hapticut_format";
constexpr char kUnitKey[] = "hapticut_unit_m";
constexpr char kVoxelSizeKey[] = "hapticut_voxel_size_m";
constexpr char kPoseKey[] = "hapticut_X_WV_m";
constexpr char kMaterialsKey[] = "hapticut_materials";
constexpr char kFieldsKey[] = "hapticut_material_fields";

std::string key_of(int id, const char* field) { return "hapticut_material_" + std::to_string(id) + "_" + field; }

template <class Value>
void write_meta(openvdb::MetaMap& meta, const std::string& key, const Value& value) {
  meta.insertMeta(key, openvdb::TypedMetadata<Value>(value));
}
template <NamedEnum Value>
void write_meta(openvdb::MetaMap& meta, const std::string& key, const std::optional<Value>& value) {
  write_meta(meta, key, std::string(value ? name_or_null(*value) : ""));
}

openvdb::Mat4d matrix_of(const Pose& pose) {
  openvdb::Mat4d matrix = openvdb::Mat4d::identity();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      matrix(row, column) = pose.rotation(column, row);
      matrix(3, column) = pose.translation[column];
    }
  return matrix;
}

Pose pose_of(const openvdb::Mat4d& matrix) {
  Pose pose;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      pose.rotation(column, row) = matrix(row, column);
      pose.translation[column] = matrix(3, column);
    }
  return pose;
}

void describe(const Workpiece& workpiece, openvdb::MetaMap& meta) {
  write_meta(meta, kFormatKey, kFormat);
  write_meta(meta, kUnitKey, kUnit);
  write_meta(meta, kVoxelSizeKey, workpiece.voxel_size());
  write_meta(meta, kPoseKey, matrix_of(workpiece.frame().X_WV));
  write_meta(meta, kMaterialsKey, int(workpiece.materials().size()));
  std::string fields;
  for_each_field<Material>([&](const auto& field) { append_item(fields, field.name); });
  write_meta(meta, kFieldsKey, fields);
  int id = 0;
  for (const Material& material : workpiece.materials().all()) {
    ++id;
    for_each_field<Material>(
        [&](const auto& field) { write_meta(meta, key_of(id, field.name), material.*field.member); });
  }
}

/// Writes through a checked stream, with the table of offsets that lets other programs load single grids.
class FileWriter : public openvdb::io::Stream {
 public:
  void write_file(std::ostream& stream, const openvdb::GridCPtrVec& grids) const {
    openvdb::MetaMap meta;
    meta.insertMeta("creator", openvdb::StringMetadata("hapticut"));
    openvdb::io::Archive::write(stream, grids, /*seekable=*/true, meta);
  }
};

/// Runs a part of the reading.
/// @throws Error whose message calls the file "it"
template <class Function>
auto reading(const Function& function) {
  try {
    return function();
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    if (is_lack_of_memory(error)) throw Error("there is not enough memory for it; it is too large or damaged.");
    throw Error(std::string("it is damaged, or not a supported .vdb file (OpenVDB: ") + error.what() +
                "); get a complete copy, or save it again with the program that wrote it.");
  }
}

/// The content of a file: grids usable for a workpiece, and the names of all grids.
struct VdbFile {
  openvdb::GridPtrVec grids;
  std::vector<VdbEntry> entries;
};

/// Deletes the nodes of grids at its end, see `delete_nodes`.
class NodesOf {
 public:
  explicit NodesOf(const VdbFile& file) : file_(file) {}
  ~NodesOf() {
    for (const auto& grid : file_.grids) {
      if (const auto floats = openvdb::gridPtrCast<openvdb::FloatGrid>(grid)) delete_nodes(floats->tree());
      if (const auto integers = openvdb::gridPtrCast<openvdb::Int32Grid>(grid)) delete_nodes(integers->tree());
    }
  }
  NodesOf(const NodesOf&) = delete;
  NodesOf& operator=(const NodesOf&) = delete;

 private:
  const VdbFile& file_;
};

/// Tries whether memory can be had, because the decompressor of OpenVDB writes to address 0 where it is lacking.
/// @throws std::bad_alloc
void require_memory(std::uint64_t bytes) {
  constexpr std::uint64_t kForPacking = std::uint64_t(32) << 20U;  // [bytes] buffers of the (de)compressor
  const std::uint64_t all = bytes + kForPacking;
  void* const place = ::mmap(nullptr, all, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (place == MAP_FAILED) throw std::bad_alloc();
  ::munmap(place, all);
}

VdbFile read_grids(std::string bytes) {
  openvdb::initialize();
  VdbFile file;
  require_memory(0);
  file.entries = check_vdb(bytes);
  std::uint64_t trees = 0;  // [bytes]
  for (const VdbEntry& entry : file.entries) trees += entry.memory;
  require_memory(trees);
  std::istringstream stream(std::move(bytes), std::ios_base::binary);
  // OpenVDB does not check the state of the stream after reading.
  stream.exceptions(std::ios_base::failbit | std::ios_base::badbit | std::ios_base::eofbit);
  openvdb::io::Stream archive(stream, /*delayLoad=*/false);
  if (const auto grids = archive.getGrids()) file.grids = *grids;
  return file;
}

std::string list_of(const VdbFile& file) {
  std::string list;
  for (const VdbEntry& entry : file.entries) append_item(list, "'" + entry.name + "' (" + entry.type + ")", ", ");
  return list.empty() ? "no grid at all" : list;
}

template <class Grid>
typename Grid::Ptr require_grid(const VdbFile& file, const char* name) {
  for (const auto& grid : file.grids)
    if (grid && grid->getName() == name && grid->isType<Grid>()) return openvdb::gridPtrCast<Grid>(grid);
  throw Error(std::string("there is no grid '") + name + "' (" + Grid().valueType() + ") in it; it has " +
              list_of(file) + ". A file of another program needs " + "VdbImport::material"_name + ".");
}

template <class Value>
Value require_meta(const openvdb::MetaMap& meta, const std::string& key) {
  const auto entry = meta.getMetadata<openvdb::TypedMetadata<Value>>(key);
  if (!entry)
    throw Error("its grid 'material' lacks the metadata '" + key +
                "'; hapticut did not write it, or another program dropped it.");
  return entry->value();
}

template <class Value>
void read_meta(const openvdb::MetaMap& meta, const std::string& key, Value& value) {
  value = require_meta<Value>(meta, key);
}
template <NamedEnum Value>
void read_meta(const openvdb::MetaMap& meta, const std::string& key, std::optional<Value>& value) {
  const std::string name = require_meta<std::string>(meta, key);
  value = value_named<Value>(name);
  if (!name.empty() && !value)
    throw Error("its '" + key + "' is \"" + name + "\"; it must be one of " + list_of_names<Value>() + ", or empty.");
}

/// The fields of each material in a file.
/// @throws Error when a field is unknown
std::vector<std::string> fields_in(const openvdb::MetaMap& meta) {
  std::vector<std::string> names = items_of(require_meta<std::string>(meta, kFieldsKey));
  for (const std::string& name : names) {
    bool known = false;
    for_each_field<Material>([&](const auto& field) { known |= name == field.name; });
    if (!known)
      throw Error("its materials have a '" + name +
                  "', which this version of hapticut does not know; use a newer version.");
  }
  return names;
}

MaterialTable read_materials(const openvdb::MetaMap& meta) {
  const auto count = require_meta<std::int32_t>(meta, kMaterialsKey);
  if (count < 1 || count > kMaxMaterials)
    throw Error("it names " + std::to_string(count) + " materials; 1 to 255 are allowed.");
  const std::vector<std::string> fields = fields_in(meta);
  MaterialTable materials;
  for (int id = 1; id <= count; ++id) {
    Material material;
    for_each_field<Material>([&](const auto& field) {
      if (std::find(fields.begin(), fields.end(), field.name) != fields.end())
        read_meta(meta, key_of(id, field.name), material.*field.member);
    });
    materials.add(std::move(material));
  }
  return materials;
}

/// The exact saved frame, unless another program has moved or scaled the grid.
GridFrame read_frame(const openvdb::GridBase& grid) {
  GridFrame saved;
  saved.voxel_size = require_meta<double>(grid, kVoxelSizeKey);
  saved.X_WV = pose_of(require_meta<openvdb::Mat4d>(grid, kPoseKey));
  const double unit = require_meta<double>(grid, kUnitKey);
  const GridFrame now = frame_of(grid.transform(), unit);
  const double tolerance = 1e-9;  // rounding of the transform
  const bool same = std::abs(now.voxel_size - saved.voxel_size) <= tolerance * saved.voxel_size &&
                    (now.X_WV.rotation - saved.X_WV.rotation).cwiseAbs().maxCoeff() <= tolerance &&
                    (now.X_WV.translation - saved.X_WV.translation).norm() <=
                        tolerance * (saved.X_WV.translation.norm() + saved.voxel_size);
  return same ? saved : now;
}

void check_values(const openvdb::FloatTree& density, const openvdb::Int32Tree& ids, const MaterialTable& materials) {
  if (!density.hasSameTopology(ids))
    throw Error(
        "its grids 'density' and 'material' do not cover the same voxels; another program changed one of them.");
  for (auto tile = ids.root().cbeginValueOn(); tile; ++tile)
    throw Error("its grid 'material' has a solid region of more than 4096^3 voxels.");
  for (auto value = ids.cbeginValueOn(); value; ++value)
    if (*value < 1 || *value > materials.size())
      throw Error("a voxel has material id " + std::to_string(*value) + ", but the file names only " +
                  std::to_string(materials.size()) + " materials.");
  for (auto value = density.cbeginValueOn(); value; ++value)
    if (!(*value >= 0 && *value <= 1) || (value.isTileValue() && *value != 1))
      throw Error("a voxel has density " + format_number(double(*value)) +
                  "; a filled fraction must be within 0 ... 1, and 1 in uniform regions.");
}

void copy_fill(const openvdb::FloatTree& density, FillTree& fill) {
  for (auto leaf = density.cbeginLeaf(); leaf; ++leaf) {
    bool full = true;
    for (auto voxel = leaf->cbeginValueOn(); voxel; ++voxel) full &= *voxel == 1;
    if (full) continue;
    auto copy = std::make_unique<Leaf<FillTree>>(leaf->origin(), 0.0F, true);
    for (auto voxel = leaf->cbeginValueOn(); voxel; ++voxel) copy->setValueOnly(voxel.pos(), *voxel);
    fill.addLeaf(copy.release());
  }
}

Workpiece parse(std::string bytes) {
  const VdbFile file = read_grids(std::move(bytes));
  const NodesOf nodes(file);
  const auto density = require_grid<openvdb::FloatGrid>(file, "density");
  const auto material = require_grid<openvdb::Int32Grid>(file, "material");
  const auto centroid = require_grid<openvdb::Int32Grid>(file, "centroid");
  const auto format = require_meta<std::int32_t>(*material, kFormatKey);
  if (format != kFormat)
    throw Error("it has format " + std::to_string(format) + "; this version of hapticut reads format " +
                std::to_string(kFormat) + ". Use the version that wrote it.");
  MaterialTable materials = read_materials(*material);
  const GridFrame frame = read_frame(*material);
  check_values(density->tree(), material->tree(), materials);
  std::unique_ptr<VoxelTrees> trees(
      new VoxelTrees{MaterialTree(material->tree()), FillTree(1.0F), CentroidTree(centroid->tree())});
  copy_fill(density->tree(), trees->fill);
  return WorkpieceAccess::make(frame, std::move(materials), std::move(trees));
}

/// A file of save_vdb has its own materials, which an import would silently replace by one.
void require_foreign(const VdbFile& file) {
  for (const auto& grid : file.grids)
    if (grid && grid->getMetadata<openvdb::Int32Metadata>(kFormatKey))
      throw Error("hapticut wrote it, with its own materials, grid and unit; leave " + "VdbImport::material"_name +
                  " out.");
}

Workpiece parse_foreign(std::string bytes, const VdbImport& options) {
  const VdbFile file = read_grids(std::move(bytes));
  const NodesOf nodes(file);
  require_foreign(file);
  openvdb::FloatGrid::Ptr chosen;
  int candidates = 0;
  std::map<std::string, int> floats;  // number of grids of each name
  for (const auto& grid : file.grids) {
    if (!grid || !grid->isType<openvdb::FloatGrid>()) continue;
    ++floats[grid->getName()];
    if (!options.grid.empty() && grid->getName() != options.grid) continue;
    chosen = openvdb::gridPtrCast<openvdb::FloatGrid>(grid);
    ++candidates;
  }
  if (candidates != 1) {
    const bool can_name = (candidates == 0 || options.grid.empty()) &&
                          std::any_of(floats.begin(), floats.end(),
                                      [](const auto& named) { return named.second == 1 && !named.first.empty(); });
    throw Error((candidates == 0 ? std::string("there is no ") : "there is more than one ") + "float grid" +
                (options.grid.empty() ? "" : " '" + options.grid + "'") + " in it; it has " + list_of(file) +
                (can_name         ? ". Name a float grid (level set or fog volume) with " + "VdbImport::grid"_name + "."
                 : floats.empty() ? ". Save a level set or fog volume with values of type float in it."
                                  : ". Give its float grids different names in the program that wrote it."));
  }
  const openvdb::GridClass says = chosen->getGridClass();
  if (options.kind == VdbImport::Kind::from_class && says != openvdb::GRID_LEVEL_SET &&
      says != openvdb::GRID_FOG_VOLUME)
    throw Error("its grid '" + chosen->getName() + "' does not say what its values mean; set " +
                "VdbImport::kind"_name + ": " + "fog_volume for filled fractions, level_set for distances.");
  GridImport import;
  import.unit = options.unit_mm * 1e-3;
  if (options.kind == VdbImport::Kind::level_set) import.kind = GridKind::level_set;
  if (options.kind == VdbImport::Kind::fog_volume) import.kind = GridKind::fog_volume;
  return workpiece_from_grid(*chosen, options.material, import);
}

/// Calls `write` with a function that writes the grids of a workpiece to a stream.
template <class Write>
void with_grids(const Workpiece& workpiece, const Write& write) {
  openvdb::initialize();
  const auto material = material_grid(workpiece, kUnit);
  describe(workpiece, *material);
  const auto density = density_grid(workpiece, kUnit);
  auto centroid = openvdb::Int32Grid::create(make_tree<openvdb::Int32Tree>(WorkpieceAccess::trees(workpiece).centroid));
  centroid->setTransform(material->transformPtr());
  centroid->setName("centroid");
  require_memory(0);
  write([&](std::ostream& stream) { FileWriter().write_file(stream, {density, material, centroid}); });
}

}  // namespace

void save_vdb(const Workpiece& workpiece, const std::filesystem::path& path) {
  with_grids(workpiece, [&](const std::function<void(std::ostream&)>& write) { write_atomically(path, write); });
}

std::string vdb_bytes(const Workpiece& workpiece) {
  std::ostringstream stream(std::ios_base::binary);
  with_grids(workpiece, [&](const std::function<void(std::ostream&)>& write) { write(stream); });
  return std::move(stream).str();
}

Workpiece load_vdb(const std::filesystem::path& path) {
  return naming(path, [&] { return workpiece_of_vdb(bytes_of_file(path)); });
}

Workpiece workpiece_of_vdb(std::string bytes) {
  return reading([&] { return parse(std::move(bytes)); });
}

Workpiece workpiece_of_vdb(std::string bytes, const VdbImport& options) {
  return reading([&] { return parse_foreign(std::move(bytes), options); });
}

Workpiece load_vdb(const std::filesystem::path& path, const VdbImport& options) {
  require_positive(options.unit_mm, "VdbImport::unit_mm [mm]");
  return naming(path, [&] { return workpiece_of_vdb(bytes_of_file(path), options); });
}

}  // namespace hapticut
