// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hapticut/simulation/config.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/tool.hpp"
#include "hapticut/view/protocol.hpp"
#include "hapticut/workpiece/material.hpp"
#include "page/session/slider_range.hpp"

namespace hapticut::apps {

/// Effect of a changed control on the loop.
enum class Change : std::uint8_t {
  none,
  haptics,
  removal,
  spindle,
  tool,
  materials,
  effects,
  restart,
  reset,
  record,
  heat,
  loose_pieces
};

/// What a page switches beside the step.
struct BesideTheStep {
  bool heat = false;          ///< whether temperatures are computed
  double irrigation = 0;      ///< [W/(m^2 K)] heat transfer to the water; 0: dry
  bool loose_pieces = false;  ///< whether loose pieces are removed
};

struct ModelSettings;

/// The panels of a page: controls, their values, and the settings that they define.
class ViewControls {
 public:
  /// @param config  completed, see `complete`
  ViewControls(const Tool& tool, const MaterialTable& materials, const SimulationConfig& config, bool can_record,
               const BesideTheStep& beside = {});

  [[nodiscard]] std::span<const view::Control> all() const { return controls_; }

  /// @return the effect; Change::none when there is no such control or the value is not in its range
  /// @throws Error when a static friction is below the dynamic one
  [[nodiscard]] Change set(const view::SetControl& command);

  /// Reverts the last `set`.
  void revert() { controls_ = before_; }

  void show_recording(bool on);
  void show_heat(bool on);

  /// Sets the controls of spindle, removal and effects to the values of the model.
  void show(const ModelSettings& model);

  [[nodiscard]] bool haptics() const { return at(kHaptics) != 0; }
  [[nodiscard]] bool sound() const { return at(kSound) != 0; }
  [[nodiscard]] double volume() const { return at(kVolume); }
  [[nodiscard]] bool recording() const { return at(kRecord) != 0; }
  [[nodiscard]] BesideTheStep beside() const;
  [[nodiscard]] AngularSpeed spindle_speed() const;  ///< [rad/s] set speed
  [[nodiscard]] RemovalLaw removal() const;
  [[nodiscard]] AxisMask mask() const;
  [[nodiscard]] Effects effects() const;
  /// @throws Error when the dimensions contradict each other
  [[nodiscard]] Tool tool() const;
  [[nodiscard]] MaterialTable materials() const;

 private:
  enum Id : std::uint16_t {
    kHaptics = 1,
    kCutting,
    kRemoval,
    kSpindle,
    kRecord,
    kReset,
    kRestart,
    kLoosePieces,
    kHead = 20,
    kDiameter,
    kLength,
    kAngle,
    kSpeed,
    kPower,
    kHandle,
    kHandleLength,
    kNeck,
    kBend,
    kGravity = 40,
    kMass,
    kVibration,
    kSound,
    kVolume,
    kFilter,
    kDelta,
    kEpsilon,
    kFrequency = 50,
    kAmplitude,
    kPerWatt,
    kMaxAmplitude,
    kMask = 60,
    kHeat = 70,
    kWater,
    kIrrigation,
    kMaterial = 100,  // kIdsOfAMaterial ids per material
  };

  static constexpr EffectNumber<Gravity> kGravityNumbers[] = {
      {kMass, "Mass", &Gravity::mass, Range::between(0, 2)},
  };
  static constexpr EffectNumber<DeltaFilter> kFilterNumbers[] = {
      {kDelta, "Filter passes", &DeltaFilter::delta, Range::between(1e-3, 10)},
      {kEpsilon, "Filter step", &DeltaFilter::epsilon, Range::between(1e-4, 1)},
  };
  static constexpr EffectNumber<Vibration> kVibrationNumbers[] = {
      {kFrequency, "Frequency", &Vibration::frequency, Range::between(1, 449)},
      {kAmplitude, "Amplitude", &Vibration::amplitude, Range::between(0, 2)},
      {kPerWatt, "Growth", &Vibration::amplitude_per_watt, Range::between(0, 1)},
      {kMaxAmplitude, "Largest", &Vibration::max_amplitude, Range::between(0, 5)},
  };

  void add_application(const Tool& tool, bool can_record, bool removes_loose_pieces);
  void add_tool(const Tool& tool);
  void add_additional(const Effects& effects);
  void add_materials();
  void add_heat(const BesideTheStep& beside);
  void number(std::uint16_t id, const std::string& panel, const std::string& label, const std::string& unit,
              double value, double min, double max);
  void on_off(std::uint16_t id, const std::string& panel, const std::string& label, bool value);
  template <class Effect, std::size_t kCount>
  void add_numbers(const char* panel, const EffectNumber<Effect> (&numbers)[kCount], const Effect& effect);
  template <class Effect, std::size_t kCount>
  void show_numbers(const EffectNumber<Effect> (&numbers)[kCount], const Effect& effect);
  /// @return `effect` with the numbers of the controls
  template <class Effect, std::size_t kCount>
  [[nodiscard]] Effect with_numbers(const EffectNumber<Effect> (&numbers)[kCount], Effect effect) const;
  void show(const Effects& effects);
  void show(const MaterialTable& materials);
  [[nodiscard]] double& at(std::uint16_t id);
  [[nodiscard]] double at(std::uint16_t id) const;
  void set_spindle(double speed);
  [[nodiscard]] static Change change_of(std::uint16_t id);
  void require_friction_order(const view::SetControl& command) const;
  void tell_idle_ones();
  [[nodiscard]] std::string why_idle(std::uint16_t id) const;
  [[nodiscard]] std::string why_idle(double Material::*number, const Material& material) const;
  [[nodiscard]] static bool is_height(const HeadShape::Dimension& dimension);
  [[nodiscard]] static bool is_cone_angle(const HeadShape::Dimension& dimension);
  [[nodiscard]] bool head_has(bool (*is)(const HeadShape::Dimension&)) const;
  [[nodiscard]] ToolHead head() const;

  std::vector<view::Control> controls_, before_;
  MaterialTable materials_;
  SimulationConfig config_;
  Tool tool_;
};

}  // namespace hapticut::apps
