// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/socket.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "hapticut/view/view_server.hpp"

/// @file
/// A client for tests of the view server over 127.0.0.1.
namespace hapticut::view_test {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;
using Response = http::response<http::string_body>;

/// Waits for a condition that another thread fulfils.  @return whether it is fulfilled
template <class Condition>
bool soon(const Condition& condition) {
  for (int n = 0; n < 2000; ++n) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return condition();
}

inline Tcp::endpoint endpoint_of(const view::ViewServer& server) {
  return {asio::ip::address_v4::loopback(), std::uint16_t(server.port())};
}

/// Requests a file.
/// @param host  empty: the correct one
inline Response ask(const view::ViewServer& server, const std::string& target, const std::string& host = "",
                    http::verb verb = http::verb::get) {
  asio::io_context context;
  beast::tcp_stream stream(context);
  stream.connect(endpoint_of(server));
  http::request<http::empty_body> request{verb, target, 11};
  request.set(http::field::host, host.empty() ? "127.0.0.1:" + std::to_string(server.port()) : host);
  http::write(stream, request);
  beast::flat_buffer buffer;
  http::response_parser<http::string_body> parser;
  parser.skip(verb == http::verb::head);
  http::read(stream, buffer, parser);
  return parser.release();
}

/// Requests a connection with a token.
/// @param origin  empty: no origin
/// @return the status of the response; 101 if the server accepts
inline unsigned knock(const view::ViewServer& server, const std::string& token, const std::string& origin,
                      const std::string& path = "/socket") {
  asio::io_context context;
  beast::tcp_stream stream(context);
  stream.connect(endpoint_of(server));
  http::request<http::empty_body> request{http::verb::get, path + "?token=" + token, 11};
  request.set(http::field::host, "127.0.0.1:" + std::to_string(server.port()));
  request.set(http::field::connection, "Upgrade");
  request.set(http::field::upgrade, "websocket");
  request.set(http::field::sec_websocket_version, "13");
  request.set(http::field::sec_websocket_key, "MDEyMzQ1Njc4OWFiY2RlZg==");
  if (!origin.empty()) request.set(http::field::origin, origin);
  http::write(stream, request);
  beast::flat_buffer buffer;
  http::response_parser<http::string_body> parser;
  http::read_header(stream, buffer, parser);
  return parser.get().result_int();
}

class Page {
 public:
  explicit Page(const view::ViewServer& server) {
    beast::get_lowest_layer(socket_).connect(endpoint_of(server));
    const std::string host = "127.0.0.1:" + std::to_string(server.port());
    socket_.set_option(websocket::stream_base::decorator(
        [=](websocket::request_type& request) { request.set(http::field::origin, "http://" + host); }));
    socket_.handshake(host, "/socket?token=" + server.token(), error);
    socket_.binary(true);
  }

  [[nodiscard]] bool is_open() const { return !error; }

  /// The next message; nothing after the server has closed the connection.
  std::optional<view::Message> read() {
    buffer_.consume(buffer_.size());
    socket_.read(buffer_, error);
    if (error) return std::nullopt;
    const auto* first = static_cast<const std::uint8_t*>(buffer_.data().data());
    return view::Message(first, first + buffer_.size());
  }
  void write(const std::vector<std::uint8_t>& bytes) { socket_.write(asio::buffer(bytes), error); }
  void write_text(const std::string& text) {
    socket_.text(true);
    socket_.write(asio::buffer(text), error);
  }
  /// Reads until the server closes the connection.  @return whether it did so because of an invalid message
  bool is_thrown_out() {
    while (read()) {
    }
    return error == websocket::error::closed && socket_.reason().code == websocket::close_code::policy_error;
  }
  void close() { socket_.close(websocket::close_code::normal, error); }

  /// Disconnects without a close message, also during a read in another thread.
  void vanish() { ::shutdown(beast::get_lowest_layer(socket_).socket().native_handle(), SHUT_RDWR); }

  beast::error_code error;

 private:
  asio::io_context context_;
  websocket::stream<beast::tcp_stream> socket_{context_};
  beast::flat_buffer buffer_;
};

}  // namespace hapticut::view_test
