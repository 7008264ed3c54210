#include "bench/bench_result.h"

#include <algorithm>

namespace terrview {
namespace {

using Json = nlohmann::ordered_json;

// Calls visit(name, member) for every field, in the order of the file.
template <class Result, class Visit>
void visit_fields(Result& result, Visit visit) {
  visit("dem", result.dem);
  visit("view", result.view);
  visit("rays", result.rays);
  visit("contender", result.contender);
  visit("threads", result.threads);
  visit("surface", result.surface);
  visit("mrays_per_s", result.mrays_per_s);
  visit("ray_count", result.ray_count);
  visit("hit_share", result.hit_share);
  visit("seconds", result.seconds);
  visit("tests_per_ray", result.tests_per_ray);
  visit("nodes_per_ray", result.nodes_per_ray);
  visit("build_s", result.build_s);
  visit("memory_mib", result.memory_mib);
  visit("cells_differ", result.cells_differ);
  visit("hit_flips", result.hit_flips);
  visit("p50_rel_error", result.p50_rel_error);
  visit("p99_rel_error", result.p99_rel_error);
  visit("max_rel_error", result.max_rel_error);
}

template <class Value>
Json json_of(const Value& value) {
  return value;
}

template <class Value>
Json json_of(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

template <class Value>
void read(const Json& json, Value& value) {
  value = json.get<Value>();
}

template <class Value>
void read(const Json& json, std::optional<Value>& value) {
  if (!json.is_null()) value = json.get<Value>();
}

}  // namespace

bool is_same_frame(const BenchResult& a, const BenchResult& b) {
  return a.dem == b.dem && a.view == b.view && a.rays == b.rays && a.threads == b.threads;
}

const BenchResult* beside(const std::vector<BenchResult>& results, const BenchResult& one,
                          const std::string& contender) {
  const auto found = std::find_if(results.begin(), results.end(), [&](const BenchResult& other) {
    return is_same_frame(other, one) && other.contender == contender;
  });
  return found == results.end() ? nullptr : &*found;
}

Json to_json(const BenchRun& run) {
  Json results = Json::array();
  for (const BenchResult& result : run.results) {
    Json json;
    visit_fields(result, [&](const char* name, const auto& value) { json[name] = json_of(value); });
    results.push_back(std::move(json));
  }
  return {{"machine", run.machine},
          {"command", run.command},
          {"date", run.date},
          {"results", std::move(results)}};
}

BenchRun run_from_json(const Json& json) {
  BenchRun run{json.at("machine"),
               json.at("command").get<std::string>(),
               json.at("date").get<std::string>(),
               {}};
  for (const Json& entry : json.at("results")) {
    BenchResult result;
    visit_fields(result, [&](const char* name, auto& value) { read(entry.at(name), value); });
    run.results.push_back(std::move(result));
  }
  return run;
}

}  // namespace terrview
