#include "game/app/app_services.h"

#include <cstdio>

namespace gw {

namespace {

WindowOptions windowOptions(const DesktopOptions& options, const Settings& settings) {
  WindowOptions window;
  window.size = {int(options.width_px), int(options.height_px)};
  window.fullscreen = options.fullscreen || settings.video.fullscreen;
  return window;
}

void configure(PlayerInput& input, const Settings& settings) {
  input.setBindings(settings.bindings);
  input.setDeadZones(settings.pad.moveDeadZone, settings.pad.aimDeadZone);
}

}  // namespace

AppServices::AppServices(const DesktopOptions& options, const Settings& settings, const std::filesystem::path& assets)
    : window(windowOptions(options, settings)),
      instruments(window.context()),
      view(assets, settings.effects),
      audio(assets, settings.sound, options.mute) {
  if (!pads.problem().empty()) std::fprintf(stderr, "%s\n", pads.problem().c_str());
  configure(input, settings);
}

void AppServices::apply(const Settings& settings) {
  configure(input, settings);
  view.setEffects(settings.effects);
  if (settings.video.fullscreen != window.fullscreen()) window.setFullscreen(settings.video.fullscreen);
  if (settings.sound.muted != audio.mutedByPlayer()) audio.setMuted(settings.sound.muted);
  audio.setVolumes(settings.sound);
}

void AppServices::beginRun(Run& run) {
  view.begin(run.simulation());
  instruments.forget();
  timestep = FixedTimestep();  // starts with the next frame: the time to load is not played
}

WorldPoint AppServices::pointerInWorld() const {
  return view.toWorld(input.pointer_x_px(), input.pointer_y_px(), window.eventArea());
}

}  // namespace gw
