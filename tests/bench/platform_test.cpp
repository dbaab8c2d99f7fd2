#include "platform.h"

#include <gtest/gtest.h>
#include <ode/ode.h>
#include <unistd.h>

#include <filesystem>
#include <sstream>

using namespace bench;

namespace {

std::string processorIn(const std::string &text) {
    std::istringstream stream(text);
    return readProcessor(stream);
}

}  // namespace

TEST(Machine, TheFirstProcessorIsNamed) {
    EXPECT_EQ(processorIn("processor\t: 0\nmodel name\t: Core i5: fast\nmodel name\t: other\n"),
              "Core i5: fast");
}

TEST(Machine, NoNameIsNoError) {
    EXPECT_EQ(processorIn("processor : 0\n"), "");
    EXPECT_EQ(processorIn("model name\t:\n"), "");
    EXPECT_EQ(processorIn(""), "");
}

TEST(Machine, ThisOneHasACore) { EXPECT_GE(thisMachine().cores, 1u); }

namespace {

const std::string kOurs = ODEMT_OUR_FOLDER "/libode.so.8", kOracle = ODEMT_ORACLE;

class LibraryRelease : public testing::Test {
protected:
    LibraryRelease() { std::filesystem::create_directories(folder); }
    ~LibraryRelease() override { std::filesystem::remove_all(folder); }

    std::string copyOf(const std::string &library, const std::string &name) const {
        std::filesystem::copy_file(library, folder + '/' + name);
        return folder + '/' + name;
    }

    const std::string folder = testing::TempDir() + "/library_release_" + std::to_string(getpid());
};

}  // namespace

TEST_F(LibraryRelease, OursSaysItWhateverTheNameOfItsFile) {
    EXPECT_EQ(releaseOfLibrary(kOurs), ODEMT_UPSTREAM);
    EXPECT_EQ(releaseOfLibrary(copyOf(kOurs, "ours.so")), ODEMT_UPSTREAM);
    EXPECT_EQ(releaseOfLibrary(copyOf(kOurs, "libode.so.8.99.0")), ODEMT_UPSTREAM);
}

TEST_F(LibraryRelease, OthersAreKnownByTheNumberOfTheirFile) {
    EXPECT_EQ(releaseOfLibrary(copyOf(kOracle, "libode.so.8.0.2")), "0.16.2");
    EXPECT_EQ(releaseOfLibrary(copyOf(kOracle, "libode.so.8.2.0")), "0.16.6");
    std::filesystem::create_symlink("libode.so.8.2.0", folder + "/libode.so.8");
    EXPECT_EQ(releaseOfLibrary(folder + "/libode.so.8"), "0.16.6");
    EXPECT_EQ(releaseOfLibrary(copyOf(kOracle, "libode.so.8.99.0")), kUnknownRelease);
    EXPECT_EQ(releaseOfLibrary(folder + "/none"), kUnknownRelease);
}

// Also of a file that is not there any more.
TEST_F(LibraryRelease, ANameIsEnough) {
    EXPECT_EQ(releaseByName("/nowhere/libode.so.8.0.2"), "0.16.2");
    EXPECT_EQ(releaseByName("/nowhere/libode.so.8"), kUnknownRelease);
}

TEST_F(LibraryRelease, OursIsToldFromOthers) {
    EXPECT_TRUE(isOurLibrary(kOurs));
    EXPECT_FALSE(isOurLibrary(kOracle));
    EXPECT_FALSE(isOurLibrary(folder));
}

TEST_F(LibraryRelease, AnUnknownOneIsNoOtherRelease) {
    EXPECT_TRUE(areOtherReleases("0.16.2", "0.16.6"));
    EXPECT_FALSE(areOtherReleases("0.16.2", "0.16.2"));
    EXPECT_FALSE(areOtherReleases("0.16.2", kUnknownRelease));
    EXPECT_FALSE(areOtherReleases(kUnknownRelease, "0.16.6"));
}

// The test runs on whichever library the loader finds; without LD_LIBRARY_PATH that is Debian's.
TEST(LibraryProbe, FindsTheLibraryThatRuns) {
    const volatile auto linked = &dWorldStep;  // keeps the library linked
    EXPECT_TRUE(linked);
    const LibraryProbe library = probeLibrary();
    EXPECT_NE(library.file.find("libode.so.8"), std::string::npos) << library.file;
    if (!library.isOurs) {
        EXPECT_EQ(library.threads(), 0);
        EXPECT_EQ(library.manager(), "");
        EXPECT_EQ(library.callbacks(), "");
        EXPECT_EQ(library.gridCells(), 0);
        EXPECT_EQ(library.sharedSteps(), 0u);
    }
}
