// --coherence neighbours: docs/cli.md.
#include <cmath>

#include "tests/cli/small_view.h"

namespace terrview {
namespace {

class NeighboursOfView : public SmallView {};

TEST_F(NeighboursOfView, HaveTheSameBytesForAnyNumberOfThreads) {
  for (const std::string line : {"--pitch -35 --roll 20", "--pitch -90", "--heading 20 --roll 7"}) {
    SCOPED_TRACE(line);
    view(line + " --coherence neighbours --threads 1 -o a.png --layers a.tif --overwrite");
    view(line + " --coherence neighbours --threads 3 -o b.png --layers b.tif --overwrite");
    EXPECT_TRUE(bytes("a.png") == bytes("b.png"));
    EXPECT_TRUE(bytes("a.tif") == bytes("b.tif"));
  }
}

TEST_F(NeighboursOfView, SeeNearlyWhatRaysOnTheirOwnSee) {
  view("--pitch -35 --roll 20 -o a.png --layers a.tif");
  view("--pitch -35 --roll 20 --coherence neighbours -o b.png --layers b.tif");
  const Layers exact = layers("a.tif");
  const Layers found = layers("b.tif");
  int differ = 0;
  for (std::size_t i = 0; i < exact.bands[0].size(); ++i) {
    const double a = exact.bands[0][i];
    const double b = found.bands[0][i];
    differ += a == b || (std::isnan(a) && std::isnan(b)) ? 0 : 1;
  }
  EXPECT_LE(differ, 30);  // of 3072
}

TEST_F(NeighboursOfView, AreSaidInThePicture) {
  view("--coherence neighbours -o a.png");
  const GDALDatasetUniquePtr picture(GDALDataset::Open(path("a.png").c_str()));
  ASSERT_TRUE(picture);
  EXPECT_TRUE(says(picture->GetMetadataItem("terrview_view"), {R"("coherence":"neighbours")"}));
}

TEST_F(NeighboursOfView, NeedAnEye) {
  expect_refused(run(words("hills.tif --eye 48,7,900 --pitch -90 --projection orthographic "
                           "--width 900 --coherence neighbours -o a.png")),
                 {"--coherence neighbours", "orthographic"});
}

}  // namespace
}  // namespace terrview
