#include "game/replay_viewer/replay_viewer.h"

#include <chrono>
#include <utility>

namespace gw {

namespace {

double now_ms() {
  using namespace std::chrono;
  return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ReplayViewer::ReplayViewer(const Replay& replay, std::unique_ptr<Simulation> simulation, Scout::Make scout,
                           size_t budget_bytes)
    : replay_(replay),
      moments_(budget_bytes),
      player_(ReplayPlayer(replay, std::move(simulation), difference_), moments_) {
  if (scout) scout_ = std::make_unique<Scout>(replay, difference_, moments_, std::move(scout));
}

void ReplayViewer::seek(uint32_t tick) {
  tick = std::min(tick, replay_.ticks());
  if (!wish_ && tick == this->tick()) return;
  wish_ = tick;
  begun_ = this->tick();
  share_ = 0;
}

void ReplayViewer::seekBy(int64_t ticks) {
  seek(uint32_t(std::clamp<int64_t>(int64_t(wish()) + ticks, 0, replay_.ticks())));
}

float ReplayViewer::seekShare() const {
  return wish_ ? share_ : 1.0f;
}

// To the best moment there is for the wish, unless going on from here is as short.
void ReplayViewer::jump() {
  constexpr uint32_t kWorthIt_ticks = 16;
  const auto from = moments_.start(*wish_, kSparks_ticks);
  if (*wish_ >= tick() && from->tick() <= tick() + kWorthIt_ticks) return;
  if (*wish_ < tick()) begun_ = from->tick();
  player_.restore(*from);
}

bool ReplayViewer::work(double budget_ms) {
  constexpr uint32_t kLooks_ticks = 16;  // the scout may have come nearer meanwhile
  const double until_ms = now_ms() + budget_ms;
  for (uint32_t i = 0; wish_ && (i == 0 || now_ms() < until_ms); ++i) {
    if (i % kLooks_ticks == 0) jump();
    if (tick() < *wish_ && !player_.ended()) player_.playOne();
    const auto way = float(*wish_ - std::min(begun_, *wish_));
    share_ = std::max(share_, way > 0 ? float(tick() - std::min(begun_, tick())) / way : 1.0f);
    if (tick() == *wish_ || player_.ended()) wish_.reset();
  }
  furthest_ = std::max(furthest_, tick());
  return !wish_;
}

}  // namespace gw
