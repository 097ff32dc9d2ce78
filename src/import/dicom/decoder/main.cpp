// SPDX-License-Identifier: Apache-2.0
// Program that unpacks compressed pictures for the library: a request is a DICOM file of one frame, its reply the
// values.
#include <gdcmImageReader.h>
#include <gdcmTrace.h>

#include <sstream>
#include <stdexcept>
#include <string>

#include "io/child_side.hpp"

// NOLINTNEXTLINE(bugprone-exception-escape): it ends this program, and the library reports a damaged file
int main() {
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  gdcm::Trace::DebugOff();
  const auto values_of = [](const std::string& file) {
    std::istringstream stream(file);
    gdcm::ImageReader reader;
    reader.SetStream(stream);
    if (!reader.Read()) throw std::runtime_error("no picture");
    const gdcm::Image& image = reader.GetImage();
    std::string values(image.GetBufferLength(), '\0');
    if (!image.GetBuffer(values.data())) throw std::runtime_error("no values");
    return values;
  };
  hapticut::child::serve(values_of, [](const std::exception&) { return 0; });
}
