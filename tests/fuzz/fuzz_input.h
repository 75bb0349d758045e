// What fuzz targets share. A target is one LLVMFuzzerTestOneInput(), which libFuzzer feeds with what it makes up, and
// replay_corpus.cpp with the files that are kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace gw::fuzz {

// A property that must hold for every input; libFuzzer keeps the input when it does not.
inline void demand(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "fuzz target: %s\n", what);
  std::abort();
}

inline std::string textOf(const uint8_t* data, size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// What users are told is a sentence, whatever the input held: not empty, on one line.
inline void demandSentence(const std::string& sentence) {
  demand(!sentence.empty(), "there is no message");
  demand(sentence.find('\n') == std::string::npos, "the message is more than one line");
}

}  // namespace gw::fuzz
