// SPDX-License-Identifier: Apache-2.0
#include "import/volume/unpack.hpp"

#include <archive.h>
#include <zlib.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kAtOnce = std::size_t(1) << 20U;  // [bytes]
constexpr int kGzipOrZlib = 15 + 32;                    // zlib's code

void append_unpacked(std::string& unpacked, const char* bytes, std::size_t count, std::uint64_t max_bytes) {
  if (unpacked.size() + count > max_bytes) throw Error("its compressed data contain far more than its header says.");
  unpacked.append(bytes, count);
}

/// Unpacks data in memory with zlib.
class Inflater {
 public:
  explicit Inflater(std::string_view packed) : left_(packed) {
    if (inflateInit2(&stream_, kGzipOrZlib) != Z_OK) throw Error("its data cannot be unpacked.");
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// @return number of unpacked bytes
  std::size_t unpack(char* to, std::size_t capacity, int flush) {
    // zlib counts in 32 bits, so large data are passed in pieces.
    const std::size_t give = std::min(std::size_t(1) << 30U, left_.size());
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(left_.data()));  // zlib does not modify it
    stream_.avail_in = uInt(give);
    stream_.next_out = reinterpret_cast<Bytef*>(to);
    stream_.avail_out = uInt(capacity);
    const int status = inflate(&stream_, flush);
    if (status != Z_OK && status != Z_STREAM_END)
      throw Error("its compressed data are damaged or truncated. Get a complete copy.");
    ended_ = status == Z_STREAM_END;
    left_.remove_prefix(give - stream_.avail_in);
    return capacity - stream_.avail_out;
  }

  /// Whether the data have ended. Another gzip member may follow; any other bytes are not part of the data.
  bool is_done() { return ended_ && (!left_.starts_with("\x1f\x8b") || inflateReset(&stream_) != Z_OK); }

 private:
  z_stream stream_{};
  std::string_view left_;
  bool ended_ = false;
};

}  // namespace

std::string unpack_gzip(std::string_view packed, std::uint64_t max_bytes) {
  Inflater inflater(packed);
  std::vector<char> buffer(kAtOnce);
  std::string unpacked;
  do {
    const std::size_t count = inflater.unpack(buffer.data(), buffer.size(), Z_NO_FLUSH);
    append_unpacked(unpacked, buffer.data(), count, max_bytes);
  } while (!inflater.is_done());
  return unpacked;
}

std::string start_of_gzip(std::string_view packed, std::size_t count) {
  std::string start(count, '\0');
  start.resize(Inflater(packed.substr(0, kAtOnce)).unpack(start.data(), count, Z_SYNC_FLUSH));
  return start;
}

std::string unpack_bzip2(std::string_view packed, std::uint64_t max_bytes) {
  const std::unique_ptr<archive, int (*)(archive*)> reader(archive_read_new(), archive_read_free);
  archive_read_support_format_raw(reader.get());
  archive_read_support_filter_bzip2(reader.get());
  archive_entry* entry = nullptr;
  if (archive_read_open_memory(reader.get(), packed.data(), packed.size()) != ARCHIVE_OK ||
      archive_read_next_header(reader.get(), &entry) != ARCHIVE_OK ||
      archive_filter_code(reader.get(), 0) != ARCHIVE_FILTER_BZIP2)
    throw Error("its data are not compressed by bzip2, as its header says.");
  std::vector<char> buffer(kAtOnce);
  std::string unpacked;
  for (;;) {
    const auto count = archive_read_data(reader.get(), buffer.data(), buffer.size());
    if (count < 0) throw Error("its compressed data are damaged or truncated. Get a complete copy.");
    if (count == 0) return unpacked;
    append_unpacked(unpacked, buffer.data(), std::size_t(count), max_bytes);
  }
}

}  // namespace hapticut
