// SPDX-License-Identifier: Apache-2.0
// The cells of a heat field: their content, conduction between them, and the heat that is added.
#include "hapticut/heat/heat_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hapticut/core/errors.hpp"
#include "hapticut/heat/heat_collector.hpp"
#include "hapticut/workpiece/block_grid.hpp"

namespace hapticut {
namespace {

constexpr double kMaxCells = 8e6;  // some 130 bytes each
constexpr int kMaxDistance = 3;    // [cells] distance in which heat looks for material

}  // namespace

HeatField::Cells::Cells(std::size_t count) {
  for (std::vector<double>* numbers :
       {&heat, &capacity, &conductivity, &filled, &wetted, &cooling, &rise, &peak, &above, &dose, &removed, &held,
        &held_capacity, &conductance[0], &conductance[1], &conductance[2]})
    numbers->resize(count);
}

HeatField::HeatField(const Workpiece& workpiece, HeatConfig config)
    : config_(std::move(config)), frame_(workpiece.frame()), cells_(0) {
  require_fields_within(config_, "HeatConfig::");
  for (const ThermalProperties& p : config_.by_material) require_fields_within(p, "HeatConfig::by_material.");
  const int width = config_.voxels_per_cell;
  if (kBlockEdge % width != 0)
    throw Error("HeatConfig::voxels_per_cell"_name + " = " + std::to_string(width) + "; must be 1, 2, 4 or 8.");
  const IndexBox bounds = workpiece.bounds();
  if (bounds.empty()) throw Error("the workpiece is empty; there is nothing to heat.");
  double count = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    first_[axis] = block_start(bounds.min[axis]);
    dims_[axis] = (block_start(bounds.max[axis]) - first_[axis] + kBlockEdge) / width;
    count *= dims_[axis] + 2;
  }
  materials_ = std::size_t(workpiece.materials().size());
  if (count * double(materials_) > kMaxCells)
    throw Error("the workpiece spans " + format_number(count) + " cells of " + std::to_string(width) +
                " voxels, times " + std::to_string(materials_) + " materials; at most " + format_number(kMaxCells) +
                " are possible. Raise " + "HeatConfig::voxels_per_cell"_name + ", or crop it.");
  cell_size_ = width * workpiece.voxel_size();
  cell_volume_ = std::pow(cell_size_, 3);
  stride_[1] = std::size_t(dims_[2]) + 2;
  stride_[0] = stride_[1] * (std::size_t(dims_[1]) + 2);
  cells_ = Cells(std::size_t(count));
  volumes_.resize(std::size_t(count) * materials_);
  peaks_.resize(materials_);
  for (std::size_t id = 1; id <= materials_; ++id) {
    const Material& material = workpiece.materials()[MaterialId(id)];
    properties_.push_back(id <= config_.by_material.size() ? config_.by_material[id - 1]
                                                           : thermal_properties_of(material.name));
    cutting_energy_.push_back(material.specific_cutting_energy);
  }
  BlockContent content;
  workpiece.for_each_block([&](const BlockView& block) {
    block.copy_to(content.material, content.fill);
    update(block.origin, content.material.data(), content.fill.data());
  });
  refresh_changed();
}

std::size_t HeatField::number_of(const std::array<int, 3>& cell) const {
  std::size_t number = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) number += std::size_t(cell[axis] + 1) * stride_[axis];
  return number;
}

std::array<int, 3> HeatField::cell_of(std::size_t number) const {
  return {int(number / stride_[0]) - 1, int(number / stride_[1] % std::size_t(dims_[1] + 2)) - 1,
          int(number % stride_[1]) - 1};
}

Vec3 HeatField::center(const std::array<int, 3>& cell) const {
  Vec3 voxel;
  for (std::size_t axis = 0; axis < 3; ++axis)
    voxel[int(axis)] = first_[axis] + config_.voxels_per_cell * (cell[axis] + 0.5) - 0.5;
  return frame_.X_WV * Vec3(frame_.voxel_size * voxel);
}

// --- content of the cells -------------------------------------------------------------------------------------------

void HeatField::update(const VoxelIndex& origin, const MaterialId* material, const float* fill) {
  const int width = config_.voxels_per_cell, across = kBlockEdge / width;
  std::array<int, 3> first;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (origin[axis] < first_[axis]) return;
    first[axis] = (origin[axis] - first_[axis]) / width;
    if (first[axis] >= dims_[axis]) return;
  }
  std::vector<float> volumes(materials_);
  const float part = 1.0F / float(width * width * width);
  const auto cube = [](int edge) { return IndexBox{{0, 0, 0}, {edge - 1, edge - 1, edge - 1}}; };
  for_each_voxel(cube(across), [&](const VoxelIndex& cell) {
    std::ranges::fill(volumes, 0.0F);
    for_each_voxel(cube(width), [&](const VoxelIndex& in_cell) {
      const int n =
          block_offset(cell[0] * width + in_cell[0], cell[1] * width + in_cell[1], cell[2] * width + in_cell[2]);
      if (material[n] != kEmpty) volumes[material[n] - 1U] += part * fill[n];
    });
    set_content(number_of({first[0] + cell[0], first[1] + cell[1], first[2] + cell[2]}), volumes);
  });
}

void HeatField::update(const Workpiece& workpiece, std::span<const VoxelIndex> origins) {
  if (!(workpiece.frame() == frame_) || std::size_t(workpiece.materials().size()) != materials_)
    throw Error("HeatField::update"_name +
                " was given another workpiece: its voxels or materials are not those of the field. Make a "
                "field of it.");
  BlockContent content;
  for (const VoxelIndex& origin : origins) {
    workpiece.block(origin).copy_to(content.material, content.fill);
    update(origin, content.material.data(), content.fill.data());
  }
}

/// Removed material takes its heat along. New material is at body temperature and brings no heat.
void HeatField::set_content(std::size_t cell, const std::vector<float>& volumes) {
  float* known = volumes_.data() + cell * materials_;
  if (std::equal(volumes.begin(), volumes.end(), known)) return;
  double capacity = 0, conductivity = 0, filled = 0, lost_capacity = 0, removed = 0;
  for (std::size_t m = 0; m < materials_; ++m) {
    const double before = known[m], now = volumes[m];
    capacity += now * properties_[m].heat_capacity;
    conductivity += now * properties_[m].conductivity;
    filled += now;
    if (now >= before) continue;
    lost_capacity += (before - now) * properties_[m].heat_capacity;
    removed += (before - now) * cutting_energy_[m];
  }
  double& heat = cells_.heat[cell];
  const double leaves =
      capacity > 0 ? heat * std::min(1.0, lost_capacity * cell_volume_ / cells_.capacity[cell]) : heat;
  if (lost_capacity > 0) {
    heat -= leaves;
    cells_.held[cell] += leaves;
    cells_.held_capacity[cell] += lost_capacity * cell_volume_;
    if (cells_.removed[cell] == 0) removed_.push_back(cell);
    cells_.removed[cell] += removed * cell_volume_;
  }
  std::ranges::copy(volumes, known);
  cells_.capacity[cell] = capacity * cell_volume_;
  cells_.conductivity[cell] = conductivity;
  cells_.filled[cell] = std::min(1.0, filled);
  if (!(capacity > 0)) cells_.peak[cell] = cells_.above[cell] = cells_.dose[cell] = cells_.rise[cell] = 0;
  changed_.push_back(cell);
}

/// Updates conductances and surfaces of the changed cells and their neighbours.
void HeatField::refresh_changed() {
  if (changed_.empty()) return;
  std::vector<std::size_t> all;
  all.reserve(7 * changed_.size());
  for (const std::size_t cell : changed_) {
    all.push_back(cell);
    for (const std::size_t stride : stride_) all.insert(all.end(), {cell - stride, cell + stride});
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  for (const std::size_t cell : all)
    if (cells_.capacity[cell] > 0) refresh_faces(cell);
  for (const std::size_t cell : changed_)  // a cell that is empty now conducts nothing
    if (!(cells_.capacity[cell] > 0)) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        cells_.conductance[axis][cell] = cells_.conductance[axis][cell - stride_[axis]] = 0;
      cells_.cooling[cell] = cells_.wetted[cell] = 0;
    }
  changed_.clear();
  rate_ = 0;
}

/// Between centres, heat passes through half of each cell. Empty space does not conduct. The surface inside a cell is
/// the difference of its fill to its neighbours, as the root of the sum of squares over the axes, because all three
/// axes see a plane.
void HeatField::refresh_faces(std::size_t cell) {
  double squares = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double bare = 0;
    for (const std::size_t other : {cell - stride_[axis], cell + stride_[axis]}) {
      const double a = cells_.conductivity[cell], b = cells_.conductivity[other];
      cells_.conductance[axis][std::min(cell, other)] = a > 0 && b > 0 ? 2 * a * b / (a + b) * cell_size_ : 0.0;
      bare += std::max(0.0, cells_.filled[cell] - cells_.filled[other]);
    }
    squares += bare * bare;
  }
  cells_.wetted[cell] = std::sqrt(squares) * cell_size_ * cell_size_;
  refresh_cooling(cell);
}

/// The conductances of half of the cell and of the film of water, in series.
void HeatField::refresh_cooling(std::size_t cell) {
  const double film = config_.irrigation * cells_.wetted[cell];
  const double half = 2 * cells_.conductivity[cell] * cell_size_;
  cells_.cooling[cell] = film > 0 ? film * half / (film + half) : 0.0;
}

void HeatField::set_irrigation(double coefficient) {
  require_within(coefficient, range_of(&HeatConfig::irrigation), "HeatField::set_irrigation: coefficient [W/(m^2 K)]");
  config_.irrigation = coefficient;
  for (std::size_t cell = 0; cell < cells_.wetted.size(); ++cell)
    if (cells_.wetted[cell] > 0) refresh_cooling(cell);
  rate_ = 0;
}

// --- heat that is added ----------------------------------------------------------------------------------------------

double HeatField::drain(HeatCollector& collector) {
  double time = 0, cut = 0;
  for (ChangedBlock block; collector.receive(block);) update(block.origin, block.material.data(), block.fill.data());
  for (HeatPulse pulse; collector.receive(pulse);) {
    time += pulse.dt;
    cut += config_.cutting_share.value_or(pulse.share) * (pulse.cut + pulse.rubbed_in_cut);
    if (pulse.rubbed > 0) add_heat(pulse.p_WQ, config_.rubbing_share * pulse.rubbed, pulse.radius);
  }
  add_cutting_heat(std::max(cut, 0.0));
  return time;
}

/// [cells] Position relative to the centre of the first cell.
Vec3 HeatField::in_cells(const Vec3& p_WQ) const {
  const Vec3 p_V = frame_.X_WV.inverse() * p_WQ / frame_.voxel_size;
  Vec3 p_cells;
  for (int axis = 0; axis < 3; ++axis)
    p_cells[axis] = (p_V[axis] - first_[std::size_t(axis)] + 0.5) / config_.voxels_per_cell - 0.5;
  return p_cells;
}

HeatField::Around HeatField::cells_around(const Vec3& p_WQ) const {
  Around around;
  const Vec3 p_cells = in_cells(p_WQ);
  std::array<int, 3> low;
  std::array<double, 3> part;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double at = p_cells[int(axis)];
    if (!(at > -1 && at < dims_[axis])) return around;
    low[axis] = int(std::floor(at));
    part[axis] = at - low[axis];
  }
  for (; around.count < 8; ++around.count) {
    const int corner = around.count;
    const std::array<int, 3> up = {corner >> 2, corner >> 1 & 1, corner & 1};
    double weight = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) weight *= up[axis] == 1 ? part[axis] : 1 - part[axis];
    around.cell[std::size_t(corner)] = number_of({low[0] + up[0], low[1] + up[1], low[2] + up[2]});
    around.weight[std::size_t(corner)] = weight;
  }
  return around;
}

/// Adds heat in proportion to the surface of the cells whose centres are near.  @return false when there is no surface
bool HeatField::add_to_surface(const Vec3& p_WQ, double heat, double radius) {
  refresh_changed();
  const Vec3 p_cells = in_cells(p_WQ);
  IndexBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double at = p_cells[int(axis)], far = radius / cell_size_;
    box.min[axis] = int(std::clamp(std::ceil(at - far), 0.0, double(dims_[axis])));
    box.max[axis] = int(std::clamp(std::floor(at + far), -1.0, dims_[axis] - 1.0));
  }
  const auto for_each = [&](const auto& visit) {
    for_each_voxel(box, [&](const VoxelIndex& cell) {
      if ((center(cell) - p_WQ).norm() <= radius) visit(number_of(cell));
    });
  };
  double surface = 0;
  for_each([&](std::size_t cell) { surface += cells_.wetted[cell]; });
  if (!(surface > 0)) return false;
  balance_.brought_in += heat;
  for_each([&](std::size_t cell) { cells_.heat[cell] += heat * (cells_.wetted[cell] / surface); });
  return true;
}

void HeatField::add_heat(const Vec3& p_WQ, double heat, double radius) {
  if (!is_finite(p_WQ)) throw Error("HeatField::add_heat"_name + ": the point must be finite.");
  require_within(heat, Range::not_negative(), "HeatField::add_heat: heat [J]");
  require_within(radius, Range::not_negative(), "HeatField::add_heat: radius [m]");
  if (radius > 0 && add_to_surface(p_WQ, heat, radius)) return;
  double weights = 0, nearest = 0;
  std::size_t at = 0;
  const Around around = cells_around(p_WQ);
  for (std::size_t n = 0; n < std::size_t(around.count); ++n) {
    weights += around.weight[n] * cells_.capacity[around.cell[n]];
    if (around.weight[n] > nearest) nearest = around.weight[n], at = around.cell[n];
  }
  if (weights > 0) {
    balance_.brought_in += heat;
    for (std::size_t n = 0; n < std::size_t(around.count); ++n)
      cells_.heat[around.cell[n]] += heat * around.weight[n] * cells_.capacity[around.cell[n]] / weights;
  } else if (nearest > 0) {
    spread(at, heat);
  } else {
    balance_.brought_in += heat;
    balance_.chips += heat;
  }
}

/// Adds heat to a cell in proportion to its fill, so a small remainder does not get hotter than a full cell would. The
/// rest goes to the material around, in proportion to capacity, if there is as much of it as beside a plane; where
/// there is less, only such a part, and the rest farther away. What finds no material leaves with the chips.
void HeatField::spread(std::size_t cell, double heat) {
  balance_.brought_in += heat;
  const double own = cells_.filled[cell] * heat;
  double rest = heat - own;
  cells_.heat[cell] += own;
  const VoxelIndex at = cell_of(cell);
  for (int far = 1; far <= kMaxDistance && rest > 0; ++far) {
    const IndexBox box = overlap({{at[0] - far, at[1] - far, at[2] - far}, {at[0] + far, at[1] + far, at[2] + far}},
                                 {{0, 0, 0}, {dims_[0] - 1, dims_[1] - 1, dims_[2] - 1}});
    const auto for_each = [&](const auto& visit) {
      for_each_voxel(box, [&](const VoxelIndex& near) {
        const int apart = std::abs(near[0] - at[0]) + std::abs(near[1] - at[1]) + std::abs(near[2] - at[2]);
        if (apart > 0 && apart <= far) visit(number_of(near));
      });
    };
    double capacity = 0, filled = 0;
    for_each([&](std::size_t n) { capacity += cells_.capacity[n], filled += cells_.filled[n]; });
    if (!(capacity > 0)) continue;
    const double beside_a_plane = far * (2 * far * (far + 1.5) + 4) / 3;  // [1] half of the cells within this distance
    const double taken = rest * std::min(1.0, filled / beside_a_plane);
    for_each([&](std::size_t n) { cells_.heat[n] += taken * (cells_.capacity[n] / capacity); });
    rest -= taken;
  }
  balance_.chips += rest;
}

/// Gives the heat that cut material held to the colder material in its cell and beside it; under water, what it lacked
/// to the warmer.
void HeatField::give_back(std::size_t cell) {
  const double held = cells_.held[cell];
  if (held == 0) return;
  const double rise = held / cells_.held_capacity[cell];
  std::array<double, 7> takes;  // [J] to be as warm as the cut material was
  const std::array<std::size_t, 7> near = {cell,
                                           cell - stride_[0],
                                           cell + stride_[0],
                                           cell - stride_[1],
                                           cell + stride_[1],
                                           cell - stride_[2],
                                           cell + stride_[2]};
  double all = 0;
  for (std::size_t n = 0; n < near.size(); ++n) {
    const double lacks = cells_.capacity[near[n]] * rise - cells_.heat[near[n]];
    all += takes[n] = lacks * held > 0 ? lacks : 0.0;
  }
  const double part = all == 0 ? 0.0 : std::min(1.0, held / all);
  for (std::size_t n = 0; n < near.size(); ++n) cells_.heat[near[n]] += part * takes[n];
  balance_.chips += held - part * all;
}

void HeatField::add_cutting_heat(double heat) {
  require_within(heat, Range::not_negative(), "HeatField::add_cutting_heat: heat [J]");
  waiting_ += heat;
  double removed = 0;
  for (const std::size_t cell : removed_) removed += cells_.removed[cell];
  if (!(removed > 0)) return;
  for (const std::size_t cell : removed_) {
    if (waiting_ > 0) {
      give_back(cell);
      spread(cell, waiting_ * (cells_.removed[cell] / removed));
    } else {
      balance_.chips += cells_.held[cell];
    }
    cells_.removed[cell] = cells_.held[cell] = cells_.held_capacity[cell] = 0;
  }
  removed_.clear();
  waiting_ = 0;
}

}  // namespace hapticut
