#include "collision/pairs/dxMissedNotifications.h"

std::atomic<std::uint64_t> dxMissedNotifications::events{0};
