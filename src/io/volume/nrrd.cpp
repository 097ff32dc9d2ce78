// SPDX-License-Identifier: Apache-2.0
#include <archive.h>
#include <itkNrrdImageIO.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>

#include "io/file_errors.hpp"
#include "io/volume/formats.hpp"
#include "io/volume/itk_image.hpp"
#include "io/volume/nrrd_header.hpp"

namespace hapticut {
namespace {

namespace fs = std::filesystem;

/// A folder that goes away with this object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "hapticut-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw Error("cannot make a folder in '" + fs::temp_directory_path().string() + "': " + std::strerror(errno) +
                  ".");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// The bytes of the data file from where they begin, unpacked.
class PayloadStream {
 public:
  PayloadStream(const fs::path& path, const NrrdHeader& header)
      : path_(path),
        file_(std::fopen(header.data_file.c_str(), "rb"), std::fclose),
        archive_(archive_read_new(), archive_read_free) {
    if (!file_) cannot_read(path, "its data file '" + header.data_file.string() + "' cannot be opened.");
    std::fseek(file_.get(), long(header.data_offset), SEEK_SET);
    for (std::int64_t line = 0; line < header.line_skip; ++line)
      for (int c = 0; c != '\n';)
        if ((c = std::fgetc(file_.get())) == EOF) cannot_read(path, "it has fewer lines than it says to skip.");
    // Reading by descriptor starts where the file stands, not where the buffered stream has read to.
    ::lseek(::fileno(file_.get()), std::ftell(file_.get()), SEEK_SET);
    archive_read_support_format_raw(archive_.get());
    if (header.encoding == "gzip") archive_read_support_filter_gzip(archive_.get());
    if (header.encoding == "bzip2") archive_read_support_filter_bzip2(archive_.get());
    archive_entry* entry = nullptr;
    if (archive_read_open_fd(archive_.get(), ::fileno(file_.get()), 1U << 16U) != ARCHIVE_OK ||
        archive_read_next_header(archive_.get(), &entry) != ARCHIVE_OK)
      fail();
    const int filter = header.encoding == "gzip"    ? ARCHIVE_FILTER_GZIP
                       : header.encoding == "bzip2" ? ARCHIVE_FILTER_BZIP2
                                                    : ARCHIVE_FILTER_NONE;
    if (archive_filter_code(archive_.get(), 0) != filter)
      cannot_read(path, "its data are not in the encoding '" + header.encoding + "' that it claims.");
  }

  /// The next bytes; none at the end.
  std::size_t read(std::vector<char>& buffer) {
    const auto count = archive_read_data(archive_.get(), buffer.data(), buffer.size());
    if (count < 0) fail();
    return std::size_t(count);
  }

 private:
  [[noreturn]] void fail() {
    const char* reason = archive_error_string(archive_.get());
    cannot_read(path_, "its data cannot be unpacked (" + std::string(reason != nullptr ? reason : "no data") + ").");
  }

  const fs::path& path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::unique_ptr<archive, int (*)(archive*)> archive_;
};

/// Whether data begin with the header of a NIfTI file, and where its values start.
std::uint64_t nifti_values_offset(const std::vector<char>& first) {
  if (first.size() < 352 || std::memcmp(first.data() + 344, "n+1", 4) != 0) return 0;
  float offset = 0;
  std::memcpy(&offset, first.data() + 108, sizeof offset);
  return offset >= 348 && offset < 1e9F ? std::uint64_t(offset) : 0;
}

/// Where the values begin among `total` unpacked bytes.
std::uint64_t values_offset(const NrrdHeader& header, const std::vector<char>& first, std::uint64_t total,
                            std::uint64_t needed) {
  if (header.byte_skip > 0) return std::uint64_t(header.byte_skip);
  if (header.byte_skip < 0) {
    // -1 means: the last bytes of the data; -1 - n: n bytes before that, but not before the first byte.
    const auto before_end = needed + std::uint64_t(-(header.byte_skip + 1));
    return before_end < total ? total - before_end : 0;
  }
  // A data file that is a whole NIfTI file: its own header is not part of the values.
  const std::uint64_t nifti = nifti_values_offset(first);
  return nifti + needed == total ? nifti : 0;
}

/// Unpacks the data into a plain file beside a plain header, for what ITK does not read: bzip2, counting back from the
/// end, a NIfTI file as data file.
void write_plain_copy(const fs::path& path, const NrrdHeader& header, std::uint64_t needed, const fs::path& folder) {
  PayloadStream payload(path, header);
  std::ofstream data(folder / "data.raw", std::ios::binary);
  std::vector<char> buffer(1U << 20U), first;
  std::uint64_t total = 0;
  while (const std::size_t count = payload.read(buffer)) {
    if (first.size() < 352) first.insert(first.end(), buffer.begin(), buffer.begin() + std::ptrdiff_t(count));
    data.write(buffer.data(), std::streamsize(count));
    total += count;
    if (total > 2 * needed + (1U << 20U)) cannot_read(path, "it holds far more data than its header says.");
  }
  const std::uint64_t offset = values_offset(header, first, total, needed);
  require_bytes(path, double(offset) + double(needed), double(total), kNotCompressed);
  std::ofstream plain(folder / "plain.nhdr");
  plain << header.fields << "encoding: raw\nbyte skip: " << offset << "\ndata file: data.raw\n";
  plain.close();
  data.close();
  if (!plain || !data)
    cannot_read(path, "its data could not be unpacked into '" + folder.string() + "'; is the disk full?");
}

bool needs_plain_copy(const NrrdHeader& header) {
  if (header.encoding == "bzip2" || header.byte_skip < -1) return true;
  if (header.encoding == "raw") return false;
  return header.data_offset == 0 && header.encoding == "gzip" && header.byte_skip == 0;  // perhaps a NIfTI file
}

}  // namespace

RawImage read_nrrd(const fs::path& path) {
  (void)readable_size(path);
  const NrrdHeader header = parse_nrrd_header(path);
  if (header.sizes.size() != 3)
    cannot_read(path, "it has " + std::to_string(header.sizes.size()) +
                          " dimensions; a volume has three. Take one volume out of it, or put its slices together.");
  require_sane_dims(path, {header.sizes[0], header.sizes[1], header.sizes[2]});
  if (header.bytes_per_value == 0) cannot_read(path, "its values are of a type that is not read.");
  const double samples = header.sizes[0] * header.sizes[1] * header.sizes[2];
  const double needed = samples * double(header.bytes_per_value);
  if (!header.data_file.empty()) {
    std::error_code code;
    const auto size = fs::file_size(header.data_file, code);
    if (code) cannot_read(path, "its data file '" + header.data_file.string() + "' cannot be opened.");
    const auto available = double(size) - double(header.data_offset);
    if (header.encoding == "raw")
      require_bytes(path, needed + double(std::max<std::int64_t>(header.byte_skip, 0)), available, kNotCompressed);
    if (header.encoding == "gzip") require_bytes(path, needed, available, kDeflate);
    if (header.encoding == "ascii" || header.encoding == "hex") require_bytes(path, samples, available, kNotCompressed);
  }

  const auto io = itk::NrrdImageIO::New();
  RawImage image;
  if (!header.data_file.empty() && needs_plain_copy(header)) {
    const TemporaryFolder folder;
    write_plain_copy(path, header, std::uint64_t(needed), folder.path());
    image = read_itk_image(*io, folder.path() / "plain.nhdr");
  } else {
    image = read_itk_image(*io, path);
  }
  image.geometry.spacing_mm *= header.unit_mm;
  image.geometry.origin_mm *= header.unit_mm;
  return image;
}

}  // namespace hapticut
