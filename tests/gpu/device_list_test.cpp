#include "gpu/device_list.h"

#include <gtest/gtest.h>

namespace gw {
namespace {

TEST(DeviceList, NeverThrowsAndIsTheSameAgain) {
  DeviceList first, second;
  ASSERT_NO_THROW(first = listDevices());
  ASSERT_NO_THROW(second = listDevices());
  EXPECT_EQ(first.cudaMissing, second.cudaMissing);
  ASSERT_EQ(first.devices.size(), second.devices.size());
}

TEST(DeviceList, TheCpuComesLastAndIsAlwaysThere) {
  const DeviceList list = listDevices();
  ASSERT_FALSE(list.devices.empty());
  for (size_t i = 0; i + 1 < list.devices.size(); ++i) EXPECT_EQ(list.devices[i].kind, "cuda");
  EXPECT_EQ(list.devices.back().kind, "cpu");
  EXPECT_GE(std::stoi(list.devices.back().detail), 1);
  EXPECT_NE(list.devices.back().detail.find(" threads"), std::string::npos);
}

TEST(DeviceList, SaysInOneSentenceWhyCudaIsMissing) {
  const DeviceList list = listDevices();
  EXPECT_EQ(list.hasCuda(), list.devices.front().kind == "cuda");
  if (list.hasCuda()) {
    EXPECT_FALSE(list.devices.front().name.empty());
    EXPECT_EQ(list.devices.front().detail.rfind("sm_", 0), 0u);
    return;
  }
  ASSERT_FALSE(list.cudaMissing.empty());
  EXPECT_EQ(list.cudaMissing.back(), '.');
  EXPECT_EQ(list.cudaMissing.find('\n'), std::string::npos);
#ifdef GW_HAVE_CUDA
  EXPECT_EQ(list.cudaMissing.find("This build has no cuda device"), std::string::npos);
#else
  EXPECT_NE(list.cudaMissing.find("This build has no cuda device"), std::string::npos);
#endif
}

}  // namespace
}  // namespace gw
