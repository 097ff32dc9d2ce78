// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/random_pose.hpp"

namespace hapticut::test {

using fixtures::RandomPoses;

}  // namespace hapticut::test
