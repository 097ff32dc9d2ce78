// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticut::cli {

/// Makes `open_device` know every kind of device that this build can drive.
void use_all_devices();

}  // namespace hapticut::cli
