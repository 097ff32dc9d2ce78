// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/tool.hpp"

namespace hapticut {

Tool::Tool(ToolHead head, Handle handle, Spindle spindle)
    : head_(std::move(head)), handle_(handle), spindle_(spindle), X_HT_(head_in_handle(handle)) {
  validate(spindle_);
}

}  // namespace hapticut
