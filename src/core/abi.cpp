// SPDX-License-Identifier: Apache-2.0
#include "hapticut/core/abi.hpp"

namespace hapticut::abi {

// Instantiated by kMustAgree, which this file has as well.
template <hapticut_version, glibcxx_debug, glibcxx_use_cxx11_abi, libcxx_abi, eigen_version, eigen_align,
          eigen_row_major, eigen_index_bytes, struct_bytes>
void library_was_compiled_with() {}

}  // namespace hapticut::abi
