// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>
#include <vector>

#include "io/dicom/dicom_picture.hpp"

namespace hapticut {

/// The program beside the library that unpacks compressed pictures: what their codecs do to damaged data, it does to
/// itself. It is started at the first frame and ends with this object; docs/decisions/0011-readers.md says why it is no
/// fork.
class CodecProcess {
 public:
  CodecProcess() = default;
  ~CodecProcess();
  CodecProcess(const CodecProcess&) = delete;
  CodecProcess& operator=(const CodecProcess&) = delete;

  /// Unpacks one frame.
  /// @param fragments  its compressed parts
  /// @return its values as stored, in little-endian order
  /// @throws Error a sentence that begins with "its", when the program fails, dies or takes too long, and when it is
  ///         not there
  std::string unpack(const DicomFile& file, const DicomPicture& picture,
                     const std::vector<std::string_view>& fragments);

 private:
  void start();
  void stop();
  bool send(std::string_view bytes) const;
  bool receive(char* bytes, std::size_t count) const;

  pid_t process_ = -1;
  int socket_ = -1;
};

}  // namespace hapticut
