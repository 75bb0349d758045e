// Kernels that nvcc compiled, launched as nvcc's own host code does, on the PTX machine.
#include <cuda_runtime_api.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "tests/fake_cuda/stand_in.h"
#include "tests/ptx_machine/runtime/ptx_device.h"
#include "tests/ptx_machine/runtime/test_kernels.h"

namespace gw::ptx {
namespace {

template <class T>
T* allocated(size_t count) {
  void* pointer = nullptr;
  EXPECT_EQ(cudaMalloc(&pointer, count * sizeof(T)), cudaSuccess);
  return static_cast<T*>(pointer);
}

template <class T>
T* uploaded(const std::vector<T>& values) {
  T* pointer = allocated<T>(values.size());
  EXPECT_EQ(cudaMemcpy(pointer, values.data(), values.size() * sizeof(T), cudaMemcpyHostToDevice), cudaSuccess);
  return pointer;
}

template <class T>
std::vector<T> downloaded(const T* pointer, size_t count) {
  std::vector<T> values(count);
  EXPECT_EQ(cudaMemcpy(values.data(), pointer, count * sizeof(T), cudaMemcpyDeviceToHost), cudaSuccess);
  return values;
}

const std::vector<Fault>& foundFaults() {
  return device().memory->faults();
}

class Runtime : public testing::Test {
 protected:
  void SetUp() override {
    stand_in::restart({});
    ASSERT_EQ(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), cudaSuccess);
  }
  void TearDown() override { stand_in::restart({}); }

  cudaStream_t stream = nullptr;
};

constexpr Mixed kMixed{'x', 0.25, {1, 2, 3}};

std::vector<float> expectedMixed(const std::vector<float>& in, char small, float factor) {
  std::vector<float> out;
  for (const float x : in) out.push_back(x * factor + 0.25f + float(small) + 3);
  return out;
}

std::vector<float> someFloats() {
  std::vector<float> values(200);
  std::iota(values.begin(), values.end(), -100.0f);
  return values;
}

TEST_F(Runtime, ArgumentsOfAllSizesArrive) {
  const std::vector<float> in = someFloats();
  const float* d_in = uploaded(in);
  float* d_out = allocated<float>(in.size());
  launchMixed(d_out, d_in, -3, kMixed, uint32_t(in.size()), 2, stream);
  ASSERT_EQ(cudaStreamSynchronize(stream), cudaSuccess);
  EXPECT_EQ(downloaded(d_out, in.size()), expectedMixed(in, -3, 2));
  ASSERT_EQ(launchMixedEx(d_out, d_in, 5, kMixed, uint32_t(in.size()), 0.5f, stream), cudaSuccess);
  ASSERT_EQ(cudaStreamSynchronize(stream), cudaSuccess);
  EXPECT_EQ(downloaded(d_out, in.size()), expectedMixed(in, 5, 0.5f));
  EXPECT_EQ(stand_in::kernelsRun(), 2u);
  EXPECT_TRUE(foundFaults().empty());
}

TEST_F(Runtime, AGraphReplaysItsKernels) {
  const std::vector<float> in = someFloats();
  float* d_values = uploaded(in);
  cudaGraph_t graph = nullptr;
  cudaGraphExec_t executable = nullptr;
  ASSERT_EQ(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal), cudaSuccess);
  ASSERT_EQ(launchMixedEx(d_values, d_values, 0, {0, 1, {}}, uint32_t(in.size()), 1, stream), cudaSuccess);
  ASSERT_EQ(cudaStreamEndCapture(stream, &graph), cudaSuccess);
  ASSERT_EQ(cudaGraphInstantiate(&executable, graph, 0), cudaSuccess);
  for (int i = 0; i < 3; ++i) ASSERT_EQ(cudaGraphLaunch(executable, stream), cudaSuccess);
  EXPECT_EQ(stand_in::kernelsRun(), 0u) << "work is done when it is waited for";
  ASSERT_EQ(cudaStreamSynchronize(stream), cudaSuccess);
  std::vector<float> expected = in;
  for (float& value : expected) value += 3;
  EXPECT_EQ(downloaded(d_values, in.size()), expected);
  EXPECT_EQ(stand_in::kernelsRun(), 3u);
  cudaGraphExecDestroy(executable);
  cudaGraphDestroy(graph);
}

TEST_F(Runtime, StaticAndDynamicSharedMemoryStandApart) {
  uint32_t* d_out = allocated<uint32_t>(3);
  for (const uint32_t threads : {1u, 31u, 64u, 1000u}) {
    ASSERT_EQ(launchSums(d_out, 3, threads, threads * sizeof(uint32_t), stream), cudaSuccess);
    ASSERT_EQ(cudaStreamSynchronize(stream), cudaSuccess);
    EXPECT_EQ(downloaded(d_out, 3), std::vector<uint32_t>(3, threads * (threads - 1) / 2)) << threads;
  }
  EXPECT_TRUE(foundFaults().empty());
}

TEST_F(Runtime, GridsHaveThreeDimensions) {
  constexpr uint32_t kWidth = 6, kHeight = 10, kDepth = 3;
  uint32_t* d_out = allocated<uint32_t>(kWidth * kHeight * kDepth);
  ASSERT_EQ(launchPlaces(d_out, dim3(2, 2, 1), dim3(3, 5, 3), stream), cudaSuccess);
  ASSERT_EQ(cudaStreamSynchronize(stream), cudaSuccess);
  const std::vector<uint32_t> places = downloaded(d_out, kWidth * kHeight * kDepth);
  for (uint32_t i = 0; i < places.size(); ++i) {
    EXPECT_EQ(places[i], i % kWidth + 100 * (i / kWidth % kHeight) + 10000 * (i / kWidth / kHeight));
  }
}

TEST_F(Runtime, AKernelWritesPinnedMemory) {
  uint32_t* h_out = nullptr;
  ASSERT_EQ(cudaMallocHost(reinterpret_cast<void**>(&h_out), 4 * sizeof(uint32_t)), cudaSuccess);
  ASSERT_EQ(launchSums(h_out, 4, 32, 32 * sizeof(uint32_t), stream), cudaSuccess);
  ASSERT_EQ(cudaStreamSynchronize(stream), cudaSuccess);
  EXPECT_EQ(std::vector<uint32_t>(h_out, h_out + 4), std::vector<uint32_t>(4, 496));
  EXPECT_TRUE(foundFaults().empty());
  EXPECT_EQ(cudaFree(h_out), cudaErrorInvalidValue) << "it is not the device's";
  EXPECT_EQ(cudaFreeHost(h_out), cudaSuccess);
}

TEST_F(Runtime, VariablesOfAModuleKeepTheirValues) {
  uint32_t* d_out = allocated<uint32_t>(1);
  for (uint32_t expected = 41; expected < 44; ++expected) {
    ASSERT_EQ(launchCounter(d_out, stream), cudaSuccess);
    ASSERT_EQ(cudaStreamSynchronize(stream), cudaSuccess);
    EXPECT_EQ(downloaded(d_out, 1).front(), expected);
  }
  EXPECT_TRUE(foundFaults().empty());
}

TEST_F(Runtime, RefusesWhatCudaRefuses) {
  uint32_t* d_out = allocated<uint32_t>(8);
  EXPECT_EQ(launchSums(d_out, 1, 1025, 8192, stream), cudaErrorInvalidConfiguration);
  EXPECT_EQ(launchSums(d_out, 0, 32, 128, stream), cudaErrorInvalidConfiguration);
  EXPECT_EQ(launchSums(d_out, 1, 32, 48 * 1024, stream), cudaErrorInvalidConfiguration) << "with the static part";
  EXPECT_EQ(cudaFuncSetAttribute(sumsStub(), cudaFuncAttributeMaxDynamicSharedMemorySize, 64 * 1024), cudaSuccess);
  EXPECT_EQ(launchSums(d_out, 1, 32, 48 * 1024, stream), cudaSuccess);
  EXPECT_EQ(cudaFuncSetAttribute(d_out, cudaFuncAttributeMaxDynamicSharedMemorySize, 1),
            cudaErrorInvalidDeviceFunction);
  cudaFuncAttributes attributes{};
  ASSERT_EQ(cudaFuncGetAttributes(&attributes, sumsStub()), cudaSuccess);
  EXPECT_EQ(attributes.sharedSizeBytes, sizeof(uint32_t));
  EXPECT_EQ(cudaMemcpy(d_out, attributes.reserved, 9 * sizeof(uint32_t), cudaMemcpyHostToDevice), cudaErrorInvalidValue)
      << "past the allocation";
  EXPECT_EQ(cudaFree(d_out + 1), cudaErrorInvalidValue);
}

TEST_F(Runtime, AnInjectedFaultStrikesALaunch) {
  stand_in::restart({.fault = {"cudaLaunchKernelEx", 2, cudaErrorLaunchFailure}});
  uint32_t* d_out = allocated<uint32_t>(1);
  EXPECT_EQ(launchCounter(d_out, nullptr), cudaSuccess);
  EXPECT_EQ(launchCounter(d_out, nullptr), cudaErrorLaunchFailure);
  EXPECT_EQ(cudaFree(d_out), cudaErrorLaunchFailure) << "it is sticky";
}

TEST_F(Runtime, AFaultIsReportedWithTheAllocationsOrigin) {
  uint32_t* d_out = allocateWords(100);
  testing::internal::CaptureStderr();
  ASSERT_EQ(launchOffByOne(d_out, 100, stream), cudaSuccess);
  EXPECT_EQ(cudaStreamSynchronize(stream), cudaSuccess) << "a run goes on";
  const std::string said = testing::internal::GetCapturedStderr();
  ASSERT_EQ(foundFaults().size(), 1u) << said;
  EXPECT_NE(said.find("offByOneKernel"), std::string::npos) << said;
  EXPECT_NE(said.find("test_kernels.cu"), std::string::npos) << said;
  EXPECT_NE(said.find("(400 bytes)"), std::string::npos) << said;
  EXPECT_NE(said.find("made by gw::ptx::allocateWords"), std::string::npos) << said;
  std::vector<uint32_t> expected(100);
  std::iota(expected.begin(), expected.end(), 0u);
  EXPECT_EQ(downloaded(d_out, 100), expected);
  forgetFaults();
}

// In processes of their own, since it is about how they end.
void runOffByOneAndExit(const char* options) {
  setenv("GW_PTX_MACHINE", options, 1);
  stand_in::restart(stand_in::optionsFromEnvironment());
  uint32_t* d_out = allocated<uint32_t>(100);
  launchOffByOne(d_out, 100, nullptr);
  std::exit(cudaDeviceSynchronize() == cudaErrorLaunchFailure ? 40 : 0);
}

TEST_F(Runtime, AProgramThatMetAFaultEndsWithStatusThree) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  EXPECT_EXIT(runOffByOneAndExit(""), testing::ExitedWithCode(3), "faults at 1 places");
  EXPECT_EXIT(runOffByOneAndExit("stop-at-fault"), testing::ExitedWithCode(40), "offByOneKernel");
  EXPECT_EXIT(runOffByOneAndExit("unchecked,engine=interpreter"), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(runOffByOneAndExit("order=random"), testing::ExitedWithCode(2), "'order=random' is not known");
}

}  // namespace
}  // namespace gw::ptx
