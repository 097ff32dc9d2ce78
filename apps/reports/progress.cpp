// SPDX-License-Identifier: Apache-2.0
#include "reports/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace hapticut::apps {
namespace {

using std::chrono::steady_clock;

constexpr std::chrono::milliseconds kBetween{100};
constexpr std::size_t kWidth = 40;  // characters

/// Prints one line and erases the bar.
void print_line(const std::string& line) {
  std::fprintf(stderr, "%shapticut: %s\n", ::isatty(STDERR_FILENO) == 1 ? "\r\033[K" : "", line.c_str());
}

void tell_of_work(const WorkEstimate& estimate) {
  constexpr double kWorthAWord = 10;  // [s]
  if (estimate.seconds < kWorthAWord) return;
  char line[128];
  std::snprintf(line, sizeof line, "about %.2g voxels, %.2g MB and %.2g s of work.", estimate.voxels,
                estimate.memory_bytes * 1e-6, estimate.seconds);
  print_line(line);
}

}  // namespace

ProgressBar::ProgressBar(std::string what, std::size_t total) : what_(std::move(what)), total_(total) {
  if (::isatty(STDERR_FILENO) != 1) return;
  draw();
  drawer_ = std::thread([this] { run(); });
}

ProgressBar::~ProgressBar() {
  if (!drawer_.joinable()) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    finished_ = true;
  }
  wake_.notify_one();
  drawer_.join();
  wipe();
}

std::unique_lock<std::mutex> ProgressBar::pause() {
  std::unique_lock<std::mutex> lock(mutex_);
  wipe();
  return lock;
}

void ProgressBar::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!wake_.wait_for(lock, kBetween, [this] { return finished_; })) draw();
}

void ProgressBar::draw() {
  if (total_ == 0) {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(steady_clock::now() - start_).count();
    std::fprintf(stderr, "\r%s, %lld s", what_.c_str(), (long long)seconds);
  } else {
    const std::size_t done = std::min(done_.load(std::memory_order_relaxed), total_), filled = kWidth * done / total_;
    const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
    std::fprintf(stderr, "\r%s [%s] %3zu %%", what_.c_str(), bar.c_str(), 100 * done / total_);
  }
  std::fflush(stderr);
  drawn_ = true;
}

void tell_on_stderr(settings::WorkpieceSettings& workpiece) {
  workpiece.tell = tell_of_work;
  workpiece.warn = print_line;
}

void ProgressBar::wipe() {
  if (std::exchange(drawn_, false)) std::fputs("\r\033[K", stderr);
}

}  // namespace hapticut::apps
