// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/byte_reader.hpp"

/// @file
/// A walk of our own through the bytes of a .vdb file. OpenVDB believes the lengths and the tables of a file, so that a
/// single damaged byte can make it write outside its buffers, ask for all memory or wait for ever; nothing reaches
/// OpenVDB before this walk has gone from one end of the file to the other.
namespace hapticut {

/// A grid as its file announces it.
struct VdbEntry {
  std::string name;  ///< may be empty
  std::string type;  ///< type of a value: "float", "int32", "vec3s", "ptdataidx32" ...
};

/// Checks the bytes of a .vdb file and leaves in them only what a workpiece can be made of: grids of float and of
/// int32.
/// @param bytes  the whole file; other grids and hints for delayed loading are taken out or made unreadable
/// @return all grids of the file, also those that were taken out
/// @throws Error  what is wrong with the file, as a sentence that begins with "it" or "its"
std::vector<VdbEntry> check_vdb(std::string& bytes);

/// @param what  "tree is not in order"
/// @throws Error  that it is so, and the file damaged
[[noreturn]] inline void damaged_vdb(const std::string& what) {
  throw Error("its " + what + ": it is damaged. Get a complete copy.");
}

/// How the values of one grid are stored.
struct VdbStorage {
  std::uint32_t compression = 0;  ///< flags of openvdb::io
  bool half = false;              ///< real values as 16 bits
};

/// Walks through the nodes and values of a tree of float or int32 with the usual 32^3, 16^3 and 8^3 branches.
/// @throws Error  as above
void check_vdb_tree(ByteReader& in, const VdbStorage& storage);

}  // namespace hapticut
