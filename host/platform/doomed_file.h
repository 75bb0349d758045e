// Files that are worth nothing unless they are finished: a program that is told to end at once removes them first.
#pragma once

#include <atomic>
#include <string>

namespace gw {

// While it lives the file is removed by removeDoomedFiles(). Of more than a few at a time some are left over.
class DoomedFile {
 public:
  explicit DoomedFile(std::string name);
  ~DoomedFile() { spare(); }
  DoomedFile(const DoomedFile&) = delete;
  DoomedFile& operator=(const DoomedFile&) = delete;

  void spare();  // from here it stays

 private:
  std::string name_;
  std::atomic<const char*>* slot_ = nullptr;
};

// For a signal handler that ends the program; async-signal-safe.
void removeDoomedFiles();

}  // namespace gw
