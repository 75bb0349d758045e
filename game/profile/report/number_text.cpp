#include "game/profile/report/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/platform/number_format.h"

namespace gw::profile {

namespace {
constexpr int kDigits = 4;
}

std::string wholeText(double number) {
  return groupThousands(fmt::format("{:.0f}", number));
}

std::string figureText(double number) {
  if (!std::isfinite(number)) return "–";
  const double size = std::abs(number);
  if (number == std::round(number) && size < 1e15) return wholeText(number);
  if (size >= 1e15 || size < 1e-6) return fmt::format("{:.3e}", number);
  const int decimals = kDigits - 1 - int(std::floor(std::log10(size)));
  return decimals <= 0 ? wholeText(number) : fmt::format("{:.{}f}", number, std::min(decimals, 8));
}

std::string estimateText(const Estimate& estimate) {
  std::string text = figureText(estimate.value);
  if (!std::isfinite(estimate.low) || !std::isfinite(estimate.high)) return text;
  return text + " (" + figureText(estimate.low) + " to " + figureText(estimate.high) + ")";
}

std::string enemiesText(uint32_t count) {
  return wholeText(count) + (count == 1 ? " enemy" : " enemies");
}

std::string plural(uint64_t count, const char* noun) {
  return fmt::format("{} {}{}", wholeText(double(count)), noun, count == 1 ? "" : "s");
}

}  // namespace gw::profile
