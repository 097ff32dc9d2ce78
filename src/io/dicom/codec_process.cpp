// SPDX-License-Identifier: Apache-2.0
#include "io/dicom/codec_process.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): <csignal> need not have kill
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "hapticut/core/errors.hpp"

extern char** environ;

namespace hapticut {
namespace {

namespace fs = std::filesystem;

constexpr int kLongestWait = 20'000;  // [ms] for the next bytes of an answer

/// Where the program is: what HAPTICUT_DECODER names, beside the file that holds this code, where a package puts it
/// from there, where it was installed, or where it was built.
fs::path decoder_program() {
  constexpr const char* kName = "hapticut-decoder";
  if (const char* given = std::getenv("HAPTICUT_DECODER")) return given;
  std::error_code code;
  Dl_info here{};
  std::vector<fs::path> candidates;
  // A program that was found by PATH is named without a folder.
  const bool known = ::dladdr(reinterpret_cast<void*>(&decoder_program), &here) != 0 && here.dli_fname != nullptr &&
                     std::strchr(here.dli_fname, '/') != nullptr;
  const fs::path folder = fs::weakly_canonical(known ? here.dli_fname : "/proc/self/exe", code).parent_path();
  for (const char* place : {"", "../libexec/hapticut", "../../libexec/hapticut"})
    candidates.push_back(folder / place / kName);
  candidates.emplace_back(HAPTICUT_DECODER_INSTALLED);
  candidates.emplace_back(HAPTICUT_DECODER_BUILT);
  for (const fs::path& candidate : candidates)
    if (fs::is_regular_file(candidate, code)) return candidate;
  throw Error(std::string("its values are compressed, and the program '") + kName +
              "', which comes with the library and unpacks them, is not where it belongs; name it by the environment "
              "variable HAPTICUT_DECODER, or save the file uncompressed.");
}

template <class Number>
void append_little(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void append_element(std::string& bytes, std::uint32_t tag, const char* kind, std::string value) {
  if (value.size() % 2 != 0) value += kind == std::string_view("UI") ? '\0' : ' ';
  append_little(bytes, std::uint16_t(tag >> 16U));
  append_little(bytes, std::uint16_t(tag));
  bytes += kind;
  append_little(bytes, std::uint16_t(value.size()));
  bytes += value;
}

void append_number(std::string& bytes, std::uint32_t tag, int number) {
  append_element(bytes, tag, "US", {char(number), char(number >> 8)});
}

/// A file of one frame with nothing in it but what a codec needs, so that nothing else of the file can confuse it.
std::string one_frame_file(const DicomFile& file, const DicomPicture& picture,
                           const std::vector<std::string_view>& fragments) {
  constexpr const char* kClass = "1.2.840.10008.5.1.4.1.1.7";
  std::string meta;
  append_element(meta, dicom_tag(2, 2), "UI", kClass);
  append_element(meta, dicom_tag(2, 3), "UI", "1.2");
  append_element(meta, dicom_tag(2, 0x10), "UI", file.syntax);
  std::string bytes = std::string(128, '\0') + "DICM";
  append_element(bytes, dicom_tag(2, 0), "UL", {char(meta.size()), 0, 0, 0});
  bytes += meta;
  append_element(bytes, dicom_tag(8, 0x16), "UI", kClass);
  append_element(bytes, dicom_tag(8, 0x18), "UI", "1.2");
  append_number(bytes, dicom_tag(0x28, 2), 1);
  append_element(bytes, dicom_tag(0x28, 4), "CS", "MONOCHROME2");
  append_number(bytes, dicom_tag(0x28, 0x10), picture.geometry.dims[1]);
  append_number(bytes, dicom_tag(0x28, 0x11), picture.geometry.dims[0]);
  append_number(bytes, dicom_tag(0x28, 0x100), picture.allocated);
  append_number(bytes, dicom_tag(0x28, 0x101), picture.stored);
  append_number(bytes, dicom_tag(0x28, 0x102), picture.high);
  append_number(bytes, dicom_tag(0x28, 0x103), picture.has_sign ? 1 : 0);
  bytes += std::string("\xe0\x7f\x10\0OB\0\0\xff\xff\xff\xff", 12);
  const auto append_item = [&](std::uint16_t element, std::string_view content) {
    append_little(bytes, std::uint16_t(0xfffe));
    append_little(bytes, element);
    append_little(bytes, std::uint32_t(content.size()));
    bytes += content;
  };
  append_item(0xe000, "");
  for (const std::string_view fragment : fragments) append_item(0xe000, fragment);
  append_item(0xe0dd, "");
  return bytes;
}

std::string name_of_compression(const std::string& syntax) {
  const std::string jpeg = "1.2.840.10008.1.2.4.";
  if (syntax.starts_with(jpeg + "8")) return "JPEG-LS";
  if (syntax.starts_with(jpeg + "9")) return "JPEG 2000";
  if (syntax.starts_with(jpeg) && syntax.size() == jpeg.size() + 2) return "JPEG";
  throw Error("its picture is compressed in a way that is not read (" + syntax + "); save it uncompressed.");
}

}  // namespace

CodecProcess::~CodecProcess() { stop(); }

void CodecProcess::start() {
  if (process_ > 0) return;
  const std::string program = decoder_program().string();
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw Error(std::string("its compressed values cannot be unpacked: ") + std::strerror(errno) + ".");
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  sigset_t none;
  ::sigemptyset(&none);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  char* arguments[] = {const_cast<char*>(program.c_str()), nullptr};
  const int failure = ::posix_spawn(&process_, program.c_str(), &actions, &attributes, arguments, environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  socket_ = ends[0];
  if (failure == 0) return;
  process_ = -1;
  stop();
  throw Error("its values are compressed, and the program '" + program +
              "' that unpacks them cannot be started: " + std::strerror(failure) + ".");
}

void CodecProcess::stop() {
  if (socket_ >= 0) ::close(socket_);
  socket_ = -1;
  if (process_ <= 0) return;
  ::kill(process_, SIGKILL);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
  process_ = -1;
}

bool CodecProcess::send(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(std::size_t(count));
  }
  return true;
}

bool CodecProcess::receive(char* bytes, std::size_t count) const {
  while (count > 0) {
    pollfd waiting{socket_, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, kLongestWait);
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return false;
    const ssize_t got = ::recv(socket_, bytes, count, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes += got;
    count -= std::size_t(got);
  }
  return true;
}

std::string CodecProcess::unpack(const DicomFile& file, const DicomPicture& picture,
                                 const std::vector<std::string_view>& fragments) {
  const std::string compression = name_of_compression(file.syntax);
  if (compression == "JPEG 2000" && !fragments.empty()) require_jpeg_2000_of(fragments.front(), picture);
  start();
  const std::string request = one_frame_file(file, picture, fragments);
  std::string message;
  append_little(message, std::uint64_t(request.size()));
  append_little(message, std::uint64_t(picture.frame_bytes()));
  std::uint64_t length = 0;
  std::string values(picture.frame_bytes(), '\0');
  const bool answered = send(message) && send(request) && receive(reinterpret_cast<char*>(&length), sizeof length) &&
                        length == values.size() && receive(values.data(), values.size());
  if (answered) return values;
  stop();
  throw Error("its values, compressed by " + compression +
              ", cannot be unpacked; they are damaged or of a kind that is not read. Get a complete copy, or save the "
              "file uncompressed.");
}

}  // namespace hapticut
