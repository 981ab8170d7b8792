#include "io/film_webp.hpp"

#include <webp/encode.h>
#include <webp/mux.h>

#include "io/picture_file.hpp"

namespace facet::io {

namespace {

tl::unexpected<Error> noFilmMemory() {
  return fail("", "", "there is not enough memory for the film", "take fewer or smaller pictures");
}

}  // namespace

struct WebpFilm::Encoder {
  std::unique_ptr<WebPAnimEncoder, decltype(&WebPAnimEncoderDelete)> animation{nullptr, WebPAnimEncoderDelete};
  WebPConfig config;
};

Result<WebpFilm> WebpFilm::begin(int width, int height, int quality) {
  if (Result<void> r = checkPictureSize(PictureFormat::webp, width, height, ""); !r) return tl::unexpected(r.error());
  auto encoder = std::make_shared<Encoder>();
  WebPAnimEncoderOptions options;
  if (!WebPAnimEncoderOptionsInit(&options) || !WebPConfigInit(&encoder->config)) return noFilmMemory();
  options.anim_params.loop_count = 0;
  encoder->config.quality = static_cast<float>(quality);
  if (quality == 100 && !WebPConfigLosslessPreset(&encoder->config, 2)) return noFilmMemory();
  encoder->config.thread_level = 1;
  encoder->config.use_sharp_yuv = 1;
  encoder->animation.reset(WebPAnimEncoderNew(width, height, &options));
  if (!encoder->animation) return noFilmMemory();
  return WebpFilm(std::move(encoder));
}

Result<void> WebpFilm::add(const Pixels& pixels, int milliseconds) {
  WebPPicture picture;
  if (!WebPPictureInit(&picture)) return noFilmMemory();
  const std::unique_ptr<WebPPicture, decltype(&WebPPictureFree)> freed(&picture, WebPPictureFree);
  picture.use_argb = 1;
  picture.width = pixels.width, picture.height = pixels.height;
  const auto import = pixels.channels == 4 ? WebPPictureImportRGBA : WebPPictureImportRGB;
  if (!import(&picture, pixels.data.data(), pixels.width * pixels.channels) ||
      !WebPAnimEncoderAdd(encoder_->animation.get(), &picture, milliseconds, &encoder_->config))
    return noFilmMemory();
  return {};
}

Result<std::vector<uint8_t>> WebpFilm::end(int milliseconds) {
  WebPData data;
  WebPDataInit(&data);
  const std::unique_ptr<WebPData, decltype(&WebPDataClear)> freed(&data, WebPDataClear);
  if (!WebPAnimEncoderAdd(encoder_->animation.get(), nullptr, milliseconds, nullptr) ||
      !WebPAnimEncoderAssemble(encoder_->animation.get(), &data))
    return noFilmMemory();
  return std::vector<uint8_t>(data.bytes, data.bytes + data.size);
}

}  // namespace facet::io
