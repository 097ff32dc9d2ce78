// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "hapticut/view/view_server.hpp"

/// @file
/// The mailbox between the threads of the program and the thread of the server. It keeps the newest value of each kind,
/// and its queues are bounded.
namespace hapticut::view {

using SharedMessage = std::shared_ptr<const Message>;

/// A message that is kept for a limited time: sound, curves, notices.
struct TimedMessage {
  std::uint64_t number;
  double seconds;
  SharedMessage message;
};

/// The newest message of its kind and its number, counted over all messages of that kind; null if there is none.
struct Newest {
  std::uint64_t number = 0;
  SharedMessage message;
};

/// Kinds of messages of which each connection receives only the newest, once.
enum class NewestKind : std::uint8_t { tool, controls, snapshot, instruments, heat, count };
inline constexpr std::size_t kNewestKinds = std::size_t(NewestKind::count);

class Mailbox {
 public:
  Mailbox(Scene scene, std::size_t commands) : scene_(std::move(scene)), max_commands_(commands) {}

  // --- for the program; each function returns whether the server must be woken --------------------------------------
  bool put(const SurfacePage& page) {
    auto message = std::make_shared<const Message>(encode(page));
    const std::lock_guard lock(mutex_);
    pages_[page.origin] = {++page_, std::move(message)};
    if (is_changed_.insert_or_assign(page.origin, true).second) changed_.push_back(page.origin);
    return !std::exchange(woken_, true);
  }
  bool put(NewestKind kind, Message&& message) {
    auto shared = std::make_shared<const Message>(std::move(message));
    const std::lock_guard lock(mutex_);
    Newest& newest = newest_[std::size_t(kind)];
    newest.message = std::move(shared);
    ++newest.number;
    return !std::exchange(woken_, true);
  }
  /// @param seconds  [s] that the message covers, of kKept in total
  bool put_timed(Message&& message, double seconds) {
    auto shared = std::make_shared<const Message>(std::move(message));
    const std::lock_guard lock(mutex_);
    timed_.push_back({++last_timed_, seconds, std::move(shared)});
    kept_ += seconds;
    for (; kept_ > kKept && timed_.size() > 1; timed_.pop_front()) kept_ -= timed_.front().seconds;
    return !std::exchange(woken_, true);
  }
  bool put(Scene scene) {
    const std::lock_guard lock(mutex_);
    scene_ = std::move(scene);
    ++scenes_;
    pages_.clear(), changed_.clear(), is_changed_.clear();
    for (Newest& newest : newest_) newest.message.reset();
    return !std::exchange(woken_, true);
  }
  std::optional<ViewCommand> pop_command() {
    const std::lock_guard lock(mutex_);
    if (commands_.empty()) return std::nullopt;
    std::optional<ViewCommand> command(std::move(commands_.front()));
    commands_.pop_front();
    return command;
  }

  // --- for the server -----------------------------------------------------------------------------------------------
  /// Removes and returns the origins of the pages that have changed since the last call.
  std::vector<VoxelIndex> drain_changed() {
    const std::lock_guard lock(mutex_);
    woken_ = false;
    is_changed_.clear();
    return std::exchange(changed_, {});
  }
  std::vector<VoxelIndex> all_pages() {
    const std::lock_guard lock(mutex_);
    std::vector<VoxelIndex> origins;
    for (const auto& [origin, newest] : pages_) origins.push_back(origin);
    return origins;
  }
  Newest page(const VoxelIndex& origin) {
    const std::lock_guard lock(mutex_);
    const auto found = pages_.find(origin);
    return found == pages_.end() ? Newest{} : found->second;
  }
  Newest newest(NewestKind kind) {
    const std::lock_guard lock(mutex_);
    return newest_[std::size_t(kind)];
  }
  std::pair<std::uint64_t, Scene> scene() {
    const std::lock_guard lock(mutex_);
    return {scenes_, scene_};
  }
  std::uint64_t scenes() {
    const std::lock_guard lock(mutex_);
    return scenes_;
  }
  std::uint64_t last_timed() {
    const std::lock_guard lock(mutex_);
    return last_timed_;
  }
  /// The oldest timed message after a number.
  std::optional<TimedMessage> timed_after(std::uint64_t number) {
    const std::lock_guard lock(mutex_);
    for (const TimedMessage& timed : timed_)
      if (timed.number > number) return timed;
    return std::nullopt;
  }
  void put_command(ViewCommand command) {
    const std::lock_guard lock(mutex_);
    if (!commands_.empty() && std::holds_alternative<MoveHand>(command) &&
        std::holds_alternative<MoveHand>(commands_.back())) {
      commands_.back() = std::move(command);  // intermediate poses do not matter
      return;
    }
    commands_.push_back(std::move(command));
    if (commands_.size() <= max_commands_) return;
    const auto may_drop = [](const ViewCommand& one) {
      return !std::holds_alternative<Stop>(one) && !std::holds_alternative<WriterLeft>(one);
    };
    const auto oldest = std::find_if(commands_.begin(), commands_.end(), may_drop);
    commands_.erase(oldest == commands_.end() ? commands_.begin() : oldest);
  }

 private:
  static constexpr double kKept = 2;  // [s] timed messages that are kept: one second each of sound and curves

  std::mutex mutex_;
  Scene scene_;
  std::uint64_t scenes_ = 1, last_timed_ = 0, page_ = 0;
  std::map<VoxelIndex, Newest> pages_;
  std::map<VoxelIndex, bool> is_changed_;
  std::vector<VoxelIndex> changed_;  // ordered by arrival
  std::array<Newest, kNewestKinds> newest_;
  std::deque<TimedMessage> timed_;
  double kept_ = 0;  // [s]
  std::size_t max_commands_;
  std::deque<ViewCommand> commands_;
  bool woken_ = false;
};

}  // namespace hapticut::view
