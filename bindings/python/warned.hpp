// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hapticut/build/mesh_builder.hpp"
#include "hapticut/build/volume_builders.hpp"
#include "workpiece.hpp"

namespace hapticut::python {

/// Gives each sentence to Python as a UserWarning.
/// @throws error_already_set when warnings are errors
inline void give_warnings(const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences)
    if (PyErr_WarnEx(PyExc_UserWarning, sentence.c_str(), 1) != 0) throw pybind11::error_already_set();
}

/// Reads a volume without the interpreter lock, then gives its remarks to Python.
template <class Read>
auto read_with_warnings(const Read& read) {
  auto volume = [&] {
    const pybind11::gil_scoped_release released;
    return read();
  }();
  give_warnings(volume.remarks);
  return volume;
}

/// Builds a workpiece without the interpreter lock; what the builder says becomes a warning.
template <class Options, class Build>
PythonWorkpiece build_with_warnings(Options options, const Build& build) {
  std::vector<std::string> said;
  options.warn = [&](const std::string& sentence) { said.push_back(sentence); };
  PythonWorkpiece workpiece = make_released([&] { return build(options); });
  give_warnings(said);
  return workpiece;
}

inline PythonWorkpiece build_labels_with_warnings(const LabelVolume& volume,
                                                  const std::vector<LabelMaterial>& materials,
                                                  const VolumeBuildOptions& options, UnclaimedLabels unclaimed) {
  return build_with_warnings(options,
                             [&](const auto& heard) { return build_from_labels(volume, materials, heard, unclaimed); });
}

inline PythonWorkpiece build_ranges_with_warnings(const GreyVolume& volume, const std::vector<GreyRange>& ranges,
                                                  const VolumeBuildOptions& options) {
  return build_with_warnings(options, [&](const auto& heard) { return build_from_grey(volume, ranges, heard); });
}

inline PythonWorkpiece build_shells_with_warnings(const std::vector<MeshShell>& shells, const MaterialTable& materials,
                                                  const MeshImport& options) {
  return build_with_warnings(options, [&](const auto& heard) { return build_from_shells(shells, materials, heard); });
}

}  // namespace hapticut::python
