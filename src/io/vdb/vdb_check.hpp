// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/byte_reader.hpp"

/// @file
/// Checks the bytes of a .vdb file before OpenVDB reads them. OpenVDB trusts the lengths and tables of a file: one
/// damaged byte can make it write outside its buffers, allocate all memory or hang. So this check walks through the
/// whole file first.
namespace hapticut {

/// Description of a grid in its file.
struct VdbEntry {
  std::string name;          ///< may be empty
  std::string type;          ///< type of its values: "float", "int32", "vec3s", "ptdataidx32" ...
  std::uint64_t memory = 0;  ///< [bytes] memory of its tree, once it is read; 0 for a removed grid
};

/// Checks the bytes of a .vdb file and keeps only the grids that a workpiece can use: float and int32.
/// @param bytes  the whole file; other grids and hints for delayed loading are removed or made unreadable
/// @return all grids of the file, including the removed ones
/// @throws Error without the name of the file
std::vector<VdbEntry> check_vdb(std::string& bytes);

/// Throws the error of a damaged file.
/// @param what  the problem: "tree is not in order"
[[noreturn]] inline void damaged_vdb(const std::string& what) {
  throw Error("its " + what + ": it is damaged. Get a complete copy.");
}

/// Storage format of the values of one grid.
struct VdbStorage {
  std::uint32_t compression = 0;  ///< flags of openvdb::io
  bool half = false;              ///< real values as 16 bits
};

/// Walks through the nodes and values of a tree of float or int32 with the usual 32^3, 16^3 and 8^3 branches.
/// @return [bytes] memory of the tree, once it is read
/// @throws Error without the name of the file, when the tree is damaged
std::uint64_t check_vdb_tree(ByteReader& in, const VdbStorage& storage);

}  // namespace hapticut
