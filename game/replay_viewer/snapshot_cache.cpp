#include "game/replay_viewer/snapshot_cache.h"

#include <iterator>
#include <utility>

namespace gw {

size_t bytesOf(const RunSnapshot& snapshot) {
  constexpr size_t kEffects = 4096;  // their lists hold a few dozen small entries each
  return sizeof(RunSnapshot) + kEffects + snapshot.state.globals.capacity() +
         snapshot.state.entities.capacity() * sizeof(EntityRecord) +
         snapshot.state.arrangement.capacity() * sizeof(uint32_t);
}

bool SnapshotCache::wanted(uint32_t tick, double cost_ms) const {
  const std::lock_guard lock(mutex_);
  auto after = kept_.upper_bound(tick);
  if (after == kept_.begin()) return true;
  const uint32_t since = tick - std::prev(after)->first;
  return since > 0 && (since >= spacing_.ticks || cost_ms >= spacing_.cost_ms);
}

void SnapshotCache::keep(RunSnapshot snapshot) {
  snapshot.state.entities.shrink_to_fit();
  snapshot.state.arrangement.shrink_to_fit();
  const uint32_t tick = snapshot.tick();
  const size_t bytes = bytesOf(snapshot);
  auto shared = std::make_shared<const RunSnapshot>(std::move(snapshot));
  const std::lock_guard lock(mutex_);
  if (!kept_.emplace(tick, std::move(shared)).second) return;  // the other thread has stored it already
  bytes_ += bytes;
  while (bytes_ > budget_bytes_ && kept_.size() > 1) thin();
}

void SnapshotCache::thin() {
  bool drop = false;
  for (auto it = kept_.begin(); it != kept_.end(); drop = !drop) {
    if (!drop) {
      ++it;
      continue;
    }
    bytes_ -= bytesOf(*it->second);
    it = kept_.erase(it);
  }
  spacing_.ticks *= 2;
  spacing_.cost_ms *= 2;
}

bool SnapshotCache::has(uint32_t tick) const {
  const std::lock_guard lock(mutex_);
  return kept_.contains(tick);
}

std::shared_ptr<const RunSnapshot> SnapshotCache::before(uint32_t tick) const {
  const std::lock_guard lock(mutex_);
  const auto after = kept_.upper_bound(tick);
  return after == kept_.begin() ? nullptr : std::prev(after)->second;
}

std::shared_ptr<const RunSnapshot> SnapshotCache::start(uint32_t tick, uint32_t lead_ticks) const {
  const std::lock_guard lock(mutex_);
  auto it = kept_.upper_bound(tick);
  if (it == kept_.begin()) return nullptr;
  --it;
  for (int back = 0; back < kBack && it != kept_.begin() && it->first + lead_ticks > tick; ++back) --it;
  return it->second;
}

uint32_t SnapshotCache::lastTick() const {
  const std::lock_guard lock(mutex_);
  return kept_.empty() ? 0 : kept_.rbegin()->first;
}

size_t SnapshotCache::count() const {
  const std::lock_guard lock(mutex_);
  return kept_.size();
}

size_t SnapshotCache::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

SnapshotCache::Spacing SnapshotCache::spacing() const {
  const std::lock_guard lock(mutex_);
  return spacing_;
}

}  // namespace gw
