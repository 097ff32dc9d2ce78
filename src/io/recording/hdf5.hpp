// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <hdf5.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "io/recording/recording_source.hpp"

/// @file
/// Owners for the identifiers of HDF5's C interface, and exceptions for its error codes. HDF5's own C++ layer lacks
/// single-writer-multiple-reader mode, which recordings need.
namespace hapticut::hdf5 {

/// While it lives, HDF5 prints nothing to stderr in this thread.
class Quiet {
 public:
  Quiet();
  ~Quiet();
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// Prevents HDF5 from printing when the program ends and HDF5 closes a damaged file.
void be_quiet_at_exit();

/// @throws Failure that names the failed operation and HDF5's reason
[[noreturn]] void fail(const std::string& what, Fault fault = Fault::part);

template <class Code>
Code checked(Code code, const std::string& what) {
  if (code < 0) fail(what);
  return code;
}

/// Owns an HDF5 identifier.
template <herr_t (*kClose)(hid_t)>
class Handle {
 public:
  Handle() = default;
  explicit Handle(hid_t id) : id_(id) {}
  Handle(hid_t id, const std::string& what) : id_(checked(id, what)) {}
  ~Handle() { reset(); }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  Handle& operator=(Handle&& other) noexcept {
    if (this != &other) {
      reset();
      id_ = std::exchange(other.id_, H5I_INVALID_HID);
    }
    return *this;
  }

  [[nodiscard]] hid_t get() const { return id_; }
  [[nodiscard]] bool valid() const { return id_ >= 0; }
  /// @return HDF5's code
  herr_t reset() noexcept { return id_ >= 0 ? kClose(std::exchange(id_, H5I_INVALID_HID)) : 0; }

 private:
  hid_t id_ = H5I_INVALID_HID;
};

using File = Handle<H5Fclose>;
using Group = Handle<H5Gclose>;
using DataSet = Handle<H5Dclose>;
using DataSpace = Handle<H5Sclose>;
using DataType = Handle<H5Tclose>;
using Object = Handle<H5Oclose>;
using Attribute = Handle<H5Aclose>;
using Properties = Handle<H5Pclose>;

/// The HDF5 type of numbers, in the file and in memory (little-endian).
[[nodiscard]] hid_t type_of(ValueType type);

[[nodiscard]] Group create_group(hid_t parent, const std::string& name);
[[nodiscard]] Group open_group(hid_t parent, const std::string& name);

/// Opens a group or data set inside the file.
/// @throws Failure when it does not exist or is a link
[[nodiscard]] Object open_object(hid_t parent, const std::string& name);
[[nodiscard]] bool exists(hid_t parent, const std::string& name);

void write_attribute(hid_t object, const std::string& name, const std::string& text);
void write_attribute(hid_t object, const std::string& name, std::uint64_t number);

/// @throws Failure when it does not exist or has another kind
[[nodiscard]] std::string read_text_attribute(hid_t object, const std::string& name);
[[nodiscard]] std::uint64_t read_number_attribute(hid_t object, const std::string& name);
[[nodiscard]] bool has_attribute(hid_t object, const std::string& name);

/// Lengths along the dimensions of a data set.
[[nodiscard]] std::vector<hsize_t> shape_of(hid_t data_set);

/// Opens a data set inside the file. HDF5 itself would follow a link or external storage to any file or device.
/// @throws Failure when it does not exist or its data are elsewhere
[[nodiscard]] DataSet open_data_set(hid_t parent, const std::string& name);

/// H5T_INTEGER or H5T_FLOAT.
/// @throws Failure for any other type
[[nodiscard]] H5T_class_t number_class(hid_t data_set, const std::string& name);

/// Writes a data set with a fixed number of rows.
template <class Number>
DataSet write_array(hid_t parent, const std::string& name, const Number* values, const std::vector<hsize_t>& shape) {
  const hid_t type = type_of(value_type_of<Number>());
  const DataSpace space(H5Screate_simple(int(shape.size()), shape.data(), nullptr), "allocating " + name);
  DataSet set(H5Dcreate2(parent, name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
              "creating " + name);
  checked(H5Dwrite(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "writing " + name);
  return set;
}

/// A data set with an unlimited first dimension.
class Appender {
 public:
  /// Creates an empty data set.
  static Appender create(hid_t group, const std::string& name, ValueType type, const std::vector<hsize_t>& row_shape);
  /// Opens an existing data set.
  Appender(hid_t group, const std::string& name, ValueType type);

  void append(const void* rows, std::size_t count);
  [[nodiscard]] hid_t get() const { return set_.get(); }

 private:
  std::string name_;
  DataSet set_;
  ValueType type_;
  std::vector<hsize_t> shape_;
};

/// Writes a text as a data set.
DataSet write_text(hid_t parent, const std::string& name, const std::string& text);
[[nodiscard]] std::string read_text(hid_t parent, const std::string& name);

}  // namespace hapticut::hdf5
