// SPDX-License-Identifier: Apache-2.0
// A program of one line, which links where its compiler and the library's mean the same by a type.
#include <hapticut/workpiece/workpiece.hpp>

int main() { return 0; }
