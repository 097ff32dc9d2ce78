// SPDX-License-Identifier: Apache-2.0
#include "io/recording/recording_settings.hpp"

#include <utility>

#include "hapticut/force/laws/foundation.hpp"
#include "io/recording/settings_archive.hpp"

namespace hapticut {
namespace {

const Names<RemovalLaw> kRemovalLaws = {{RemovalLaw::none, "none"},
                                        {RemovalLaw::constant_energy, "constant_energy"},
                                        {RemovalLaw::elastic_release, "elastic_release"}};
const Names<Quadrature> kQuadratures = {{Quadrature::centroid, "centroid"}, {Quadrature::voxel_center, "voxel_center"}};
const Names<ContactTime> kContactTimes = {{ContactTime::middle, "middle"}, {ContactTime::end, "end"}};
const Names<HandleTorque> kHandleTorques = {{HandleTorque::full_wrench, "full_wrench"},
                                            {HandleTorque::thesis, "thesis"}};
const Names<FlatRule> kFlatRules = {{FlatRule::nearest, "nearest"},
                                    {FlatRule::bottom_only, "bottom_only"},
                                    {FlatRule::side_only, "side_only"},
                                    {FlatRule::both, "both"}};

// --- what is stored, once for writing and reading -------------------------------------------------------------------

/// Everything but law and effects, which are told apart by `law_is_default` and by a table of their changes.
template <class Archive, class Config>
void visit_config(Archive& archive, Config& c) {
  archive("reference_stiffness", "N/m^4", c.reference_stiffness);
  archive("removal", c.removal, kRemovalLaws);
  archive("quadrature", c.quadrature, kQuadratures);
  archive("contact_time", c.contact_time, kContactTimes);
  archive("deep_contact", c.deep_contact);
  archive("handle_torque", c.handle_torque, kHandleTorques);
  archive("handle_torque_scale", "1", c.handle_torque_scale);
  archive("update_rate", "Hz", c.update_rate);
  archive("reserved_blocks", c.reserved_blocks);
  archive("removed_voxel_capacity", c.removed_voxel_capacity);
  archive("voxel_budget", c.voxel_budget);
  archive("stage_times", c.stage_times);
  archive("shortest_dt", "s", c.shortest_dt);
  archive("longest_dt", "s", c.longest_dt);
  archive("longest_sweep", c.longest_sweep);
}

// A new field of SimulationConfig or Effects needs a line of its own here, and the format a new number: a recording
// that leaves a setting out does not replay.
static_assert(sizeof(Effects) == 176 && sizeof(SimulationConfig) == 328);

template <class Archive, class Friction>
void visit_friction(Archive& archive, Friction& f) {
  archive("static_friction", "1", f.static_friction);
  archive("dynamic_friction", "1", f.dynamic_friction);
  archive("tangential_stiffness", "N/m", f.tangential_stiffness);
}

template <class Archive, class Motor>
void visit_spindle(Archive& archive, Motor& s) {
  archive("spindle_speed", "rad/s", s.speed);
  archive("spindle_power_limit", "W", s.power_limit);
  archive("spindle_acceleration_limit", "rad/s^2", s.acceleration_limit);
  archive("spindle_droop", "rad/(s N m)", s.droop);
}

template <class Archive, class Capabilities>
void visit_capabilities(Archive& archive, Capabilities& c) {
  archive("model", c.model);
  archive("vendor", c.vendor);
  archive("serial_number", c.serial_number);
  archive("driver_version", c.driver_version);
  archive("input_degrees_of_freedom", c.input_degrees_of_freedom);
  archive("output_degrees_of_freedom", c.output_degrees_of_freedom);
  archive("peak_force", "N", c.peak_force);
  archive("continuous_force", "N", c.continuous_force);
  archive("peak_torque", "N m", c.peak_torque);
  archive("continuous_torque", "N m", c.continuous_torque);
  archive("stiffness", "N/m", c.stiffness);
  archive("rotational_stiffness", "N m/rad", c.rotational_stiffness);
  archive("damping", "N s/m", c.damping);
  archive("position_resolution", "m", c.position_resolution);
  archive("workspace_low_x", "m", c.workspace_low.x());
  archive("workspace_low_y", "m", c.workspace_low.y());
  archive("workspace_low_z", "m", c.workspace_low.z());
  archive("workspace_high_x", "m", c.workspace_high.x());
  archive("workspace_high_y", "m", c.workspace_high.y());
  archive("workspace_high_z", "m", c.workspace_high.z());
  archive("rate", "Hz", c.rate);
  archive("hard_realtime", c.hard_realtime);
}

constexpr struct {
  const char *name, *unit;
  double Material::*member;
} kMaterialFields[] = {
    {"relative_stiffness", "1", &Material::relative_stiffness},
    {"damping", "s/m", &Material::damping},
    {"cutting_ratio", "1", &Material::cutting_ratio},
    {"specific_cutting_energy", "J/m^3", &Material::specific_cutting_energy},
    {"edge_pressure", "Pa", &Material::edge_pressure},
    {"static_friction", "1", &Material::static_friction},
    {"dynamic_friction", "1", &Material::dynamic_friction},
    {"tangential_stiffness", "N/m", &Material::tangential_stiffness},
    {"density", "kg/m^3", &Material::density},
};
// A new field of Material needs a line above, and the format a new number.
static_assert(sizeof(Material) == sizeof(std::string) + std::size(kMaterialFields) * sizeof(double));

// --- heads and handles ----------------------------------------------------------------------------------------------

void write_head(SettingsWriter& write, const ToolHead& head) {
  if (const auto* sphere = std::get_if<SphereHead>(&head.shape())) {
    write("head", std::string("sphere"));
    write("radius", "m", sphere->radius);
  } else if (const auto* cone = std::get_if<ConeHead>(&head.shape())) {
    write("head", std::string("cone"));
    write("half_angle", "rad", cone->half_angle);
    write("height", "m", cone->height);
  } else if (const auto* flat = std::get_if<FlatHead>(&head.shape())) {
    write("head", std::string("flat"));
    write("radius", "m", flat->radius);
    write("height", "m", flat->height);
    write("flat_rule", flat->rule, kFlatRules);
  } else {
    const auto& profile = std::get<ProfileHead>(head.shape());
    std::vector<double> rho, z, radius, cutting;
    for (const ProfileEdge& edge : profile.profile().edges) {
      rho.push_back(edge.rho);
      z.push_back(edge.z);
      radius.push_back(edge.radius);
      cutting.push_back(edge.kind == EdgeKind::cutting ? 1 : 0);
    }
    write("head", std::string("profile"));
    write("profile_tip", "m", profile.profile().tip);
    write("profile_rho", "m", rho);
    write("profile_z", "m", z);
    write("profile_radius", "m", radius);
    write("profile_cutting", "1", cutting);
    write("profile_tolerance", "1", profile.tolerance());
  }
}

ToolHead read_profile(const SettingsReader& read) {
  Profile profile;
  double tolerance = 0;
  std::vector<double> rho, z, radius, cutting;
  read("profile_tip", "m", profile.tip);
  read("profile_rho", "m", rho);
  read("profile_z", "m", z);
  read("profile_radius", "m", radius);
  read("profile_cutting", "1", cutting);
  read("profile_tolerance", "1", tolerance);
  if (z.size() != rho.size() || radius.size() != rho.size() || cutting.size() != rho.size())
    throw Error("the columns of its 'tool/profile_...' differ in length");
  for (std::size_t n = 0; n < rho.size(); ++n)
    profile.edges.push_back({rho[n], z[n], radius[n], cutting[n] != 0 ? EdgeKind::cutting : EdgeKind::smooth});
  return ProfileHead(std::move(profile), tolerance);
}

ToolHead read_head(const SettingsReader& read) {
  std::string kind;
  read("head", kind);
  if (kind == "sphere") {
    SphereHead sphere{};
    read("radius", "m", sphere.radius);
    return sphere;
  }
  if (kind == "cone") {
    ConeHead cone{};
    read("half_angle", "rad", cone.half_angle);
    read("height", "m", cone.height);
    return cone;
  }
  if (kind == "flat") {
    FlatHead flat{};
    read("radius", "m", flat.radius);
    read("height", "m", flat.height);
    read("flat_rule", flat.rule, kFlatRules);
    return flat;
  }
  if (kind == "profile") return read_profile(read);
  throw Error("its 'tool/head' is \"" + kind + "\", but must be one of sphere, cone, flat, profile");
}

void write_handle(SettingsWriter& write, const Handle& handle) {
  if (const auto* ray = std::get_if<RayHandle>(&handle)) {
    write("handle", std::string("ray"));
    write("handle_length", "m", ray->length);
    return;
  }
  const auto& angled = std::get<LHandle>(handle);
  write("handle", std::string("L"));
  write("handle_length", "m", angled.length);
  write("handle_neck", "m", angled.neck);
  write("handle_bend", "rad", angled.bend);
}

Handle read_handle(const SettingsReader& read) {
  std::string kind;
  double length = 0;
  read("handle", kind);
  read("handle_length", "m", length);
  if (kind == "ray") return RayHandle{length};
  if (kind != "L") throw Error("its 'tool/handle' is \"" + kind + "\", but must be one of ray, L");
  LHandle angled{length, 0, 0};
  read("handle_neck", "m", angled.neck);
  read("handle_bend", "rad", angled.bend);
  return angled;
}

}  // namespace

void write_settings(hid_t file, const SimulationConfig& config, const Tool& tool, const MaterialTable& materials) {
  {
    const hdf5::Group group = hdf5::create_group(file, "simulation");
    SettingsWriter write(group.get());
    visit_config(write, config);
    const bool law_is_default =
        config.law == nullptr || dynamic_cast<const FoundationLaw*>(config.law.get()) != nullptr;
    write("law_is_default", law_is_default);
    write("friction_is_given", config.friction.has_value());
    if (config.friction) visit_friction(write, *config.friction);
  }
  {
    const hdf5::Group group = hdf5::create_group(file, "tool");
    SettingsWriter write(group.get());
    write_head(write, tool.head());
    write_handle(write, tool.handle());
    visit_spindle(write, tool.spindle());
  }
  const hdf5::Group group = hdf5::create_group(file, "materials");
  SettingsWriter write(group.get());
  write("count", std::size_t(materials.size()));
  int id = 0;
  for (const Material& material : materials.all()) write(("name_" + std::to_string(++id)).c_str(), material.name);
  for (const auto& field : kMaterialFields) {
    std::vector<double> values;
    for (const Material& material : materials.all()) values.push_back(material.*field.member);
    write(field.name, field.unit, values);
  }
}

SimulationConfig read_config(hid_t file) {
  hdf5::Group group;
  const SettingsReader read = settings_of(file, group, "simulation");
  SimulationConfig config;
  visit_config(read, config);
  bool friction_is_given = false;
  read("friction_is_given", friction_is_given);
  if (friction_is_given) visit_friction(read, config.friction.emplace());
  return config;
}

bool read_default_law(hid_t file) {
  hdf5::Group group;
  bool law_is_default = false;
  settings_of(file, group, "simulation")("law_is_default", law_is_default);
  return law_is_default;
}

Tool read_tool(hid_t file) {
  hdf5::Group group;
  const SettingsReader read = settings_of(file, group, "tool");
  Spindle spindle;
  visit_spindle(read, spindle);
  return Tool(read_head(read), read_handle(read), spindle);
}

MaterialTable read_materials(hid_t file) {
  hdf5::Group group;
  const SettingsReader read = settings_of(file, group, "materials");
  std::size_t count = 0;
  read("count", count);
  if (count < 1 || count > std::size_t(kMaxMaterials))
    throw Error("its 'materials/count' is " + std::to_string(count) + ", but must be 1 to 255");
  std::vector<Material> materials(count);
  for (std::size_t id = 1; id <= count; ++id) read(("name_" + std::to_string(id)).c_str(), materials[id - 1].name);
  for (const auto& field : kMaterialFields) {
    std::vector<double> values;
    read(field.name, field.unit, values);
    if (values.size() != count)
      throw Error(std::string("its 'materials/") + field.name + "' must have " + std::to_string(count) + " numbers");
    for (std::size_t n = 0; n < count; ++n) materials[n].*field.member = values[n];
  }
  return MaterialTable(std::move(materials));
}

void write_capabilities(hid_t file, const DeviceCapabilities& capabilities) {
  const hdf5::Group group = hdf5::create_group(file, "device");
  SettingsWriter write(group.get());
  visit_capabilities(write, capabilities);
}

DeviceCapabilities read_capabilities(hid_t file) {
  hdf5::Group group;
  const SettingsReader read = settings_of(file, group, "device");
  DeviceCapabilities capabilities;
  visit_capabilities(read, capabilities);
  return capabilities;
}

}  // namespace hapticut
