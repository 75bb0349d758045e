// A frame of a run: an effect that is switched off leaves nothing behind.
#include <algorithm>

#include "game/session/failover.h"
#include "game/tables/tables.h"
#include "game/view/world_renderer.h"
#include "render/screenshot.h"
#include "tests/render/gl_fixture.h"

namespace gw {
namespace {

using GameRun = Run;  // within a test, Run is the test framework's

constexpr uint32_t kTicks = 700;  // the expert has killed some, and is flying

class WorldRendererGl : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    config_.rules = loadRules(readRuleTexts(kAssets));
    config_.seed = 7;
    config_.enemies = 1024;
    config_.autopilot = Autopilot::expert;
    run_ = runWith(true);
    view_ = std::make_unique<WorldRenderer>(kAssets);
  }

  // Stops in a tick in which something was just killed.
  std::unique_ptr<GameRun> runWith(bool particles) {
    config_.particles = particles;
    auto run = std::make_unique<GameRun>(cpu::makeSimulation(config_), std::nullopt);
    while (run->last().tick < kTicks || run->last().pops[0].points + run->last().pops[1].points == 0) run->tick({});
    return run;
  }

  // No input, and the flush has just begun.
  std::unique_ptr<GameRun> runAfterFlush() {
    auto run = std::make_unique<GameRun>(cpu::makeSimulation(config_), std::nullopt);
    for (int t = 0; t < 60; ++t) run->tick({});
    for (int t = 0; t < 3; ++t) run->tick({0, 0, 0, kButtonFlush});
    return run;
  }

  Image draw(GameRun& run, const Settings::Effects& effects) {
    FollowCamera camera(run.simulation().worldWidth_m(), run.simulation().worldHeight_m());
    camera.snap(cameraTarget(run.last(), 1), float(kSize.width) / float(kSize.height));
    WorldFrame frame{kSize};
    frame.effects = effects;
    view_->draw(run, config_.rules, camera, frame, [](Canvas&) {});
    view_camera_ = camera.view();
    return readPixels(kSize);
  }

  static Settings::Effects none() {
    return {.shake = 0, .flash = 0, .particles = false, .gridBending = false, .scorePops = false};
  }

  SimulationConfig config_;
  std::unique_ptr<GameRun> run_;
  std::unique_ptr<WorldRenderer> view_;
  Camera view_camera_;
};

TEST_F(WorldRendererGl, WithoutEffectsItIsBackgroundAndSprites) {
  const Image off = draw(*run_, none());
  ASSERT_EQ(run_->last().flushRadius_m, 0);  // no rings in this picture
  ASSERT_EQ(run_->last().contacts, 0u);

  GridPass grid(kAssets);
  grid.draw({.camera = view_camera_,
             .target = kSize,
             .worldWidth_m = run_->simulation().worldWidth_m(),
             .worldHeight_m = run_->simulation().worldHeight_m(),
             .time_s = (float(run_->last().tick) + 1) * kTick_s});
  VertexStream stream(run_->simulation().capacity() + 1);
  const StreamRegion region = stream.begin();
  run_->simulation().drawList(
      {view_camera_.centre_x, view_camera_.centre_y, view_camera_.halfWidth_m + 3, view_camera_.halfHeight_m + 3},
      {region.vertices, region.capacity, region.command});
  stream.written();
  SpritePass sprites(kAssets);
  sprites.draw(region,
               {.camera = view_camera_, .target = kSize, .tick = float(run_->last().tick) + 1, .flashes = false});
  stream.end();
  EXPECT_EQ(off.rgb, readPixels(kSize).rgb);
}

TEST_F(WorldRendererGl, EveryEffectIsSeenAndCanBeTurnedOff) {
  const Image off = draw(*run_, none());
  const auto only = [](auto set) {
    Settings::Effects effects = none();
    set(effects);
    return effects;
  };
  EXPECT_NE(draw(*run_, only([](auto& e) { e.particles = true; })).rgb, off.rgb);
  EXPECT_NE(draw(*run_, only([](auto& e) { e.gridBending = true; })).rgb, off.rgb);
  EXPECT_NE(draw(*run_, only([](auto& e) { e.scorePops = true; })).rgb, off.rgb);
  EXPECT_EQ(draw(*run_, none()).rgb, off.rgb);
}

TEST_F(WorldRendererGl, ParticlesSwitchedOffLookAsIfThereWereNone) {
  const auto without = runWith(false);
  ASSERT_EQ(without->last().hash, run_->last().hash);
  Settings::Effects effects;
  effects.particles = false;
  const Image off = draw(*run_, effects);
  EXPECT_EQ(draw(*without, effects).rgb, off.rgb);
  EXPECT_EQ(draw(*without, {}).rgb, off.rgb);  // a run that makes none has none to show
}

TEST_F(WorldRendererGl, ShakeAndFlashOfAFlushCanBeTurnedOff) {
  config_.autopilot = Autopilot::none;
  run_ = runAfterFlush();
  const auto with = [&](float shake, float flash) {
    Settings::Effects effects = none();
    effects.shake = shake;
    effects.flash = flash;
    return draw(*run_, effects).rgb;
  };
  const auto off = with(0, 0);
  EXPECT_NE(with(1, 0), off);
  EXPECT_NE(with(0, 1), off);
  EXPECT_EQ(with(0, 0), off);
}

// A device that fails to write draw lists, at first or later, until it is dropped.
class BlindDevice final : public Failover {
 public:
  BlindDevice(const SimulationConfig& config, uint32_t blindAfter)
      : Failover(
            cpu::makeSimulation(config), [config] { return cpu::makeSimulation(config); }, [](const std::string&) {}),
        blindAfter_(blindAfter) {}
  void drawList(const DrawView& view, const DrawTarget& target) override {
    if (dropped().empty() && drawn_++ == blindAfter_) throw DeviceError("cannot draw");
    Failover::drawList(view, target);
  }

 private:
  uint32_t drawn_ = 0, blindAfter_;
};

TEST_F(WorldRendererGl, ADeviceThatFailsToDrawIsDroppedAndThePictureDrawnAllTheSame) {
  for (const uint32_t after : {0u, 1u}) {
    GameRun healthy(cpu::makeSimulation(config_), std::nullopt);
    GameRun blind(std::make_unique<BlindDevice>(config_, after), std::nullopt);
    for (uint32_t t = 0; t < 40; ++t) {
      healthy.tick({});
      blind.tick({});
    }
    Settings::Effects effects;
    effects.particles = false;  // the next device has thrown none yet
    const Image expected = draw(healthy, effects);
    for (int frame = 0; frame < 3; ++frame) EXPECT_EQ(draw(blind, effects).rgb, expected.rgb);
    EXPECT_EQ(blind.simulation().dropped(), "cannot draw");
  }
}

}  // namespace
}  // namespace gw
