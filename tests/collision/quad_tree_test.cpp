// dxQuadTree: blocks and their order, and where a box goes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include <ode/ode.h>

#include "collision/spaces/quad_tree/dxQuadTree.h"

namespace {

using Block = dxQuadTree::Block;

constexpr dReal kNaN = std::numeric_limits<dReal>::quiet_NaN();

dxQuadTree treeAround(dReal x, dReal y, dReal extent, int depth) {
    const dVector3 centre = {x, y, 0}, extents = {extent, extent, extent};
    return dxQuadTree(centre, extents, depth);
}

Block findFrom(const dxQuadTree &tree, Block from, dReal lowX, dReal highX, dReal lowY, dReal highY) {
    const dReal aabb[6] = {lowX, highX, lowY, highY, 0, 0};
    return tree.find(aabb, from);
}

// Finds a box's block, starting at the root.
Block find(const dxQuadTree &tree, dReal lowX, dReal highX, dReal lowY, dReal highY) {
    return findFrom(tree, dxQuadTree::kRoot, lowX, highX, lowY, highY);
}

TEST(QuadTree, BlocksAreNumberedWithTheirQuartersBehindThem) {
    const dxQuadTree tree = treeAround(0, 0, 8, 2);
    EXPECT_EQ(tree.size(), 21u);
    EXPECT_EQ(tree.endOf(0), 21u);
    for (const Block quarter : {1u, 6u, 11u, 16u}) {
        EXPECT_EQ(tree.endOf(quarter), quarter + 5);
        for (Block leaf = quarter + 1; leaf < quarter + 5; ++leaf) EXPECT_EQ(tree.endOf(leaf), leaf + 1);
    }
}

TEST(QuadTree, ABoxGoesToTheSmallestBlockThatHasIt) {
    const dxQuadTree tree = treeAround(0, 0, 8, 2);
    EXPECT_EQ(find(tree, -1, 1, -1, 1), 0u);
    EXPECT_EQ(find(tree, -5, -3, -5, -3), 1u);
    EXPECT_EQ(find(tree, -7, -6, -7, -6), 2u);   // low x, low y
    EXPECT_EQ(find(tree, -7, -6, 6, 7), 6u + 2);  // low x, high y
    EXPECT_EQ(find(tree, 6, 7, -7, -6), 11u + 3);
    EXPECT_EQ(find(tree, 6, 7, 6, 7), 20u);
}

TEST(QuadTree, ABlockHasItsLowerEdgesOnly) {
    const dxQuadTree tree = treeAround(0, 0, 8, 1);
    EXPECT_EQ(find(tree, 0, 1, 0, 1), 4u);
    EXPECT_EQ(find(tree, -1, 0, -1, 0), 0u);
    EXPECT_EQ(find(tree, 7, 8, 7, 8), 4u);  // but the tree has its upper edges
    EXPECT_EQ(find(tree, -8, -8, -8, -8), 1u);
}

TEST(QuadTree, WhatDoesNotFitIsInTheRoot) {
    const dxQuadTree tree = treeAround(0, 0, 8, 3);
    const dReal infinity = std::numeric_limits<dReal>::infinity();
    EXPECT_EQ(find(tree, 20, 21, 0, 1), 0u);
    EXPECT_EQ(find(tree, -infinity, infinity, 1, 2), 0u);
    EXPECT_EQ(find(tree, 1, kNaN, 1, 2), 0u);
    EXPECT_EQ(find(tree, 1, 2, kNaN, 2), 0u);
}

TEST(QuadTree, WhereABoxComesFromMattersOnlyIfItIsInverted) {
    const dxQuadTree tree = treeAround(3, -2, 8, 4);
    std::mt19937 random(1);
    std::uniform_real_distribution<dReal> place(-12, 12), size(0, 4);
    std::uniform_int_distribution<Block> anyBlock(0, tree.size() - 1);
    for (int i = 0; i < 20000; ++i) {
        const dReal x = place(random), y = place(random), highX = x + size(random), highY = y + size(random);
        const Block block = find(tree, x, highX, y, highY);
        EXPECT_EQ(findFrom(tree, anyBlock(random), x, highX, y, highY), block);
    }
    const dxQuadTree small = treeAround(0, 0, 8, 1);
    EXPECT_EQ(find(small, 5, -5, 5, 6), 2u);
    EXPECT_EQ(findFrom(small, 4, 5, -5, 5, 6), 4u);
    EXPECT_EQ(findFrom(small, 1, 5, -5, 5, 6), 2u);
}

TEST(QuadTree, BoxesOfBlocksThatAreNotWithinOneAnotherAreApart) {
    const dxQuadTree tree = treeAround(0.1, 0.3, 7, 4);
    std::mt19937 random(2);
    std::uniform_real_distribution<dReal> place(-7, 7), size(-1, 2);
    for (int i = 0; i < 20000; ++i) {
        dReal boxes[2][4];
        Block blocks[2];
        for (int k = 0; k < 2; ++k) {
            for (int axis = 0; axis < 2; ++axis) {
                boxes[k][2 * axis] = place(random);
                boxes[k][2 * axis + 1] = boxes[k][2 * axis] + size(random);
            }
            blocks[k] = find(tree, boxes[k][0], boxes[k][1], boxes[k][2], boxes[k][3]);
        }
        const Block outer = std::min(blocks[0], blocks[1]), inner = std::max(blocks[0], blocks[1]);
        if (inner < tree.endOf(outer)) continue;
        const bool areApart = boxes[0][0] > boxes[1][1] || boxes[0][1] < boxes[1][0] || boxes[0][2] > boxes[1][3] ||
                              boxes[0][3] < boxes[1][2];
        EXPECT_TRUE(areApart);
    }
}

TEST(QuadTree, ABlockIsPassedOverIfTheBoxIsBesideIt) {
    const dxQuadTree tree = treeAround(0, 0, 8, 1);
    const auto mayMeet = [&](dReal lowX, dReal highX) {
        const dReal aabb[6] = {lowX, highX, 1, 2, 0, 0};
        return tree.mayMeet(4, aabb);
    };
    EXPECT_TRUE(mayMeet(-1, 0));
    EXPECT_FALSE(mayMeet(-2, -1));
    EXPECT_FALSE(mayMeet(9, 10));
    EXPECT_TRUE(mayMeet(kNaN, kNaN));
}

[[noreturn]] void throwText(int, const char *format, va_list arguments) {
    char text[300];
    std::vsnprintf(text, sizeof text, format, arguments);
    throw std::runtime_error(text);
}

std::string complaintAbout(dReal extentX, dReal extentY, int depth) {
    const dVector3 centre = {0, 0, 0}, extents = {extentX, extentY, 1};
    dMessageFunction *const before = dGetDebugHandler();
    dSetDebugHandler(throwText);
    std::string text;
    try {
        dxQuadTree tree(centre, extents, depth);
    } catch (const std::runtime_error &error) {
        text = error.what();
    }
    dSetDebugHandler(before);
    return text.substr(0, text.find('['));
}

TEST(QuadTree, ARectangleInsideOutFailsUpstreamsAssertion) {
    EXPECT_EQ(complaintAbout(-1, 1, 2), "assertion \"MinX <= MaxX\" failed in Create() ");
    EXPECT_EQ(complaintAbout(1, -1, 2), "assertion \"MinZ <= MaxZ\" failed in Create() ");
    const dReal infinity = std::numeric_limits<dReal>::infinity(), most = std::numeric_limits<dReal>::max();
    EXPECT_EQ(complaintAbout(infinity, infinity, 0), "");
    EXPECT_EQ(complaintAbout(infinity, 1, 1), "assertion \"MinX <= MaxX\" failed in Create() ");
    EXPECT_EQ(complaintAbout(0, 0, 4), "");
    EXPECT_EQ(complaintAbout(most / 4, most / 4, 4), "");
}

}  // namespace
