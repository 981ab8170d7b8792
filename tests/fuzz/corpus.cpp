#include "fuzz/corpus.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace facet::fuzz {

namespace {

Bytes contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(in), {});
}

}  // namespace

std::vector<Bytes> readCorpus(const std::filesystem::path& file) {
  const Bytes bytes = contents(file);
  std::vector<Bytes> inputs;
  for (size_t at = 0; at < bytes.size();) {
    size_t length = 0;
    for (size_t i = 0; i < 4 && at + i < bytes.size(); ++i) length |= size_t{bytes[at + i]} << 8 * i;
    if (bytes.size() - at < 4 || length > bytes.size() - at - 4) {
      std::fprintf(stderr, "fuzz: %s is no corpus\n", file.c_str());
      std::exit(2);
    }
    const auto begin = bytes.begin() + static_cast<ptrdiff_t>(at + 4);
    inputs.emplace_back(begin, begin + static_cast<ptrdiff_t>(length));
    at += 4 + length;
  }
  return inputs;
}

void writeCorpus(const std::filesystem::path& file, std::span<const Bytes> inputs) {
  std::ofstream out(file, std::ios::binary);
  for (const Bytes& input : inputs) {
    for (size_t i = 0; i < 4; ++i) out.put(static_cast<char>(input.size() >> 8 * i));
    out.write(reinterpret_cast<const char*>(input.data()), static_cast<std::streamsize>(input.size()));
  }
}

std::vector<Bytes> readFolder(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<Bytes> inputs;
  for (const auto& file : files) inputs.push_back(contents(file));
  return inputs;
}

}  // namespace facet::fuzz
