// Thread managers are made by name.
#include "threading/managers/dxThreadManagerFactory.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

TEST(ThreadManagerFactory, MakesEveryManagerItNames) {
    const std::vector<const char *> names = dxThreadManagerFactory::names();
    EXPECT_FALSE(names.empty());
    for (const char *name : names) {
        const auto manager = dxThreadManagerFactory::create(name);
        ASSERT_NE(manager, nullptr) << name;
        EXPECT_STREQ(manager->name(), name);
        EXPECT_EQ(manager->workers(), 1u);
    }
    EXPECT_NE(std::find(names.begin(), names.end(), std::string(dxThreadManagerFactory::defaultName())),
              names.end());
}

TEST(ThreadManagerFactory, ListsTheKnownNamesForAnUnknownOne) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(dxThreadManagerFactory::create("tbb"), nullptr);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("ODE_MT error: unknown thread manager 'tbb'; known: pthread"), std::string::npos)
        << said;
}

}  // namespace
