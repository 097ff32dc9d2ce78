// SPDX-License-Identifier: Apache-2.0
#include "import/volume/itk_volume.hpp"

#include <itkObject.h>

namespace hapticut {

QuietItk::QuietItk() : warned_(itk::Object::GetGlobalWarningDisplay()) { itk::Object::SetGlobalWarningDisplay(false); }
QuietItk::~QuietItk() { itk::Object::SetGlobalWarningDisplay(warned_); }

std::string reason_of(const itk::ExceptionObject& exception) {
  // Descriptions have several lines, from general to specific: the last one is the most useful.
  std::string text = exception.GetDescription();
  text.erase(text.find_last_not_of(" \n\r\t.") + 1);
  const auto line = text.find_last_of('\n');
  if (line != std::string::npos) text.erase(0, line + 1);
  // "ITK ERROR: ResampleImageFilter(0x55d5738a9f00): ..." names an object that is meaningless to users.
  const auto object = text.find("): ");
  if (text.find("ERROR: ") != std::string::npos && object != std::string::npos) text.erase(0, object + 3);
  return text.empty() ? "the volume cannot be used." : text + ".";
}

}  // namespace hapticut
