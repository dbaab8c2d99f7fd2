#include "library_probe.h"

#include <gtest/gtest.h>
#include <ode/ode.h>

using namespace bench;

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
