// SPDX-License-Identifier: Apache-2.0
// The program that unpacks compressed pictures for the library, frame after frame, over the socket that it is given as
// its input. It may end in any way: the library takes that for a damaged picture.
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

constexpr unsigned kSeconds = 15;                                  // of a frame
constexpr std::uint64_t kLargest = std::uint64_t(1) << 33U;        // [bytes] of a frame and of its file
constexpr std::uint64_t kMemoryBesides = std::uint64_t(1) << 29U;  // [bytes] for the program and its codecs
constexpr std::uint64_t kCopiesOfAFrame = 16;                      // that codecs hold of it, in wider numbers

/// @return the values of the frame; empty: it cannot be read
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
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // it has no use without the program that started it
  ::signal(SIGPIPE, SIG_IGN);
  limit(RLIMIT_CORE, 0);
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  gdcm::Trace::DebugOff();
  std::uint64_t most = 0;
  for (std::uint64_t lengths[2]; take(reinterpret_cast<char*>(lengths), sizeof lengths);) {
    if (lengths[0] > kLargest || lengths[1] > kLargest) return 1;
    most = std::max(most, kMemoryBesides + kCopiesOfAFrame * lengths[1] + 4 * lengths[0]);
    limit(RLIMIT_AS, most);
    ::alarm(kSeconds);
    std::string file(lengths[0], '\0');
    if (!take(file.data(), file.size())) return 1;
    const std::string values = unpacked(file);
    const std::uint64_t length = values.size();
    if (!give(reinterpret_cast<const char*>(&length), sizeof length) || !give(values.data(), values.size())) return 1;
    ::alarm(0);
  }
  return 0;
}
