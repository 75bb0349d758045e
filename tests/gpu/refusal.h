// What a call says when it refuses.
#pragma once

#include <stdexcept>
#include <string>

namespace gw::test {

// The text of the Error that call() throws, or "not refused".
template <class Error = std::invalid_argument, class Call>
std::string refusal(const Call& call) {
  try {
    call();
    return "not refused";
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace gw::test
