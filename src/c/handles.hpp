// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "c/failure.hpp"
#include "hapticut/c/hapticut.h"

/// @file
/// Handles are numbers that identify objects and their kind. A handle becomes stale when its object is released.
///
///     bits 63 ... 56  kind    55 ... 16  number    15 ... 0  slot
///
/// The number counts the handles, from a start value that each copy of the library draws when it is loaded. So a handle
/// of another copy is stale here, and a reused slot has another handle.
namespace hapticut::c {

enum class Kind : std::uint8_t {
  none,
  simulation,
  snapshot,
  coupling,
  device,
  loop,
  surface,
  sound,
  recording,
  heat,
  islands
};
inline constexpr std::size_t kKinds = 11;
[[nodiscard]] const char* name_of(Kind kind) noexcept;

/// Threads that may be in a call with an object at the same time: one thread per lane.
enum class Lane : std::uint8_t { first, reading, sending };

class Object {
 public:
  Object() = default;
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;
  virtual ~Object() = default;

  [[nodiscard]] bool enter(Lane lane) noexcept {
    return !lanes_[std::size_t(lane)].exchange(true, std::memory_order_acquire);
  }
  void leave(Lane lane) noexcept { lanes_[std::size_t(lane)].store(false, std::memory_order_release); }

 private:
  std::array<std::atomic<bool>, 3> lanes_{};
};

/// Makes a handle for an object.  @throws Refusal when there are too many
[[nodiscard]] hapticut_handle add_object(Kind kind, std::shared_ptr<Object> object);

/// Releases a handle, and its object if no other object needs it.
int release_object(hapticut_handle handle) noexcept;

/// Finds an object and pins its slot.  @return null when the handle is not of this kind; `code` and its sentence are
/// set
/// @realtime no allocation, no lock, when it succeeds
[[nodiscard]] const std::shared_ptr<Object>* pin_slot(hapticut_handle handle, Kind kind, int& code) noexcept;
void unpin_slot(hapticut_handle handle) noexcept;

/// Represents a thread in a call: the object stays alive, and no other thread is in the same lane.
/// @realtime like pin_slot
template <class T>
class Use {
 public:
  explicit Use(hapticut_handle handle, Lane lane = Lane::first) noexcept : handle_(handle), lane_(lane) {
    shared_ = pin_slot(handle, T::kKind, code_);
    if (shared_ == nullptr) return;
    if (!(*shared_)->enter(lane)) {
      unpin_slot(handle);
      shared_ = nullptr;
      code_ = fail(HAPTICUT_ERROR_BUSY, "Another thread is in a call with this handle; try again.");
    }
  }
  ~Use() {
    if (shared_ == nullptr) return;
    (*shared_)->leave(lane_);
    unpin_slot(handle_);
  }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;

  explicit operator bool() const noexcept { return shared_ != nullptr; }
  [[nodiscard]] int code() const noexcept { return code_; }
  T* operator->() const noexcept { return static_cast<T*>(shared_->get()); }
  [[nodiscard]] std::shared_ptr<T> pointer() const { return std::static_pointer_cast<T>(*shared_); }

 private:
  hapticut_handle handle_;
  Lane lane_;
  const std::shared_ptr<Object>* shared_ = nullptr;
  int code_ = HAPTICUT_OK;
};

/// Runs `body(stay)` if the stay has been entered, otherwise returns the code of its failure.
/// @param stay  Use, IdleSimulation or IdleStay
template <class InCall, class Body>
int within(const InCall& stay, Body&& body) noexcept {
  return stay ? guarded([&] { return body(stay); }) : stay.code();
}

/// Occupies a lane of an object that is accessed without its handle.
class Stay {
 public:
  explicit Stay(Object& object, Lane lane = Lane::first) noexcept
      : object_(object), lane_(lane), in_(object.enter(lane)) {}
  ~Stay() {
    if (in_) object_.leave(lane_);
  }
  Stay(const Stay&) = delete;
  Stay& operator=(const Stay&) = delete;
  explicit operator bool() const noexcept { return in_; }

 private:
  Object& object_;
  Lane lane_;
  bool in_;
};

}  // namespace hapticut::c
