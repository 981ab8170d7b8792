#include "fuzz/replay.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>

#include "fuzz/corpus.hpp"
#include "fuzz/mutate.hpp"

namespace facet::fuzz {

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

// Some bytes other ones, a part doubled, left out or from another input, cut off.
Bytes damaged(Bytes bytes, const std::vector<Bytes>& others, std::mt19937& random) {
  for (size_t i = 1 + random() % 4; i > 0 && !bytes.empty(); --i)
    bytes[random() % bytes.size()] = static_cast<uint8_t>(random());
  const auto place = [&](const Bytes& in) { return static_cast<ptrdiff_t>(random() % (in.size() + 1)); };
  const uint32_t kind = random() % 16;
  if (kind < 3) {
    const Bytes& other = kind == 0 ? bytes : others[random() % others.size()];
    const ptrdiff_t from = place(other), to = from + static_cast<ptrdiff_t>(random()) % (std::ssize(other) - from + 1);
    const Bytes part(other.begin() + from, other.begin() + to);
    bytes.insert(bytes.begin() + place(bytes), part.begin(), part.end());
  }
  if (kind == 3) bytes.resize(random() % (bytes.size() + 1));
  if (kind == 4) {
    const ptrdiff_t from = place(bytes), to = from + static_cast<ptrdiff_t>(random()) % (std::ssize(bytes) - from + 1);
    bytes.erase(bytes.begin() + from, bytes.begin() + to);
  }
  return bytes;
}

// Seeds, corpus, `changes` of each by that chance; how many that were.
size_t replay(const Target& target, const fs::path& corpora, size_t changes, uint32_t chance) {
  std::vector<Bytes> inputs = target.seeds();
  const std::vector<Bytes> corpus = readCorpus(corpora / (std::string(target.name) + ".bin"));
  inputs.insert(inputs.end(), corpus.begin(), corpus.end());
  tryInput(target, {});
  std::mt19937 random(chance);
  size_t count = 1;
  for (const Bytes& input : inputs) {
    tryInput(target, input);
    for (size_t i = 0; i < changes; ++i) {
      Bytes changed = target.json && i % 4 != 3 ? mutateJson(input, random) : damaged(input, inputs, random);
      if (changed.size() > target.maxBytes) changed.resize(target.maxBytes);
      tryInput(target, changed);
    }
    count += 1 + changes;
  }
  return count;
}

int replayAll(std::span<const Target> targets, const fs::path& corpora, std::string_view wanted, size_t changes,
              uint32_t chance) {
  for (const Target& target : targets) {
    if (wanted != "all" && wanted != target.name) continue;
    const auto start = std::chrono::steady_clock::now();
    const size_t count = replay(target, corpora, changes, chance);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    std::printf("%s: %zu inputs, %.1f s\n", target.name, count, spent.count());
    std::fflush(stdout);
  }
  return 0;
}

int usage() {
  std::fputs(
      "PROGRAM CORPORA [TARGET|all] [CHANGES [CHANCE]]  tries seeds, corpus and so many changes of each\n"
      "PROGRAM --list                      names the targets\n"
      "PROGRAM --input TARGET FILE         tries one input\n"
      "PROGRAM --unpack TARGET CORPORA DIR seeds and corpus as files\n"
      "PROGRAM --pack TARGET DIR CORPORA BYTES  the files of DIR, smallest first, as the corpus\n",
      stderr);
  return 2;
}

}  // namespace

int replayCommand(std::span<const Target> targets, const std::vector<std::string>& words) {
  if (words.empty()) return usage();
  if (const char* file = std::getenv("FACET_FUZZ_LAST")) lastInput = file;
  if (words[0] == "--list") {
    for (const Target& target : targets) std::printf("%-12s %6zu  %s\n", target.name, target.maxBytes, target.summary);
    return 0;
  }
  if (!words[0].starts_with("--"))
    return replayAll(targets, words[0], words.size() > 1 ? words[1] : "all",
                     words.size() > 2 ? std::stoul(words[2]) : 0,
                     words.size() > 3 ? static_cast<uint32_t>(std::stoul(words[3])) : 1);
  const Target* target = words.size() > 2 ? findTarget(targets, words[1]) : nullptr;
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

}  // namespace facet::fuzz
