// SPDX-License-Identifier: Apache-2.0
// The five components that come with the core, each linked by its own name: a molar, its surface, its temperature, its
// loose pieces and the sound of a drill.
#include <array>
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
  return find_islands(molar).empty() && !extract_surface(molar).mesh.triangles.empty() && samples.back() == 0;
}
