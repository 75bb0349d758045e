// A replay that is being watched: plays on, and goes to any tick. A tick that was gone to is the one that plain
// playing gives, bit for bit, with the score, the effects and the sparks that belong to it.
//
// Going to a tick is work, and the window must not freeze while it is done: seek() says where to go, work() goes for
// so many milliseconds, and the window does its own things between.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>

#include "game/replay_viewer/keeping_player.h"
#include "game/replay_viewer/scout.h"

namespace gw {

class ReplayViewer {
 public:
  // No spark lives longer (game/sim/draw/particles.cu). They are no state, so a jump to a tick begins so much
  // before it, or as much as Moments::start() allows.
  static constexpr uint32_t kSparks_ticks = 60;

  // The replay must outlive this. `scout` makes a second game for the scout; none: there is no scout.
  ReplayViewer(const Replay& replay, std::unique_ptr<Simulation> simulation, Scout::Make scout,
               size_t budget_bytes = Moments::kBudget_bytes);

  // Goes there, as far as the run goes; a second wish takes the place of the first.
  void seek(uint32_t tick);
  // From where it is, or is going to.
  void seekBy(int64_t ticks);
  bool seeking() const { return wish_.has_value(); }
  uint32_t wish() const { return wish_.value_or(tick()); }
  float seekShare() const;  // 0 to 1, of the work to get there
  // Goes on with it for so long. True when it has arrived, or nothing was wished.
  bool work(double budget_ms);

  // One tick of plain playing.
  void playOne() { player_.playOne(); }

  uint32_t tick() const { return player_.tick(); }
  uint32_t ticks() const { return replay_.ticks(); }
  bool ended() const { return player_.ended(); }
  // How far moments reach; all that was played when nothing is left to do.
  uint32_t reach() const { return std::max(moments_.reach(), furthest_); }
  bool scouted() const { return !scout_ || scout_->done(); }
  std::optional<uint32_t> differsFrom() const { return difference_.tick(); }

  Run& run() { return player_.run(); }
  const Run& run() const { return player_.run(); }
  const Moments& moments() const { return moments_; }

 private:
  void jump();

  const Replay& replay_;
  FirstDifference difference_;
  Moments moments_;
  KeepingPlayer player_;
  std::optional<uint32_t> wish_;
  uint32_t begun_ = 0;  // where the way to the wish began
  float share_ = 0;
  uint32_t furthest_ = 0;
  std::unique_ptr<Scout> scout_;  // last: it uses the others
};

}  // namespace gw
