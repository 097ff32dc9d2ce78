// SPDX-License-Identifier: Apache-2.0
#include "import/dicom/codec_process.hpp"

namespace hapticut {

const ChildProgram kDecoder = {"hapticut-decoder",
                               "HAPTICUT_DECODER",
                               HAPTICUT_PROGRAMS_INSTALLED "hapticut-decoder",
                               HAPTICUT_PROGRAM_BUILT,
                               "its values are compressed and must be unpacked",
                               ", which needs ITK; this build of hapticut lacks it. Install "
                               "libinsighttoolkit5-dev and build it with HAPTICUT_WITH_ITK=ON",
                               ", or save the file uncompressed"};

}  // namespace hapticut
