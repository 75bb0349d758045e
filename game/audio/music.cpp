#include "game/audio/music.h"

#include <algorithm>

namespace gw {

float musicLevel(Scene scene) {
  switch (scene) {
    case Scene::title:
    case Scene::play:
      return 1;
    case Scene::pause:
      return 0.3f;
    case Scene::over:
      return 0.5f;
  }
  return 1;
}

float effectsLevel(Scene scene) {
  return scene == Scene::title ? 0.2f : 1;
}

Stutter stutter(uint32_t tick, uint32_t frameTime_us, const Rules& rules) {
  const float start = float(rules.budget.start_us), limit = float(rules.budget.limit_us);
  const float way = std::clamp((float(frameTime_us) - start) / std::max(limit - start, 1.0f), 0.0f, 1.0f);
  constexpr float kFrom = 0.25f;
  if (way <= kFrom) return {};
  const float depth = (way - kFrom) / (1 - kFrom);  // 0 to 1
  const uint32_t period_ticks = uint32_t(56 - 40 * depth), gap_ticks = uint32_t(2 + 3 * depth);
  const bool gap = tick % period_ticks < gap_ticks;
  return {gap ? 1 - 0.4f - 0.5f * depth : 1, 1 - 0.03f * depth};
}

}  // namespace gw
