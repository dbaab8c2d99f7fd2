// The threads of this process as the kernel lists them.
#pragma once

#include <dirent.h>

#include "Runs.h"

inline unsigned processThreads() {
    unsigned count = 0;
    DIR *tasks = opendir("/proc/self/task");
    while (const dirent *entry = readdir(tasks)) count += entry->d_name[0] != '.';
    closedir(tasks);
    return count;
}

// A joined thread stays listed for a moment.
inline bool threadsFallTo(unsigned count) {
    return waitUntil([=] { return processThreads() <= count; }, 5);
}
