// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
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

/// Builds a workpiece from labels; what the builder says becomes a warning.
inline PythonWorkpiece build_labels_with_warnings(const LabelVolume& volume,
                                                  const std::vector<LabelMaterial>& materials,
                                                  VolumeBuildOptions options, UnclaimedLabels unclaimed) {
  std::vector<std::string> said;
  options.warn = [&](const std::string& sentence) { said.push_back(sentence); };
  PythonWorkpiece workpiece = make_released([&] { return build_from_labels(volume, materials, options, unclaimed); });
  give_warnings(said);
  return workpiece;
}

/// Builds a workpiece from surfaces; what the builder says becomes a warning.
inline PythonWorkpiece build_shells_with_warnings(const std::vector<MeshShell>& shells, MaterialTable materials,
                                                  MeshImport options) {
  std::vector<std::string> said;
  options.warn = [&](const std::string& sentence) { said.push_back(sentence); };
  PythonWorkpiece workpiece = make_released([&] { return build_from_shells(shells, std::move(materials), options); });
  give_warnings(said);
  return workpiece;
}

}  // namespace hapticut::python
