// SPDX-License-Identifier: Apache-2.0
#include "cli/reports/json_file.hpp"

#include <system_error>

#include "hapticut/core/build_info.hpp"
#include "io/atomic_file.hpp"

namespace hapticut::cli {

Json build_json() {
  const BuildInfo build = build_info();
  return {{"version", build.version}, {"commit", build.commit}, {"compiler", build.compiler}, {"cpu", build.cpu}};
}

void require_writable(const std::filesystem::path& path) {
  if (path.empty()) return;
  std::error_code refused;  // if this fails, writing the file fails too and reports the reason
  std::filesystem::create_directories(path.parent_path(), refused);
  const AtomicFile unused(path);
}

void write_json(const std::filesystem::path& path, const Json& report) {
  if (path.empty()) return;
  write_atomically(path, report.dump(2) + '\n');
}

}  // namespace hapticut::cli
