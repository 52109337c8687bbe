#include <png.h>

#include <cstring>

#include "core/error.h"
#include "plugins/render/picture.h"
#include "tests/catch.h"
#include "tests/temporary_folder.h"

using namespace ringlet;

TEST_CASE("a PNG file holds the picture, to the bit") {
  Picture picture{37, 11, {}};
  for (int i = 0; i < 3 * 37 * 11; ++i) {
    picture.bytes.push_back(static_cast<std::uint8_t>(i * i % 251));
  }
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "picture.png").string();
  write_png(picture, path);

  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_file(&image, path.c_str()) != 0);
  CHECK(image.width == 37);
  CHECK(image.height == 11);
  CHECK(image.format == PNG_FORMAT_RGB);
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
  REQUIRE(png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr) != 0);
  CHECK(bytes == picture.bytes);
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
  CHECK_THROWS_AS(write_png(picture, folder.path() / "none" / "picture.png"), Error);
}
