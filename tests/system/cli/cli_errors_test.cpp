// SPDX-License-Identifier: Apache-2.0
// Errors of the command line program: one sentence, an exit code, and no half-written file.
#include <gtest/gtest.h>
#include <unistd.h>

#include <random>

#include "support/program.hpp"

namespace hapticut::cli_errors_test {
namespace {

using test::kFailed;
using test::kWrongUsage;
using test::ProgramOutcome;
using test::write_bytes;

const std::string kBlock = "--workpiece block --size_mm 2,2,2 --material dentin --voxel_mm 0.2 ";
const std::string kBall = "--head sphere --radius_mm 0.5 --spindle_rpm 30000 ";
const std::string kLine = "--path line --from_mm 0,1,2 --to_mm 2,1,2 --feed_mm_per_s 20 ";

class Complaint : public test::Program {
 protected:
  /// Runs the program and expects one line on stderr that contains `part`.
  void expect(const std::string& arguments, int code, const std::string& part) {
    expect_refused(arguments, {part}, code);
  }
};

using Flags = Complaint;
using SettingsFile = Complaint;
using Files = Complaint;

TEST_F(Complaint, OfADeviceThatThisBuildLacksNamesNoFunctionToCall) {
  expect("loop openhaptics --seconds 0.1", kFailed, "then build hapticut with -DHAPTICUT_WITH_OPENHAPTICS=ON.");
}

TEST_F(Flags, ThatDoNotExistAreRefusedWithTheNearestOne) {
  expect("drill --raduis_mm 1", kWrongUsage, "there is no --raduis_mm. Did you mean --radius_mm?");
  expect("drill --json-file x", kWrongUsage, "there is no --json");
  expect("drill --size_mm 60 10 10", kWrongUsage, "10 belongs to no flag. Separate the numbers of one flag by commas");
  expect("drill --feed 4", kWrongUsage, "there is no --feed. Did you mean --feed_mm_per_s?");
  expect("drill --to 1,3,2.5", kWrongUsage, "there is no --to. Did you mean --to_mm?");
  expect("drill --radius 1", kWrongUsage, "there is no --radius. Did you mean --radius_mm?");
  expect("drill --voxel 1", kWrongUsage, "there is no --voxel. Did you mean --voxel_mm?");
  expect("drill --rpm 4000", kWrongUsage, "there is no --rpm. Did you mean --spindle_rpm?");
  expect("drill --spindle-speed 4000", kWrongUsage, "there is no --spindle_speed. Did you mean --spindle_rpm?");
  expect("dril", kWrongUsage, "there is no dril. Did you mean drill?");
}

TEST_F(Flags, ThatAreEmptyAreRefusedInWords) {
  expect("''", kWrongUsage, "an argument is empty. Leave it out.");
  expect("drill ''", kWrongUsage, "an argument is empty. Leave it out. See hapticut drill --help.");
  expect("drill --radius_mm ''", kWrongUsage, "--radius_mm '': must be a number > 0");
  expect("drill --head ''", kWrongUsage, "--head '': must be one of sphere, cone");
}

TEST_F(Flags, ThatStandElsewhereOrAreIncompleteAreRefusedWithWhatToWrite) {
  expect("", kWrongUsage, "there is no command. Choose drill, ");
  expect("--settings a.toml drill", kWrongUsage,
         "--settings stands before the command. Write hapticut drill --settings");
  expect("--radius_mm 1", kWrongUsage, "--radius_mm stands before the command. Write hapticut COMMAND --radius_mm");
  expect("drill a.toml", kWrongUsage, "a.toml belongs to no flag. If it has settings, write --settings a.toml.");
  expect("drill --json --save a.vdb", kWrongUsage, "--json has no value.");
  expect("drill --json= --save a.vdb", kWrongUsage, "--json has no value.");
  expect("drill --settings", kWrongUsage, "--settings has no value.");
  expect("drill --settings a.toml --settings b.toml", kWrongUsage, "--settings is given 2 times; give it once.");
  expect("drill --settings ''", kWrongUsage, "--settings has no value.");
  expect("inspect a.vdb b.vdb", kWrongUsage, "b.vdb belongs to no flag.");
  expect("inspect", kWrongUsage, "the workpiece is missing. Use: hapticut inspect SOURCE.");
}

// every_setting_test.cpp tests every flag.
TEST_F(Flags, OfTheWrongTypeOrOutOfRangeAreRefused) {
  expect("drill --radius_mm 2mm", kWrongUsage, "--radius_mm 2mm: must be a number > 0");
  expect("drill --spindle_rpm 1e7", kWrongUsage, "must be a number from -1e+06 to 1e+06");
  expect("drill --voxel_mm 100", kWrongUsage, "--voxel_mm 100: must be a number > 0 and <= 20");
  expect("drill --radius_mm 1000", kWrongUsage, "--radius_mm 1000: must be a number > 0 and <= 300");
  expect("drill --handle_length_mm 1e5", kWrongUsage, "--handle_length_mm 1e5: must be a number from 0 to 5000");
  expect("drill " + kBlock + kLine + "--spindle_rpm 1000 --head cone --half_angle_deg 90 --height_mm 1", kFailed,
         "--half_angle_deg is 90 deg; must be less than 90 deg (pi/2)");
  expect("drill --grey bone=1", kWrongUsage, "--grey bone=1: must be MATERIAL=FROM:TO");
  expect("drill --radius_mm", kWrongUsage, "--radius_mm");
  expect("validate --only a --only b", kWrongUsage, "--only is given 2 times; give it once.");
  expect("view --port 1.5", kWrongUsage, "--port 1.5: must be a whole number from 0 to 65535");
}

TEST_F(Flags, ThatAreMissingAreNamed) {
  expect("drill " + kBall + kLine, kFailed, "--workpiece is missing. Set --workpiece to block");
  expect("drill " + kBlock + kLine, kFailed, "--head");
  expect("drill " + kBlock + kBall, kFailed, "--path");
  expect("drill " + kBlock + "--head sphere --radius_mm 1 " + kLine, kFailed, "--spindle_rpm is missing");
  const std::string ball = "--head sphere --radius_mm 1 ";
  expect("drill " + kBlock + ball + "--spindle_rpm 0 --handle ray " + kLine, kFailed,
         "--handle_length_mm is missing; a ray handle needs it");
  expect("drill " + kBlock + ball + "--spindle_rpm 300000 --motor electric " + kLine, kFailed,
         "--spindle_rpm = 300000; must be at most 250000 with the motor electric. Lower the speed, or choose "
         "another --motor");
  expect("drill " + kBlock + ball + "--spindle_rpm 0 --motor electric " + kLine, kFailed,
         "--motor is set; must be left out");
  expect("drill " + kBlock + kBall + "--path line --from_mm 0,0,0 --feed_mm_per_s 1", kFailed, "--to_mm is missing");
  expect("drill " + kBlock + kBall + "--path line --from_mm 0,0,0 --to_mm 1,0,0", kFailed, "feed_mm_per_s is missing");
  expect("drill --workpiece block --material dentin " + kBall + kLine, kFailed, "--size_mm is missing");
  expect("convert block", kWrongUsage, "file to write");
}

TEST_F(Flags, ThatDoNotBelongTogetherAreRefused) {
  expect("drill " + kBlock + kBall + kLine + "--handle_neck_mm 3", kFailed,
         "--handle_neck_mm = 3; must be left out, because a ray handle has none. Leave it out, or choose --handle L.");
  expect("drill " + kBlock + kBall + kLine + "--turns 2", kFailed,
         "--turns = 2; must be left out, because a path of kind line has none. Leave it out, or choose --path circle.");
  expect("drill " + kBlock + "--layer enamel=1 " + kBall + kLine, kFailed,
         "--layer MATERIAL=THICKNESS_MM is set; must be left out, because block");
  expect("drill " + kBlock + kBall + kLine + "--point handle", kFailed, "--point");
}

TEST_F(Flags, NameMaterialsThatExist) {
  expect("drill --workpiece block --size_mm 2,2,2 --material dentine " + kBall + kLine, kFailed,
         "there is no material dentine");
}

TEST_F(Flags, MustNotAskForTheImpossible) {
  expect("drill --workpiece block --size_mm 1e6,1e6,1e6 --voxel_mm 1e-3 --material dentin " + kBall + kLine, kFailed,
         "voxels");
  expect("drill " + kBlock + kBall + "--path line --from_mm 0,0,3 --to_mm 1000,0,3 --feed_mm_per_s 1e-3", kFailed,
         "at most 1e+07");
  expect("drill " + kBlock + kBall + "--path line --from_mm 0,0,3 --to_mm 0,0,3 --feed_mm_per_s 1", kFailed,
         "at least two");
  expect("drill " + kBlock + kBall + kLine + "--tool_axis 0,0,0", kFailed, "--tool_axis");
}

// The depth is 100 m. The program counts the points of the path before it creates one.
TEST_F(SettingsFile, MustNotAskForAnImpossibleDepth) {
  const std::string common = "center_mm = [1, 1, 2]\nfeed_mm_per_s = 20\npitch_mm = 0.5\ndepth_mm = 1e5\n";
  const auto expect_of = [&](const std::string& keys, const std::string& part) {
    write_bytes(folder / "scene.toml", "[path]\n" + common + keys);
    expect_refused("drill --settings " + path("scene.toml") + " " + kBlock + kBall,
                   {"the path would have", "at most 1e+07 are possible. Change --depth_mm", part});
  };
  expect_of("kind = \"cavity\"\ntop_radius_mm = 0.6\nbottom_radius_mm = 0.4\nlayer_mm = 0.2\n",
            ", --layer_mm or --pitch_mm.");
  expect_of("kind = \"spiral\"\nstart_radius_mm = 0.1\nend_radius_mm = 1\n", " or --pitch_mm.");
}

TEST_F(SettingsFile, NamesMaterialsThatExistEvenWhereNothingIsMadeOfThem) {
  const auto expect_of = [this](const std::string& table, const std::string& part) {
    write_bytes(folder / "scene.toml", table);
    expect("drill --settings " + path("scene.toml") + " " + kBlock + kBall + kLine, kFailed, part);
  };
  expect_of("[material.dentine]\ndensity_kg_per_m3 = 2000\n", "there is no material dentine");
  expect_of("[material.soft]\nbased_on = \"dentine\"\n", "there is no material dentine");
}

TEST_F(Flags, NameAFileThatIsNotReadOrWrittenOtherwise) {
  const std::string scene = "[tool]\nhead = \"sphere\"\n";
  write_bytes(folder / "scene.toml", scene);
  std::filesystem::create_symlink(folder / "scene.toml", folder / "link.toml");
  const std::string drill = "drill --settings " + path("scene.toml") + " " + kBlock + kBall + kLine;
  for (const char* output : {"--json ", "--steps_csv ", "--record "})
    for (const char* name : {"scene.toml", "link.toml"})
      expect(drill + output + path(name), kFailed, "the file of --settings. Give it another name.");
  expect(drill + "--record " + path("a.vdb") + " --save " + path("./a.vdb"), kFailed, "the file of --record");
  write_bytes(folder / "a.h5", "");
  expect("replay " + path("a.h5") + " --json " + path("a.h5"), kFailed, "the file of RECORDING");
  EXPECT_EQ(test::read_bytes(folder / "scene.toml"), scene);
}

TEST_F(SettingsFile, NamesTheCommandOfAnotherCommandsKey) {
  const auto expect_of = [this](const std::string& command, const std::string& toml, const std::string& message) {
    write_bytes(folder / "s.toml", toml);
    expect(command + " --settings " + path("s.toml"), kFailed, "hapticut: " + path("s.toml") + message);
  };
  const std::string picture = "[output]\njson = \"a.json\"\npicture = \"a.png\"\n";
  expect_of("loop mock:rest", picture, ":3: loop takes no output.picture; it is a setting of drill. Leave it out.");
  expect_of("convert molar molar.vdb", "[path]\nkind = \"line\"\n",
            ":1: convert takes no [path]; it is a table of drill. Leave it out.");
  expect_of("drill", "[output]\npictur = \"a.png\"\n",
            ":2: output.pictur: there is no such setting. Did you mean output.picture?");
}

TEST_F(SettingsFile, ThatIsWrongOrMissingIsRefused) {
  for (const auto& [toml, part] :
       {std::pair("[tool]\nradius_mm = -1\n", ":2: tool.radius_mm: must be a number > 0 and <= 300, not -1."),
        std::pair("[tool]\nradius_mm = = 3\n", ":2: not valid TOML")}) {
    write_bytes(folder / "s.toml", toml);
    expect("drill --settings " + path("s.toml"), kFailed, "hapticut: " + path("s.toml") + part);
  }
  expect("drill --settings " + path("none.toml"), kFailed, "there is no such settings file");
  expect("drill --settings /", kFailed, "it is a folder; name the settings file in it.");
}

TEST_F(Files, ThatAreMissingOrOfNoKnownKindAreRefused) {
  expect("inspect " + path("none.vdb"), kFailed, "there is no file");
  expect("inspect blokc", kFailed, "Did you mean block?");
  write_bytes(folder / "notes.docx", "hello");
  expect("inspect " + path("notes.docx"), kFailed, "notes.docx");
}

TEST_F(Files, ThatCannotBeReachedSayWhy) {
  const std::string too_long = path(std::string(300, 'a'));
  for (const std::string end : {".vdb", ".stl", ".nrrd", ".toml", ".h5"}) {
    std::filesystem::create_symlink("loop" + end, folder / ("loop" + end));
    const std::string command = end == ".toml" ? "drill --settings " : end == ".h5" ? "replay " : "inspect ";
    expect(command + path("loop" + end), kFailed, "it is a symbolic link that leads back to itself");
    expect(command + too_long + end, kFailed, "File name too long.");
  }
}

#ifdef HAPTICUT_HAS_ITK
TEST_F(Files, OfSamplesNeedTheMeaningOfTheirValues) {
  std::string volume = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 4 4 4\nspacings: 1 1 1\nencoding: raw\n\n";
  write_bytes(folder / "v.nrrd", volume + std::string(64, '\1'));
  const std::string source = "drill --workpiece " + path("v.nrrd") + " " + kBall + kLine;
  expect(source, kFailed, "0 of them are set. Set --label, --grey or --grade_low.");
  expect(source + "--label dentin=1 --grey dentin=1:", kFailed, "2 of them are set");
  expect(source + "--grade_low 1", kFailed, "a grade needs all of");
  expect(source + "--label dentin=2", kFailed, "leave them out with --unclaimed_labels leave_out.");
  expect(source + "--grey dentin=1: --unclaimed_labels leave_out", kFailed, "needs labels");
  expect(source + "--grey dentin=5:3", kFailed, "`from` must be less than `to`");
  expect(source + "--grade_low 5 --grade_high 3 --grade_at_low dentin --grade_at_high enamel", kFailed, "`low`");
  const ProgramOutcome large = test::run_program(folder, source + "--label dentin=1 --voxel_mm 1e-3");
  EXPECT_NE(large.errors.find("lift the limit (--large)."), std::string::npos) << large.errors;
  std::filesystem::create_directory(folder / "slices");
  write_bytes(folder / "slices/s1.png", "");
  expect("inspect " + path("slices"), kFailed, "set --spacing_mm");
  expect(source + "--grey dentin=1: --crop_mm 0,0,0,1,1,-1", kFailed, "--crop_mm");
  expect(source + "--grey dentin=1: --crop_mm 50,50,50,60,60,60", kFailed, "lies outside the volume");
  expect("inspect block --size_mm 1,1,1 --material dentin --threshold 3", kFailed, "--threshold");
}
#endif

TEST_F(Files, ThatAreRandomAreRefused) {
  std::mt19937 random(7);
  std::string noise(4096, '\0');
  for (char& c : noise) c = char(random());
  for (const char* name : {"noise.vdb", "noise.nrrd", "noise.inv3", "noise.dcm", "noise.xyz"}) {
    write_bytes(folder / name, noise);
    expect("inspect " + path(name), kFailed, name);
  }
  write_bytes(folder / "noise.toml", noise);
  expect("drill --settings " + path("noise.toml"), kFailed, "not valid TOML");
}

TEST_F(Files, ThatCannotBeWrittenAreRefusedBeforeTheWork) {
  write_bytes(folder / "file", "");
  const std::string nowhere = path("file/no/folder/x.json");
  expect("inspect molar --json " + nowhere, kFailed, "cannot write");
  for (const char* flag : {"--json", "--markdown", "--measurements"})
    expect(std::string("validate ") + flag + " " + nowhere, kFailed, "cannot write");
  expect("stability --json " + nowhere, kFailed, "cannot write");
  expect("calibrate tests.csv --json " + nowhere, kFailed, "cannot write");
  expect("convert molar " + path("x.doc"), kWrongUsage, "extension must be");
  for (const char* flag : {"--json", "--save", "--steps_csv"})
    expect("drill " + kBlock + kBall + kLine + flag + " " + path("file/no/folder/x.vdb"), kFailed, "cannot write");
  expect("drill " + kBlock + kBall + kLine + "--json " + path(""), kFailed, "cannot write");
  expect("drill " + kBlock + kBall + kLine + "--save " + path("x.doc"), kWrongUsage, "extension must be");
  if (::geteuid() != 0) {  // root may write everywhere
    std::filesystem::create_directory(folder / "closed");
    std::filesystem::permissions(folder / "closed", std::filesystem::perms::owner_read);
    expect("drill " + kBlock + kBall + kLine + "--json " + path("closed/x.json"), kFailed, "cannot write");
    std::filesystem::permissions(folder / "closed", std::filesystem::perms::owner_all);
  }
}

// A real file system without a free byte: every kind of output keeps the old file, leaves no other file, and reports
// the reason.
TEST_F(Files, OnAFullDiskStayWhatTheyWere) {
  if (std::system("unshare -rm mount -t tmpfs none /tmp 2>/dev/null") != 0)
    GTEST_SKIP() << "this user may not mount a small disk of its own";
  std::vector<std::string> outputs = {"--json x.json", "--steps_csv x.csv", "--save x.vdb"};
#ifdef HAPTICUT_HAS_IMPORT
  for (const char* more : {"--save x.nrrd", "--surface x.stl", "--surface x.ply", "--picture x.png", "--record x.h5"})
    outputs.emplace_back(more);
#endif
  std::filesystem::create_directory(folder / "disk");
  for (const std::string& output : outputs) {
    const std::string name = output.substr(output.find(' ') + 1);
    const std::string script = "mount -t tmpfs -o size=32k none " + path("disk") + " && cd " + path("disk") +
                               " && printf old >" + name + std::string(" && cat /dev/zero >filler 2>/dev/null; ") +
                               test::kProgram + " drill " + kBlock + kBall + kLine + output + " >" + path("stdout") +
                               "; printf \"%s \" $? $(cat " + name + ") $(ls -A)";
    write_bytes(folder / "script", script);
    const std::string command = "unshare -rm sh " + path("script") + " >" + path("result") + " 2>" + path("stderr");
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(test::read_bytes(folder / "result"), "1 old filler " + name + " ") << output;
    const std::string errors = test::read_bytes(folder / "stderr");
    EXPECT_TRUE(errors.starts_with("hapticut: ")) << output << errors;
    EXPECT_EQ(errors.find('\n'), errors.size() - 1) << errors;
    EXPECT_NE(errors.find("space"), std::string::npos) << output << errors;
  }
}

TEST_F(Files, ThatAreDevicesAreNotWrittenTo) {
  std::filesystem::create_symlink("/dev/full", folder / "x.vdb");
  std::filesystem::create_symlink("/dev/full", folder / "x.png");
  std::filesystem::create_symlink("/dev/full", folder / "x.stl");
  expect("drill " + kBlock + kBall + kLine + "--json /dev/full", kFailed, "not a regular file");
  expect("drill " + kBlock + kBall + kLine + "--save " + path("x.vdb"), kFailed, "not a regular file");
  expect("convert block " + path("x.vdb") + " --size_mm 1,1,1 --material dentin", kFailed, "not a regular file");
#ifdef HAPTICUT_HAS_IMPORT
  expect("drill " + kBlock + kBall + kLine + "--picture " + path("x.png"), kFailed, "not a regular file");
  expect("drill " + kBlock + kBall + kLine + "--surface " + path("x.stl"), kFailed, "not a regular file");
#endif
}

TEST_F(Files, AreNotLeftHalfWritten) {
  // On a full disk (no file may grow beyond a kilobyte): the old report stays, and no temporary file is left.
  write_bytes(folder / "report.json", "old");
  const std::string command = "drill " + kBlock + kBall + kLine + "--json " + path("report.json");
  const std::string limited = std::string("sh -c 'ulimit -f 1; trap \"\" XFSZ; exec ") + test::kProgram + " " +
                              command + "' >" + path("stdout") + " 2>" + path("stderr");
  EXPECT_NE(std::system(limited.c_str()), 0);
  EXPECT_EQ(test::read_bytes(folder / "report.json"), "old");
  EXPECT_EQ(folder.file_count(), 3U);
  EXPECT_NE(test::read_bytes(folder / "stderr").find("report.json"), std::string::npos);
}

}  // namespace
}  // namespace hapticut::cli_errors_test
