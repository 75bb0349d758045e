// Files that are worth nothing unless they are finished: a program that is told to end at once removes them first.
#pragma once

#include <atomic>
#include <string>

namespace gw {

// While it lives the file is removed by removeUnfinishedFiles(). Of more than a few at a time some are left over.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(std::string name);
  ~UnfinishedFile() { keep(); }
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  void keep();  // from here it stays

 private:
  std::string name_;
  std::atomic<const char*>* slot_ = nullptr;
};

// For a signal handler that ends the program; async-signal-safe.
void removeUnfinishedFiles();

}  // namespace gw
