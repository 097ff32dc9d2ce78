// SPDX-License-Identifier: Apache-2.0
#include "reports/json_file.hpp"

#include <system_error>

#include "hapticut/core/build_info.hpp"
#include "io/atomic_file.hpp"
#include "reports/delivery.hpp"

namespace hapticut::apps {

Json build_json() {
  const BuildInfo build = build_info();
  return {{"version", build.version}, {"commit", build.commit}, {"compiler", build.compiler}, {"cpu", build.cpu}};
}

void require_writable(const std::filesystem::path& path) {
  if (path.empty()) return;
  std::error_code refused;
  const std::filesystem::file_status status = std::filesystem::status(path, refused);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
      !std::filesystem::is_directory(status))
    throw Error("cannot write '" + path.string() +
                "': it exists and is not a regular file. Give another name; a file of text can be -, which is standard "
                "output.");
  // If this fails, writing the file fails too and reports the reason.
  std::filesystem::create_directories(path.parent_path(), refused);
  const AtomicFile unused(path);
}

void write_json(Delivery& delivery, const std::string& file, const Json& report) {
  delivery.write(file, [&] { write_text(file, report.dump(2) + '\n'); });
}

settings::Setting json_setting(std::string& file) {
  return settings::path("output.json", "--json", file, "report in JSON; -: to standard output", {kStandardOutput});
}

}  // namespace hapticut::apps
