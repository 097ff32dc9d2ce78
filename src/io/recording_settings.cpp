// SPDX-License-Identifier: Apache-2.0
#include "io/recording_settings.hpp"

#include <utility>

#include "hapticut/force/laws/foundation.hpp"

namespace hapticut {
namespace {

template <class Enum>
using Names = std::vector<std::pair<Enum, const char*>>;

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

/// Writes settings into a group.
class Writer {
 public:
  explicit Writer(hid_t group) : group_(group) {}

  void operator()(const char* name, const char* unit, const double& value) { write(name, unit, &value, 1); }
  void operator()(const char* name, const char* unit, const std::vector<double>& values) {
    write(name, unit, values.data(), values.size());
  }
  void operator()(const char* name, const std::size_t& value) {
    const auto number = std::uint64_t(value);
    hdf5::write_attribute(hdf5::write_array(group_, name, &number, {1}).get(), "unit", "1");
  }
  void operator()(const char* name, const int& value) { (*this)(name, std::size_t(value)); }
  void operator()(const char* name, const bool& value) { (*this)(name, std::size_t(value)); }
  void operator()(const char* name, const std::string& text) { hdf5::write_text(group_, name, text); }
  template <class Enum>
  void operator()(const char* name, const Enum& value, const Names<Enum>& names) {
    for (const auto& [known, word] : names)
      if (known == value) hdf5::write_text(group_, name, word);
  }

 private:
  void write(const char* name, const char* unit, const double* values, std::size_t count) {
    hdf5::write_attribute(hdf5::write_array(group_, name, values, {count}).get(), "unit", unit);
  }
  hid_t group_;
};

/// Reads them back, by the same calls.
class Reader {
 public:
  Reader(hid_t group, std::string name) : group_(group), name_(std::move(name)) {}

  void operator()(const char* name, const char* /*unit*/, double& value) const { value = only<double>(name); }
  void operator()(const char* name, const char* /*unit*/, std::vector<double>& values) const {
    require(name);
    values = hdf5::read_array<double>(group_, name);
  }
  void operator()(const char* name, std::size_t& value) const { value = std::size_t(only<std::uint64_t>(name)); }
  void operator()(const char* name, int& value) const { value = int(only<std::uint64_t>(name)); }
  void operator()(const char* name, bool& value) const { value = only<std::uint64_t>(name) != 0; }
  void operator()(const char* name, std::string& text) const {
    require(name);
    text = hdf5::read_text(group_, name);
  }
  template <class Enum>
  void operator()(const char* name, Enum& value, const Names<Enum>& names) const {
    std::string found, allowed;
    (*this)(name, found);
    for (const auto& [known, word] : names) {
      if (found == word) {
        value = known;
        return;
      }
      if (!allowed.empty()) allowed += ", ";
      allowed += word;
    }
    throw Error("its '" + name_ + "/" + name + "' is \"" + found + "\", but must be one of " + allowed);
  }

 private:
  void require(const char* name) const {
    if (!hdf5::exists(group_, name)) throw Error("it lacks '" + name_ + "/" + name + "'");
  }
  template <class Number>
  Number only(const char* name) const {
    require(name);
    const std::vector<Number> values = hdf5::read_array<Number>(group_, name);
    if (values.size() != 1) throw Error("its '" + name_ + "/" + name + "' must be one number");
    return values[0];
  }
  hid_t group_;
  std::string name_;
};

Reader reader_of(hid_t file, hdf5::Group& group, const char* name) {
  if (!hdf5::exists(file, name)) throw Error(std::string("it lacks the group '") + name + "'");
  group = hdf5::open_group(file, name);
  return {group.get(), name};
}

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

void write_head(Writer& write, const ToolHead& head) {
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

ToolHead read_profile(const Reader& read) {
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

ToolHead read_head(const Reader& read) {
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

void write_handle(Writer& write, const Handle& handle) {
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

Handle read_handle(const Reader& read) {
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

// --- effects --------------------------------------------------------------------------------------------------------

/// Goes over the numbers of the effects in their order.
template <class Visit>
void visit_effects(Effects& e, bool& gravity, bool& vibration, bool& filter, Gravity& g, Vibration& v, DeltaFilter& f,
                   const Visit& visit) {
  visit("gravity", gravity);
  visit("gravity_mass_kg", g.mass);
  visit("gravity_center_x_m", g.center_of_mass.x());
  visit("gravity_center_y_m", g.center_of_mass.y());
  visit("gravity_center_z_m", g.center_of_mass.z());
  visit("gravity_x_m_per_s2", g.acceleration.x());
  visit("gravity_y_m_per_s2", g.acceleration.y());
  visit("gravity_z_m_per_s2", g.acceleration.z());
  visit("vibration", vibration);
  visit("vibration_frequency_Hz", v.frequency);
  visit("vibration_amplitude_N", v.amplitude);
  visit("vibration_amplitude_N_per_W", v.amplitude_per_watt);
  visit("vibration_largest_amplitude_N", v.largest_amplitude);
  visit("delta_filter", filter);
  visit("delta_filter_delta_N", f.delta);
  visit("delta_filter_epsilon_N", f.epsilon);
  visit("force_x", e.enabled.force[0]);
  visit("force_y", e.enabled.force[1]);
  visit("force_z", e.enabled.force[2]);
  visit("torque_x", e.enabled.torque[0]);
  visit("torque_y", e.enabled.torque[1]);
  visit("torque_z", e.enabled.torque[2]);
  visit("largest_force_N", e.limits.largest_force);
  visit("largest_torque_Nm", e.limits.largest_torque);
  visit("force_growth_N_per_s", e.limits.force_growth);
  visit("torque_growth_Nm_per_s", e.limits.torque_growth);
  visit("ramp_time_s", e.limits.ramp_time);
}

template <class Visit>
void visit_all(Effects& effects, const Visit& visit) {
  bool gravity = effects.gravity.has_value(), vibration = effects.vibration.has_value(),
       filter = effects.delta_filter.has_value();
  Gravity g = effects.gravity.value_or(Gravity{});
  Vibration v = effects.vibration.value_or(Vibration{});
  DeltaFilter f = effects.delta_filter.value_or(DeltaFilter{});
  visit_effects(effects, gravity, vibration, filter, g, v, f, visit);
  effects.gravity = gravity ? std::optional(g) : std::nullopt;
  effects.vibration = vibration ? std::optional(v) : std::nullopt;
  effects.delta_filter = filter ? std::optional(f) : std::nullopt;
}

double to_number(double value) { return value; }
double to_number(bool value) { return value ? 1 : 0; }
void from_number(double number, double& value) { value = number; }
void from_number(double number, bool& value) { value = number != 0; }

}  // namespace

void write_settings(hid_t file, const SimulationConfig& config, const Tool& tool, const MaterialTable& materials) {
  {
    const hdf5::Group group = hdf5::create_group(file, "simulation");
    Writer write(group.get());
    visit_config(write, config);
    const bool law_is_default =
        config.law == nullptr || dynamic_cast<const FoundationLaw*>(config.law.get()) != nullptr;
    write("law_is_default", law_is_default);
    write("friction_is_given", config.friction.has_value());
    if (config.friction) visit_friction(write, *config.friction);
  }
  {
    const hdf5::Group group = hdf5::create_group(file, "tool");
    Writer write(group.get());
    write_head(write, tool.head());
    write_handle(write, tool.handle());
    visit_spindle(write, tool.spindle());
  }
  const hdf5::Group group = hdf5::create_group(file, "materials");
  Writer write(group.get());
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
  const Reader read = reader_of(file, group, "simulation");
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
  reader_of(file, group, "simulation")("law_is_default", law_is_default);
  return law_is_default;
}

Tool read_tool(hid_t file) {
  hdf5::Group group;
  const Reader read = reader_of(file, group, "tool");
  Spindle spindle;
  visit_spindle(read, spindle);
  return Tool(read_head(read), read_handle(read), spindle);
}

MaterialTable read_materials(hid_t file) {
  hdf5::Group group;
  const Reader read = reader_of(file, group, "materials");
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

EffectNumbers pack(const Effects& effects) noexcept {
  EffectNumbers numbers{};
  Effects copy = effects;
  std::size_t n = 0;
  visit_all(copy, [&](const char*, const auto& value) { numbers[n++] = to_number(value); });
  HAPTICUT_ASSERT(n == kEffectNumbers);
  return numbers;
}

Effects unpack(const EffectNumbers& numbers) {
  Effects effects;
  // What is absent is visited only when it is there: so make it all, and let the flags say what to keep.
  effects.gravity.emplace();
  effects.vibration.emplace();
  effects.delta_filter.emplace();
  std::size_t n = 0;
  visit_all(effects, [&](const char*, auto& value) { from_number(numbers[n++], value); });
  return effects;
}

std::string effect_names() {
  std::string names;
  Effects none;
  visit_all(none, [&](const char* name, const auto&) {
    if (!names.empty()) names += ',';
    names += name;
  });
  return names;
}

}  // namespace hapticut
