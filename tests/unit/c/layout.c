/* SPDX-License-Identifier: Apache-2.0 */
/* The layout of the structs in C. */
#include "layout.h"

const struct layout layout_in_c[] = {HAPTICUT_LAYOUT(HAPTICUT_LAYOUT_OF, HAPTICUT_LAYOUT_AT)};
const size_t layouts_in_c = sizeof layout_in_c / sizeof layout_in_c[0];
