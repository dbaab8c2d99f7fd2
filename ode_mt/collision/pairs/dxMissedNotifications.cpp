#include "collision/pairs/dxMissedNotifications.h"

dxEventCounter dxMissedNotifications;
