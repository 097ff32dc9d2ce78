// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <string>

namespace hapticut::test {

/// Peak growth of the memory of this process, in bytes that were really used.
class MemoryGrowth {
 public:
  MemoryGrowth() {
    std::ofstream("/proc/self/clear_refs") << "5";  // forgets earlier peaks, where that is allowed
    start_ = peak_kilobytes();
  }
  [[nodiscard]] double bytes() const { return 1024 * double(peak_kilobytes() - start_); }

 private:
  static long peak_kilobytes() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
      if (long kilobytes = 0; word == "VmHWM:" && status >> kilobytes) return kilobytes;
    return 0;
  }
  long start_;
};

/// Small inputs need far less, even under a sanitizer that keeps freed memory. Hostile inputs claim far more.
inline constexpr double kModestMemory = 512e6;  // [bytes]

}  // namespace hapticut::test
