// SPDX-License-Identifier: Apache-2.0
#include "io/recording/recording_process.hpp"

namespace hapticut {

const ChildProgram kRecordingReader = {"hapticut-recording-reader",
                                       "HAPTICUT_RECORDING_READER",
                                       HAPTICUT_PROGRAMS_INSTALLED "hapticut-recording-reader",
                                       HAPTICUT_PROGRAM_BUILT,
                                       "recordings are read by a separate program",
                                       "",
                                       ""};

}  // namespace hapticut
