// Messages arrive as they were sent, or are recognised as something else: whichever bit is flipped, wherever they are cut off.
#include "remote/transport/dxRemoteFrame.h"
#include "remote/transport/dxSpareBytes.h"

#include <gtest/gtest.h>

namespace {

dxRemoteBytes makeMessage() {
    dxRemoteFrame frame;
    const char text[] = "thirty-seven bytes, no multiple of 8";
    frame.addItem(7, text, sizeof text);
    frame.addItem(8, text, 0);
    frame.addItem(9, text, 8);
    return frame.seal(dxRemoteKind::Problems, 42);
}

TEST(RemoteFrame, ItemsComeBack) {
    const dxRemoteBytes message = makeMessage();
    ASSERT_EQ(dxFindFrameFault(message), nullptr);
    EXPECT_EQ(dxReadHeader(message).number, 42u);
    dxRemoteItems items(message);
    const std::pair<std::uint64_t, std::size_t> expected[] = {{7, 37}, {8, 0}, {9, 8}};
    for (const auto &[number, size] : expected) {
        ASSERT_TRUE(items.next());
        EXPECT_EQ(items.number(), number);
        EXPECT_EQ(items.size(), size);
    }
    EXPECT_TRUE(items.isAtEnd());
    EXPECT_FALSE(items.next());
}

TEST(RemoteFrame, UsesRoomThatIsToSpare) {
    dxSpareBytes spare;
    spare.giveBack(dxRemoteBytes(1000, std::byte{7}));
    EXPECT_GE(spare.capacity(), 1000u);
    dxRemoteFrame frame(spare.take());
    EXPECT_EQ(spare.capacity(), 0u);
    const char text[] = "as in a new one";
    frame.addItem(7, text, sizeof text);
    const std::byte *const at = frame.seal(dxRemoteKind::Problems).data();
    EXPECT_EQ(dxFindFrameFault(frame.seal(dxRemoteKind::Problems)), nullptr);
    spare.giveBack(frame.release());
    EXPECT_EQ(dxRemoteFrame(spare.take()).seal(dxRemoteKind::Wake).data(), at);
}

TEST(RemoteFrame, RoomToSpareIsBounded) {
    dxSpareBytes spare;
    for (int i = 0; i < 100; ++i) spare.giveBack(dxRemoteBytes(1 << 20));
    EXPECT_LE(spare.capacity(), dxSpareBytes::kMaxCapacity);
    EXPECT_GT(spare.capacity(), dxSpareBytes::kMaxCapacity / 2);
    spare.giveBack(dxRemoteBytes(2 * dxSpareBytes::kMaxCapacity));
    while (spare.capacity() > 0) spare.take();
    EXPECT_EQ(spare.take().capacity(), 0u);
}

TEST(RemoteFrame, EachFlippedBitIsSeen) {
    const dxRemoteBytes message = makeMessage();
    for (std::size_t bit = 0; bit < 8 * message.size(); ++bit) {
        dxRemoteBytes damaged = message;
        damaged[bit / 8] ^= std::byte{1} << bit % 8;
        EXPECT_NE(dxFindFrameFault(damaged), nullptr) << "bit " << bit;
    }
}

TEST(RemoteFrame, EachShorterMessageIsSeen) {
    const dxRemoteBytes message = makeMessage();
    for (std::size_t size = 0; size < message.size(); ++size)
        EXPECT_NE(dxFindFrameFault(dxRemoteBytes(message.begin(), message.begin() + size)), nullptr) << size;
}

TEST(RemoteFrame, AnotherByteOrderIsNamed) {
    dxRemoteBytes message = makeMessage();
    std::swap(message[0], message[3]);
    std::swap(message[1], message[2]);
    EXPECT_STREQ(dxFindFrameFault(message), "of another byte order");
}

TEST(RemoteFrame, ItemsLargerThanTheMessageAreNone) {
    dxRemoteBytes message = makeMessage();
    const std::uint64_t huge = ~std::uint64_t{0} - 3;
    std::memcpy(message.data() + sizeof(dxRemoteHeader) + 8, &huge, sizeof huge);
    EXPECT_FALSE(dxRemoteItems(message).next());
}

}  // namespace
