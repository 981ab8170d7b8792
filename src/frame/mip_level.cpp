#include "frame/mip_level.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "base/parallel.hpp"
#include "base/srgb.hpp"

namespace facet::frame {

namespace {

constexpr float one = 65535;
constexpr int bandRows = 32;                   // of one core at a time
constexpr size_t fewTexels = size_t{1} << 14;  // not worth a thread

using Decoding = std::array<float, 256>;
template <class Curve>
Decoding decoding(Curve curve) {
  Decoding table{};
  for (size_t i = 0; i < table.size(); ++i) table[i] = one * static_cast<float>(curve(static_cast<double>(i) / 255));
  return table;
}
const Decoding& decodingOf(bool srgb) {
  static const Decoding curved = decoding(linearFromSrgb), straight = decoding([](double value) { return value; });
  return srgb ? curved : straight;
}

const std::vector<uint8_t>& srgbEncoding() {
  static const std::vector<uint8_t> table = [] {
    std::vector<uint8_t> codes(65536);
    for (size_t i = 0; i < codes.size(); ++i)
      codes[i] = static_cast<uint8_t>(std::lround(255 * srgbFromLinear(static_cast<double>(i) / 65535)));
    return codes;
  }();
  return table;
}

// Adds a row of the source times a weight.
void addRow(const MipSource& source, int row, float weight, std::vector<float>& sums) {
  const auto width = static_cast<size_t>(source.width), channels = source.channels.size();
  if (!source.data) {
    const uint16_t* from = source.linear->texels.data() + static_cast<size_t>(row) * sums.size();
    for (size_t i = 0; i < sums.size(); ++i) sums[i] += weight * static_cast<float>(from[i]);
    return;
  }
  const auto stride = static_cast<size_t>(source.stride);
  const size_t begin = static_cast<size_t>(row) * width * stride;
  for (size_t k = 0; k < channels; ++k) {
    const auto channel = static_cast<size_t>(source.channels[k]);
    const bool srgb = source.srgb && k < 3;
    const Decoding& decode = decodingOf(srgb);
    float* sum = sums.data() + k;
    if (source.bytesPerSample == 1) {
      const uint8_t* from = source.data + begin + channel;
      for (size_t x = 0; x < width; ++x) sum[x * channels] += weight * decode[from[x * stride]];
    } else {
      const auto* from = reinterpret_cast<const uint16_t*>(source.data) + begin + channel;
      // Texels of 16 bits go through the sRGB curve as 8, as the finest level is stored.
      for (size_t x = 0; x < width; ++x)
        sum[x * channels] += weight * (source.srgb ? decode[(from[x * stride] * 255u + 32767u) / 65535u]
                                                   : static_cast<float>(from[x * stride]));
    }
  }
}

void averageRow(const MipSource& source, LinearLevel& next, int row, const std::vector<LevelParts>& columns,
                std::vector<float>& sums) {
  const size_t channels = source.channels.size();
  std::ranges::fill(sums, 0.0f);
  const LevelParts down = levelParts(row, next.height, source.height);
  for (int i = 0; i < down.count; ++i) addRow(source, down.first + i, down.weights[i], sums);
  uint16_t* out = next.texels.data() + static_cast<size_t>(row) * static_cast<size_t>(next.width) * channels;
  for (const LevelParts& across : columns) {
    const float* from = sums.data() + static_cast<size_t>(across.first) * channels;
    for (size_t k = 0; k < channels; ++k) {
      float mean = 0.5f;
      for (int i = 0; i < across.count; ++i) mean += across.weights[i] * from[static_cast<size_t>(i) * channels + k];
      *out++ = static_cast<uint16_t>(std::min(mean, one));
    }
  }
}

// Bands of rows, on all cores where that pays.
template <class Work>
void inBands(int first, int rows, size_t texels, const Work& work) {
  if (texels < fewTexels) return work(first, first + rows);
  const auto bands = static_cast<size_t>((rows + bandRows - 1) / bandRows);
  parallelFor(bands, [&](size_t band) {
    const int from = first + static_cast<int>(band) * bandRows;
    work(from, std::min(from + bandRows, first + rows));
  });
}

}  // namespace

LevelParts levelParts(int i, int coarse, int fine) {
  const double from = static_cast<double>(i) * fine / coarse, to = static_cast<double>(i + 1) * fine / coarse;
  LevelParts parts;
  parts.first = static_cast<int>(from);
  for (int at = parts.first; at < fine && at < to - 1e-9; ++at)
    parts.weights[parts.count++] =
        static_cast<float>((std::min<double>(at + 1, to) - std::max<double>(at, from)) / (to - from));
  return parts;
}

void averageRows(const MipSource& source, LinearLevel& next, int first, int rows) {
  std::vector<LevelParts> columns;
  for (int x = 0; x < next.width; ++x) columns.push_back(levelParts(x, next.width, source.width));
  const size_t texels = static_cast<size_t>(source.width) * 2 * static_cast<size_t>(rows);
  inBands(first, rows, texels, [&](int from, int to) {
    std::vector<float> sums(static_cast<size_t>(source.width) * source.channels.size());
    for (int row = from; row < to; ++row) averageRow(source, next, row, columns, sums);
  });
}

std::vector<uint8_t> storedRows(const LinearLevel& level, int channels, TexelCode code, int first, int rows) {
  const size_t rowSamples = static_cast<size_t>(level.width) * static_cast<size_t>(channels);
  const uint16_t* from = level.texels.data() + static_cast<size_t>(first) * rowSamples;
  const size_t count = rowSamples * static_cast<size_t>(rows);
  if (code == TexelCode::unorm16) {
    std::vector<uint8_t> out(2 * count);
    std::memcpy(out.data(), from, out.size());
    return out;
  }
  std::vector<uint8_t> out(count);
  const std::vector<uint8_t>& curve = srgbEncoding();
  const auto straight = [](uint16_t value) { return static_cast<uint8_t>((value * 255u + 32767u) / 65535u); };
  for (size_t i = 0; i < count; ++i)
    out[i] = code == TexelCode::srgb8 && (channels < 4 || i % 4 < 3) ? curve[from[i]] : straight(from[i]);
  return out;
}

}  // namespace facet::frame
