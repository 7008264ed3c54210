// The sky of a view, as a user asks for it.
#include <gtest/gtest.h>

#include "tests/cli/small_view.h"

namespace terrview {
namespace {

using ViewSky = SmallView;

const char* const kUp = "--heading 200 --pitch 25 --clouds 0.6 ";

TEST_F(ViewSky, EveryChoiceChangesThePicture) {
  view(std::string(kUp) + "-o plain.png");
  for (const char* choice : {"--sky 2", "--no-sky", "--sky-model gradient", "--turbidity 5",
                             "--cloud-base 800", "--cloud-base +900", "--cloud-cell 3000"}) {
    view(std::string(kUp) + "--overwrite -o other.png " + choice);
    EXPECT_FALSE(bytes("plain.png") == bytes("other.png")) << choice;
  }
}

TEST_F(ViewSky, CloudsShadeTheGroundOnlyWhereAsked) {
  const std::string down = "--heading 200 --pitch -20 --samples 1 --cloud-cell 200 --sun 200,60 ";
  const auto picture = [&](const std::string& line) {
    view(down + line + " --overwrite -o a.ppm");
    return bytes("a.ppm");
  };
  EXPECT_FALSE(picture("--clouds 0.5") == picture("--clouds 0.5 --cloud-shadows"));
  EXPECT_TRUE(picture("--clouds 0") == picture("--clouds 0 --cloud-shadows"));
}

TEST_F(ViewSky, IsTheSameForAnyNumberOfThreadsAndWithoutCoherence) {
  for (const std::string projection : {"", "--projection cylindrical --pitch 0 --fov 360 "}) {
    const std::string line =
        (projection.empty() ? std::string(kUp) : "--heading 10 " + projection) +
        "--cloud-shadows --overwrite -o ";
    view(line + "one.png --threads 1");
    view(line + "four.png --threads 4");
    view(line + "plain.png --coherence off");
    EXPECT_TRUE(bytes("one.png") == bytes("four.png"));
    EXPECT_TRUE(bytes("one.png") == bytes("plain.png"));
  }
}

TEST_F(ViewSky, AnEyeAboveTheCloudsSeesNone) {
  view("--heading 200 --pitch 25 --clouds 0 -o clear.ppm");
  view("--heading 200 --pitch 25 --clouds 0.6 --cloud-base -100 -o above.ppm");
  EXPECT_TRUE(bytes("above.ppm") == bytes("clear.ppm"));
}

TEST_F(ViewSky, MetadataSaysWhatChangesThePicture) {
  view(std::string(kUp) + "--sky 7 --cloud-base +900 -o a.png");
  const std::string png = bytes("a.png");
  for (const char* part : {"\"seed\":7", "\"clouds\":0.6", "\"above_eye\":true"})
    EXPECT_NE(png.find(part), std::string::npos) << part;
}

TEST_F(ViewSky, RefusesInOneLine) {
  const Arguments eye = words("hills.tif --eye 48,7,900");
  expect_refused(run(eye + words("--clouds 3")), {"--clouds"});
  expect_refused(run(eye + words("--sky blue")), {"--sky blue"});
  expect_refused(run(eye + words("--cloud-base high")), {"--cloud-base high"});
  expect_refused(run(eye + words("--sky-model hosek")), {"--sky-model"});
}

}  // namespace
}  // namespace terrview
