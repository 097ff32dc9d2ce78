// SPDX-License-Identifier: Apache-2.0
#include "io/recording/hdf5_source.hpp"

#include <new>
#include <string_view>

#include "io/file_errors.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kHead = 12;  // [bytes] part of the file header that identifies the format
constexpr std::uint64_t kMaxBlock = std::uint64_t(1) << 40U;  // [bytes] limit of a block query

/// Whether a writer has the file open, or was killed with the file open: a bit in the header (HDF5 File Format
/// Specification, superblock version 3).
bool has_writer(std::string_view head) {
  constexpr std::size_t kVersion = 8, kFlags = 11;
  constexpr unsigned kWriterWithReaders = 4;
  return head.size() > kFlags && head[kVersion] == 3 && (unsigned(head[kFlags]) & kWriterWithReaders) != 0;
}

/// @param id    HDF5's identifier of the file
/// @param head  first bytes of the file
hdf5::File require_open(hid_t id, std::string_view head) {
  hdf5::File file(id);
  if (file.valid()) return file;
  if (!head.starts_with("\x89HDF"))
    throw hdf5::Failure("it is not an HDF5 file, so not a recording of hapticut", Fault::not_hdf5);
  hdf5::fail("it is a damaged HDF5 file; opening it", Fault::damaged);
}

}  // namespace

std::unique_ptr<Hdf5Source> open_hdf5_file(const std::filesystem::path& path) {
  const hdf5::Quiet quiet;
  const std::string head = first_bytes(path, kHead);
  const hdf5::Properties access(H5Pcreate(H5P_FILE_ACCESS), "preparing");
  constexpr unsigned kAttempts = 12;  // retries while the writer changes metadata; HDF5's default of 100 takes minutes
  unsigned mode = H5F_ACC_RDONLY;
  if (has_writer(head)) {
    mode |= H5F_ACC_SWMR_READ;
    hdf5::checked(H5Pset_metadata_read_attempts(access.get(), kAttempts), "preparing");
  }
  hdf5::File file = require_open(H5Fopen(path.c_str(), mode, access.get()), head);
  hsize_t size = 0;
  hdf5::checked(H5Fget_filesize(file.get(), &size), "inspecting the file");
  return std::make_unique<Hdf5Source>(std::move(file), size);
}

Hdf5Source::~Hdf5Source() {
  const hdf5::Quiet quiet;
  hdf5::be_quiet_at_exit();  // where HDF5 closes a damaged file
  data_sets_.clear();
  file_.reset();
}

hdf5::Group Hdf5Source::group_at(const std::string& place) const {
  hdf5::Group group(H5Gopen2(file_.get(), "/", H5P_DEFAULT), "opening it");
  for (std::size_t begin = 0; begin < place.size();) {
    const std::size_t end = std::min(place.find('/', begin), place.size());
    group = hdf5::open_group(group.get(), place.substr(begin, end - begin));
    begin = end + 1;
  }
  return group;
}

hdf5::Group Hdf5Source::parent_group_of(const std::string& place) const {
  const std::size_t slash = place.rfind('/');
  return group_at(slash == std::string::npos ? "" : place.substr(0, slash));
}

hdf5::Object Hdf5Source::object_at(const std::string& place) const {
  if (place.empty()) return {H5Oopen(file_.get(), "/", H5P_DEFAULT), "opening it"};
  return hdf5::open_object(parent_group_of(place).get(), name_at(place));
}

hid_t Hdf5Source::data_set_at(const std::string& place) {
  const auto known = data_sets_.find(place);
  if (known != data_sets_.end()) return known->second.get();
  hdf5::DataSet set = hdf5::open_data_set(parent_group_of(place).get(), name_at(place));
  return data_sets_.emplace(place, std::move(set)).first->second.get();
}

std::string Hdf5Source::reply_to(const Query& query) {
  const hdf5::Quiet quiet;
  const std::string &place = query.place, &name = query.name;
  std::string content;
  switch (query.kind) {
    case QueryKind::open:
      break;
    case QueryKind::exists:
      append_bytes_of(content, hdf5::exists(parent_group_of(place).get(), name_at(place)));
      break;
    case QueryKind::has_attribute:
      append_bytes_of(content, hdf5::has_attribute(object_at(place).get(), name));
      break;
    case QueryKind::text_attribute:
      return hdf5::read_text_attribute(object_at(place).get(), name);
    case QueryKind::number_attribute:
      append_bytes_of(content, hdf5::read_number_attribute(object_at(place).get(), name));
      break;
    case QueryKind::text:
      return hdf5::read_text(parent_group_of(place).get(), name_at(place));
    case QueryKind::layout:
      return layout_at(place);
    case QueryKind::block:
      return block_of(query);
  }
  return content;
}

std::string Hdf5Source::layout_at(const std::string& place) {
  const hid_t set = data_set_at(place);
  std::string content;
  append_bytes_of(content, std::uint64_t(hdf5::number_class(set, name_at(place)) == H5T_FLOAT));
  for (const hsize_t length : hdf5::shape_of(set)) append_bytes_of(content, std::uint64_t(length));
  return content;
}

std::string Hdf5Source::block_of(const Query& q) {
  if (double(q.numbers) * double(q.count) > double(kMaxBlock)) throw std::bad_alloc();
  const std::string name = name_at(q.place), its = "its '" + name + "'", what = "reading " + name;
  const hid_t set = data_set_at(q.place);
  (void)hdf5::number_class(set, name);
  std::vector<hsize_t> length = hdf5::shape_of(set);
  const hdf5::DataSpace source(H5Dget_space(set), what);
  if (!length.empty()) {
    std::vector<hsize_t> from(length.size(), 0);
    from[0] = q.first;
    if (q.first > length[0] || q.count > length[0] - q.first) throw hdf5::Failure(its + " is shorter");
    length[0] = q.count;
    hdf5::checked(H5Sselect_hyperslab(source.get(), H5S_SELECT_SET, from.data(), nullptr, length.data(), nullptr),
                  what);
  }
  const hsize_t expected = q.numbers * q.count;
  if (hdf5::checked(H5Sget_select_npoints(source.get()), what) != hssize_t(expected))
    throw hdf5::Failure(its + " has another shape");
  std::string bytes(expected * size_of(q.value_type), '\0');
  const hdf5::DataSpace target(H5Screate_simple(1, &expected, nullptr), what);
  hdf5::checked(H5Dread(set, hdf5::type_of(q.value_type), target.get(), source.get(), H5P_DEFAULT, bytes.data()), what);
  return bytes;
}

}  // namespace hapticut
