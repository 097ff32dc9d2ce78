// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

/// @file
/// Paths on this machine. The names of folders are in one small file that the configuration writes,
/// places.cpp of the build folder, so that everything else compiles the same in every clone.
namespace hapticut::test {

extern const char* const kSourceFolder;  // source of this clone
extern const char* const kDataFolder;    // HAPTICUT_TEST_DATA
extern const char* const kProgramWith;   // and the folder of a driver: hapticut with its adapter and its stand-in
extern const char* const kProgram;       // hapticut; this and the next: empty if not built
extern const char* const kCLibrary;      // libhapticut_c.so

/// Path of a file of the repository: "docs/forces.md".
inline std::filesystem::path source_path(const std::string& name) {
  return std::filesystem::path(kSourceFolder) / name;
}

/// Path of a real input file, whether it exists or not.
inline std::filesystem::path data_path(const std::string& name) { return std::filesystem::path(kDataFolder) / name; }

}  // namespace hapticut::test
