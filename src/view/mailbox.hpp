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
/// What lies between the threads of the program and that of the server: of everything the newest, and of nothing more
/// than is bounded.
namespace hapticut::view {

using SharedMessage = std::shared_ptr<const Message>;

/// One of what is kept for a second: sound, curves, notices.
struct Piece {
  std::uint64_t number;
  double seconds;
  SharedMessage message;
};

/// The newest of its kind, and its number among all that there were; null where there is none.
struct Newest {
  std::uint64_t number = 0;
  SharedMessage message;
};

/// Of these the newest is sent, once to each connection.
enum class Slot : std::uint8_t { tool, controls, snapshot, instruments, count };
inline constexpr std::size_t kSlots = std::size_t(Slot::count);

class Mailbox {
 public:
  Mailbox(Scene scene, std::size_t commands) : scene_(std::move(scene)), max_commands_(commands) {}

  // --- from the program; each returns whether the server must be woken ----------------------------------------------
  bool put(const SurfacePage& page) {
    auto message = std::make_shared<const Message>(encode(page));
    const std::lock_guard lock(mutex_);
    pages_[page.origin] = {++page_, std::move(message)};
    if (is_new_.insert_or_assign(page.origin, true).second) news_.push_back(page.origin);
    return !std::exchange(woken_, true);
  }
  bool put(Slot slot, Message&& message) {
    auto shared = std::make_shared<const Message>(std::move(message));
    const std::lock_guard lock(mutex_);
    Newest& newest = slots_[std::size_t(slot)];
    newest.message = std::move(shared);
    ++newest.number;
    return !std::exchange(woken_, true);
  }
  /// @param seconds  for which it is a part of what is kept
  bool put_piece(Message&& message, double seconds) {
    auto shared = std::make_shared<const Message>(std::move(message));
    const std::lock_guard lock(mutex_);
    pieces_.push_back({++piece_, seconds, std::move(shared)});
    waiting_ += seconds;
    for (; waiting_ > kKept && pieces_.size() > 1; pieces_.pop_front()) waiting_ -= pieces_.front().seconds;
    return !std::exchange(woken_, true);
  }
  bool put(Scene scene) {
    const std::lock_guard lock(mutex_);
    scene_ = std::move(scene);
    ++scenes_;
    pages_.clear(), news_.clear(), is_new_.clear();
    for (Newest& newest : slots_) newest.message.reset();
    return !std::exchange(woken_, true);
  }
  std::optional<ViewCommand> pop_command() {
    const std::lock_guard lock(mutex_);
    if (commands_.empty()) return std::nullopt;
    std::optional<ViewCommand> command(std::move(commands_.front()));
    commands_.pop_front();
    return command;
  }

  // --- from the server ----------------------------------------------------------------------------------------------
  /// Pages that are new since the last call.
  std::vector<VoxelIndex> drain_news() {
    const std::lock_guard lock(mutex_);
    woken_ = false;
    is_new_.clear();
    return std::exchange(news_, {});
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
  Newest newest(Slot slot) {
    const std::lock_guard lock(mutex_);
    return slots_[std::size_t(slot)];
  }
  std::pair<std::uint64_t, Scene> scene() {
    const std::lock_guard lock(mutex_);
    return {scenes_, scene_};
  }
  std::uint64_t scenes() {
    const std::lock_guard lock(mutex_);
    return scenes_;
  }
  std::uint64_t last_piece() {
    const std::lock_guard lock(mutex_);
    return piece_;
  }
  /// The oldest piece that is younger than a number.
  std::optional<Piece> piece_after(std::uint64_t number) {
    const std::lock_guard lock(mutex_);
    for (const Piece& piece : pieces_)
      if (piece.number > number) return piece;
    return std::nullopt;
  }
  void put_command(ViewCommand command) {
    const std::lock_guard lock(mutex_);
    if (!commands_.empty() && std::holds_alternative<MoveHand>(command) &&
        std::holds_alternative<MoveHand>(commands_.back())) {
      commands_.back() = std::move(command);  // where the hand was meanwhile is no matter
      return;
    }
    commands_.push_back(std::move(command));
    if (commands_.size() <= max_commands_) return;
    const auto may_go = [](const ViewCommand& one) {
      return !std::holds_alternative<Stop>(one) && !std::holds_alternative<WriterLeft>(one);
    };
    const auto oldest = std::find_if(commands_.begin(), commands_.end(), may_go);
    commands_.erase(oldest == commands_.end() ? commands_.begin() : oldest);
  }

 private:
  static constexpr double kKept = 2;  // [s] of pieces: sound and curves are one second each

  std::mutex mutex_;
  Scene scene_;
  std::uint64_t scenes_ = 1, piece_ = 0, page_ = 0;
  std::map<VoxelIndex, Newest> pages_;
  std::map<VoxelIndex, bool> is_new_;
  std::vector<VoxelIndex> news_;  // in the order in which they came
  std::array<Newest, kSlots> slots_;
  std::deque<Piece> pieces_;
  double waiting_ = 0;  // [s]
  std::size_t max_commands_;
  std::deque<ViewCommand> commands_;
  bool woken_ = false;
};

}  // namespace hapticut::view
