#include "gpu/devices/cuda_state.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gw {
namespace {

CudaAnswers goodAnswers() {
  CudaAnswers answers;
  answers.driverVersion = 13020;
  answers.runtimeVersion = 13000;
  answers.driverRelease = "580.65.06";
  answers.oldestArchitecture = 75;
  answers.devices = {{"NVIDIA A", 90}, {"NVIDIA B", 61}};
  return answers;
}

CudaAnswers withError(const char* text) {
  CudaAnswers answers = goodAnswers();
  answers.error = text;
  answers.devices.clear();
  return answers;
}

// One sentence, with something to do about it after the colon.
void expectSentence(const std::string& why) {
  ASSERT_FALSE(why.empty());
  EXPECT_EQ(why.back(), '.') << why;
  EXPECT_EQ(why.find('\n'), std::string::npos) << why;
  EXPECT_NE(why.find(": "), std::string::npos) << why;
  EXPECT_EQ(why.find(". "), std::string::npos) << why;
}

TEST(CudaStateOf, ADeviceThatComputesNeedsNoWord) {
  const CudaVerdict verdict = judgeCuda(goodAnswers());
  EXPECT_EQ(verdict.state, CudaState::ready);
  EXPECT_EQ(verdict.why, "");
}

TEST(CudaStateOf, NoDriverIsToldFromADriverWithoutItsLibrary) {
  CudaAnswers answers = withError("CUDA driver version is insufficient for CUDA runtime version");
  answers.insufficientDriver = true;  // what the runtime says then, misleading as it is
  answers.driverVersion = 0;
  CudaVerdict withoutLibrary = judgeCuda(answers);
  answers.driverRelease = "";
  CudaVerdict without = judgeCuda(answers);
  EXPECT_EQ(without.state, CudaState::noDriver);
  EXPECT_EQ(withoutLibrary.state, CudaState::noDriver);
  EXPECT_NE(without.why.find("CUDA 13.0 or newer"), std::string::npos) << without.why;
  EXPECT_NE(withoutLibrary.why.find("libcuda"), std::string::npos) << withoutLibrary.why;
  expectSentence(without.why);
  expectSentence(withoutLibrary.why);
}

TEST(CudaStateOf, AnOldDriverIsNamedWithBothVersions) {
  CudaAnswers answers = withError("CUDA driver version is insufficient for CUDA runtime version");
  answers.insufficientDriver = true;
  answers.driverVersion = 12040;
  answers.driverRelease = "550.54.14";
  const CudaVerdict verdict = judgeCuda(answers);
  EXPECT_EQ(verdict.state, CudaState::driverTooOld);
  EXPECT_EQ(verdict.why,
            "The NVIDIA driver 550.54.14 supports CUDA up to 12.4; this program needs 13.0: update the driver.");
  answers.driverRelease = "";
  expectSentence(judgeCuda(answers).why);
  answers.driverVersion = 13000;  // new enough by its own account: then its age is not what is wrong
  EXPECT_EQ(judgeCuda(answers).state, CudaState::failed);
}

TEST(CudaStateOf, NoDeviceIsNoFaultOfTheDriver) {
  CudaAnswers answers = withError("no CUDA-capable device is detected");
  answers.noDevice = true;
  EXPECT_EQ(judgeCuda(answers).state, CudaState::noDevice);
  expectSentence(judgeCuda(answers).why);
  CudaAnswers empty = goodAnswers();
  empty.devices.clear();
  EXPECT_EQ(judgeCuda(empty).state, CudaState::noDevice);
}

TEST(CudaStateOf, AnyOtherErrorIsQuoted) {
  const CudaVerdict verdict = judgeCuda(withError("system not yet initialized"));
  EXPECT_EQ(verdict.state, CudaState::failed);
  EXPECT_NE(verdict.why.find("system not yet initialized"), std::string::npos);
  expectSentence(verdict.why);
}

TEST(CudaStateOf, OnlyTheDeviceThatComputesMayNotBeTooOld) {
  CudaAnswers answers = goodAnswers();
  std::reverse(answers.devices.begin(), answers.devices.end());
  const CudaVerdict verdict = judgeCuda(answers);
  EXPECT_EQ(verdict.state, CudaState::deviceTooOld);
  EXPECT_NE(verdict.why.find("NVIDIA B is sm_61, and this program's kernels are for sm_75"), std::string::npos)
      << verdict.why;
  expectSentence(verdict.why);
  EXPECT_EQ(tooOld({"C", 75}, 75), "");
  EXPECT_NE(tooOld({"C", 74}, 75), "");
  answers.oldestArchitecture = 0;  // not known: the kernels themselves will tell
  EXPECT_EQ(judgeCuda(answers).state, CudaState::ready);
}

TEST(CudaStateOf, TheOldestOfCMakesArchitecturesIsFound) {
  EXPECT_EQ(oldestOf("90"), 90);
  EXPECT_EQ(oldestOf("80,75,120"), 75);
  EXPECT_EQ(oldestOf("120-virtual;86-real;90a"), 86);
  EXPECT_EQ(oldestOf("native"), 0);
  EXPECT_EQ(oldestOf("all-major"), 0);
  EXPECT_EQ(oldestOf(""), 0);
  EXPECT_EQ(oldestOf(",;,"), 0);
}

TEST(CudaStateOf, VersionsReadAsPeopleWriteThem) {
  EXPECT_EQ(cudaVersionText(13000), "13.0");
  EXPECT_EQ(cudaVersionText(11080), "11.8");
  EXPECT_EQ(cudaVersionText(12090), "12.9");
}

TEST(CudaStateOf, TheDriversReleaseIsFoundInBothKindsOfModule) {
  EXPECT_EQ(driverReleaseIn("NVRM version: NVIDIA UNIX x86_64 Kernel Module  535.129.03  Thu Oct 19 18:56:32 UTC 2023\n"
                            "GCC version:  gcc version 12.2.0 (Debian 12.2.0-14)\n"),
            "535.129.03");
  EXPECT_EQ(driverReleaseIn("NVRM version: NVIDIA UNIX Open Kernel Module for x86_64  580.65.06  Release Build\n"),
            "580.65.06");
  EXPECT_EQ(driverReleaseIn("GCC version:  gcc version 12.2.0 (Debian 12.2.0-14)\n"), "");
  EXPECT_EQ(driverReleaseIn(""), "");
}

}  // namespace
}  // namespace gw
