// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "hapticut/import/volume/volumes.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

/// @file
/// Refusals of readers, with what their sentences tell the user to do.
namespace hapticut::test {

/// Content of files by name; nullopt removes a file.
using Files = std::map<std::string, std::optional<std::string>>;

/// A refused input and its cure.
struct Cure {
  std::string sentence;         ///< part of the refusal
  std::string path;             ///< path in the folder; empty: the folder
  Files broken;                 ///< files that are refused
  Files cured = {};             ///< files that the cure changes
  VolumeReadOptions with = {};  ///< options that the cure sets
  bool labels = false;          ///< read as labels, before the cure
  std::string cured_path = {};  ///< path in the folder; empty: `path`
};

inline void PrintTo(const Cure& cure, std::ostream* out) { *out << cure.sentence; }

inline void write_files(const TemporaryFolder& folder, const Files& files) {
  for (const auto& [name, bytes] : files)
    if (bytes)
      write_bytes(folder / name, *bytes);
    else
      std::filesystem::remove(folder / name);
}

/// Expects that the input is refused with its sentence, and is read after the cure.
inline void expect_cured(const Cure& cure) {
  SCOPED_TRACE(cure.sentence);
  const TemporaryFolder folder;
  write_files(folder, cure.broken);
  const std::string said = refusal([&] {
    if (cure.labels)
      (void)read_label_volume(folder / cure.path);
    else
      (void)read_grey_volume(folder / cure.path);
  });
  expect_part(said, cure.sentence);
  write_files(folder, cure.cured);
  EXPECT_EQ(refusal([&] {
              return read_grey_volume(folder / (cure.cured_path.empty() ? cure.path : cure.cured_path), cure.with);
            }),
            "");
}

}  // namespace hapticut::test
