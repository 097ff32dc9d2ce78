// SPDX-License-Identifier: Apache-2.0
#include "io/recording/hdf5.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace hapticut::hdf5 {
namespace {

constexpr hsize_t kMaxText = 1 << 20;  // [bytes]

/// The innermost entry of HDF5's error stack is the reason; the others are the call chain.
herr_t keep_first(unsigned n, const H5E_error2_t* entry, void* reason) {
  if (n == 0 && entry->desc != nullptr) *static_cast<std::string*>(reason) = entry->desc;
  return 0;
}

DataType text_type(std::size_t length) {
  DataType type(H5Tcopy(H5T_C_S1), "making a text type");
  checked(H5Tset_size(type.get(), std::max<std::size_t>(1, length)), "making a text type");
  checked(H5Tset_cset(type.get(), H5T_CSET_UTF8), "making a text type");
  checked(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), "making a text type");
  return type;
}

/// A buffer for a text of this fixed-length type.
std::string buffer_for(const DataType& type, const std::string& name) {
  const std::size_t length = H5Tget_size(type.get());
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0 || length > kMaxText)
    throw Failure("its '" + name + "' is not a text");
  return std::string(length, '\0');
}

/// @throws Failure when there is no such name, or it is a link
void require_here(hid_t parent, const std::string& name) {
  H5L_info_t info;
  checked(H5Lget_info(parent, name.c_str(), &info, H5P_DEFAULT), "finding " + name);
  if (info.type != H5L_TYPE_HARD) throw Failure("its '" + name + "' is only a link to another place");
}

hsize_t size_of_file(hid_t object) {
  const File file(H5Iget_file_id(object), "inspecting the file");
  hsize_t size = 0;
  checked(H5Fget_filesize(file.get(), &size), "inspecting the file");
  return size;
}

void write_attribute(hid_t object, const std::string& name, hid_t type, const void* value) {
  const DataSpace space(H5Screate(H5S_SCALAR), "allocating " + name);
  const Attribute attribute(H5Acreate2(object, name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT),
                            "creating " + name);
  checked(H5Awrite(attribute.get(), type, value), "writing " + name);
}

/// @throws Failure when there is no such attribute, or it has several values
std::pair<Attribute, DataType> open_attribute(hid_t object, const std::string& name, const char* what) {
  Attribute attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), "opening " + name);
  DataType type(H5Aget_type(attribute.get()), "inspecting " + name);
  const DataSpace space(H5Aget_space(attribute.get()), "inspecting " + name);
  if (H5Sget_simple_extent_npoints(space.get()) != 1) throw Failure("its '" + name + "' is not a " + what);
  return {std::move(attribute), std::move(type)};
}

std::string until_null(const std::string& text) { return text.substr(0, text.find('\0')); }

}  // namespace

Quiet::Quiet() {
  H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Quiet::~Quiet() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }

void be_quiet_at_exit() {
  // The last registered function runs first, so before HDF5's own exit function.
  static const bool registered = std::atexit([] { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }) == 0;
  (void)registered;
}

void fail(const std::string& what, Fault fault) {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
  H5Eclear2(H5E_DEFAULT);
  reason.resize(std::min(reason.find(':'), reason.size()));  // the rest are variables of HDF5's code
  throw Failure(what + " failed" + (reason.empty() ? "" : " (HDF5: " + reason + ")"), fault);
}

hid_t type_of(ValueType type) {
  static_assert(std::endian::native == std::endian::little);
  const hid_t types[] = {H5T_STD_U8LE,  H5T_STD_I8LE,  H5T_STD_U16LE, H5T_STD_I16LE,  H5T_STD_U32LE,
                         H5T_STD_I32LE, H5T_STD_U64LE, H5T_STD_I64LE, H5T_IEEE_F32LE, H5T_IEEE_F64LE};
  return types[std::size_t(type)];
}

Group create_group(hid_t parent, const std::string& name) {
  return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), "creating " + name};
}

Group open_group(hid_t parent, const std::string& name) {
  require_here(parent, name);
  return {H5Gopen2(parent, name.c_str(), H5P_DEFAULT), "opening " + name};
}

Object open_object(hid_t parent, const std::string& name) {
  require_here(parent, name);
  return {H5Oopen(parent, name.c_str(), H5P_DEFAULT), "opening " + name};
}

bool exists(hid_t parent, const std::string& name) { return H5Lexists(parent, name.c_str(), H5P_DEFAULT) > 0; }

void write_attribute(hid_t object, const std::string& name, const std::string& text) {
  write_attribute(object, name, text_type(text.size()).get(), text.c_str());
}

void write_attribute(hid_t object, const std::string& name, std::uint64_t number) {
  write_attribute(object, name, type_of(ValueType::uint64), &number);
}

std::string read_text_attribute(hid_t object, const std::string& name) {
  const auto [attribute, type] = open_attribute(object, name, "text");
  std::string text = buffer_for(type, name);
  checked(H5Aread(attribute.get(), type.get(), text.data()), "reading " + name);
  return until_null(text);
}

std::uint64_t read_number_attribute(hid_t object, const std::string& name) {
  const auto [attribute, type] = open_attribute(object, name, "whole number");
  if (H5Tget_class(type.get()) != H5T_INTEGER) throw Failure("its '" + name + "' is not a whole number");
  std::uint64_t number = 0;
  checked(H5Aread(attribute.get(), type_of(ValueType::uint64), &number), "reading " + name);
  return number;
}

bool has_attribute(hid_t object, const std::string& name) { return H5Aexists(object, name.c_str()) > 0; }

std::vector<hsize_t> shape_of(hid_t data_set) {
  const DataSpace space(H5Dget_space(data_set), "inspecting a data set");
  if (H5Sget_simple_extent_type(space.get()) == H5S_NULL) throw Failure("one of its data sets is empty");
  std::vector<hsize_t> shape(std::size_t(checked(H5Sget_simple_extent_ndims(space.get()), "inspecting a data set")));
  checked(H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr), "inspecting a data set");
  return shape;
}

DataSet open_data_set(hid_t parent, const std::string& name) {
  require_here(parent, name);
  DataSet set(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), "opening " + name);
  const Properties made(H5Dget_create_plist(set.get()), "inspecting " + name);
  const H5D_layout_t layout = H5Pget_layout(made.get());
  if (layout == H5D_CHUNKED) {
    std::array<hsize_t, H5S_MAX_RANK> chunk{};
    const int rank = checked(H5Pget_chunk(made.get(), int(chunk.size()), chunk.data()), "inspecting " + name);
    const DataType type(H5Dget_type(set.get()), "inspecting " + name);
    auto bytes = double(H5Tget_size(type.get()));
    for (int n = 0; n < rank; ++n) bytes *= double(chunk[std::size_t(n)]);
    require_size_in_file(bytes, size_of_file(set.get()), name);
  } else if ((layout != H5D_CONTIGUOUS && layout != H5D_COMPACT) || H5Pget_external_count(made.get()) != 0) {
    throw Failure("its '" + name + "' is stored in another file");
  }
  return set;
}

H5T_class_t number_class(hid_t data_set, const std::string& name) {
  const DataType type(H5Dget_type(data_set), "inspecting " + name);
  const H5T_class_t kind = H5Tget_class(type.get());
  if ((kind != H5T_FLOAT && kind != H5T_INTEGER) || H5Tget_size(type.get()) > sizeof(double))
    throw Failure("its '" + name + "' has no numbers");
  return kind;
}

Appender Appender::create(hid_t group, const std::string& name, ValueType type, const std::vector<hsize_t>& row_shape) {
  constexpr hsize_t kChunk = 256;  // rows
  std::vector<hsize_t> now = row_shape, max_shape = row_shape, chunk = row_shape;
  now.insert(now.begin(), 0);
  max_shape.insert(max_shape.begin(), H5S_UNLIMITED);
  chunk.insert(chunk.begin(), kChunk);
  const DataSpace space(H5Screate_simple(int(now.size()), now.data(), max_shape.data()), "allocating " + name);
  const Properties properties(H5Pcreate(H5P_DATASET_CREATE), "creating " + name);
  checked(H5Pset_chunk(properties.get(), int(chunk.size()), chunk.data()), "creating " + name);
  (void)DataSet(H5Dcreate2(group, name.c_str(), type_of(type), space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
                "creating " + name);
  return {group, name, type};
}

Appender::Appender(hid_t group, const std::string& name, ValueType type)
    : name_(name),
      set_(H5Dopen2(group, name.c_str(), H5P_DEFAULT), "opening " + name),
      type_(type),
      shape_(shape_of(set_.get())) {}

void Appender::append(const void* rows, std::size_t count) {
  const std::string what = "writing " + name_;
  std::vector<hsize_t> from(shape_.size(), 0), length = shape_;
  from.at(0) = shape_.at(0);
  length[0] = count;
  shape_[0] += count;
  checked(H5Dset_extent(set_.get(), shape_.data()), what);
  const DataSpace target(H5Dget_space(set_.get()), what);
  checked(H5Sselect_hyperslab(target.get(), H5S_SELECT_SET, from.data(), nullptr, length.data(), nullptr), what);
  const DataSpace source(H5Screate_simple(int(length.size()), length.data(), nullptr), what);
  checked(H5Dwrite(set_.get(), type_of(type_), source.get(), target.get(), H5P_DEFAULT, rows), what);
}

DataSet write_text(hid_t parent, const std::string& name, const std::string& text) {
  const DataType type = text_type(text.size());
  const DataSpace space(H5Screate(H5S_SCALAR), "allocating " + name);
  DataSet set(H5Dcreate2(parent, name.c_str(), type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
              "creating " + name);
  checked(H5Dwrite(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()), "writing " + name);
  return set;
}

std::string read_text(hid_t parent, const std::string& name) {
  const DataSet set = open_data_set(parent, name);
  const DataType type(H5Dget_type(set.get()), "inspecting " + name);
  const DataSpace space(H5Dget_space(set.get()), "inspecting " + name);
  if (H5Sget_simple_extent_npoints(space.get()) != 1) throw Failure("its '" + name + "' is not a text");
  std::string text = buffer_for(type, name);
  checked(H5Dread(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), "reading " + name);
  return until_null(text);
}

}  // namespace hapticut::hdf5
