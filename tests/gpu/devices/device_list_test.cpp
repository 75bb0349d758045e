#include "gpu/devices/device_list.h"

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
  EXPECT_EQ(uint32_t(std::stoi(list.devices.back().detail)), list.processors.usable());
  EXPECT_NE(list.devices.back().detail.find(" thread"), std::string::npos);
  EXPECT_NE(list.devices.back().detail.find(list.processors.limits()), std::string::npos);
}

TEST(DeviceList, SaysInOneSentenceWhyCudaIsMissing) {
  const DeviceList list = listDevices();
  EXPECT_EQ(list.hasCuda(), list.cudaState == CudaState::ready);
  if (list.hasCuda()) return;
  ASSERT_FALSE(list.cudaMissing.empty());
  EXPECT_EQ(list.cudaMissing.back(), '.');
  EXPECT_EQ(list.cudaMissing.find('\n'), std::string::npos);
#ifdef GW_HAVE_CUDA
  EXPECT_NE(list.cudaState, CudaState::notBuilt);
  EXPECT_GE(list.runtimeVersion, 13000);
#else
  EXPECT_EQ(list.cudaState, CudaState::notBuilt);
  EXPECT_NE(list.cudaMissing.find("This build has no cuda device"), std::string::npos);
#endif
}

TEST(DeviceList, DescribesEveryCudaDevice) {
  const DeviceList list = listDevices();
  if (list.devices.front().kind != "cuda") GTEST_SKIP() << "no CUDA device";
  EXPECT_EQ(list.devices.front().problem.empty(), list.hasCuda());
  for (const DeviceInfo& device : list.devices) {
    if (device.kind != "cuda") continue;
    EXPECT_FALSE(device.name.empty());
    EXPECT_EQ(device.detail.rfind("sm_" + std::to_string(device.architecture), 0), 0u);
    EXPECT_GT(device.architecture, 0);
    EXPECT_GT(device.memory_MiB, 0u);
  }
  EXPECT_TRUE(currentCudaDevice().has_value());
}

TEST(DeviceList, TheCurrentCudaDeviceIsNoneWhereNoneAnswers) {
  const DeviceList list = listDevices();
  if (list.devices.front().kind == "cuda") GTEST_SKIP() << "a CUDA device answers";
  EXPECT_FALSE(currentCudaDevice().has_value());
}

}  // namespace
}  // namespace gw
