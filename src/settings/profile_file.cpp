// SPDX-License-Identifier: Apache-2.0
#include "settings/profile_file.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "hapticut/core/units.hpp"
#include "io/file_errors.hpp"
#include "settings/csv_file.hpp"
#include "settings/setting.hpp"
#ifdef HAPTICUT_HAS_IMPORT
#include "hapticut/import/mesh/meshes.hpp"
#include "hapticut/import/mesh/profile_from_mesh.hpp"
#endif

namespace hapticut::settings {
namespace {

class ProfileFile {
 public:
  explicit ProfileFile(CsvFile lines) : lines_(std::move(lines)) {}

  Profile read() {
    std::vector<std::string> cells;
    (void)lines_.read_names("name the columns rho_mm, z_mm ...");
    lines_.require_known({"rho_mm", "z_mm", "radius_mm", "kind"});
    if (!lines_.column("rho_mm") || !lines_.column("z_mm")) fail("the file needs the columns rho_mm and z_mm.");
    Profile profile;
    std::size_t points = 0;
    for (; lines_.next(cells); ++points) {
      const ProfileEdge edge = read_edge(cells);
      if (points > 0) {
        profile.edges.push_back(edge);
        continue;
      }
      if (edge.rho != 0)
        fail("rho_mm = " + format_number(edge.rho / units::mm) + "; must be 0, because the first point is the tip.");
      profile.tip = edge.z;
    }
    return profile;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { lines_.fail(message); }

  ProfileEdge read_edge(const std::vector<std::string>& cells) {
    ProfileEdge edge;
    for (const auto& [name, length] :
         {std::pair("rho_mm", &edge.rho), std::pair("z_mm", &edge.z), std::pair("radius_mm", &edge.radius)})
      if (const std::optional<std::size_t> column = lines_.column(name))
        *length = lines_.number_at(cells, *column) * units::mm;
    const std::optional<std::size_t> column = lines_.column("kind");
    if (!column) return edge;
    const std::string& kind = cells[*column];
    if (kind != "cutting" && kind != "smooth") fail("kind = " + kind + "; must be cutting or smooth.");
    edge.kind = kind == "cutting" ? EdgeKind::cutting : EdgeKind::smooth;
    return edge;
  }

  CsvFile lines_;
};

Profile profile_in(const std::filesystem::path& path) {
  if (path.extension() == ".csv") return ProfileFile(CsvFile(path, "profile", "tool.profile"_name)).read();
#ifdef HAPTICUT_HAS_IMPORT
  const std::vector<NamedMesh> objects = read_mesh(path);
  if (objects.size() != 1)
    throw FileError(path.string() + ": there are " + std::to_string(objects.size()) +
                    " objects; a head is one object. Keep the one that cuts.");
  return profile_from_mesh(objects.front().mesh).profile;
#else
  throw FileError(path.string() +
                  ": only profiles in CSV files can be read; this program was built without the component import, "
                  "which reads meshes.");
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
