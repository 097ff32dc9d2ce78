// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hapticut/io/vdb/vdb.hpp"
#include "hapticut/workpiece/workpiece.hpp"

/// @file
/// Workpieces as the bytes of a .vdb file, for storage inside another file.
namespace hapticut {

[[nodiscard]] std::string vdb_bytes(const Workpiece& workpiece);

/// @throws Error without the name of the file, when the bytes are not a file of `save_vdb`
[[nodiscard]] Workpiece workpiece_of_vdb(std::string bytes);

/// The workpiece in the bytes of another program's file.
[[nodiscard]] Workpiece workpiece_of_vdb(std::string bytes, const VdbImport& options);

}  // namespace hapticut
