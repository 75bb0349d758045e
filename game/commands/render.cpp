// gpuwars render FILE --out OUT: pictures or a film of a run. Every tick's hash is compared on the way.
#include <fmt/format.h>

#include <cstdio>

#include "game/cli/render_options.h"
#include "game/commands/progress.h"
#include "game/replay_viewer/replay_player.h"
#include "game/session/device_choice.h"
#include "game/session/replay_file.h"
#include "game/ui/hud.h"
#include "game/view/frame_times.h"
#include "game/view/offscreen_renderer.h"
#include "host/platform/asset_folder.h"
#include "host/platform/clock.h"
#include "host/platform/interrupt.h"
#include "host/platform/number_format.h"
#include "host/platform/user_error.h"
#include "host/video/frame_sink.h"

namespace gw {

namespace {

FrameRange rangeOf(const RenderOptions& options, const Replay& replay) {
  FrameRange range;
  range.framesPerSecond = options.framesPerSecond;
  range.from = tickInside(options.file, "--from", options.fromTick.value_or(1), replay);
  range.to = options.toTick ? tickInside(options.file, "--to", options.toTick, replay) : replay.ticks();
  if (!isOnePicture(options.outPath)) return range;
  if (!options.toTick && options.fromTick) range.to = range.from;
  range.from = range.to;
  range.framesPerSecond = kTicksPerSecond;
  return range;
}

// The camera lives from the first tick on and moves by ticks, so that a tick's picture is the same wherever a film
// begins.
class Filming {
 public:
  Filming(const RenderOptions& options, const SimulationConfig& config, Run& run)
      : config_(config),
        run_(run),
        maker_({int(options.width_px), int(options.height_px)}, findAssetFolder(options.assetsDir), run.simulation()),
        camera_(run.simulation().worldWidth_m(), run.simulation().worldHeight_m()),
        hud_(options.hud) {}

  // After each tick. Hands its frames to the sink.
  uint64_t take(const FrameRange& range, FrameSink& sink) {
    const FollowCamera before = camera_;
    follow(camera_, 1);
    uint64_t frames = 0;
    for (const float share : framesOf(run_.last().tick, range)) {
      FollowCamera camera = share < 1 ? before : camera_;
      if (share < 1) follow(camera, share);
      sink.add(maker_.draw(run_, config_.rules, camera, share, [this](Canvas& canvas) { drawScreens(canvas); }));
      ++frames;
    }
    return frames;
  }

 private:
  void follow(FollowCamera& camera, float share) const {
    const FollowCamera::Target target = cameraTarget(run_.last(), share);
    if (run_.last().tick <= 1) {
      camera.snap(target, maker_.aspect());
    } else {
      camera.follow(target, maker_.aspect(), share * kTick_s);
    }
  }

  void drawScreens(Canvas& canvas) const {
    if (!hud_) return;
    HudFrame hud;  // a picture has no frame rate
    hud.mode = config_.mode;
    hud.enemies = config_.enemies;
    drawHud(canvas, run_.monitor(), config_.rules, hud);
  }

  const SimulationConfig& config_;
  Run& run_;
  OffscreenRenderer maker_;
  FollowCamera camera_;
  bool hud_;
};

}  // namespace

ExitCode runVerb(const RenderOptions& options) {
  catchInterrupts();
  const std::string file = options.file.string();
  const Replay replay = readWatched(options.file);
  SimulationConfig config = replayConfig(replay);
  setComputingOf(config, options, file);
  config.particles = true;
  const FrameRange range = rangeOf(options, replay);
  const PixelSize size{int(options.width_px), int(options.height_px)};
  const DeviceChoice device = chooseDevice(options.device);

  FirstDifference difference;
  ReplayPlayer player(replay, makeLastingSimulation(device, config), difference);
  Filming filming(options, config, player.run());
  const std::unique_ptr<FrameSink> sink = openFrameSink(options.outPath, size, range.framesPerSecond);

  const double start_s = now_s();
  uint64_t frames = 0;
  {
    Progress progress("tick", range.to);
    while (player.tick() < range.to && !player.ended() && !interrupted()) {
      player.playOne();
      frames += filming.take(range, *sink);
      progress.show(player.tick());
    }
  }
  sink->finish();
  const double seconds = now_s() - start_s;

  std::printf("%s: %s of %s %s, %ux%u, ticks %u to %u, in %s s\n", options.outPath.c_str(), withCommas(frames).c_str(),
              withCommas(frameCount(range)).c_str(), range.from == range.to ? "picture" : "frames", options.width_px,
              options.height_px, range.from, range.to, oneDecimal(seconds).c_str());
  if (const auto differs = difference.tick()) {
    throw UserError(ExitCode::desync,
                    fmt::format("{} differs from tick {} on, and so does what was drawn: find out more "
                                "with 'gpuwars verify'.",
                                file, *differs));
  }
  if (frames < frameCount(range)) {
    throw UserError(ExitCode::failedRun,
                    fmt::format("Interrupted at tick {}: what was made up to there is whole, and a "
                                "new run of the same command makes the rest too.",
                                player.tick()));
  }
  return ExitCode::fine;
}

}  // namespace gw
