// What the study of light and air says: bench/light_study.h.
#include "bench/light_study.h"

#include <gtest/gtest.h>

#include <sstream>

namespace terrview {
namespace {

TEST(LightStudy, NamesEveryEffectWithItsCost) {
  std::ostringstream out;
  print_effect_costs(out, synthetic_mountains(65), {32, 24}, 1);
  for (const char* effect :
       {"none", "none, again", "soft shadows", "air", "level of detail", "sky view",
        "adaptive rays", "haze", "preview", "progressive", "sparkle"})
    EXPECT_NE(out.str().find(effect), std::string::npos) << effect;
}

}  // namespace
}  // namespace terrview
