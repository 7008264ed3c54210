// Views and scenes as scene files, and names of files in them: cli/scene/scene_json.h and
// scene_paths.h.
#include "cli/scene/scene_json.h"

#include "cli/scene/scene_paths.h"
#include "tests/cli/scene/scene_cases.h"

namespace terrview {
namespace {

TEST(SceneJson, HasNumbersWhereTheyAreTheSameTexts) {
  const auto json = scene_json(OptionValues{{"fov", {"33.5"}}, {"layers", {"1.50"}}}, {});
  EXPECT_EQ(json["options"]["fov"], 33.5);
  EXPECT_EQ(json["options"]["layers"], "1.50");
}

TEST(SceneJson, NamesPicturesAsSeenFromTheCurrentFolder) {
  const SceneFile scene = [] {
    SceneFile file;
    file.path = "sub/s.json";
    file.contents_json = SceneJson::parse(
        R"({"materials": {"a": {"color": {"kind": "mix", "share": 0.5, "of": [
              {"kind": "picture", "file": "a.png"}, {"kind": "picture", "file": "/b.png"}]}}}})");
    return file;
  }();
  const auto parts = scene_json(scene)["materials"]["a"]["color"]["of"];
  EXPECT_EQ(parts[0]["file"], "sub/a.png");
  EXPECT_EQ(parts[1]["file"], "/b.png");
}

TEST(SceneJson, OfANameThatIsNoUtf8IsRefused) {
  const auto json = scene_json(OptionValues{}, {"a\xff.tif"});
  EXPECT_THROW(static_cast<void>(scene_text(json)), InputError);
}

TEST(ScenePaths, AreRelativeToTheirFolderUnlessTheyAreTheSameEverywhere) {
  EXPECT_EQ(from_folder("a/b.tif", "sub"), "sub/a/b.tif");
  EXPECT_EQ(to_folder("sub/a/b.tif", "sub"), "a/b.tif");
  EXPECT_EQ(to_folder("b.tif", "sub"), "../b.tif");
  for (const std::string name :
       {"/b.tif", "https://host/b.tif", "NETCDF:b.nc:z", "WMS:http://host"}) {
    EXPECT_EQ(from_folder(name, "sub"), name);
    EXPECT_EQ(to_folder(name, "sub"), name);
  }
  EXPECT_EQ(from_folder("a/b:c.tif", "sub"), "sub/a/b:c.tif");
}

}  // namespace
}  // namespace terrview
