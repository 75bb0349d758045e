// Reports that were not measured, for tests of what is made from them.
#pragma once

#include "game/profile/metrics/report.h"

namespace gw::profile::test {

// Three contenders and one in shadow, at 1,024, 4,096 and 16,384 enemies, with figures as a session would find them.
Report sampleReport();

// Names that are markup, bytes that are no text, values that are no numbers, and curves of a single point.
Report hostileReport();

// Doubles of any bits; every list of random length.
Report randomReport(uint32_t seed);

}  // namespace gw::profile::test
