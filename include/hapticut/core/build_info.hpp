// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hapticut/core/abi.hpp"

namespace hapticut {

/// Version and build of the library, and the processor it runs on. Reports contain it, so that every result can be
/// traced to a build.
struct BuildInfo {
  std::string version;   ///< version of the compiled library, e.g. "0.1.0"; HAPTICUT_VERSION is that of the headers
  std::string commit;    ///< git commit it was built from, with "-dirty" if files were changed; "" outside git
  std::string compiler;  ///< name and version, e.g. "GNU 12.2.0"
  std::string cpu;       ///< model name of the current processor; "unknown" if the system does not report it
};

/// @realtime set-up only: reads a file
[[nodiscard]] BuildInfo build_info();

}  // namespace hapticut
