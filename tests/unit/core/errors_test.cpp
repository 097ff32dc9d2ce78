// SPDX-License-Identifier: Apache-2.0
// The sentence of an error is safe to show on a terminal, in a page, or as a Python string.
#include "hapticut/core/errors.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>

#include "hapticut/core/description.hpp"
#include "support/refusal.hpp"

namespace hapticut::errors_test {

std::string shown(const std::string& sentence) { return Error(sentence).what(); }

TEST(Errors, KeepTheirSentenceOnOneLine) {
  EXPECT_EQ(shown("a material 'sharp\r\n\tenamel' is unknown."), "a material 'sharp???enamel' is unknown.");
  EXPECT_EQ(shown("\x1b[2J\x7f"), "?[2J?");
  EXPECT_EQ(shown(std::string("a\0b", 3)), "a?b");
  EXPECT_EQ(shown("\xc2\x9b"), "??") << "U+009B starts a terminal command";
  EXPECT_EQ(shown(""), "");
}

TEST(Errors, KeepValidUtf8) {
  for (const char* text :
       {"Zähne/Backenzahn.vdb", "奥歯", "\xf0\x9f\xa6\xb7", "\xc2\xa0", "\xf4\x8f\xbf\xbf", "\xed\x9f\xbf"})
    EXPECT_EQ(shown(text), text);
}

TEST(Errors, MakeUtf8OfAnything) {
  EXPECT_EQ(shown("Z\xe4hne"), "Z?hne") << "Latin-1";
  EXPECT_EQ(shown("\x80"), "?") << "continuation byte without a start";
  EXPECT_EQ(shown("\xe5\xa5"), "??") << "truncated";
  EXPECT_EQ(shown("\xc0\xaf\xc1\xbf"), "????") << "overlong";
  EXPECT_EQ(shown("\xe0\x9f\xbf"), "???") << "overlong";
  EXPECT_EQ(shown("\xf0\x8f\xbf\xbf"), "????") << "overlong";
  EXPECT_EQ(shown("\xed\xa0\x80"), "???") << "half of a UTF-16 pair";
  EXPECT_EQ(shown("\xf4\x90\x80\x80"), "????") << "beyond the last character";
  EXPECT_EQ(shown("\xf8\x88\x80\x80\x80"), "?????") << "five bytes";
}

/// As a front end that has no word for the second name writes it.
std::string shown_elsewhere(const Sentence& sentence) {
  return sentence.written([](const Name& name) {
    return name.scope() == "GuardOptions" ? std::optional<std::string>("the " + std::string(name.member()))
                                          : std::nullopt;
  });
}

TEST(Errors, HaveTheNamesOfTheFrontEnd) {
  const Error error("GuardOptions::period"_name + " = 3; must be at most " + "WatchdogOptions::late"_name + ".");
  EXPECT_STREQ(error.what(), "GuardOptions::period = 3; must be at most WatchdogOptions::late.");
  EXPECT_EQ(shown_elsewhere(error.sentence()), "the period = 3; must be at most late.");
}

TEST(Errors, LeaveOutAClauseAboutWhatTheFrontEndLacks) {
  const Sentence sentence = "it is late" + Sentence::clause("; raise " + "GuardOptions::late"_name) +
                            Sentence::clause(", or " + "read_recording"_name + " later") + ".";
  EXPECT_EQ(sentence.in_cpp(), "it is late; raise GuardOptions::late, or read_recording later.");
  EXPECT_EQ(shown_elsewhere(sentence), "it is late; raise the late.");
}

TEST(Errors, OfChecksNameTheFieldApartFromItsUnit) {
  const auto said = [](const Subject& what) { return shown_elsewhere(Sentence(what)); };
  EXPECT_EQ(said("GuardOptions::period [s]"), "the period [s]");
  EXPECT_EQ(said("GuardOptions::start: dt [s]"), "the start: dt [s]");
  EXPECT_EQ(said("HeatConfig::water.temperature"), "water.temperature");
  EXPECT_EQ(said("voxel size [m]"), "voxel size [m]");
}

TEST(Numbers, InMessagesHaveSixDigitsUnlessTheyWouldLookRoundAndAreNot) {
  EXPECT_EQ(format_number(0.3), "0.3");
  EXPECT_EQ(format_number(0.1 + 0.2), "0.3") << "noise of an operation";
  EXPECT_EQ(format_number(double(0.3F)), "0.3") << "a number in single precision";
  EXPECT_EQ(format_number(1.0 / 3), "0.333333");
  EXPECT_EQ(format_number(1e-5), "1e-05");
  EXPECT_EQ(format_number(2.00000004), "2.00000004");
  EXPECT_EQ(format_number(double(2.0000002F)), "2.0000002");
  EXPECT_EQ(format_number(1000000.5), "1000000.5");
  EXPECT_EQ(format_number(0), "0");
  EXPECT_EQ(format_number(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(Numbers, ThatAreComparedInAMessageNeverLookTheSame) {
  EXPECT_EQ(format_number(0.1 + 0.2, 0.3), "0.30000000000000004");
  EXPECT_EQ(format_number(0.3, 0.1 + 0.2), "0.3");
  EXPECT_EQ(format_number(1.2345678, 1.2345677), "1.2345678");
  EXPECT_EQ(format_number(0.3, 0.3), "0.3");
  const auto said = [](double value) { return test::refusal([&] { require_between(value, 0, 0.3, "x"); }); };
  EXPECT_EQ(said(0.1 + 0.2), "x = 0.30000000000000004; must be between 0 and 0.3.");
  EXPECT_EQ(said(0.3000000001), "x = 0.3000000001; must be between 0 and 0.3.");
  EXPECT_EQ(test::refusal([] { require_within(0.1 + 0.2, Range::between(0, 0.3), "x"); }), said(0.1 + 0.2));
}

}  // namespace hapticut::errors_test
