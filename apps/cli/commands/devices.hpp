// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticut::apps {

/// Registers every device driver of this build for `open_device`.
void use_all_devices();

}  // namespace hapticut::apps
