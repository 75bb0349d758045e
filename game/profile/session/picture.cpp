#include "game/profile/session/picture.h"

#include <stdexcept>

#include "game/ui/hud.h"
#include "game/ui/title.h"
#include "gpu/devices/device_list.h"
#include "host/platform/clock.h"
#include "host/platform/user_error.h"
#include "render/gl_context_egl.h"

namespace gw::profile {
Screen openOffscreen(PixelSize size, bool onCuda) {
  try {
    return {makeEglContext(size, onCuda ? currentCudaDevice() : std::nullopt), {}, "offscreen"};
  } catch (const std::runtime_error& error) {
    throw UserError(ExitCode::failedRun, error.what());
  }
}

Picture::Picture(Screen& screen, const std::filesystem::path& assets, const Look& look)
    : screen_(screen), renderer_(assets), look_(look) {
  for (GlQuery& query : queries_) query = makeGlQuery(GL_TIME_ELAPSED);
  // The first query of a context counts from the start of the machine on llvmpipe (Mesa 22 to 26): one for nothing.
  screen.context->bindTarget();
  glBeginQuery(GL_TIME_ELAPSED, queries_[0].get());
  glClear(GL_COLOR_BUFFER_BIT);
  glEndQuery(GL_TIME_ELAPSED);
  GLuint64 unused_ns = 0;
  glGetQueryObjectui64v(queries_[0].get(), GL_QUERY_RESULT, &unused_ns);
}

void Picture::begin(Run& run) {
  camera_.emplace(run.simulation().worldWidth_m(), run.simulation().worldHeight_m());
  while (takeGlTime_ms(true)) {
  }
}

void Picture::follow(Run& run, float alpha, float passed_s) {
  const PixelSize size = screen_.context->size();
  const float aspect = float(size.width) / float(size.height);
  const float width = run.simulation().worldWidth_m(), height = run.simulation().worldHeight_m();
  if (look_.wholeWorld) {
    camera_->place({width / 2, height / 2, std::max(height, width / aspect)}, aspect);
  } else if (run.last().tick <= 1) {
    camera_->snap(cameraTarget(run.last(), alpha), aspect);
  } else {
    camera_->follow(cameraTarget(run.last(), alpha), aspect, passed_s);
  }
}

PictureCost Picture::draw(Run& run, const Rules& rules, float alpha, float passed_s, bool title, bool timed) {
  const double begin = now_ms();
  follow(run, alpha, passed_s);
  screen_.context->bindTarget();
  WorldFrame frame{screen_.context->size(), alpha};
  if (!look_.effects) {
    frame.effects = {.shake = 0, .flash = 0, .particles = false, .gridBending = false, .scorePops = false};
  }
  frame.effects.glow = look_.glow;
  if (title) frame.brightness = 0.8f;
  timed = timed && asked_ - answered_ < kQueries;
  if (timed) glBeginQuery(GL_TIME_ELAPSED, queries_[asked_++ % kQueries].get());
  renderer_.draw(run, rules, *camera_, frame, [&](Canvas& canvas) {
    if (title) {
      drawTitle(canvas,
                {double(run.last().tick) / kTicksPerSecond, run.simulation().deviceName(), 0, Mode::arcade, "", {}});
    } else {
      drawHud(canvas, run.monitor(), rules, {});
    }
  });
  if (timed) glEndQuery(GL_TIME_ELAPSED);
  const double drawn = now_ms();
  screen_.context->swap();
  return {drawn - begin, now_ms() - drawn, timed};
}

std::optional<double> Picture::takeGlTime_ms(bool wait) {
  if (answered_ == asked_) return std::nullopt;
  const GLuint query = queries_[answered_ % kQueries].get();
  GLint ready = 0;
  glGetQueryObjectiv(query, GL_QUERY_RESULT_AVAILABLE, &ready);
  if (!ready && !wait) return std::nullopt;
  GLuint64 took_ns = 0;
  glGetQueryObjectui64v(query, GL_QUERY_RESULT, &took_ns);
  ++answered_;
  return double(took_ns) * 1e-6;
}

}  // namespace gw::profile
