// The temporary file beside a target, which becomes the target, is removed, or is left for somebody to find.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gw {

// "FILE cannot be written: why", as FileError.
[[noreturn]] void refuseWriting(const std::filesystem::path& path, const std::string& why);

// The system's words for `error`, and the remedy.
std::string because(int error, const char* remedy);

// Where the bytes of `path` really go: a link is followed, so that it goes on pointing at the file. Throws FileError
// when no file can stand there.
std::filesystem::path writingDestination(const std::filesystem::path& path);

struct OpenPart {
  int descriptor = -1;  // for writing; the caller closes it
  std::string name;
};

// Makes TARGET.part-PID-N with the first free N, so that nobody's file is overwritten. Throws FileError about `shown`.
OpenPart openPart(const std::filesystem::path& shown, const std::filesystem::path& target);

// Syncs the part, closes it and gives it the target's name. Throws FileError about `shown`; the part is then still
// there.
void becomeTarget(OpenPart& part, const std::filesystem::path& shown, const std::filesystem::path& target);

// Whether a running program holds this temporary file.
bool isBeingWritten(const std::filesystem::path& part);

// The temporary files beside the target of `path` that no running program writes any more, by name. What cannot be
// looked at is not among them.
std::vector<std::filesystem::path> partsLeftBeside(const std::filesystem::path& path);

}  // namespace gw
