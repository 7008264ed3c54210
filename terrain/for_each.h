// How work is shared out where this folder starts no threads.
#pragma once

#include <functional>

namespace terrview {

// Calls work(0) ... work(count - 1), each once, in any order, on any threads.
using ForEach = std::function<void(int count, const std::function<void(int index)>& work)>;

inline void one_by_one(int count, const std::function<void(int index)>& work) {
  for (int i = 0; i < count; ++i) work(i);
}

}  // namespace terrview
