#include "worlds/asset_files.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <vector>

namespace fuzz_worlds {

namespace {

using Corner = std::array<float, 3>;

// A tetrahedron.
constexpr std::array<Corner, 4> kCorners = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr std::array<std::array<int, 3>, 4> kFaces = {{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};

template <class Number>
void append(std::string &bytes, Number number) {
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    bytes.append(raw, sizeof raw);
}

// PNG and its checksums are big-endian.
void appendBigEndian(std::string &bytes, std::uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
}

std::string asciiStlMesh() {
    std::ostringstream text;
    text << "solid tetrahedron\n";
    for (const auto &face : kFaces) {
        text << "facet normal 0 0 0\n outer loop\n";
        for (const int corner : face)
            text << "  vertex " << kCorners[corner][0] << ' ' << kCorners[corner][1] << ' '
                 << kCorners[corner][2] << '\n';
        text << " endloop\nendfacet\n";
    }
    text << "endsolid tetrahedron\n";
    return text.str();
}

std::string plyMesh(const std::string &format) {
    std::string text = "ply\nformat " + format +
                       " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                       "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
    if (format == "ascii") {
        std::ostringstream body;
        for (const Corner &corner : kCorners)
            body << corner[0] << ' ' << corner[1] << ' ' << corner[2] << '\n';
        for (const auto &face : kFaces) body << "3 " << face[0] << ' ' << face[1] << ' ' << face[2] << '\n';
        return text + body.str();
    }
    for (const Corner &corner : kCorners)
        for (const float number : corner) append(text, number);
    for (const auto &face : kFaces) {
        text += '\3';
        for (const int corner : face) append(text, static_cast<std::int32_t>(corner));
    }
    return text;
}

const char *const kCollada = R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
  <library_geometries><geometry id="g" name="g"><mesh>
    <source id="p"><float_array id="a" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array>
      <technique_common><accessor source="#a" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
        <param name="Z" type="float"/></accessor></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="s" name="s"><node id="n" name="n"><matrix sid="transform">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>
    <instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
)";

std::uint32_t crc32(const std::string &bytes) {
    std::uint32_t crc = 0xffffffffu;
    for (const char byte : bytes) {
        crc ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return ~crc;
}

std::uint32_t adler32(const std::string &bytes) {
    std::uint32_t a = 1, b = 0;
    for (const char byte : bytes) {
        a = (a + static_cast<unsigned char>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

void appendChunk(std::string &png, const std::string &type, const std::string &data) {
    appendBigEndian(png, static_cast<std::uint32_t>(data.size()));
    png += type + data;
    appendBigEndian(png, crc32(type + data));
}

// 4 x 4 grey pixels, in a block of zlib's that is not compressed.
std::string png() {
    constexpr std::uint32_t kSide = 4;
    std::string rows;
    for (std::uint32_t y = 0; y < kSide; ++y) {
        rows += '\0';  // no filter
        for (std::uint32_t x = 0; x < kSide; ++x) rows += static_cast<char>(60 * x + 5 * y);
    }
    std::string header, data = "\x78\x01\x01";
    appendBigEndian(header, kSide);
    appendBigEndian(header, kSide);
    header += std::string("\x08\x00\x00\x00\x00", 5);
    const auto length = static_cast<std::uint16_t>(rows.size());
    append(data, length);
    append(data, static_cast<std::uint16_t>(~length));
    data += rows;
    appendBigEndian(data, adler32(rows));
    std::string file = "\x89PNG\r\n\x1a\n";
    appendChunk(file, "IHDR", header);
    appendChunk(file, "IDAT", data);
    appendChunk(file, "IEND", "");
    return file;
}

// 4 x 3 pixels of 24 bits.
std::string bmp() {
    std::string file = "BM";
    append(file, std::uint32_t{54 + 36});
    append(file, std::uint32_t{0});
    append(file, std::uint32_t{54});
    append(file, std::uint32_t{40});
    append(file, std::int32_t{4});
    append(file, std::int32_t{3});
    append(file, std::uint16_t{1});
    append(file, std::uint16_t{24});
    for (int i = 0; i < 6; ++i) append(file, std::uint32_t{0});
    for (int i = 0; i < 36; ++i) file += static_cast<char>(7 * i);
    return file;
}

// 3 x 3 pixels, run-length encoded.
std::string tga() {
    std::string file(18, '\0');
    file[2] = 11;  // grey, run-length encoded
    file[12] = file[14] = 3;
    file[16] = 8;
    return file + std::string("\x83\x40\x84\x80", 4) + std::string(4, '\x11');
}

}  // namespace

std::string objMesh() {
    std::ostringstream text;
    text << "# a tetrahedron\no t\n";
    for (const Corner &corner : kCorners)
        text << "v " << corner[0] << ' ' << corner[1] << ' ' << corner[2] << '\n';
    for (const auto &face : kFaces)
        text << "f " << face[0] + 1 << ' ' << face[1] + 1 << ' ' << face[2] + 1 << '\n';
    return text.str();
}

std::string binaryStlMesh() {
    std::string bytes(80, ' ');
    append(bytes, static_cast<std::uint32_t>(kFaces.size()));
    for (const auto &face : kFaces) {
        bytes.append(12, '\0');  // the normal follows from the corners
        for (const int corner : face)
            for (const float number : kCorners[corner]) append(bytes, number);
        bytes.append(2, '\0');
    }
    return bytes;
}

std::string greyImage() {
    std::string image = "P5\n4 4\n255\n";
    for (int i = 0; i < 16; ++i) image += static_cast<char>(16 * i);
    return image;
}

std::map<std::string, std::string> assetFiles() {
    return {{"shape.obj", objMesh()},
            {"ascii.stl", asciiStlMesh()},
            {"binary.stl", binaryStlMesh()},
            {"ascii.ply", plyMesh("ascii")},
            {"binary.ply", plyMesh("binary_little_endian")},
            {"shape.dae", kCollada},
            {"hills.pgm", greyImage()},
            {"hills.png", png()},
            {"hills.bmp", bmp()},
            {"hills.tga", tga()}};
}

bool isImage(const std::string &file) { return file.rfind("hills.", 0) == 0; }

}  // namespace fuzz_worlds
