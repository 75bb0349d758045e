// ngrid_order_*.png: entities at their places, coloured by row and the darker the further right their column is; rows
// as lines, and three columns in black.
#include <cstdio>
#include <stdexcept>

#include "bench/neighbours/pictures.h"

namespace gw::bench {
namespace {

using namespace gw::cpu;

constexpr uint32_t kFew = 336;  // that can be told apart in a picture

void drawOrder(const std::string& path, const TextFont& font, const Crowd<Cell>& crowd, KeptGrid& kept,
               const std::string& title) {
  const NDimensions d = kept.grid.dimensions();
  const std::vector<Cell> cells = kept.cells.download();
  Canvas canvas(kSize, font, kGround);
  const Look look{{0.5f * crowd.world[0], 0.5f * crowd.world[1]},
                  (float(kSize.height) - 2.0f * kBar_px - 8.0f) / crowd.world[1]};
  const auto lives = [&](uint32_t i) { return i < cells.size() && cells[i].x < kInfinity; };
  const auto colourOf = [&](uint32_t i) {
    const uint32_t shade = i % d.columns * 5 / d.columns;  // few colours make a small file
    return fromHue(0.8f * float(i / d.columns) / float(d.rows), 0.85f, 0.62f - 0.08f * float(shade));
  };
  for (uint32_t i = 0; i < cells.size(); ++i) {
    if ((i + 1) % d.columns && lives(i) && lives(i + 1)) {
      canvas.line(look(cells[i]), look(cells[i + 1]), 1.6f, colourOf(i));
    }
  }
  for (uint32_t i = 0; i + d.columns < cells.size(); ++i) {
    const bool shown = i % d.columns % (d.columns / 3) == d.columns / 6;  // three of them
    if (shown && lives(i) && lives(i + d.columns)) {
      canvas.line(look(cells[i]), look(cells[i + d.columns]), 2.4f, kInk);
    }
  }
  uint32_t misaligned = 0;
  for (uint32_t i = 0; i < cells.size(); ++i) {
    if (!lives(i)) continue;
    const bool out =
        (i % d.columns && cells[i].x < cells[i - 1].x) || (i >= d.columns && cells[i].y < cells[i - d.columns].y);
    misaligned += out;
    canvas.disc(look(cells[i]), 4.0f, colourOf(i));
    if (out) canvas.ring(look(cells[i]), 6.0f, 1.6f, kInk);
  }
  if (misaligned != kept.grid.upkeepReport(kept.queue, kept.cells.data()).misaligned) {
    throw std::logic_error("upkeepReport() counts other misaligned entities than are drawn");
  }
  drawBars(canvas, title);
  char legend[200];
  std::snprintf(legend, sizeof legend,
                "%u x %u cells; a colour is a row, darker to the right; black: three columns; ringed: out of order, %u",
                d.columns, d.rows, misaligned);
  canvas.text({8, float(kSize.height) - 8}, 9, legend, kInk);
  std::printf("%s: %s\n", path.c_str(), legend);
  canvas.save(path);
}

}  // namespace

void drawOrders(const std::string& folder, const TextFont& font) {
  Crowd<Cell> crowd(kFew, Distribution::uniform, 1);
  const NDimensions dimensions = chooseWindowDimensions(kFew, {crowd.world[0], crowd.world[1], 0.0f});
  KeptGrid rebuilt(crowd.byId, dimensions), settled(crowd.byId, dimensions);
  rebuilt.grid.rebuild(rebuilt.queue, rebuilt.cells.data(), rebuilt.cellOf.data());
  drawOrder(folder + "/ngrid_order_rebuild.png", font, crowd, rebuilt,
            "rebuild(): all by y, cut into rows, each row by x");
  settled.grid.sortUntilStable(settled.queue, settled.cells.data(), settled.cellOf.data());
  drawOrder(folder + "/ngrid_order_settle.png", font, crowd, settled,
            "sortUntilStable(): columns by y, rows by x, by turns until nothing moves");
  for (int frame = 0; frame < 100; ++frame) {
    crowd.step(0.1f);
    settled.move(crowd.byId);
    settled.grid.transpose(settled.queue, settled.cells.data(), settled.cellOf.data());
  }
  drawOrder(folder + "/ngrid_order_transpose.png", font, crowd, settled,
            "transpose(): the same after 100 frames, in each a motion of 0.1 radii");
}

}  // namespace gw::bench
