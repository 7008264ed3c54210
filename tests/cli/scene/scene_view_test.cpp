// `terrview SCENE.json` and --print-scene.
#include <filesystem>

#include "tests/cli/small_picture.h"
#include "tests/cli/small_view.h"

namespace terrview {
namespace {

class SceneView : public SmallView {
 protected:
  void write(const std::string& name, const std::string& text) const {
    write_text(path(name), text);
  }

  // Quietly; must succeed.
  [[nodiscard]] std::string picture(const Arguments& args) const {
    const Finished finished = run(args + words("-q --overwrite -o picture.png"));
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    return bytes("picture.png");
  }

  // Solids in the middle of the hills.
  [[nodiscard]] static std::string solids() {
    return R"("materials": {"red": {"color": [255, 0, 0], "specular": 0.5}},
      "solids": [{"kind": "cylinder", "radius": 30, "height": 200, "at": [48, 7, "+0"],
                  "material": "red"}])";
  }
};

TEST_F(SceneView, APrintedSceneMakesTheSamePicture) {
  for (const char* line :
       {"hills.tif --eye 47.985,6.99,900 --size 40x30",
        "hills.tif --eye-xy 6.99,47.985,+80 --look-at 48,7,+5 --size 40x30 --no-shadows --fov 33.5",
        "hills.tif --eye 47.985,6.99,900 --size 40x30 --sun 200,12.25 --sky 3 --refraction 0",
        "hills.tif --eye 47.985,6.99,900 --size 40x30 --colors arid --of png --co ZLEVEL=3",
        "plain.asc --eye-xy 400,300,360 --heading 20 --pitch -12 --size 40x30 --contours 1e1"}) {
    const Finished printed = run(words(line) + words("--print-scene"));
    ASSERT_EQ(printed.exit_code, 0) << printed.err;
    EXPECT_EQ(printed.err, "");
    write("s.json", printed.out);
    EXPECT_EQ(picture({"s.json"}), picture(words(line))) << printed.out;
  }
  EXPECT_EQ(outputs(), (std::vector<std::string>{"picture.png", "s.json"}));
}

TEST_F(SceneView, NamesOfFilesAreRelativeToTheScene) {
  std::filesystem::create_directory(path("sub"));
  write("sub/s.json", R"({"dems": ["../hills.tif"], "options": {"eye": [47.985, 6.99, 900],
    "size": "40x30", "layers": "layers.tif"}})");
  EXPECT_EQ(picture({"sub/s.json"}),
            picture(words("hills.tif --eye 47.985,6.99,900 --size 40x30")));
  EXPECT_TRUE(std::filesystem::exists(path("sub/layers.tif")));
  expect_refused(run(words("sub/s.json -q -o other.png")), {"sub/layers.tif", "--overwrite"});
  expect_refused(run(words("sub/s.json -q --overwrite --camera sub/s.json")), {"is read by this"});
}

TEST_F(SceneView, TheCommandLineGoesBeforeTheScene) {
  write("s.json", R"({"dems": ["no.tif"], "options": {"eye": [47.985, 6.99, 900],
    "size": "40x30", "look-at": [48, 7], "no-shadows": true}})");
  EXPECT_EQ(picture(words("s.json hills.tif --heading 80 --no-shadows=false")),
            picture(words("hills.tif --eye 47.985,6.99,900 --size 40x30 --heading 80")));
}

TEST_F(SceneView, APrintedSceneKeepsItsSolids) {
  write("s.json", R"({"dems": ["hills.tif"], "options": {"eye": [47.985, 6.99, 900],
    "size": "40x30"}, )" +
                      solids() + "}");
  const Finished printed = run(words("s.json --fov 40 --print-scene"));
  ASSERT_EQ(printed.exit_code, 0) << printed.err;
  write("t.json", printed.out);
  const std::string there = picture({"t.json"});
  EXPECT_EQ(there, picture(words("s.json --fov 40")));
  EXPECT_NE(there, picture(words("hills.tif --eye 47.985,6.99,900 --size 40x30 --fov 40")));
}

TEST_F(SceneView, SolidsAreObjectsInLayersAndTables) {
  write("s.json", R"({"dems": ["hills.tif"], "options": {"eye": [47.985, 6.99, 900],
    "size": "40x30"}, )" +
                      solids() + "}");
  const Finished finished = run(words("s.json --layers l.tif --objects-csv o.csv -q"));
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(outputs(), (std::vector<std::string>{"l.tif", "o.csv", "s.json", "s.png"}));
  const Rows rows = csv_rows(bytes("o.csv"));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1][1], "solid");
  EXPECT_NEAR(std::stod(rows[1][4]), 200, 0.1);
  const Layers seen = layers("l.tif");
  EXPECT_EQ(seen.at("object_id", 20, 14), 1);
}

TEST_F(SceneView, ASceneNeedsNoGround) {
  const std::string ball = R"("solids": [{"kind": "sphere", "radius": 2, "at-xy": [0, 10, 0]}])";
  write("s.json", R"({"options": {"eye-xy": [0, 0, 0], "heading": 0, "size": "40x30",
    "layers": "l.tif"}, )" +
                      ball + "}");
  const Finished finished = run(words("s.json -q"));
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const Layers seen = layers("l.tif");
  EXPECT_NEAR(seen.at("distance_m", 20, 15), 8, 1e-2);
  EXPECT_TRUE(std::isnan(seen.at("distance_m", 0, 29)));
  for (const auto& [options, why] :
       std::map<std::string, std::string>{{"--eye 48,7,2", "--eye-xy"},
                                          {"--eye-xy 0,0,+2", "no ground"},
                                          {"--projection plan", "there is no ground"},
                                          {"--water 3", "there is no ground"},
                                          {"--drape x.tif", "there is no ground"},
                                          {"--look-at 48,7", "there is no ground"}})
    expect_refused(run(words("s.json -q --overwrite -o x.png " + options)), {why});
}

TEST_F(SceneView, ItsBackgroundTakesTheSkysPlace) {
  write("s.json", R"({"dems": ["plain.asc"], "light": {"background": [10, 200, 90]},
    "options": {"eye-xy": [400, 100, 380], "heading": 0, "size": "8x8", "clouds": 1}})");
  ASSERT_EQ(run(words("s.json -q -o s.png")).exit_code, 0);
  EXPECT_EQ(read_picture(path("s.png")).colors.front(), glm::ivec4(10, 200, 90, 255));
}

TEST_F(SceneView, AFileOfThatNameAfterViewIsADem) {
  write("s.json", R"({"options": {"fov": 60}})");
  expect_refused(run(words("view s.json --eye 48,7,+2")), {"s.json"});
  expect_refused(run(words("s.json")), {"s.json: --eye: missing"});
  expect_refused(run(words("none.json")), {"none.json", "cannot be read"});
  std::filesystem::create_directory(path("folder.json"));
  expect_refused(run(words("folder.json")), {"folder.json", "is no file"});
}

TEST_F(SceneView, ItsTexturesAreNotReplaced) {
  const std::string eye = R"("options": {"eye-xy": [0, 0, 0], "heading": 0, "size": "8x8"})";
  write("plain.json",
        "{" + eye + R"(, "solids": [{"kind": "sphere", "radius": 2, "at-xy": [0, 9, 0]}]})");
  ASSERT_EQ(run(words("plain.json -q -o texture.png")).exit_code, 0);
  const std::string before = bytes("texture.png");
  write("s.json", "{" + eye + R"(, "solids": [{"kind": "sphere", "radius": 2, "at-xy": [0, 9, 0],
    "material": {"color": {"kind": "picture", "file": "texture.png"}}}]})");
  expect_refused(run(words("s.json -q --overwrite -o texture.png")),
                 {"texture.png", "is read by this view"});
  EXPECT_EQ(bytes("texture.png"), before);
}

// All ground is under water, so that what the ground looks like shows nowhere: neither in the
// water, nor in a mirror over it, nor in the mirror's image in the water.
TEST_F(SceneView, WaterHidesItsBedInEveryMirror) {
  write("s.json", R"({"dems": ["plain.asc"],
    "options": {"eye-xy": [400, 100, 380], "heading": 0, "pitch": -8, "size": "40x30",
                "water": "350", "visibility": "inf"},
    "solids": [{"kind": "box", "size": [120, 4, 120], "rotate": [20, 0, 0], "at-xy": [400, 250, 380],
                "material": {"color": [0, 0, 0], "mirror": 1}}]})");
  for (const char* colors : {"arid", "alpine"}) {
    const Finished finished =
        run(words("s.json -q -o") + Arguments{std::string(colors) + ".ppm", "--colors", colors});
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
  }
  EXPECT_EQ(bytes("arid.ppm"), bytes("alpine.ppm"));
}

TEST_F(SceneView, PlacesWithoutGroundAreRefusedByName) {
  write("s.json", R"({"dems": ["hills.tif"], "options": {"eye": [47.985, 6.99, 900], "size": "8x8"},
    "solids": [{"kind": "sphere", "radius": 2, "at": [40, 7, "+1"]}]})");
  expect_refused(run(words("s.json -q")), {"s.json: /solids/0: there is no ground at its place"});
  write("t.json", R"({"dems": ["hills.tif"], "options": {"eye": [47.985, 6.99, 900], "size": "8x8"},
    "solids": [{"kind": "sphere", "radius": 2, "at-xy": [7, 1000, 3]}]})");
  expect_refused(run(words("t.json -q")), {"t.json: /solids/0: its place is nowhere on the Earth"});
}

}  // namespace
}  // namespace terrview
