// What the program writes, and that it writes all or nothing: docs/cli.md.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "tests/cli/small_view.h"

namespace terrview {
namespace {

using Names = std::vector<std::string>;

const std::string kAllOutputs = "-o a.png --layers a.tif --stats s.json --camera c.json";

class Output : public SmallView {
 protected:
  // A view that takes seconds, and the signal that comes once its outputs are claimed.
  [[nodiscard]] Finished interrupted_by(int signal) const {
    Program program(
        words("hills.tif -q --eye 47.985,6.99,900 --size 3000x3000 --threads 1 " + kAllOutputs),
        folder_.path().string());
    wait_for_outputs(4);
    program.send(signal);
    return program.wait();
  }

  void wait_for_outputs(std::size_t count) const {
    for (int tries = 0; tries < 6000 && outputs().size() < count; ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_GE(outputs().size(), count);
  }
};

TEST_F(Output, IsNamedAfterTheFirstDemByDefault) {
  view("");
  EXPECT_EQ(outputs(), Names{"hills.png"});
  EXPECT_EQ(bytes("hills.png").substr(1, 3), "PNG");
  view("--of JPEG");
  EXPECT_EQ(bytes("hills.jpeg").substr(0, 2), "\xff\xd8");
  view(words("--of EXR -o named"));
  EXPECT_EQ(bytes("named").substr(0, 4), "\x76\x2f\x31\x01");
}

TEST_F(Output, ThatExistsIsRefusedAndUntouchedUnlessOverwritten) {
  for (const std::string name : {"a.png", "a.tif", "s.json", "c.json"}) {
    SCOPED_TRACE(name);
    write_text(path(name), "precious");
    const Arguments line = words("hills.tif -q --eye 48,7,+20 --size 16x12 " + kAllOutputs);
    expect_refused(run(line), {name, "--overwrite"});
    EXPECT_EQ(outputs(), Names{name});
    EXPECT_EQ(bytes(name), "precious");
    EXPECT_EQ(run(line + words("--overwrite")).exit_code, 0);
    EXPECT_EQ(outputs(), (Names{"a.png", "a.tif", "c.json", "s.json"}));
    EXPECT_NE(bytes(name), "precious");
    for (const std::string& written : outputs()) std::filesystem::remove(path(written));
  }
}

TEST_F(Output, NamedTwiceIsRefused) {
  expect_refused(run(words("hills.tif --eye 48,7,+20 -o a.tif --layers ./a.tif")),
                 {"a.tif", "two outputs"});
  expect_refused(run(words("hills.tif --eye 48,7,+20 --stats a.json --camera a.json")),
                 {"a.json", "two outputs"});
  EXPECT_EQ(outputs(), Names());
}

TEST_F(Output, IsNeverAFileThatTheViewReads) {
  const std::string before = bytes("hills.tif");
  for (const char* option : {"-o", "--layers"})
    expect_refused(
        run(words("hills.tif --eye 48,7,+20 --overwrite") + Arguments{option, "./hills.tif"}),
        {"hills.tif", "read by this view"});
  EXPECT_TRUE(bytes("hills.tif") == before);
  view("--camera camera.json --palette 4 --save-palette palette.json");
  write_text(path("colors.txt"), "0 1 2 3\n9 4 5 6\n");
  std::filesystem::create_hard_link(path("colors.txt"), path("link.txt"));
  for (const std::string line :
       {"--colors colors.txt --stats colors.txt", "--colors link.txt --stats colors.txt",
        "--use-palette palette.json --stats palette.json",
        "--from-camera camera.json --stats camera.json"})
    expect_refused(run(words("hills.tif --eye 48,7,+20 --overwrite " + line)),
                   {"read by this view"});
}

TEST_F(Output, OfAFailingRunIsNoFileAtAll) {
  for (const char* line :
       {"--layers none/a.tif -o a.png", "--stats none/s.json -o a.png", "-o a.png --camera /proc/c",
        "-o a.png --look-at 50,7", "-o a.png --colors none.txt", "-o a.png --window 0,0,99,99"}) {
    SCOPED_TRACE(line);
    EXPECT_EQ(run(words(std::string("hills.tif -q --eye 48,7,+20 --size 16x12 ") + line)).exit_code,
              2);
    EXPECT_EQ(outputs(), Names());
  }
}

TEST_F(Output, InAReadOnlyFolderIsRefused) {
  // Of the system's, so that root may not write there either.
  expect_refused(run(words("hills.tif --eye 48,7,+20 -o /proc/a.png")),
                 {"'/proc/a.png'", "cannot be written"});
}

TEST_F(Output, ThatTheDiskCannotHoldFailsAndLeavesNothing) {
  for (const std::string line :
       {"-o full.png", "-o full.jpg", "-o full.tif", "-o full.exr", "-o full.ppm", "-o full.webp",
        "-o a.png --layers full.tif", "-o a.png --layers full.exr"}) {
    SCOPED_TRACE(line);
    // The small picture beside full layers fits.
    const FullDisk disk(line.find("--layers") != std::string::npos ? 12000 : 1000);
    const Finished finished =
        run(words("hills.tif -q --no-sky --eye 47.985,6.99,900 --size 160x120 " + line));
    EXPECT_EQ(finished.exit_code, 1);
    EXPECT_EQ(finished.out, "");
    EXPECT_TRUE(says(finished.err, {"terrview: 'full.", "writing failed"}));
    EXPECT_EQ(finished.err.find('\n'), finished.err.size() - 1) << finished.err;
    EXPECT_EQ(outputs(), Names());
  }
}

TEST_F(Output, OfAnInterruptedRunIsNoFileAtAll) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    SCOPED_TRACE(signal);
    const Finished finished = interrupted_by(signal);
    EXPECT_EQ(finished.exit_code, 130);
    EXPECT_EQ(finished.err, "terrview: interrupted: nothing was written\n");
    EXPECT_EQ(outputs(), Names());
  }
}

TEST_F(Output, SurvivesASignalThatTheParentIgnores) {
  Program program(words("hills.tif -q --eye 48,7,+20 --size 200x200 -o a.png"),
                  folder_.path().string(), {.ignored_signal = SIGHUP});
  wait_for_outputs(1);
  program.send(SIGHUP);
  EXPECT_EQ(program.wait().exit_code, 0);
  EXPECT_EQ(outputs(), Names{"a.png"});
}

TEST_F(Output, IsWrittenThoughNobodyReadsTheMessages) {
  const Finished finished = run(words("hills.tif --eye 48,7,+20 --size 16x12 -o a.png"),
                                RunOptions{.unread_messages = true});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(outputs(), Names{"a.png"});
}

TEST_F(Output, HasTheSameBytesASecondLater) {
  const auto write_all = [&](const std::string& name) {
    view("-o " + name + ".png --layers " + name + "_layers.tif");
    view("-o " + name + ".tif --layers " + name + "_layers.exr");
    view("-o " + name + ".jpg");
  };
  write_all("a");
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  ::setenv("SOURCE_DATE_EPOCH", "1000000000", 1);
  write_all("b");
  for (const std::string name : {".png", ".tif", ".jpg", "_layers.tif", "_layers.exr"})
    EXPECT_TRUE(bytes("a" + name) == bytes("b" + name)) << name;
}

TEST_F(Output, IsTheSameForAnyNumberOfThreadsAndWithoutCoherence) {
  const std::string beginning = "hills.tif -q --eye 47.985,6.99,900 --size 96x72 ";
  const auto write_all = [&](const std::string& name, const std::string& options) {
    EXPECT_EQ(run(words(beginning + options + " -o " + name + ".png --layers " + name +
                        ".tif --camera " + name + ".json"))
                  .exit_code,
              0);
    EXPECT_EQ(run(words(beginning + options + " -o " + name + ".exr --layers " + name + "_l.exr"))
                  .exit_code,
              0);
  };
  write_all("one", "--threads 1");
  write_all("four", "--threads 4");
  write_all("plain", "--threads 2 --coherence off");
  for (const std::string other : {"four", "plain"}) {
    for (const std::string name : {".png", ".tif", ".json", ".exr", "_l.exr"})
      EXPECT_TRUE(bytes("one" + name) == bytes(other + name)) << other << name;
  }
}

TEST_F(Output, SaysInThePictureAllThatMakesIt) {
  write_text(path("map.txt"), "0 0 0 0\n2000 255 255 255\n");
  view(
      "-o a.png --roll 3 --sun 100,40 --no-shadows --normals facet --surface triangles "
      "--window 0,0,40,40 --voids open --nodata 12345 --colors map.txt --threads 3");
  const GDALDatasetUniquePtr picture(GDALDataset::Open(path("a.png").c_str()));
  ASSERT_TRUE(picture);
  const char* text = picture->GetMetadataItem("terrview_view");
  ASSERT_NE(text, nullptr);
  const nlohmann::json said = nlohmann::json::parse(text);
  EXPECT_EQ(said.at("camera").at("roll"), 3);
  EXPECT_EQ(said.at("dems"), nlohmann::json({"hills.tif"}));
  EXPECT_NEAR(said.at("sun").at("azimuth").get<double>(), 100, 1e-12);
  EXPECT_NEAR(said.at("sun").at("elevation").get<double>(), 40, 1e-12);
  EXPECT_EQ(said.at("shadows"), "none");
  EXPECT_EQ(said.at("normals"), "facet");
  EXPECT_EQ(said.at("surface"), "triangles");
  EXPECT_EQ(said.at("colors"), "map.txt");
  EXPECT_EQ(said.at("reading").at("window"), nlohmann::json({0, 0, 40, 40}));
  EXPECT_EQ(said.at("reading").at("voids"), "open");
  EXPECT_EQ(said.at("reading").at("nodata"), 12345);
  EXPECT_FALSE(says(text, {"threads"}));
}

TEST_F(Output, OfADemWithAnyNameIsWritten) {
  for (const std::string name : {"caf\xe9.tif", "a b'\"%s.tif", "\xe6\x97\xa5.tif", "-o.tif"}) {
    SCOPED_TRACE(name);
    std::filesystem::copy_file(path("hills.tif"), path(name));
    const Finished finished = run(
        {"./" + name, "--eye", "48,7,+20", "--size", "16x12", "-q", "-o", "a.png", "--overwrite"});
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
  }
}

}  // namespace
}  // namespace terrview
