// Without a fuzzer: every target on its seeds and its corpus, and on some changes of each. What tools/fuzz moves
// corpora with.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string>

#include "fuzz/corpus.hpp"
#include "fuzz/mutate.hpp"

using namespace facet;
using namespace facet::fuzz;

namespace {

namespace fs = std::filesystem;

// The input that is being tried: where a target ends the program, it is left here.
fs::path lastInput;

void tryInput(const Target& target, const Bytes& input) {
  if (!lastInput.empty()) {
    std::ofstream out(lastInput, std::ios::binary);
    out.write(reinterpret_cast<const char*>(input.data()), static_cast<std::streamsize>(input.size()));
  }
  target.run(input);
}

Bytes damaged(Bytes bytes, std::mt19937& random) {
  for (size_t i = 1 + random() % 4; i > 0 && !bytes.empty(); --i)
    bytes[random() % bytes.size()] = static_cast<uint8_t>(random());
  if (random() % 8 == 0) bytes.resize(random() % (bytes.size() + 1));
  return bytes;
}

// Seeds, corpus, `changes` of each; how many that were.
size_t replay(const Target& target, const fs::path& corpora, size_t changes) {
  std::vector<Bytes> inputs = target.seeds();
  const std::vector<Bytes> corpus = readCorpus(corpora / (std::string(target.name) + ".bin"));
  inputs.insert(inputs.end(), corpus.begin(), corpus.end());
  tryInput(target, {});
  std::mt19937 random(1);
  size_t count = 1;
  for (const Bytes& input : inputs) {
    tryInput(target, input);
    for (size_t i = 0; i < changes; ++i)
      tryInput(target, target.json && i % 2 == 0 ? mutateJson(input, random) : damaged(input, random));
    count += 1 + changes;
  }
  return count;
}

int replayAll(const fs::path& corpora, std::string_view wanted, size_t changes) {
  for (const Target& target : targets()) {
    if (wanted != "all" && wanted != target.name) continue;
    const auto start = std::chrono::steady_clock::now();
    const size_t count = replay(target, corpora, changes);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    std::printf("%s: %zu inputs, %.1f s\n", target.name, count, spent.count());
    std::fflush(stdout);
  }
  return 0;
}

int usage() {
  std::fputs(
      "facet_fuzz_replay CORPORA [TARGET|all] [CHANGES]  tries seeds, corpus and so many changes of each\n"
      "facet_fuzz_replay --list                      names the targets\n"
      "facet_fuzz_replay --input TARGET FILE         tries one input\n"
      "facet_fuzz_replay --unpack TARGET CORPORA DIR seeds and corpus as files\n"
      "facet_fuzz_replay --pack TARGET DIR CORPORA BYTES  the files of DIR, smallest first, as the corpus\n",
      stderr);
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty()) return usage();
  if (const char* file = std::getenv("FACET_FUZZ_LAST")) lastInput = file;
  if (words[0] == "--list") {
    for (const Target& target : targets())
      std::printf("%-12s %6zu  %s\n", target.name, target.maxBytes, target.summary);
    return 0;
  }
  if (!words[0].starts_with("--"))
    return replayAll(words[0], words.size() > 1 ? words[1] : "all", words.size() > 2 ? std::stoul(words[2]) : 0);
  const Target* target = words.size() > 2 ? findTarget(words[1]) : nullptr;
  if (!target) return usage();
  const std::string packed = std::string(target->name) + ".bin";
  if (words[0] == "--input") {
    std::ifstream in(words[2], std::ios::binary);
    tryInput(*target, Bytes(std::istreambuf_iterator<char>(in), {}));
    return 0;
  }
  if (words[0] == "--unpack" && words.size() == 4) {
    std::vector<Bytes> inputs = target->seeds();
    const std::vector<Bytes> corpus = readCorpus(fs::path(words[2]) / packed);
    inputs.insert(inputs.end(), corpus.begin(), corpus.end());
    for (size_t i = 0; i < inputs.size(); ++i)
      std::ofstream(fs::path(words[3]) / (std::to_string(10000 + i) + ".input"), std::ios::binary)
          .write(reinterpret_cast<const char*>(inputs[i].data()), static_cast<std::streamsize>(inputs[i].size()));
    return 0;
  }
  if (words[0] == "--pack" && words.size() == 5) {
    std::vector<Bytes> inputs = readFolder(words[2]);
    std::stable_sort(inputs.begin(), inputs.end(), [](const Bytes& a, const Bytes& b) { return a.size() < b.size(); });
    size_t sum = 0, count = 0;
    while (count < inputs.size() && sum + 4 + inputs[count].size() <= std::stoul(words[4]))
      sum += 4 + inputs[count++].size();
    writeCorpus(fs::path(words[3]) / packed, std::span(inputs).first(count));
    return 0;
  }
  return usage();
}
