#include "loader/read/height_image.h"

#include "loader/read/regular_file.h"

#include <stb_image.h>

#include <memory>

namespace worlds {

namespace {

constexpr std::uintmax_t longestImageFile = 1u << 30;  // bytes
constexpr int mostPixels = 100000000;                  // 18 bytes are taken for each

}  // namespace

HeightField readHeightImage(const std::string &file, const ignition::math::Vector3d &size,
                            const Place &place) {
    const auto fail = [&](const std::string &what) {
        return LoadError(LoadError::Kind::Resource, place, "image file " + file + ": " + what);
    };
    const std::string wrong = whyNotReadable(file, longestImageFile);
    if (!wrong.empty()) throw fail(wrong);
    HeightField field;
    if (!stbi_info(file.c_str(), &field.columns, &field.rows, nullptr)) throw fail(stbi_failure_reason());
    if (field.columns < 2 || field.rows < 2) throw fail("a height map needs 2 x 2 pixels or more");
    if (static_cast<double>(field.columns) * field.rows > mostPixels)
        throw fail(std::to_string(field.columns) + " x " + std::to_string(field.rows) +
                   " pixels are more than " + std::to_string(mostPixels));
    const std::unique_ptr<stbi_us, void (*)(void *)> pixels(
        stbi_load_16(file.c_str(), &field.columns, &field.rows, nullptr, STBI_grey), stbi_image_free);
    if (!pixels) throw fail(stbi_failure_reason());

    constexpr double white = 0xffff;
    const std::size_t count = static_cast<std::size_t>(field.columns) * field.rows;
    field.heights.reserve(count);
    for (std::size_t i = 0; i < count; ++i) field.heights.push_back(pixels.get()[i] / white * size.Z());
    field.width = size.X();
    field.depth = size.Y();
    return field;
}

}  // namespace worlds
