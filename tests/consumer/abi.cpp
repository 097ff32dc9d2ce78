// SPDX-License-Identifier: Apache-2.0
// A one-line program that links only if its compiler and the library's have the same type layouts.
#include <hapticut/workpiece/workpiece.hpp>

int main() { return 0; }
