#include "io/ktx2/astc.hpp"

#include <astcenc.h>

#include <memory>

#include "io/image_formats.hpp"

namespace facet::io {

namespace {

struct FreeAstc {
  void operator()(astcenc_context* context) const { astcenc_context_free(context); }
};

}  // namespace

Result<void> decodeAstc(std::span<const uint8_t> level, int blockWidth, int blockHeight, bool srgb, int width,
                        int height, uint8_t* rgba) {
  const auto failed = [](astcenc_error status) {
    if (status == ASTCENC_ERR_OUT_OF_MEM) throw std::bad_alloc();
    return damagedImage(std::string("its ASTC data: ") + astcenc_get_error_string(status));
  };
  astcenc_config config = {};
  astcenc_error status = astcenc_config_init(srgb ? ASTCENC_PRF_LDR_SRGB : ASTCENC_PRF_LDR,
                                             static_cast<unsigned>(blockWidth), static_cast<unsigned>(blockHeight), 1,
                                             ASTCENC_PRE_FASTEST, ASTCENC_FLG_DECOMPRESS_ONLY, &config);
  if (status != ASTCENC_SUCCESS) return failed(status);
  astcenc_context* made = nullptr;
  status = astcenc_context_alloc(&config, 1, &made);
  if (status != ASTCENC_SUCCESS) return failed(status);
  const std::unique_ptr<astcenc_context, FreeAstc> context(made);
  void* slices[] = {rgba};
  astcenc_image image = {static_cast<unsigned>(width), static_cast<unsigned>(height), 1, ASTCENC_TYPE_U8, slices};
  const astcenc_swizzle swizzle = {ASTCENC_SWZ_R, ASTCENC_SWZ_G, ASTCENC_SWZ_B, ASTCENC_SWZ_A};
  status = astcenc_decompress_image(context.get(), level.data(), level.size(), &image, &swizzle, 0);
  if (status != ASTCENC_SUCCESS) return failed(status);
  return {};
}

}  // namespace facet::io
