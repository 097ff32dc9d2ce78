// SPDX-License-Identifier: Apache-2.0
// Writes a Markdown table from the JSON of the benchmarks: `bench_report step.json scenarios.json [--loop loop.json]`.
// The last file comes from `hapticut loop ... --json loop.json`. Each ratio is that of one repetition of one run; the
// table has the median.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

using nlohmann::json;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

/// All counters of all benchmarks, one value per repetition.
class Results {
 public:
  void read(const std::string& file) {
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error(file + " cannot be read; run scripts/bench.sh, which writes it.");
    std::stringstream text;
    text << stream.rdbuf();
    // Google Benchmark writes the variation of counters that are all zero as NaN, which is not valid JSON.
    const json all = json::parse(std::regex_replace(text.str(), std::regex(": -?[nN]a[nN]"), ": null"));
    context_ = all.at("context");
    for (const json& run : all.at("benchmarks")) {
      if (run.at("run_type") != "iteration") continue;
      std::string name = run.at("name");
      name.resize(std::min(name.size(), name.find("/iterations:")));
      if (!runs_.contains(name)) order_.push_back(name);
      runs_[name].push_back(run);
    }
  }

  [[nodiscard]] std::optional<double> value(const std::string& name, const std::string& counter) const {
    const auto found = runs_.find(name);
    if (found == runs_.end() || !found->second.front().contains(counter)) return std::nullopt;
    std::vector<double> values;
    for (const json& run : found->second) values.push_back(run.at(counter));
    return median(values);
  }

  /// Median over the repetitions of the ratio of a counter.
  [[nodiscard]] std::optional<double> ratio(const std::string& ours, const std::string& theirs,
                                            const std::string& counter) const {
    const auto a = runs_.find(ours), b = runs_.find(theirs);
    if (a == runs_.end() || b == runs_.end()) return std::nullopt;
    std::vector<double> ratios;
    for (std::size_t n = 0; n < std::min(a->second.size(), b->second.size()); ++n)
      ratios.push_back(double(a->second[n].at(counter)) / double(b->second[n].at(counter)));
    return median(ratios);
  }

  [[nodiscard]] const std::vector<std::string>& names() const { return order_; }
  [[nodiscard]] const json& context() const { return context_; }

 private:
  std::map<std::string, std::vector<json>> runs_;
  std::vector<std::string> order_;
  json context_;
};

void print_row(const std::string& what, double target, const std::optional<double>& measured) {
  if (measured)
    std::printf("| %s | %.4g | %.3g | %s |\n", what.c_str(), target, *measured, *measured <= target ? "yes" : "**no**");
  else
    std::printf("| %s | %.4g | not run | |\n", what.c_str(), target);
}

/// Ratios to the loops that compute only a force, and of other heads to a ball. The goals differ by instruction set.
void print_ratios(const Results& r) {
  const bool wide = r.context().value("kernels", "") == "AVX-512";
  const auto row = [&](const std::string& what, double goal_512, double goal_avx2, std::optional<double> measured) {
    print_row(what, wide ? goal_512 : goal_avx2, measured);
  };
  const auto step = [](const char* path, const char* h, const char* R) {
    return std::string("step/") + path + "/h" + h + "/R" + R + "/";
  };
  const auto over_simd = [&](const char* ours, const char* path, const char* h, const char* R, double goal_512,
                             double goal_avx2) {
    const std::string at = step(path, h, R);
    row(std::string(ours) + " / dense_simd, p50, " + path + " R " + R + ", " + h + " mm", goal_512, goal_avx2,
        r.ratio(at + ours, at + "dense_simd", "p50_us"));
  };
  over_simd("hapticut", "W2", "0.1", "2", 1.1, 1.6);
  over_simd("hapticut", "W2", "0.05", "2", 0.95, 1.4);
  over_simd("hapticut", "W3", "0.1", "2", 0.9, 1.2);
  over_simd("hapticut", "W3", "0.05", "3", 0.7, 1.0);
  over_simd("hapticut_static", "W1", "0.1", "2", 1.9, 1.9);
  over_simd("hapticut_static", "W1", "0.05", "2", 1.8, 1.8);
  over_simd("hapticut_static", "W3", "0.1", "2", 1.5, 1.5);
  for (const auto& [h, goal] : {std::pair("0.1", 0.25), std::pair("0.05", 0.13)}) {
    const std::string at = step("W2", h, "2");
    row("hapticut / vdb_accessor, mean, W2 R 2, " + std::string(h) + " mm", goal, goal,
        r.ratio(at + "hapticut", at + "vdb_accessor", "mean_us"));
    row("hapticut / proxy_one (one voxel a tick), mean, W2 R 2, " + std::string(h) + " mm", 1, 1,
        r.ratio(at + "hapticut", at + "proxy_one", "mean_us"));
  }
  row("hapticut in 0.1 mm / dense_simd in 0.05 mm, p50, W2 R 2 (equal error)", 0.22, 0.22,
      r.ratio(step("W2", "0.1", "2") + "hapticut", step("W2", "0.05", "2") + "dense_simd", "p50_us"));
  for (const auto& [kind, goal] : {std::pair("pear", 2.0), std::pair("tree", 3.0)}) {
    const std::string profile = std::string("heads/profile_") + kind;
    row(std::string(kind) + " / sphere, cutting, per voxel", 1.5, 1.5,
        r.ratio(profile + "/cutting", "heads/sphere/cutting", "ns_per_contact_voxel"));
    row(std::string(kind) + " / sphere, standing, per voxel", goal, goal,
        r.ratio(profile + "/static", "heads/sphere/static", "ns_per_contact_voxel"));
  }
  for (const auto& [h, goal] : {std::pair("0.1", 900.0), std::pair("0.05", 4000.0)})
    row("longest tick [us], W3 R 3, " + std::string(h) + " mm", goal, goal,
        r.value(step("W3", h, "3") + "hapticut", "max_us"));
}

void print_targets(const Results& r) {
  std::printf("| what | at most | measured | met |\n|---|---|---|---|\n");
  print_ratios(r);
  print_row("deadline misses in 60 s, 0.05 mm, R 2", 0, r.value("deadline/h0.05/R2", "misses"));
  print_row("p99.9 [us] in 60 s, 0.05 mm, R 2", 700, r.value("deadline/h0.05/R2", "p999_us"));
  print_row("p99.9 [us] in 60 s, 0.1 mm, R 3", 500, r.value("deadline/h0.1/R3", "p999_us"));
  if (const auto late = r.value("deadline/arithmetic", "misses"))
    std::printf("| the same ticks of arithmetic alone: late by the machine | | %.3g | |\n", *late);
  print_row("ten times larger workpiece, p50", 1.05, r.ratio("sizes/x10", "sizes/x1", "p50_us"));
  print_row("page faults in 60 s", 0, r.value("deadline/h0.05/R2", "page_faults"));
  print_row("allocations in 60 s", 0, r.value("deadline/h0.05/R2", "allocations"));
  print_row("load 256 M voxels in layers [ms]", 5000, r.value("load/layers", "real_time"));
  print_row("load 256 M voxels, mixed [ms]", 5000, r.value("load/mixed", "real_time"));
  print_row("64 dirty blocks to pages [ms]", 4, r.value("surface/dirty64", "ms_of_64_blocks"));
  print_row("one dirty block to pages [us]", 37, r.value("surface/dirty64", "us_per_block"));
  print_row("from a cut to its pages, p99 [ms]", 33, r.value("surface/latency", "age_p99_ms"));
  print_row("64 nearest pages of 256 M voxels [ms]", 1000, r.value("surface/first", "nearest_64_pages_ms"));
  print_row("bytes per voxel, mixed", 1.5, r.value("load/mixed", "bytes_per_voxel"));
}

void print_all(const Results& r) {
  std::printf(
      "\n| benchmark | p50 us | p99 us | p99.9 us | max us | misses | allocations | voxels in contact | ns per voxel "
      "|\n");
  std::printf("|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string& name : r.names()) {
    if (!r.value(name, "p50_us")) continue;
    const auto v = [&](const char* counter) { return r.value(name, counter).value_or(0); };
    std::printf("| %s | %.1f | %.1f | %.1f | %.0f | %.0f | %.0f | %.0f | %.2f |\n", name.c_str(), v("p50_us"),
                v("p99_us"), v("p999_us"), v("max_us"), v("misses"), v("allocations"), v("contact_voxels"),
                v("ns_per_contact_voxel"));
  }
}

/// Prints the delays and compute times of the ticks of the loop, and the missed ticks.
void print_loop(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(file + " cannot be read; `hapticut loop` writes it.");
  const json loop = json::parse(stream);
  std::printf("\n| loop at %.0f Hz, %.0f ticks | p50 us | p99 us | p99.9 us | max us |\n|---|---|---|---|---|\n",
              loop.at("rate_Hz").get<double>(), loop.at("ticks").get<double>());
  for (const auto& [what, key] :
       {std::pair("woke up late by", "wake_up_us"), std::pair("computed for", "compute_us")}) {
    const json& times = loop.at(key);
    const auto v = [&](const char* name) { return times.at(name).get<double>(); };
    std::printf("| %s | %.1f | %.1f | %.1f | %.0f |\n", what, v("p50"), v("p99"), v("p999"), v("max"));
  }
  std::printf("\n%.0f ticks missed, %.0f computed for longer than a period.\n", loop.at("missed_ticks").get<double>(),
              loop.at("deadline_misses").get<double>());
}

}  // namespace

int main(int argc, char** argv) try {
  Results results;
  std::string loop;
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) == "--loop" && i + 1 < argc)
      loop = argv[++i];
    else
      results.read(argv[i]);
  }
  if (results.names().empty()) throw std::runtime_error("usage: bench_report RESULTS.json ... [--loop LOOP.json]");
  print_targets(results);
  print_all(results);
  if (!loop.empty()) print_loop(loop);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "bench_report: %s\n", error.what());
  return 1;
}
