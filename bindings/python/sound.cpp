// SPDX-License-Identifier: Apache-2.0
// include/hapticut/sound
#include "bindings.hpp"
#include "hapticut/sound/drill_sound.hpp"
#include "hapticut/sound/loop_listener.hpp"
#include "structs.hpp"

namespace hapticut::python {

void bind_sound(py::module_& m) {
  bind_described<SoundInput>(m, "SoundInput");
  bind_described<SoundOptions>(m, "SoundOptions");
  py::class_<DrillSound>(m, "DrillSound", doc("DrillSound"))
      .def(py::init<const SoundOptions&>(), py::arg("options") = SoundOptions{}, doc("DrillSound::DrillSound"))
      .def(
          "render",
          [](DrillSound& self, std::size_t count, double sample_rate, const SoundInput& input) {
            py::array_t<float> samples{py::ssize_t(count)};
            self.render({samples.mutable_data(), count}, sample_rate, input);
            return samples;
          },
          py::arg("count"), py::arg("sample_rate"), py::arg("input"),
          "The next samples of one channel. The number of samples per call does not affect the sound.\n\n"
          "count\n    number of samples.\n"
          "sample_rate\n    [Hz] 8000 ... 384 000; silence at any other.\n"
          "input\n    valid from now on; numbers that are not finite count as 0.\n"
          "Returns\n    (n,) float32 of n = count, -1 ... 1");
  py::class_<LoopListener>(m, "LoopListener", doc("LoopListener"))
      .def(py::init<double>(), py::arg("rate") = 1000.0, doc("LoopListener::LoopListener"))
      .def(
          "listen", [](LoopListener& self, const LoopSnapshot& snapshot) { return self.listen(snapshot); },
          py::arg("snapshot"), doc("LoopListener::listen"));
}

}  // namespace hapticut::python
