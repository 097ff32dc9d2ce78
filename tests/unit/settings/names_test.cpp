// SPDX-License-Identifier: Apache-2.0
#include "settings/names.hpp"

#include <gtest/gtest.h>

#include <string>

#include "hapticut/tool/head.hpp"

namespace hapticut::names_test {
namespace {

TEST(Names, OfTheNumbersOfEachShapeOfHeadAreThoseOfItsSettings) {
  for_each_shape([]<class Shape>(Of<Shape>) {
    if constexpr (Described<Shape>)
      for_each_number<Shape>([](const auto& field) {
        const std::string name = std::string(Shape::kName) + "::" + field.name;
        const auto key = settings::key_of(Name(name));
        ASSERT_TRUE(key) << name;
        EXPECT_TRUE(settings::flag_of(*key)) << name << " has the key " << *key << ", which no setting has";
      });
  });
  EXPECT_EQ(settings::key_of(Name("ConeHead::half_angle")), "tool.half_angle_deg");
}

}  // namespace
}  // namespace hapticut::names_test
