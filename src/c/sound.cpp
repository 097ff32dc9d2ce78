// SPDX-License-Identifier: Apache-2.0
#include "c/handles.hpp"
#include "c/structs.hpp"
#include "hapticut/sound/drill_sound.hpp"

namespace hapticut::c {
namespace {

class SoundObject final : public Object {
 public:
  static constexpr Kind kKind = Kind::sound;
  explicit SoundObject(const SoundOptions& options) : sound(options) {}
  DrillSound sound;
};

}  // namespace
}  // namespace hapticut::c

using namespace hapticut;
using namespace hapticut::c;

extern "C" {

int hapticut_sound_open(const hapticut_sound_options* options, hapticut_sound* sound) {
  return guarded([&]() -> int {
    require_argument(sound, "sound");
    hapticut_sound_options own;
    if (const int code = read_struct_if_given(options, "options", own); code != HAPTICUT_OK) return code;
    SoundOptions given;
    set_if_given(std::min(own.flutes, kTooMany), given.flutes);
    set_if_given(own.volume, given.volume);
    set_if_given(own.half_power, given.half_power);
    *sound = add_object(Kind::sound, std::make_shared<SoundObject>(given));
    return HAPTICUT_OK;
  });
}

int hapticut_sound_render(hapticut_sound sound, const hapticut_sound_input* input, double sample_rate, float* samples,
                          size_t count) {
  hapticut_sound_input in;
  if (const int code = read_struct(input, "input", in); code != HAPTICUT_OK) return code;
  if (samples == nullptr) return fail(HAPTICUT_ERROR_ARGUMENT, "samples is a null pointer; it must not be null.");
  return within(Use<SoundObject>(sound), [&](const auto& use) {
    use->sound.render({samples, count}, sample_rate, {in.spindle_speed, in.power, in.removal_rate, in.touching != 0});
  });
}

}  // extern "C"
