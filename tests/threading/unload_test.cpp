// dlclose while workers are idle.
//
// Covers dxOpenMPRuntime.cpp.
#include <dlfcn.h>
#include <unistd.h>

#include "ManagerKinds.h"
#include "processThreads.h"

namespace {

TEST_P(ThreadManagerTest, LibraryCanBeUnloadedWithIdleWorkers) {
    if (!GetParam().ownThreads) GTEST_SKIP() << "the threads are the user's";
    const unsigned before = processThreads();
    for (int i = 0; i < 10; ++i) {
        void *library = dlopen(UNLOAD_MODULE, RTLD_NOW | RTLD_LOCAL);
        ASSERT_NE(library, nullptr) << dlerror();
        const auto use =
            reinterpret_cast<unsigned (*)(const char *, unsigned)>(dlsym(library, "useThreadManager"));
        ASSERT_NE(use, nullptr);
        EXPECT_EQ(use(GetParam().name.c_str(), 4), 499500u);
        if (GetParam().endsThreads) {
            EXPECT_GT(processThreads(), before);
        }
        ASSERT_EQ(dlclose(library), 0);
        EXPECT_EQ(dlopen(UNLOAD_MODULE, RTLD_NOW | RTLD_NOLOAD), nullptr) << "something keeps the library";
        if (GetParam().endsThreads) {
            EXPECT_TRUE(threadsFallTo(before));
        }
    }
    // The handlers for fork went with the library.
    const pid_t child = fork();
    if (child == 0) _exit(0);
    EXPECT_GT(child, 0);
}

}  // namespace
