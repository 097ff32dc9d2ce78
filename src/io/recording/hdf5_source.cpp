// SPDX-License-Identifier: Apache-2.0
#include "io/recording/hdf5_source.hpp"

#include <string_view>

#include "io/file_errors.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kHead = 12;  // [bytes] of a file that say what it is

/// Whether a writer has the file open, or was killed while it had: a bit in the head of the file (HDF5 File Format
/// Specification, superblock version 3).
bool has_writer(std::string_view head) {
  constexpr std::size_t kVersion = 8, kFlags = 11;
  constexpr unsigned kWriterWithReaders = 4;
  return head.size() > kFlags && head[kVersion] == 3 && (unsigned(head[kFlags]) & kWriterWithReaders) != 0;
}

/// @param id    what HDF5 made of the file
/// @param head  its first bytes
hdf5::File require_open(hid_t id, std::string_view head) {
  hdf5::File file(id);
  if (file.valid()) return file;
  if (!head.starts_with("\x89HDF")) throw hdf5::Failure("it is not an HDF5 file, so not a recording of hapticut");
  hdf5::fail("it is a damaged HDF5 file; opening it");
}

/// The place that holds another, "" for the file itself.
std::string holder_of(const std::string& place) {
  const std::size_t slash = place.rfind('/');
  return slash == std::string::npos ? "" : place.substr(0, slash);
}

}  // namespace

std::unique_ptr<Hdf5Source> open_hdf5_file(const std::filesystem::path& path) {
  const hdf5::Quiet quiet;
  const std::string head = first_bytes(path, kHead);
  const hdf5::Properties access(H5Pcreate(H5P_FILE_ACCESS), "preparing");
  constexpr unsigned kAttempts = 12;  // to read what the writer is just changing; HDF5's own 100 take minutes
  unsigned mode = H5F_ACC_RDONLY;
  if (has_writer(head)) {
    mode |= H5F_ACC_SWMR_READ;
    hdf5::checked(H5Pset_metadata_read_attempts(access.get(), kAttempts), "preparing");
  }
  hdf5::File file = require_open(H5Fopen(path.c_str(), mode, access.get()), head);
  hsize_t size = 0;
  hdf5::checked(H5Fget_filesize(file.get(), &size), "looking at the file");
  return std::make_unique<Hdf5Source>(std::move(file), size);
}

Hdf5Source::~Hdf5Source() {
  const hdf5::Quiet quiet;
  hdf5::be_quiet_at_exit();  // where HDF5 closes what is left of a damaged file
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

hid_t Hdf5Source::data_set_at(const std::string& place) {
  const auto known = data_sets_.find(place);
  if (known != data_sets_.end()) return known->second.get();
  hdf5::DataSet set = hdf5::open_data_set(group_at(holder_of(place)).get(), name_at(place));
  return data_sets_.emplace(place, std::move(set)).first->second.get();
}

template <class Use>
auto Hdf5Source::with_object(const std::string& place, const Use& use) const {
  const hdf5::Quiet quiet;
  if (place.empty()) return use(file_.get());
  return use(hdf5::open_object(group_at(holder_of(place)).get(), name_at(place)).get());
}

bool Hdf5Source::exists(const std::string& place) {
  const hdf5::Quiet quiet;
  return hdf5::exists(group_at(holder_of(place)).get(), name_at(place));
}

bool Hdf5Source::has_attribute(const std::string& place, const std::string& name) {
  return with_object(place, [&](hid_t object) { return hdf5::has_attribute(object, name); });
}

std::string Hdf5Source::text_attribute(const std::string& place, const std::string& name) {
  return with_object(place, [&](hid_t object) { return hdf5::read_text_attribute(object, name); });
}

std::uint64_t Hdf5Source::number_attribute(const std::string& place, const std::string& name) {
  return with_object(place, [&](hid_t object) { return hdf5::read_number_attribute(object, name); });
}

std::string Hdf5Source::text(const std::string& place) {
  const hdf5::Quiet quiet;
  return hdf5::read_text(group_at(holder_of(place)).get(), name_at(place));
}

DataSetLayout Hdf5Source::layout(const std::string& place) {
  const hdf5::Quiet quiet;
  const hid_t set = data_set_at(place);
  const std::vector<hsize_t> shape = hdf5::shape_of(set);
  return {hdf5::number_class(set, name_at(place)) == H5T_FLOAT, {shape.begin(), shape.end()}};
}

void Hdf5Source::block(const std::string& place, ColumnKind kind, std::uint64_t numbers, std::uint64_t first,
                       std::uint64_t count, std::byte* bytes) {
  const hdf5::Quiet quiet;
  const std::string what = "reading " + name_at(place);
  const hid_t set = data_set_at(place);
  (void)hdf5::number_class(set, name_at(place));
  std::vector<hsize_t> length = hdf5::shape_of(set);
  const hdf5::DataSpace source(H5Dget_space(set), what);
  if (!length.empty()) {
    std::vector<hsize_t> from(length.size(), 0);
    from[0] = first;
    if (first > length[0] || count > length[0] - first) throw hdf5::Failure("its '" + name_at(place) + "' is shorter");
    length[0] = count;
    hdf5::checked(H5Sselect_hyperslab(source.get(), H5S_SELECT_SET, from.data(), nullptr, length.data(), nullptr),
                  what);
  }
  const hsize_t expected = numbers * count;
  if (hdf5::checked(H5Sget_select_npoints(source.get()), what) != hssize_t(expected))
    throw hdf5::Failure("its '" + name_at(place) + "' has another shape");
  const hdf5::DataSpace target(H5Screate_simple(1, &expected, nullptr), what);
  hdf5::checked(H5Dread(set, hdf5::type_of(kind).memory, target.get(), source.get(), H5P_DEFAULT, bytes), what);
}

}  // namespace hapticut
