// The one exception for a user's mistake: bad file, bad option, impossible request.
#pragma once

#include <stdexcept>

namespace terrview {

// what() is one line that says what is wrong, where, and how to mend it.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace terrview
