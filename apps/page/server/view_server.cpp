// SPDX-License-Identifier: Apache-2.0
// The one file that includes Boost.Beast.
#include "hapticut/view/view_server.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <deque>
#include <list>
#include <map>
#include <set>
#include <thread>

#include "page/server/server_state.hpp"

namespace hapticut::view {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;
using ErrorCode = beast::error_code;
using Clock = std::chrono::steady_clock;
using Request = http::request<http::empty_body>;

constexpr auto kTimeout = std::chrono::seconds(10);  // for a request, and for the response to a ping
constexpr unsigned kMaxHeader = 8192;                // [bytes] size of a request's header
constexpr const char* kWrongToken = "the token is wrong; open the address that the program has printed.";

std::string_view view_of_text(beast::string_view text) { return {text.data(), text.size()}; }

/// A connected page.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(ServerState& server, beast::tcp_stream&& stream, std::list<std::weak_ptr<Connection>>& all)
      : server_(server), all_(all), socket_(std::move(stream)), tokens_(max_at_once()) {}
  ~Connection() {
    --server_.open;
    if (!accepted_) return;
    --server_.connected;
    if (!writer_) return;
    server_.has_writer = false;
    server_.accept(WriterLeft{});
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void accept(const Request& request) {
    beast::get_lowest_layer(socket_).expires_never();
    websocket::stream_base::timeout timeouts{};
    timeouts.handshake_timeout = kTimeout;
    timeouts.idle_timeout = kTimeout;
    timeouts.keep_alive_pings = true;
    socket_.set_option(timeouts);
    socket_.read_message_max(kMaxCommand);
    socket_.binary(true);
    socket_.async_accept(request, [self = shared_from_this()](ErrorCode error) {
      if (!error) self->begin();
    });
  }

  void announce(const std::vector<VoxelIndex>& pages) {
    for (const VoxelIndex& origin : pages)
      if (is_due_.insert(origin).second) due_.push_back(origin);
    send_next();
  }

 private:
  void begin() {
    accepted_ = true;
    ++server_.connected;
    writer_ = !std::exchange(server_.has_writer, true);
    last_timed_ = server_.mailbox.last_timed();
    all_.push_back(weak_from_this());
    read();
    announce(server_.mailbox.all_pages());
  }

  void read() {
    socket_.async_read(buffer_, [self = shared_from_this()](ErrorCode error, std::size_t) {
      if (error == websocket::error::message_too_big) ++self->server_.refused;
      if (error) return self->drop();
      self->handle_message();
    });
  }

  void handle_message() {
    const auto bytes = buffer_.data();
    auto command = decode_command({static_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    buffer_.consume(buffer_.size());
    const auto now = Clock::now();
    const double more = server_.options.commands_per_second * std::chrono::duration<double>(now - last_).count();
    tokens_ = std::min(max_at_once(), tokens_ + more) - 1;
    last_ = now;
    if (!command || !writer_ || tokens_ < 0 || !socket_.got_binary()) {
      ++server_.refused;
      return close();
    }
    server_.accept(std::move(*command));
    read();
  }

  [[nodiscard]] double max_at_once() const { return std::max(1.0, server_.options.commands_per_second); }

  void close() {
    closing_ = true;
    socket_.async_close(websocket::close_reason(websocket::close_code::policy_error),
                        [self = shared_from_this()](ErrorCode) {});
  }

  void drop() {
    closing_ = true;
    beast::get_lowest_layer(socket_).close();
  }

  /// The next message: first the scene, then timed messages, then in turn the newest of the loop and of the surface.
  SharedMessage next() {
    if (const std::uint64_t scenes = server_.mailbox.scenes(); scenes != scene_) {
      const auto [number, scene] = server_.mailbox.scene();
      scene_ = number;
      due_.clear(), is_due_.clear(), sent_pages_.clear();
      for (const VoxelIndex& origin : server_.mailbox.all_pages())
        if (is_due_.insert(origin).second) due_.push_back(origin);
      return std::make_shared<const Message>(encode_hello(scene, writer_));
    }
    if (const auto timed = server_.mailbox.timed_after(last_timed_)) {
      last_timed_ = timed->number;
      return timed->message;
    }
    if (due_.empty() || !was_newest_)
      if (SharedMessage message = next_newest()) {
        was_newest_ = true;
        return message;
      }
    was_newest_ = false;
    while (!due_.empty()) {
      const VoxelIndex origin = due_.front();
      due_.pop_front();
      is_due_.erase(origin);
      // A page that changes while its newest version is being sent may already have this number.
      if (const auto [number, page] = server_.mailbox.page(origin); page != nullptr)
        if (std::exchange(sent_pages_[origin], number) != number) return page;
    }
    return nullptr;
  }

  /// The next message of a NewestKind that this connection has not received; the kinds take turns.
  SharedMessage next_newest() {
    for (std::size_t n = 0; n < kNewestKinds; ++n) {
      kind_ = (kind_ + 1) % kNewestKinds;
      const auto [number, message] = server_.mailbox.newest(NewestKind(kind_));
      if (message == nullptr || number == sent_[kind_]) continue;
      sent_[kind_] = number;
      return message;
    }
    return nullptr;
  }

  void send_next() {
    if (writing_ || closing_ || !accepted_) return;
    SharedMessage message = next();
    if (message == nullptr) return;
    writing_ = true;
    socket_.async_write(asio::buffer(*message), [self = shared_from_this(), message](ErrorCode error, std::size_t) {
      self->writing_ = false;
      if (error) return self->drop();
      self->send_next();
    });
  }

  ServerState& server_;
  std::list<std::weak_ptr<Connection>>& all_;
  websocket::stream<beast::tcp_stream> socket_;
  beast::flat_buffer buffer_;
  bool accepted_ = false, writer_ = false, writing_ = false, closing_ = false, was_newest_ = false;
  std::deque<VoxelIndex> due_;  // pages whose newest version is not yet sent
  std::set<VoxelIndex> is_due_;
  std::map<VoxelIndex, std::uint64_t> sent_pages_;  // numbers of the sent versions
  std::uint64_t scene_ = 0, last_timed_ = 0;        // numbers of the last sent
  std::array<std::uint64_t, kNewestKinds> sent_{};
  std::size_t kind_ = 0;
  double tokens_;  // [commands] that the page may send at once
  Clock::time_point last_ = Clock::now();
};

/// One HTTP request: for a file, or for a connection.
class HttpSession : public std::enable_shared_from_this<HttpSession> {
 public:
  HttpSession(ServerState& server, Tcp::socket&& socket, std::list<std::weak_ptr<Connection>>& all)
      : server_(server), all_(all), stream_(std::move(socket)) {
    ++server_.open;
  }
  ~HttpSession() {
    if (!handed_over_) --server_.open;
  }
  HttpSession(const HttpSession&) = delete;
  HttpSession& operator=(const HttpSession&) = delete;

  void begin() {
    parser_.header_limit(kMaxHeader);
    parser_.body_limit(0);
    stream_.expires_after(kTimeout);
    http::async_read(stream_, buffer_, parser_, [self = shared_from_this()](ErrorCode error, std::size_t) {
      if (!error) self->handle_request();
    });
  }

 private:
  void handle_request() {
    const Request& request = parser_.get();
    const std::string_view target = view_of_text(request.target());
    const std::string_view path = target.substr(0, target.find('?'));
    if (!server_.is_our_host(view_of_text(request[http::field::host])))
      return refuse(http::status::forbidden, "this server only answers requests to 127.0.0.1 and localhost.");
    if (websocket::is_upgrade(request)) return connect(request, path, target);
    if (request.method() != http::verb::get && request.method() != http::verb::head)
      return refuse(http::status::method_not_allowed, "only GET and HEAD are allowed.");
    const auto file = server_.files.find(path);
    if (file == server_.files.end())
      return reply(http::status::not_found, "text/plain",
                   server_.files.empty() ? "This server was started without a page." : "There is no such file.");
    if (file->second.is_data() && !has_token(target.substr(path.size())))
      return refuse(http::status::unauthorized, kWrongToken);
    reply(http::status::ok, file->second.type, file->second.content);
  }

  /// @param rest  the part of a target behind its path
  [[nodiscard]] bool has_token(std::string_view rest) const {
    constexpr std::string_view kToken = "?token=";
    return rest.substr(0, kToken.size()) == kToken && is_same(rest.substr(kToken.size()), server_.token);
  }

  void connect(const Request& request, std::string_view path, std::string_view target) {
    const std::string_view origin = view_of_text(request[http::field::origin]);
    constexpr std::string_view kScheme = "http://";
    if (path != "/socket" || origin.substr(0, kScheme.size()) != kScheme ||
        !server_.is_our_host(origin.substr(std::min(origin.size(), kScheme.size()))))
      return refuse(http::status::forbidden, "only pages of this server may connect.");
    if (!has_token(target.substr(path.size()))) return refuse(http::status::unauthorized, kWrongToken);
    handed_over_ = true;
    std::make_shared<Connection>(server_, std::move(stream_), all_)->accept(request);
  }

  void refuse(http::status status, const std::string& why) {
    ++server_.refused;
    reply(status, "text/plain", why);
  }

  void reply(http::status status, const char* type, const std::string& content) {
    auto response = std::make_shared<http::response<http::string_body>>(status, parser_.get().version());
    response->set(http::field::content_type, type);
    response->set(http::field::cache_control, "no-store");
    response->set("Content-Security-Policy",
                  "default-src 'self'; connect-src 'self' ws://127.0.0.1:* ws://localhost:*; "
                  "style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:");
    response->set("X-Content-Type-Options", "nosniff");
    response->set("Referrer-Policy", "no-referrer");  // the token is in the address
    response->keep_alive(false);
    response->content_length(content.size());
    if (parser_.get().method() != http::verb::head) response->body() = content;
    http::async_write(stream_, *response, [self = shared_from_this(), response](ErrorCode, std::size_t) {
      ErrorCode ignored;
      self->stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
    });
  }

  ServerState& server_;
  std::list<std::weak_ptr<Connection>>& all_;
  beast::tcp_stream stream_;
  beast::flat_buffer buffer_;
  http::request_parser<http::empty_body> parser_;
  bool handed_over_ = false;
};

}  // namespace

struct ViewServer::State {
  State(Scene scene, const ViewServerOptions& options) : server(std::move(scene), options) {
    const Tcp::endpoint here(asio::ip::address_v4::loopback(), std::uint16_t(options.port));
    ErrorCode error;
    acceptor.open(here.protocol(), error);
    if (!error) acceptor.set_option(Tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor.bind(here, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error)
      throw Error("the page cannot be served at port " + std::to_string(options.port) +
                  " of 127.0.0.1: " + error.message() + ". Choose another port, or 0 for any free port.");
    server.port = acceptor.local_endpoint().port();
    listen();
    thread = std::thread([this] {
      while (!context.stopped()) {
        try {
          context.run();
        } catch (const std::exception&) {  // no memory for a message: that message is lost
        }
      }
    });
  }
  ~State() {
    context.stop();
    thread.join();
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void listen() {
    acceptor.async_accept([this](ErrorCode error, Tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (error) return listen_later();
      if (server.open < server.options.max_connections)
        std::make_shared<HttpSession>(server, std::move(socket), all)->begin();
      else
        ++server.refused;
      listen();
    });
  }

  /// Without the pause, a system without free sockets would report the error in a busy loop.
  void listen_later() {
    pause.expires_after(std::chrono::milliseconds(100));
    pause.async_wait([this](ErrorCode error) {
      if (!error) listen();
    });
  }

  void wake() {
    asio::post(context, [this] {
      const std::vector<VoxelIndex> changed = server.mailbox.drain_changed();
      for (auto one = all.begin(); one != all.end();) {
        const auto connection = one->lock();
        if (connection != nullptr) connection->announce(changed);
        one = connection != nullptr ? std::next(one) : all.erase(one);
      }
    });
  }

  ServerState server;  // outlives the connections, which the context owns
  std::list<std::weak_ptr<Connection>> all;
  asio::io_context context{1};
  Tcp::acceptor acceptor{context};
  asio::steady_timer pause{context};
  std::thread thread;
};

ViewServer::ViewServer(Scene scene, const ViewServerOptions& options) {
  require_fields_within(options, "ViewServerOptions::");
  state_ = std::make_unique<State>(std::move(scene), options);
}
ViewServer::~ViewServer() = default;

int ViewServer::port() const { return state_->server.port; }
std::string ViewServer::token() const { return state_->server.token; }
std::string ViewServer::address() const { return "http://127.0.0.1:" + std::to_string(port()) + "/?token=" + token(); }

void ViewServer::send(const SurfacePage& page) {
  if (state_->server.mailbox.put(page)) state_->wake();
}
void ViewServer::send(const LoopSnapshot& snapshot) {
  if (state_->server.mailbox.put(NewestKind::snapshot, encode(snapshot))) state_->wake();
}
void ViewServer::send(const Tool& tool) {
  if (state_->server.mailbox.put(NewestKind::tool, encode(tool))) state_->wake();
}
void ViewServer::send(std::span<const Control> controls) {
  if (state_->server.mailbox.put(NewestKind::controls, encode(controls))) state_->wake();
}
void ViewServer::send(const Instruments& instruments) {
  if (state_->server.mailbox.put(NewestKind::instruments, encode(instruments))) state_->wake();
}
void ViewServer::send(const Heat& heat) {
  if (state_->server.mailbox.put(NewestKind::heat, encode(heat))) state_->wake();
}
void ViewServer::send_sound(std::span<const float> samples, std::uint32_t sample_rate) {
  if (samples.empty() || sample_rate == 0) return;
  const double seconds = double(samples.size()) / sample_rate;
  if (state_->server.mailbox.put_timed(encode_sound(samples, sample_rate), seconds)) state_->wake();
}
void ViewServer::send_trace(std::uint64_t first, std::span<const TraceSample> samples, double rate) {
  if (samples.empty() || !(rate > 0)) return;
  if (state_->server.mailbox.put_timed(encode_trace(first, samples), double(samples.size()) / rate)) state_->wake();
}
void ViewServer::send_notice(Severity severity, std::string_view text) {
  constexpr double kSeconds = 0.02;  // [s] so that many notices drop old ones
  if (state_->server.mailbox.put_timed(encode_notice(severity, text), kSeconds)) state_->wake();
}
void ViewServer::show(Scene scene) {
  if (state_->server.mailbox.put(std::move(scene))) state_->wake();
}
std::optional<ViewCommand> ViewServer::receive() { return state_->server.mailbox.pop_command(); }
std::size_t ViewServer::connections() const { return state_->server.connected; }
std::uint64_t ViewServer::refused() const { return state_->server.refused; }

}  // namespace hapticut::view
