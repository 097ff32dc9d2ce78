// SPDX-License-Identifier: Apache-2.0
#include "cli/profile_file.hpp"

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>

#include "cli/setting.hpp"
#include "hapticut/core/units.hpp"
#ifdef HAPTICUT_HAS_IO
#include "hapticut/io/meshes.hpp"
#include "hapticut/tool/profile_mesh.hpp"
#endif

namespace hapticut::cli {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

class ProfileFile {
 public:
  explicit ProfileFile(const std::filesystem::path& path) : name_(path.string()), stream_(path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error) || !stream_)
      throw Error(name_ + ": this profile cannot be read. Check the name given to --profile.");
  }

  Profile read() {
    std::vector<std::string> cells;
    if (!next_line(cells)) fail("the file is empty; its first line must name the columns rho_mm, z_mm ...");
    read_names(cells);
    Profile profile;
    std::size_t points = 0;
    for (; next_line(cells); ++points) {
      if (cells.size() != columns_)
        fail(std::to_string(cells.size()) + " values; there must be " + std::to_string(columns_) +
             ", as in the first line.");
      const ProfileEdge edge = read_edge(cells);
      if (points > 0) {
        profile.edges.push_back(edge);
        continue;
      }
      if (edge.rho != 0)
        fail("rho_mm = " + format_number(edge.rho / units::mm) + "; the first point is the tip, at 0.");
      profile.tip = edge.z;
    }
    return profile;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw Error(name_ + ":" + std::to_string(line_) + ": " + message);
  }

  bool next_line(std::vector<std::string>& cells) {
    for (std::string line; std::getline(stream_, line);) {
      ++line_;
      line = trimmed(line);
      if (line.empty() || line.front() == '#') continue;
      cells = split(line, ',');
      std::transform(cells.begin(), cells.end(), cells.begin(), trimmed);
      return true;
    }
    return false;
  }

  void read_names(const std::vector<std::string>& names) {
    columns_ = names.size();
    const std::vector<std::string> known = {"rho_mm", "z_mm", "radius_mm", "kind"};
    for (std::size_t n = 0; n < names.size(); ++n) {
      const auto place = std::find(known.begin(), known.end(), names[n]);
      if (place == known.end())
        fail("there is no column " + names[n] + "; must be one of rho_mm, z_mm, radius_mm, kind." +
             suggestion(names[n], known));
      place_[std::size_t(place - known.begin())] = n;
    }
    if (!place_[0] || !place_[1]) fail("the columns rho_mm and z_mm must be there.");
  }

  double length(const std::string& cell) const {
    const std::optional<double> value = parse_number(cell);
    if (!value) fail("'" + cell + "' is not a number.");
    return *value * units::mm;
  }

  ProfileEdge read_edge(const std::vector<std::string>& cells) const {
    ProfileEdge edge;
    edge.rho = length(cells[*place_[0]]);
    edge.z = length(cells[*place_[1]]);
    if (place_[2]) edge.radius = length(cells[*place_[2]]);
    if (!place_[3]) return edge;
    const std::string& kind = cells[*place_[3]];
    if (kind != "cutting" && kind != "smooth") fail("kind = " + kind + "; must be cutting or smooth.");
    edge.kind = kind == "cutting" ? EdgeKind::cutting : EdgeKind::smooth;
    return edge;
  }

  std::string name_;
  std::ifstream stream_;
  int line_ = 0;
  std::size_t columns_ = 0;
  std::array<std::optional<std::size_t>, 4> place_ = {};
};

Profile profile_in(const std::filesystem::path& path) {
  if (path.extension() == ".csv") return ProfileFile(path).read();
#ifdef HAPTICUT_HAS_IO
  const std::vector<NamedMesh> objects = read_mesh(path);
  if (objects.size() != 1)
    throw Error(path.string() + ": there are " + std::to_string(objects.size()) +
                " objects; a head is one. Keep the one that cuts.");
  return profile_from_mesh(objects.front().mesh).profile;
#else
  throw Error(
      path.string() +
      ": only profiles in CSV files can be read; this program was built without the component io, which reads meshes.");
#endif
}

}  // namespace

Profile read_profile(const std::filesystem::path& path) {
  Profile profile = profile_in(path);
  for (ProfileEdge& e : profile.edges) e.z -= profile.tip;
  profile.tip = 0;
  return profile;
}

}  // namespace hapticut::cli
