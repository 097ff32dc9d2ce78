// SPDX-License-Identifier: Apache-2.0
#include "io/volume/unpack.hpp"

#include <archive.h>
#include <zlib.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kAtOnce = std::size_t(1) << 20U;  // [bytes]
constexpr int kGzipOrZlib = 15 + 32;                    // what zlib calls it

void append_unpacked(std::string& unpacked, const char* bytes, std::size_t count, std::uint64_t most) {
  if (unpacked.size() + count > most) throw Error("its compressed data hold far more than its header says.");
  unpacked.append(bytes, count);
}

}  // namespace

std::string unpack_gzip(std::string_view packed, std::uint64_t most) {
  z_stream stream{};
  if (inflateInit2(&stream, kGzipOrZlib) != Z_OK) throw Error("its data cannot be unpacked.");
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, inflateEnd);
  std::vector<char> buffer(kAtOnce);
  std::string unpacked;
  std::size_t at = 0;
  for (bool done = false; !done;) {
    // zlib counts in 32 bits: large data are handed over in pieces.
    const std::size_t give = std::min(std::size_t(1) << 30U, packed.size() - at);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + at));  // it is not written to
    stream.avail_in = uInt(give);
    stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
    stream.avail_out = uInt(buffer.size());
    const int status = inflate(&stream, Z_NO_FLUSH);
    at += give - stream.avail_in;
    append_unpacked(unpacked, buffer.data(), buffer.size() - stream.avail_out, most);
    if (status == Z_STREAM_END) {
      // Another member may follow; anything else behind the last one is no part of the data.
      done = packed.substr(at, 2) != "\x1f\x8b" || inflateReset(&stream) != Z_OK;
    } else if (status != Z_OK) {
      throw Error("its compressed data are damaged or cut short.");
    }
  }
  return unpacked;
}

std::string start_of_gzip(std::string_view packed, std::size_t count) {
  z_stream stream{};
  if (inflateInit2(&stream, kGzipOrZlib) != Z_OK) throw Error("its data cannot be unpacked.");
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, inflateEnd);
  std::string start(count, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = uInt(std::min(kAtOnce, packed.size()));
  stream.next_out = reinterpret_cast<Bytef*>(start.data());
  stream.avail_out = uInt(count);
  const int status = inflate(&stream, Z_SYNC_FLUSH);
  if (status != Z_OK && status != Z_STREAM_END) throw Error("its compressed data are damaged or cut short.");
  start.resize(count - stream.avail_out);
  return start;
}

std::string unpack_bzip2(std::string_view packed, std::uint64_t most) {
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
    if (count < 0) throw Error("its compressed data are damaged or cut short.");
    if (count == 0) return unpacked;
    append_unpacked(unpacked, buffer.data(), std::size_t(count), most);
  }
}

}  // namespace hapticut
