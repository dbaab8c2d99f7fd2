// Height maps whose files were damaged are errors, not other heights.
#include "small_world.h"
#include "test_folder.h"

#include <stb_image_write.h>

#include <fstream>
#include <sstream>

namespace {

using namespace small_world;

class PngCheck : public testing::Test {
protected:
    PngCheck() {
        unsigned char pixels[25];
        for (int i = 0; i < 25; ++i) pixels[i] = static_cast<unsigned char>(10 * i);
        stbi_write_png(folder.path("good.png").c_str(), 5, 5, 1, pixels, 5);
        std::ostringstream bytes;
        bytes << std::ifstream(folder.path("good.png"), std::ios::binary).rdbuf();
        good = bytes.str();
    }
    std::string message(const std::string &bytes) const {
        folder.write("map.png", bytes);
        try {
            worlds::loadWorldText(
                world(staticModel("m", "0 0 0 0 0 0",
                                  "<heightmap><uri>map.png</uri><size>4 4 1</size></heightmap>")),
                folder.path("test.sdf"));
        } catch (const worlds::LoadError &error) {
            EXPECT_NE(std::string(error.what()).find("/geometry/heightmap: image file "), std::string::npos)
                << error.what();
            return std::string(error.what()).substr(std::string(error.what()).rfind("map.png: "));
        }
        return "loaded";
    }

    TestFolder folder{"png_check"};
    std::string good;
};

TEST_F(PngCheck, EveryChangedByteIsNoticed) {
    ASSERT_EQ(message(good), "loaded");
    for (std::size_t i = 8; i < good.size(); i += 7) {
        std::string changed = good;
        changed[i] = static_cast<char>(changed[i] ^ 4);
        EXPECT_NE(message(changed), "loaded") << "byte " << i;
    }
}

TEST_F(PngCheck, EveryCutIsNamed) {
    for (std::size_t length = 8; length < good.size(); length += 9)
        EXPECT_EQ(message(good.substr(0, length)), "map.png: is cut off") << length;
    EXPECT_EQ(message(good.substr(0, good.size() - 12)), "map.png: is cut off");
}

TEST_F(PngCheck, AnotherSizeThanThePixelsHaveIsNamed) {
    std::string lower = good;  // 5 x 4, with the checksum of that header
    ASSERT_EQ(lower[23], 5);
    lower[23] = 4;
    lower.replace(29, 4, "\x63\x58\xaa\x9c", 4);
    EXPECT_EQ(message(lower), "map.png: has more or fewer pixels than its size says");
}

}  // namespace
