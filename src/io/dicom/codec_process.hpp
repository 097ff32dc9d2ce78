// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "io/child_process.hpp"
#include "io/dicom/dicom_picture.hpp"

namespace hapticut {

/// The program beside the library that unpacks compressed pictures: what their codecs do to damaged data, it does to
/// itself. It is started at the first frame and ends with this object; docs/decisions/0011-readers.md says why it is no
/// fork.
class CodecProcess {
 public:
  /// Unpacks one frame.
  /// @param packed  its compressed values
  /// @return its values as stored, in little-endian order
  /// @throws Error a sentence that begins with "its", when the program fails, dies or takes too long, and when it is
  ///         not there
  std::string operator()(const DicomFile& file, const DicomPicture& picture, std::string_view packed);

 private:
  ChildProcess process_{kDecoder};
};

}  // namespace hapticut
