/* SPDX-License-Identifier: Apache-2.0 */
/* The layout of the structs in C. */
#include "layout.h"

void layout_in_c(layout_user use) { every_layout(use); }
