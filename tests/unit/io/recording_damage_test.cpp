// SPDX-License-Identifier: Apache-2.0
// Recordings that somebody damaged on purpose: HDF5 finds them in order, and what they say of themselves is wrong.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <optional>

#include "hapticut/core/errors.hpp"
#include "hapticut/io/recording/recording.hpp"
#include "io/recording/hdf5.hpp"
#include "support/recordings.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::recording_damage_test {
namespace {

using test::TemporaryFolder;

constexpr int kSteps = 5;

std::filesystem::path recorded(const TemporaryFolder& folder) {
  test::record_scene(folder / "a.h5", "axial_flat", kSteps);
  return folder / "a.h5";
}

/// What is said of a recording that was changed.
std::string refusal_of(const std::function<void(hid_t file)>& change) {
  const TemporaryFolder folder;
  const std::filesystem::path path = recorded(folder);
  {
    const hdf5::File file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "opening");
    change(file.get());
  }
  try {
    (void)read_recording(path).workpiece();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("a.h5"), std::string::npos) << error.what();
    return error.what();
  }
  return "";
}

void expect_refusal(const std::string& cause, const std::function<void(hid_t file)>& change) {
  const std::string refusal = refusal_of(change);
  EXPECT_NE(refusal.find(cause), std::string::npos) << refusal;
}

void remove(hid_t file, const std::string& name) {
  hdf5::checked(H5Ldelete(file, name.c_str(), H5P_DEFAULT), "deleting");
}

/// Puts an empty data set in the place of another.
void replace(hid_t file, const std::string& name, hid_t type, const std::vector<hsize_t>& shape,
             const std::function<void(hid_t properties)>& prepare) {
  remove(file, name);
  const hdf5::DataSpace space(H5Screate_simple(int(shape.size()), shape.data(), nullptr), "replacing");
  const hdf5::Properties properties(H5Pcreate(H5P_DATASET_CREATE), "replacing");
  prepare(properties.get());
  const hdf5::DataSet set(H5Dcreate2(file, name.c_str(), type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
                          "replacing");
}

// A list of texts was read into the room of one.
TEST(DamagedRecording, MayNotHaveManyTextsInThePlaceOfOne) {
  expect_refusal("'note' is no text", [](hid_t file) {
    const hsize_t many = 1000;
    hdf5::checked(H5Adelete(file, "note"), "deleting");
    const hdf5::DataSpace space(H5Screate_simple(1, &many, nullptr), "changing");
    const hdf5::DataType type(H5Tcopy(H5T_C_S1), "changing");
    const hdf5::Attribute note(H5Acreate2(file, "note", type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), "changing");
    hdf5::checked(H5Awrite(note.get(), type.get(), std::string(many, 'a').data()), "changing");
  });
}

// HDF5 opens whatever a link or a data set names: a device, a pipe, another user's file.
TEST(DamagedRecording, IsReadOnlyFromItself) {
  expect_refusal("'simulation' is only a link", [](hid_t file) {
    remove(file, "simulation");
    hdf5::checked(H5Lcreate_external("/dev/zero", "/a", file, "simulation", H5P_DEFAULT, H5P_DEFAULT), "linking");
  });
  expect_refusal("'dt' is only a link", [](hid_t file) {
    remove(file, "steps/dt");
    hdf5::checked(H5Lcreate_soft("/steps/time", file, "steps/dt", H5P_DEFAULT, H5P_DEFAULT), "linking");
  });
  expect_refusal("'dt' lies in another file", [](hid_t file) {
    replace(file, "steps/dt", H5T_IEEE_F64LE, {kSteps},
            [](hid_t properties) { H5Pset_external(properties, "/dev/zero", 0, kSteps * sizeof(double)); });
  });
}

TEST(DamagedRecording, MayNotClaimMoreThanItHolds) {
  const auto chunks_of = [](const std::vector<hsize_t>& chunk) {
    return [chunk](hid_t properties) {
      H5Pset_chunk(properties, int(chunk.size()), chunk.data());
      H5Pset_alloc_time(properties, H5D_ALLOC_TIME_INCR);
    };
  };
  expect_refusal("'vdb' claims", [&](hid_t file) {
    replace(file, "workpiece/vdb", H5T_STD_U8LE, {hsize_t(1) << 31U}, chunks_of({4096}));
  });
  // As whole numbers, the product of the lengths is 0.
  expect_refusal("'vdb' claims", [&](hid_t file) {
    replace(file, "workpiece/vdb", H5T_STD_U8LE, {hsize_t(1) << 32U, hsize_t(1) << 32U}, chunks_of({64, 64}));
  });
  expect_refusal("'dt' claims", [&](hid_t file) {
    replace(file, "steps/dt", H5T_IEEE_F64LE, {hsize_t(1) << 29U}, chunks_of({hsize_t(1) << 28U}));
  });
  expect_refusal("holds nothing", [](hid_t file) {
    remove(file, "simulation/longest_sweep");
    const hdf5::DataSpace space(H5Screate(H5S_NULL), "replacing");
    const hdf5::DataSet set(H5Dcreate2(file, "simulation/longest_sweep", H5T_IEEE_F64LE, space.get(), H5P_DEFAULT,
                                       H5P_DEFAULT, H5P_DEFAULT),
                            "replacing");
  });
}

TEST(DamagedRecording, CountsTheLostStepsUpToTheLargestNumber) {
  expect_refusal("do not increase", [](hid_t file) {
    std::uint64_t numbers[kSteps] = {std::numeric_limits<std::uint64_t>::max(), 1, 2, 3, 4};
    const hdf5::DataSet set = hdf5::open_data_set(file, "steps/number");
    hdf5::checked(H5Dwrite(set.get(), H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers), "changing");
  });
}

// The places of a column's values are looked up when it is read, so an export is the first to see that they are wrong.
TEST(DamagedRecording, IsNamedByAnExportThatCannotReadAColumn) {
  const TemporaryFolder folder;
  const std::string bytes = test::read_bytes(recorded(folder));
  int refused = 0;
  const std::string index = "EAIB";  // begins the places of a data set that grows
  for (std::size_t at = bytes.find(index); at != std::string::npos && refused < 3; at = bytes.find(index, at + 1)) {
    std::string wrong = bytes;
    wrong[at + index.size()] = char(wrong[at + index.size()] ^ 1);
    test::write_bytes(folder / "b.h5", wrong);
    std::optional<Recording> recording;
    try {
      recording.emplace(read_recording(folder / "b.h5"));
    } catch (const Error&) {
      continue;  // of a column that the reader needs
    }
    for (const auto& write : {write_csv, write_npz}) {
      try {
        write(*recording, folder / "out");
        ADD_FAILURE() << at;
      } catch (const Error& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("cannot read '" + (folder / "b.h5").string()))
            << error.what();
      }
    }
    ++refused;
  }
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace hapticut::recording_damage_test
