#include <png.h>

#include <cstring>

#include "core/atomic_file.h"
#include "core/error.h"
#include "plugins/render/picture.h"

namespace ringlet {
namespace {

/// With libpng's interface for whole pictures, which reports errors without longjmp.
std::vector<char> encode(const Picture& picture) {
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  image.format = PNG_FORMAT_RGB;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<char> encoded(size);
  const int written =
      png_image_write_to_memory(&image, encoded.data(), &size, 0, picture.bytes.data(), 0, nullptr);
  if (written == 0) throw Error(std::string("libpng cannot write a picture: ") + image.message);
  encoded.resize(size);
  return encoded;
}

}  // namespace

void write_png(const Picture& picture, const std::filesystem::path& path) {
  const std::vector<char> encoded = encode(picture);
  AtomicFile file(path);
  file.stream().write(encoded.data(), static_cast<std::streamsize>(encoded.size()));
  file.commit();
}

}  // namespace ringlet
