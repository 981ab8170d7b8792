#include <zlib.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <new>

#include "base/parallel.hpp"
#include "io/image_formats.hpp"

// PNG (ISO/IEC 15948) written by all cores: rows are filtered and deflated in bands of about equal size whatever the
// number of cores, so that the same pixels always give the same file. Each band begins with the bytes before it as its
// dictionary and ends on a byte (a sync flush), so that together they are one stream.

namespace facet::io {

namespace {

constexpr size_t bandBytes = size_t{1} << 18;
constexpr size_t windowBytes = size_t{1} << 15;  // as far as deflate looks back
constexpr int level = 2;                         // 4: a tenth smaller, a quarter more time

void addWord(std::vector<uint8_t>& out, uint32_t word) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<uint8_t>(word >> shift));
}

void addChunk(std::vector<uint8_t>& out, const char* type, std::span<const uint8_t> data) {
  addWord(out, static_cast<uint32_t>(data.size()));
  const size_t begin = out.size();
  out.insert(out.end(), type, type + 4);
  out.insert(out.end(), data.begin(), data.end());
  addWord(out, static_cast<uint32_t>(crc32(0, &out[begin], static_cast<uInt>(out.size() - begin))));
}

int paeth(int left, int up, int corner) {
  const int p = left + up - corner, pl = std::abs(p - left), pu = std::abs(p - up), pc = std::abs(p - corner);
  return pl <= pu && pl <= pc ? left : pu <= pc ? up : corner;
}

// Its samples as the format has them: the higher byte of two first.
std::span<const uint8_t> fileRow(std::span<const uint8_t> row, int bytesPerSample, std::vector<uint8_t>& swapped) {
  if (bytesPerSample == 1) return row;
  swapped.resize(row.size());
  for (size_t i = 0; i + 1 < row.size(); i += 2) {
    uint16_t sample;
    std::memcpy(&sample, &row[i], sizeof sample);
    swapped[i] = static_cast<uint8_t>(sample >> 8), swapped[i + 1] = static_cast<uint8_t>(sample & 255);
  }
  return swapped;
}

// Of the five filters the one whose bytes are the smallest, as the specification suggests (12.8). above: zeros for the
// first row. out: the filter's number, then the row.
void filterRow(std::span<const uint8_t> row, const uint8_t* above, size_t pixelBytes, std::vector<uint8_t>& candidate,
               uint8_t* out) {
  long best = std::numeric_limits<long>::max();
  for (uint8_t filter = 0; filter < 5; ++filter) {
    const auto with = [&](auto predict) {
      const size_t first = std::min(pixelBytes, row.size());
      for (size_t i = 0; i < first; ++i) candidate[i] = static_cast<uint8_t>(row[i] - predict(0, above[i], 0));
      for (size_t i = first; i < row.size(); ++i)
        candidate[i] = static_cast<uint8_t>(row[i] - predict(row[i - pixelBytes], above[i], above[i - pixelBytes]));
    };
    if (filter == 0) with([](int, int, int) { return 0; });
    if (filter == 1) with([](int left, int, int) { return left; });
    if (filter == 2) with([](int, int up, int) { return up; });
    if (filter == 3) with([](int left, int up, int) { return (left + up) / 2; });
    if (filter == 4) with(paeth);
    long sum = 0;
    for (const uint8_t byte : candidate) sum += std::abs(static_cast<int8_t>(byte));
    if (sum >= best) continue;
    best = sum;
    out[0] = filter;
    std::memcpy(out + 1, candidate.data(), candidate.size());
  }
}

struct Band {
  std::vector<uint8_t> deflated;
  uLong adler = 1;
  bool good = false;
};

// Rows that are filtered already, the ones before them too. Throws std::bad_alloc.
void deflateBand(std::span<const uint8_t> filtered, size_t begin, size_t end, Band& band) {
  const auto size = static_cast<uInt>(end - begin);
  band.adler = adler32(1, &filtered[begin], size);
  z_stream stream = {};
  if (deflateInit2(&stream, level, Z_DEFLATED, -15, 9, Z_DEFAULT_STRATEGY) != Z_OK) throw std::bad_alloc();
  const std::unique_ptr<z_stream, decltype(&deflateEnd)> closed(&stream, deflateEnd);
  const size_t before = std::min(begin, windowBytes);
  if (before > 0) deflateSetDictionary(&stream, &filtered[begin - before], static_cast<uInt>(before));
  band.deflated.resize(deflateBound(&stream, size) + 16);
  stream.next_in = const_cast<Bytef*>(&filtered[begin]);
  stream.avail_in = size;
  stream.next_out = band.deflated.data();
  stream.avail_out = static_cast<uInt>(band.deflated.size());
  const bool last = end == filtered.size();
  [[maybe_unused]] const int status = deflate(&stream, last ? Z_FINISH : Z_SYNC_FLUSH);
  assert((last ? status == Z_STREAM_END : status == Z_OK) && stream.avail_in == 0 && stream.avail_out > 0);
  band.deflated.resize(stream.total_out);
}

}  // namespace

std::vector<uint8_t> pngOf(const Pixels& pixels, std::span<const PngText> texts) {
  const auto channels = static_cast<size_t>(pixels.channels), height = static_cast<size_t>(pixels.height);
  const size_t pixelBytes = channels * static_cast<size_t>(pixels.bytesPerSample);
  const size_t rowBytes = static_cast<size_t>(pixels.width) * pixelBytes, filteredBytes = rowBytes + 1;
  const size_t rowsOfBand = std::max<size_t>(bandBytes / filteredBytes, 1);
  const auto endRow = [&](size_t band) { return std::min((band + 1) * rowsOfBand, height); };
  std::vector<Band> bands((height + rowsOfBand - 1) / rowsOfBand);
  const auto eachBand = [&](const std::function<void(size_t)>& work) {
    parallelFor(bands.size(), [&](size_t i) {
      try {
        work(i);
        bands[i].good = true;
      } catch (const std::bad_alloc&) {
        bands[i].good = false;
      }
    });
    return std::ranges::all_of(bands, &Band::good);
  };
  std::vector<uint8_t> filtered(height * filteredBytes);
  const std::vector<uint8_t> zeros(rowBytes, 0);
  const bool allFiltered = eachBand([&](size_t band) {
    std::vector<uint8_t> candidate(rowBytes), row, above;
    const auto rowAt = [&](size_t y, std::vector<uint8_t>& swapped) {
      return fileRow(std::span(pixels.data).subspan(y * rowBytes, rowBytes), pixels.bytesPerSample, swapped);
    };
    for (size_t y = band * rowsOfBand; y < endRow(band); ++y)
      filterRow(rowAt(y, row), y > 0 ? rowAt(y - 1, above).data() : zeros.data(), pixelBytes, candidate,
                &filtered[y * filteredBytes]);
  });
  if (!allFiltered || !eachBand([&](size_t i) {
        deflateBand(filtered, i * rowsOfBand * filteredBytes, endRow(i) * filteredBytes, bands[i]);
      }))
    return {};

  std::vector<uint8_t> stream = {0x78, 0x5e};  // deflate, a window of 32 KiB, a level below the default (RFC 1950)
  uLong adler = 1;
  for (size_t i = 0; i < bands.size(); ++i) {
    const size_t size = (endRow(i) - i * rowsOfBand) * filteredBytes;
    adler = i == 0 ? bands[i].adler : adler32_combine(adler, bands[i].adler, static_cast<z_off_t>(size));
    stream.insert(stream.end(), bands[i].deflated.begin(), bands[i].deflated.end());
  }
  addWord(stream, static_cast<uint32_t>(adler));
  std::vector<uint8_t> out = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  constexpr std::array<uint8_t, 5> colorTypes = {0, 0, 4, 2, 6};  // by channels
  std::vector<uint8_t> header;
  addWord(header, static_cast<uint32_t>(pixels.width));
  addWord(header, static_cast<uint32_t>(pixels.height));
  header.insert(header.end(), {static_cast<uint8_t>(8 * pixels.bytesPerSample), colorTypes[channels], 0, 0, 0});
  addChunk(out, "IHDR", header);
  for (const PngText& text : texts) {
    std::vector<uint8_t> data(text.keyword.begin(), text.keyword.end());
    data.push_back(0);
    data.insert(data.end(), text.text.begin(), text.text.end());
    addChunk(out, "tEXt", data);
  }
  constexpr size_t mostOfChunk = size_t{1} << 30;  // its length has 31 bits
  for (size_t begin = 0; begin < stream.size(); begin += mostOfChunk)
    addChunk(out, "IDAT", std::span(stream).subspan(begin, std::min(mostOfChunk, stream.size() - begin)));
  addChunk(out, "IEND", {});
  return out;
}

}  // namespace facet::io
