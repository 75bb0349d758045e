// Colours of rows: neighbours differ so far that they are told apart.
#include "game/sim/draw/row_colour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace gw::test {
namespace {

// Of a colour 0xRRGGBB, in degrees.
double hueOf(uint32_t colour) {
  const double red = colour >> 16 & 255, green = colour >> 8 & 255, blue = colour & 255;
  const double high = std::max({red, green, blue}), span = high - std::min({red, green, blue});
  const double sextant = high == red     ? (green - blue) / span
                         : high == green ? 2 + (blue - red) / span
                                         : 4 + (red - green) / span;
  return std::fmod(60 * sextant + 360, 360);
}

double apart(uint32_t row, uint32_t other) {
  const double turn = std::fabs(hueOf(cpu::rowColour(row)) - hueOf(cpu::rowColour(other)));
  return std::min(turn, 360 - turn);
}

TEST(row_colour, of_neighbouring_rows_lie_far_apart) {
  for (uint32_t row = 0; row < 3000; ++row) {
    ASSERT_GT(apart(row, row + 1), 120) << row;
    ASSERT_GT(apart(row, row + 2), 75) << row;
    ASSERT_GT(apart(row, row + 3), 45) << row;
  }
}

TEST(row_colour, is_bright_and_coloured) {
  for (uint32_t row = 0; row < 3000; ++row) {
    const uint32_t colour = cpu::rowColour(row);
    const uint32_t channels[] = {colour >> 16 & 255, colour >> 8 & 255, colour & 255};
    ASSERT_EQ(colour >> 24, 0u);
    ASSERT_EQ(*std::max_element(std::begin(channels), std::end(channels)), 255u);
    ASSERT_EQ(*std::min_element(std::begin(channels), std::end(channels)), 56u);
  }
}

TEST(row_colour, of_a_hundred_rows_all_differ) {
  std::set<uint32_t> colours;
  for (uint32_t row = 0; row < 100; ++row) colours.insert(cpu::rowColour(row));
  EXPECT_EQ(colours.size(), 100u);
}

}  // namespace
}  // namespace gw::test
