// Tests that need a CUDA device are skipped, and counted as such, where there is none.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>

#include "gpu/devices/device_list.h"

namespace gw::test {

class ParityTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!listDevices().hasCuda()) GTEST_SKIP() << "no CUDA device";
  }
};

// Where the rule tables are: --assets, GW_ASSETS, beside the program, or the source tree.
const std::filesystem::path& assetFolder();

}  // namespace gw::test
