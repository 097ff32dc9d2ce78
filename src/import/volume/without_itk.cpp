// SPDX-License-Identifier: Apache-2.0
// Replaces the functions that need ITK in a library built without it.
#include "hapticut/core/errors.hpp"
#include "hapticut/import/volume/volume_filters.hpp"

namespace hapticut {
namespace {

const std::string kNeedsItk =
    " needs ITK, which this build of hapticut lacks; install libinsighttoolkit5-dev and build it with "
    "HAPTICUT_WITH_ITK=ON.";

[[noreturn]] void cannot_do(const std::string& what) { throw Error(what + kNeedsItk); }

}  // namespace

GreyVolume resample(const GreyVolume&, double) { cannot_do("resampling a volume"); }

LabelVolume resample(const LabelVolume&, double, LabelInterpolation) { cannot_do("resampling a volume"); }

LabelVolume close_gaps(LabelVolume, double, std::uint16_t) { cannot_do("closing gaps"); }

}  // namespace hapticut
