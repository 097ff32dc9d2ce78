// SPDX-License-Identifier: Apache-2.0
#include "cli/json_file.hpp"

#include "io/atomic_file.hpp"

namespace hapticut::cli {

void write_json(const std::filesystem::path& path, const Json& report) {
  if (path.empty()) return;
  write_atomically(path, [&](std::ostream& stream) { stream << report.dump(2) << '\n'; });
}

}  // namespace hapticut::cli
