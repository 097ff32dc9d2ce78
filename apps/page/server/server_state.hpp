// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <utility>

#include "page/server/mailbox.hpp"
#include "page/server/page_files.hpp"

namespace hapticut::view {

inline std::string new_token() {
  std::random_device random;
  std::string token;
  for (int n = 0; n < 4; ++n) {
    char text[9];
    std::snprintf(text, sizeof text, "%08x", unsigned(random()));
    token += text;
  }
  return token;
}

/// Compares in a time that does not depend on the number of equal characters.
inline bool is_same(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t n = 0; n < a.size(); ++n) difference |= unsigned(a[n] ^ b[n]);
  return difference == 0;
}

/// The state that all connections share. Only the server's thread accesses it, except the atomic counts.
struct ServerState {
  ServerState(Scene scene, const ViewServerOptions& given)
      : options(given), mailbox(std::move(scene), given.max_waiting_commands), files(read_page_files(given.page)) {}

  [[nodiscard]] bool is_our_host(std::string_view host) const {
    const std::string at = ":" + std::to_string(port);
    return host == "127.0.0.1" + at || host == "localhost" + at;
  }

  void accept(ViewCommand command) {
    const bool is_urgent = std::holds_alternative<Stop>(command) || std::holds_alternative<WriterLeft>(command);
    if (is_urgent && options.on_urgent) options.on_urgent(command);
    mailbox.put_command(std::move(command));
  }

  ViewServerOptions options;
  Mailbox mailbox;
  std::map<std::string, PageFile, std::less<>> files;
  std::string token = new_token();
  int port = 0;
  std::size_t open = 0;  // sockets
  bool has_writer = false;
  std::atomic<std::size_t> connected = 0;
  std::atomic<std::uint64_t> refused = 0;
};

}  // namespace hapticut::view
