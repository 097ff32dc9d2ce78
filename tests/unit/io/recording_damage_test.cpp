// SPDX-License-Identifier: Apache-2.0
// Files that are no recordings, of another version, or damaged on purpose: valid for HDF5, but with wrong content.
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

/// A recording of a few steps.
const std::string& good_recording() {
  static const std::string bytes = [] {
    const TemporaryFolder folder;
    return test::read_bytes(test::record_scene(folder / "a.h5", "axial_flat", kSteps));
  }();
  return bytes;
}

/// A recording in a separate folder, modified, and the error of reading it.
struct Damaged {
  explicit Damaged(const std::string& bytes) { test::write_bytes(path, bytes); }
  explicit Damaged(const std::function<void(hid_t file)>& change) : Damaged(good_recording()) { also(change); }
  void also(const std::function<void(hid_t file)>& change) const {
    const hdf5::File file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "opening");
    change(file.get());
  }
  [[nodiscard]] std::string complaint() const { return test::complaint_about(path); }

  TemporaryFolder folder = {};
  std::filesystem::path path = folder / "a.h5";
};

void expect_refused(const std::string& cause, const std::function<void(hid_t file)>& change) {
  test::expect_part(Damaged(change).complaint(), cause);
}

void remove(hid_t file, const std::string& name) {
  hdf5::checked(H5Ldelete(file, name.c_str(), H5P_DEFAULT), "deleting");
}

/// Replaces a data set by an empty one.
void replace(hid_t file, const std::string& name, hid_t type, const std::vector<hsize_t>& shape,
             const std::function<void(hid_t properties)>& prepare) {
  remove(file, name);
  const hdf5::DataSpace space(H5Screate_simple(int(shape.size()), shape.data(), nullptr), "replacing");
  const hdf5::Properties properties(H5Pcreate(H5P_DATASET_CREATE), "replacing");
  prepare(properties.get());
  const hdf5::DataSet set(H5Dcreate2(file, name.c_str(), type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
                          "replacing");
}

// Regression: the reader read a list of texts into the memory of one text.
TEST(DamagedRecording, MayNotHaveManyTextsInThePlaceOfOne) {
  expect_refused("'note' is not a text", [](hid_t file) {
    const hsize_t many = 1000;
    hdf5::checked(H5Adelete(file, "note"), "deleting");
    const hdf5::DataSpace space(H5Screate_simple(1, &many, nullptr), "changing");
    const hdf5::DataType type(H5Tcopy(H5T_C_S1), "changing");
    const hdf5::Attribute note(H5Acreate2(file, "note", type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), "changing");
    hdf5::checked(H5Awrite(note.get(), type.get(), std::string(many, 'a').data()), "changing");
  });
}

// HDF5 opens any target of a link or data set: a device, a pipe, a file of another user.
TEST(DamagedRecording, IsReadOnlyFromItself) {
  expect_refused("'simulation' is only a link", [](hid_t file) {
    remove(file, "simulation");
    hdf5::checked(H5Lcreate_external("/dev/zero", "/a", file, "simulation", H5P_DEFAULT, H5P_DEFAULT), "linking");
  });
  expect_refused("'dt' is only a link", [](hid_t file) {
    remove(file, "steps/dt");
    hdf5::checked(H5Lcreate_soft("/steps/time", file, "steps/dt", H5P_DEFAULT, H5P_DEFAULT), "linking");
  });
  expect_refused("'dt' is stored in another file", [](hid_t file) {
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
  expect_refused("'vdb' claims", [&](hid_t file) {
    replace(file, "workpiece/vdb", H5T_STD_U8LE, {hsize_t(1) << 31U}, chunks_of({4096}));
  });
  // The product of the lengths, 2^64, overflows to 0.
  expect_refused("'vdb' claims", [&](hid_t file) {
    replace(file, "workpiece/vdb", H5T_STD_U8LE, {hsize_t(1) << 32U, hsize_t(1) << 32U}, chunks_of({64, 64}));
  });
  expect_refused("'dt' claims", [&](hid_t file) {
    replace(file, "steps/dt", H5T_IEEE_F64LE, {hsize_t(1) << 29U}, chunks_of({hsize_t(1) << 28U}));
  });
  expect_refused("is empty", [](hid_t file) {
    remove(file, "simulation/max_sweep");
    const hdf5::DataSpace space(H5Screate(H5S_NULL), "replacing");
    const hdf5::DataSet set(
        H5Dcreate2(file, "simulation/max_sweep", H5T_IEEE_F64LE, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        "replacing");
  });
}

TEST(DamagedRecording, CountsTheLostStepsUpToTheLargestNumber) {
  expect_refused("do not increase", [](hid_t file) {
    std::uint64_t numbers[kSteps] = {std::numeric_limits<std::uint64_t>::max(), 1, 2, 3, 4};
    const hdf5::DataSet set = hdf5::open_data_set(file, "steps/number");
    hdf5::checked(H5Dwrite(set.get(), H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers), "changing");
  });
}

// The index of a column is read only with its values, so an export is the first to detect errors in the index.
TEST(DamagedRecording, IsNamedByAnExportThatCannotReadAColumn) {
  const TemporaryFolder folder;
  const std::string& bytes = good_recording();
  int refused = 0;
  const std::string index = "EAIB";  // marks the index of a growing data set
  for (std::size_t at = bytes.find(index); at != std::string::npos && refused < 3; at = bytes.find(index, at + 1)) {
    std::string wrong = bytes;
    wrong[at + index.size()] = char(wrong[at + index.size()] ^ 1);
    test::write_bytes(folder / "b.h5", wrong);
    std::optional<Recording> recording;
    try {
      recording.emplace(read_recording(folder / "b.h5"));
    } catch (const Error&) {
      continue;  // the index belongs to a column that the reader needs
    }
    for (const auto& write : {write_csv, write_npz}) {
      const std::string refusal = test::refusal([&] { write(*recording, folder / "out"); });
      EXPECT_TRUE(refusal.starts_with("cannot read '" + (folder / "b.h5").string())) << at << refusal;
    }
    ++refused;
  }
  EXPECT_GT(refused, 0);
}

TEST(BadRecording, IsNamedInOneSentence) {
  const TemporaryFolder folder;
  test::expect_part(test::complaint_about(folder / "absent.h5"), "no such file");
  test::expect_part(Damaged(std::string("this is no recording")).complaint(), "not an HDF5 file");
  test::expect_part(Damaged(std::string()).complaint(), "it is empty");
  H5Fclose(H5Fcreate((folder / "foreign.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  test::expect_part(test::complaint_about(folder / "foreign.h5"), "not a recording of hapticut");
  const auto of_format = [](std::uint64_t format) {
    return [format](hid_t file) {
      hdf5::checked(H5Adelete(file, "format"), "deleting");
      hdf5::write_attribute(file, "format", format);
    };
  };
  expect_refused("reads format 3; use a newer version", of_format(kRecordingFormat + 1));
  expect_refused("it has format 2; this version of hapticut reads format 3; use the version that wrote it",
                 of_format(kRecordingFormat - 1));
  for (const auto& [name, part] : {std::pair{"steps/force", "steps/force"},
                                   {"steps", "'steps'"},
                                   {"effects", "'effects'"},
                                   {"workpiece", "'workpiece'"},
                                   {"workpiece/vdb", "vdb"},
                                   {"simulation/max_dt", "simulation/max_dt"},
                                   {"tool/radius", "tool/radius"},
                                   {"materials/damping", "materials/damping"},
                                   {"materials", "'materials'"}})
    expect_refused(part, [missing = name](hid_t file) { remove(file, missing); });
  expect_refused("reference_stiffness", [](hid_t file) {
    const double value = -1;
    const hdf5::DataSet set = hdf5::open_data_set(file, "simulation/reference_stiffness");
    H5Dwrite(set.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value);
  });
  expect_refused("cannot read", [](hid_t file) {
    const std::vector<std::uint8_t> zeros(1 << 20, 0);
    const hdf5::DataSet set = hdf5::open_data_set(file, "workpiece/vdb");
    H5Dwrite(set.get(), H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data());
  });
}

TEST(BadRecording, ThatIsCutShortIsRefusedAtEveryLength) {
  const std::string& bytes = good_recording();
  for (const double share : {0.0, 0.0001, 0.001, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.999})
    EXPECT_NE(Damaged(bytes.substr(0, std::size_t(share * double(bytes.size())))).complaint(), "") << share;
}

/// Changes the list of fields of a group, as if another version had written it.
void change_fields(hid_t file, const char* group_name, const std::function<std::string(std::string)>& change) {
  const hdf5::Group group = hdf5::open_group(file, group_name);
  const std::string fields = hdf5::read_text_attribute(group.get(), "fields");
  hdf5::checked(H5Adelete(group.get(), "fields"), "deleting");
  hdf5::write_attribute(group.get(), "fields", change(fields));
}

TEST(Recording, GivesAFieldThatCameLaterItsDefaultAndRefusesOneThatIsMissingOrUnknown) {
  for (const auto& [group_name, field_name] : {std::pair{"simulation", "max_sweep"},
                                               {"tool", "spindle_droop"},
                                               {"materials", "density"},
                                               {"steps", "contact_level_of_detail"}}) {
    const char* const group = group_name;  // copy for the lambda captures
    const std::string field = field_name, place = std::string(group) + "/" + field;
    SCOPED_TRACE(place);
    const Damaged recording([&](hid_t file) { remove(file, place); });
    test::expect_part(recording.complaint(), place);
    recording.also([&](hid_t file) {
      change_fields(file, group, [&](std::string list) {
        const std::size_t at = list.find("," + field);
        EXPECT_NE(at, std::string::npos) << list;
        return list.erase(at, field.size() + 1);
      });
    });
    EXPECT_EQ(recording.complaint(), "");
    EXPECT_EQ(read_recording(recording.path).config().max_sweep, SimulationConfig{}.max_sweep);
    recording.also(
        [&](hid_t file) { change_fields(file, group, [](const std::string& list) { return list + ",taste"; }); });
    test::expect_part(recording.complaint(), "newer version");
  }
}

}  // namespace
}  // namespace hapticut::recording_damage_test
