// Promises of cli/batch/fingerprint.h, ingest/file_list.h and cli/shared_inputs.h.
#include "cli/batch/fingerprint.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "cli/shared_inputs.h"
#include "ingest/file_list.h"
#include "terrain/error.h"
#include "tests/ingest/test_raster.h"
#include "tests/support/temporary_folder.h"

namespace terrview {
namespace {

TEST(Fingerprint, IsXxh3Of128Bits) {
  // The XXH3 test vector of nothing, as `xxhsum -H2 /dev/null` prints it.
  EXPECT_EQ(hash_of(""), "99aa06d3014798d86001c324468d497f");
}

TEST(Fingerprint, OfAFileIsThatOfItsBytes) {
  const TemporaryFolder folder;
  for (const std::size_t size : {0U, 1U, 5000U, (1U << 20) - 1, 1U << 20, (1U << 20) + 7}) {
    std::string bytes(size, 'x');
    if (size > 0) bytes.back() = 'y';
    write_text(folder / "f", bytes);
    EXPECT_EQ(stamp_file(folder / "f"), (FileStamp{folder / "f", size, hash_of(bytes)}));
  }
  EXPECT_FALSE(stamp_file(folder / "none"));
  EXPECT_FALSE(stamp_file(folder.path().string()));
}

TEST(Fingerprint, OfAnInputHasTheFilesThatGdalReadsWithIt) {
  const TemporaryFolder folder;
  TestRaster raster;
  raster.columns = 3;
  raster.rows = 2;
  raster.number = [](int column, int row) { return column + row; };
  raster.write(folder / "d.tif");
  write_text(folder / "v.vrt",
             "<VRTDataset rasterXSize=\"3\" rasterYSize=\"2\"><VRTRasterBand dataType=\"Float32\" "
             "band=\"1\"><SimpleSource><SourceFilename relativeToVRT=\"1\">d.tif</SourceFilename>"
             "</SimpleSource></VRTRasterBand></VRTDataset>");
  EXPECT_EQ(files_of(folder / "v.vrt"),
            (std::vector<std::string>{folder / "v.vrt", folder / "d.tif"}));
  write_text(folder / "t.txt", "no raster");
  EXPECT_EQ(files_of(folder / "t.txt"), std::vector<std::string>{folder / "t.txt"});
  InputStamps stamps;
  EXPECT_EQ(stamps.of(folder / "v.vrt").size(), 2U);
  EXPECT_TRUE(stamps.of(folder / "none").empty());
}

TEST(SharedFile, IsReadOnceWhileItIsUsedAndAgainAfterAFailure) {
  SharedFile<int> file;
  int reads = 0;
  const auto read = [&] { return std::make_shared<const int>(++reads); };
  const auto fail = []() -> std::shared_ptr<const int> { throw InputError("gone"); };
  EXPECT_THROW(static_cast<void>(file.get("a", fail)), InputError);
  const auto first = file.get("a", read);
  EXPECT_EQ(*file.get("b", read), 2);
  EXPECT_EQ(file.get("a", fail), first);
  EXPECT_EQ(*file.get("a", read), 1);
}

}  // namespace
}  // namespace terrview
