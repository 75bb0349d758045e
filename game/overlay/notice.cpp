#include "game/overlay/notice.h"

#include <algorithm>
#include <utility>

#include "game/ui/theme.h"

namespace gw {

void Notice::say(std::string text, double now_s) {
  text_ = std::move(text);
  until_s_ = now_s + kShown_s;
}

void Notice::draw(Canvas& canvas, double now_s) const {
  constexpr float kBaseline = 640, kSize = 13, kFades_s = 0.4f;
  if (text_.empty() || now_s >= until_s_) return;
  const float alpha = std::min(float(until_s_ - now_s) / kFades_s, 1.0f), middle = canvas.width() / 2;
  const float natural = canvas.textWidth(text_, kSize), room = canvas.width() - 2 * theme::kMargin;
  const float size = kSize * std::min(1.0f, room / std::max(natural, 1.0f)), width = canvas.textWidth(text_, size) + 28;
  canvas.nextLayer();
  canvas.rectangle(middle - width / 2, kBaseline - 20, width, 30, theme::faded(theme::kShade, 0.8f * alpha));
  canvas.text(text_, middle, kBaseline,
              theme::style(size, theme::faded(theme::kAccent, alpha), TextAlign::centre, 0.3f));
}

}  // namespace gw
