// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "hapticut/core/description.hpp"
#include "hapticut/view/protocol.hpp"

namespace hapticut::view {

/// How the page is served.
struct ViewServerOptions {
  int port = 0;
  std::filesystem::path page;
  std::size_t max_connections = 16;
  double commands_per_second = 2000;
  std::size_t max_waiting_commands = 4096;
  std::function<void(const ViewCommand&)> on_urgent;
};

constexpr auto fields_of(Of<ViewServerOptions>) {
  using O = ViewServerOptions;
  return std::tuple{
      field("port", &O::port, "1", Range::between(0, 65535), "to listen at on this machine; 0: any that is free"),
      field("page", &O::page, "folder of the built page, read when the server starts; empty: no files are served"),
      field("max_connections", &O::max_connections, "1", Range::between(1, 1000), "at once; more are closed"),
      field("commands_per_second", &O::commands_per_second, "1/s", Range::positive(),
            "of a page, over a second; more close its connection"),
      field("max_waiting_commands", &O::max_waiting_commands, "1", Range::between(1, 1e6),
            "that nobody has taken; beyond that the oldest is forgotten, but never a Stop"),
      field("on_urgent", &O::on_urgent,
            "called with each Stop and WriterLeft in the thread of the server, before `receive` gives it, so that it "
            "waits for nothing that the program does meanwhile; null: nothing is called"),
  };
}

/// Serves the page and tells it what the loop shows: HTTP for its files and a WebSocket for the rest, on this machine
/// alone (127.0.0.1), in a thread of its own. It knows nothing of the loop: what it is given it sends, what it is told
/// it keeps until it is taken.
///
/// The first page that connects may send commands, all others look on until it has gone and one connects anew. Whoever
/// connects needs the token of `address`, and so does whoever asks for a file that is none of the page's own kinds, as
/// a recording is none; a connection must come from a page of this server: another `Host` or `Origin` is refused. A
/// message that is malformed, too long or too frequent closes the connection, and nothing else.
///
/// A page that reads slowly gets the newest version of each part of the surface and the newest snapshot, never a queue:
/// of each page of the surface one version is kept, for all connections together, and one message is under way to each.
///
/// The functions may be called from any thread; they wait for a mutex, so not from that of the loop.
class ViewServer {
 public:
  /// Begins to listen.
  /// @throws Error when an option is out of range, the port is in use, or the folder cannot be read
  explicit ViewServer(Scene scene, const ViewServerOptions& options = {});
  /// Closes all connections.
  ~ViewServer();
  ViewServer(const ViewServer&) = delete;
  ViewServer& operator=(const ViewServer&) = delete;

  [[nodiscard]] int port() const;
  [[nodiscard]] std::string token() const;    ///< 32 hexadecimal digits, other ones with each server
  [[nodiscard]] std::string address() const;  ///< for a browser, with the token

  void send(const SurfacePage& page);       ///< one without vertices takes back what there was
  void send(const LoopSnapshot& snapshot);  ///< replaces one that was not sent yet
  void send(const Tool& tool);              ///< each of these three too
  void send(std::span<const Control> controls);
  void send(const Instruments& instruments);

  /// Sound, curves and notices of the last second are kept for who reads slowly, no more.
  void send_sound(std::span<const float> samples, std::uint32_t sample_rate);
  /// @param first  tick of the first sample
  /// @param rate   [Hz] of the loop
  void send_trace(std::uint64_t first, std::span<const TraceSample> samples, double rate);
  /// @param text  one sentence, UTF-8
  void send_notice(Severity severity, std::string_view text);

  /// Another workpiece: all pages of the old one are forgotten, and every connection is told of the new one.
  void show(Scene scene);

  /// Takes the oldest command.  @return nothing when there is none
  [[nodiscard]] std::optional<ViewCommand> receive();

  [[nodiscard]] std::size_t connections() const;  ///< pages that are connected
  [[nodiscard]] std::uint64_t refused() const;    ///< connections that were refused or closed for what they said

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hapticut::view
