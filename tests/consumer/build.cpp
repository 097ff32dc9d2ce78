// SPDX-License-Identifier: Apache-2.0
// Uses the six components of the core, each linked by its name: a molar, its surface, its temperature, its loose
// pieces, the sound of a drill, and a ball pressed by a hand.
#include <array>
#include <hapticut/analysis/pressed_ball.hpp>
#include <hapticut/build/molar.hpp>
#include <hapticut/heat/heat_field.hpp>
#include <hapticut/islands/islands.hpp>
#include <hapticut/sound/drill_sound.hpp>
#include <hapticut/surface/extract_surface.hpp>

bool use_build() {
  using namespace hapticut;
  const Workpiece molar = build_molar(0.5e-3);
  const HeatField heat(molar);
  std::array<float, 480> samples = {};
  DrillSound().render(samples, 48000, SoundInput{});
  DeviceState above;
  above.X_BS.translation.z() = 2e-3;
  const Wrench untouched = contact_models({})(1e12)(above);
  return find_islands(molar).empty() && !extract_surface(molar).mesh.triangles.empty() && samples.back() == 0 &&
         untouched.force.norm() == 0;
}
