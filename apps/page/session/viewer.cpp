// SPDX-License-Identifier: Apache-2.0
#include "page/session/viewer.hpp"

#include <chrono>
#include <exception>
#include <utility>

namespace hapticut::apps {
namespace {

using Clock = std::chrono::steady_clock;

view::ViewServerOptions with_stop_line(view::ViewServerOptions options, StopLine& line) {
  options.on_urgent = [&line](const view::ViewCommand& command) { line.handle(command); };
  return options;
}

/// Whether a command is a request that needs a notice when it is not done.
bool is_a_wish(const view::ViewCommand& command) {
  return !std::holds_alternative<view::MoveHand>(command) && !std::holds_alternative<view::LookAt>(command) &&
         !std::holds_alternative<view::Stop>(command) && !std::holds_alternative<view::WriterLeft>(command);
}

}  // namespace

void StopLine::set_device(Device* device) {
  const std::lock_guard lock(mutex_);
  device_ = device;
  if (device_ != nullptr && std::exchange(stopped_, false)) device_->emergency_stop();
}

void StopLine::handle(const view::ViewCommand& command) {
  const std::lock_guard lock(mutex_);
  const bool is_stop = std::holds_alternative<view::Stop>(command);
  if (device_ == nullptr)
    stopped_ = stopped_ || is_stop;
  else if (is_stop)
    device_->emergency_stop();
  else if (std::holds_alternative<view::WriterLeft>(command))
    device_->stop();
}

Viewer::Viewer(const std::string& scene, view::ViewServerOptions options, Device* device, MakeScene make_scene)
    : make_scene_(std::move(make_scene)), device_(device), server_({}, with_stop_line(std::move(options), stop_line_)) {
  replace(std::make_unique<ViewSession>(make_scene_(scene), server_, device_));
}

Viewer::~Viewer() { end(); }

void Viewer::frame() {
  const auto now = Clock::now();
  while (const auto command = server_.receive()) apply(*command);
  if (loading_.valid() && loading_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) finish_loading();
  session_->frame(std::chrono::duration<double>(now - std::exchange(last_, now)).count());
  if (session_->consume_restart()) load(session_->name());
}

void Viewer::apply(const view::ViewCommand& command) {
  if (is_loading()) {
    has_writer_ = !std::holds_alternative<view::WriterLeft>(command);
    if (is_a_wish(command))
      server_.send_notice(view::Severity::warning, loaded_ + " is still loading: try again afterwards.");
  } else if (const auto* request = std::get_if<view::Load>(&command)) {
    load(request->name);
  } else {
    session_->apply(command);
  }
}

void Viewer::load(const std::string& name) {
  session_->suspend();
  server_.send_notice(view::Severity::info, "Loading " + name + " ...");
  has_writer_ = true;
  loaded_ = name;
  loading_ = std::async(std::launch::async,
                        [=, this] { return std::make_unique<ViewSession>(make_scene_(name), server_, device_); });
}

void Viewer::finish_loading() {
  try {
    replace(loading_.get());
    server_.send_notice(view::Severity::info, loaded_ + " is ready.");
  } catch (const std::exception& error) {
    server_.send_notice(view::Severity::error, as_sentence(error));
    if (has_writer_) session_->start();
  }
}

/// An emergency stop also applies to the next session.
void Viewer::replace(std::unique_ptr<ViewSession> next) {
  stop_line_.set_device(nullptr);  // before reading the state: StopLine stores a stop that arrives now
  const bool is_stopped = session_ != nullptr && session_->device().requests().emergency();
  session_ = std::move(next);
  if (session_ == nullptr) return;
  if (is_stopped) session_->device().emergency_stop();
  stop_line_.set_device(&session_->device());
  session_->begin(has_writer_);
}

}  // namespace hapticut::apps
