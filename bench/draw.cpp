// How long a frame takes to draw without a display: gw_bench_draw [--out FILE] [--frames N]
//
// Prints a Markdown table of medians, at 1280x720, all sprites in view, every shape in equal parts: milliseconds
// from the first GL call of a frame until everything is drawn (glFinish), and milliseconds of processor time on all
// cores together. The second moves far less (about a fifth) when other programs want the cores too.
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <functional>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "bench/machine.h"
#include "host/platform/clock.h"
#include "render/gl_context_egl.h"
#include "render/grid_pass.h"
#include "render/particle_pass.h"
#include "render/sprite_pass.h"
#include "render/vertex_stream.h"

namespace gw {
namespace {

constexpr PixelSize kSize{1280, 720};
constexpr float kPixelsPerMetre = 18;  // the game's usual view, 40 m high
constexpr Camera kCamera{96, 54, float(kSize.width) / 2 / kPixelsPerMetre, float(kSize.height) / 2 / kPixelsPerMetre};

double median(std::vector<double> values) {
  const auto middle = values.begin() + ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// "passed / processor", in milliseconds.
std::string medianFrame(int frames, GlContext& context, const std::function<void()>& drawFrame) {
  constexpr int kWarmUp = 5;  // shaders are compiled for the state they are first used in
  std::vector<double> passed_ms, processor_ms;
  for (int i = -kWarmUp; i < frames; ++i) {
    const double start_ms = now_ms(), processorStart_s = processTime_s();
    context.bindTarget();
    drawFrame();
    context.swap();
    const double end_ms = now_ms();
    if (i < 0) continue;
    passed_ms.push_back(end_ms - start_ms);
    processor_ms.push_back(1e3 * (processTime_s() - processorStart_s));
  }
  char text[64];
  std::snprintf(text, sizeof text, "%.1f / %.1f", median(passed_ms), median(processor_ms));
  return text;
}

std::vector<SpriteVertex> sprites(uint32_t count, float diameter_px) {
  constexpr uint32_t kShapes = 10;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> side(-1, 1);
  std::vector<SpriteVertex> all;
  for (uint32_t i = 0; i < count; ++i) {
    const float x = kCamera.centre_x + side(random) * kCamera.halfWidth_m;
    const float y = kCamera.centre_y + side(random) * kCamera.halfHeight_m;
    all.push_back({x, y, x - .1f, y, side(random) * 3.14f, diameter_px / 2 / kPixelsPerMetre,
                   i % kShapes | 200u << 16 | 255u << 24, 0x40C0FFu + i * 7919u % 0xFFFFu});
  }
  return all;
}

// Streaks as a burst leaves them after a few ticks.
std::vector<ParticleVertex> particles(uint32_t count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> side(-1, 1);
  std::vector<ParticleVertex> all;
  for (uint32_t i = 0; i < count; ++i) {
    const float x = kCamera.centre_x + side(random) * kCamera.halfWidth_m;
    const float y = kCamera.centre_y + side(random) * kCamera.halfHeight_m;
    all.push_back({x, y, x + side(random), y + side(random), .1f, .8f, 0x40C0FFu + i * 7919u % 0xFFFFu});
  }
  return all;
}

std::string measure(int frames) {
  const auto context = makeEglContext(kSize);
  const std::filesystem::path assets = std::filesystem::path(GW_SOURCE_DIR) / "assets";
  SpritePass pass(assets);
  GridPass grid(assets);
  ParticlePass particlePass(assets);
  std::vector<GridBend> bends;
  for (int i = 0; i < kMaxGridBends; ++i) bends.push_back({kCamera.centre_x + float(i), kCamera.centre_y, 5, 4, .5f});
  const auto drawGrid = [&](float unrest, size_t bent = 0) {
    return [&grid, &bends, unrest, bent] {
      grid.draw({.camera = kCamera,
                 .target = kSize,
                 .time_s = 1,
                 .unrest = unrest,
                 .bends = std::span<const GridBend>(bends).first(bent)});
    };
  };

  std::ostringstream table;
  table << "# Drawing a frame\n\n"
        << "Medians of " << frames
        << " frames until glFinish, 1280x720, all sprites in view, every shape in equal parts: milliseconds passed / "
           "milliseconds of processor time on all cores together.\n\n"
        << machineLine() << " OpenGL: " << context->rendererName() << ". Command: `gw_bench_draw --frames " << frames
        << "`\n\n";
  table << "| what | ms |\n|---|---|\n| grid, calm | " << medianFrame(frames, *context, drawGrid(0))
        << " |\n| grid, torn | " << medianFrame(frames, *context, drawGrid(1)) << " |\n| grid, bent by one | "
        << medianFrame(frames, *context, drawGrid(0, 1)) << " |\n| grid, bent by all " << bends.size() << " | "
        << medianFrame(frames, *context, drawGrid(0, bends.size())) << " |\n";
  for (const uint32_t count : {512u, 3072u}) {
    MappedStream<ParticleVertex> stream(count);
    const std::vector<ParticleVertex> scene = particles(count);
    table << "| grid and " << count << " particles | " << medianFrame(frames, *context, [&] {
      drawGrid(0)();
      const ParticleRegion region = stream.begin();
      std::memcpy(region.vertices, scene.data(), scene.size() * sizeof(ParticleVertex));
      region.command->instanceCount = count;
      stream.written();
      particlePass.draw(region, {kCamera, kSize});
      stream.end();
    }) << " |\n";
  }
  table << '\n';
  table << "Grid and sprites, by glow:\n\n| sprites | across | off | low | high |\n|---|---|---|---|---|\n";
  for (const uint32_t count : {2048u, 8192u}) {
    VertexStream stream(count);
    for (const float diameter_px : {8.0f, 16.0f, 24.0f}) {
      const std::vector<SpriteVertex> scene = sprites(count, diameter_px);
      table << "| " << count << " | " << int(diameter_px) << " px |";
      for (const float glow : {kGlowOff, kGlowLow, kGlowHigh}) {
        table << ' ' << medianFrame(frames, *context, [&] {
          drawGrid(0)();
          const StreamRegion region = stream.begin();
          std::memcpy(region.vertices, scene.data(), scene.size() * sizeof(SpriteVertex));
          region.command->instanceCount = count;
          stream.written();
          pass.draw(region, {.camera = kCamera, .target = kSize, .glow = glow});
          stream.end();
        }) << " |";
      }
      table << '\n';
    }
  }
  return table.str();
}

int run(int count, char** words) {
  std::string out;
  int frames = 41;
  for (int i = 1; i + 1 < count; i += 2) {
    if (std::strcmp(words[i], "--out") == 0) out = words[i + 1];
    if (std::strcmp(words[i], "--frames") == 0) frames = std::atoi(words[i + 1]);
  }
  if (frames < 1) throw std::runtime_error("--frames needs a number of at least 1.");
  const std::string table = measure(frames);
  std::fputs(table.c_str(), stdout);
  if (out.empty()) return 0;
  std::ofstream file(out);
  file << table;
  if (!file.flush()) throw std::runtime_error("Cannot write " + out + ": choose a folder that exists.");
  return 0;
}

}  // namespace
}  // namespace gw

int main(int count, char** words) {
  try {
    return gw::run(count, words);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
