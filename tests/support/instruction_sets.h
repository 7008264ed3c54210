// Every instruction set that the machine has, forced in turn.
#pragma once

#include <cstdint>

#include <hwy/targets.h>

namespace terrview {

template <class Work>
void under_every_instruction_set(const Work& work) {
  for (std::int64_t sets = hwy::SupportedTargets(); sets != 0; sets &= sets - 1) {
    hwy::SetSupportedTargetsForTest(sets & -sets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    work();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace terrview
