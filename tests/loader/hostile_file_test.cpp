// Files that are none: FIFOs, folders, loops of links, names beyond all length, images and texts too large.
// Loading neither hangs nor crashes, and says what is wrong.
#include "small_world.h"
#include "test_folder.h"

#include "loader/load_world.h"

#include <sys/stat.h>

namespace {

using namespace small_world;
namespace fs = std::filesystem;

class HostileFile : public testing::Test {
protected:
    HostileFile() {
        ::mkfifo(folder.path("fifo").c_str(), 0600);
        ::mkfifo(folder.path("fifo.obj").c_str(), 0600);
        fs::create_directory(folder.path("folder"));
        fs::create_symlink("loop", folder.path("loop"));
    }

    static std::string fileMessage(const std::string &file) {
        try {
            worlds::loadWorld(file);
        } catch (const worlds::LoadError &error) {
            return error.what();
        }
        return "loaded";
    }
    std::string geometryMessage(const std::string &geometry) const {
        try {
            worlds::loadWorldText(world(staticModel("m", "0 0 0 0 0 0", geometry)), folder.path("test.sdf"));
        } catch (const worlds::LoadError &error) {
            return error.what();
        }
        return "loaded";
    }
    void expectReason(const std::string &geometry, const std::string &reason) const {
        const std::string message = geometryMessage(geometry);
        EXPECT_EQ(message.find(folder.path("test.sdf") +
                               ": /sdf/world/model[m]/link[link]/collision[shape]/geometry/"),
                  0u)
            << message;
        EXPECT_NE(message.find(reason), std::string::npos) << message << "\n  does not say " << reason;
    }
    static std::string mesh(const std::string &uri) { return "<mesh><uri>" + uri + "</uri></mesh>"; }
    static std::string image(const std::string &uri) {
        return "<heightmap><uri>" + uri + "</uri><size>1 1 1</size></heightmap>";
    }

    TestFolder folder{"hostile_file"};
};

TEST_F(HostileFile, AsWorld) {
    EXPECT_EQ(fileMessage(folder.path("fifo")), folder.path("fifo") + ": is not a regular file");
    EXPECT_EQ(fileMessage("/dev/zero"), "/dev/zero: is not a regular file");
    EXPECT_EQ(fileMessage(folder.path("folder")), folder.path("folder") + ": is a folder");
    EXPECT_EQ(fileMessage(folder.path("loop")), folder.path("loop") + ": Too many levels of symbolic links");
    EXPECT_NE(fileMessage("/" + std::string(5000, 'x')).find(": File name too long"), std::string::npos);
}

TEST_F(HostileFile, AsNameOfAWorld) {
    const auto message = [](const std::string &name) -> std::string {
        try {
            return worlds::findWorld(name);
        } catch (const std::invalid_argument &error) {
            return error.what();
        }
    };
    EXPECT_NE(message(folder.path("folder")).find("is a folder"), std::string::npos);
    EXPECT_NE(message(folder.path("fifo")).find("is not a regular file"), std::string::npos);
    EXPECT_NE(message(folder.path("loop")).find("Too many levels"), std::string::npos);
    EXPECT_NE(message(std::string(30000, 'x')).find("no world"), std::string::npos);
    EXPECT_NE(message("\x1b[31m").find("'\\x1b[31m'"), std::string::npos);
}

TEST_F(HostileFile, AsMesh) {
    expectReason(mesh("fifo"), "fifo: is not a regular file");
    expectReason(mesh("folder"), "folder: is a folder");
    expectReason(mesh("loop"), "no file 'loop'");
    expectReason(mesh(std::string(900, 'x')), "no file 'xxx");
    folder.write("cube.obj", "mtllib fifo.obj\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(geometryMessage(mesh("cube.obj")), "loaded");
}

TEST_F(HostileFile, AsImage) {
    expectReason(image("fifo"), "fifo: is not a regular file");
    expectReason(image("folder"), "folder: is a folder");
    folder.write("huge.pgm", "P5\n20000 20000\n255\nxxxx");
    expectReason(image("huge.pgm"), "20000 x 20000 pixels are more than 100000000");
}

TEST_F(HostileFile, AsIncludedModel) {
    const auto message = [&](const std::string &uri) -> std::string {
        try {
            worlds::loadWorldText(world("<include><uri>" + uri + "</uri></include>"),
                                  folder.path("test.sdf"));
        } catch (const worlds::LoadError &error) {
            return error.what();
        }
        return "loaded";
    };
    const std::string place = folder.path("test.sdf") + ": /sdf/world/include/uri: ";
    EXPECT_EQ(message("fifo"), place + folder.path("fifo") + ": is not a regular file");
    EXPECT_EQ(message("loop").find(place + "no model 'loop': looked for in "), 0u) << message("loop");
    ::mkfifo(folder.path("folder/model.config").c_str(), 0600);
    EXPECT_EQ(message("folder"),
              place + "model 'folder': " + folder.path("folder/model.config") + ": is not a regular file");
}

}  // namespace
