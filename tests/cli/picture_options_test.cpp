// The options of air, rays and previews: docs/cli.md.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>
#include <utility>

#include <OpenImageIO/imageio.h>

#include "tests/cli/small_view.h"

namespace terrview {
namespace {

class PictureOptions : public SmallView {
 protected:
  // A picture's pixels, without what it says of itself.
  [[nodiscard]] std::string pixels(const std::string& line) const {
    view(line + " -o pixels.ppm --overwrite");
    return bytes("pixels.ppm");
  }

  // Channels of an EXR by name.
  [[nodiscard]] Layers exr(const std::string& name) const {
    const auto file = OIIO::ImageInput::open(path(name));
    if (!file) throw std::runtime_error("no picture in " + name);
    const OIIO::ImageSpec& spec = file->spec();
    const auto pixels =
        static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    std::vector<float> values(pixels * channels);
    file->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, values.data());
    Layers found{spec.width, spec.height, spec.channelnames, {}};
    for (std::size_t c = 0; c < channels; ++c) {
      std::vector<double> band(pixels);
      for (std::size_t p = 0; p < pixels; ++p) band[p] = values[p * channels + c];
      found.bands.push_back(std::move(band));
    }
    return found;
  }
};

TEST_F(PictureOptions, VisibilityIs60KilometresUnlessSaidAndInfMeansNoAir) {
  EXPECT_EQ(pixels(""), pixels("--visibility 60"));
  EXPECT_EQ(pixels("--visibility 60"), pixels("--extinction 0.0652"));
  EXPECT_NE(pixels("--visibility 5"), pixels(""));
  EXPECT_EQ(pixels("--visibility inf"), pixels("--extinction 0"));
  EXPECT_NE(pixels("--visibility inf"), pixels("--visibility 20"));
}

TEST_F(PictureOptions, AirColoursAreTaken) {
  const std::string thick = "--visibility 2 --samples 1";
  EXPECT_NE(pixels(thick + " --air-color 250,20,20"), pixels(thick));
  EXPECT_NE(pixels(thick + " --air-color-sun 250,20,20"), pixels(thick));
}

TEST_F(PictureOptions, TheAirCanBeTakenOutOfAnExr) {
  view("--samples 1 --visibility 3 -o a.exr --layers l.exr");
  view("--samples 1 --visibility inf -o clear.exr");
  const Layers picture = exr("a.exr");
  const Layers clear = exr("clear.exr");
  const Layers layer = exr("l.exr");
  const char* const kAxes[] = {"R", "G", "B"};
  int hazed = 0;
  for (int row = 0; row < 48; ++row) {
    for (int column = 0; column < 64; ++column) {
      const double q = layer.at("q", column, row);
      const double distance_m = layer.at("distance", column, row);
      if (!std::isnan(distance_m)) {
        ASSERT_NEAR(q, std::exp(-3.912 / 3000 * distance_m), 1e-5);
        hazed += q < 0.9 ? 1 : 0;
      } else {
        ASSERT_EQ(q, 1);
      }
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double base = layer.at(std::string("clear.") + kAxes[axis], column, row);
        const double air = layer.at(std::string("air.") + kAxes[axis], column, row);
        const auto at = static_cast<std::size_t>(row * 64 + column);
        ASSERT_NEAR(base, clear.bands[axis][at], 1e-6);
        ASSERT_NEAR(base * q + air * (1 - q), picture.bands[axis][at], 1e-6);
      }
    }
  }
  EXPECT_GT(hazed, 500);
}

TEST_F(PictureOptions, RaysAreAdaptiveUnlessSaid) {
  const auto rays = [&](const std::string& line) {
    view(line + " --overwrite -o a.png --stats s.json");
    return json("s.json").at("rays").get<int>();
  };
  constexpr int kPixels = 64 * 48;
  EXPECT_EQ(rays("--samples 1"), kPixels);
  EXPECT_EQ(rays("--samples 4"), 4 * kPixels);
  EXPECT_GT(rays(""), kPixels);
  EXPECT_LT(rays(""), 8 * kPixels);
  EXPECT_GT(rays("--aa 0.005"), rays(""));
  EXPECT_EQ(rays("--aa 0.03"), rays(""));
  EXPECT_LT(rays("--preview"), kPixels);
  EXPECT_EQ(pixels(""), pixels("--aa 0.03 --threads 3"));
}

TEST_F(PictureOptions, LayersAreThoseOfThePixelsCentresWhateverTheRays) {
  view("--samples 1 --layers a.tif -o a.png");
  for (const std::string line : {"--samples 5", "--aa 0.01", "--haze 3 --visibility 2"}) {
    view(line + " --overwrite --layers b.tif -o b.png");
    EXPECT_TRUE(bytes("a.tif") == bytes("b.tif")) << line;
  }
}

TEST_F(PictureOptions, HazeBlurs) {
  const std::string line = "--visibility 2 --size 160x120 ";
  EXPECT_NE(pixels(line + "--haze 2"), pixels(line));
  EXPECT_EQ(pixels(line + "--haze 0"), pixels(line));
  EXPECT_EQ(pixels(line + "--haze 2 --threads 1"), pixels(line + "--haze 2 --threads 4"));
}

TEST_F(PictureOptions, AProgressivePictureEndsAsTheDirectOneToTheByte) {
  for (const std::string line : {"", "--samples 1", "--haze 2 --visibility 2"}) {
    view(line + " --overwrite -o direct.png");
    view(line + " --overwrite -o same.png --progressive p.png");
    EXPECT_TRUE(bytes("p.png") == bytes("direct.png")) << line;
    EXPECT_TRUE(bytes("same.png") == bytes("direct.png")) << line;
  }
  expect_refused(run(words("hills.tif --eye 48,7,+20 -o b.png --progressive p.png")),
                 {"p.png", "--overwrite"});
  expect_refused(run(words("hills.tif --eye 48,7,+20 -o q.png --progressive q.png")),
                 {"q.png", "two outputs"});
}

TEST_F(PictureOptions, AProgressivePictureOutlivesAnInterruption) {
  Program program(words("hills.tif -q --eye 47.985,6.99,900 --size 2500x2500 --samples 200 "
                        "--threads 1 -o a.png --progressive p.png"),
                  folder_.path().string());
  for (int tries = 0; tries < 6000; ++tries) {
    const auto names = outputs();
    if (std::find(names.begin(), names.end(), "p.png") != names.end()) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  program.send(SIGTERM);
  const Finished finished = program.wait();
  EXPECT_EQ(finished.exit_code, 130);
  EXPECT_EQ(finished.err, "terrview: interrupted: 'p.png' is as far as it came\n");
  EXPECT_EQ(outputs(), std::vector<std::string>{"p.png"});
  EXPECT_EQ(bytes("p.png").substr(1, 3), "PNG");
}

TEST_F(PictureOptions, WhatCannotBeIsRefused) {
  const std::vector<std::pair<const char*, std::vector<std::string>>> lines{
      {"--visibility 0", {"--visibility 0", "inf"}},
      {"--visibility far", {"--visibility far", "kilometres"}},
      {"--visibility 3 --extinction 1", {"--visibility", "--extinction"}},
      {"--extinction -1", {"--extinction", "per kilometre"}},
      {"--air-color 1,2", {"--air-color", "3 numbers"}},
      {"--air-color-sun 300,0,0", {"--air-color-sun", "0 to 255"}},
      {"--haze -1", {"--haze", "0 to 100"}},
      {"--haze 1 --visibility inf", {"--haze", "--visibility KM"}},
      {"--samples 0", {"--samples", "1 to 1024"}},
      {"--samples 4 --aa 0.1", {"--samples", "--aa"}},
      {"--aa 2", {"--aa", "0 to 1"}},
      {"--preview --samples 3", {"--preview", "--samples"}},
      {"--preview --layers a.tif", {"--layers", "--preview"}},
      {"--progressive a.bmp", {"a.bmp", ".png"}},
  };
  for (const auto& [line, parts] : lines) {
    SCOPED_TRACE(line);
    expect_refused(run(words(std::string("hills.tif --eye 48,7,900 ") + line)), parts);
    EXPECT_EQ(outputs(), std::vector<std::string>());
  }
}

}  // namespace
}  // namespace terrview
