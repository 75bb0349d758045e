// The temporary file beside a target, which becomes the target, is removed, or is left to be found.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "host/platform/atomic_file.h"
#include "host/platform/unfinished_file.h"

namespace gw {

// "FILE cannot be written: why", as FileError.
[[noreturn]] void refuseWriting(const std::filesystem::path& path, const std::string& why);

// Where the bytes of `path` really go: a link is followed, so that it goes on pointing at the file. Throws FileError
// when no file can stand there.
std::filesystem::path writingDestination(const std::filesystem::path& path);

struct OpenPart {
  int descriptor = -1;  // for writing; the caller closes it
  std::string name;
};

// Makes TARGET.part-PID-N with the first free N, so that no file is overwritten. It has the permissions of the
// file that it is to replace, and its owner where that may be given. Throws FileError about `shown`.
OpenPart openPart(const std::filesystem::path& shown, const std::filesystem::path& target);

// Syncs the part, closes it and gives it the target's name, or its bytes where the name cannot be taken
// (replaceFile()). Throws FileError about `shown`; the part is then still there.
void becomeTarget(OpenPart& part, const std::filesystem::path& shown, const std::filesystem::path& target,
                  Sync sync = Sync::now);

// A part that is of no use unless it is whole: removed on destruction, and by removeUnfinishedFiles(), unless it became
// the target.
class PartFile {
 public:
  // Throws FileError about `path`, as all of it does.
  explicit PartFile(const std::filesystem::path& path);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  void write(std::span<const uint8_t> bytes);
  void become(Sync sync = Sync::now);

  const std::string& name() const { return part_.name; }  // of the part

 private:
  std::filesystem::path shown_, target_;
  OpenPart part_;
  UnfinishedFile unfinished_;
};

// Whether a running program holds this temporary file.
bool isBeingWritten(const std::filesystem::path& part);

// The temporary files beside the target of `path` that no running program writes any more, by name. What cannot be
// looked at is not among them.
std::vector<std::filesystem::path> partsLeftBeside(const std::filesystem::path& path);

}  // namespace gw
