// SPDX-License-Identifier: Apache-2.0
// The sentence of an error is safe to show on a terminal, in a page, or as a Python string.
#include "hapticut/core/errors.hpp"

#include <gtest/gtest.h>

#include <string>

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

}  // namespace hapticut::errors_test
