// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "import/dicom/dicom_picture.hpp"
#include "io/child_process.hpp"

namespace hapticut {

extern const ChildProgram kDecoder;

/// Unpacks compressed pictures in a child process, because damaged data can crash the codecs. The child starts at the
/// first frame and ends with this object; docs/decisions/0011-readers.md explains why it is not a fork.
class CodecProcess {
 public:
  /// Unpacks one frame.
  /// @param packed  compressed values of the frame
  /// @return values of the frame as stored, in little-endian order
  /// @throws Error without the name of the file, when the program is missing, fails, dies or takes too long
  std::string operator()(const DicomFile& file, const DicomPicture& picture, std::string_view packed);

 private:
  ChildProcess process_{kDecoder};
  std::uint64_t seconds_ = 0;  // [s] processor time that all frames may take
};

}  // namespace hapticut
