// SPDX-License-Identifier: Apache-2.0
// Export of recordings to CSV and NumPy.
#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string_view>

#include "core/interruption.hpp"
#include "io/atomic_file.hpp"
#include "io/file_errors.hpp"
#include "io/recording/recording_access.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

constexpr std::uint64_t kRowsAtOnce = 4096;  // rows

/// Names of the numbers of a column: `force_0`, `pose_rotation_21`.
std::vector<std::string> names_of(const Column& column) {
  if (column.numbers == 1) return {column.name};
  std::vector<std::string> names;
  for (std::size_t n = 0; n < column.numbers; ++n)
    names.push_back(column.name + "_" +
                    (column.numbers == 9 ? std::to_string(n / 3) + std::to_string(n % 3) : std::to_string(n)));
  return names;
}

void append_cell(std::string& line, const Column& column, const std::byte* row, std::size_t element) {
  with_value_type(column.kind, [&](auto number) {
    std::memcpy(&number, row + element * sizeof number, sizeof number);
    append_number(line, number);
  });
}

// --- NumPy ----------------------------------------------------------------------------------------------------------

/// NumPy's type name, e.g. `<f8`, `|u1`: byte order, kind and length.
std::string dtype_of(ValueType kind) {
  return with_value_type(kind, []<class Number>(Number) {
    const char* letter = std::is_floating_point_v<Number> ? "f" : std::is_signed_v<Number> ? "i" : "u";
    return (sizeof(Number) == 1 ? "|" : "<") + (letter + std::to_string(sizeof(Number)));
  });
}

/// The header of a .npy file, format 1.0: magic, length, and a Python dictionary, padded to a multiple of 64 bytes.
std::string npy_head(const Column& column, std::uint64_t rows) {
  std::string shape = std::to_string(rows) + ",";
  for (const hsize_t length : column.shape) shape += std::to_string(length) + ",";
  std::string dictionary =
      "{'descr': '" + dtype_of(column.kind) + "', 'fortran_order': False, 'shape': (" + shape + "), }";
  constexpr std::size_t kBefore = 10;
  dictionary.append((64 - (kBefore + dictionary.size() + 1) % 64) % 64, ' ');
  dictionary += '\n';
  std::string head = "\x93NUMPY";
  head += '\x01';
  head += '\0';
  head += char(dictionary.size() & 0xff);
  head += char(dictionary.size() >> 8);
  return head + dictionary;
}

/// Writes an uncompressed .zip file, NumPy's .npz.
class ZipWriter {
 public:
  explicit ZipWriter(const std::filesystem::path& path) : archive_(archive_write_new(), archive_write_free) {
    check(archive_write_set_format_zip(archive_.get()));
    check(archive_write_zip_set_compression_store(archive_.get()));
    check(archive_write_open_filename(archive_.get(), path.c_str()));
  }
  void begin(const std::string& name, std::uint64_t bytes) {
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(), archive_entry_free);
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_size(entry.get(), la_int64_t(bytes));
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    check(archive_write_header(archive_.get(), entry.get()));
  }
  void write(const void* bytes, std::size_t count) {
    if (archive_write_data(archive_.get(), bytes, count) != la_ssize_t(count)) check(ARCHIVE_FATAL);
  }
  void close() { check(archive_write_close(archive_.get())); }

 private:
  void check(int code) {
    if (code == ARCHIVE_OK) return;
    const char* reason = archive_error_string(archive_.get());
    throw Error(reason != nullptr ? reason : "writing failed");
  }
  std::unique_ptr<archive, int (*)(archive*)> archive_;
};

}  // namespace

void require_other_file(const Recording& recording, const std::filesystem::path& path) {
  std::error_code unknown;
  if (std::filesystem::equivalent(path, recording.path(), unknown))
    throw Error("cannot write '" + path.string() + "': it is the recording itself. Choose another name.");
}

void write_csv(const Recording& recording, const std::filesystem::path& path) {
  require_other_file(recording, path);
  const std::vector<const Column*>& columns = RecordingAccess::state(recording).columns;
  write_atomically(path, [&](std::ostream& stream) {
    std::string line;
    for (const Column* column : columns)
      for (const std::string& name : names_of(*column)) line += (line.empty() ? "" : ",") + name;
    stream << line << '\n';
    std::vector<std::vector<std::byte>> rows(columns.size());
    for (std::uint64_t first = 0; first < recording.size(); first += kRowsAtOnce) {
      const std::uint64_t count = std::min(kRowsAtOnce, recording.size() - first);
      for (std::size_t n = 0; n < columns.size(); ++n) read_rows(recording, *columns[n], first, count, rows[n]);
      for (std::uint64_t row = 0; row < count; ++row) {
        look_for_interruption();
        line.clear();
        for (std::size_t n = 0; n < columns.size(); ++n) {
          const Column& column = *columns[n];
          for (std::size_t element = 0; element < column.numbers; ++element) {
            if (!line.empty()) line += ',';
            append_cell(line, column, rows[n].data() + row * column.bytes, element);
          }
        }
        stream << line << '\n';
      }
    }
  });
}

void write_npz(const Recording& recording, const std::filesystem::path& path) {
  require_other_file(recording, path);
  AtomicFile target(path);
  try {
    ZipWriter zip(target.temporary_path());
    std::vector<std::byte> rows;
    for (const Column* each : RecordingAccess::state(recording).columns) {
      const Column& column = *each;
      const std::string head = npy_head(column, recording.size());
      zip.begin(column.name + ".npy", head.size() + recording.size() * column.bytes);
      zip.write(head.data(), head.size());
      for (std::uint64_t first = 0; first < recording.size(); first += kRowsAtOnce) {
        read_rows(recording, column, first, std::min(kRowsAtOnce, recording.size() - first), rows);
        zip.write(rows.data(), rows.size());
      }
    }
    zip.close();
  } catch (const FileError&) {  // the fault is in the recording
    throw;
  } catch (const Error& error) {
    cannot_write(path, error.sentence());
  }
  target.commit();
}

}  // namespace hapticut
