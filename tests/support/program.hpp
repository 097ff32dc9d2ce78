// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "support/temporary_folder.hpp"

/// @file
/// Runs the command line program as a user does.
namespace hapticut::test {

struct Outcome {
  int code;            // exit code
  std::string out;     // what was printed
  std::string errors;  // what was printed on stderr
};

/// Runs `hapticut <arguments>` with the folder's files `stdout` and `stderr`.
inline Outcome run_program(const TemporaryFolder& folder, const std::string& arguments) {
  const std::string out = (folder / "stdout").string(), errors = (folder / "stderr").string();
  const std::string command =
      std::string(HAPTICUT_PROGRAM) + " " + arguments + " >" + out + " 2>" + errors + " </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_bytes(out), read_bytes(errors)};
}

inline nlohmann::json read_json(const std::filesystem::path& path) {
  std::ifstream stream(path);
  return nlohmann::json::parse(stream);
}

}  // namespace hapticut::test
