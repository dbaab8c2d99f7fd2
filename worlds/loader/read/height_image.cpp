#include "loader/read/height_image.h"

#include <stb_image.h>
#include <zlib.h>

#include <cstdint>
#include <memory>
#include <new>
#include <vector>

#include "loader/read/regular_file.h"

namespace worlds {

namespace {

const std::string signature = "\x89PNG\r\n\x1a\n";

std::uint32_t bigEndian(const std::string &bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = at; i < at + 4; ++i) number = number << 8 | static_cast<unsigned char>(bytes[i]);
    return number;
}

const Bytef *data(const std::string &bytes, std::size_t at) {
    return reinterpret_cast<const Bytef *>(bytes.data() + at);
}

// Bytes of a picture, or of one pass of an interlaced one: a filter and its pixels in every row.
std::uint64_t sizeOf(std::uint64_t columns, std::uint64_t rows, unsigned bitsPerPixel) {
    return columns == 0 ? 0 : rows * (1 + (columns * bitsPerPixel + 7) / 8);
}

// Returns the size that follows from the header, width to interlacing.
std::uint64_t expectedSize(const std::string &header) {
    const std::uint64_t columns = bigEndian(header, 0), rows = bigEndian(header, 4);
    const unsigned depth = static_cast<unsigned char>(header[8]),
                   colour = static_cast<unsigned char>(header[9]);
    const unsigned channels = colour == 2 ? 3 : colour == 4 ? 2 : colour == 6 ? 4 : 1;
    if (header[12] == 0) return sizeOf(columns, rows, depth * channels);
    constexpr unsigned first[7][2] = {{0, 0}, {4, 0}, {0, 4}, {2, 0}, {0, 2}, {1, 0}, {0, 1}};
    constexpr unsigned every[7][2] = {{8, 8}, {8, 8}, {4, 8}, {4, 4}, {2, 4}, {2, 2}, {1, 2}};
    std::uint64_t size = 0;
    for (int pass = 0; pass < 7; ++pass)
        size += sizeOf((columns + every[pass][0] - 1 - first[pass][0]) / every[pass][0],
                       (rows + every[pass][1] - 1 - first[pass][1]) / every[pass][1], depth * channels);
    return size;
}

// How many bytes `packed` holds; nothing when its end is missing, its checksum wrong, or more follows
// it.
bool unpackedSize(const std::string &packed, std::uint64_t most, std::uint64_t &size) {
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) throw std::bad_alloc();
    std::vector<Bytef> part(1u << 16);
    stream.next_in = const_cast<Bytef *>(data(packed, 0));
    stream.avail_in = static_cast<uInt>(packed.size());
    int state = Z_OK;
    for (size = 0; state == Z_OK && size <= most;) {
        stream.next_out = part.data();
        stream.avail_out = static_cast<uInt>(part.size());
        state = inflate(&stream, Z_NO_FLUSH);
        size += part.size() - stream.avail_out;
    }
    const bool isWhole = state == Z_STREAM_END && stream.avail_in == 0;
    inflateEnd(&stream);
    return isWhole || size > most;
}

// Looks through a PNG file before it is decoded: the decoder passes over every checksum.
//
// Returns an empty text for a file that is no PNG; else what is wrong with it: a part or the whole is cut off, a checksum
// does not match, or there are more or fewer pixels than its size says.
std::string whyNotPng(const std::string &bytes) {
    if (bytes.compare(0, signature.size(), signature) != 0) return {};
    std::string header, pixels;
    constexpr std::size_t around = 12;  // bytes of a chunk's length, type and checksum
    for (std::size_t at = signature.size();;) {
        if (bytes.size() - at < around || bytes.size() - at - around < bigEndian(bytes, at))
            return "is cut off";
        const std::size_t length = bigEndian(bytes, at);
        const std::string type = bytes.substr(at + 4, 4);
        if (crc32(0, data(bytes, at + 4), static_cast<uInt>(length + 4)) != bigEndian(bytes, at + 8 + length))
            return "the checksum of a part is wrong";
        if (header.empty()) {
            if (type != "IHDR" || length != 13) return "has no header";
            header = bytes.substr(at + 8, length);
        }
        if (type == "IDAT") pixels.append(bytes, at + 8, length);
        at += around + length;
        if (type == "IEND") break;
    }
    std::uint64_t size = 0;
    if (!unpackedSize(pixels, expectedSize(header), size))
        return "its pixels are cut off, or their checksum is wrong";
    if (size != expectedSize(header)) return "has more or fewer pixels than its size says";
    return {};
}

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
