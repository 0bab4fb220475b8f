// Shared by the C++ contenders: reading a set, timing an operation in samples, and answering
// requests.
//
// A contender is a program that reads one request a line, and answers each with one line of JSON:
//     op=find set=build/bench/sets/random5-1000 count=1000 seconds=0.2 limit=60 step=0.01
// or, for a person:   native_bench build/bench/sets/random5-1000 build find remove
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace contender {

struct Request {
  std::string operation;
  std::string set;        ///< path of the set, without the extension
  std::size_t count = 0;  ///< how many items to operate on; 0: as many as there are
  double seconds = 0.2;   ///< samples are taken until this much time has been measured
  double limit = 60;      ///< one sample is cut off after this many seconds
  double step = 0.01;     ///< length of a move, in mean spacings
};

struct Answer {
  std::vector<double> samples;  ///< microseconds per item
  std::size_t items = 0;        ///< per sample
  std::size_t visible = 0;      ///< visible sites at the end: contenders must agree
  double sink =
      0;  ///< made of all results: nothing is optimised away, and contenders can be compared
  bool isCutOff = false;  ///< a sample reached the limit and stands for fewer items
  std::string extra;      ///< further members as JSON, each with a leading comma
  std::string error;
};

inline std::vector<double> readDoubles(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return {};
  std::vector<double> values(static_cast<std::size_t>(file.tellg()) / sizeof(double));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(values.size() * sizeof(double)));
  return values;
}

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Takes samples: `prepare()` is not timed, `work(items)` is; it may lower `items` if it stops at
/// the limit.
template <class Prepare, class Work>
Answer sampled(const Request& request, std::size_t items, Prepare prepare, Work work) {
  constexpr std::size_t kMostSamples = 200;
  Answer answer;
  answer.items = items;
  double measured = 0;
  do {
    prepare();
    std::size_t done = items;
    const Stopwatch stopwatch;
    work(done);
    const double seconds = stopwatch.seconds();
    measured += seconds;
    answer.isCutOff = answer.isCutOff || done < items;
    answer.samples.push_back(1e6 * seconds / static_cast<double>(done));
  } while (measured < request.seconds && answer.samples.size() < kMostSamples && !answer.isCutOff);
  return answer;
}

/// Calls `step(k)` for k = 0, 1, ... until `items` are done or the time limit is reached, which
/// lowers `items`.
template <class Step>
void forEachUntil(double limit, std::size_t& items, Step step) {
  const Stopwatch stopwatch;
  for (std::size_t k = 0; k < items; ++k) {
    if ((k & 1023) == 1023 && stopwatch.seconds() > limit) {
      items = k;
      return;
    }
    step(k);
  }
}

inline void printJson(const Answer& answer) {
  if (!answer.error.empty()) {
    std::cout << "{\"error\":\"" << answer.error << "\"}" << std::endl;
    return;
  }
  std::cout.precision(6);
  std::cout << "{\"samples\":[";
  for (std::size_t k = 0; k < answer.samples.size(); ++k)
    std::cout << (k == 0 ? "" : ",") << answer.samples[k];
  std::cout.precision(17);
  std::cout << "],\"items\":" << answer.items << ",\"visible\":" << answer.visible
            << ",\"sink\":" << answer.sink
            << ",\"isCutOff\":" << (answer.isCutOff ? "true" : "false") << answer.extra << "}"
            << std::endl;
}

inline void printForPeople(const std::string& operation, const Answer& answer) {
  if (!answer.error.empty()) {
    std::printf("%-14s %s\n", operation.c_str(), answer.error.c_str());
    return;
  }
  std::vector<double> sorted = answer.samples;
  std::sort(sorted.begin(), sorted.end());
  std::printf("%-14s %9.4f us  (%.4f .. %.4f, %zu samples of %zu, %zu visible%s)%s\n",
              operation.c_str(), sorted[sorted.size() / 2], sorted.front(), sorted.back(),
              sorted.size(), answer.items, answer.visible, answer.isCutOff ? ", cut off" : "",
              answer.extra.c_str());
}

inline Request parsed(const std::string& line) {
  Request request;
  std::istringstream words(line);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    const std::string key = word.substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : word.substr(equals + 1);
    if (key == "op") request.operation = value;
    if (key == "set") request.set = value;
    if (key == "count") request.count = std::stoull(value);
    if (key == "seconds") request.seconds = std::stod(value);
    if (key == "limit") request.limit = std::stod(value);
    if (key == "step") request.step = std::stod(value);
  }
  return request;
}

/// The main function of a contender.
inline int serve(int argc, char** argv, const std::function<Answer(const Request&)>& answer) {
  if (argc > 2) {
    for (int k = 2; k < argc; ++k) {
      Request request;
      request.set = argv[1];
      request.operation = argv[k];
      request.seconds = 1;
      printForPeople(request.operation, answer(request));
    }
    return 0;
  }
  for (std::string line; std::getline(std::cin, line);) printJson(answer(parsed(line)));
  return 0;
}

}  // namespace contender
