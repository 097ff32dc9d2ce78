// SPDX-License-Identifier: Apache-2.0
#include "hapticut/core/errors.hpp"

#include <cmath>
#include <cstdio>

namespace hapticut {

std::string format_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

void require_positive(double value, const char* name) {
  if (!(std::isfinite(value) && value > 0))
    throw Error(std::string(name) + " = " + format_number(value) + "; must be a finite number > 0.");
}

void require_not_negative(double value, const char* name) {
  if (!(std::isfinite(value) && value >= 0))
    throw Error(std::string(name) + " = " + format_number(value) + "; must be a finite number >= 0.");
}

void require_between(double value, double low, double high, const char* name) {
  if (!(value >= low && value <= high))
    throw Error(std::string(name) + " = " + format_number(value) + "; must be between " + format_number(low) + " and " +
                format_number(high) + ".");
}

}  // namespace hapticut
