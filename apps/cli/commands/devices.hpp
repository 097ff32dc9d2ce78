// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticut::cli {

/// Registers every device driver of this build for `open_device`.
void use_all_devices();

}  // namespace hapticut::cli
