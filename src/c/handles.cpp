// SPDX-License-Identifier: Apache-2.0
#include "c/handles.hpp"

#include <chrono>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace hapticut::c {
namespace {

constexpr std::size_t kSlots = 4096;
constexpr std::uint64_t kSlotMask = 0xffff, kNumberMask = (std::uint64_t(1) << 40) - 1;
constexpr int kNumberShift = 16, kKindShift = 56;
constexpr std::uint32_t kClosing = 1U << 31;  // bit of Slot::users

struct Slot {
  std::atomic<hapticut_handle> handle{0};
  std::atomic<std::uint32_t> users{0};  // number of threads that have pinned the slot
  std::shared_ptr<Object> object;       // changes only while no thread has pinned the slot
};

struct Table {
  std::array<Slot, kSlots> slots;
  std::mutex mutex;  // protects the members below; never locked in a step
  std::vector<std::size_t> free_slots;
  std::uint64_t number = 0;  // number of the last handle

  Table() {
    const auto now = std::uint64_t(std::chrono::steady_clock::now().time_since_epoch().count());
    number = (now ^ (std::uint64_t(reinterpret_cast<std::uintptr_t>(this)) << 8)) & kNumberMask;
    free_slots.reserve(kSlots);
    for (std::size_t n = kSlots; n-- > 0;) free_slots.push_back(n);
  }
};

/// Lives until the process ends, because a thread of another library may call late.
Table& table() {
  static Table* const all = new Table;
  return *all;
}

Kind kind_of(hapticut_handle handle) noexcept {
  const std::uint64_t kind = handle >> kKindShift;
  return kind < kKinds ? Kind(kind) : Kind::none;
}

int fail_stale(hapticut_handle handle, Kind wanted) noexcept {
  char text[160];
  if (handle == 0)
    std::snprintf(text, sizeof text, "The handle is 0; it must be that of a %s.", name_of(wanted));
  else if (kind_of(handle) == Kind::none)
    std::snprintf(text, sizeof text, "The handle was not issued by this library; it must be that of a %s.",
                  name_of(wanted));
  else if (wanted != Kind::none && kind_of(handle) != wanted)
    std::snprintf(text, sizeof text, "The handle is that of a %s; it must be that of a %s.", name_of(kind_of(handle)),
                  name_of(wanted));
  else
    std::snprintf(text, sizeof text,
                  "The handle of this %s was already released, or is of another copy of the library.",
                  name_of(kind_of(handle)));
  return fail(HAPTICUT_ERROR_HANDLE, text);
}

Slot& slot_of(hapticut_handle handle) noexcept { return table().slots[(handle & kSlotMask) % kSlots]; }

}  // namespace

const char* name_of(Kind kind) noexcept {
  constexpr std::array<const char*, kKinds> kNames = {"handle",
                                                      "simulation",
                                                      "snapshot",
                                                      "coupling",
                                                      "device",
                                                      "loop",
                                                      "surface",
                                                      "sound",
                                                      "recording",
                                                      "heat field",
                                                      "removal of loose pieces"};
  return kNames[std::size_t(kind)];
}

hapticut_handle add_object(Kind kind, std::shared_ptr<Object> object) {
  Table& all = table();
  const std::lock_guard lock(all.mutex);
  if (all.free_slots.empty())
    throw Refusal(HAPTICUT_ERROR_FULL, "There are " + std::to_string(kSlots) +
                                           " handles, which is the maximum; release those that are no longer needed.");
  const std::size_t n = all.free_slots.back();
  all.free_slots.pop_back();
  Slot& slot = all.slots[n];
  all.number = (all.number + 1) & kNumberMask;
  slot.object = std::move(object);
  const hapticut_handle handle = std::uint64_t(kind) << kKindShift | all.number << kNumberShift | n;
  slot.handle.store(handle, std::memory_order_release);
  return handle;
}

const std::shared_ptr<Object>* pin_slot(hapticut_handle handle, Kind kind, int& code) noexcept {
  if (kind_of(handle) != kind || handle == 0) {
    code = fail_stale(handle, kind);
    return nullptr;
  }
  Slot& slot = slot_of(handle);
  if ((slot.users.fetch_add(1, std::memory_order_acquire) & kClosing) != 0 ||
      slot.handle.load(std::memory_order_acquire) != handle) {
    slot.users.fetch_sub(1, std::memory_order_release);
    code = fail_stale(handle, kind);
    return nullptr;
  }
  return &slot.object;
}

void unpin_slot(hapticut_handle handle) noexcept { slot_of(handle).users.fetch_sub(1, std::memory_order_release); }

int release_object(hapticut_handle handle) noexcept {
  if (handle == 0 || kind_of(handle) == Kind::none) return fail_stale(handle, Kind::none);
  Slot& slot = slot_of(handle);
  std::uint32_t users = 0;
  // A thread with a stale handle pins the slot for a moment, a thread in a call for longer.
  for (int tries = 0; !slot.users.compare_exchange_strong(users, kClosing, std::memory_order_acq_rel); users = 0) {
    if (slot.handle.load(std::memory_order_acquire) != handle) return fail_stale(handle, Kind::none);
    if (++tries == 100) return fail(HAPTICUT_ERROR_BUSY, "Another thread is in a call with this handle; try again.");
    std::this_thread::yield();
  }
  if (slot.handle.load(std::memory_order_acquire) != handle) {
    slot.users.fetch_sub(kClosing, std::memory_order_release);
    return fail_stale(handle, Kind::none);
  }
  std::shared_ptr<Object> object = std::move(slot.object);
  slot.object = nullptr;
  slot.handle.store(0, std::memory_order_release);
  slot.users.fetch_sub(kClosing, std::memory_order_release);
  return guarded([&] {
    {
      Table& all = table();
      const std::lock_guard lock(all.mutex);
      all.free_slots.push_back(std::size_t(handle & kSlotMask));
    }
    object = nullptr;
    return int(HAPTICUT_OK);
  });
}

}  // namespace hapticut::c
