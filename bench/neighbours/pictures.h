// What the pictures for docs/design/ngrid.md have in common.
#pragma once

#include <string>
#include <vector>

#include "bench/neighbours/canvas.h"
#include "bench/neighbours/crowd.h"
#include "gpu/ngrid/ngrid.h"

namespace gw::bench {

inline constexpr PixelSize kSize{640, 400};
inline constexpr float kBar_px = 24.0f;  // a title above, a legend below
inline constexpr Colour kGround{1, 1, 1}, kInk{0.13f, 0.13f, 0.16f}, kPale{0.80f, 0.80f, 0.83f};

// From metres to pixels, y up.
struct Look {
  Float2 middle;
  float pixelsPerMetre;
  Float2 operator()(float x, float y) const {
    return {0.5f * float(kSize.width) + (x - middle.x) * pixelsPerMetre,
            0.5f * float(kSize.height) - (y - middle.y) * pixelsPerMetre};
  }
  Float2 operator()(const Cell& cell) const { return (*this)(cell.x, cell.y); }
};

// Over whatever reaches into them.
inline void drawBars(Canvas& canvas, const std::string& title) {
  const float width = float(kSize.width), height = float(kSize.height);
  canvas.rectangle({0, 0}, {width, kBar_px}, kGround);
  canvas.rectangle({0, height - kBar_px}, {width, height}, kGround);
  canvas.text({8, kBar_px - 8}, 9, title, kInk);
}

// The grid and what it stands on.
struct KeptGrid {
  cpu::Queue queue{ExecOptions{1}};
  cpu::NGrid<Cell> grid;
  cpu::Buffer<Cell> cells;
  cpu::Buffer<uint32_t> cellOf;

  KeptGrid(const std::vector<Cell>& byId, cpu::NDimensions dimensions, cpu::Kept kept = cpu::Kept::inPlace)
      : grid(queue, dimensions, kept), cells(queue, dimensions.cells()), cellOf(queue, dimensions.cells()) {
    cells.upload(cpu::padded(byId, dimensions));
  }
  void move(const std::vector<Cell>& byId) {
    std::vector<Cell> now = cells.download();
    for (Cell& cell : now) {
      if (cell.id < byId.size()) cell = byId[cell.id];
    }
    cells.upload(now);
  }
};

// The three orders.
void drawOrders(const std::string& folder, const TextFont& font);

// The four searches around one entity.
void drawGathers(const std::string& folder, const TextFont& font);

}  // namespace gw::bench
