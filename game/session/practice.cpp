#include "game/session/practice.h"

#include <algorithm>
#include <iterator>

namespace gw {

namespace {
constexpr uint32_t kCounts = uint32_t(std::size(kPracticeCounts));
}

std::optional<PracticeRequest> requestIn(const InputRecord& record, uint32_t typeCount) {
  const uint32_t type = record.buttons >> kSpawnTypeShift & kSpawnTypeMask;
  const uint32_t number = record.buttons >> kSpawnCountShift & kSpawnCountMask;
  if (!(record.buttons & kButtonSpawn) || type >= typeCount || number >= kCounts) return std::nullopt;
  return PracticeRequest{type, kPracticeCounts[number]};
}

void Practice::press(const PracticePresses& presses) {
  if (presses.number > 0 && presses.number <= typeCount_) type_ = presses.number - 1;
  if (typeCount_ > 0) type_ = (type_ + uint32_t(presses.nextType)) % typeCount_;
  number_ = uint32_t(std::clamp(int(number_) + presses.more, 0, int(kCounts) - 1));
  slow_ ^= presses.slowMotion % 2 != 0;
  const auto ask = [&](uint16_t bits, int times) {
    for (; times > 0 && waiting_.size() < kMostWaiting; --times) waiting_.push_back(bits);
  };
  ask(kButtonClear, presses.clear);
  ask(uint16_t(kButtonSpawn | type_ << kSpawnTypeShift | number_ << kSpawnCountShift), presses.spawn);
}

uint16_t Practice::takeButtons() {
  constexpr uint16_t kPresses = kButtonSpawn | kButtonClear;
  if (waiting_.empty() || (waiting_.front() & last_ & kPresses) != 0) return last_ = 0;
  last_ = waiting_.front();
  waiting_.pop_front();
  return last_;
}

}  // namespace gw
