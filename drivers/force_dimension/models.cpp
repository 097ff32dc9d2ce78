// SPDX-License-Identifier: Apache-2.0
#include "force_dimension/models.hpp"

namespace hapticut::force_dimension {
namespace {

constexpr std::string_view kLeft = "-left", kRight = "-right";

// Name, type, force, torque, stiffness, rotational stiffness, damping, half widths of the workspace. The numbers are
// those that CHAI3D uses for these devices. CHAI3D does not have lambda.3, lambda.6 and sigma.3; they have the numbers
// of their family without torque. The middle of the workspace of a sigma.7 is reported to be 10 mm and 20 mm off the
// origin, in an unknown direction: the box has room for both directions.
constexpr std::array kModels = {
    Model{"omega.3", 33, 12, 0, 5000, 0, 30, {0.075, 0.075, 0.075}},
    Model{"omega.6", 34, 12, 0, 5000, 0, 30, {0.075, 0.075, 0.075}},
    Model{"omega.6-left", 36, 12, 0, 5000, 0, 30, {0.075, 0.075, 0.075}},
    Model{"omega.7", 35, 12, 0, 5000, 0, 30, {0.075, 0.075, 0.075}},
    Model{"omega.7-left", 37, 12, 0, 5000, 0, 30, {0.075, 0.075, 0.075}},
    Model{"falcon", 60, 8, 0, 3000, 0, 20, {0.04, 0.04, 0.04}},
    Model{"delta.3", 63, 20, 0, 5000, 0, 30, {0.15, 0.15, 0.15}},
    Model{"sigma.3", 206, 12, 0, 4000, 0, 30, {0.085, 0.095, 0.075}},
    Model{"sigma.7", 104, 12, 0.2, 4000, 1, 30, {0.085, 0.095, 0.075}},
    Model{"sigma.7-left", 105, 12, 0.2, 4000, 1, 30, {0.085, 0.095, 0.075}},
    Model{"lambda.3", 203, 12, 0, 8000, 0, 30, {0.1125, 0.1125, 0.1125}},
    Model{"lambda.6", 131, 12, 0, 8000, 0, 30, {0.1125, 0.1125, 0.1125}},
    Model{"lambda.6-left", 132, 12, 0, 8000, 0, 30, {0.1125, 0.1125, 0.1125}},
    Model{"lambda.7", 108, 12, 0.2, 8000, 1, 30, {0.1125, 0.1125, 0.1125}},
    Model{"lambda.7-left", 109, 12, 0.2, 8000, 1, 30, {0.1125, 0.1125, 0.1125}},
};

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() > end.size() && text.substr(text.size() - end.size()) == end;
}

}  // namespace

std::span<const Model> models() { return kModels; }

const Model* find_model(int type) {
  for (const Model& model : kModels)
    if (model.type == type) return &model;
  return nullptr;
}

bool answers_to(const Model& model, std::string_view name) {
  if (model.name == name) return true;
  const bool left = ends_with(model.name, kLeft);
  if (left) return model.name.substr(0, model.name.size() - kLeft.size()) == name;
  return ends_with(name, kRight) && model.name == name.substr(0, name.size() - kRight.size());
}

}  // namespace hapticut::force_dimension
