// SPDX-License-Identifier: Apache-2.0
// Program that unpacks compressed pictures for the library. It reads frames from, and writes values to, the socket at
// standard input. If it ends in any way, the library reports a damaged picture.
#include <gdcmImageReader.h>
#include <gdcmTrace.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <sstream>
#include <string>

#include "io/child_side.hpp"

namespace {

constexpr unsigned kSeconds = 15;                                  // [s] time for a frame
constexpr std::uint64_t kMaxFrame = std::uint64_t(1) << 33U;       // [bytes] size of a frame and of its file
constexpr std::uint64_t kMemoryBesides = std::uint64_t(1) << 29U;  // [bytes] for the program and its codecs
constexpr std::uint64_t kCopiesOfAFrame = 16;  // copies of a frame that codecs hold, in wider numbers

/// @return values of the frame; empty when it cannot be read
std::string unpacked(const std::string& file) {
  std::istringstream stream(file);
  gdcm::ImageReader reader;
  reader.SetStream(stream);
  if (!reader.Read()) return {};
  const gdcm::Image& image = reader.GetImage();
  std::string values(image.GetBufferLength(), '\0');
  return image.GetBuffer(values.data()) ? values : std::string();
}

}  // namespace

int main() {
  using namespace hapticut::child;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // ends with the program that started it
  ::signal(SIGPIPE, SIG_IGN);
  limit(RLIMIT_CORE, 0);
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  gdcm::Trace::DebugOff();
  std::uint64_t max_memory = 0;
  for (std::uint64_t lengths[2]; read_all(reinterpret_cast<char*>(lengths), sizeof lengths);) {
    if (lengths[0] > kMaxFrame || lengths[1] > kMaxFrame) return 1;
    max_memory = std::max(max_memory, kMemoryBesides + kCopiesOfAFrame * lengths[1] + 4 * lengths[0]);
    limit(RLIMIT_AS, max_memory);
    ::alarm(kSeconds);
    std::string file(lengths[0], '\0');
    if (!read_all(file.data(), file.size())) return 1;
    const std::string values = unpacked(file);
    const std::uint64_t length = values.size();
    if (!write_all(reinterpret_cast<const char*>(&length), sizeof length) || !write_all(values.data(), values.size()))
      return 1;
    ::alarm(0);
  }
  return 0;
}
