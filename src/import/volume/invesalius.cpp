// SPDX-License-Identifier: Apache-2.0
#include <archive.h>
#include <archive_entry.h>
#include <expat.h>

#include <cstring>
#include <map>
#include <memory>

#include "hapticut/core/errors.hpp"
#include "import/volume/formats.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

/// The properties of an InVesalius project, by path of keys: `matrix/shape` -> "108 256 256 ".
class PropertyList {
 public:
  explicit PropertyList(std::string_view xml) {
    const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr), XML_ParserFree);
    XML_SetUserData(parser.get(), this);
    XML_SetElementHandler(parser.get(), &PropertyList::start, &PropertyList::end);
    XML_SetCharacterDataHandler(parser.get(), &PropertyList::text);
    if (XML_Parse(parser.get(), xml.data(), int(xml.size()), 1) == XML_STATUS_ERROR)
      throw Error(std::string("its main.plist is damaged (") + XML_ErrorString(XML_GetErrorCode(parser.get())) + ").");
  }

  [[nodiscard]] const std::string& get(const std::string& key) const {
    const auto found = values_.find(key);
    if (found == values_.end()) throw Error("its main.plist has no '" + key + "'.");
    return found->second;
  }

  [[nodiscard]] Vec3 three_numbers(const std::string& key) const {
    const std::optional<std::vector<double>> numbers = numbers_in(get(key), " \t\r\n");
    if (!numbers || numbers->size() != 3) throw Error("'" + key + "' in its main.plist is not three numbers.");
    return {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  }

 private:
  static void start(void* self, const char* name, const char** /*attributes*/) {
    auto& list = *static_cast<PropertyList*>(self);
    list.text_.clear();
    if (std::strcmp(name, "dict") == 0 && ++list.depth_ > 1) list.prefix_ += list.key_ + "/";
  }
  static void end(void* self, const char* name) {
    auto& list = *static_cast<PropertyList*>(self);
    if (std::strcmp(name, "dict") == 0) {
      if (list.depth_-- > 1) list.prefix_.erase(list.prefix_.find_last_of('/', list.prefix_.size() - 2) + 1);
    } else if (std::strcmp(name, "key") == 0) {
      list.key_ = list.text_;
    } else if (std::strcmp(name, "string") == 0 || std::strcmp(name, "integer") == 0 ||
               std::strcmp(name, "real") == 0) {
      std::string& value = list.values_[list.prefix_ + list.key_];
      value += value.empty() ? list.text_ : " " + list.text_;
    }
    list.text_.clear();
  }
  static void text(void* self, const char* characters, int count) {
    static_cast<PropertyList*>(self)->text_.append(characters, std::size_t(count));
  }

  std::map<std::string, std::string> values_;
  std::string prefix_, key_, text_;
  int depth_ = 0;
};

/// The tar.gz archive of a project.
class ProjectArchive {
 public:
  explicit ProjectArchive(std::string_view bytes) : archive_(archive_read_new(), archive_read_free) {
    archive_read_support_format_tar(archive_.get());
    archive_read_support_filter_gzip(archive_.get());
    if (archive_read_open_memory(archive_.get(), bytes.data(), bytes.size()) != ARCHIVE_OK) fail();
  }

  /// Reads the file of a name, in any folder of the archive.
  /// @param max_bytes  [bytes] larger files are refused
  std::string read(const std::string& name, double max_bytes) {
    archive_entry* entry = nullptr;
    for (;;) {
      const int status = archive_read_next_header(archive_.get(), &entry);
      if (status == ARCHIVE_EOF) throw Error("it contains no file '" + name + "'; is it an InVesalius project?");
      if (status != ARCHIVE_OK) fail();
      if (const char* at = archive_entry_pathname(entry); at != nullptr && std::filesystem::path(at).filename() == name)
        break;
    }
    const auto size = double(archive_entry_size(entry));
    if (!(size >= 0 && size <= max_bytes))
      throw Error("its file '" + name + "' has " + format_number(size) + " bytes; at most " + format_number(max_bytes) +
                  " are allowed.");
    // The archive may claim more than it contains, so the buffer grows as data arrive.
    std::string bytes, buffer(1U << 20U, '\0');
    for (;;) {
      const auto count = archive_read_data(archive_.get(), buffer.data(), buffer.size());
      if (count < 0) fail();
      if (count == 0) break;
      bytes.append(buffer, 0, std::size_t(count));
    }
    if (double(bytes.size()) != size) throw Error("its file '" + name + "' is truncated.");
    return bytes;
  }

 private:
  [[noreturn]] void fail() {
    const char* reason = archive_error_string(archive_.get());
    throw Error("it is not an InVesalius project, or it is damaged (" +
                std::string(reason != nullptr ? reason : "unknown format") + ").");
  }

  std::unique_ptr<archive, int (*)(archive*)> archive_;
};

}  // namespace

RawImage parse_invesalius(std::string_view bytes) {
  constexpr double kMaxList = 1e6;  // [bytes]
  const PropertyList list(ProjectArchive(bytes).read("main.plist", kMaxList));
  if (list.get("matrix/dtype") != "int16")
    throw Error("its values are of type '" + list.get("matrix/dtype") + "'; only int16 is supported.");

  RawImage image;
  image.type = ValueType::int16;
  const Vec3 shape = list.three_numbers("matrix/shape");  // slices, rows, columns
  require_sane_dims({shape[2], shape[1], shape[0]});
  image.geometry.dims = {int(shape[2]), int(shape[1]), int(shape[0])};
  image.geometry.spacing_mm = list.three_numbers("spacing");
  image.bytes = ProjectArchive(bytes).read(list.get("matrix/filename"), double(image.needed()));
  if (image.bytes.size() != image.needed())
    throw Error("it has " + std::to_string(image.bytes.size()) + " bytes of values, but its shape needs " +
                std::to_string(image.needed()) + ".");
  return image;
}

}  // namespace hapticut
