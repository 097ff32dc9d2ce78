// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hapticut/io/vdb/vdb.hpp"
#include "hapticut/workpiece/workpiece.hpp"

/// @file
/// Workpieces as the bytes of a .vdb file, for what keeps them within a file of its own.
namespace hapticut {

[[nodiscard]] std::string vdb_bytes(const Workpiece& workpiece);

/// @throws Error a sentence that begins with "it" or "its", when the bytes are no file that `save_vdb` writes
[[nodiscard]] Workpiece workpiece_of_vdb(std::string bytes);

/// The same of a file of another program.
[[nodiscard]] Workpiece workpiece_of_vdb(std::string bytes, const VdbImport& options);

}  // namespace hapticut
