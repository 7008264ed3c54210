// Exit codes and messages of the program: docs/cli.md.
#include <cstddef>
#include <cstdlib>

#include "tests/cli/small_view.h"

namespace terrview {
namespace {

struct BadLine {
  const char* line;  // after the beginning
  std::vector<std::string> parts;
};

class Usage : public SmallView {
 protected:
  void expect_each_refused(const std::string& beginning, const std::vector<BadLine>& lines) const {
    for (const BadLine& bad : lines) {
      SCOPED_TRACE(bad.line);
      expect_refused(run(words(beginning + bad.line)), bad.parts);
      EXPECT_EQ(outputs(), std::vector<std::string>());
    }
  }
};

TEST_F(Usage, ErrorsInThePlaceOfTheEyeNameTheOptionAndARemedy) {
  expect_each_refused("hills.tif ", {{"-q", {"--eye", "--eye 47.9,7.1,+2"}},
                                     {"--eye", {"--eye"}},
                                     {"--eye 48,7", {"--eye 48,7", "LAT,LON,ALT"}},
                                     {"--eye 48,7,1,2", {"--eye 48,7,1,2", "LAT,LON,ALT"}},
                                     {"--eye 48,x,900", {"--eye", "'x'", "not a number"}},
                                     {"--eye 48,7,high", {"--eye", "high", "metres"}},
                                     {"--eye 48,7,nan", {"--eye", "nan"}},
                                     {"--eye 98,7,900", {"--eye", "latitude", "LAT,LON"}},
                                     {"--eye 7,480,900", {"--eye", "longitude", "LAT,LON"}},
                                     {"--eye 48,7,1e300", {"--eye", "100 000 km"}},
                                     {"--eye-xy 1e300,7,3", {"--eye-xy", "100 000 km"}},
                                     {"--eye 48,7,900 --eye-xy 7,48,900", {"--eye", "--eye-xy"}},
                                     {"--eye-xy 7,48", {"--eye-xy 7,48", "X,Y,Z"}},
                                     {"--from-camera none.json", {"none.json", "cannot be read"}}});
}

TEST_F(Usage, ErrorsInTheAimNameTheOptionAndARemedy) {
  expect_each_refused("hills.tif --eye 48,7,900 ",
                      {{"--look-at 48,7 --heading 3", {"--look-at", "--heading"}},
                       {"--look-at-xy 7,48 --heading 3", {"--look-at-xy", "--heading"}},
                       {"--look-at 48,7 --look-at-xy 7,48", {"--look-at", "--look-at-xy"}},
                       {"--look-at 48", {"--look-at 48", "LAT,LON"}},
                       {"--look-at 99,7", {"--look-at", "latitude"}},
                       {"--look-at 50,7", {"--look-at", "no ground", "height"}},
                       {"--heading north", {"--heading", "north", "number"}},
                       {"--heading nan", {"--heading", "nan"}},
                       {"--pitch 0x10", {"--pitch", "0x10"}},
                       {"--pitch inf", {"--pitch", "inf"}},
                       {"--pitch 90.5", {"--pitch", "90"}},
                       {"--pitch", {"--pitch"}},
                       {"--roll 1,2", {"--roll", "1,2"}}});
}

TEST_F(Usage, ErrorsInTheProjectionNameTheOptionAndARemedy) {
  expect_each_refused("hills.tif --eye 48,7,900 ",
                      {{"--fov 0", {"--fov", "0 and less than 180"}},
                       {"--fov 180", {"--fov", "less than 180"}},
                       {"--fov nan", {"--fov", "nan"}},
                       {"--projection cylindrical --fov 361", {"--fov", "360"}},
                       {"--projection cylindrical --pitch 3", {"--pitch", "level"}},
                       {"--projection cylindrical --roll 3", {"--roll", "level"}},
                       {"--projection orthographic", {"--width", "metres"}},
                       {"--projection orthographic --width 0", {"--width", "metres"}},
                       {"--width 500", {"--width", "--projection orthographic"}},
                       {"--projection orthographic --width 500 --fov 30", {"--fov", "--width"}},
                       {"--projection fisheye", {"--projection", "fisheye", "cylindrical"}},
                       {"--size 64", {"--size 64", "WIDTHxHEIGHT"}},
                       {"--size 64x", {"--size 64x", "WIDTHxHEIGHT"}},
                       {"--size 64x48x3", {"--size", "WIDTHxHEIGHT"}},
                       {"--size 6.4x48", {"--size", "WIDTHxHEIGHT"}},
                       {"--size 0x48", {"--size", "0x48"}},
                       {"--size 64x-48", {"--size", "64x-48"}},
                       {"--size 99999999999x48", {"--size", "WIDTHxHEIGHT"}}});
}

TEST_F(Usage, ErrorsInGroundAndLightNameTheOptionAndARemedy) {
  expect_each_refused("hills.tif --eye 48,7,900 ",
                      {{"--z-scale 0", {"--z-scale", "above 0"}},
                       {"--z-scale -2", {"--z-scale", "above 0"}},
                       {"--z-scale 1e300", {"--z-scale", "1000"}},
                       {"--earth round", {"--earth", "round", "flat"}},
                       {"--earth flat --refraction 0.1", {"--refraction", "flat"}},
                       {"--refraction 3", {"--refraction", "0.13"}},
                       {"--surface cubic", {"--surface", "cubic", "triangles"}},
                       {"--coherence maybe", {"--coherence", "maybe"}},
                       {"--voids close", {"--voids", "close", "fill"}},
                       {"--window 0,0,9", {"--window", "4 numbers"}},
                       {"--window 0,0,9,9.5", {"--window", "whole numbers"}},
                       {"--window 0,0,900,9", {"--window", "900", "41"}},
                       {"--spacing 60", {"--spacing", "2 to 3 numbers"}},
                       {"--band 2", {"2", "band"}},
                       {"--nodata none", {"--nodata", "none"}},
                       {"--a-srs EPSG:nonsense", {"EPSG:nonsense"}},
                       {"--sun 180", {"--sun", "2 numbers"}},
                       {"--sun 45,180", {"--sun", "AZ,EL"}},
                       {"--time noon", {"--time noon", "2026-06-21T15:00Z"}},
                       {"--time 2026-06-21T15:00Z --sun 4,5", {"--time", "--sun", "one of them"}},
                       {"--time 2026-06-21T15:00Z --shade relief", {"--time", "--shade"}},
                       {"--sun-refraction some", {"--sun-refraction", "some", "on"}},
                       {"--soft-shadows --no-shadows", {"--soft-shadows", "--no-shadows"}},
                       {"--soft-shadows --shade relief", {"--soft-shadows", "relief"}},
                       {"--normals bumpy", {"--normals", "bumpy", "facet"}},
                       {"--colors none.txt", {"none.txt"}},
                       {"--threads 0", {"--threads", "0", "1 to 256"}},
                       {"--threads 4096", {"--threads", "4096", "1 to 256"}}});
}

TEST_F(Usage, ErrorsInTheFilesNameTheOptionAndARemedy) {
  expect_each_refused("hills.tif --eye 48,7,900 ",
                      {{"-o a.bmp", {"a.bmp", ".png", "--of"}},
                       {"-o a", {"'a'", "--of"}},
                       {"--of bmp", {"'bmp'", ".png"}},
                       {"-o a.png --co QUALITY=5", {"--co QUALITY=5", "ZLEVEL"}},
                       {"-o a.png --co ZLEVEL", {"--co ZLEVEL", "KEY=VALUE"}},
                       {"-o a.jpg --co QUALITY=500", {"--co QUALITY=500", "100"}},
                       {"-o a.webp --size 20000x10", {"--size", "16383"}},
                       {"--layers a.png", {"--layers a.png", ".tif"}},
                       {"-o none/a.png", {"none/a.png", "folder"}},
                       {"-o .", {"'.'"}},
                       {"--stats none/a.json", {"none/a.json", "folder"}},
                       {"-o /proc/a.png", {"/proc/a.png", "folder"}},
                       {"--of png -o /dev/null", {"/dev/null", "regular file"}},
                       {"--of png -o /dev/null --overwrite", {"/dev/null", "regular file"}},
                       {"--bogus", {"--bogus", "--help"}},
                       {"--eye 48,7,950", {"--eye"}}});
}

TEST_F(Usage, ErrorsInTheDemNameItAndARemedy) {
  expect_refused(run(words("none.tif --eye 48,7,+2")), {"none.tif", "check the path"});
  expect_refused(run(words("--eye 48,7,+2")), {"DEM", "--help"});
  expect_refused(run(words("plain.asc --eye 48,7,+2")), {"plain.asc", "--eye-xy", "--a-srs"});
  expect_refused(run(words("plain.asc --eye-xy 100,100,+2 --look-at 48,7")), {"--a-srs"});
  expect_refused(run(words("plain.asc --eye-xy 100,100,+2 --refraction 0.1")),
                 {"--refraction", "plain.asc", "--a-srs"});
  expect_refused(run(words("plain.asc --eye-xy 100,100,+2 --earth curved")),
                 {"--earth curved", "plain.asc", "--a-srs"});
  EXPECT_EQ(outputs(), std::vector<std::string>());
}

TEST_F(Usage, AnEyeUnderTheGroundIsRefusedSayingByHowMuch) {
  expect_refused(run(words("plain.asc --eye-xy 100,100,287.5")), {"12.500 m under the ground"});
  expect_refused(run(words("plain.asc --eye-xy 100,100,+-2")), {"2.000 m under the ground"});
}

TEST_F(Usage, AnEyeAboveNoGroundNeedsAnAbsoluteHeight) {
  expect_refused(run(words("plain.asc --eye-xy 5000,100,+2")), {"no ground", "without a +"});
}

TEST_F(Usage, HelpAndVersionGoToStandardOutput) {
  for (const char* line : {"--help", "-h", "view --help", "view -h", "hills.tif --help",
                           "--version", "view --version"}) {
    const Finished finished = run(words(line));
    EXPECT_EQ(finished.exit_code, 0) << line;
    EXPECT_EQ(finished.out.rfind("terrview", 0) == 0 || says(finished.out, {"terrview view"}), true)
        << finished.out;
    EXPECT_EQ(finished.err, "") << line;
  }
}

TEST_F(Usage, ExitCodesAreThoseOfTheProcess) {
  EXPECT_EQ(run(words("--version"), RunOptions{}).exit_code, 0);
  EXPECT_EQ(run(words("none.tif --eye 48,7,+2"), RunOptions{}).exit_code, 2);
}

TEST_F(Usage, IsShownOnStandardErrorWithoutArguments) {
  const Finished finished = run({});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_EQ(finished.out, "");
  EXPECT_TRUE(says(finished.err, {"terrview", "--eye", "--help"}));
}

TEST_F(Usage, MessagesGoToStandardErrorAndQuietHasNone) {
  const Finished said = run(words("hills.tif --eye 48,7,+20 --size 16x12 -o a.png"));
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_EQ(said.out, "");
  EXPECT_TRUE(says(said.err, {"hills.tif: 41 x 41 posts", "eye: 48.000000, 7.000000",
                              "multiplier 1-k = 0.87", "wrote a.png"}));
  const Finished quiet =
      run(words("hills.tif --eye 48,7,+20 --size 16x12 -o b.png -q --threads 4"));
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
  EXPECT_EQ(bytes("a.png"), bytes("b.png"));
}

TEST_F(Usage, MessagesHaveNoColoursOrProgressAwayFromATerminal) {
  const Arguments line = words("hills.tif --eye 48,7,+20 --size 16x12 --overwrite -o a.png");
  const Finished plain = run(line);
  ::setenv("NO_COLOR", "1", 1);
  const Finished colorless = run(line);
  EXPECT_EQ(plain.err, colorless.err);
  EXPECT_EQ(plain.err.find_first_of("\x1b\r"), std::string::npos);
}

TEST_F(Usage, WarningsAreShown) {
  // A lone -9999 that no nodata value declares.
  std::string text = "ncols 3\nnrows 3\nxllcenter 0\nyllcenter 0\ncellsize 10\n";
  write_text(path("odd.asc"), text + "300 300 300\n300 300 300\n300 300 1e30\n");
  const Finished said = run(words("odd.asc --eye-xy 5,5,+20 --size 16x12"));
  EXPECT_EQ(said.exit_code, 0) << said.err;
  EXPECT_TRUE(says(said.err, {"warning: odd.asc"}));
}

}  // namespace
}  // namespace terrview
