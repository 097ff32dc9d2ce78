// SPDX-License-Identifier: Apache-2.0
#include "settings/profile_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "hapticut/core/units.hpp"
#include "settings/csv_file.hpp"
#include "settings/setting.hpp"
#ifdef HAPTICUT_HAS_IO
#include "hapticut/io/mesh/meshes.hpp"
#include "hapticut/tool/profile_mesh.hpp"
#endif

namespace hapticut::settings {
namespace {

class ProfileFile {
 public:
  explicit ProfileFile(CsvFile lines) : lines_(std::move(lines)) {}

  Profile read() {
    std::vector<std::string> cells;
    if (!lines_.next(cells)) fail("the file is empty; its first line must name the columns rho_mm, z_mm ...");
    lines_.require_names_once(cells);
    read_names(cells);
    Profile profile;
    std::size_t points = 0;
    for (; lines_.next(cells); ++points) {
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
  [[noreturn]] void fail(const std::string& message) const { lines_.fail(message); }

  void read_names(const std::vector<std::string>& names) {
    const std::vector<std::string> known = {"rho_mm", "z_mm", "radius_mm", "kind"};
    for (std::size_t n = 0; n < names.size(); ++n) {
      if (names[n].empty()) continue;  // a column that a spreadsheet added
      const auto place = std::find(known.begin(), known.end(), names[n]);
      if (place == known.end())
        fail("there is no column " + names[n] + "; must be one of rho_mm, z_mm, radius_mm, kind." +
             suggestion(names[n], known));
      place_[std::size_t(place - known.begin())] = n;
    }
    if (!place_[0] || !place_[1]) fail("the columns rho_mm and z_mm must be there.");
  }

  double length(const std::string& cell) {
    const std::optional<double> value = lines_.number(cell);
    if (!value || !std::isfinite(*value)) fail("'" + cell + "' is not a number.");
    return *value * units::mm;
  }

  ProfileEdge read_edge(const std::vector<std::string>& cells) {
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

  CsvFile lines_;
  std::array<std::optional<std::size_t>, 4> place_ = {};
};

Profile profile_in(const std::filesystem::path& path) {
  if (path.extension() == ".csv") return ProfileFile(CsvFile(path, "profile", "--profile")).read();
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

Profile with_tip_at_zero(Profile profile) {
  for (ProfileEdge& e : profile.edges) e.z -= profile.tip;
  profile.tip = 0;
  return profile;
}

}  // namespace

Profile read_profile(const std::filesystem::path& path) { return with_tip_at_zero(profile_in(path)); }

Profile profile_of_text(std::string text, std::string name) {
  return with_tip_at_zero(ProfileFile(CsvFile(std::move(text), std::move(name))).read());
}

}  // namespace hapticut::settings
