// Files that several views read, read once.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "cli/view_water.h"
#include "ingest/dem.h"
#include "ingest/footprints.h"
#include "render/drape.h"

namespace terrview {

// What was read under a key, as long as somebody uses it; and the last one.
template <class Value>
class SharedFile {
 public:
  // Of several threads that want one key, one reads. What `read` throws is not kept.
  std::shared_ptr<const Value> get(const std::string& key,
                                   const std::function<std::shared_ptr<const Value>()>& read) {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<const Value> value = known_[key].lock();
    if (!value) known_[key] = value = read();
    last_ = value;
    return value;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, std::weak_ptr<const Value>> known_;
  std::shared_ptr<const Value> last_;
};

// Its functions may be called from several threads, and throw InputError. The memory is the same at
// every call.
class SharedInputs {
 public:
  std::shared_ptr<const FootprintFile> footprints(const std::string& path,
                                                  const FootprintOptions& options);
  std::shared_ptr<const TreeFile> trees(const std::string& path);
  // `dems`: one for each layer of a terrain.
  std::shared_ptr<const Drape> drape(const std::string& path, const std::vector<Dem>& dems,
                                     std::size_t memory_bytes);
  std::shared_ptr<const LaidWater> water(const WaterOptions& options, const std::vector<Dem>& dems);

 private:
  SharedFile<FootprintFile> footprints_;
  SharedFile<TreeFile> trees_;
  SharedFile<Drape> drapes_;
  SharedFile<LaidWater> water_;
};

}  // namespace terrview
