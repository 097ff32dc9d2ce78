// SPDX-License-Identifier: Apache-2.0
#include "reports/recording_source.hpp"

#include <utility>

#include "hapticut/core/errors.hpp"
#include "reports/fail_without.hpp"
#include "reports/flag_words.hpp"
#ifdef HAPTICUT_HAS_IO
#include "hapticut/io/recording/playback.hpp"
#include "hapticut/io/recording/recorder.hpp"
#endif

namespace hapticut::apps {

#ifdef HAPTICUT_HAS_IO
namespace {

RecorderOptions options_for(Pace pace, const Device* device) {
  RecorderOptions options;
  options.wait_when_full = pace == Pace::own;
  options.driven_by = device;
  return options;
}

}  // namespace

struct RunRecorder::State {
  State(const std::string& path, Simulation& simulation, const RecorderOptions& options)
      : recorder(path, simulation, options) {}
  Recorder recorder;
};

RunRecorder::RunRecorder(const std::string& path, Simulation& simulation, Pace pace, const Device* device) {
  if (!path.empty()) state_ = std::make_unique<State>(path, simulation, options_for(pace, device));
}

std::uint64_t RunRecorder::close() {
  if (!state_) return 0;
  try {
    state_->recorder.close();
  } catch (const Error& error) {
    failure_ = in_words_of_flags(error);
  }
  return state_->recorder.lost();
}

void use_recordings_if_possible() { use_recordings(); }
#else
struct RunRecorder::State {};

RunRecorder::RunRecorder(const std::string& path, Simulation&, Pace, const Device*) {
  if (!path.empty()) fail_without("io", "cannot write the recording '" + path + "'");
}

std::uint64_t RunRecorder::close() { return 0; }
void use_recordings_if_possible() {}
#endif

RunRecorder::~RunRecorder() = default;

std::unique_ptr<RunRecorder> start_recording(Delivery& delivery, const std::string& path, Simulation& simulation,
                                             Pace pace, const Device* device) {
  std::unique_ptr<RunRecorder> recorder;
  delivery.begin(path, [&] { recorder = std::make_unique<RunRecorder>(path, simulation, pace, device); });
  return recorder ? std::move(recorder) : std::make_unique<RunRecorder>("", simulation, pace, device);
}

void RunRecorder::require_complete() const {
  if (!failure_.empty()) throw Error(failure_);
}

}  // namespace hapticut::apps
