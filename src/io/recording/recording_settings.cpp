// SPDX-License-Identifier: Apache-2.0
#include "io/recording/recording_settings.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "hapticut/force/laws/foundation.hpp"
#include "io/recording/settings_archive.hpp"

namespace hapticut {
namespace {

/// Fields stored separately: the law cannot be stored, only `law_is_default`; the effects are a table of their changes.
using StoredApart = Except<std::shared_ptr<const ForceLaw>, std::optional<DryFriction>, Effects>;

// --- heads and handles ----------------------------------------------------------------------------------------------

constexpr std::pair<const char*, double ProfileEdge::*> kEdges[] = {
    {"profile_rho", &ProfileEdge::rho}, {"profile_z", &ProfileEdge::z}, {"profile_radius", &ProfileEdge::radius}};

/// A shape with dimensions. What is not a number has the shape in its name: "flat_rule".
template <class Archive, class Shape>
void visit_shape(Archive& archive, Shape& shape) {
  for_each_field<std::remove_const_t<Shape>>([&](const auto& field) {
    constexpr bool kNumber = kIsNumber<typename std::remove_cvref_t<decltype(field)>::Type>;
    visit_value(archive, (kNumber ? "" : std::string(Shape::kWord) + "_") + field.name, field.unit,
                shape.*field.member);
  });
}

void visit_shape(SettingsWriter& write, const ProfileHead& head) {
  const std::vector<ProfileEdge>& edges = head.profile().edges;
  std::vector<double> numbers(edges.size());
  write("profile_tip", "m", head.profile().tip);
  for (const auto& [name, member] : kEdges) {
    std::transform(edges.begin(), edges.end(), numbers.begin(), [at = member](const auto& edge) { return edge.*at; });
    write(name, "m", numbers);
  }
  std::transform(edges.begin(), edges.end(), numbers.begin(),
                 [](const ProfileEdge& edge) { return edge.kind == EdgeKind::cutting ? 1 : 0; });
  write("profile_cutting", "1", numbers);
  write("profile_tolerance", "1", head.tolerance());
}

void write_head(SettingsWriter& write, const ToolHead& head) {
  head.visit([&]<class Shape>(const Shape& shape) {
    write("head", std::string(Shape::kWord));
    visit_shape(write, shape);
  });
}

template <Described Shape>
ToolHead read_shape(SettingsReader& read, Of<Shape>) {
  Shape shape{};
  visit_shape(read, shape);
  return shape;
}

ToolHead read_shape(SettingsReader& read, Of<ProfileHead>) {
  Profile profile;
  double tolerance = 0;
  std::vector<double> numbers, cutting;
  read("profile_tip", "m", profile.tip);
  read("profile_cutting", "1", cutting);
  for (const double cuts : cutting) profile.edges.push_back({.kind = cuts != 0 ? EdgeKind::cutting : EdgeKind::smooth});
  for (const auto& [name, member] : kEdges) {
    numbers.clear();
    read(name, "m", numbers);
    if (numbers.size() != cutting.size()) throw Error("the columns of its 'tool/profile_...' differ in length.");
    for (std::size_t n = 0; n < numbers.size(); ++n) profile.edges[n].*member = numbers[n];
  }
  read("profile_tolerance", "1", tolerance);
  return ProfileHead(std::move(profile), tolerance);
}

ToolHead read_head(SettingsReader& read) {
  std::string kind, words;
  read("head", kind);
  std::optional<ToolHead> head;
  for_each_shape([&]<class Shape>(Of<Shape> shape) {
    if (kind == Shape::kWord) head = read_shape(read, shape);
    words += (words.empty() ? "" : ", ") + std::string(Shape::kWord);
  });
  if (!head) throw Error("its 'tool/head' is \"" + kind + "\", but must be one of " + words + ".");
  return *std::move(head);
}

void write_handle(SettingsWriter& write, const Handle& handle) {
  write("handle", std::string(std::holds_alternative<RayHandle>(handle) ? "ray" : "L"));
  std::visit([&](const auto& any) { visit_fields(write, "handle_", any); }, handle);
}

Handle read_handle(SettingsReader& read) {
  std::string kind;
  read("handle", kind);
  if (kind != "ray" && kind != "L") throw Error("its 'tool/handle' is \"" + kind + "\", but must be one of ray, L.");
  Handle handle = kind == "ray" ? Handle(RayHandle{0}) : Handle(LHandle{});
  std::visit([&](auto& any) { visit_fields(read, "handle_", any); }, handle);
  return handle;
}

}  // namespace

void write_settings(hid_t file, const SimulationConfig& config, const Tool& tool, const MaterialTable& materials) {
  {
    const hdf5::Group group = hdf5::create_group(file, "simulation");
    SettingsWriter write(group.get());
    visit_fields(write, "", config, StoredApart{});
    write("law_is_default", config.law->is_foundation());
    write("friction_is_given", config.friction.has_value());
    if (config.friction) visit_fields(write, "", *config.friction);
    write.close();
  }
  {
    const hdf5::Group group = hdf5::create_group(file, "tool");
    SettingsWriter write(group.get());
    write_head(write, tool.head());
    write_handle(write, tool.handle());
    visit_fields(write, "spindle_", tool.spindle());
    visit_fields(write, "cutter_", tool.cutter());
    write.close();
  }
  const hdf5::Group group = hdf5::create_group(file, "materials");
  SettingsWriter write(group.get());
  write("count", std::size_t(materials.size()));
  int id = 0;
  for (const Material& material : materials.all()) {
    const std::string number = std::to_string(++id);
    write(("name_" + number).c_str(), material.name);
    write(("cutter_" + number).c_str(), material.cutter);
  }
  for_each_number<Material>([&](const auto& field) {
    std::vector<double> values;
    for (const Material& material : materials.all()) values.push_back(material.*field.member);
    write(field.name, field.unit, values);
  });
  write.close();
}

SimulationConfig read_config(RecordingSource& source) {
  SettingsReader read = settings_of(source, "simulation");
  SimulationConfig config;
  visit_fields(read, "", config, StoredApart{});
  bool friction_is_given = false, law_is_default = false;
  read("friction_is_given", friction_is_given);
  if (friction_is_given) visit_fields(read, "", config.friction.emplace());
  read("law_is_default", law_is_default);  // for `read_default_law`
  read.close();
  return config;
}

bool read_default_law(RecordingSource& source) {
  bool law_is_default = false;
  settings_of(source, "simulation")("law_is_default", law_is_default);
  return law_is_default;
}

Tool read_tool(RecordingSource& source) {
  SettingsReader read = settings_of(source, "tool");
  Spindle spindle;
  visit_fields(read, "spindle_", spindle);
  Cutter cutter;
  visit_fields(read, "cutter_", cutter);
  ToolHead head = read_head(read);
  const Handle handle = read_handle(read);
  read.close();
  return Tool(std::move(head), handle, spindle, cutter);
}

MaterialTable read_materials(RecordingSource& source) {
  SettingsReader read = settings_of(source, "materials");
  std::size_t count = 0;
  read("count", count);
  if (count < 1 || count > std::size_t(kMaxMaterials))
    throw Error("its 'materials/count' is " + std::to_string(count) + ", but must be 1 to 255.");
  std::vector<Material> materials(count);
  for (std::size_t id = 1; id <= count; ++id) {
    read(("name_" + std::to_string(id)).c_str(), materials[id - 1].name);
    read(("cutter_" + std::to_string(id)).c_str(), materials[id - 1].cutter);
  }
  for_each_number<Material>([&](const auto& field) {
    std::vector<double> values(count, Material{}.*field.member);
    read(field.name, field.unit, values);
    if (values.size() != count)
      throw Error(std::string("its 'materials/") + field.name + "' must have " + std::to_string(count) + " numbers.");
    for (std::size_t n = 0; n < count; ++n) materials[n].*field.member = values[n];
  });
  read.close();
  return MaterialTable(std::move(materials));
}

void write_capabilities(hid_t file, const DeviceCapabilities& capabilities) {
  const hdf5::Group group = hdf5::create_group(file, "device");
  SettingsWriter write(group.get());
  visit_fields(write, "", capabilities);
  write.close();
}

DeviceCapabilities read_capabilities(RecordingSource& source) {
  SettingsReader read = settings_of(source, "device");
  DeviceCapabilities capabilities;
  visit_fields(read, "", capabilities);
  read.close();
  return capabilities;
}

}  // namespace hapticut
