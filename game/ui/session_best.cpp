#include "game/ui/session_best.h"

#include "game/ui/tick_text.h"
#include "host/platform/number_format.h"

namespace gw {

bool beats(Mode mode, const TickReport& report, const Best& best) {
  if (mode == Mode::practice) return false;
  if (mode == Mode::swarm) {
    return report.ending == Ending::cleared && (best.cleared_ticks == 0 || report.tick < best.cleared_ticks);
  }
  return report.score > best.score;
}

std::string bestText(Mode mode, const Best& best) {
  if (mode == Mode::swarm) return best.cleared_ticks > 0 ? minutesTenths(best.cleared_ticks) : "";
  return best.score > 0 ? withCommas(best.score) : "";
}

void SessionBest::enter(Mode mode, const TickReport& report) {
  if (beats(mode, report, of(mode))) best_[uint32_t(mode)] = {report.score, report.tick};
}

}  // namespace gw
