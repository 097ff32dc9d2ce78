// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace hapticut::python {

/// The docstring of a declaration in the C++ headers, e.g. "Material::damping"; overloads are told apart by the
/// types of their parameters, "validate(Gravity)".
/// @throws std::logic_error when no header documents it; then the import of the module and the tests fail
[[nodiscard]] const char* doc(std::string_view key);

/// The docstring of a declaration; empty when no header documents it.
[[nodiscard]] const char* doc_or_none(std::string_view key);

}  // namespace hapticut::python
