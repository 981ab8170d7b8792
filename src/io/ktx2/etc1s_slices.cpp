#include <algorithm>

#include "io/image_formats.hpp"
#include "io/ktx2/blocks.hpp"
#include "io/ktx2/etc1s.hpp"

namespace facet::io {

namespace {

// Of the four colours from the darkest on.
int modifier(uint8_t intensity, size_t color) {
  return color < 2 ? -etcModifiers[intensity][1 - color] : etcModifiers[intensity][color - 2];
}

struct BlockIndex {
  uint32_t endpoint = 0, selector = 0;
};

// "ETC1S Approximate Move to Front Routines": the selectors that were used last.
struct History {
  std::vector<uint32_t> values;
  size_t next = 0;

  explicit History(size_t size) : values(size), next(size / 2) {}
  void add(uint32_t value) {
    if (values.empty()) return;
    values[next++] = value;
    if (next == values.size()) next = values.size() / 2;
  }
  uint32_t use(size_t index) {
    const uint32_t value = values[index];
    std::swap(values[index / 2], values[index]);
    return value;
  }
};

// "ETC1S VLC Decoding Procedure": chunks of so many bits, each with a bit that says whether another one follows.
uint32_t takeChunks(BitReader& bits, unsigned chunk) {
  uint32_t value = 0;
  for (unsigned shift = 0; shift < 32; shift += chunk) {
    const uint32_t part = bits.take(chunk + 1);
    value |= (part & ((1u << chunk) - 1)) << shift;
    if (part >> chunk == 0) break;
  }
  return value;
}

// "ETC1S Slice Block Decoding": block by block, the indices into the codebooks.
class SliceReader {
 public:
  SliceReader(const Etc1s& etc1s, std::span<const uint8_t> bytes, size_t columns)
      : etc1s_(etc1s), bits_{bytes}, history_(etc1s.historySize), above_(columns), row_(columns), below_(columns) {}

  // The next row of blocks; false: it is damaged.
  bool readRow(size_t y) {
    std::swap(above_, row_);
    for (size_t x = 0; x < row_.size(); ++x)
      if (!readEndpoint(x, y) || !readSelector(row_[x].selector)) return false;
    return true;
  }
  const std::vector<BlockIndex>& row() const { return row_; }

 private:
  // Two bits for each of 2 x 2 blocks; those of the lower two wait in below_.
  bool readPredictions(size_t x, size_t y) {
    constexpr int repeat = 256, leastRepeats = 3;
    if (y % 2 == 1) {
      predictions_ = below_[x];
      return true;
    }
    if (repeats_ > 0) {
      --repeats_;
    } else if (const int symbol = etc1s_.predictions.decode(bits_); symbol == repeat) {
      repeats_ = uint64_t{takeChunks(bits_, 4)} + leastRepeats - 1;
    } else if (symbol >= 0 && symbol < repeat) {
      lastPredictions_ = static_cast<uint32_t>(symbol);
    } else {
      return false;
    }
    predictions_ = lastPredictions_;
    below_[x] = static_cast<uint8_t>(predictions_ >> 4);
    return true;
  }

  bool readEndpoint(size_t x, size_t y) {
    if (x % 2 == 0 && !readPredictions(x, y)) return false;
    const uint32_t prediction = predictions_ & 3;
    predictions_ >>= 2;
    const bool left = prediction == 0 || prediction == 2, up = prediction == 1 || prediction == 2;
    if ((left && x == 0) || (up && y == 0)) return false;  // as a block outside
    uint32_t endpoint = lastEndpoint_;
    if (prediction == 1) endpoint = above_[x].endpoint;
    if (prediction == 2) endpoint = above_[x - 1].endpoint;
    if (prediction == 3) {
      const int delta = etc1s_.endpointDeltas.decode(bits_);
      if (delta < 0) return false;
      endpoint += static_cast<uint32_t>(delta);
      if (endpoint >= etc1s_.endpoints.size()) endpoint -= static_cast<uint32_t>(etc1s_.endpoints.size());
    }
    if (endpoint >= etc1s_.endpoints.size()) return false;
    row_[x].endpoint = lastEndpoint_ = endpoint;
    return true;
  }

  bool readSelector(uint32_t& selector) {
    constexpr int longRun = 63, leastRun = 3;
    const auto count = static_cast<uint32_t>(etc1s_.selectors.size());
    uint32_t symbol = count;  // in a run: the last one
    if (run_ > 0) {
      --run_;
    } else {
      const int read = etc1s_.selectorSymbols.decode(bits_);
      if (read < 0) return false;
      symbol = static_cast<uint32_t>(read);
      if (symbol == count + etc1s_.historySize) {
        const int length = etc1s_.runs.decode(bits_);
        if (length < 0) return false;
        run_ = (length == longRun ? uint64_t{takeChunks(bits_, 7)} : static_cast<uint64_t>(length)) + leastRun - 1;
        symbol = count;
      }
    }
    if (symbol < count) {
      selector = symbol;
      history_.add(symbol);
      return true;
    }
    if (symbol - count >= history_.values.size()) return false;
    selector = history_.use(symbol - count);
    return true;
  }

  const Etc1s& etc1s_;
  BitReader bits_;
  History history_;
  std::vector<BlockIndex> above_, row_;
  std::vector<uint8_t> below_;
  uint32_t predictions_ = 0, lastPredictions_ = 0, lastEndpoint_ = 0;
  uint64_t repeats_ = 0, run_ = 0;
};

struct Target {
  uint8_t* texels;
  size_t width, height, channels;
};

// The four colours that a block's texels choose from.
std::array<std::array<uint8_t, 3>, 4> colorsOf(const Etc1sEndpoint& endpoint) {
  std::array<std::array<uint8_t, 3>, 4> out;
  for (size_t i = 0; i < 4; ++i) {
    for (size_t c = 0; c < 3; ++c) {
      const int base = endpoint.color[c] << 3 | endpoint.color[c] >> 2;
      out[i][c] = static_cast<uint8_t>(std::clamp(base + modifier(endpoint.intensity, i), 0, 255));
    }
  }
  return out;
}

void writeBlock(const Target& to, size_t column, size_t row, const Etc1sEndpoint& endpoint,
                const Etc1sSelector& selector, bool alpha) {
  const auto colors = colorsOf(endpoint);
  for (size_t y = 4 * row; y < std::min(4 * row + 4, to.height); ++y) {
    for (size_t x = 4 * column; x < std::min(4 * column + 4, to.width); ++x) {
      const auto& color = colors[selector[y % 4] >> 2 * (x % 4) & 3];
      uint8_t* texel = to.texels + (y * to.width + x) * to.channels;
      if (alpha)
        texel[3] = color[1];
      else
        std::ranges::copy(color, texel);
    }
  }
}

Result<void> decodeSlice(const Etc1s& etc1s, std::span<const uint8_t> bytes, const Target& to, bool alpha) {
  SliceReader reader(etc1s, bytes, (to.width + 3) / 4);
  for (size_t y = 0; 4 * y < to.height; ++y) {
    if (!reader.readRow(y)) return damagedImage("its BasisLZ slice is faulty or too short");
    for (size_t x = 0; x < reader.row().size(); ++x) {
      const BlockIndex& block = reader.row()[x];
      writeBlock(to, x, y, etc1s.endpoints[block.endpoint], etc1s.selectors[block.selector], alpha);
    }
  }
  return {};
}

}  // namespace

Result<void> decodeEtc1sLevel(const Etc1s& etc1s, const Ktx2& ktx, size_t level, int channels, uint8_t* texels) {
  const Target to{texels, static_cast<size_t>(levelSide(ktx.width, level)),
                  static_cast<size_t>(levelSide(ktx.height, level)), static_cast<size_t>(channels)};
  const std::span<const uint8_t> bytes = ktx.levels[level].bytes;
  const Etc1sLevel& part = etc1s.levels[level];
  auto ok = decodeSlice(etc1s, bytes.subspan(part.colorOffset, part.colorLength), to, false);
  if (ok && channels == 4) ok = decodeSlice(etc1s, bytes.subspan(part.alphaOffset, part.alphaLength), to, true);
  return ok;
}

}  // namespace facet::io
