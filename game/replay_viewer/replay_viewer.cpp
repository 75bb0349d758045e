#include "game/replay_viewer/replay_viewer.h"

#include <utility>

#include "host/platform/clock.h"

namespace gw {

ReplayViewer::ReplayViewer(const Replay& replay, std::unique_ptr<Simulation> simulation, PrefetchThread::Make prefetch,
                           size_t budget_bytes)
    : replay_(replay), cache_(budget_bytes), player_(ReplayPlayer(replay, std::move(simulation), difference_), cache_) {
  if (prefetch) prefetch_ = std::make_unique<PrefetchThread>(replay, difference_, cache_, std::move(prefetch));
}

void ReplayViewer::seek(uint32_t tick) {
  tick = std::min(tick, replay_.ticks());
  if (!target_ && tick == this->tick()) return;
  target_ = tick;
  seekStart_ = this->tick();
  progress_ = 0;
}

void ReplayViewer::seekBy(int64_t ticks) {
  seek(uint32_t(std::clamp<int64_t>(int64_t(seekTarget()) + ticks, 0, replay_.ticks())));
}

float ReplayViewer::seekProgress() const {
  return target_ ? progress_ : 1.0f;
}

// To the best snapshot for the target, unless playing on from the current tick is as short.
void ReplayViewer::jump() {
  constexpr uint32_t kWorthIt_ticks = 16;
  const auto from = cache_.start(*target_, kSparks_ticks);
  if (*target_ >= tick() && from->tick() <= tick() + kWorthIt_ticks) return;
  if (*target_ < tick()) seekStart_ = from->tick();
  player_.restore(*from);
}

bool ReplayViewer::continueSeek(double budget_ms) {
  constexpr uint32_t kLooks_ticks = 16;  // prefetching may have cached a nearer snapshot since
  const double until_ms = now_ms() + budget_ms;
  for (uint32_t i = 0; target_ && (i == 0 || now_ms() < until_ms); ++i) {
    if (i % kLooks_ticks == 0) jump();
    if (tick() < *target_ && !player_.ended()) player_.playOne();
    const auto way = float(*target_ - std::min(seekStart_, *target_));
    progress_ = std::max(progress_, way > 0 ? float(tick() - std::min(seekStart_, tick())) / way : 1.0f);
    if (tick() == *target_ || player_.ended()) target_.reset();
  }
  playedTo_ = std::max(playedTo_, tick());
  return !target_;
}

}  // namespace gw
