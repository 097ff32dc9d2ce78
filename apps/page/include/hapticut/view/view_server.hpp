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

/// Options of a view server.
struct ViewServerOptions {
  int port = 0;  ///< [1] port of 127.0.0.1 to listen at; 0: any free port
  /// Folder of the built page, read when the server starts; empty: no files are served
  std::filesystem::path page;
  std::size_t max_connections = 16;  ///< [1] connections at a time; more are closed
  /// [1/s] that a page may send, averaged over a second; more close its connection
  double commands_per_second = 2000;
  /// [1] commands in the queue; when it is full, the oldest is dropped, but never a Stop or WriterLeft
  std::size_t max_waiting_commands = 4096;
  /// Called with each Stop and WriterLeft in the thread of the server, before `receive` returns it, so that a busy
  /// program does not delay them; null: nothing is called
  std::function<void(const ViewCommand&)> on_urgent;
};

constexpr auto fields_of(Of<ViewServerOptions>) {
  using O = ViewServerOptions;
  return std::tuple{
      field("port", &O::port, "1", Range::between(0, 65535), "port of 127.0.0.1 to listen at; 0: any free port"),
      field("page", &O::page, "folder of the built page, read when the server starts; empty: no files are served"),
      field("max_connections", &O::max_connections, "1", Range::between(1, 1000),
            "connections at a time; more are closed"),
      field("commands_per_second", &O::commands_per_second, "1/s", Range::positive(),
            "that a page may send, averaged over a second; more close its connection"),
      field("max_waiting_commands", &O::max_waiting_commands, "1", Range::between(1, 1e6),
            "commands in the queue; when it is full, the oldest is dropped, but never a Stop or WriterLeft"),
      field("on_urgent", &O::on_urgent,
            "called with each Stop and WriterLeft in the thread of the server, before `receive` returns it, so that a "
            "busy program does not delay them; null: nothing is called"),
  };
}

/// Serves the page over HTTP and exchanges messages with it over a WebSocket, on this machine only (127.0.0.1), in its
/// own thread. It does not depend on a loop: it sends the messages that it is given, and queues commands until
/// `receive` returns them.
///
/// The first page that connects is the writer and may send commands. All other pages only watch. When the writer has
/// disconnected, the next page that connects becomes the writer. A connection needs the token of `address`; so does a
/// request for a data file, such as a recording. A connection must come from a page of this server: another `Host` or
/// `Origin` is refused. A malformed, too long or too frequent message only closes its connection.
///
/// A page that reads slowly receives the newest version of each part of the surface and the newest snapshot, without a
/// queue. The server keeps one version of each page of the surface for all connections, and sends one message at a time
/// to each.
///
/// Any thread may call the functions, except that of the loop, because they wait for a mutex.
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
  [[nodiscard]] std::string token() const;    ///< 32 hexadecimal digits, different for each server
  [[nodiscard]] std::string address() const;  ///< URL for a browser, with the token

  void send(const SurfacePage& page);       ///< a page without vertices removes the previous version
  void send(const LoopSnapshot& snapshot);  ///< replaces a snapshot that is not yet sent
  void send(const Tool& tool);              ///< replaces, like the following three functions
  void send(std::span<const Control> controls);
  void send(const Instruments& instruments);
  void send(const Heat& heat);

  /// Sends samples of sound. The server keeps sound, curves and notices of the last second for slow readers.
  void send_sound(std::span<const float> samples, std::uint32_t sample_rate);
  /// Sends samples for the curves.
  /// @param first  tick of the first sample
  /// @param rate   [Hz] of the loop
  void send_trace(std::uint64_t first, std::span<const TraceSample> samples, double rate);
  /// Sends a notice.
  /// @param text  one sentence, UTF-8
  void send_notice(Severity severity, std::string_view text);

  /// Shows another workpiece: discards all pages of the old workpiece, and sends the new scene to every connection.
  void show(Scene scene);

  /// Removes and returns the oldest command.  @return nothing when the queue is empty
  [[nodiscard]] std::optional<ViewCommand> receive();

  [[nodiscard]] std::size_t connections() const;  ///< number of connected pages

  /// The number of connections that were refused, or closed because of an invalid message.
  [[nodiscard]] std::uint64_t refused() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hapticut::view
