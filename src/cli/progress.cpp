// SPDX-License-Identifier: Apache-2.0
#include "cli/progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace hapticut::cli {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr std::size_t kCheckEvery = 64;  // calls between looks at the clock
constexpr std::size_t kWidth = 40;       // characters

}  // namespace

ProgressBar::ProgressBar(std::string what, std::size_t total)
    : what_(std::move(what)),
      total_(total),
      on_terminal_(::isatty(STDERR_FILENO) == 1),
      next_(steady_clock::now() + milliseconds(500)) {}

ProgressBar::~ProgressBar() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::advance_to(std::size_t done) {
  if (!on_terminal_ || done % kCheckEvery != 0 || steady_clock::now() < next_) return;
  next_ = steady_clock::now() + milliseconds(100);
  draw(done);
}

void ProgressBar::draw(std::size_t done) {
  const std::size_t filled = kWidth * done / total_;
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  std::fprintf(stderr, "\r%s [%s] %3zu %%", what_.c_str(), bar.c_str(), 100 * done / total_);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace hapticut::cli
