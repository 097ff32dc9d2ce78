// SPDX-License-Identifier: Apache-2.0
// The view server over 127.0.0.1: permissions to connect and to send, and the messages to a slow reader.
#include "hapticut/view/view_server.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <map>

#include "hapticut/core/errors.hpp"
#include "support/temporary_folder.hpp"
#include "unit/view/command_bytes.hpp"
#include "unit/view/view_client.hpp"

namespace hapticut::view_server_test {
namespace {

using namespace view;
using view_test::ask;
using view_test::Bytes;
using view_test::CommandKind;
using view_test::Page;
using view_test::soon;

Scene scene() { return {{1e-4, {}}, {{"clay", {200, 180, 160}}}}; }

SurfacePage page_at(int x, std::uint64_t version, std::size_t vertices = 3) {
  SurfacePage page;
  page.origin = {x, 0, 0};
  page.version = version;
  page.vertices.resize(vertices);
  page.indices = {0, 1, 2};
  return page;
}

std::uint64_t version_of(const Message& page) {
  std::uint64_t version = 0;
  std::memcpy(&version, page.data() + 16, sizeof version);
  return version;
}

bool is_kind(const std::optional<Message>& message, MessageKind kind) {
  return message && !message->empty() && (*message)[0] == std::uint8_t(kind);
}

bool is_writer(const Message& hello) { return hello.at(4) == 1; }

/// Waits for the next command.
std::optional<ViewCommand> heard(ViewServer& server) {
  std::optional<ViewCommand> command;
  (void)soon([&] { return (command = server.receive()).has_value(); });
  return command;
}

TEST(ViewServer, SendsANewPageTheSceneAndThenTheState) {
  ViewServer server(scene());
  server.send(page_at(0, 1));
  server.send(page_at(32, 2));
  LoopSnapshot snapshot;
  snapshot.tick = 77;
  server.send(snapshot);
  Page page(server);
  ASSERT_TRUE(page.is_open());
  EXPECT_TRUE(is_kind(page.read(), MessageKind::hello));
  std::map<MessageKind, int> counts;
  for (int n = 0; n < 3; ++n) ++counts[MessageKind(page.read().value().at(0))];
  EXPECT_EQ(counts[MessageKind::page], 2);
  EXPECT_EQ(counts[MessageKind::snapshot], 1);
  server.send(page_at(64, 3));
  const auto next = page.read();
  ASSERT_TRUE(is_kind(next, MessageKind::page));
  EXPECT_EQ(version_of(*next), 3U);
  server.send_sound(std::vector<float>(480, 0.1F), 48'000);
  EXPECT_TRUE(is_kind(page.read(), MessageKind::sound));
}

TEST(ViewServer, RefusesARequestWithoutItsTokenOrFromAnotherOrigin) {
  ViewServer server(scene());
  EXPECT_EQ(server.token().size(), 32U);
  EXPECT_NE(server.token(), ViewServer(scene()).token());
  EXPECT_EQ(server.address(), "http://127.0.0.1:" + std::to_string(server.port()) + "/?token=" + server.token());
  const std::string ours = "127.0.0.1:" + std::to_string(server.port());
  EXPECT_EQ(view_test::knock(server, "0123456789abcdef0123456789abcdef", "http://" + ours), 401U);
  EXPECT_EQ(view_test::knock(server, server.token().substr(1), "http://" + ours), 401U);
  EXPECT_EQ(view_test::knock(server, server.token(), "http://example.org"), 403U);
  EXPECT_EQ(view_test::knock(server, server.token(), "https://" + ours), 403U);
  EXPECT_EQ(view_test::knock(server, server.token(), ""), 403U);
  EXPECT_EQ(view_test::knock(server, server.token(), "http://" + ours, "/other"), 403U);
  EXPECT_EQ(ask(server, "/", "example.org").result_int(), 403U) << "another host name that resolves to this machine";
  EXPECT_EQ(server.refused(), 7U);
  EXPECT_EQ(server.connections(), 0U);
  EXPECT_EQ(view_test::knock(server, server.token(), "http://localhost:" + std::to_string(server.port())), 101U);
  EXPECT_EQ(view_test::knock(server, server.token(), "http://" + ours), 101U);
}

TEST(ViewServer, HasOneWriterAndOtherPagesWatch) {
  ViewServer server(scene());
  auto first = std::make_unique<Page>(server);
  EXPECT_TRUE(is_writer(first->read().value()));
  Page second(server);
  EXPECT_FALSE(is_writer(second.read().value()));
  EXPECT_EQ(server.connections(), 2U);
  first->write(Bytes(CommandKind::set_spindle_speed).add(3000.0).bytes);
  const auto command = heard(server);
  ASSERT_TRUE(command);
  EXPECT_EQ(std::get<commands::SetSpindleSpeed>(*command).speed, 3000);
  second.write(Bytes(CommandKind::set_spindle_speed).add(1.0).bytes);
  EXPECT_TRUE(second.is_thrown_out());
  EXPECT_FALSE(server.receive().has_value());
  first->close();
  first.reset();
  const auto left = heard(server);
  ASSERT_TRUE(left);
  EXPECT_TRUE(std::holds_alternative<WriterLeft>(*left));
  Page third(server);
  EXPECT_TRUE(is_writer(third.read().value())) << "the next page that connects";
}

TEST(ViewServer, AWriterThatIsTornAwayHasLeft) {
  ViewServer server(scene());
  {
    Page page(server);
    ASSERT_TRUE(page.read());
  }  // without a close message, like a killed process
  const auto left = heard(server);
  ASSERT_TRUE(left);
  EXPECT_TRUE(std::holds_alternative<WriterLeft>(*left));
  EXPECT_TRUE(soon([&] { return server.connections() == 0; }));
}

TEST(ViewServer, ClosesAConnectionThatSendsAMalformedCommand) {
  ViewServer server(scene());
  std::vector<std::uint8_t> long_one(kMaxCommand + 1, 0);
  for (const auto& bytes :
       {std::vector<std::uint8_t>{}, {1, 2, 3}, {0xff, 1, 0, 0}, Bytes(CommandKind::look_at).bytes}) {
    Page page(server);
    ASSERT_TRUE(page.read());
    page.write(bytes);
    EXPECT_TRUE(page.is_thrown_out());
  }
  {
    Page page(server);
    ASSERT_TRUE(page.read());
    page.write_text("\x03\x01\x00\x00");
    EXPECT_TRUE(page.is_thrown_out()) << "text messages are no commands";
  }
  Page page(server);
  ASSERT_TRUE(page.read());
  page.write(long_one);
  while (page.read()) {
  }
  EXPECT_TRUE(soon([&] { return server.refused() == 6; })) << server.refused();
  while (const auto command = server.receive()) EXPECT_TRUE(std::holds_alternative<WriterLeft>(*command));
}

TEST(ViewServer, ReportsAStopAndALostWriterBeforeCommandsAreReceived) {
  std::atomic<int> stops{0}, left{0}, others{0};
  ViewServerOptions options;
  options.on_urgent = [&](const ViewCommand& command) {
    ++(std::holds_alternative<Stop>(command) ? stops : std::holds_alternative<WriterLeft>(command) ? left : others);
  };
  ViewServer server(scene(), options);
  {
    Page page(server);
    ASSERT_TRUE(page.read());
    page.write(Bytes(CommandKind::undo).bytes);
    page.write(Bytes(CommandKind::stop).bytes);
    EXPECT_TRUE(soon([&] { return stops == 1; }));
  }
  EXPECT_TRUE(soon([&] { return left == 1; }));
  EXPECT_EQ(others, 0);
}

TEST(ViewServer, GivesARecordingOnlyWithTheToken) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "index.html") << "<html>";
  std::ofstream(folder / "recording.bin") << "HCRP";
  ViewServerOptions options;
  options.page = folder / "";
  const ViewServer server(scene(), options);
  EXPECT_EQ(ask(server, "/index.html").result_int(), 200U);
  EXPECT_EQ(ask(server, "/recording.bin").result_int(), 401U);
  EXPECT_EQ(ask(server, "/recording.bin?token=" + std::string(32, '0')).result_int(), 401U);
  EXPECT_EQ(ask(server, "/recording.bin?token=" + server.token()).body(), "HCRP");
}

TEST(ViewServer, ClosesAConnectionThatSendsTooManyCommands) {
  ViewServerOptions options;
  options.commands_per_second = 50;
  ViewServer server(scene(), options);
  Page page(server);
  ASSERT_TRUE(page.read());
  for (int n = 0; n < 1000 && page.is_open(); ++n) page.write(Bytes(CommandKind::set_undo_mark).bytes);
  page.error = {};
  while (page.read()) {
  }
  EXPECT_TRUE(soon([&] { return server.refused() == 1; }));
  int marks = 0;
  while (const auto command = server.receive())
    marks += std::holds_alternative<commands::SetUndoMark>(*command) ? 1 : 0;
  EXPECT_GE(marks, 50);
  EXPECT_LT(marks, 500);
}

TEST(ViewServer, KeepsTheStopAndTheNewestPlaceOfTheHand) {
  ViewServerOptions options;
  options.max_waiting_commands = 5;
  ViewServer server(scene(), options);
  Page page(server);
  ASSERT_TRUE(page.read());
  page.write(Bytes(CommandKind::stop).bytes);
  for (int n = 0; n < 20; ++n) page.write(Bytes(CommandKind::set_undo_mark).bytes);
  for (int n = 1; n <= 100; ++n)
    page.write(
        Bytes(CommandKind::move_hand).add(Pose::from_translation(Vec3(0.001 * n, 0, 0))).add(std::uint8_t(1)).bytes);
  page.close();
  ASSERT_TRUE(soon([&] { return server.connections() == 0; }));
  std::vector<ViewCommand> commands;
  while (const auto command = server.receive()) commands.push_back(*command);
  ASSERT_EQ(commands.size(), 5U);
  EXPECT_TRUE(std::holds_alternative<Stop>(commands.front()));
  EXPECT_TRUE(std::holds_alternative<WriterLeft>(commands.back()));
  EXPECT_EQ(std::get<MoveHand>(commands[3]).X_WH.translation.x(), 0.1);
}

TEST(ViewServer, ASlowPageGetsTheNewestAndNoQueue) {
  ViewServer server(scene());
  Page slow(server);
  ASSERT_TRUE(slow.read());
  // The slow page does not read a hundred megabytes, more than any socket buffers.
  constexpr std::uint64_t kVersions = 2000;
  for (std::uint64_t version = 1; version <= kVersions; ++version) {
    server.send(page_at(32 * int(version % 2), version, 4096));
    LoopSnapshot snapshot;
    snapshot.tick = version;
    server.send(snapshot);
  }
  Page quick(server);  // the slow page does not delay the quick one
  ASSERT_TRUE(is_kind(quick.read(), MessageKind::hello));
  std::map<int, std::uint64_t> newest;
  std::size_t messages = 0;
  while (newest[0] != kVersions || newest[32] != kVersions - 1) {
    const auto message = slow.read();
    ASSERT_TRUE(message);
    ++messages;
    if (!is_kind(message, MessageKind::page)) continue;
    std::int32_t x = 0;
    std::memcpy(&x, message->data() + 4, sizeof x);
    EXPECT_GT(version_of(*message), newest[x]);
    newest[x] = version_of(*message);
  }
  EXPECT_LT(messages, 1000U) << "of 4000";
}

TEST(ViewServer, AnotherSceneForgetsThePagesOfTheOldOne) {
  ViewServer server(scene());
  server.send(page_at(0, 1));
  Page page(server);
  EXPECT_TRUE(is_kind(page.read(), MessageKind::hello));
  EXPECT_TRUE(is_kind(page.read(), MessageKind::page));
  Scene other = scene();
  other.frame.voxel_size = 2e-4;
  server.show(other);
  server.send(page_at(96, 2));
  const auto hello = page.read();
  ASSERT_TRUE(is_kind(hello, MessageKind::hello));
  double voxel_size = 0;
  std::memcpy(&voxel_size, hello->data() + 8, sizeof voxel_size);
  EXPECT_EQ(voxel_size, 2e-4);
  const auto next = page.read();
  ASSERT_TRUE(is_kind(next, MessageKind::page));
  EXPECT_EQ(version_of(*next), 2U);
}

TEST(ViewServer, ServesTheFilesOfThePageAndNothingElse) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "page/assets");
  std::ofstream(folder / "page/index.html") << "<p>here</p>";
  std::ofstream(folder / "page/assets/app.js") << "1;";
  std::ofstream(folder / "secret") << "no";
  std::filesystem::create_symlink(folder / "secret", folder / "page/link");
  ViewServerOptions options;
  options.page = folder / "page";
  ViewServer server(scene(), options);
  const auto index = ask(server, "/?token=" + server.token());
  EXPECT_EQ(index.result_int(), 200U);
  EXPECT_EQ(index.body(), "<p>here</p>");
  EXPECT_EQ(index["Content-Type"], "text/html; charset=utf-8");
  EXPECT_EQ(index["Referrer-Policy"], "no-referrer");
  EXPECT_EQ(ask(server, "/assets/app.js").body(), "1;");
  EXPECT_EQ(ask(server, "/assets/app.js", "", view_test::http::verb::head).result_int(), 200U);
  for (const std::string target :
       {"/../secret", "/%2e%2e/secret", "/assets/../../secret", "/link", "/assets", "//secret"})
    EXPECT_EQ(ask(server, target).result_int(), 404U) << target;
  EXPECT_EQ(ask(server, "/", "", view_test::http::verb::post).result_int(), 405U);
  options.page = folder / "nowhere";
  EXPECT_THROW(ViewServer(scene(), options), Error);
  options.page = folder / "page/assets";
  EXPECT_THROW(ViewServer(scene(), options), Error) << "without index.html";
}

TEST(ViewServer, RefusesAPortInUseAndConnectionsBeyondItsNumber) {
  ViewServerOptions options;
  options.max_connections = 3;
  ViewServer server(scene(), options);
  ViewServerOptions same;
  same.port = server.port();
  try {
    ViewServer other(scene(), same);
    FAIL() << "the port is in use";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("Choose another port"), std::string::npos) << error.what();
  }
  options.port = 70'000;
  EXPECT_THROW(ViewServer(scene(), options), Error);
  Page a(server), b(server), c(server);
  ASSERT_TRUE(a.read() && b.read() && c.read());
  EXPECT_FALSE(Page(server).is_open());
  a.close();
  EXPECT_TRUE(soon([&] { return Page(server).is_open(); })) << "a connection is free again";
}

TEST(ViewServer, SurvivesDataThatIsNotHttp) {
  ViewServer server(scene());
  for (const std::string& noise : {std::string("\x16\x03\x01 hello"), std::string(20'000, 'a'), std::string()}) {
    view_test::asio::io_context context;
    view_test::beast::tcp_stream stream(context);
    stream.connect(view_test::endpoint_of(server));
    view_test::beast::error_code error;
    stream.write_some(view_test::asio::buffer(noise), error);
  }
  EXPECT_EQ(ask(server, "/" + std::string(3000, 'x')).result_int(), 404U);
  EXPECT_TRUE(Page(server).is_open());
}

}  // namespace
}  // namespace hapticut::view_server_test
