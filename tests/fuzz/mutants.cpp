// SPDX-License-Identifier: Apache-2.0
// Reads many damaged files: hapticut_mutants COUNT [SEED [FOLDER_OF_FINDINGS [MORE_SEEDS...]]]. Each mutant is a valid
// file with some changed bytes. It must be read, or refused by one sentence that names it, within 20 s and 4 GB. The
// valid files are read first. MORE_SEEDS are files, read by their extension. The last line counts the findings. Exit
// code: 0 without findings, 1 with findings or when a valid file is not read, 2 when the extension of one of MORE_SEEDS
// is unknown.
#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <stdexcept>

#include "fuzz/readers.hpp"
#include "fuzz/seeds.hpp"

namespace hapticut::test {
namespace {

namespace fs = std::filesystem;

constexpr unsigned kMaxSeconds = 20;             // [s] time for a mutant
constexpr rlim_t kMaxMemory = rlim_t(4) << 30U;  // [bytes]

struct MutantSeed {
  std::string format;
  fs::path path;
  std::string bytes;
};

/// State that a worker shares.
struct Shared {
  std::uint64_t index;
  std::uint64_t read, refused;
  char format[16];  ///< format of the current mutant; shared memory, because a file would wait for the disk
};

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  std::size_t below(std::size_t end) { return end == 0 ? 0 : std::size_t(random_() % end); }

  std::string mutant_of(std::string bytes, const std::string& other) {
    for (std::size_t n = 1 + below(below(4) == 0 ? 16 : 3); n > 0; --n) change(bytes, other);
    return bytes;
  }

 private:
  void change(std::string& bytes, const std::string& other) {
    const std::size_t at = below(bytes.size()), length = 1 + below(below(2) == 0 ? 8 : 200);
    switch (below(9)) {
      case 0:
        if (!bytes.empty()) bytes[at] = char(bytes[at] ^ (1 << below(8)));
        break;
      case 1:
        if (!bytes.empty()) bytes[at] = char(random_());
        break;
      case 2:
        bytes.insert(at, length, char(random_()));
        break;
      case 3:
        bytes.erase(at, length);
        break;
      case 4:
        bytes.insert(at, bytes.substr(below(bytes.size()), length));
        break;
      case 5:
        bytes.resize(at);
        break;
      case 6:
        if (!other.empty()) bytes.replace(at, length, other.substr(below(other.size()), length));
        break;
      case 7:
        put_number(bytes, at);
        break;
      default:
        change_text_number(bytes, at);
    }
  }

  /// A number, often a limit value, in 1, 2, 4 or 8 bytes of either order.
  void put_number(std::string& bytes, std::size_t at) {
    constexpr std::uint64_t kEdges[] = {0,
                                        1,
                                        0x7f,
                                        0x80,
                                        0xff,
                                        0x7fff,
                                        0xffff,
                                        0x7fffffff,
                                        0x80000000,
                                        0xffffffff,
                                        0x7ff0000000000000,
                                        0x7ff8000000000000,
                                        0x7e37e43c8800759c,
                                        1U << 20U,
                                        ~0ULL};
    std::string number = little(kEdges[below(std::size(kEdges))]).substr(0, std::size_t(1) << below(4));
    if (below(2) == 0) number = {number.rbegin(), number.rend()};
    if (at + number.size() <= bytes.size()) bytes.replace(at, number.size(), number);
  }

  void change_text_number(std::string& bytes, std::size_t at) {
    constexpr const char* kNumbers[] = {"0",      "-1",    "1e308", "-1e308",     "nan", "inf", "99999999999999999999",
                                        "1e-320", "65535", "65536", "4294967296", "-0",  "1e5", "2147483647"};
    const std::size_t first = bytes.find_first_of("0123456789", at);
    if (first == std::string::npos) return;
    const std::size_t last = std::min(bytes.find_first_not_of("0123456789.eE+-", first), bytes.size());
    bytes.replace(first, last - first, kNumbers[below(std::size(kNumbers))]);
  }

  std::mt19937_64 random_;
};

/// @return the fault of a refusal; empty when it is correct
std::string fault_of(const std::string& sentence, const fs::path& file) {
  if (sentence.find('\n') != std::string::npos) return "more than one line";
  if (sentence.find(file.filename().string()) == std::string::npos &&
      sentence.find(file.parent_path().filename().string()) == std::string::npos)
    return "does not name the file";
  if (sentence.find("ITK") != std::string::npos) return "names a library";
  return "";
}

/// Writes a file, and next to it the unchanged slice that is read with it.
fs::path write_file(const MutantSeed& seed, const std::string& bytes, const fs::path& folder) {
  fs::path path = folder / seed.path.filename();
  write_bytes(path, bytes);
  if (seed.format == "slices") write_bytes(folder / ("a2" + path.extension().string()), seed.bytes);
  constexpr std::string_view kPlace = "\\20\\0.7", kNext = "\\20\\1.4";  // position of the slice in the project's seeds
  if (const std::size_t at = seed.bytes.find(kPlace); seed.format == "dicom" && at != std::string::npos)
    write_bytes(folder / "companion2.dcm", std::string(seed.bytes).replace(at, kPlace.size(), kNext));
  return path;
}

void make_empty(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) fs::remove(entry.path());
}

/// Reads one mutant. Its number determines the seed and the changes.
void read_mutant(const std::vector<MutantSeed>& seeds, std::uint64_t seed, std::uint64_t index, const fs::path& folder,
                 Shared& shared) {
  Mutator mutator(seed * 1'000'003 + index);
  const MutantSeed& chosen = seeds[mutator.below(seeds.size())];
  const std::string bytes = mutator.mutant_of(chosen.bytes, seeds[mutator.below(seeds.size())].bytes);
  const fs::path path = write_file(chosen, bytes, folder);
  shared.format[chosen.format.copy(shared.format, sizeof shared.format - 1)] = '\0';
  std::string fault;
  try {
    read_as(chosen.format, path);
    ++shared.read;
  } catch (const Error& error) {
    ++shared.refused;
    fault = fault_of(error.what(), path);
    if (!fault.empty()) fault += ": " + std::string(error.what());
  } catch (const std::exception& error) {
    fault = std::string("not hapticut::Error: ") + error.what();
  }
  if (!fault.empty()) {
    std::printf("mutant %llu of %s: %s\n", static_cast<unsigned long long>(index), chosen.path.filename().c_str(),
                fault.c_str());
    std::fflush(stdout);
    ::_exit(3);
  }
  make_empty(folder);
}

/// Shared memory of the processes.
Shared& shared_in(const fs::path& file) {
  const int handle = ::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
  if (handle < 0 || ::ftruncate(handle, sizeof(Shared)) != 0) throw std::runtime_error("no shared file");
  void* memory = ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED, handle, 0);
  ::close(handle);
  return *static_cast<Shared*>(memory);
}

std::vector<MutantSeed> seeds_in(const fs::path& folder) {
  std::vector<MutantSeed> seeds;
  for (const char* format : kFormats) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder / format)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) seeds.push_back({format, file, read_bytes(file)});
  }
  return seeds;
}

/// Runs this program again: a fork would lose the threads that libraries have started.
/// @return its exit status
int run_again(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "hapticut_mutants");
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  pid_t process = 0;
  if (::posix_spawn(&process, "/proc/self/exe", nullptr, nullptr, pointers.data(), environ) != 0) return -1;
  int status = 0;
  ::waitpid(process, &status, 0);
  return status;
}

/// Limits the memory of this process and redirects its stderr to a file.
void begin_reading(const fs::path& folder) {
  const rlimit memory = {kMaxMemory, kMaxMemory};
  ::setrlimit(RLIMIT_AS, &memory);
  const int errors = ::open((folder / "stderr").c_str(), O_CREAT | O_WRONLY | O_APPEND, 0600);
  ::dup2(errors, STDERR_FILENO);
}

/// Reads each unchanged seed: if a seed is refused, its mutants test nothing.
/// @return exit code
int read_seeds(const fs::path& folder) {
  begin_reading(folder);
  int refused = 0;
  for (const MutantSeed& seed : seeds_in(folder / "seeds")) {
    ::alarm(kMaxSeconds);
    const fs::path path = write_file(seed, seed.bytes, folder / "work");
    try {
      read_as(seed.format, path);
    } catch (const std::exception& error) {
      ++refused;
      std::printf("seed %s of %s: %s\n", seed.path.filename().c_str(), seed.format.c_str(), error.what());
      std::fflush(stdout);
    }
    make_empty(folder / "work");
  }
  return refused == 0 ? 0 : 1;
}

int work(const fs::path& folder, std::uint64_t count, std::uint64_t seed) {
  begin_reading(folder);
  Shared& shared = shared_in(folder / "shared");
  const std::vector<MutantSeed> seeds = seeds_in(folder / "seeds");
  while (shared.index < count) {
    ::alarm(kMaxSeconds);
    read_mutant(seeds, seed, shared.index, folder / "work", shared);
    ++shared.index;
  }
  return 0;  // a normal exit, so exit functions of libraries run
}

/// Adds further seed files.
/// @return false, with a message, when the extension of a file is unknown
bool copy_seeds(const std::vector<fs::path>& files, const fs::path& seeds) {
  static constexpr std::pair<std::string_view, const char*> kExtensions[] = {
      {".nrrd", "nrrd"}, {".nii", "nifti"},    {".gz", "nifti"},     {".mha", "meta"}, {".dcm", "dicom"},
      {".inv3", "inv3"}, {".stl", "stl"},      {".ply", "ply"},      {".obj", "obj"},  {".off", "off"},
      {".vdb", "vdb"},   {".h5", "recording"}, {".toml", "settings"}};
  for (const fs::path& file : files) {
    const char* const* format = found_in(kExtensions, extension_in_lower_case(file));
    if (format == nullptr) {
      std::fprintf(stderr, "%s: its extension is unknown; seeds must end in", file.c_str());
      for (const auto& [extension, name] : kExtensions) std::fprintf(stderr, " %s", std::string(extension).c_str());
      std::fputs(".\n", stderr);
      return false;
    }
    fs::copy_file(file, seeds / *format / file.filename());
  }
  return true;
}

int run(int argc, char** argv) {
  const std::uint64_t count = std::strtoull(argv[1], nullptr, 10),
                      seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const TemporaryFolder folder;
  fs::create_directories(folder / "seeds");
  fs::create_directories(folder / "work");
  const std::string root = (folder / "").string();
  if (run_again({"--seeds", (folder / "seeds").string()}) != 0) throw std::runtime_error("the seeds cannot be written");
  if (!copy_seeds({argv + std::min(argc, 4), argv + argc}, folder / "seeds")) return 2;
  if (const int status = run_again({"--unchanged", root}); status != 0) {
    std::printf("not every unchanged seed is read (%s %d)\n", WIFSIGNALED(status) ? "signal" : "exit code",
                WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status));
    return 1;
  }
  const std::size_t seed_count = seeds_in(folder / "seeds").size();
  Shared& shared = shared_in(folder / "shared");
  int findings = 0;
  while (shared.index < count) {
    const int status = run_again({"--work", root, std::to_string(count), std::to_string(seed)});
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) break;
    ++findings;
    if (WIFSIGNALED(status))
      std::printf("mutant %llu (%s): signal %d\n", static_cast<unsigned long long>(shared.index), shared.format,
                  WTERMSIG(status));
    std::fflush(stdout);
    if (argc > 3) {
      const fs::path kept = fs::path(argv[3]) / std::to_string(shared.index);
      fs::create_directories(kept);
      fs::copy(folder / "work", kept, fs::copy_options::overwrite_existing);
    }
    make_empty(folder / "work");
    ++shared.index;
  }
  const std::string printed = read_bytes(folder / "stderr");
  if (!printed.empty()) {
    ++findings;
    std::printf("printed on stderr: %s\n", printed.substr(0, 500).c_str());
  }
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  std::printf("%llu mutants of %zu files: %llu read, %llu refused, at most %ld MB, %d findings\n",
              static_cast<unsigned long long>(count), seed_count, static_cast<unsigned long long>(shared.read),
              static_cast<unsigned long long>(shared.refused), usage.ru_maxrss / 1024, findings);
  return findings == 0 ? 0 : 1;
}

}  // namespace
}  // namespace hapticut::test

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("hapticut_mutants COUNT [SEED [FOLDER_OF_FINDINGS [MORE_SEEDS...]]]\n", stderr);
    return 2;
  }
  const std::string mode = argv[1];
  if (mode == "--seeds") return hapticut::test::write_seeds(argv[2]), 0;
  if (mode == "--unchanged") return hapticut::test::read_seeds(argv[2]);
  if (mode == "--work")
    return hapticut::test::work(argv[2], std::strtoull(argv[3], nullptr, 10), std::strtoull(argv[4], nullptr, 10));
  return hapticut::test::run(argc, argv);
}
