#include "loader/read/height_image.h"

#include "loader/read/png_check.h"
#include "loader/read/regular_file.h"

#include <stb_image.h>

#include <memory>

namespace worlds {

namespace {

constexpr std::uintmax_t longestImageFile = 1u << 30;  // bytes
constexpr int maxPixels = 100000000;                  // 18 bytes are taken for each

// The library has no words for a file that ends too early.
std::string reason() {
    const char *const said = stbi_failure_reason();
    return said && *said ? said : "is cut off";
}

}  // namespace

HeightField readHeightImage(const std::string &file, const Vector3 &size,
                            const Place &place) {
    const auto fail = [&](const std::string &what) {
        return LoadError(LoadError::Kind::Resource, place, "image file " + file + ": " + what);
    };
    const std::string wrong = whyNotReadable(file, longestImageFile);
    if (!wrong.empty()) throw fail(wrong);
    std::string bytes;
    if (!readBytes(file, bytes)) throw fail("cannot be read");
    if (const std::string fault = whyNotPng(bytes); !fault.empty()) throw fail(fault);
    HeightField field;
    if (!stbi_info(file.c_str(), &field.columns, &field.rows, nullptr)) throw fail(reason());
    if (field.columns < 2 || field.rows < 2) throw fail("a height map needs 2 x 2 pixels or more");
    if (static_cast<double>(field.columns) * field.rows > maxPixels)
        throw fail(std::to_string(field.columns) + " x " + std::to_string(field.rows) +
                   " pixels are more than " + std::to_string(maxPixels));
    const std::unique_ptr<stbi_us, void (*)(void *)> pixels(
        stbi_load_16(file.c_str(), &field.columns, &field.rows, nullptr, STBI_grey), stbi_image_free);
    if (!pixels) throw fail(reason());

    constexpr double white = 0xffff;
    const std::size_t count = static_cast<std::size_t>(field.columns) * field.rows;
    field.heights.reserve(count);
    for (std::size_t i = 0; i < count; ++i) field.heights.push_back(pixels.get()[i] / white * size.z);
    field.width = size.x;
    field.depth = size.y;
    return field;
}

}  // namespace worlds
