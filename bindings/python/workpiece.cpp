// SPDX-License-Identifier: Apache-2.0
// include/hapticut/workpiece: the workpiece itself
#include "workpiece.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "bindings.hpp"
#include "core.hpp"
#include "hapticut/build/volume_builders.hpp"
#include "hapticut/contact/contact.hpp"
#include "hapticut/workpiece/block_grid.hpp"
#include "simulation.hpp"
#include "structs.hpp"
#include "warned.hpp"

namespace hapticut::python {

const Workpiece& PythonWorkpiece::read() const {
  occupancy().require_readable("The workpiece");
  return own_ != nullptr ? *own_ : simulation_->simulation.workpiece();
}

Workpiece& PythonWorkpiece::write() {
  if (own_ == nullptr)
    throw Error(
        "only its Simulation may change this workpiece; use Simulation.restore, .reset or "
        ".reserve_blocks, or change a clone() of it.");
  own_occupancy_->require_writable("The workpiece");
  return *own_;
}

Occupancy& PythonWorkpiece::occupancy() const {
  return own_occupancy_ != nullptr ? *own_occupancy_ : simulation_->occupancy;
}

namespace {

/// Maximum size of an array: 4 GiB. A larger one is probably a mistake.
constexpr double kMaxVoxelsOfAnArray = 4294967296.0;

IndexBox box_or_bounds(const Workpiece& workpiece, const std::optional<IndexBox>& box) {
  const IndexBox wanted = box ? *box : workpiece.bounds();
  if (wanted.empty())
    throw Error(box ? "IndexBox is empty; each max must be at least its min." : "the workpiece is empty; give a box.");
  double voxels = 1;  // as double, because IndexBox::voxels can overflow
  for (std::size_t axis = 0; axis < 3; ++axis) voxels *= double(wanted.max[axis]) - wanted.min[axis] + 1;
  if (voxels > kMaxVoxelsOfAnArray)
    throw Error("an array of " + format_number(voxels) + " voxels is too large; ask for a smaller box.");
  return wanted;
}

std::array<std::size_t, 3> extent_of(const IndexBox& box) {
  std::array<std::size_t, 3> extent;
  for (std::size_t axis = 0; axis < 3; ++axis)
    extent[axis] = std::size_t(std::int64_t(box.max[axis]) - box.min[axis] + 1);
  return extent;
}

/// Calls `function(block, voxel in the block, index in the array)` for every voxel of a box that can be solid.
template <class Function>
void for_each_filled_voxel(const Workpiece& workpiece, const IndexBox& box, const Function& function) {
  const std::array<std::size_t, 3> extent = extent_of(box);
  const auto place = [&box](const VoxelIndex& at, std::size_t axis) {
    return std::size_t(std::int64_t(at[axis]) - box.min[axis]);
  };
  const IndexBox both = overlap(workpiece.bounds(), box);  // within +-2^30, so the loops below end
  for_each_block_origin(both, [&](const VoxelIndex& origin) {
    const BlockView block = workpiece.block(origin);
    if (block.empty()) return;
    hapticut::for_each_voxel(overlap(voxels_of_block(origin), both), [&](const VoxelIndex& at) {
      function(block, block_offset(at[0] - origin[0], at[1] - origin[1], at[2] - origin[2]),
               (place(at, 0) * extent[1] + place(at, 1)) * extent[2] + place(at, 2));
    });
  });
}

template <class Value, class Function>
py::array dense(const PythonWorkpiece& workpiece, const std::optional<IndexBox>& box, const Function& value_of) {
  const IndexBox wanted = box_or_bounds(workpiece.read(), box);
  py::array_t<Value> array(extent_of(wanted));
  Value* values = array.mutable_data();
  std::fill_n(values, array.size(), Value(0));
  workpiece.read_released([&](const Workpiece& w) {
    for_each_filled_voxel(w, wanted, [&](const BlockView& block, int voxel, std::size_t at) {
      if (block.fill_of(voxel) > 0) values[at] = std::invoke(value_of, block, voxel);
    });
  });
  return array;
}

/// A workpiece from dense voxel arrays: the inverse of material_array and fill_array.
PythonWorkpiece from_arrays(const py::array& material, const std::optional<py::array>& fill, const GridFrame& frame,
                            const MaterialTable& materials, const VoxelIndex& origin) {
  const auto ids = py::array_t<std::uint8_t, py::array::c_style>::ensure(material);
  if (material.dtype().kind() != 'u' || material.itemsize() != 1 || material.ndim() != 3 || !ids) {
    PyErr_Clear();
    throw Error("material: " + describe_given(material) +
                " was given; it must be an array of shape (nx, ny, nz) and dtype uint8.");
  }
  py::array_t<float, py::array::c_style | py::array::forcecast> fills;
  if (fill) {
    fills = *fill;
    const bool same_shape = fill->ndim() == 3 && std::equal(material.shape(), material.shape() + 3, fill->shape());
    if (fill->dtype().kind() != 'f' || !same_shape)
      throw Error("fill: " + describe_given(*fill) +
                  " was given; it must have a floating dtype and the shape of material, " +
                  std::string(py::str(material.attr("shape"))) + ".");
  }
  if (material.size() == 0) throw Error("material has no voxels; every axis must have at least one.");
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (std::int64_t(origin[axis]) + ids.shape(py::ssize_t(axis)) > std::numeric_limits<int>::max())
      throw Error("origin = " + std::to_string(origin[axis]) + " along axis " + std::to_string(axis) + " and " +
                  std::to_string(ids.shape(py::ssize_t(axis))) +
                  " voxels from there are outside the range of indices.");
  const int nx = int(ids.shape(0)), ny = int(ids.shape(1)), nz = int(ids.shape(2));
  const IndexBox domain{origin, {origin[0] + nx - 1, origin[1] + ny - 1, origin[2] + nz - 1}};
  const std::uint8_t* id = ids.data();
  const float* part = fill ? fills.data() : nullptr;
  return make_released([&] {
    return Workpiece::from_blocks(domain, frame, materials, [&](const VoxelIndex& block, BlockContent& content) {
      for (int n = 0; n < kBlockVoxels; ++n) {
        const auto [x, y, z] = voxel_at(block, n);
        const int i = x - origin[0], j = y - origin[1], k = z - origin[2];
        content.material[n] = kEmpty;
        content.fill[n] = 0;
        content.centroid[n] = {};
        if (i < 0 || j < 0 || k < 0 || i >= nx || j >= ny || k >= nz) continue;
        const std::size_t at = (std::size_t(i) * std::size_t(ny) + std::size_t(j)) * std::size_t(nz) + std::size_t(k);
        const float share = part != nullptr ? part[at] : 1.0F;
        if (id[at] == kEmpty || share == 0) continue;
        content.material[n] = id[at];
        content.fill[n] = share;
      }
      return BlockKind::mixed();
    });
  });
}

std::vector<LabelMaterial> label_materials_from(const py::dict& materials) {
  std::vector<LabelMaterial> list;
  for (const auto& [labels, material] : materials) {
    LabelMaterial entry;
    const auto add = [&entry](py::handle label) {
      const py::object number = py::reinterpret_steal<py::object>(PyNumber_Index(label.ptr()));
      if (!number) {
        PyErr_Clear();
        throw Error("materials: a key must be a label, or a tuple of labels; " + std::string(py::repr(label)) +
                    " is neither.");
      }
      const long value = PyLong_AsLong(number.ptr());
      if (PyErr_Occurred() != nullptr || value < 0 || value > 65535) {
        PyErr_Clear();
        throw Error("materials: label " + std::string(py::str(number)) + " is not within 0 ... 65535.");
      }
      entry.labels.push_back(std::uint16_t(value));
    };
    if (py::isinstance<py::tuple>(labels)) {
      for (const py::handle label : py::reinterpret_borrow<py::tuple>(labels)) add(label);
    } else {
      add(labels);
    }
    if (!py::isinstance<Material>(material))
      throw Error("materials: the value of label " + std::string(py::repr(labels)) + " is " + describe_given(material) +
                  "; it must be a Material.");
    entry.material = material.cast<Material>();
    list.push_back(std::move(entry));
  }
  return list;
}

void bind_values(py::module_& m) {
  bind_struct<IndexBox>(m, "IndexBox", field("min", &IndexBox::min), field("max", &IndexBox::max))
      .def("empty", &IndexBox::empty, "Whether the box has no voxel.")
      .def("voxels", &IndexBox::voxels, "Number of voxels in the box.");
  bind_struct<GridFrame>(m, "GridFrame", field("voxel_size", &GridFrame::voxel_size), field("X_WV", &GridFrame::X_WV))
      .def("center", &GridFrame::center, py::arg("index"), "[m] (3,) centre of a voxel, in W.");
  bind_struct<Box>(m, "Box", required("min", &Box::min), required("max", &Box::max));
  bind_result<MaterialAmount>(m, "MaterialAmount", member("material", &MaterialAmount::material),
                              member("voxels", &MaterialAmount::voxels), member("volume", &MaterialAmount::volume),
                              member("mass", &MaterialAmount::mass), member("center", &MaterialAmount::center));
  py::class_<WorkpieceSnapshot>(m, "WorkpieceSnapshot", doc("WorkpieceSnapshot"));
  bind_enum<Quadrature>(m, "Quadrature");
  bind_enum<UnclaimedLabels>(m, "UnclaimedLabels");
  bind_struct<VolumeBuildOptions>(
      m, "VolumeBuildOptions", field("voxel_size", &VolumeBuildOptions::voxel_size),
      field("crop_samples", &VolumeBuildOptions::crop_samples), field("crop", &VolumeBuildOptions::crop),
      field("antialias", &VolumeBuildOptions::antialias), field("subsamples", &VolumeBuildOptions::subsamples),
      field("partial_volume", &VolumeBuildOptions::partial_volume), field("large", &VolumeBuildOptions::large));
  bind_struct<GreyRange>(m, "GreyRange", "GreyRange", required("from_", &GreyRange::from),
                         required("to", &GreyRange::to), required("material", &GreyRange::material));
  bind_struct<Grade>(m, "Grade", required("low", &Grade::low), required("high", &Grade::high),
                     required("at_low", &Grade::at_low), required("at_high", &Grade::at_high),
                     field("steps", &Grade::steps));
}

void bind_makers(py::class_<PythonWorkpiece>& binding) {
  binding
      .def_static(
          "from_labels",
          [](const RealArray& array, const Vec3& spacing, const py::dict& materials, const Pose& X_WG,
             const VolumeBuildOptions& options, UnclaimedLabels unclaimed) {
            const LabelVolume volume = volume_from<std::uint16_t>(array, spacing, X_WG);
            const std::vector<LabelMaterial> list = label_materials_from(materials);
            return build_labels_with_warnings(volume, list, options, unclaimed);
          },
          py::arg("array"), py::arg("spacing"), py::arg("materials"), py::arg("X_WG") = Pose{},
          py::arg("options") = VolumeBuildOptions{}, py::arg("unclaimed") = UnclaimedLabels::refuse,
          "A workpiece from a segmentation.\n\n"
          "Parameters\n----------\n"
          "array\n    (nx, ny, nz) of a whole-number dtype, any memory order: array[i, j, k] is the label of sample\n"
          "    (i, j, k). For an array in the order [z, y, x], pass array.T.\n"
          "spacing\n    [m] (3,) distance of neighbouring samples along x, y, z.\n"
          "materials\n    dict from a label, or a tuple of labels, to its Material; ids follow its order.\n"
          "X_WG\n    (4, 4) pose of the grid: position of sample (0, 0, 0) and directions of its axes.\n"
          "options\n    voxel size, crop and antialiasing.\n"
          "unclaimed\n    what to do with a label that no material claims; label 0 is always empty unless claimed.\n\n"
          "Raises\n------\nError\n    When the array, the spacing or the labels do not fit; see build_from_labels.")
      .def_static(
          "from_intensity",
          [](const RealArray& array, const Vec3& spacing, const std::vector<GreyRange>& ranges, const Pose& X_WG,
             const VolumeBuildOptions& options) {
            return build_ranges_with_warnings(volume_from<float>(array, spacing, X_WG), ranges, options);
          },
          py::arg("array"), py::arg("spacing"), py::arg("ranges"), py::arg("X_WG") = Pose{},
          py::arg("options") = VolumeBuildOptions{},
          "A workpiece from grey values: values outside all ranges are empty.\n\n"
          "Parameters\n----------\n"
          "array\n    (nx, ny, nz) of any real dtype, any memory order: array[i, j, k] is sample (i, j, k).\n"
          "spacing\n    [m] (3,) distance of neighbouring samples along x, y, z.\n"
          "ranges\n    GreyRange list, or one Grade for a material whose constants change with the grey value.\n"
          "X_WG\n    (4, 4) pose of the grid.\n"
          "options\n    voxel size, crop, antialiasing and the partial volume at borders.\n\n"
          "Raises\n------\nError\n    When the array, the spacing or the ranges do not fit; see build_from_grey.")
      .def_static(
          "from_intensity",
          [](const RealArray& array, const Vec3& spacing, const Grade& grade, const Pose& X_WG,
             const VolumeBuildOptions& options) {
            const GreyVolume volume = volume_from<float>(array, spacing, X_WG);
            return make_released([&] { return build_from_grey(volume, grade, options); });
          },
          py::arg("array"), py::arg("spacing"), py::arg("ranges"), py::arg("X_WG") = Pose{},
          py::arg("options") = VolumeBuildOptions{})
      .def_static("from_arrays", &from_arrays, py::arg("material"), py::arg("fill"), py::arg("frame"),
                  py::arg("materials"), py::arg("origin") = VoxelIndex{0, 0, 0},
                  "A workpiece from its voxels: the results of material_array and fill_array, without centroids.\n\n"
                  "Parameters\n----------\n"
                  "material\n    (nx, ny, nz) uint8 ids, 0 where there is nothing.\n"
                  "fill\n    (nx, ny, nz) filled fractions 0 ... 1, or None: all full.\n"
                  "frame\n    voxel size and pose.\n"
                  "materials\n    the table that the ids refer to.\n"
                  "origin\n    index of the first voxel.\n\n"
                  "Raises\n------\nError\n    When shapes or types do not fit, or an id or a fill is out of range.");
}

void bind_state(py::class_<PythonWorkpiece>& binding) {
  using W = PythonWorkpiece;
  binding
      .def(
          "clone", [](const W& w) { return W(w.read_released([](const Workpiece& x) { return x.clone(); })); },
          doc("Workpiece::clone"))
      .def("__copy__", [](const W& w) { return W(w.read().clone()); })
      .def(
          "__deepcopy__", [](const W& w, const py::dict&) { return W(w.read().clone()); }, py::arg("memo"))
      .def_property_readonly("frame", reading<W>(&Workpiece::frame), doc("GridFrame"))
      .def_property_readonly("voxel_size", reading<W>(&Workpiece::voxel_size), doc("Workpiece::voxel_size"))
      .def_property_readonly("materials", reading<W>(&Workpiece::materials), "A copy of the table; see set_materials.")
      .def("bounds", reading<W>(&Workpiece::bounds), doc("Workpiece::bounds"))
      .def("empty", reading<W>(&Workpiece::empty), doc("Workpiece::empty"))
      .def("solid_voxels", reading<W>(&Workpiece::solid_voxels), doc("Workpiece::solid_voxels"))
      .def("memory_bytes", reading<W>(&Workpiece::memory_bytes), doc("Workpiece::memory_bytes"))
      .def("pool_bytes", reading<W>(&Workpiece::pool_bytes), doc("Workpiece::pool_bytes"))
      .def("amounts", reading<W>(&Workpiece::amounts), doc("Workpiece::amounts"))
      .def("material_at", reading<W>(&Workpiece::material_at), py::arg("index"), doc("Workpiece::material_at"))
      .def("fill_at", reading<W>(&Workpiece::fill_at), py::arg("index"), doc("Workpiece::fill_at"))
      .def(
          "centroid_at",
          [](const W& w, const VoxelIndex& i) {
            const CentroidOffset offset = w.read().centroid_at(i);
            return Vec3(Vec3(offset.steps[0], offset.steps[1], offset.steps[2]) / CentroidOffset::kSteps);
          },
          py::arg("index"), "[voxel edges] (3,) from a voxel's centre to the centroid of its filled part.")
      .def(
          "material_array",
          [](const W& w, const std::optional<IndexBox>& box) {
            return dense<std::uint8_t>(w, box, &BlockView::material_of);
          },
          py::arg("box") = py::none(),
          "(nx, ny, nz) uint8: the material of every voxel of a box, 0 where it is empty; without a box, of bounds().")
      .def(
          "fill_array",
          [](const W& w, const std::optional<IndexBox>& box) {
            return dense<float>(w, box, [](const BlockView& block, int voxel) { return block.fill_of(voxel); });
          },
          py::arg("box") = py::none(),
          "(nx, ny, nz) float32: the filled fraction of every voxel of a box; without a box, of bounds().")
      .def("hash", reading<W>(&Workpiece::hash), doc("Workpiece::hash"))
      .def("set_materials", writing<W>(&Workpiece::set_materials), py::arg("materials"),
           doc("Workpiece::set_materials"))
      .def("snapshot", reading<W>(&Workpiece::snapshot),
           "A frozen copy of the state, for `restore`. Cheap to copy; shares memory.")
      .def("restore", writing<W>(&Workpiece::restore), py::arg("snapshot"), doc("Workpiece::restore"))
      .def("reserve_undo", writing<W>(&Workpiece::reserve_undo), py::arg("blocks"), doc("Workpiece::reserve_undo"))
      .def_property_readonly("undo_blocks", reading<W>(&Workpiece::undo_blocks),
                             "Number of blocks reserved by `reserve_undo`.")
      .def("set_mark", writing<W>(&Workpiece::set_mark), doc("Workpiece::set_mark"))
      .def_property_readonly("marks", reading<W>(&Workpiece::marks), "Number of marks that can be restored.")
      .def("undo_block", writing<W>(&Workpiece::undo_block), doc("Workpiece::undo_block"))
      .def_property_readonly("redo_marks", reading<W>(&Workpiece::redo_marks), "Number of undone marks.")
      .def("redo_block", writing<W>(&Workpiece::redo_block), doc("Workpiece::redo_block"))
      .def("reserve_blocks", writing<W>(&Workpiece::reserve_blocks), py::arg("count"), doc("Workpiece::reserve_blocks"))
      .def("reserved_blocks", reading<W>(&Workpiece::reserved_blocks), doc("Workpiece::reserved_blocks"))
      .def("__repr__", [](const W& w) {
        return "Workpiece(" + std::to_string(w.read().solid_voxels()) + " voxels of " +
               format_number(w.read().voxel_size() * 1e3) + " mm)";
      });
}

}  // namespace

void bind_workpiece(py::module_& m) {
  m.attr("kBlockEdge") = kBlockEdge;
  m.attr("kBlockVoxels") = kBlockVoxels;
  bind_values(m);
  py::class_<PythonWorkpiece> binding(m, "Workpiece", doc("Workpiece"));
  bind_makers(binding);
  bind_state(binding);
}

}  // namespace hapticut::python
