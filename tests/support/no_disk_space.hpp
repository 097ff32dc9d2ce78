// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signal.h>
#include <sys/resource.h>

namespace hapticut::test {

/// During its lifetime no file of this process can grow beyond a few bytes: writing fails as on a full disk.
class NoDiskSpace {
 public:
  explicit NoDiskSpace(rlim_t bytes = 64) {
    previous_handler_ = ::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &previous_);
    rlimit limit = previous_;
    limit.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~NoDiskSpace() {
    ::setrlimit(RLIMIT_FSIZE, &previous_);
    ::signal(SIGXFSZ, previous_handler_);
  }
  NoDiskSpace(const NoDiskSpace&) = delete;
  NoDiskSpace& operator=(const NoDiskSpace&) = delete;

 private:
  rlimit previous_{};
  void (*previous_handler_)(int) = nullptr;
};

}  // namespace hapticut::test
