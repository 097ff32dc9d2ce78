// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace hapticut {

/// Whether a file begins like a DICOM file.
[[nodiscard]] bool looks_like_dicom(const std::filesystem::path& path);

/// Goes through a DICOM file from element to element, to its end, before GDCM sees it: where an element is cut short or
/// of an unknown kind, GDCM ends the whole program (Debian builds it with its assertions on) or allocates what the file
/// claims.
/// @throws Error when the file is damaged, cut short, or of a kind that cannot be checked
void require_sound_dicom(const std::filesystem::path& path);

}  // namespace hapticut
