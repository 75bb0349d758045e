#include "host/platform/unfinished_file.h"

#include <unistd.h>

#include <utility>

namespace gw {
namespace {

constexpr size_t kSlots = 8;  // a film or a picture, and a text beside it; a list could not be read from a handler
std::atomic<const char*> slots[kSlots];
static_assert(std::atomic<const char*>::is_always_lock_free, "a handler may not wait for a lock");

}  // namespace

UnfinishedFile::UnfinishedFile(std::string name) : name_(std::move(name)) {
  for (std::atomic<const char*>& slot : slots) {
    const char* none = nullptr;
    if (!slot.compare_exchange_strong(none, name_.c_str())) continue;
    slot_ = &slot;
    return;
  }
}

void UnfinishedFile::keep() {
  if (slot_ != nullptr) std::exchange(slot_, nullptr)->store(nullptr);
}

void removeUnfinishedFiles() {
  for (const std::atomic<const char*>& slot : slots) {
    if (const char* name = slot.load()) unlink(name);
  }
}

}  // namespace gw
