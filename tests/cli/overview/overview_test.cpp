// `terrview overview`: docs/cli.md and docs/overview.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include <glm/vec2.hpp>

#include "tests/cli/small_picture.h"
#include "tests/cli/small_view.h"

namespace terrview {
namespace {

class Overview : public SmallView {};

TEST_F(Overview, RefusesOptionsItCannotTake) {
  expect_refused(run(words("overview hills.tif --plan --tilt 20")), {"--tilt", "block"});
  expect_refused(run(words("overview hills.tif --resolution 5")), {"--resolution", "--plan"});
  expect_refused(run(words("overview hills.tif --from up")), {"--from", "up"});
  expect_refused(run(words("overview hills.tif --tilt 4")), {"--tilt"});
}

TEST_F(Overview, IsABlockByItself) {
  const Finished finished =
      run(words("overview hills.tif --from wsw --size 400x300 --title Hills -o block.png"));
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_NE(finished.err.find("heights x "), std::string::npos);
  const ReadPicture block = read_picture(path("block.png"));
  ASSERT_EQ(glm::ivec2(block.width_px, block.height_px), glm::ivec2(400, 300));
  EXPECT_EQ(block.colors.front(), glm::ivec4(246, 244, 239, 255));
  // The title is above, where the block is not.
  int darkest = 255;
  for (std::size_t i = 0; i < 400 * 40; ++i)
    for (const int band : {0, 1, 2}) darkest = std::min(darkest, block.colors[i][band]);
  EXPECT_LT(darkest, 60);
}

TEST_F(Overview, SaysAllThatChangesItsBlock) {
  const auto said = [&](const std::string& line) {
    const Finished finished =
        run(words("overview hills.tif -q --size 300x240 --samples 1 --overwrite -o b.png " + line));
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    const std::string text = bytes("b.png");
    const std::size_t at = text.find("terrview:view");
    return text.substr(at, text.find("IDAT") - at);
  };
  const std::set<std::string> texts{said("--title A"), said("--title B"),
                                    said("--title A --ticks degrees"), said("--plain")};
  EXPECT_EQ(texts.size(), 4U);
}

TEST_F(Overview, IsACloudOptimizedGeoTiffOnDemand) {
  const Finished finished = run(words("overview hills.tif -q --plan --of COG -o cog.tif"));
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const GDALDatasetUniquePtr file(GDALDataset::Open(path("cog.tif").c_str()));
  ASSERT_TRUE(file);
  EXPECT_STREQ(file->GetMetadataItem("LAYOUT", "IMAGE_STRUCTURE"), "COG");
  EXPECT_EQ(outputs(), std::vector<std::string>{"cog.tif"});
}

}  // namespace
}  // namespace terrview
