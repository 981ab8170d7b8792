#include "compare/compare.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <fstream>

#include "base/parallel.hpp"
#include "base/srgb.hpp"
#include "compare/flip.hpp"
#include "compare/ssim.hpp"

namespace facet::compare {

namespace {

bool isFinite(const glm::vec4& v) {
  return std::isfinite(v.r) && std::isfinite(v.g) && std::isfinite(v.b) && std::isfinite(v.a);
}

glm::dvec3 finiteColor(const glm::vec4& v) {
  const auto keep = [](float x) { return std::isfinite(x) ? static_cast<double>(x) : 0.0; };
  return {keep(v.r), keep(v.g), keep(v.b)};
}

// What is not finite covers nothing.
double coverage(const glm::vec4& v) { return std::isfinite(v.a) ? glm::clamp<double>(v.a, 0, 1) : 0.0; }

bool isOpaque(const io::RadianceImage& image) {
  return std::ranges::all_of(image.pixels, [](const glm::vec4& v) { return !std::isfinite(v.a) || v.a >= 1; });
}

io::RadianceImage overWhite(const io::RadianceImage& image) {
  io::RadianceImage over{image.width, image.height, image.pixels};
  for (glm::vec4& v : over.pixels) {
    const float white = std::isfinite(v.a) ? static_cast<float>(1 - coverage(v)) : 0;
    v.r += white, v.g += white, v.b += white;
  }
  return over;
}

glm::dvec3 display(const glm::dvec3& linear) {
  const glm::dvec3 c = glm::clamp(linear, 0.0, 1.0);
  return {srgbFromLinear(c.r), srgbFromLinear(c.g), srgbFromLinear(c.b)};
}

// Rec. 709 weights on encoded values, as usual for SSIM.
float luma(const glm::dvec3& c) { return static_cast<float>(0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b); }

bool counts(const glm::vec4& reference, const CompareOptions& options) {
  return !options.maskFromAlpha || reference.a > 0.5f;
}

Result<void> checkSizes(const io::RadianceImage& a, const io::RadianceImage& b) {
  const auto size = [](const io::RadianceImage& i) { return std::to_string(i.width) + "x" + std::to_string(i.height); };
  if (a.width != b.width || a.height != b.height) {
    return fail({}, {}, "the sizes differ, " + size(a) + " and " + size(b), "compare pictures of one size");
  }
  if (a.width <= 0 || a.height <= 0) return fail({}, {}, "the pictures are empty");
  assert(a.pixels.size() == static_cast<size_t>(a.width) * static_cast<size_t>(a.height));
  assert(b.pixels.size() == a.pixels.size());
  return {};
}

constexpr double relativeFloor = 0.01;  // added to what squares are divided by (Rousselle et al. 2011)

// What one row adds up to. Rows are summed in order afterwards, so that the result does not depend on the threads.
struct Sums {
  glm::dvec3 reference = glm::dvec3(0), error = glm::dvec3(0);
  double squaredRelativeError = 0;
  std::vector<float> displayErrors = {}, differences = {};  // of each pixel: squared, largest of the channels
  double squaredError = 0, squaredDisplayError = 0, squaredAlphaError = 0, ssim = 0;
  double flip = 0, flipLargest = 0;
  double largest = -1;
  int largestX = 0, largestY = 0;
  uint64_t pixels = 0, above = 0, nonFiniteReference = 0, nonFinitePicture = 0, noticeable = 0;

  void add(const Sums& row) {
    reference += row.reference, error += row.error;
    squaredRelativeError += row.squaredRelativeError;
    displayErrors.insert(displayErrors.end(), row.displayErrors.begin(), row.displayErrors.end());
    differences.insert(differences.end(), row.differences.begin(), row.differences.end());
    squaredError += row.squaredError, squaredDisplayError += row.squaredDisplayError, ssim += row.ssim;
    squaredAlphaError += row.squaredAlphaError;
    flip += row.flip, flipLargest = std::max(flipLargest, row.flipLargest), noticeable += row.noticeable;
    if (row.largest > largest) largest = row.largest, largestX = row.largestX, largestY = row.largestY;
    pixels += row.pixels, above += row.above;
    nonFiniteReference += row.nonFiniteReference, nonFinitePicture += row.nonFinitePicture;
  }
};

void addPixel(Sums& sums, const glm::vec4& reference, const glm::vec4& picture, int x, int y, double tolerance) {
  const glm::dvec3 r = finiteColor(reference), p = finiteColor(picture);
  const glm::dvec3 error = p - r, displayError = display(p) - display(r);
  sums.reference += r;
  sums.error += error;
  sums.squaredError += glm::dot(error, error);
  sums.squaredDisplayError += glm::dot(displayError, displayError);
  sums.displayErrors.push_back(static_cast<float>(glm::dot(displayError, displayError)));
  for (int c = 0; c < 3; ++c) sums.squaredRelativeError += error[c] * error[c] / (r[c] * r[c] + relativeFloor);
  const double alphaError = coverage(picture) - coverage(reference);
  sums.squaredAlphaError += alphaError * alphaError;
  const double difference = isFinite(reference) && isFinite(picture)
                                ? std::max({std::abs(displayError.r), std::abs(displayError.g),
                                            std::abs(displayError.b), std::abs(alphaError)})
                                : 1;
  sums.differences.push_back(static_cast<float>(difference));
  if (difference > sums.largest) sums.largest = difference, sums.largestX = x, sums.largestY = y;
  if (difference > tolerance) ++sums.above;
  ++sums.pixels;
}

// Sorts some of the sums' pixels.
void setTails(Comparison& result, Sums& sums) {
  const size_t n = sums.displayErrors.size(), worst = n / 1000;
  std::vector<float>& errors = sums.displayErrors;
  if (worst > 0) std::ranges::nth_element(errors, errors.end() - static_cast<ptrdiff_t>(worst));
  double tail = 0, all = 0;
  for (size_t i = 0; i < n; ++i) {
    all += static_cast<double>(errors[i]);
    if (i >= n - worst) tail += static_cast<double>(errors[i]);
  }
  result.worstShare = all > 0 ? tail / all : 0;
  if (n > worst)
    result.trimmedRmse = std::sqrt(std::max(all - tail, 0.0) / (3.0 * static_cast<double>(n - worst))) * 255;
  const auto at = sums.differences.begin() + static_cast<ptrdiff_t>((99 * n + 99) / 100 - 1);  // rank ceil(.99 n)
  std::ranges::nth_element(sums.differences, at);
  result.percentile99 = static_cast<double>(*at);
}

Comparison figures(Sums& sums) {
  // A black reference has no scale: its errors are then taken relative to a mean of 1e-9, large but finite.
  const auto scale = [](double mean) { return std::max(mean, 1e-9); };
  const double n = static_cast<double>(sums.pixels);
  const glm::dvec3 mean = sums.reference / n;
  Comparison result;
  result.relRmse = std::sqrt(sums.squaredError / (3 * n)) / scale((mean.r + mean.g + mean.b) / 3);
  for (int c = 0; c < 3; ++c) result.bias[static_cast<size_t>(c)] = sums.error[c] / n / scale(mean[c]);
  result.relMse = sums.squaredRelativeError / (3 * n);
  result.displayRmse = std::sqrt(sums.squaredDisplayError / (3 * n)) * 255;
  setTails(result, sums);
  result.alphaRmse = std::sqrt(sums.squaredAlphaError / n) * 255;
  result.ssim = sums.ssim / n;
  result.flipMean = sums.flip / n;
  result.flipLargest = sums.flipLargest;
  result.shareNoticeable = static_cast<double>(sums.noticeable) / n;
  result.largest = sums.largest;
  result.largestX = sums.largestX, result.largestY = sums.largestY;
  result.shareAbove = static_cast<double>(sums.above) / n;
  result.pixels = sums.pixels;
  result.nonFiniteReference = sums.nonFiniteReference;
  result.nonFinitePicture = sums.nonFinitePicture;
  return result;
}

}  // namespace

io::RadianceImage linearPicture(const io::Pixels& pixels) {
  const size_t channels = static_cast<size_t>(pixels.channels);
  const bool wide = pixels.bytesPerSample == 2;
  const size_t count = static_cast<size_t>(pixels.width) * static_cast<size_t>(pixels.height);
  assert(channels >= 1 && channels <= 4 && pixels.data.size() == count * channels * (wide ? 2 : 1));
  const auto sample = [&](size_t i) {
    if (!wide) return pixels.data[i] / 255.0;
    uint16_t value;
    std::memcpy(&value, &pixels.data[2 * i], 2);
    return value / 65535.0;
  };
  io::RadianceImage image{pixels.width, pixels.height, std::vector<glm::vec4>(count)};
  for (size_t i = 0; i < count; ++i) {
    const size_t first = i * channels, step = channels >= 3 ? 1 : 0;  // grey is its own green and blue
    const double alpha = channels == 2 || channels == 4 ? sample(first + channels - 1) : 1.0;
    const glm::dvec3 straight(linearFromSrgb(sample(first)), linearFromSrgb(sample(first + step)),
                              linearFromSrgb(sample(first + 2 * step)));
    image.pixels[i] = glm::vec4(straight * alpha, alpha);
  }
  return image;
}

Result<io::RadianceImage> readPicture(const std::filesystem::path& path, const io::Limits& limits) {
  char magic[4] = {};
  std::error_code ignored;
  if (std::filesystem::is_regular_file(path, ignored)) std::ifstream(path, std::ios::binary).read(magic, 4);
  const bool exr = std::memcmp(magic, "\x76\x2f\x31\x01", 4) == 0;
  const bool hdr = std::memcmp(magic, "#?", 2) == 0;
  if (exr || hdr) return io::readRadiance(path, limits);
  const Result<io::Pixels> pixels = io::readImage(path, limits);
  if (!pixels) return tl::unexpected(pixels.error());
  return linearPicture(*pixels);
}

double displayDifference(const glm::vec4& reference, const glm::vec4& picture) {
  if (!isFinite(reference) || !isFinite(picture)) return 1;
  const double behindPicture = 1 - coverage(picture), behindReference = 1 - coverage(reference);
  const auto over = [&](double background) {
    const glm::dvec3 d = glm::abs(display(glm::dvec3(picture) + background * behindPicture) -
                                  display(glm::dvec3(reference) + background * behindReference));
    return std::max({d.r, d.g, d.b});
  };
  return std::max({over(0), over(1), std::abs(behindPicture - behindReference)});
}

namespace {

// Of the associated colours as they are: over black.
Result<Comparison> compareColors(const io::RadianceImage& reference, const io::RadianceImage& picture,
                                 const CompareOptions& options) {
  if (auto checked = checkSizes(reference, picture); !checked) return tl::unexpected(checked.error());
  const size_t width = static_cast<size_t>(reference.width), height = static_cast<size_t>(reference.height);
  std::vector<float> lumaReference(width * height), lumaPicture(width * height);
  std::vector<glm::dvec3> colorsReference(width * height), colorsPicture(width * height);
  std::vector<Sums> rows(height);
  parallelFor(height, [&](size_t y) {
    for (size_t x = 0; x < width; ++x) {
      const size_t i = y * width + x;
      const glm::vec4 r = reference.pixels[i], p = picture.pixels[i];
      colorsReference[i] = finiteColor(r), colorsPicture[i] = finiteColor(p);
      lumaReference[i] = luma(display(colorsReference[i]));
      lumaPicture[i] = luma(display(colorsPicture[i]));
      if (!isFinite(r)) ++rows[y].nonFiniteReference;
      if (!isFinite(p)) ++rows[y].nonFinitePicture;
      if (!counts(r, options)) continue;
      addPixel(rows[y], r, p, static_cast<int>(x), static_cast<int>(y), options.tolerance);
    }
  });
  const std::vector<float> similarity = ssimMap(lumaReference, lumaPicture, reference.width, reference.height);
  const std::vector<float> flip = flipMap(colorsReference, colorsPicture, reference.width, reference.height);
  Sums sums;
  sums.displayErrors.reserve(width * height), sums.differences.reserve(width * height);
  for (size_t y = 0; y < height; ++y) {
    for (size_t i = y * width; i < (y + 1) * width; ++i) {
      if (!counts(reference.pixels[i], options)) continue;
      rows[y].ssim += similarity[i];
      rows[y].flip += flip[i];
      rows[y].flipLargest = std::max<double>(rows[y].flipLargest, flip[i]);
      if (flip[i] > flipJustNoticeable) ++rows[y].noticeable;
    }
    sums.add(rows[y]);
    rows[y] = {};
  }
  if (sums.pixels == 0) {
    return fail({}, {}, "no pixel of the reference has an alpha above 0.5", "compare without the mask");
  }
  return figures(sums);
}

// Of each figure the worse.
Comparison worse(const Comparison& a, const Comparison& b) {
  Comparison result = a.largest >= b.largest ? a : b;
  result.relRmse = std::max(a.relRmse, b.relRmse);
  for (size_t c = 0; c < 3; ++c) result.bias[c] = std::abs(a.bias[c]) >= std::abs(b.bias[c]) ? a.bias[c] : b.bias[c];
  result.relMse = std::max(a.relMse, b.relMse);
  result.displayRmse = std::max(a.displayRmse, b.displayRmse);
  const Comparison& tailed = a.displayRmse >= b.displayRmse ? a : b;
  result.worstShare = tailed.worstShare;
  result.trimmedRmse = std::max(a.trimmedRmse, b.trimmedRmse);
  result.percentile99 = std::max(a.percentile99, b.percentile99);
  result.ssim = std::min(a.ssim, b.ssim);
  result.flipMean = std::max(a.flipMean, b.flipMean);
  result.flipLargest = std::max(a.flipLargest, b.flipLargest);
  result.shareNoticeable = std::max(a.shareNoticeable, b.shareNoticeable);
  result.shareAbove = std::max(a.shareAbove, b.shareAbove);
  return result;
}

}  // namespace

Result<Comparison> comparePictures(const io::RadianceImage& reference, const io::RadianceImage& picture,
                                   const CompareOptions& options) {
  const Result<Comparison> overBlack = compareColors(reference, picture, options);
  if (!overBlack || (isOpaque(reference) && isOpaque(picture))) return overBlack;
  const Result<Comparison> white = compareColors(overWhite(reference), overWhite(picture), options);
  return white ? worse(*overBlack, *white) : white;
}

Result<DifferenceMaps> differenceMaps(const io::RadianceImage& reference, const io::RadianceImage& picture,
                                      const CompareOptions& options) {
  if (auto checked = checkSizes(reference, picture); !checked) return tl::unexpected(checked.error());
  DifferenceMaps maps;
  for (io::RadianceImage* map : {&maps.difference, &maps.relative}) {
    map->width = reference.width, map->height = reference.height;
    map->pixels.resize(reference.pixels.size());
  }
  for (size_t i = 0; i < reference.pixels.size(); ++i) {
    if (!counts(reference.pixels[i], options)) continue;
    const glm::vec3 r(reference.pixels[i]), apart = glm::vec3(picture.pixels[i]) - r;
    maps.difference.pixels[i] = glm::vec4(apart, 1);
    maps.relative.pixels[i] = glm::vec4(apart / glm::max(r, glm::vec3(0.01f)), 1);
  }
  return maps;
}

std::array<uint8_t, 3> heatColor(double difference) {
  constexpr double stops[5][3] = {{0, 0, 0}, {0, 0, 255}, {255, 0, 0}, {255, 255, 0}, {255, 255, 255}};
  const double t = 4 * std::sqrt(std::clamp(difference, 0.0, 1.0));
  const int i = std::min(static_cast<int>(t), 3);
  std::array<uint8_t, 3> color;
  for (size_t c = 0; c < 3; ++c) {
    color[c] = static_cast<uint8_t>(std::lround(stops[i][c] + (t - i) * (stops[i + 1][c] - stops[i][c])));
  }
  return color;
}

namespace {

// differenceAt(i): of pixel i.
template <class Difference>
Result<io::Pixels> heatPicture(const io::RadianceImage& reference, const io::RadianceImage& picture,
                               const CompareOptions& options, const Difference& differenceAt) {
  if (auto checked = checkSizes(reference, picture); !checked) return tl::unexpected(checked.error());
  io::Pixels map;
  map.width = reference.width, map.height = reference.height, map.channels = 3;
  map.data.resize(reference.pixels.size() * 3);
  const size_t width = static_cast<size_t>(reference.width);
  parallelFor(static_cast<size_t>(reference.height), [&](size_t y) {
    for (size_t i = y * width; i < (y + 1) * width; ++i) {
      const glm::vec4 r = reference.pixels[i], p = picture.pixels[i];
      std::array<uint8_t, 3> color = {48, 48, 48};
      if (counts(r, options)) color = heatColor(differenceAt(i));
      if (!isFinite(r) || !isFinite(p)) color = {255, 0, 255};
      std::copy(color.begin(), color.end(), map.data.begin() + static_cast<std::ptrdiff_t>(3 * i));
    }
  });
  return map;
}

std::vector<float> flipOf(const io::RadianceImage& reference, const io::RadianceImage& picture) {
  const auto colors = [](const io::RadianceImage& image) {
    std::vector<glm::dvec3> out;
    for (const glm::vec4& pixel : image.pixels) out.push_back(finiteColor(pixel));
    return out;
  };
  return flipMap(colors(reference), colors(picture), reference.width, reference.height);
}

}  // namespace

Result<io::Pixels> heatMap(const io::RadianceImage& reference, const io::RadianceImage& picture,
                           const CompareOptions& options) {
  return heatPicture(reference, picture, options,
                     [&](size_t i) { return displayDifference(reference.pixels[i], picture.pixels[i]); });
}

Result<io::Pixels> flipHeatMap(const io::RadianceImage& reference, const io::RadianceImage& picture,
                               const CompareOptions& options) {
  if (auto checked = checkSizes(reference, picture); !checked) return tl::unexpected(checked.error());
  std::vector<float> flip = flipOf(reference, picture);
  if (!isOpaque(reference) || !isOpaque(picture)) {
    const std::vector<float> white = flipOf(overWhite(reference), overWhite(picture));
    for (size_t i = 0; i < flip.size(); ++i) flip[i] = std::max(flip[i], white[i]);
  }
  return heatPicture(reference, picture, options, [&](size_t i) { return static_cast<double>(flip[i]); });
}

}  // namespace facet::compare
