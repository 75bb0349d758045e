#include "tests/ptx_machine/ptx/fat_binary.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "tests/ptx_machine/ptx/ptx_module.h"

namespace gw::ptx {
namespace {

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// An entry as nvcc 13 writes it, with its 64 bytes of header and the file's name behind it.
std::string entry(uint16_t kind, uint32_t architecture, std::string text, uint32_t compressed_bytes = 0) {
  text.resize((text.size() + 8) / 8 * 8, '\0');
  std::string bytes;
  append<uint16_t>(bytes, kind);
  append<uint16_t>(bytes, 0x0101);
  append<uint32_t>(bytes, 72);
  append<uint64_t>(bytes, text.size());
  append<uint32_t>(bytes, compressed_bytes);
  append<uint32_t>(bytes, 0);
  append<uint32_t>(bytes, 9u << 16);
  append<uint32_t>(bytes, architecture);
  bytes.resize(72, '\x11');
  return bytes + text;
}

std::string fatBinary(const std::string& entries) {
  std::string bytes;
  append<uint32_t>(bytes, 0xBA55ED50);
  append<uint16_t>(bytes, 1);
  append<uint16_t>(bytes, 16);
  append<uint64_t>(bytes, entries.size());
  return bytes + entries;
}

TEST(FatBinary, GivesThePtxOfEachArchitecture) {
  const std::string all = fatBinary(entry(2, 90,
                                          "\x7f"
                                          "ELF") +
                                    entry(1, 90, "\n.version 9.0\n") + entry(1, 75, ".version 8.0\n.target sm_75\n"));
  const auto found = embeddedPtxOfSection(all);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].architecture, 90u);
  EXPECT_EQ(found[0].text, "\n.version 9.0\n");
  EXPECT_EQ(found[1].architecture, 75u);
  EXPECT_EQ(found[1].text, ".version 8.0\n.target sm_75\n");
}

TEST(FatBinary, FollowsTheWrapperOfAnObject) {
  const std::string all = fatBinary(entry(1, 90, ".version 9.0\n"));
  struct {
    uint32_t magic = 0x466243B1, version = 1;
    const void* data;
    const void* none = nullptr;
  } wrapper;
  wrapper.data = all.data();
  const auto found = embeddedPtx(&wrapper);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].text, ".version 9.0\n");
  wrapper.magic = 7;
  EXPECT_THROW(embeddedPtx(&wrapper), PtxError);
}

TEST(FatBinary, FindsSeveralInASection) {
  const std::string one = fatBinary(entry(1, 90, ".version 9.0\n"));
  const auto found = embeddedPtxOfSection(one + std::string(16, '\0') + one);
  EXPECT_EQ(found.size(), 2u);
}

TEST(FatBinary, RefusesWhatItCannotRead) {
  const std::string right = fatBinary(entry(1, 90, ".version 9.0\n"));
  EXPECT_THROW(embeddedPtxOfSection("x" + right.substr(1)), PtxError);
  EXPECT_THROW(embeddedPtxOfSection(right.substr(0, right.size() - 1)), PtxError);
  EXPECT_THROW(embeddedPtxOfSection(fatBinary(entry(1, 90, "\x28\xb5\x2f\xfd compressed", 17))), PtxError);
  EXPECT_THROW(embeddedPtxOfSection(fatBinary(entry(1, 90, "\x28\xb5\x2f\xfd compressed"))), PtxError);
  std::string longer = right;
  const uint64_t bytes = 4096;
  std::memcpy(longer.data() + 16 + 8, &bytes, sizeof bytes);
  EXPECT_THROW(embeddedPtxOfSection(longer), PtxError);
}

}  // namespace
}  // namespace gw::ptx
