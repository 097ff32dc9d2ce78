// SPDX-License-Identifier: Apache-2.0
#include "hapticut/core/build_info.hpp"

#include <fstream>

#include "hapticut/version.hpp"
#include "hapticut_commit.hpp"  // written by cmake/HapticutCommit.cmake

namespace hapticut {
namespace {

std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t start = line.find_first_not_of(" \t", line.find(':') + 1);
    if (start != std::string::npos) return line.substr(start);
  }
  return "unknown";
}

}  // namespace

BuildInfo build_info() { return {HAPTICUT_VERSION, HAPTICUT_COMMIT, HAPTICUT_COMPILER, cpu_model()}; }

}  // namespace hapticut
