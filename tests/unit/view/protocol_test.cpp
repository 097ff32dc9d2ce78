// SPDX-License-Identifier: Apache-2.0
// Messages match the comment of hapticut/view/protocol.hpp byte by byte; the server accepts nothing else from a page.
#include "hapticut/view/protocol.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "unit/view/command_bytes.hpp"

namespace hapticut::protocol_test {
namespace {

using namespace view;
using view_test::Bytes;
using view_test::CommandKind;
using view_test::kCommandKinds;
using view_test::number_at;

TEST(ViewProtocol, HelloHasTheGridTheMaterialsAndWhetherThePageMayWrite) {
  Scene scene;
  scene.frame = {1e-4, Pose::from_translation(Vec3(1, 2, 3))};
  scene.materials = {{"enamel", {250, 249, 248}}, {std::string(300, 'x'), {1, 2, 3}}};
  const Message message = encode_hello(scene, true);
  EXPECT_EQ(message[0], 1);
  EXPECT_EQ(message[1], kProtocolVersion);
  EXPECT_EQ(number_at<std::uint32_t>(message, 4), 1U);
  EXPECT_EQ(number_at<double>(message, 8), 1e-4);
  EXPECT_EQ(number_at<double>(message, 16), 1) << "first of the rotation";
  EXPECT_EQ(number_at<double>(message, 16 + 72 + 16), 3) << "last of the translation";
  EXPECT_EQ(number_at<std::uint32_t>(message, 112), 2U);
  EXPECT_EQ(std::string(message.begin() + 120, message.begin() + 126), "enamel");
  EXPECT_EQ(message[119], 6);
  constexpr std::size_t kSentences = 120 + 6 + 4 + 255;  // names are cut at 255 bytes
  EXPECT_EQ(number_at<std::uint32_t>(message, kSentences), names_of(Of<ArmingState>{}).size());
  EXPECT_EQ(number_at<std::uint32_t>(message, kSentences + 4), std::uint32_t(ArmingState::off));
  EXPECT_EQ(number_at<std::uint16_t>(message, kSentences + 8), 3) << "\"off\"";
  EXPECT_EQ(number_at<std::uint32_t>(encode_hello(scene, false), 4), 0U);
}

TEST(ViewProtocol, EveryStateOfTheGuardAndEveryBitOfAStepHasASentenceWithItsCure) {
  const Message hello = encode_hello({}, true);
  const std::string text(hello.begin(), hello.end());
  const auto expect_sentence = [&](const auto& one, bool good) {
    ASSERT_NE(one.words, nullptr) << one.name;
    const std::string words = one.words;
    EXPECT_TRUE(words.ends_with('.')) << one.name << ": " << words;
    EXPECT_EQ(words.find(": ") == std::string::npos, good) << one.name << ": " << words;
    EXPECT_NE(text.find(words), std::string::npos) << one.name << " is missing";
  };
  for (const auto& one : names_of(Of<ArmingState>{})) expect_sentence(one, one.value == ArmingState::on);
  for (const auto& one : names_of(Of<StepStatus>{}))
    if (one.value != StepStatus::ok) expect_sentence(one, false);
}

TEST(ViewProtocol, APageIsItsVerticesAndIndicesAsTheyAre) {
  SurfacePage page;
  page.origin = {-32, 0, 64};
  page.version = 7;
  page.vertices = {{{1, -2, 3}, 4, 0, {5, -6, 7}, 0}, {{-512, 16383, 0}, 1, 0, {127, 0, -127}, 0}};
  page.indices = {0, 1, 0};
  const Message message = encode(page);
  EXPECT_EQ(message.size(), 32 + 24 + 6U);
  EXPECT_EQ(message[0], 2);
  EXPECT_EQ(number_at<std::int32_t>(message, 4), -32);
  EXPECT_EQ(number_at<std::int32_t>(message, 12), 64);
  EXPECT_EQ(number_at<std::uint64_t>(message, 16), 7U);
  EXPECT_EQ(number_at<std::uint32_t>(message, 24), 2U);
  EXPECT_EQ(number_at<std::uint32_t>(message, 28), 3U);
  EXPECT_EQ(number_at<std::int16_t>(message, 34), -2);
  EXPECT_EQ(message[38], 4) << "the material";
  EXPECT_EQ(number_at<std::int8_t>(message, 41), -6);
  EXPECT_EQ(number_at<std::int16_t>(message, 44), -512);
  EXPECT_EQ(number_at<std::uint16_t>(message, 58), 1);
}

TEST(ViewProtocol, ASnapshotHasWhatThePanelsShow) {
  LoopSnapshot snapshot;
  snapshot.arming = ArmingState::on;
  snapshot.tick = 12345;
  snapshot.X_WT = Pose::from_translation(Vec3(0.1, 0.2, 0.3));
  snapshot.tool.force = Vec3(1, 2, 3);
  snapshot.tool.spindle_speed = 4000;
  snapshot.tool.contact_voxels = 17;
  snapshot.tool.contact_point_W = Vec3(4, 5, 6);
  snapshot.tool.redoing = true;
  snapshot.blocks_waiting = 9;
  const Message message = encode(snapshot);
  ASSERT_EQ(message.size(), 248U);
  EXPECT_EQ(message[0], 3);
  EXPECT_EQ(number_at<std::uint32_t>(message, 4), std::uint32_t(ArmingState::on));
  EXPECT_EQ(number_at<std::uint64_t>(message, 8), 12345U);
  EXPECT_EQ(number_at<double>(message, 88), 0.1);
  EXPECT_EQ(number_at<double>(message, 112), 1);
  EXPECT_EQ(number_at<double>(message, 184), 4000);
  EXPECT_EQ(number_at<std::uint32_t>(message, 192), 17U);
  EXPECT_EQ(number_at<std::uint32_t>(message, 212), 2U) << "redoing";
  EXPECT_EQ(number_at<std::uint32_t>(message, 220), 9U);
  EXPECT_EQ(number_at<double>(message, 240), 6);
}

TEST(ViewProtocol, SoundIsSixteenBitsAndBounded) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Message message = encode_sound(std::vector<float>{0.5F, -2, nan}, 48'000);
  ASSERT_EQ(message.size(), 12 + 6U);
  EXPECT_EQ(number_at<std::uint32_t>(message, 4), 48'000U);
  EXPECT_EQ(number_at<std::int16_t>(message, 12), 16384);
  EXPECT_EQ(number_at<std::int16_t>(message, 14), -32767);
  EXPECT_EQ(number_at<std::int16_t>(message, 16), 0);
}

TEST(ViewProtocol, CommandsAreDecoded) {
  const auto speed = decode_command(Bytes(CommandKind::set_spindle_speed).add(4188.5).bytes);
  ASSERT_TRUE(speed);
  EXPECT_EQ(std::get<commands::SetSpindleSpeed>(*speed).speed, 4188.5);
  EXPECT_TRUE(std::holds_alternative<commands::SetUndoMark>(*decode_command(Bytes(CommandKind::set_undo_mark).bytes)));
  EXPECT_TRUE(std::holds_alternative<commands::Undo>(*decode_command(Bytes(CommandKind::undo).bytes)));
  EXPECT_TRUE(std::holds_alternative<commands::Redo>(*decode_command(Bytes(CommandKind::redo).bytes)));
  EXPECT_TRUE(std::holds_alternative<Stop>(*decode_command(Bytes(CommandKind::stop).bytes)));
  const auto hold = decode_command(Bytes(CommandKind::hold_force).add(std::uint8_t(0)).bytes);
  EXPECT_FALSE(std::get<commands::HoldForce>(*hold).hold);
  const Pose X_WH = {rotation_from_vector(Vec3(0.1, 0.2, 0.3)), Vec3(0.01, -0.02, 0.03)};
  const auto hand =
      std::get<MoveHand>(*decode_command(Bytes(CommandKind::move_hand).add(X_WH).add(std::uint8_t(1)).bytes));
  EXPECT_EQ(hand.X_WH.rotation, X_WH.rotation);
  EXPECT_EQ(hand.X_WH.translation, X_WH.translation);
  EXPECT_TRUE(hand.pressed);
  const auto look = std::get<LookAt>(*decode_command(Bytes(CommandKind::look_at).add(Vec3(1, 2, 3)).bytes));
  EXPECT_EQ(look.p_WQ, Vec3(1, 2, 3));
}

TEST(ViewProtocol, AMalformedCommandIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto is_refused = [](const Bytes& given) { return !decode_command(given.bytes).has_value(); };
  for (const double speed : {nan, infinity, -infinity, 1e9})
    EXPECT_TRUE(is_refused(Bytes(CommandKind::set_spindle_speed).add(speed))) << speed;
  EXPECT_TRUE(is_refused(Bytes(CommandKind::set_spindle_speed).add(1.0).add(std::uint8_t(0)))) << "too long";
  EXPECT_TRUE(is_refused(Bytes(CommandKind::set_spindle_speed).add(1.0F))) << "too short";
  EXPECT_TRUE(is_refused(Bytes(CommandKind::hold_force).add(std::uint8_t(2))));
  EXPECT_TRUE(is_refused(Bytes(0)));
  EXPECT_TRUE(is_refused(Bytes(kCommandKinds + 1)));
  EXPECT_TRUE(is_refused(Bytes(CommandKind::look_at).add(Vec3(1, nan, 1))));
  EXPECT_TRUE(is_refused(Bytes(CommandKind::look_at).add(Vec3(1, 1e4, 1))));
  Pose bent;
  bent.rotation(0, 0) = 1.5;
  EXPECT_TRUE(is_refused(Bytes(CommandKind::move_hand).add(bent).add(std::uint8_t(1))));
  Pose mirrored;
  mirrored.rotation(0, 0) = -1;
  EXPECT_TRUE(is_refused(Bytes(CommandKind::move_hand).add(mirrored).add(std::uint8_t(1))));
  Bytes other(CommandKind::undo);
  other.bytes[1] = kProtocolVersion + 1;
  EXPECT_TRUE(is_refused(other)) << "another version";
  other = Bytes(CommandKind::undo);
  other.bytes[3] = 1;
  EXPECT_TRUE(is_refused(other));
  EXPECT_FALSE(decode_command({}).has_value());
}

TEST(ViewProtocol, AControlIsSetWithinItsBytes) {
  const Bytes given = Bytes(CommandKind::set_control).add(std::uint16_t(513)).add(-2.5);
  const auto command = std::get<SetControl>(*decode_command(given.bytes));
  EXPECT_EQ(command.id, 513);
  EXPECT_EQ(command.value, -2.5);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(decode_command(Bytes(CommandKind::set_control).add(std::uint16_t(1)).add(nan).bytes));
}

TEST(ViewProtocol, ANameToLoadIsShortAndHasNoControlCharacters) {
  const auto load = [](const std::string& name) {
    Bytes bytes(CommandKind::load);
    for (const char c : name) bytes.add(c);
    return decode_command(bytes.bytes);
  };
  EXPECT_EQ(std::get<Load>(*load("molar")).name, "molar");
  EXPECT_EQ(std::get<Load>(*load(std::string(kMaxName, 'x'))).name.size(), kMaxName);
  EXPECT_FALSE(load(std::string(kMaxName + 1, 'x')));
  EXPECT_FALSE(load(""));
  EXPECT_FALSE(load("a\nb"));
  EXPECT_FALSE(load(std::string("a\0b", 3)));
}

TEST(ViewProtocol, ANameToLoadIsInUtf8) {
  const auto load = [](const std::string& name) {
    Bytes bytes(CommandKind::load);
    for (const char c : name) bytes.add(c);
    return decode_command(bytes.bytes).has_value();
  };
  for (const char* name : {"Z\xc3\xa4hne.toml", "\xe2\x82\xac", "\xf0\x9f\xa6\xb7", "\xc2\xa0", "\xed\x9f\xbf",
                           "\xee\x80\x80", "\xf4\x8f\xbf\xbf"})
    EXPECT_TRUE(load(name)) << name;
  // Bytes that begin nothing, cut off, overlong, surrogates, above 0x10ffff, C1 controls.
  for (const char* name : {"\x80",
                           "\xff",
                           "\xfe",
                           "a\xc3",
                           "\xe2\x82",
                           "\xf0\x9f\xa6",
                           "\xc3(",
                           "\xe2(\xac",
                           "\xc0\xaf",
                           "\xc1\xbf",
                           "\xe0\x80\xaf",
                           "\xe0\x9f\xbf",
                           "\xf0\x80\x80\xaf",
                           "\xf0\x8f\xbf\xbf",
                           "\xed\xa0\x80",
                           "\xed\xbf\xbf",
                           "\xf4\x90\x80\x80",
                           "\xf5\x80\x80\x80",
                           "\xc2\x80",
                           "\xc2\x9f"})
    EXPECT_FALSE(load(name)) << name;
}

RC_GTEST_PROP(ViewProtocol, AnyBytesAreACommandOrNone, ()) {
  auto bytes = *rc::gen::container<std::vector<std::uint8_t>>(rc::gen::arbitrary<std::uint8_t>());
  if (bytes.size() > 3 && *rc::gen::arbitrary<bool>()) {
    bytes[0] = std::uint8_t(1 + bytes[0] % kCommandKinds);
    bytes[1] = kProtocolVersion, bytes[2] = bytes[3] = 0;
  }
  const auto command = decode_command(bytes);
  if (!command) return;
  RC_ASSERT(bytes.size() <= kMaxCommand);
  if (const auto* speed = std::get_if<commands::SetSpindleSpeed>(&*command)) RC_ASSERT(std::isfinite(speed->speed));
  if (const auto* look = std::get_if<LookAt>(&*command)) RC_ASSERT(look->p_WQ.allFinite());
  if (const auto* hand = std::get_if<MoveHand>(&*command)) RC_ASSERT(hand->X_WH.translation.allFinite());
}

}  // namespace
}  // namespace hapticut::protocol_test
