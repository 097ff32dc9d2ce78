// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/lack_of_memory.hpp"
#include "hapticut/core/errors.hpp"

namespace hapticut {

/// An Error that names its file.
class FileError : public Error {
 public:
  using Error::Error;
};

/// @param reason  calls the file "it"
[[noreturn]] inline void cannot_read(const std::filesystem::path& path, const Sentence& reason) {
  throw FileError("cannot read '" + path.string() + "': " + reason);
}

/// Runs a part of the reading that does not know the name of the file. Its errors call the file "it".
/// @throws FileError
template <class Work>
auto naming(const std::filesystem::path& path, const Work& work) {
  try {
    return work();
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    cannot_read(path, error.sentence());
  } catch (const std::exception& error) {
    if (!is_lack_of_memory(error) && dynamic_cast<const std::length_error*>(&error) == nullptr) throw;
    cannot_read(path, "there is not enough memory for it. Crop or downsample it first.");
  }
}

/// Whether there is certainly nothing at a path. Does not throw, other than std::filesystem::exists.
[[nodiscard]] bool is_missing(const std::filesystem::path& path);

/// Why a path leads nowhere, calling the file "it": no permission, a link to itself, too long a name. Empty if it leads
/// to something, or if nothing is there.
[[nodiscard]] std::string unreachable(const std::filesystem::path& path);

/// The first line of the small text that Git stores in place of a large file.
inline constexpr std::string_view kGitLfsPointer = "version https://git-lfs.github.com/spec/v1";

/// What a download or a copy of a repository may have left in place of a file, and what to do: "it is a Git LFS pointer
/// ...", "it is a web page ...". Empty for anything else.
/// @param head  the first bytes of the file, 200 or all
[[nodiscard]] std::string not_the_file(std::string_view head);

/// "it is a gzip archive" or another one; empty for anything else.
/// @param head  the first bytes of the file, 6 or more
[[nodiscard]] std::string archive_instead(std::string_view head);

/// Size of a regular file that can be opened for reading.
/// @throws Error for anything else (a pipe or a device may have no end), an empty file, a Git LFS pointer and a web
/// page
[[nodiscard]] std::uint64_t readable_size(const std::filesystem::path& path);

/// The first bytes of a file, up to `count`.
[[nodiscard]] std::string first_bytes(const std::filesystem::path& path, std::size_t count);

/// All bytes of a regular file.
/// @throws Error when it is not a regular file, or cannot be read to its end
[[nodiscard]] std::string bytes_of_file(const std::filesystem::path& path);

}  // namespace hapticut
