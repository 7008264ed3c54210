#include "cli/batch/fingerprint.h"

#include <filesystem>
#include <fstream>
#include <memory>
#include <system_error>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "ingest/file_list.h"

namespace terrview {
namespace {

std::string hexadecimal(XXH128_hash_t hash) {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, hash);
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : canonical.digest) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

struct FreeState {
  void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

}  // namespace

std::string hash_of(std::string_view bytes) {
  return hexadecimal(XXH3_128bits(bytes.data(), bytes.size()));
}

std::optional<FileStamp> stamp_file(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return std::nullopt;
  std::ifstream stream(path, std::ios::binary);
  const std::unique_ptr<XXH3_state_t, FreeState> state(XXH3_createState());
  XXH3_128bits_reset(state.get());
  FileStamp stamp{path, 0, ""};
  std::vector<char> buffer(std::size_t{1} << 20);
  while (stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) ||
         stream.gcount() > 0) {
    const auto count = static_cast<std::size_t>(stream.gcount());
    XXH3_128bits_update(state.get(), buffer.data(), count);
    stamp.bytes += count;
  }
  if (!stream.eof()) return std::nullopt;
  stamp.xxh3 = hexadecimal(XXH3_128bits_digest(state.get()));
  return stamp;
}

const std::vector<FileStamp>& InputStamps::of(const std::string& path) {
  const auto known = known_.find(path);
  if (known != known_.end()) return known->second;
  std::vector<FileStamp>& stamps = known_[path];
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return stamps;
  for (const std::string& file : files_of(path))
    if (const auto stamp = stamp_file(file)) stamps.push_back(*stamp);
  return stamps;
}

}  // namespace terrview
