// SPDX-License-Identifier: Apache-2.0
#include "io/child_process.hpp"

namespace hapticut {

const ChildProgram kDecoder = {"hapticut-decoder",
                               "HAPTICUT_DECODER",
                               HAPTICUT_PROGRAMS_INSTALLED "hapticut-decoder",
                               HAPTICUT_DECODER_BUILT,
                               "its values are compressed and must be unpacked",
                               ", which needs ITK; this build of hapticut lacks it. Install "
                               "libinsighttoolkit5-dev and build it with HAPTICUT_WITH_ITK=ON",
                               ", or save the file uncompressed"};

const ChildProgram kRecordingReader = {"hapticut-recording-reader",
                                       "HAPTICUT_RECORDING_READER",
                                       HAPTICUT_PROGRAMS_INSTALLED "hapticut-recording-reader",
                                       HAPTICUT_RECORDING_READER_BUILT,
                                       "recordings are read by a separate program",
                                       "",
                                       ""};

}  // namespace hapticut
