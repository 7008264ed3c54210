#include "cli/batch/manifest.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "cli/command_line.h"
#include "cli/read_file.h"
#include "terrain/error.h"

namespace terrview {
namespace {

using Json = nlohmann::ordered_json;

std::string one_line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json stamps_json(const std::vector<FileStamp>& stamps) {
  Json list = Json::array();
  for (const FileStamp& stamp : stamps)
    list.push_back({{"path", stamp.path}, {"bytes", stamp.bytes}, {"xxh3", stamp.xxh3}});
  return list;
}

std::vector<FileStamp> stamps_of(const Json& list) {
  std::vector<FileStamp> stamps;
  for (const Json& stamp : list)
    stamps.push_back({stamp.at("path"), stamp.at("bytes"), stamp.at("xxh3")});
  return stamps;
}

ManifestHeader header_of(const Json& json) {
  ManifestHeader header{json.at("jobs"), {}, json.at("table")};
  if (const Json& shard = json.at("shard"); !shard.is_null())
    header.shard = {shard.at(0), shard.at(1)};
  return header;
}

JobRecord record_of(const Json& json) {
  const Json& error = json.at("error");
  return {json.at("job"),
          json.at("name").is_null() ? "" : json.at("name"),
          json.at("options"),
          stamps_of(json.at("inputs")),
          stamps_of(json.at("outputs")),
          json.at("seconds"),
          error.is_null() ? "" : error};
}

void take_line(const Json& json, Manifest& manifest) {
  if (json.contains("batch")) {
    const ManifestHeader header = header_of(json.at("batch"));
    const ManifestHeader& before = manifest.header;
    if (header.table != before.table || header.jobs != before.jobs) manifest.of_job.clear();
    manifest.header = header;
    return;
  }
  const JobRecord& record = manifest.records.emplace_back(record_of(json));
  manifest.of_job[record.job] = manifest.records.size() - 1;
  for (const FileStamp& output : record.outputs)
    manifest.of_output[output.path] = manifest.records.size() - 1;
}

// Of a file without a whole line.
bool may_begin_header(const std::string& text) {
  const std::string beginning = R"({"batch":{)";
  return text.substr(0, beginning.size()) == beginning.substr(0, text.size());
}

}  // namespace

std::string ManifestHeader::line() const {
  Json json{{"program", std::string("terrview ") + kVersion}, {"jobs", jobs}, {"shard", nullptr}};
  if (shard.count > 1) json["shard"] = {shard.number, shard.count};
  json["table"] = table;
  return one_line({{"batch", json}});
}

std::string JobRecord::line() const {
  Json json{{"job", job}, {"name", name}, {"options", options}};
  json["inputs"] = stamps_json(inputs);
  json["outputs"] = stamps_json(outputs);
  json["seconds"] = seconds;
  json["error"] = error.empty() ? Json() : Json(error);
  return one_line(json);
}

Manifest parse_manifest(std::string_view text, const std::string& name) {
  Manifest manifest;
  for (int number = 1; text.find('\n') != std::string_view::npos; ++number) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(line.size() + 1);
    try {
      take_line(Json::parse(line), manifest);
    } catch (const Json::exception&) {
      throw InputError("'" + name + "', line " + std::to_string(number) +
                       ": is none of a manifest: name another file, or remove the line");
    }
  }
  return manifest;
}

void check_is_new(const std::string& path) {
  std::error_code none;
  const auto bytes = std::filesystem::file_size(path, none);
  if (!none && bytes > 0)
    throw InputError("'" + path +
                     "': exists already: give --resume to go on with it, or --overwrite");
}

ManifestFile::ManifestFile(std::string path, Existing existing)
    : path_(std::move(path)),
      file_(::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
  try {
    if (file_ < 0)
      throw InputError("'" + path_ + "': cannot be written (" + std::strerror(errno) +
                       "): check its folder");
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0)
      throw InputError("'" + path_ +
                       "': another batch is writing it: wait for that, or name another --manifest");
    const std::string text = read_file(path_);
    const std::size_t whole = text.rfind('\n') + 1;
    Manifest held = parse_manifest(text.substr(0, whole), path_);
    if (whole == 0 && !may_begin_header(text))
      throw InputError("'" + path_ + "': is no manifest: name another file");
    if (existing == Existing::refuse) check_is_new(path_);
    const std::size_t kept = existing == Existing::go_on ? whole : 0;
    if (existing == Existing::go_on) before_ = std::move(held);
    if (::ftruncate(file_, static_cast<off_t>(kept)) != 0)
      throw InputError("'" + path_ + "': cannot be shortened (" + std::strerror(errno) +
                       "): name a regular file");
  } catch (const InputError&) {
    if (file_ >= 0) ::close(file_);
    throw;
  }
}

ManifestFile::~ManifestFile() {
  struct stat now {};
  // Gives back what was reserved.
  if (::fstat(file_, &now) == 0) static_cast<void>(::ftruncate(file_, now.st_size));
  ::close(file_);
}

void ManifestFile::reserve(std::size_t lines) {
  constexpr std::size_t kLine_bytes = 1024;
  struct stat now {};
  if (::fstat(file_, &now) == 0)
    static_cast<void>(::fallocate(file_, FALLOC_FL_KEEP_SIZE, now.st_size,
                                  static_cast<off_t>(lines * kLine_bytes)));
}

void ManifestFile::append(const std::string& line) {
  const std::lock_guard lock(mutex_);
  pending_ += line;
  write_pending();
}

bool ManifestFile::complete() {
  const std::lock_guard lock(mutex_);
  write_pending();
  return pending_.empty();
}

void ManifestFile::write_pending() {
  struct stat before {};
  if (pending_.empty() || ::fstat(file_, &before) != 0) return;
  const ssize_t written = ::write(file_, pending_.data(), pending_.size());
  if (written == static_cast<ssize_t>(pending_.size()) && ::fdatasync(file_) == 0) {
    pending_.clear();
  } else {
    static_cast<void>(::ftruncate(file_, before.st_size));
  }
}

}  // namespace terrview
