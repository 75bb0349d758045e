#include "game/ui/pause.h"

#include "game/ui/shape_icon.h"
#include "game/ui/theme.h"
#include "host/platform/number_format.h"

namespace gw {

using namespace theme;

void drawPause(Canvas& canvas, const Rules& rules, const PauseFrame& frame) {
  const float middle = canvas.width() / 2;
  canvas.nextLayer();
  canvas.rectangle(0, 0, canvas.width(), Canvas::kHeight, faded(kShade, 0.84f));
  canvas.nextLayer();
  canvas.text("PAUSED", middle, 206, style(48, kAccent, TextAlign::centre, 0.8f));

  if (frame.lostPad) {
    canvas.text("the controller is gone: connect it, or press ESC to go on with the keyboard", middle, 236,
                style(12, kDanger, TextAlign::centre, 0.3f));
  }
  float y = 268;
  const auto key = [&](const std::string& name, const char* does) {
    canvas.text(name, middle - 12, y, style(13, kGold, TextAlign::right, 0.3f));
    canvas.text(does, middle + 12, y, style(13, kText, TextAlign::left, 0.1f));
    y += 28;
  };
  key(frame.keys.pause, "resume");
  key(frame.keys.retry, "start again");
  key(frame.keys.settings, "settings");
  key(frame.keys.quit, "title");

  // The table of types, as the rules in use have it: what touching each costs, what processing it pays.
  y += 20;
  const float name = middle - 190, cost = middle + 70, value = middle + 190;
  canvas.text("TYPE", name + 26, y, style(9, kQuiet, TextAlign::left, 0));
  canvas.text("CONTACT", cost, y, style(9, kQuiet, TextAlign::right, 0));
  canvas.text("VALUE", value, y, style(9, kQuiet, TextAlign::right, 0));
  y += 8;
  canvas.rectangle(name, y, value - name, 1, faded(kQuiet, 0.5f));
  for (uint32_t i = 0; i < rules.enemyTypeCount; ++i) {
    y += 26;
    const EnemyRules& type = rules.enemies[i];
    const Rgba colour = rgbaOf(type.colour);
    drawShapeIcon(canvas, type.shape, name + 8, y - 5.5f, 8, colour);
    canvas.text(type.name, name + 26, y, style(12, colour, TextAlign::left, 0.3f));
    canvas.text(oneDecimal(type.contact_us / 1000.0) + " ms", cost, y, style(12, kText, TextAlign::right, 0));
    canvas.text(withCommas(type.value), value, y, style(12, kText, TextAlign::right, 0));
  }
}

}  // namespace gw
